rtconf dump, load and diff: a configuration as text.

world: config
world: config --flavour cpp2 --context cpp.host_cxt/%n.rtc
world: two
world: hostile

  $ here=/localhost:$PORT/test.host_cxt
  $ rtconf ConfigSample0.rtc dump
  # configuration of /localhost:$PORT/test.host_cxt/ConfigSample0.rtc
  [default]
  double_param0=0.99
  double_param1=-0.99
  int_param0=0
  int_param1=1
  str_param0=default
  str_param1=default set in conf file
  vector_param0=0.0,0.1,0.2,0.3,0.4,0.5,0.6
  [mode0]
  double_param0=3.141592653589793238462643383279
  double_param1=2.718281828459045235360287471352
  int_param0=12345
  int_param1=98765
  str_param0=mode0
  str_param1=foo
  vector_param0=0.0,0.1,0.2,0.3,0.4
  [mode1] active
  double_param0=297992458
  double_param1=2.97992458e+8
  int_param0=-999
  int_param1=999
  str_param0=mode1
  str_param1=AIST
  vector_param0=1,2,3,4,5,6,7,8,9
  $ rtconf ConfigSample0.rtc dump -a all.conf; grep '^\[' all.conf
  [__constraints__]
  [__widget__]
  [default]
  [mode0]
  [mode1] active
  $ rtconf ConfigSample0.rtc dump one.conf; rtconf ConfigSample0.rtc dump - | cmp - one.conf

load brings the sets to what such a text says. Nothing is done for values that are already there:

  $ rtconf ConfigSample0.rtc dump | rtconf ConfigSample0.rtc load -v
  $ rtconf ConfigSample0.rtc load -v one.conf
  $ rtconf ConfigSample0.rtc set int_param0=5 str_param0='a=b' ; rtconf ConfigSample0.rtc act mode0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but a=b does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  $ rtconf ConfigSample0.rtc load --dry-run one.conf
  rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 set int_param0=-999 str_param0=mode1
  rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 act
  $ rtconf ConfigSample0.rtc get int_param0
  12345
  $ rtconf ConfigSample0.rtc load -v one.conf
  rtconf: rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 set int_param0=-999 str_param0=mode1
  rtconf: rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 act
  $ rtconf ConfigSample0.rtc dump | cmp - one.conf

What it costs:

  $ rtconf ConfigSample0.rtc set int_param0 5
  $ ctl reset
  $ rtconf ConfigSample0.rtc load one.conf
  $ calls
  1 activate_configuration_set
  1 get_active_configuration_set
  1 get_configuration
  1 get_configuration_sets
  1 set_configuration_set_values

The commands of --dry-run do the same:

  $ rtconf ConfigSample0.rtc set int_param0=-5 str_param0='$(id) "' ; rtconf ConfigSample0.rtc act mode0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but -5 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but $(id) " does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  $ rtconf ConfigSample0.rtc dump two.conf
  $ rtconf ConfigSample0.rtc load one.conf; rtconf ConfigSample0.rtc load --dry-run two.conf | sh
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but -5 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but $(id) " does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  $ rtconf ConfigSample0.rtc dump | cmp - two.conf

A text may be written by hand: some sets, some parameters, comments; without `active` the active set stays:

  $ printf '[mode1]\nint_param0=1\\x0a2\n' | rtconf ConfigSample0.rtc load -v
  rtconf: rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 set 'int_param0=1
  2'
  $ printf '# speed only\n\n[mode1]\nint_param0=3\n' | rtconf ConfigSample0.rtc load -v -
  rtconf: rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 set int_param0=3
  $ printf '[default]\r\nint_param1=4\r\n[default]\r\nint_param0=4\r\n' | rtconf ConfigSample0.rtc load -v
  rtconf: rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s default set int_param1=4 int_param0=4
  $ printf '[mode1] active\n' | rtconf ConfigSample0.rtc load -v
  rtconf: rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 act
  $ printf '[__widget__]\nint_param0=text\n' | rtconf ConfigSample0.rtc load -v
  rtconf: rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -a -s __widget__ set int_param0=text

Values come back as they were, whatever they hold:

  $ rtconf ConfigSample0.rtc set str_param0="$(printf ' =#[]\\ 日本\n\t\033\377 ')" str_param1='# no comment '
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but  =#[]\\ 日本\x0a\x09\x1b\xff  does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  $ rtconf ConfigSample0.rtc dump odd.conf; grep str_ odd.conf | tail -2
  str_param0= =#[]\\ 日本\x0a\x09\x1b\xff\x20
  str_param1=# no comment\x20
  $ rtconf ConfigSample0.rtc load one.conf
  $ rtconf ConfigSample0.rtc load odd.conf
  $ rtconf ConfigSample0.rtc dump | cmp - odd.conf

Sets and parameters of odd names, 64 kB:

  $ rtconf Hostile0.rtc dump -a hostile.conf; cut -c 1-60 hostile.conf | sort
  # configuration of /localhost:$PORT/test.host_cxt/Hostile0.r
  $(touch owned);`id`'"|&<>*?~ -rf=$(touch owned);`id`'"|&<>*?
  $(touch owned);`id`'"|&<>*?~ -rf=0 <= x <= $(id)
  =
  [$(touch owned);`id`'"|&<>*?~ -rf]
  [\x1b[2J\x1b\]0;owned\x07\x9b31m\x0d\x0a]
  [__constraints__]
  [__widget__]
  [default] active
  ]]><script>&amp;</rts:Components>%s{}=- : # !!python/object:
  a\=b&c=d=e?f
  bad\xff=\xff\xfe
  long=xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
  number=(((
  number=-5
  number=slider.0
  plain=\x1b[2J\x1b]0;owned\x07\x9b31m\x0d\x0a
  plain=\x1b[2J\x1b]0;owned\x07\x9b31m\x0d\x0a
  plain=x >=\x20
  x=1
  $ LC_ALL=C grep -c '[[:cntrl:]]' hostile.conf
  0
  [1]
  $ rtconf Hostile0.rtc load -v hostile.conf
  $ sed -E 's/^(x|plain|number|long|bad.xff)=/&y/' hostile.conf > changed.conf
  $ rtconf Hostile0.rtc load changed.conf
  $ rtconf Hostile0.rtc dump -a | cmp - changed.conf
  $ rtconf Hostile0.rtc load --dry-run hostile.conf | sh; rtconf Hostile0.rtc dump -a | cmp - hostile.conf
  $ rtconf Hostile0.rtc set a=b\&c e=f; rtconf Hostile0.rtc get a=b\&c
  e=f
  $ rtconf Hostile0.rtc set a=b\&c=e=f =empty
  > rtconf Hostile0.rtc get a=b\&c
  > rtconf Hostile0.rtc get ''
  e=f
  empty

All is checked before the first change:

  $ printf '[mode1]\nint_param0=9\n[mode9]\nint_param0=9\n' > bad.conf; rtconf ConfigSample0.rtc load bad.conf
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: mode9; did you mean mode1?
  [3]
  $ printf '[mode1]\nint_param0=9\nint_param9=9\n' > bad.conf; rtconf ConfigSample0.rtc load bad.conf
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration parameter: int_param9; did you mean int_param1?
  [3]
  $ printf '[mode1]\nint_param0=9\n[mode2] active\n' > bad.conf; rtconf ConfigSample0.rtc load bad.conf
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: mode2; did you mean mode1?
  [3]
  $ printf '[mode1]\nint_param0=9\n[__widget__] active\n' > bad.conf; rtconf ConfigSample0.rtc load bad.conf
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: configuration set __widget__ holds metadata and cannot be active
  [6]
  $ printf '[mode1]\nint_param0=9\n[mode1] active\n[mode0] active\n' > bad.conf
  $ rtconf ConfigSample0.rtc load bad.conf
  rtconf: bad.conf:4: a second active set
  [1]
  $ rtconf ConfigSample0.rtc get int_param0
  3

What is wrong in a text is reported with its line, before anything is contacted:

  $ printf 'int_param0=9\n' > bad.conf; rtconf Nope0.rtc load bad.conf
  rtconf: bad.conf:1: name=value before any [set]
  [1]
  $ printf '[mode1]\n\nint_param0\n' > bad.conf; rtconf Nope0.rtc load bad.conf
  rtconf: bad.conf:3: neither [set] nor name=value
  [1]
  $ printf '[mode1\n' > bad.conf; rtconf Nope0.rtc load bad.conf
  rtconf: bad.conf:1: not [set] or [set] active
  [1]
  $ printf '[mode1] passive\n' > bad.conf; rtconf Nope0.rtc load bad.conf
  rtconf: bad.conf:1: not [set] or [set] active
  [1]
  $ printf '[mode1]\na=\\q\n' | rtconf Nope0.rtc load
  rtconf: -:2: bad escape \q
  [1]
  $ printf '[mode1]\na=1\na=2\n' | rtconf Nope0.rtc load
  rtconf: -:3: a has a value already
  [1]
  $ printf '[mode1]\n\033\n' | rtconf Nope0.rtc load
  rtconf: -:2: neither [set] nor name=value
  [1]
  $ rtconf Nope0.rtc load missing.conf
  rtconf: missing.conf: No such file or directory
  [1]
  $ rtconf Nope0.rtc load .
  rtconf: .: Is a directory
  [1]
  $ rtconf Nope0.rtc load /dev/null
  rtconf: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [3]

A file is written whole or not at all:

  $ rtconf ConfigSample0.rtc dump /dev/full
  rtconf: /dev/full: No space left on device
  [1]
  $ rtconf ConfigSample0.rtc dump > /dev/full
  rtconf: No space left on device
  [1]
  $ rtconf ConfigSample0.rtc dump nowhere/x.conf
  rtconf: nowhere/x.conf: No such file or directory
  [1]
  $ rtconf ConfigSample0.rtc dump .
  rtconf: .: Is a directory
  [1]
  $ rtconf Nope0.rtc dump one.conf; wc -l < one.conf
  rtconf: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  25
  $ (ulimit -f 0; rtconf ConfigSample0.rtc dump one.conf 2>&1) 2>&1 | grep -v '^File size'; wc -l < one.conf
  rtconf: one.conf: File too large
  25
  $ ln -s one.conf link.conf
  $ rtconf ConfigSample0.rtc load one.conf
  $ rtconf ConfigSample0.rtc dump link.conf
  $ ls -l link.conf | sed 's/.*link/link/'
  link.conf -> one.conf
  $ chmod 600 one.conf
  $ rtconf ConfigSample0.rtc dump one.conf
  $ ls -l one.conf | cut -c 1-10
  -rw-------
  $ ls -A | grep tmp
  [1]

diff, status 1 when there are differences; the active sets are compared, too:

  $ rtconf ConfigSample0.rtc diff ../cpp.host_cxt/ConfigSample0.rtc
  $ rtconf ConfigSample0.rtc set int_param0=-1 'str_param0=a b'; rtconf ConfigSample0.rtc act default
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but -1 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but a b does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  $ rtconf ConfigSample0.rtc -a -s __widget__ set int_param0 spin
  $ rtconf ConfigSample0.rtc diff ../cpp.host_cxt/ConfigSample0.rtc
  mode1         int_param0  -1       -999
  mode1         str_param0  a b      mode1
  (active set)              default  mode1
  [1]
  $ rtconf -a ConfigSample0.rtc diff ../cpp.host_cxt/ConfigSample0.rtc
  __constraints__  str_param0     (default,mode0,mode1,foo,bar,radio)  (default,mode0,mode1)
  __widget__       double_param0  slider.0.1                           slider.10
  __widget__       int_param0     spin                                 slider.10
  mode1            int_param0     -1                                   -999
  mode1            str_param0     a b                                  mode1
  (active set)                    default                              mode1
  [1]
  $ rtconf ConfigSample0.rtc diff ../cpp.host_cxt/ConfigSample0.rtc --json
  {"left": "-1", "parameter": "int_param0", "right": "-999", "set": "mode1"}
  {"left": "a b", "parameter": "str_param0", "right": "mode1", "set": "mode1"}
  {"left": "default", "parameter": null, "right": "mode1", "set": null}
  [1]
  $ rtconf ConfigSample0.rtc diff ConsoleIn0.rtc | head -2
  default  double_param0  0.99                              -
  default  double_param1  -0.99                             -
  $ rtconf ConfigSample0.rtc diff ConfigSample0.rtc
  $ rtconf ConfigSample0.rtc diff Nope0.rtc
  rtconf: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [3]
  $ rtconf ConfigSample0.rtc dump 'as it was'; rtconf ConfigSample0.rtc diff 'as it was'
  $ rtconf ConfigSample0.rtc -s mode1 set int_param0 7; rtconf ConfigSample0.rtc diff 'as it was'
  mode1  int_param0  7  -1
  [1]
  $ rtconf ConfigSample0.rtc diff 'as it was' --json
  {"left": "7", "parameter": "int_param0", "right": "-1", "set": "mode1"}
  [1]
  $ rtconf ConfigSample0.rtc load 'as it was'; rtconf ConfigSample0.rtc diff 'as it was'
  $ rtconf ConfigSample0.rtc dump | rtconf ConfigSample0.rtc diff -
  $ rtconf ConfigSample0.rtc diff /dev/null | head -1
  default       double_param0  0.99                              -
  $ cp 'as it was' ConsoleIn0.rtc; rtconf ConfigSample0.rtc diff ConsoleIn0.rtc | head -1; rm ConsoleIn0.rtc
  default  double_param0  0.99                              -
  $ mkdir conf; cp 'as it was' conf/dump; rtconf ConfigSample0.rtc diff conf/dump
  $ for cwd in / ''; do RTCSH_CWD=$cwd rtconf "$here/ConfigSample0.rtc" diff conf/dump; done
  $ echo oops > broken; rtconf ConfigSample0.rtc diff broken
  rtconf: broken:1: neither [set] nor name=value
  [1]
  $ rtconf ConfigSample0.rtc diff .
  rtconf: /localhost:$PORT/test.host_cxt: not a component (it is a directory; rtfind /localhost:$PORT/test.host_cxt -t c prints the components in it)
  [3]
