rtec shows and changes the execution contexts of a component: what drives it, how often, and together with whom.

world: contexts --flavour cpp2
world: these ConsoleIn ConsoleOut --flavour cpp2 --rate 50
world: these ConsoleIn:Old0 ConsoleOut:Old1 --flavour cpp11 --rate 50
world: these ConsoleIn:Small0 --flavour rtorb --rate 50
world: these ConsoleIn:Py0 --flavour py2 --rate 50
world: composite --flavour cpp2 --context robot.host_cxt/%n.rtc
world: zombie 1
world: hung 1 --context hung.host_cxt/%n.rtc

A line for each context, as -e counts them: number, handle, kind, rate, whether it runs, the state of the component in it,
its owner, who else takes part:

  $ rtec ConsoleIn0.rtc
  0  0  Periodic  50  Running  Inactive  ConsoleIn0  -
  $ rtec -e 2 Multi0.rtc
  2  1000  Periodic  1000  Running  Inactive  Driver0  Multi0
  $ rtec Multi0.rtc list
  0  0     Periodic  1000  Running  Inactive  Multi0   -
  1  1     Periodic  1000  Running  Inactive  Multi0   -
  2  1000  Periodic  1000  Running  Inactive  Driver0  Multi0
  $ rtec Driver0.rtc
  0  0  Periodic  1000  Running  Inactive  Driver0  Multi0
  $ rtec ../robot.host_cxt/Motor0.rtc
  0  0     Periodic  1000  Stopped  Inactive  Motor0      -
  1  1000  Periodic  1000  Running  Inactive  composite0  Sensor0,Controller0,Motor0

A head says so on a terminal only:

  $ NO_COLOR=1 terminal 80 rtec Multi0.rtc
  N  HANDLE  KIND      RATE  RUNS     STATE     OWNER    PARTICIPANTS
  0  0       Periodic  1000  Running  Inactive  Multi0   -
  1  1       Periodic  1000  Running  Inactive  Multi0   -
  2  1000    Periodic  1000  Running  Inactive  Driver0  Multi0

--json has all that and the context's properties:

  $ rtec --json Multi0.rtc | python3 -c 'import json, sys
  > for line in sys.stdin:
  >     context = json.loads(line)
  >     print(sorted(context), context["index"], context["handle"], context["rate"], context["running"], \
  >         context["state"])
  >     print(context["path"], context["owner"], context["participants"], context["properties"])'
  ['handle', 'index', 'kind', 'owner', 'participants', 'path', 'properties', 'rate', 'running', 'state'] 0 0 1000.0 True Inactive
  /localhost:$PORT/test.host_cxt/Multi0.rtc Multi0 [] {'name': '', 'rate': '1000', 'sync_transition': 'YES', 'transition_timeout': '0.5', 'type': 'PeriodicExecutionContext'}
  ['handle', 'index', 'kind', 'owner', 'participants', 'path', 'properties', 'rate', 'running', 'state'] 1 1 1000.0 True Inactive
  /localhost:$PORT/test.host_cxt/Multi0.rtc Multi0 [] {'name': '', 'rate': '1000', 'sync_transition': 'YES', 'transition_timeout': '0.5', 'type': 'PeriodicExecutionContext'}
  ['handle', 'index', 'kind', 'owner', 'participants', 'path', 'properties', 'rate', 'running', 'state'] 2 1000 1000.0 True Inactive
  /localhost:$PORT/test.host_cxt/Multi0.rtc Driver0 ['Multi0'] {'name': '', 'rate': '1000', 'sync_transition': 'YES', 'transition_timeout': '0.5', 'type': 'PeriodicExecutionContext'}

The rate is set in Hz, and read again:

  $ rtec ConsoleIn0.rtc rate 100
  $ rtec -v ConsoleIn0.rtc rate 0.5
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: 0.5 Hz
  $ rtec ConsoleIn0.rtc
  0  0  Periodic  0.5  Running  Inactive  ConsoleIn0  -
  $ rtec Multi0.rtc rate -e 1 20
  $ rtec Multi0.rtc | head -2
  0  0     Periodic  1000  Running  Inactive  Multi0   -
  1  1     Periodic  20    Running  Inactive  Multi0   -
  $ rtec -v -e 2 Multi0.rtc rate 30
  rtec: /localhost:$PORT/test.host_cxt/Multi0.rtc: 30 Hz
  $ rtec Driver0.rtc
  0  0  Periodic  30  Running  Inactive  Driver0  Multi0
  $ rtec -v -e -1 Multi0.rtc rate 40
  rtec: /localhost:$PORT/test.host_cxt/Multi0.rtc: 40 Hz

A context that is stopped keeps its components as they are, and executes none of them:

  $ rtec ConsoleIn0.rtc stop
  $ rtec ConsoleIn0.rtc
  0  0  Periodic  0.5  Stopped  Inactive  ConsoleIn0  -
  $ rtec -v ConsoleIn0.rtc stop
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: stopped
  $ rtec -v ConsoleIn0.rtc start
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: running
  $ rtec -v ConsoleIn0.rtc start
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: running
  $ rtec ConsoleIn0.rtc
  0  0  Periodic  0.5  Running  Inactive  ConsoleIn0  -

Other components can take part in a context; they leave it at its next cycle, which is waited for:

  $ rtec ConsoleIn0.rtc rate 50
  $ rtec ConsoleIn0.rtc attach ConsoleOut0.rtc
  $ rtec -v ConsoleIn0.rtc attach ConsoleOut0.rtc Multi0.rtc
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc takes part
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: /localhost:$PORT/test.host_cxt/Multi0.rtc takes part
  $ rtec ConsoleIn0.rtc
  0  0  Periodic  50  Running  Inactive  ConsoleIn0  ConsoleOut0,Multi0
  $ rtec ConsoleOut0.rtc
  0  0     Periodic  50  Running  Inactive  ConsoleOut0  -
  1  1000  Periodic  50  Running  Inactive  ConsoleIn0   ConsoleOut0,Multi0
  $ rtact --wait -e 1 ConsoleOut0.rtc
  $ rtec ConsoleOut0.rtc
  0  0     Periodic  50  Running  Inactive  ConsoleOut0  -
  1  1000  Periodic  50  Running  Active    ConsoleIn0   ConsoleOut0,Multi0
  $ rtec -v ConsoleIn0.rtc detach ConsoleOut0.rtc Multi0.rtc
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc left
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: /localhost:$PORT/test.host_cxt/Multi0.rtc left
  $ rtec ConsoleIn0.rtc
  0  0  Periodic  50  Running  Inactive  ConsoleIn0  -

A context of OpenRTM-aist 2 knows a new component from its next cycle on, and executes one that leaves until then: both are waited for

  $ rtec ConsoleIn0.rtc rate 4
  $ rtec ConsoleIn0.rtc attach ConsoleOut0.rtc; ctl @these state ConsoleOut0 1001
  INACTIVE
  $ rtec ConsoleIn0.rtc detach ConsoleOut0.rtc; ctl @these state ConsoleOut0 1001 >/dev/null 2>&1
  [1]
  $ rtec ConsoleIn0.rtc rate 50

--measure watches a component that is active and writes to an out port in each cycle; how long can be given. (What it measures:
tests/sim/stories/rtec-measure.t.)

  $ rtec ConsoleIn0.rtc --measure
  0  0  Periodic  50  Running  Inactive  ConsoleIn0  -
  measured  cannot be observed: the component is not Active
  $ rtec ConsoleOut0.rtc --measure 0.2 | tail -1
  measured  cannot be observed: the component is not Active
  $ rtact --wait ConsoleIn0.rtc ConsoleOut0.rtc Py0.rtc Old0.rtc
  $ rtec --measure 0.5 ConsoleOut0.rtc | tail -1
  measured  cannot be observed: no out port is written to
  $ rtec ConsoleIn0.rtc rate 10
  $ within 5-20 rtec --measure=5 ConsoleIn0.rtc
  0  0  Periodic  10  Running  Active  ConsoleIn0  -
  measured  [0-9]+\.[0-9] Hz \(writes to out\) (re)
  $ rtec --measure 5 --json Old0.rtc | grep -o '"measured_[^,]*'
  "measured_by": "writes to out"
  "measured_rate": [0-9]+\.[0-9] (re)

It leaves nothing behind:

  $ ctl @these connectors ConsoleIn0:out

--dry-run prints commands, ready for a shell:

  $ rtec --dry-run ConsoleIn0.rtc rate 5
  rtec /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc rate 5
  $ rtec --dry-run -e 1 Multi0.rtc stop
  rtec -e 1 /localhost:$PORT/test.host_cxt/Multi0.rtc stop
  $ rtec --dry-run Multi0.rtc attach ConsoleOut0.rtc ConsoleIn0.rtc
  rtec /localhost:$PORT/test.host_cxt/Multi0.rtc attach /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ rtec ConsoleIn0.rtc | cut -c1-30
  0  0  Periodic  10  Running  A

Wrong usage:

  $ rtec
  rtec: the following arguments are required: PATH (see --help)
  [2]
  $ rtec ConsoleIn0.rtc faster
  rtec: no such command: faster; did you mean rate? (see --help)
  [2]
  $ rtec ConsoleIn0.rtc rate
  rtec: rate: too few arguments (see --help)
  [2]
  $ rtec ConsoleIn0.rtc rate fast
  rtec: rate: not a number of Hz above 0: fast (see --help)
  [2]
  $ rtec ConsoleIn0.rtc rate 0
  rtec: rate: not a number of Hz above 0: 0 (see --help)
  [2]
  $ rtec ConsoleIn0.rtc rate -5
  rtec: rate: not a number of Hz above 0: -5 (see --help)
  [2]
  $ rtec ConsoleIn0.rtc rate inf
  rtec: rate: not a number of Hz above 0: inf (see --help)
  [2]
  $ rtec ConsoleIn0.rtc rate nan
  rtec: rate: not a number of Hz above 0: nan (see --help)
  [2]
  $ rtec ConsoleIn0.rtc rate 5 6
  rtec: rate: too many arguments (see --help)
  [2]
  $ rtec ConsoleIn0.rtc start now
  rtec: start: too many arguments (see --help)
  [2]
  $ rtec ConsoleIn0.rtc attach
  rtec: attach: too few arguments (see --help)
  [2]
  $ rtec ConsoleIn0.rtc detach
  rtec: detach: too few arguments (see --help)
  [2]
  $ rtec ConsoleIn0.rtc list all
  rtec: list: too many arguments (see --help)
  [2]
  $ rtec -e one ConsoleIn0.rtc
  rtec: argument -e/--exec-context/--exec_context: not a whole number: 'one' (see --help)
  [2]
  $ rtec --measure=0 ConsoleIn0.rtc
  rtec: argument --measure: not a number of seconds above 0: 0 (see --help)
  [2]
  $ rtec Motor0.rtc --measure 0.5 rate 5
  rtec: --measure is for list (see --help)
  [2]

What is no component, no context, no participant, dead, silent:

  $ rtec nobody.rtc
  rtec: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  [3]
  $ rtec .
  rtec: /localhost:$PORT/test.host_cxt: not a component (it is a directory)
  [3]
  $ rtec ConsoleIn0.rtc:out
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not a component (it is a port)
  [3]
  $ rtec Mock0.rtc
  rtec: /localhost:$PORT/test.host_cxt/Mock0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtec -e 3 Multi0.rtc rate 5
  rtec: /localhost:$PORT/test.host_cxt/Multi0.rtc: no such execution context: 3 (it has 3)
  [3]
  $ rtec -e 1 ConsoleIn0.rtc
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such execution context: 1 (it has 1)
  [3]
  $ rtec -e 7 --dry-run ConsoleIn0.rtc stop
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such execution context: 7 (it has 1)
  [3]
  $ rtec ConsoleIn0.rtc attach nobody.rtc ConsoleOut0.rtc
  rtec: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  [5]
  $ rtec ConsoleIn0.rtc detach ConsoleOut0.rtc Multi0.rtc
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such participant: /localhost:$PORT/test.host_cxt/Multi0.rtc
  [5]
  $ rtec ConsoleIn0.rtc attach ConsoleOut0.rtc:in
  rtec: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: not a component (it is a port)
  [3]
  $ rtec ConsoleIn0.rtc attach Mock0.rtc
  rtec: /localhost:$PORT/test.host_cxt/Mock0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtec ConsoleIn0.rtc attach ConsoleIn0.rtc
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc owns this execution context
  [1]
  $ within 4-8 rtec --timeout 4 ../hung.host_cxt/Mock0.rtc
  rtec: /localhost:$PORT/hung.host_cxt/Mock0.rtc: no answer within 4s
  [4]
  $ within 4-8 rtec --timeout 4 ../hung.host_cxt/Mock0.rtc rate 5
  rtec: /localhost:$PORT/hung.host_cxt/Mock0.rtc: no answer within 4s
  [4]

Refused by the context, or not done:

  $ ctl @these fail set_rate 1 NO_PERMISSION; rtec ConsoleIn0.rtc rate 20
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: CORBA.NO_PERMISSION
  [6]
  $ ctl @these fail add_component 1 NO_PERMISSION; rtec ConsoleIn0.rtc attach Multi0.rtc
  rtec: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: CORBA.NO_PERMISSION
  [6]

C++ 1.1, RtORB and Python:

  $ rtec -v Old0.rtc rate 20
  rtec: /localhost:$PORT/test.host_cxt/Old0.rtc: 20 Hz
  $ rtec -v Small0.rtc rate 20
  rtec: /localhost:$PORT/test.host_cxt/Small0.rtc: 20 Hz
  $ rtec -v Py0.rtc rate 20
  rtec: /localhost:$PORT/test.host_cxt/Py0.rtc: 20 Hz
  $ rtec -v Old0.rtc stop
  rtec: /localhost:$PORT/test.host_cxt/Old0.rtc: stopped
  $ rtec -v Small0.rtc stop
  rtec: /localhost:$PORT/test.host_cxt/Small0.rtc: stopped
  $ rtec -v Py0.rtc stop
  rtec: /localhost:$PORT/test.host_cxt/Py0.rtc: stopped
  $ rtec -v Old0.rtc attach Old1.rtc Py0.rtc
  rtec: /localhost:$PORT/test.host_cxt/Old0.rtc: /localhost:$PORT/test.host_cxt/Old1.rtc takes part
  rtec: /localhost:$PORT/test.host_cxt/Old0.rtc: /localhost:$PORT/test.host_cxt/Py0.rtc takes part
  $ rtec Old0.rtc
  0  0  Periodic  20  Stopped  Active  Old0  Old1,Py0
  $ rtec Small0.rtc
  0  0  Periodic  20  Stopped  Inactive  Small0  -
  $ rtec Py0.rtc
  0  0     Periodic  20  Stopped  Active    Py0   -
  1  1000  Periodic  20  Stopped  Inactive  Old0  Old1,Py0
  $ rtec -v Old0.rtc start
  rtec: /localhost:$PORT/test.host_cxt/Old0.rtc: running
  $ rtec -v Small0.rtc start
  rtec: /localhost:$PORT/test.host_cxt/Small0.rtc: running
  $ rtec -v Py0.rtc start
  rtec: /localhost:$PORT/test.host_cxt/Py0.rtc: running
  $ rtec -v Old0.rtc detach Old1.rtc Py0.rtc
  rtec: /localhost:$PORT/test.host_cxt/Old0.rtc: /localhost:$PORT/test.host_cxt/Old1.rtc left
  rtec: /localhost:$PORT/test.host_cxt/Old0.rtc: /localhost:$PORT/test.host_cxt/Py0.rtc left

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A
invocation: --json A
invocation: A rate 100
invocation: A start
invocation: A attach B
invocation: --measure=0.3 A
looking: A
