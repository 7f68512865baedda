rtdeact deactivates components. rtact.t shows what it shares with rtact; what can go wrong is in rtact-failures.t.

world: two
world: error
world: slow
world: contexts
world: two --flavour cpp11 --rate 100 --context old.host_cxt/%n.rtc

  $ rtact ConsoleIn0.rtc ConsoleOut0.rtc
  $ rtdeact ConsoleIn0.rtc ConsoleOut0.rtc
  $ ctl state ConsoleIn0; ctl state ConsoleOut0
  INACTIVE
  INACTIVE

A component that is inactive already is left as it is:

  $ rtdeact -v ConsoleIn0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: Inactive

An argument that is no component does not keep the others from being changed:

  $ rtact ConsoleIn0.rtc; rtdeact ConsoleIn0.rtc ConsoleOut0.rtc:in .
  rtdeact: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: not a component (it is a port)
  rtdeact: /localhost:$PORT/test.host_cxt: not a component (it is a directory; --all takes the components in it)
  [5]
  $ ctl state ConsoleIn0
  INACTIVE

--dry-run prints commands that do it, and changes nothing:

  $ rtact ConsoleIn0.rtc
  $ rtdeact --dry-run ConsoleOut0.rtc ConsoleIn0.rtc
  rtdeact /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ ctl state ConsoleIn0
  ACTIVE
  $ rtdeact --dry-run ConsoleOut0.rtc ConsoleIn0.rtc | sh
  $ ctl state ConsoleIn0
  INACTIVE

Error is left by rtreset, not by rtdeact:

  $ rtdeact Broken0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Broken0.rtc: cannot deactivate: it is in Error; reset it first
  [6]

A component of OpenRTM 1.1 answers only after ten periods of its context:

  $ rtact --wait ../old.host_cxt/ConsoleIn0.rtc
  $ within 0.1-8 rtdeact -v ../old.host_cxt/ConsoleIn0.rtc
  rtdeact: /localhost:$PORT/old.host_cxt/ConsoleIn0.rtc: accepted

--wait waits for the state; a slow component is not reported as failed without it either. (What takes longer than that:
tests/sim/stories/rtact-late.t.)

  $ rtact Slow0.rtc
  $ within 0.6-8 rtdeact -v Slow0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Slow0.rtc: Inactive
  $ rtact Slow0.rtc
  $ within 0.6-8 rtdeact --wait=30 Slow0.rtc -v
  rtdeact: /localhost:$PORT/test.host_cxt/Slow0.rtc: Inactive

-e, another execution context:

  $ rtact -e 1 Multi0.rtc; rtact -e 0 Multi0.rtc
  $ rtdeact Multi0.rtc -e 1
  $ rtcat --json Multi0.rtc | grep -o '"state": "[A-Za-z]*"' | head -3
  "state": "Active"
  "state": "Inactive"
  "state": "Inactive"
  $ rtdeact -e 7 Multi0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Multi0.rtc: no such execution context: 7 (it has 3)
  [3]

Usage:

  $ rtdeact
  rtdeact: the following arguments are required: PATH (see --help)
  [2]
  $ rtdeact --help -v | head -1
  usage: rtdeact [-e N] [--wait [SECONDS]] [--all] [--dry-run] [-v] [-q]
  $ rtdeact --help -v | grep -A 2 '^examples'
  examples:
    rtdeact ConsoleIn0.rtc ConsoleOut0.rtc     stop both
    rtdeact --wait 5 Motor0.rtc                wait until it is Inactive

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A
invocation: --wait 0.5 A B
broken component: 5 6
