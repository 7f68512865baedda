What rtcat names as connected: the far ends of connections, wherever they are bound, without scanning the tree.

world: services
world: many 30 --context many.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut ConsoleOut:ConsoleOut1 --context away.host_cxt/arm.cxt/%n.rtc
world: these SequenceInComponent Motor Sensor
world: these ConsoleOut:Twice0 --context first.host_cxt/%n.rtc,many.host_cxt/%n.rtc

Service ports: interfaces, and which side provides them.

  $ rtcon MyServiceConsumer0.rtc:MyService MyServiceProvider0.rtc:MyService
  $ rtcat -l MyServiceConsumer0.rtc
  MyServiceConsumer0.rtc  Inactive
    Category       example
    Description    MyService Consumer Sample component
    Instance name  MyServiceConsumer0
    Type name      MyServiceConsumer
    Vendor         Shinji Kurihara
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
   +Extra properties
  -Execution Context 0
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  MyServiceConsumer0
   +Extra properties
  -CorbaPort: MyService
    port.port_type  CorbaPort
    Interface:
      Instance name  myservice0
      Type name      MyService
      Polarity       Required
   +Connected to  /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService
  $ rtcat -ll MyServiceProvider0.rtc:MyService | sed -n '/Interface/,/ID/p'
    Interface:
      Instance name  myservice0
      Type name      MyService
      Polarity       Provided
   -Connected to  /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService
      Name                                                             MyServiceMyService
      ID                                                               $UUID

Several connections of one port, to components elsewhere in the tree:

  $ far=../away.host_cxt/arm.cxt
  $ rtcon ../many.host_cxt/Mock0.rtc:out $far/ConsoleOut0.rtc:in
  $ rtcon ../many.host_cxt/Mock0.rtc:out $far/ConsoleOut1.rtc:in
  $ rtcon ../many.host_cxt/Mock0.rtc:out SequenceInComponent0.rtc:Long
  $ rtcat -l ../many.host_cxt/Mock0.rtc:out | grep -A 9 Connected
   +Connected to  /localhost:$PORT/away.host_cxt/arm.cxt/ConsoleOut0.rtc:in
   +Connected to  /localhost:$PORT/away.host_cxt/arm.cxt/ConsoleOut1.rtc:in
   +Connected to  /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Long
  $ rtcat --json ../many.host_cxt/Mock0.rtc:out | python3 -c 'import json, sys
  > for connector in json.load(sys.stdin)["connectors"]:
  >     print(*connector["connected_to"])'
  /localhost:$PORT/away.host_cxt/arm.cxt/ConsoleOut0.rtc:in
  /localhost:$PORT/away.host_cxt/arm.cxt/ConsoleOut1.rtc:in
  /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Long

Without -l nobody but the component is asked; with it, only the ports at the far ends are, once each. Nothing is
asked of the other 29. (A component that is asked for a port looks whether the ports connected to it still live:
those calls are not ours.)

  $ asked() {
  >     for world in many these these2; do
  >         calls @$world | grep -v _non_existent
  >         ctl @$world reset
  >     done
  > }

  $ ctl @services reset; asked >/dev/null
  $ rtcat ../many.host_cxt/Mock0.rtc >/dev/null; asked
  1 get_component_profile
  1 get_component_state
  1 get_context_handle
  1 get_organizations
  1 get_owned_contexts
  1 get_owned_organizations
  1 get_participating_contexts
  2 get_port_profile
  1 get_ports
  $ rtcat -ll ../many.host_cxt/Mock0.rtc >/dev/null; asked
  1 get_component_profile
  1 get_component_state
  1 get_context_handle
  1 get_organizations
  1 get_owned_contexts
  1 get_owned_organizations
  1 get_participating_contexts
  2 get_port_profile
  1 get_ports
  1 get_profile
  1 is_running
  2 get_port_profile
  1 get_port_profile
  $ rtcat -l ../many.host_cxt/Mock0.rtc:out | grep -c Connected; asked
  3
  2 get_port_profile
  1 get_ports
  2 get_port_profile
  1 get_port_profile
  $ rtcat ../many.host_cxt/Mock5.rtc:in ../many.host_cxt/Mock6.rtc:in; asked
  +DataInPort: in

  +DataInPort: in
  4 get_port_profile
  2 get_ports
  $ calls @services

Three ports in one connection, and a component connected to itself, of which its own port is no far end:

  $ rtcon Motor0.rtc:out Sensor0.rtc:in SequenceInComponent0.rtc:Long
  $ rtcat -l Motor0.rtc:out | grep -A 9 Connected
   +Connected to  /localhost:$PORT/test.host_cxt/Sensor0.rtc:in
                  /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Long
  $ rtcon Sensor0.rtc:out Motor0.rtc:in
  $ rtcat -l Sensor0.rtc Motor0.rtc:in | grep -e '^-' -e Connected
  -Execution Context 0
  -DataInPort: in
   +Connected to  /localhost:$PORT/test.host_cxt/Motor0.rtc:out
  -DataOutPort: out
   +Connected to  /localhost:$PORT/test.host_cxt/Motor0.rtc:in
  -DataInPort: in
   +Connected to  /localhost:$PORT/test.host_cxt/Sensor0.rtc:out

A component that is bound twice: the name beside the one that is connected with it.

  $ rtcon ../many.host_cxt/Mock1.rtc:out ../first.host_cxt/Twice0.rtc:in
  $ rtcat -l ../many.host_cxt/Mock1.rtc:out | grep Connected
   +Connected to  /localhost:$PORT/many.host_cxt/Twice0.rtc:in

What is connected is shown even if it does not say what it is, is bound nowhere, its process hangs, or has died:

  $ ctl @these3 fail get_port_profile 1 UNKNOWN; rtcat -l ../many.host_cxt/Mock1.rtc:out | grep Connected
   +Connected to  Unknown (127.0.0.1:*: CORBA.UNKNOWN) (glob)
  $ rtdel -f $far/ConsoleOut0.rtc
  $ rtcat -l ../many.host_cxt/Mock0.rtc:out | grep -A 9 Connected
   +Connected to  Unknown (ConsoleOut0.in)
   +Connected to  /localhost:$PORT/away.host_cxt/arm.cxt/ConsoleOut1.rtc:in
   +Connected to  /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Long
  $ hang these; within 4-8 rtcat -l --timeout 4 ../many.host_cxt/Mock0.rtc:out | grep -A 9 Connected
  rtcat: /localhost:$PORT/many.host_cxt/Mock0.rtc: no answer within 4s
  [1]
  $ wake these
  $ kill-mock these; rtcat -l ../many.host_cxt/Mock0.rtc:out | grep -A 9 Connected
   +Connected to  /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Long
  $ rtcat -ll ../many.host_cxt/Mock0.rtc:out | grep -c '^ *ID '
  1
