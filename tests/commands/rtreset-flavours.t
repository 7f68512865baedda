rtreset with components of C++ 1.1, 1.2 and 2.x, Python, Java, RtORB.

world: these ConsoleIn --flavour cpp11 --context cpp11.host_cxt/%n.rtc --rate 100
world: these ConsoleIn --flavour cpp12 --context cpp12.host_cxt/%n.rtc --rate 100
world: these ConsoleIn --flavour cpp2 --context cpp2.host_cxt/%n.rtc --rate 100
world: these ConsoleIn --flavour py2 --context py2.host_cxt/%n.rtc --rate 100
world: these ConsoleIn --flavour java --context java.host_cxt/%n.rtc --rate 100
world: these ConsoleIn --flavour rtorb --context rtorb.host_cxt/%n.rtc --rate 100

What the other versions print as C++ 1.1 does is not repeated:

  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do
  >   { RTCSH_CWD=/localhost:$PORT/$v.host_cxt "$@" 2>&1; s=$?; [ $s = 0 ] || echo "status $s"; } | sed "s/$v.host/V.host/g" >$v
  >   [ $v != cpp11 ] && cmp -s cpp11 $v || { echo "$v:"; cat $v; }
  > done; }

  $ for n in '' 2 3 4 5 6; do ctl @these$n error ConsoleIn0; done
  $ each rtls -l
  cpp11:
  Error  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ each rtreset -v --wait ConsoleIn0.rtc
  cpp11:
  rtreset: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc: Inactive
  $ each rtls -l
  cpp11:
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ each rtact --wait ConsoleIn0.rtc
  cpp11:
  $ each rtreset ConsoleIn0.rtc
  cpp11:
  rtreset: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc: cannot reset: it is Active, not Error
  status 6
