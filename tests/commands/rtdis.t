rtdis removes connections.

world: these ConsoleIn ConsoleOut ConsoleOut:ConsoleOut1 ConsoleOut:ConsoleOut2 Motor Mock

  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ ctl connectors ConsoleIn0:out; ctl connectors ConsoleOut0:in

It is silent; --verbose reports which:

  $ rtcon -i first ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtdis -v ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: removed connection first

The order of the ports does not matter, options may follow them:

  $ rtcon -i first ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtdis ConsoleOut0.rtc:in ConsoleIn0.rtc:out -v
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: removed connection first

With several ports, what joins the first with any of the others goes, and nothing else:

  $ three() {
  >   for n in 0 1 2; do rtcon -i to-$n ConsoleIn0.rtc:out ConsoleOut$n.rtc:in; done
  >   rtcon -i motor Motor0.rtc:out ConsoleOut0.rtc:in
  > }
  $ three
  $ rtdis -v ConsoleIn0.rtc:out ConsoleOut0.rtc:in ConsoleOut2.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: removed connection to-0
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: removed connection to-2
  $ ctl connectors ConsoleIn0:out; ctl connectors Motor0:out
  to-1 outin
  motor outin

The first one named again is not connected with itself, and keeps its connections:

  $ rtdis ConsoleIn0.rtc:out ConsoleIn0.rtc:out
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not connected
  [1]
  $ rtdis -v --ensure ConsoleIn0.rtc:out ConsoleOut2.rtc:in ConsoleIn0.rtc:out
  $ ctl connectors ConsoleIn0:out
  to-1 outin

One port: all its connections:

  $ rtdis ConsoleOut0.rtc:in; rtdis ConsoleIn0.rtc:out
  $ three
  $ rtdis ConsoleIn0.rtc:out
  $ ctl connectors ConsoleIn0:out
  $ ctl connectors Motor0:out
  motor outin
  $ ctl connectors ConsoleOut0:in
  motor outin

A component: all connections of all its ports; one of two of its own ports is reported once:

  $ rtcon -i own Motor0.rtc:out Mock0.rtc:in; rtcon -i loop Mock0.rtc:out Mock0.rtc:in
  $ rtdis -v Mock0.rtc
  rtdis: /localhost:$PORT/test.host_cxt/Mock0.rtc:in: removed connection own
  rtdis: /localhost:$PORT/test.host_cxt/Mock0.rtc:in: removed connection loop
  $ ctl connectors Motor0:out
  motor outin

--id, only that one; it may be any of the ports, or the component:

  $ three
  rtcon: /localhost:$PORT/test.host_cxt/Motor0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: already connected (id motor)
  [6]
  $ rtdis -v -i to-1 ConsoleIn0.rtc:out
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: removed connection to-1
  $ rtdis -v ConsoleIn0.rtc --id=to-0
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: removed connection to-0
  $ rtdis -v --id to-2 ConsoleIn0.rtc:out ConsoleOut2.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: removed connection to-2
  $ ctl connectors ConsoleIn0:out

Ids that are odd; an id is text:

  $ rtcon -i '日本 "$(id)"' ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtdis --dry-run ConsoleIn0.rtc:out
  rtdis -i '日本 "$(id)"' /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  $ rtdis --dry-run ConsoleIn0.rtc:out | sh
  $ ctl connectors ConsoleIn0:out

Nothing to remove is fine for a component or a port, but not for what was named:

  $ rtdis ConsoleIn0.rtc
  $ rtdis ConsoleIn0.rtc:out
  $ rtdis ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: not connected
  [1]
  $ rtdis -i nope ConsoleIn0.rtc:out
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: no such connection with id: nope
  [3]
  $ rtdis -i nope ConsoleIn0.rtc
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such connection with id: nope
  [3]
  $ rtcon -i to-0 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtdis -i to-0 ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: not connected
  [1]
  $ rtdis -i motor ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: no such connection with id: motor
  [3]
  $ ctl connectors ConsoleIn0:out
  to-0 outin

--dry-run prints commands that do it, and changes nothing:

  $ rtdis --dry-run ConsoleOut0.rtc
  rtdis -i motor /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  rtdis -i to-0 /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ ctl connectors ConsoleIn0:out; ctl connectors ConsoleOut0:in
  to-0 outin
  motor outin
  to-0 outin
  $ rtdis --dry-run --force -i motor ConsoleOut0.rtc
  rtdis --force -i motor /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ rtdis --dry-run ConsoleOut0.rtc | sh
  $ ctl connectors ConsoleIn0:out; ctl connectors ConsoleOut0:in

What it costs: of each component the list of its ports, each port's profile, and the request.

  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in; ctl reset
  $ rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ ctl calls ConsoleIn0
  1 disconnect
  1 get_port_profile
  1 get_ports

Wrong usage:

  $ rtdis
  rtdis: the following arguments are required: PATH[:PORT] (see --help)
  [2]
  $ rtdis ConsoleIn0.rtc ConsoleOut0.rtc
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no port specified (see --help)
  [2]
  $ rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no port specified (see --help)
  [2]
  $ rtdis ConsoleIn0.rtc:out -i
  rtdis: argument -i/--id: expected one argument (see --help)
  [2]

No such thing, or not that kind of thing:

  $ rtdis ConsoleIn0.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such port: in (its ports: out)
  [3]
  $ rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:out ConsoleOut9.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no such port: out (its ports: in)
  [3]
  $ rtdis Konsole.rtc
  rtdis: /localhost:$PORT/test.host_cxt/Konsole.rtc: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ rtdis .
  rtdis: /localhost:$PORT/test.host_cxt: not a component (it is a directory)
  [3]
  $ rtdis ..
  rtdis: /localhost:$PORT: not a component (it is a name server)
  [3]
  $ rtdis ConsoleIn0.rtc/
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtdis ConsoleIn0.rtc:out ConsoleIn0.rtc:out
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not connected
  [1]

With --ensure, a connection that is not there is no failure; a port that is not there is one:

  $ rtdis --ensure ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtdis --ensure ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtdis --ensure -i nosuch ConsoleIn0.rtc:out
  $ rtdis --ensure ConsoleIn0.rtc:nosuch
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such port: nosuch (its ports: out)
  [3]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A:out B:in
invocation: A
invocation: -i id A
prepared: rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
example: rtdis -i 68f0a2bc-e582-11f1-9d6a-e5443183122b ConsoleIn0.rtc:out <- rtcon -i 68f0a2bc-e582-11f1-9d6a-e5443183122b ConsoleIn0.rtc:out ConsoleOut0.rtc:in
