rtexit makes components exit. Their managers take the names out of the name server up to a second later.

world: two
world: these Mock:Last0
world: these Mock:Dead0
world: these Mock:Hung0
world: many 4

--dry-run prints commands that do it, and changes nothing:

  $ rtexit --dry-run ConsoleIn0.rtc ConsoleOut0.rtc
  rtexit /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  rtexit /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ ctl components
  ConsoleIn0
  ConsoleOut0

  $ rtexit ConsoleIn0.rtc
  $ ctl components
  ConsoleOut0
  $ rtls -l ConsoleOut0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc

--wait waits until the name is gone, too:

  $ rtexit -v --wait=60 ConsoleOut0.rtc
  rtexit: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: exited
  $ rtls ConsoleOut0.rtc
  rtls: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no such path
  [3]
  $ rtexit Mock1.rtc Mock2.rtc --wait=60 -v
  rtexit: /localhost:$PORT/test.host_cxt/Mock1.rtc: exited
  rtexit: /localhost:$PORT/test.host_cxt/Mock2.rtc: exited

What it costs:

  $ ctl @many reset
  $ rtexit Mock3.rtc
  $ calls @many
  1 _non_existent
  1 exit
  1 get_participating_contexts

What is not there:

  $ rtexit Nope0.rtc
  rtexit: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [3]

The last component of a process takes the process with it, and the answer may get lost. That is no failure:

  $ ctl @these fail exit 1 DIE; rtexit -v Last0.rtc
  rtexit: /localhost:$PORT/test.host_cxt/Last0.rtc: exited
  $ rtexit Last0.rtc
  rtexit: /localhost:$PORT/test.host_cxt/Last0.rtc: connection refused; its process is gone (zombie)
  [4]

Refused, dead, silent:

  $ mock console --context more.host_cxt/%n.rtc
  $ ctl @console fail exit 1 UNKNOWN; rtexit ../more.host_cxt/ConsoleIn0.rtc
  rtexit: /localhost:$PORT/more.host_cxt/ConsoleIn0.rtc: CORBA.UNKNOWN
  [6]
  $ ctl @console fail exit 1 COMM_FAILURE; rtexit ../more.host_cxt/ConsoleIn0.rtc
  rtexit: /localhost:$PORT/more.host_cxt/ConsoleIn0.rtc: connection lost
  [4]
  $ ctl @console components
  ConsoleIn0
  ConsoleOut0
  ConsoleOut1
  SequenceInComponent0
  SequenceOutComponent0
  $ kill-mock these2; hang these3
  $ rtexit Dead0.rtc
  rtexit: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ within 4-8 rtexit --timeout 4 Hung0.rtc
  rtexit: /localhost:$PORT/test.host_cxt/Hung0.rtc: no answer within 4s
  [4]
  $ rtexit --timeout 4 Dead0.rtc Hung0.rtc ../more.host_cxt/ConsoleOut1.rtc Nope0.rtc
  rtexit: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  rtexit: /localhost:$PORT/test.host_cxt/Hung0.rtc: no answer within 4s
  rtexit: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [5]
  $ interrupt 0.5 rtexit Hung0.rtc
  [130]

Not a component, and wrong usage:

  $ rtexit ../more.host_cxt/ConsoleIn0.rtc:out
  rtexit: /localhost:$PORT/more.host_cxt/ConsoleIn0.rtc:out: not a component (it is a port)
  [3]
  $ rtexit ../more.host_cxt
  rtexit: /localhost:$PORT/more.host_cxt: not a component (it is a directory)
  [3]
  $ rtexit /
  rtexit: /: not a component (it is a root directory)
  [3]
  $ rtexit
  rtexit: the following arguments are required: PATH (see --help)
  [2]
  $ rtexit ConsoleIn0.rtc:a:b ../more.host_cxt/ConsoleIn0.rtc
  rtexit: ConsoleIn0.rtc:a:b: a single colon separates a component from its port; write \: in a name
  [2]
  $ ctl @console components
  ConsoleIn0
  ConsoleOut0
  SequenceInComponent0
  SequenceOutComponent0

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A
invocation: --wait 0.5 A
fatal: components that others need may end
example: rtexit --wait Motor0.rtc Sensor0.rtc <- world
