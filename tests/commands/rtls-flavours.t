rtls shows the components of all implementations of OpenRTM: C++ 1.1, 1.2 and 2.x, Python, Java, RtORB.

world: these ConsoleIn MyServiceProvider ConfigSample --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: these ConsoleIn MyServiceProvider ConfigSample --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: these ConsoleIn MyServiceProvider ConfigSample --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: these ConsoleIn MyServiceProvider ConfigSample --flavour py2 --context py2.host_cxt/%n.rtc
world: these ConsoleIn MyServiceProvider ConfigSample --flavour java --context java.host_cxt/%n.rtc
world: these ConsoleIn MyServiceProvider ConfigSample --flavour rtorb --context rtorb.host_cxt/%n.rtc

What the other versions print as C++ 1.1 does is not repeated:

  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do
  >   { RTCSH_CWD=/localhost:$PORT/$v.host_cxt "$@" 2>&1; s=$?; [ $s = 0 ] || echo "status $s"; } |
  >       sed "s/$v.host/V.host/g" >$v
  >   [ $v != cpp11 ] && cmp -s cpp11 $v || { echo "$v:"; cat $v; }
  > done; }

  $ each rtls -l
  cpp11:
  Inactive  0/0  0/0  0/0  0/0  ConfigSample0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  0/0  0/0  1/0  MyServiceProvider0.rtc

Connected, active, in Error:

  $ for v in cpp12 py2 rtorb; do rtact --wait ../$v.host_cxt/ConsoleIn0.rtc; done
  $ ctl error ConsoleIn0
  $ ctl @these3 error ConsoleIn0
  $ ctl @these5 error ConsoleIn0
  $ each rtls -l ConsoleIn0.rtc
  cpp11:
  Error  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  cpp12:
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  py2:
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  rtorb:
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
