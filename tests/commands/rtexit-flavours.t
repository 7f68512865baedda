rtexit with components of C++ 1.1, 1.2 and 2.x, Python, Java, RtORB.

world: these ConsoleIn ConsoleOut --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut --flavour py2 --context py2.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut --flavour java --context java.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut --flavour rtorb --context rtorb.host_cxt/%n.rtc

What the other versions print as C++ 1.1 does is not repeated:

  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do
  >   { RTCSH_CWD=/localhost:$PORT/$v.host_cxt "$@" 2>&1; s=$?; [ $s = 0 ] || echo "status $s"; } | sed "s/$v.host/V.host/g" >$v
  >   [ $v != cpp11 ] && cmp -s cpp11 $v || { echo "$v:"; cat $v; }
  > done; }

  $ each rtexit -v --wait ConsoleIn0.rtc
  cpp11:
  rtexit: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc: exited
  $ each rtls
  cpp11:
  ConsoleOut0.rtc
  $ each rtexit --wait ConsoleOut0.rtc
  cpp11:
  $ each rtls
  cpp11:
  $ each rtexit ConsoleIn0.rtc
  cpp11:
  rtexit: /localhost:$PORT/V.host_cxt/ConsoleIn0.rtc: no such path
  status 3
