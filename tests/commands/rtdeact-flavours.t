rtdeact with components of C++ 1.1, 1.2 and 2.x, Python, Java, RtORB.

world: these ConsoleIn Slow --flavour cpp11 --context cpp11.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour cpp12 --context cpp12.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour cpp2 --context cpp2.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour py2 --context py2.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour java --context java.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour rtorb --context rtorb.host_cxt/%n.rtc --rate 100

What the other versions print as C++ 1.1 does is not repeated:

  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do
  >   { RTCSH_CWD=/localhost:$PORT/$v.host_cxt "$@" 2>&1; s=$?; [ $s = 0 ] || echo "status $s"; } |
  >       sed "s/$v.host/V.host/g" >$v
  >   [ $v != cpp11 ] && cmp -s cpp11 $v || { echo "$v:"; cat $v; }
  > done; }

  $ each rtact --wait ConsoleIn0.rtc
  cpp11:
  $ each rtdeact -v ConsoleIn0.rtc
  cpp11:
  rtdeact: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc: accepted
  $ each rtls -l ConsoleIn0.rtc
  cpp11:
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc

A component that takes longer than the half second that its context waits:

  $ each rtact --wait Slow0.rtc
  cpp11:
  $ each rtdeact -v --wait Slow0.rtc
  cpp11:
  rtdeact: /localhost:$PORT/V.host_cxt/Slow0.rtc: Inactive
  $ each rtls -l Slow0.rtc
  cpp11:
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc

C++ 1.1 answers only after ten periods, which may be longer than the timeout; --wait waits for the answer, too:

  $ cd=/localhost:$PORT/cpp11.host_cxt; rtec $cd/ConsoleIn0.rtc rate 8
  $ rtact --wait $cd/ConsoleIn0.rtc
  $ within 1.2-9 rtdeact -v --timeout 0.5 --wait=8 $cd/ConsoleIn0.rtc
  rtdeact: /localhost:$PORT/cpp11.host_cxt/ConsoleIn0.rtc: Inactive
  $ rtec $cd/ConsoleIn0.rtc rate 100

In Error, it cannot be deactivated:

  $ for n in '' 2 3 4 5 6; do ctl @these$n error ConsoleIn0; done
  $ each rtdeact ConsoleIn0.rtc
  cpp11:
  rtdeact: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc: cannot deactivate: it is in Error; reset it first
  status 6
