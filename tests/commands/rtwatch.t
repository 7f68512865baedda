rtwatch reports what happens to components. Those that take observers, of either kind, report it themselves; others are polled.

world: observed
world: these ConsoleIn:Plain0 --flavour cpp2
world: these ConsoleIn:Old0 --flavour rtorb
world: zombie 1 --context gone.host_cxt/%n.rtc
world: hung 1 --context hung.host_cxt/%n.rtc

An observer of OpenRTM, events of some kinds; -n ends it:

  $ rtwatch -n 4 -f RTC_STATUS ConsoleIn0.rtc > out 2>&1 & watched ConsoleIn0
  $ rtact ConsoleIn0.rtc; ctl error ConsoleIn0
  $ rtreset ConsoleIn0.rtc; rtact --wait 20 ConsoleIn0.rtc
  $ wait; plain out
  [T] 0 ACTIVE
  [T] 0 ERROR
  [T] 0 INACTIVE
  [T] 0 ACTIVE
  $ rtwatch -n 5 -f EC_EVENT -f CONFIG_EVENT ConsoleIn0.rtc > out & watched ConsoleIn0
  $ rtec ConsoleIn0.rtc rate 500; rtec ConsoleIn0.rtc stop
  $ rtec ConsoleIn0.rtc start; rtconf ConsoleIn0.rtc act default
  $ wait; plain out | sort
  [T] 0 EC_RATE_CHANGED
  [T] 0 EC_SHUTDOWN
  [T] 0 EC_STARTUP
  [T] default CFG_ACTIVATE_SET
  [T] default CFG_UPDATE_SET

One of FSM4RTC; several components have their names in the lines. A line is written when it happens, not when a buffer is
full, and the time is now:

  $ rtwatch -f PORT_EVENT ConsoleIn0.rtc ConsoleOut0.rtc > out & watch=$!
  $ watched ConsoleOut0; watched ConsoleIn0
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in; soon 'grep RECEIVE out'
  $ rtdis ConsoleIn0.rtc; soon '[ $(grep -c DISC out) = 2 ]'
  $ kill $watch; wait $watch
  [143]
  $ plain out | sort -u
  [ConsoleIn0.rtc T] ConsoleIn0.out PORT_CONNECT
  [ConsoleIn0.rtc T] ConsoleIn0.out PORT_DISCONNECT
  [ConsoleIn0.rtc T] ConsoleIn0.out PORT_SEND
  [ConsoleOut0.rtc T] ConsoleOut0.in PORT_CONNECT
  [ConsoleOut0.rtc T] ConsoleOut0.in PORT_DISCONNECT
  [ConsoleOut0.rtc T] ConsoleOut0.in PORT_RECEIVE
  $ echo $(( $(date +%s) - $(sed -n '1s/.* \([0-9]*\)\..*/\1/p' out) < 100 ))
  1
  $ rtwatch -n 8 -f FSM_EVENT Microwave0.rtc > out & watched Microwave0
  $ ctl fsm Microwave0 "$(printf 'open\033[2J')"; wait
  $ plain out | sort
  [T] FSM_STATUS closed POST_ON_EXIT
  [T] FSM_STATUS closed PRE_ON_EXIT
  [T] FSM_STATUS closed PRE_ON_STATE_CHANGE
  [T] FSM_STATUS open\x1b[2J POST_ONENTRY
  [T] FSM_STATUS open\x1b[2J POST_ON_DO
  [T] FSM_STATUS open\x1b[2J POST_ON_STATE_CHNAGE
  [T] FSM_STATUS open\x1b[2J PRE_ONENTRY
  [T] FSM_STATUS open\x1b[2J PRE_ON_DO

Heartbeats, and everything, which is the default:

  $ rtwatch -n 1 -f HEARTBEAT ConsoleIn0.rtc | plain
  [T] HEARTBEAT
  $ rtwatch -f HEARTBEAT Microwave0.rtc > out & watch=$!
  $ soon 'grep -q EC_ out && grep -q RTC_ out'
  $ kill $watch; wait $watch
  [143]
  $ plain out | sort -u
  [T] EC_HEARTBEAT
  [T] RTC_HEARTBEAT
  $ rtdeact --wait 20 ConsoleIn0.rtc; rtwatch -n 1 ConsoleIn0.rtc | plain
  [T] HEARTBEAT
  $ rtwatch -n 1 -f ALL -f RTC_STATUS ConsoleIn0.rtc | plain
  [T] HEARTBEAT

JSON:

  $ rtwatch --json -n 2 -f EC_EVENT -f CONFIG_EVENT Motor0.rtc > out & watched Motor0
  $ rtec Motor0.rtc rate 500; rtconf Motor0.rtc act default
  $ wait; plain out
  {"event": "EC_RATE_CHANGED", "kind": "EC_EVENT", "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "subject": "0", "time": T}
  {"event": "CFG_ACTIVATE_SET", "kind": "CONFIG_EVENT", "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "subject": "default", "time": T}

A component that takes no observer is polled. It is asked for nothing that would make it look after its connections more
than once, and never offered what it does not know:

  $ ctl @these reset
  $ rtwatch -f ALL Plain0.rtc > out 2>&1 & watch=$!
  $ soon 'ctl @these calls | grep get_active_configuration_set'
  $ rtact --wait 20 Plain0.rtc; soon 'grep ACTIVE out'
  $ rtec Plain0.rtc rate 500; soon 'grep RATE out'
  $ rtec Plain0.rtc stop
  $ soon 'grep SHUT out'; rtec Plain0.rtc start
  $ soon 'grep STARTUP out'; rtec Motor0.rtc attach Plain0.rtc
  $ soon 'grep ATT out'; rtec Motor0.rtc detach Plain0.rtc
  $ soon 'grep DET out'; rtdeact Plain0.rtc
  $ soon 'grep " 0 INACTIVE" out'
  $ kill $watch; wait $watch
  [143]
  $ plain out | grep -v 1000.*INACTIVE
  rtwatch: /localhost:$PORT/test.host_cxt/Plain0.rtc: offers no observer; it is polled (5 Hz), which shows no connections
  [T] 0 ACTIVE
  [T] 0 EC_RATE_CHANGED
  [T] 0 EC_SHUTDOWN
  [T] 0 EC_STARTUP
  [T] 1000 EC_ATTACHED
  [T] 1000 EC_DETACHED
  [T] 0 INACTIVE
  $ ctl @these calls | grep -E '(component|port)_profile|add'
  1 get_component_profile
  1 get_port_profile
  $ rtwatch -q -n 1 -t 99 Old0.rtc > out 2>&1 & soon 'ctl @these2 calls | grep get_active_configuration_set'
  $ rtact Old0.rtc; wait
  $ plain out
  [T] 0 ACTIVE

When polling cannot show what is wanted, that is said:

  $ rtwatch -f PORT_EVENT -f HEARTBEAT Plain0.rtc
  rtwatch: /localhost:$PORT/test.host_cxt/Plain0.rtc: offers no observer, and polling does not show HEARTBEAT, PORT_EVENT
  [6]
  $ rtwatch -t 0.3 -f PORT_EVENT Plain0.rtc ConsoleIn0.rtc
  rtwatch: /localhost:$PORT/test.host_cxt/Plain0.rtc: offers no observer, and polling does not show PORT_EVENT
  [5]

One that is gone, silent, missing or no component costs its own line:

  $ rtwatch -n 1 -f HEARTBEAT --timeout 2 ConsoleIn0.rtc ../hung.host_cxt/Mock0.rtc \
  >     ../gone.host_cxt/Mock0.rtc ConsolIn0.rtc .. > out 2> err
  [5]
  $ plain out; sort err
  [ConsoleIn0.rtc T] HEARTBEAT
  rtwatch: /localhost:$PORT/gone.host_cxt/Mock0.rtc: connection refused; its process is gone (zombie)
  rtwatch: /localhost:$PORT/hung.host_cxt/Mock0.rtc: no answer within 2s
  rtwatch: /localhost:$PORT/test.host_cxt/ConsolIn0.rtc: no such path; did you mean ConsoleIn0.rtc?
  rtwatch: /localhost:$PORT: not a component (it is a name server; rtfind /localhost:$PORT -t c prints the components in it)
  $ rtwatch ConsolIn0.rtc
  rtwatch: /localhost:$PORT/test.host_cxt/ConsolIn0.rtc: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ rtwatch ../gone.host_cxt/Mock0.rtc ConsolIn0.rtc ConsoleIn0.rtc:out
  rtwatch: /localhost:$PORT/gone.host_cxt/Mock0.rtc: connection refused; its process is gone (zombie)
  rtwatch: /localhost:$PORT/test.host_cxt/ConsolIn0.rtc: no such path; did you mean ConsoleIn0.rtc?
  rtwatch: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not a component (it is a port)
  [5]

Nothing in time: -t alone is no question, -n with -t is one.

  $ rtwatch -t 0.3 -f RTC_STATUS ConsoleIn0.rtc
  $ rtwatch -t 0.3 -n 1 -f RTC_STATUS ConsoleIn0.rtc Motor0.rtc
  rtwatch: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc, /localhost:$PORT/test.host_cxt/Motor0.rtc: 0 of 1 within 0.3s
  [1]
  $ rtwatch -n 0 ConsoleIn0.rtc

Whatever ends it, nothing is left behind in any component, and stdin is not needed:

  $ interrupt 1 rtwatch ConsoleIn0.rtc ConsoleOut0.rtc > nul
  [130]
  $ ctl observers ConsoleIn0
  $ for signal in TERM HUP; do
  >     interrupt 1:$signal rtwatch ConsoleIn0.rtc ConsoleOut0.rtc > nul <&-; echo $?
  > done
  143
  129
  $ rtwatch ConsoleIn0.rtc ConsoleOut0.rtc | head -1 | plain | cut -d' ' -f2
  T]
  $ (rtwatch -f RTC_STATUS ConsoleIn0.rtc; echo $? >&2) | true
  141
  $ rtwatch ConsoleIn0.rtc > /dev/full
  rtwatch: No space left on device
  [1]
  $ for name in ConsoleIn0 ConsoleOut0 Microwave0 Motor0 Mock0; do ctl observers $name; done

Wrong usage is found before anything is asked:

  $ ctl reset
  $ rtwatch
  rtwatch: the following arguments are required: PATH (see --help)
  [2]
  $ rtwatch -f BOGUS ConsoleIn0.rtc
  rtwatch: argument -f/--filter: not one of ALL, RTC_STATUS, COMPONENT_PROFILE, EC_EVENT, PORT_EVENT, CONFIG_EVENT, FSM_EVENT, HEARTBEAT, LIFE_EVENT: BOGUS (see --help)
  [2]
  $ rtwatch -n many ConsoleIn0.rtc
  rtwatch: argument -n/--number: not a whole number: 'many' (see --help)
  [2]
  $ rtwatch -t 0 ConsoleIn0.rtc
  rtwatch: argument -t: not a number of seconds above 0: 0 (see --help)
  [2]
  $ ctl calls

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -t 0.5 A
invocation: -f LIFE_EVENT -t 0.5 A B
lasting: A
broken component: 5
examples: endless
examples: asking
