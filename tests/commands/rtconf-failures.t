What can go wrong with rtconf.

world: config
world: config --flavour cpp2 --context cpp.host_cxt/%n.rtc
world: these ConfigSample:Dead0
world: these ConfigSample:Hung0
world: fragile

No such set or parameter; of several, nothing is set then:

  $ rtconf ConfigSample0.rtc -s mode9
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: mode9; did you mean mode1?
  [3]
  $ rtconf ConfigSample0.rtc -s __widget__
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: __widget__ (there are: default, mode0, mode1)
  [3]
  $ rtconf ConfigSample0.rtc -s __widget__ get int_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: __widget__ (there are: default, mode0, mode1)
  [3]
  $ rtconf ConfigSample0.rtc get int_param9
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration parameter: int_param9; did you mean int_param1?
  [3]
  $ rtconf ConfigSample0.rtc set int_param0=7 int_param9=7
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration parameter: int_param9; did you mean int_param1?
  [3]
  $ rtconf ConfigSample0.rtc get int_param0
  -999
  $ rtconf ConfigSample0.rtc -s mode9 set int_param0 7
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: mode9; did you mean mode1?
  [3]
  $ rtconf ../cpp.host_cxt/ConfigSample0.rtc -s mode9 set int_param0 7
  rtconf: /localhost:$PORT/cpp.host_cxt/ConfigSample0.rtc: no such configuration set: mode9; did you mean mode1?
  [3]
  $ rtconf ../cpp.host_cxt/ConfigSample0.rtc
  +default
  +mode0
  +mode1*
  $ rtconf ConfigSample0.rtc act mode9
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: mode9; did you mean mode1?
  [3]
  $ rtconf ConfigSample0.rtc act __widget__
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: __widget__ (there are: default, mode0, mode1)
  [3]
  $ rtconf ConfigSample0.rtc act mode9 --dry-run
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: mode9; did you mean mode1?
  [3]
  $ rtconf ConfigSample0.rtc set int_param9 1 --dry-run
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration parameter: int_param9; did you mean int_param1?
  [3]

Metadata cannot be activated:

  $ rtconf ConfigSample0.rtc -a act __widget__
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: configuration set __widget__ holds metadata and cannot be active
  [6]
  $ rtconf ../cpp.host_cxt/ConfigSample0.rtc -a -s __widget__ act
  rtconf: /localhost:$PORT/cpp.host_cxt/ConfigSample0.rtc: configuration set __widget__ holds metadata and cannot be active
  [6]

A value that is not a number is taken by the component all the same; it is text to the wire:

  $ rtconf ConfigSample0.rtc set int_param0 many; rtconf ConfigSample0.rtc get int_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but many is not a number, unlike the old value (-999)
  many

Somebody else has set values and activated nothing, so that no set is active:

  $ ctl fail activate_configuration_set 1 UNKNOWN; rtconf ConfigSample0.rtc set int_param0 1
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: does not activate configuration set mode1 (CORBA.UNKNOWN)
  [6]
  $ rtconf ConfigSample0.rtc
  +default
  +mode0
  +mode1
  $ rtconf ConfigSample0.rtc get int_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: has no active configuration set; name one with -s
  [6]
  $ rtconf ConfigSample0.rtc set int_param0 2
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: has no active configuration set; name one with -s
  [6]
  $ rtconf ConfigSample0.rtc -s mode1 get int_param0
  1
  $ rtconf ConfigSample0.rtc -s mode1 set int_param0 2
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: has no active configuration set; nothing is in use until one is activated
  $ rtconf ConfigSample0.rtc act mode1; rtconf ConfigSample0.rtc
  +default
  +mode0
  +mode1*

Not a component, no such component:

  $ rtconf Nope0.rtc
  rtconf: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [3]
  $ rtconf ConfigSample.rtc get int_param0
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample.rtc: no such path; did you mean ConfigSample0.rtc?
  [3]
  $ rtconf ConfigSample0.rtc:port
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc:port: not a component (it is a port)
  [3]
  $ rtconf ..
  rtconf: /localhost:$PORT: not a component (it is a name server; rtfind /localhost:$PORT -t c prints the components in it)
  [3]
  $ rtconf /
  rtconf: /: not a component (it is a root directory; rtfind / -t c prints the components in it)
  [3]
  $ rtconf ConfigSample0.rtc/
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: not a directory (it is a component)
  [3]

Dead and silent peers:

  $ kill-mock these; hang these2
  $ rtconf Dead0.rtc
  rtconf: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtconf Dead0.rtc set int_param0 1
  rtconf: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ within 4-8 rtconf --timeout 4 Hung0.rtc -l
  rtconf: /localhost:$PORT/test.host_cxt/Hung0.rtc: no answer within 4s
  [4]
  $ rtconf ConfigSample0.rtc dump Dead0.rtc; rtconf ConfigSample0.rtc diff Dead0.rtc  # a component comes before a file
  rtconf: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ interrupt 0.5 rtconf Hung0.rtc set int_param0 1
  [130]
  $ ctl fail get_configuration_sets 1 COMM_FAILURE; rtconf ConfigSample0.rtc | head -1  # a question is asked again
  +default
  $ ctl fail set_configuration_set_values 1 COMM_FAILURE; rtconf ConfigSample0.rtc set int_param0 5
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: connection lost
  [4]
  $ ctl fail set_configuration_set_values 1 UNKNOWN; rtconf ConfigSample0.rtc set int_param0 5
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: CORBA.UNKNOWN
  [6]
  $ ctl fail set_configuration_set_values 1 HANG
  $ within 4-8 rtconf --timeout 4 ConfigSample0.rtc set int_param0 5
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no answer within 4s
  [4]
  $ rtconf ConfigSample0.rtc get int_param0
  2

A component without parameters; the one that dies of being asked for its profile at the wrong time stays alive:

  $ rtconf Fragile0.rtc -l
  -default*
  $ rtconf Fragile0.rtc dump
  # configuration of /localhost:$PORT/test.host_cxt/Fragile0.rtc
  [default] active
  $ rtconf Fragile0.rtc act default
  $ rtconf Fragile0.rtc diff ConfigSample0.rtc | wc -l
  22
  $ rtconf Fragile0.rtc set any 1
  rtconf: /localhost:$PORT/test.host_cxt/Fragile0.rtc: no such configuration parameter: any (there are: none)
  [3]
  $ rtconf Fragile0.rtc get any
  rtconf: /localhost:$PORT/test.host_cxt/Fragile0.rtc: no such configuration parameter: any (there are: none)
  [3]

Output that cannot be written:

  $ rtconf ConfigSample0.rtc -l > /dev/full
  rtconf: No space left on device
  [1]
  $ rtconf ConfigSample0.rtc dump >&-
  rtconf: cannot write the output: Bad file descriptor
  [1]
  $ rtconf ConfigSample0.rtc get int_param0 >&-
  rtconf: cannot write the output: Bad file descriptor
  [1]
  $ rtconf ConfigSample0.rtc -l | true
