rtact with components of C++ 1.1, 1.2 and 2.x, Python, Java, RtORB: some answer at once, some when it is done; --wait waits
in any case.

world: these ConsoleIn ErrStart --flavour cpp11 --context cpp11.host_cxt/%n.rtc --rate 100
world: these ConsoleIn ErrStart --flavour cpp12 --context cpp12.host_cxt/%n.rtc --rate 100
world: these ConsoleIn ErrStart --flavour cpp2 --context cpp2.host_cxt/%n.rtc --rate 100
world: these ConsoleIn ErrStart --flavour py2 --context py2.host_cxt/%n.rtc --rate 100
world: these ConsoleIn ErrStart --flavour java --context java.host_cxt/%n.rtc --rate 100
world: these ConsoleIn ErrStart --flavour rtorb --context rtorb.host_cxt/%n.rtc --rate 100

What the other versions print as C++ 1.1 does is not repeated:

  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do
  >   { RTCSH_CWD=/localhost:$PORT/$v.host_cxt "$@" 2>&1; s=$?; [ $s = 0 ] || echo "status $s"; } |
  >       sed "s/$v.host/V.host/g" >$v
  >   [ $v != cpp11 ] && cmp -s cpp11 $v || { echo "$v:"; cat $v; }
  > done; }

  $ each rtact -v --wait ConsoleIn0.rtc
  cpp11:
  rtact: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc: Active
  $ each rtls -l ConsoleIn0.rtc
  cpp11:
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ each rtact -v ConsoleIn0.rtc
  cpp11:
  rtact: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc: Active

One that fails in its activation: all have said RTC_OK, and all but RtORB's are Active first. Without --wait that is believed:

  $ each rtact --wait ErrStart0.rtc
  cpp11:
  rtact: /localhost:$PORT/V.host_cxt/ErrStart0.rtc: cannot activate: it went to Error
  status 6
  $ each rtact ErrStart0.rtc
  cpp11:
  rtact: /localhost:$PORT/V.host_cxt/ErrStart0.rtc: cannot activate: it is in Error; reset it first
  status 6
  $ each rtreset --wait ErrStart0.rtc
  cpp11:
  $ each rtact ErrStart0.rtc
  cpp11:

A stopped context changes the state all the same in C++ 1.2, Java and RtORB; not so in C++ 1.1 and in 2.x, of C++ and Python:

  $ each rtdeact --wait ConsoleIn0.rtc
  cpp11:
  $ each rtec ConsoleIn0.rtc stop
  cpp11:
  $ each rtact --wait=30 ConsoleIn0.rtc
  cpp11:
  rtact: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc: cannot activate: its execution context is stopped; once started, it may still do so
  status 6
  cpp12:
  java:
  rtorb:
  $ each rtec ConsoleIn0.rtc start
  cpp11:
  $ soon 'ctl state ConsoleIn0 | grep ^ACTIVE'
  $ each rtls -l ConsoleIn0.rtc
  cpp11:
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  cpp2:
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  py2:
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
