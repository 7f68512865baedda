rtconf with components of C++ 1.1, 1.2 and 2.x, Python, Java, RtORB.

world: these ConfigSample ConsoleIn --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: these ConfigSample ConsoleIn --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: these ConfigSample ConsoleIn --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: these ConfigSample ConsoleIn --flavour py2 --context py2.host_cxt/%n.rtc
world: these ConfigSample ConsoleIn --flavour java --context java.host_cxt/%n.rtc
world: these ConfigSample ConsoleIn --flavour rtorb --context rtorb.host_cxt/%n.rtc

What the other versions print as C++ 1.1 does is not repeated:

  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do
  >   { RTCSH_CWD=/localhost:$PORT/$v.host_cxt "$@" 2>&1; s=$?; [ $s = 0 ] || echo "status $s"; } |
  >       sed "s/$v.host/V.host/g" >$v
  >   [ $v != cpp11 ] && cmp -s cpp11 $v || { echo "$v:"; cat $v; }
  > done; }

  $ each rtconf ConfigSample0.rtc list
  cpp11:
  +default
  +mode0
  +mode1*
  $ each rtconf ConfigSample0.rtc -s default get str_param1
  cpp11:
  default set in conf file
  $ each rtconf ConfigSample0.rtc -s default set str_param0 new
  cpp11:
  rtconf: /localhost:$PORT/V.host_cxt/ConfigSample0.rtc: str_param0 is set, but new does not fit the component's constraint (default,mode0,mode1)
  py2:
  rtconf: /localhost:$PORT/V.host_cxt/ConfigSample0.rtc: str_param0 is set, but new does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  java:
  rtconf: /localhost:$PORT/V.host_cxt/ConfigSample0.rtc: str_param0 is set, but new does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  rtorb:
  rtconf: /localhost:$PORT/V.host_cxt/ConfigSample0.rtc: str_param0 is set, but new does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  $ each rtconf ConfigSample0.rtc -s default get str_param0
  cpp11:
  new

Setting a value makes all but Java forget which set is active; rtconf activates it again:

  $ each rtconf ConfigSample0.rtc list
  cpp11:
  +default
  +mode0
  +mode1*

A value that is no number is taken by all, and read back as it is:

  $ each rtconf ConfigSample0.rtc -s mode1 set int_param0 many
  cpp11:
  rtconf: /localhost:$PORT/V.host_cxt/ConfigSample0.rtc: int_param0 is set, but many is not a number, unlike the old value (-999)
  $ each rtconf ConfigSample0.rtc -s mode1 get int_param0
  cpp11:
  many

Unknown sets and parameters; a component without sets:

  $ each rtconf ConfigSample0.rtc act nonsense
  cpp11:
  rtconf: /localhost:$PORT/V.host_cxt/ConfigSample0.rtc: no such configuration set: nonsense (there are: default, mode0, mode1)
  status 3
  $ each rtconf ConfigSample0.rtc -s nonsense set a b
  cpp11:
  rtconf: /localhost:$PORT/V.host_cxt/ConfigSample0.rtc: no such configuration set: nonsense (there are: default, mode0, mode1)
  status 3
  $ each rtconf ConfigSample0.rtc -s default set nonsense b
  cpp11:
  rtconf: /localhost:$PORT/V.host_cxt/ConfigSample0.rtc: no such configuration parameter: nonsense (there are: double_param0, double_param1, int_param0, int_param1, str_param0, str_param1, vector_param0)
  status 3
  $ each rtconf ConsoleIn0.rtc list
  cpp11:
  +default*
  $ each rtconf ConfigSample0.rtc act mode0
  cpp11:
  $ each rtconf ConfigSample0.rtc get int_param0
  cpp11:
  12345
