A component in execution contexts of others that have ended, that do not answer, or in which it stops late.

world: these Mock:Sensor0
world: these Mock:Motor0 Mock:Camera0
world: these Mock:Driver0
world: these Mock:Lame0 --async

  $ rtec Sensor0.rtc attach Motor0.rtc Camera0.rtc
  $ rtec Driver0.rtc attach Lame0.rtc

All contexts are asked before one is waited for: where a component stops late, it stops elsewhere at once:

  $ rtact --wait -e 0 Lame0.rtc
  $ rtact --wait -e 1 Lame0.rtc
  $ rtec Lame0.rtc rate 0.001
  $ rtec Lame0.rtc
  0  0     Periodic  0.001  Running  Active  Lame0    -
  1  1000  Periodic  1000   Running  Active  Driver0  Lame0
  $ rtdeact --wait 60 Lame0.rtc &
  $ sleep 2
  $ ctl @these4 state Lame0 1000
  INACTIVE
  $ ctl @these4 state Lame0
  ACTIVE

Where a component may be Active in a context that does not answer, only its own one that runs is used, and -v reports that:

  $ hang these
  $ rtact --dry-run --timeout 0.5 Motor0.rtc
  rtact /robot/test.host_cxt/Motor0.rtc
  [0] after 0.6 s
  $ rtact -v --timeout 0.5 Motor0.rtc
  ! rtact: /robot/test.host_cxt/Motor0.rtc: accepted; its execution context 1, of another component, does not answer: it may be Active there
  [0] after 0.6 s
  $ rtec Camera0.rtc stop
  $ rtact --timeout 0.5 Camera0.rtc
  ! rtact: /robot/test.host_cxt/Camera0.rtc: its execution context 1, of another component, does not answer: it may be Active there
  [4] after 0.6 s
  $ rtact --dry-run --timeout 0.5 Camera0.rtc
  ! rtact: /robot/test.host_cxt/Camera0.rtc: its execution context 1, of another component, does not answer: it may be Active there
  [4] after 0.6 s
  $ rtdeact --dry-run --timeout 0.5 Camera0.rtc
  ! rtdeact: /robot/test.host_cxt/Camera0.rtc: its execution context 1, of another component, does not answer: it may be Active there
  [4] after 0.5 s
  $ ctl @these2 state Camera0
  INACTIVE
  $ rtec Camera0.rtc start
  $ rtdeact --timeout 0.5 Motor0.rtc
  ! rtdeact: /robot/test.host_cxt/Motor0.rtc: its execution context 1, of another component, does not answer: it may be Active there
  [4] after 0.6 s
  $ ctl @these2 state Motor0
  INACTIVE
  $ rtact Motor0.rtc
  [0] after 3.1 s
  $ rtcryo --all -o lost.rtsys /robot/test.host_cxt/Motor0.rtc
  $ rtstop -q --timeout 0.5 lost.rtsys
  ! rtstop: /robot/test.host_cxt/Motor0.rtc: its execution context 1, of another component, does not answer: it may be Active there; whether it has been done is not known
  [4] after 0.6 s
  $ ctl @these2 state Motor0
  INACTIVE
  $ rtact Motor0.rtc
  [0] after 3.1 s

Where the process of that context is gone, the component is known not to be executed there:

  $ kill these
  $ rtdeact -v --wait Motor0.rtc
  ! rtdeact: /robot/test.host_cxt/Motor0.rtc: Inactive
  $ rtact -v --wait Motor0.rtc
  ! rtact: /robot/test.host_cxt/Motor0.rtc: Active
  $ rtstop -q lost.rtsys
  $ rtec Motor0.rtc
  0  0  Periodic  1000  Running  Inactive  Motor0  -
  1  ?  ?         ?     ?        Unknown   ?       ?
