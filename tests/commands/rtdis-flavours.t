rtdis with components of C++ 1.1, 1.2 and 2.x, Python, Java, RtORB.

world: these ConsoleIn ConsoleOut MyServiceProvider MyServiceConsumer --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider MyServiceConsumer --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider MyServiceConsumer --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider MyServiceConsumer --flavour py2 --context py2.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider MyServiceConsumer --flavour java --context java.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider MyServiceConsumer --flavour rtorb --context rtorb.host_cxt/%n.rtc

What the other versions print as C++ 1.1 does is not repeated:

  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do
  >   { RTCSH_CWD=/localhost:$PORT/$v.host_cxt "$@" 2>&1; s=$?; [ $s = 0 ] || echo "status $s"; } |
  >       sed "s/$v.host/V.host/g; s/[0-9a-f-]\{36\}/ID/" >$v
  >   [ $v != cpp11 ] && cmp -s cpp11 $v || { echo "$v:"; cat $v; }
  > done; }

  $ each rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  cpp11:
  $ each rtcon MyServiceProvider0.rtc:MyService MyServiceConsumer0.rtc:MyService
  cpp11:
  $ each rtls -l
  cpp11:
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  Inactive  1/1  0/0  0/0  1/1  MyServiceConsumer0.rtc
  Inactive  1/1  0/0  0/0  1/1  MyServiceProvider0.rtc
  $ each rtdis -v ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  cpp11:
  rtdis: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc:out: removed connection ID
  $ each rtdis -v MyServiceConsumer0.rtc
  cpp11:
  rtdis: /localhost:$PORT/V.host_cxt/MyServiceConsumer0.rtc:MyService: removed connection ID
  $ each rtls -l
  cpp11:
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  1/0  0/0  0/0  1/0  MyServiceConsumer0.rtc
  Inactive  1/0  0/0  0/0  1/0  MyServiceProvider0.rtc
  $ each rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  cpp11:
  rtdis: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/V.host_cxt/ConsoleOut0.rtc:in: not connected
  status 1
