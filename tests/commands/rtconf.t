rtconf shows and changes the configuration of a component.

world: config

Its sets; * marks the active one. Sets of metadata are hidden unless -a is given:

  $ rtconf ConfigSample0.rtc
  +default
  +mode0
  +mode1*
  $ rtconf ConfigSample0.rtc list
  +default
  +mode0
  +mode1*
  $ rtconf -a ConfigSample0.rtc
  +__constraints__
  +__widget__
  +default
  +mode0
  +mode1*

-l, their parameters:

  $ rtconf ConfigSample0.rtc -l
  -default
    double_param0  0.99
    double_param1  -0.99
    int_param0     0
    int_param1     1
    str_param0     default
    str_param1     default set in conf file
    vector_param0  0.0,0.1,0.2,0.3,0.4,0.5,0.6
  -mode0
    double_param0  3.141592653589793238462643383279
    double_param1  2.718281828459045235360287471352
    int_param0     12345
    int_param1     98765
    str_param0     mode0
    str_param1     foo
    vector_param0  0.0,0.1,0.2,0.3,0.4
  -mode1*
    double_param0  297992458
    double_param1  2.97992458e+8
    int_param0     -999
    int_param1     999
    str_param0     mode1
    str_param1     AIST
    vector_param0  1,2,3,4,5,6,7,8,9
  $ rtconf -l -s mode0 ConfigSample0.rtc list
  -mode0
    double_param0  3.141592653589793238462643383279
    double_param1  2.718281828459045235360287471352
    int_param0     12345
    int_param1     98765
    str_param0     mode0
    str_param1     foo
    vector_param0  0.0,0.1,0.2,0.3,0.4
  $ rtconf -al ConfigSample0.rtc --set=__widget__
  -__widget__
    double_param0  slider.0.1
    double_param1  text
    int_param0     slider.10
    int_param1     spin
    str_param0     radio
    str_param1     text
    vector_param0  text
  $ rtconf ConfigSample0.rtc -s default
  +default

get, a value of the active set, or of another:

  $ rtconf ConfigSample0.rtc get int_param0
  -999
  $ rtconf ConfigSample0.rtc -s mode0 get int_param0
  12345
  $ rtconf ConfigSample0.rtc get -s default str_param1
  default set in conf file
  $ rtconf ConfigSample0.rtc -a -s __widget__ get int_param0
  slider.10

set, one value, negative numbers, and several:

  $ rtconf ConfigSample0.rtc set int_param0 12
  $ rtconf ConfigSample0.rtc get int_param0
  12
  $ rtconf ConfigSample0.rtc set int_param0 -5; rtconf ConfigSample0.rtc get int_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but -5 does not fit the component's constraint 0<=x<=150
  -5
  $ rtconf ConfigSample0.rtc set double_param0 -.5e3; rtconf ConfigSample0.rtc get double_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: double_param0 is set, but -.5e3 does not fit the component's constraint 0<=x<=100
  -.5e3
  $ rtconf ConfigSample0.rtc -- set str_param0 --help; rtconf ConfigSample0.rtc get str_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but --help does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  --help
  $ rtconf ConfigSample0.rtc set int_param0=1 int_param1=-2 str_param0='a b' str_param1=
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param1 is set, but -2 does not fit the component's constraint 0<=x<=1000
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but a b does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  $ rtconf ConfigSample0.rtc -l -s mode1 | sed 's/ *$//'
  -mode1*
    double_param0  -.5e3
    double_param1  2.97992458e+8
    int_param0     1
    int_param1     -2
    str_param0     a b
    str_param1
    vector_param0  1,2,3,4,5,6,7,8,9

A value may hold anything: equals signs, newlines, blanks, any script, escapes, bytes that are no text:

  $ rtconf ConfigSample0.rtc set str_param0 'a=b=c'; rtconf ConfigSample0.rtc get str_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but a=b=c does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  a=b=c
  $ rtconf ConfigSample0.rtc set str_param0=a=b str_param1=c=d; rtconf ConfigSample0.rtc get str_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but a=b does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  a=b
  $ rtconf ConfigSample0.rtc set str_param0 '日本語 é ☃'; rtconf ConfigSample0.rtc get str_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but 日本語 é ☃ does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  日本語 é ☃
  $ rtconf ConfigSample0.rtc set str_param0 '  two
  > lines	\n  '; rtconf ConfigSample0.rtc get str_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but   two\x0alines\x09\\n   does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
    two
  lines\t\\n\x20\x20 (esc)
  $ rtconf ConfigSample0.rtc set str_param0 "$(printf 'a\033[31m\377')"
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but a\x1b[31m\xff does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  $ rtconf ConfigSample0.rtc get str_param0
  a\x1b[31m\xff (esc)
  $ rtconf ConfigSample0.rtc get str_param0 --json
  {"str_param0": "a\u001b[31m\udcff"}
  $ rtconf ConfigSample0.rtc set str_param0 ''; rtconf ConfigSample0.rtc get str_param0 | od -c
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but '' does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  0000000  \n
  0000001

What get prints is what set takes; only on a terminal it is escaped, as far as it would harm it:

  $ sample() { rtconf -q ConfigSample0.rtc "$@"; }
  $ for value in 'C:\new\x41' "$(printf 'a\tb\n \033[31m\377\\')" '-n' '' ' x ' ' ' '  日本 é' \
  >     "$(printf 'a\n\nb')" '\' '\\x' '$(id) "`'\' ',|=;'; do
  >   sample set -- str_param0 "$value"; x=$(sample get str_param0); [ "$x" = "$value" ] || echo changed
  >   sample set -- str_param0 "$x"; [ "$(sample get str_param0)" = "$value" ] || echo "changed again"
  > done
  $ sample set str_param0 "$(printf 'C:\\new \033[31m')"; terminal 80 rtconf ConfigSample0.rtc get str_param0
  C:\new \x1b[31m
  $ sample set str_param0 ''

set keeps active what is active, wherever it changes something; act changes that:

  $ rtconf ConfigSample0.rtc -s mode0 set int_param0 77
  $ rtconf ConfigSample0.rtc; rtconf ConfigSample0.rtc -s mode0 get int_param0
  +default
  +mode0
  +mode1*
  77
  $ rtconf ConfigSample0.rtc act mode0; rtconf ConfigSample0.rtc get int_param0
  77
  $ rtconf ConfigSample0.rtc -s default act; rtconf ConfigSample0.rtc
  +default*
  +mode0
  +mode1
  $ rtconf ConfigSample0.rtc act default -v
  rtconf: rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s default act
  $ rtconf ConfigSample0.rtc -a -s __widget__ set int_param0 spin; rtconf ConfigSample0.rtc -a
  +__constraints__
  +__widget__
  +default*
  +mode0
  +mode1

--verbose reports what was done, --dry-run only what would be, as commands that do it:

  $ rtconf ConfigSample0.rtc -v -s mode0 set int_param0 78
  rtconf: rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode0 set int_param0=78
  $ rtconf ConfigSample0.rtc --dry-run -s mode0 set int_param0=-79 'str_param0=$(id)  x' str_param1=日本
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0: -79 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0: $(id)  x does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode0 set int_param0=-79 'str_param0=$(id)  x' 'str_param1=日本'
  $ rtconf ConfigSample0.rtc -s mode0 get int_param0
  78
  $ rtconf ConfigSample0.rtc --dry-run -s mode0 set int_param0=-79 'str_param0=$(id)  x' str_param1=日本 | sh
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0: -79 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0: $(id)  x does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but -79 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but $(id)  x does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  $ rtconf ConfigSample0.rtc -s mode0 -l
  -mode0
    double_param0  3.141592653589793238462643383279
    double_param1  2.718281828459045235360287471352
    int_param0     -79
    int_param1     98765
    str_param0     $(id)  x
    str_param1     日本
    vector_param0  0.0,0.1,0.2,0.3,0.4
  $ rtconf ConfigSample0.rtc --dry-run act mode1; rtconf ConfigSample0.rtc --dry-run act mode1 | sh
  rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 act
  $ rtconf ConfigSample0.rtc --dry-run set int_param0 -3
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0: -3 does not fit the component's constraint 0<=x<=150
  rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 set int_param0=-3
  $ rtconf ConfigSample0.rtc --dry-run set int_param0 -3 | sh; rtconf ConfigSample0.rtc get int_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0: -3 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but -3 does not fit the component's constraint 0<=x<=150
  -3

JSON, one set a line:

  $ rtconf ConfigSample0.rtc -s mode1 --json | sed 's/, /,\n /g'
  {"active": true,
   "description": "",
   "id": "mode1",
   "path": "/localhost:$PORT/test.host_cxt/ConfigSample0.rtc",
   "values": {"double_param0": "-.5e3",
   "double_param1": "2.97992458e+8",
   "int_param0": "-3",
   "int_param1": "-2",
   "str_param0": "",
   "str_param1": "c=d",
   "vector_param0": "1,2,3,4,5,6,7,8,9"}}
  $ rtconf ConfigSample0.rtc --json -a | wc -l
  5

What a list costs; set adds one request to change and one to keep the active set active:

  $ ctl reset
  $ rtconf ConfigSample0.rtc -l > /dev/null
  $ calls
  1 get_active_configuration_set
  1 get_configuration
  1 get_configuration_sets
  $ ctl reset
  $ rtconf ConfigSample0.rtc set int_param0 1
  $ calls
  1 activate_configuration_set
  1 get_active_configuration_set
  1 get_configuration
  1 get_configuration_sets
  1 set_configuration_set_values

Wrong usage:

  $ rtconf
  rtconf: the following arguments are required: PATH (see --help)
  [2]
  $ rtconf set ConfigSample0.rtc int_param0 1
  rtconf: the path comes first: ConfigSample0.rtc set … (see --help)
  [2]
  $ rtconf ConfigSample0.rtc sit int_param0 1
  rtconf: no such command: sit; did you mean set? (see --help)
  [2]
  $ rtconf ConfigSample0.rtc erase
  rtconf: no such command: erase (there are: list, get, set, act, dump, load, diff) (see --help)
  [2]
  $ rtconf ConfigSample0.rtc get
  rtconf: get: too few arguments: which parameter? (see --help)
  [2]
  $ rtconf ConfigSample0.rtc get a b
  rtconf: get: too many arguments (see --help)
  [2]
  $ rtconf ConfigSample0.rtc set
  rtconf: set: too few arguments: set PARAM VALUE, or PARAM=VALUE … (see --help)
  [2]
  $ rtconf ConfigSample0.rtc set int_param0
  rtconf: set: not PARAM=VALUE: int_param0 (see --help)
  [2]
  $ rtconf ConfigSample0.rtc set int_param0 1 2
  rtconf: set: not PARAM=VALUE: int_param0 (see --help)
  [2]
  $ rtconf ConfigSample0.rtc set int_param0=1 2
  rtconf: set: not PARAM=VALUE: 2 (see --help)
  [2]
  $ rtconf ConfigSample0.rtc set int_param0=1 int_param0=2
  rtconf: set: int_param0 is given twice (see --help)
  [2]
  $ rtconf ConfigSample0.rtc act
  rtconf: act: name one set to activate (see --help)
  [2]
  $ rtconf ConfigSample0.rtc act mode0 -s mode1
  rtconf: act: name one set to activate (see --help)
  [2]
  $ rtconf ConfigSample0.rtc act mode0 mode1
  rtconf: act: too many arguments (see --help)
  [2]
  $ rtconf ConfigSample0.rtc diff
  rtconf: diff: too few arguments: the PATH of another component, or a FILE of dump (see --help)
  [2]
  $ rtconf ConfigSample0.rtc get int_param0 -s
  rtconf: argument -s/--set: expected one argument (see --help)
  [2]
  $ rtconf ConfigSample0.rtc list anything
  +default
  +mode0
  +mode1*

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -l A
invocation: A get p
invocation: A set p 1
invocation: A act default
invocation: A diff B
invocation: A dump
looking: -l A
looking: --json A
broken component: 3
