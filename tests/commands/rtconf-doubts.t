Values are text for components, which take any: rtconf set says what may not be meant, and sets it all the same.

world: config
world: these ConfigSample:Cpp0 --flavour cpp2

A value that is no number, where the present one is, and one that does not fit the component's own constraints:

  $ rtconf Cpp0.rtc -s mode0 set int_param0 abc
  rtconf: /localhost:$PORT/test.host_cxt/Cpp0.rtc: int_param0 is set, but abc is not a number, unlike the old value (12345)
  $ rtconf Cpp0.rtc -s mode0 get int_param0
  abc
  $ rtconf ConfigSample0.rtc -s mode0 set int_param0=151 int_param1=-1 str_param0=blue vector_param0=1,x \
  >     double_param1=1e400
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but 151 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param1 is set, but -1 does not fit the component's constraint 0<=x<=1000
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but blue does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: vector_param0 is set, but 1,x is not a number, unlike the old value (0.0,0.1,0.2,0.3,0.4)
  $ rtconf ConfigSample0.rtc -s mode0 -l
  -mode0
    double_param0  3.141592653589793238462643383279
    double_param1  1e400
    int_param0     151
    int_param1     -1
    str_param0     blue
    str_param1     foo
    vector_param0  1,x
  $ rtconf -q ConfigSample0.rtc -s mode0 set int_param0 152
  $ rtconf --dry-run ConfigSample0.rtc -s mode0 set int_param0 "$(printf '\033')"
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0: \x1b is not a number, unlike the old value (152)
  rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode0 set 'int_param0='"$(printf '\033')"

Nothing is said of values that fit, or of parameters whose values are words:

  $ rtconf ConfigSample0.rtc -s mode0 set int_param0=150 int_param1=0 str_param0=radio vector_param0=1,2.5 \
  >     str_param1=
  $ rtconf ConfigSample0.rtc -s mode0 set str_param1=foo double_param1=-3
