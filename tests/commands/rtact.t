rtact activates components. What rtact, rtdeact and rtreset have in common is here, too.

world: two
world: error
world: slow
world: contexts

It is silent, and the component has changed its state when it ends (those of OpenRTM 1.1 will change it soon):

  $ rtact ConsoleIn0.rtc
  $ ctl state ConsoleIn0
  ACTIVE

Activating an active component is no failure:

  $ rtact ConsoleIn0.rtc
  $ rtact -v ConsoleIn0.rtc
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: Active

Several paths, absolute or relative; options may follow them:

  $ rtdeact ConsoleIn0.rtc
  $ RTCSH_CWD=/ rtact localhost:$PORT/test.host_cxt/ConsoleIn0.rtc \
  >     /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc --wait=30 -v
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: Active
  rtact: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Active
  $ ctl state ConsoleIn0; ctl state ConsoleOut0
  ACTIVE
  ACTIVE

What it costs a component:

  $ rtdeact ConsoleIn0.rtc ConsoleOut0.rtc; ctl reset
  $ rtact ConsoleIn0.rtc
  $ calls
  1 activate_component
  1 get_component_state
  1 get_owned_contexts
  1 get_participating_contexts
  $ rtdeact ConsoleIn0.rtc

--dry-run prints commands that do it, and changes nothing; what is active already needs no command:

  $ rtact --dry-run ConsoleIn0.rtc ../test.host_cxt/ConsoleOut0.rtc
  rtact /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  rtact /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ ctl state ConsoleIn0; ctl state ConsoleOut0
  INACTIVE
  INACTIVE
  $ rtact --dry-run ConsoleIn0.rtc ConsoleOut0.rtc | sh
  $ ctl state ConsoleIn0; ctl state ConsoleOut0
  ACTIVE
  ACTIVE
  $ rtact --dry-run ConsoleIn0.rtc
  $ rtact --dry-run -e 2 Multi0.rtc
  rtact -e 2 /localhost:$PORT/test.host_cxt/Multi0.rtc

Refused: the reason, and status 6. Some components fail while they are being activated; they are Active for a period first, so
that only --wait knows:

  $ rtact Broken0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Broken0.rtc: cannot activate: it is in Error; reset it first
  [6]
  $ rtact --wait ErrStart0.rtc
  rtact: /localhost:$PORT/test.host_cxt/ErrStart0.rtc: cannot activate: it went to Error
  [6]
  $ rtact ErrStart0.rtc
  rtact: /localhost:$PORT/test.host_cxt/ErrStart0.rtc: cannot activate: it is in Error; reset it first
  [6]

Those that take longer than OpenRTM waits for are Active all the same; --wait has a limit. (Components that take their time, and
contexts that are stopped: tests/sim/stories/rtact-late.t.)

  $ within 0.6-8 rtact -v Slow0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Slow0.rtc: Active
  $ within 0.9-8 rtact --wait 0.8 Stuck0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Stuck0.rtc: not Active within 0.8s, still Inactive
  [4]

-e chooses the execution context: the owned ones from 0, then those that it takes part in; below zero counts the owned
ones from their end:

  $ states() { rtcat --json Multi0.rtc | grep -o '"state": "[A-Za-z]*"' | head -3; }
  $ rtact -e 1 Multi0.rtc
  $ states
  "state": "Inactive"
  "state": "Active"
  "state": "Inactive"
  $ rtact --exec-context=2 Multi0.rtc
  $ states
  "state": "Inactive"
  "state": "Active"
  "state": "Active"
  $ rtact --exec_context -2 Multi0.rtc
  $ rtdeact -e 2 Multi0.rtc
  $ states
  "state": "Active"
  "state": "Active"
  "state": "Inactive"
  $ rtdeact -v -e -1 Multi0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Multi0.rtc: accepted
  $ states
  "state": "Active"
  "state": "Inactive"
  "state": "Inactive"

  $ rtact -e 3 Multi0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Multi0.rtc: no such execution context: 3 (it has 3)
  [3]
  $ rtact -e -3 Multi0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Multi0.rtc: no such execution context: -3 (it has 3)
  [3]
  $ rtact -e 1 ConsoleIn0.rtc Multi0.rtc
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such execution context: 1 (it has 1)
  [5]
  $ rtact -e one Multi0.rtc
  rtact: argument -e/--exec-context/--exec_context: not a whole number: 'one' (see --help)
  [2]
  $ rtact Multi0.rtc -e
  rtact: argument -e/--exec-context/--exec_context: expected one argument (see --help)
  [2]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A
invocation: --wait 0.5 A B
lasting: --wait 60 A
broken component: 5 6
