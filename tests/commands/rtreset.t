rtreset takes components out of Error; they become Inactive. rtact.t shows what it shares with rtact; what can go wrong is in rtact-failures.t.

world: two
world: error
world: slow
world: contexts

  $ rtreset Broken0.rtc
  $ ctl @error state Broken0
  INACTIVE

A component that is inactive already is left as it is, an active one cannot be reset:

  $ rtreset -v Broken0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Broken0.rtc: Inactive
  $ rtact ConsoleIn0.rtc
  $ rtreset ConsoleIn0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: cannot reset: it is Active, not Error
  [6]
  $ rtreset -v Broken0.rtc ConsoleIn0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Broken0.rtc: Inactive
  rtreset: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: cannot reset: it is Active, not Error
  [5]

An argument that is no component does not keep the others from being reset:

  $ ctl @error error Broken0; rtreset Broken0.rtc ConsoleOut0.rtc:in ..
  rtreset: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: not a component (it is a port)
  rtreset: /localhost:$PORT: not a component (it is a name server; --all takes the components in it)
  [5]
  $ ctl @error state Broken0
  INACTIVE

--dry-run prints commands that do it, and changes nothing:

  $ ctl @error error Broken0
  $ rtreset --dry-run Broken0.rtc
  rtreset /localhost:$PORT/test.host_cxt/Broken0.rtc
  $ ctl @error state Broken0
  ERROR
  $ rtreset --dry-run Broken0.rtc | sh
  $ ctl @error state Broken0
  INACTIVE

--wait waits for the state; a slow component is not reported as failed without it either:

  $ ctl @slow error Slow0
  $ within 0.6-9 rtreset -v Slow0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Slow0.rtc: Inactive
  $ ctl @slow error Slow0
  $ within 0.6-9 rtreset --wait=9 -v Slow0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Slow0.rtc: Inactive
  $ ctl @slow error Stuck0
  $ rtreset --wait 0.1 Stuck0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Stuck0.rtc: not Inactive within 0.1s, still Error
  [4]

-e, another execution context:

  $ ctl @contexts error Multi0
  $ rtreset -v -e 1 Multi0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Multi0.rtc: Inactive
  $ rtreset -v Multi0.rtc -e -2
  rtreset: /localhost:$PORT/test.host_cxt/Multi0.rtc: accepted
  $ rtreset -e 7 Multi0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Multi0.rtc: no such execution context: 7 (it has 3)
  [3]

Usage:

  $ rtreset
  rtreset: the following arguments are required: PATH (see --help)
  [2]
  $ rtreset --help -v | head -1
  usage: rtreset [-e N] [--wait [SECONDS]] [--all] [--dry-run] [-v] [-q]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A
invocation: --wait 0.5 A B
broken component: 5 6
