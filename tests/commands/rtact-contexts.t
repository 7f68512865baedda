Robots that run many components in the execution context of one: rtact, rtdeact, rtreset and all others act where the component is.

world: these Mock:Sensor0
world: these Mock:Motor0 Mock:Camera0

  $ rtec Sensor0.rtc attach Motor0.rtc Camera0.rtc
  $ rtact -e 1 Motor0.rtc
  $ rtec Motor0.rtc | awk '{print $1, $2, $6, $7}'
  0 0 Inactive Motor0
  1 1000 Active Sensor0

A component that is Active in the context of another one is left as it is; -v says where it is Active:

  $ rtact Motor0.rtc
  $ rtact -v --wait Motor0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Motor0.rtc: already Active in the context of Sensor0
  $ rtact --dry-run Motor0.rtc
  $ rtec Motor0.rtc | awk '{print $1, $2, $6, $7}'
  0 0 Inactive Motor0
  1 1000 Active Sensor0

rtcat says which context has which state; rtls and rtfind one state over all:

  $ rtcat Motor0.rtc | grep Context
  +Execution Context 0  Inactive
  +Execution Context 1000 of Sensor0  Active
  $ rtcat -l Motor0.rtc | sed -n '/^-Execution Context 1000/,/Owner/p'
  -Execution Context 1000 of Sensor0  Active
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  Sensor0
  $ rtcat Sensor0.rtc | grep Context
  +Execution Context 0
  $ rtls -l Motor0.rtc
  Active  2/0  1/0  1/0  0/0  Motor0.rtc
  $ rtfind . --state active
  /localhost:$PORT/test.host_cxt/Motor0.rtc

Inactive is Inactive in every context:

  $ rtdeact --dry-run Motor0.rtc
  rtdeact /localhost:$PORT/test.host_cxt/Motor0.rtc
  $ rtdeact -v --wait 30 Motor0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Motor0.rtc: Inactive
  $ rtls -l Motor0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
  $ rtdeact --dry-run Motor0.rtc

Two contexts at once happen only with -e; rtdoctor reports it, with both:

  $ rtact -e 0 Motor0.rtc; rtact -e 1 Motor0.rtc
  $ rtdoctor -q Motor0.rtc | grep Motor0
  warn  /localhost:$PORT/test.host_cxt/Motor0.rtc: Active in its execution contexts 0 and 1 at once: each that runs executes it; try: see whose they are (rtec /localhost:$PORT/test.host_cxt/Motor0.rtc), and leave all but one: rtdeact -e N /localhost:$PORT/test.host_cxt/Motor0.rtc
  $ rtdeact --wait Motor0.rtc
  $ rtec Motor0.rtc | awk '{print $1, $2, $6, $7}'
  0 0 Inactive Motor0
  1 1000 Inactive Sensor0

Its own context is preferred if that runs, else the one of another component that runs:

  $ rtact -v Motor0.rtc; rtdeact --wait Motor0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Motor0.rtc: accepted
  $ rtec Motor0.rtc stop
  $ rtact --dry-run Motor0.rtc Camera0.rtc
  rtact -e 1 /localhost:$PORT/test.host_cxt/Motor0.rtc
  rtact /localhost:$PORT/test.host_cxt/Camera0.rtc
  $ rtact -v --wait Motor0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Motor0.rtc: Active in the context of Sensor0
  $ rtdeact --wait Motor0.rtc

A component in Error in the context of another one is reset there; before that it is not activated in its own:

  $ rtact Motor0.rtc; rtec Motor0.rtc start
  $ ctl @these error Sensor0 1
  $ rtls -l Motor0.rtc
  Error  2/0  1/0  1/0  0/0  Motor0.rtc
  $ rtact Motor0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Motor0.rtc: cannot activate: it is in Error; reset it first
  [6]
  $ rtreset -v --wait Motor0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Motor0.rtc: Inactive
  $ rtec Motor0.rtc | awk '{print $1, $2, $6, $7}'
  0 0 Inactive Motor0
  1 1000 Inactive Sensor0

A file keeps who takes part in which context, and rtstart, rtstop and rtcheck look at the right one:

  $ rtact -e 1 Motor0.rtc Camera0.rtc; rtact Sensor0.rtc
  $ rtcryo --all -o robot.rtsys; grep -c COMPONENT_PATH_ID robot.rtsys
  2
  $ rtcheck robot.rtsys
  $ rtstart -q robot.rtsys
  $ rtec Motor0.rtc | awk '{print $1, $2, $6, $7}'
  0 0 Inactive Motor0
  1 1000 Active Sensor0
  $ rtstop -q robot.rtsys
  $ rtls -l | awk '{print $1, $6}'
  Inactive Camera0.rtc
  Inactive Motor0.rtc
  Inactive Sensor0.rtc
  $ rtcheck -s Inactive robot.rtsys
  $ rtec Sensor0.rtc detach Motor0.rtc
  $ rtcheck -s Inactive robot.rtsys
  Component /localhost:$PORT/test.host_cxt/Motor0.rtc does not take part in an execution context of /localhost:$PORT/test.host_cxt/Sensor0.rtc
  [1]
  $ rtresurrect --dry-run robot.rtsys
  rtec /localhost:$PORT/test.host_cxt/Sensor0.rtc attach /localhost:$PORT/test.host_cxt/Motor0.rtc
  $ rtresurrect robot.rtsys
  $ rtec Motor0.rtc | awk '{print $1, $2, $6, $7}'
  0 0 Inactive Motor0
  1 1001 Inactive Sensor0
  $ rtcheck -s Inactive robot.rtsys

The context of a component that hangs: what was done elsewhere is done, but nobody can know that the component is Inactive

  $ rtact Camera0.rtc
  $ hang these
  $ within 4-20 rtdeact --timeout 4 --wait 4 Camera0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Camera0.rtc: its execution context 1, of another component, does not answer: it may be Active there
  [4]
  $ ctl @these2 state Camera0
  INACTIVE
