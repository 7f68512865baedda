rtcomp makes composite components and changes them: one execution context for several components, one face for their ports.

world: manager Sensor Controller Motor ConsoleOut --flavour cpp2
world: two --context other.host_cxt/%n.rtc --flavour cpp2

A new one is made on a manager, which has to be the one of the members if they are to share its process. -a adds a member,
with the ports that the composite is to show:

  $ rtcomp -v -a Sensor0.rtc:in -a Controller0.rtc -a Motor0.rtc:in,out manager.mgr:Arm
  rtcomp: created composite Arm
  rtcomp: exported port Sensor0.in
  rtcomp: exported port Motor0.in
  rtcomp: exported port Motor0.out
  rtcomp: added component /localhost:$PORT/test.host_cxt/Sensor0.rtc
  rtcomp: added component /localhost:$PORT/test.host_cxt/Controller0.rtc
  rtcomp: added component /localhost:$PORT/test.host_cxt/Motor0.rtc
  $ rtls -l
  Inactive  3/0  2/0  1/0  0/0  Arm.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  1/0  1/0  0/0  Controller0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
  Inactive  2/0  1/0  1/0  0/0  Sensor0.rtc
  -         -    -    -    -    manager.mgr
  $ rtcat Arm.rtc
  Arm.rtc  Inactive
    Category       composite.PeriodicECShared
    Description    PeriodicECSharedComposite
    Instance name  Arm
    Type name      PeriodicECSharedComposite
    Vendor         jp.go.aist
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Composite
   +Extra properties
  +Composition Arm
  +Execution Context 0
  +DataInPort: Sensor0.in
  +DataInPort: Motor0.in
  +DataOutPort: Motor0.out
  $ rtcat -l Arm.rtc | sed -n '/Composition/,/Participants/p'
  -Composition Arm
    ID      $UUID
    Member  /localhost:$PORT/test.host_cxt/Sensor0.rtc
    Member  /localhost:$PORT/test.host_cxt/Controller0.rtc
    Member  /localhost:$PORT/test.host_cxt/Motor0.rtc
  -Execution Context 0
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  Arm
   +Participants

Its ports keep the names that they have, with their component's before it; they are the same ports:

  $ rtcat -l Arm.rtc:Sensor0.in
  -DataInPort: Sensor0.in
    data_type                                IDL:RTC/TimedLong:1.0
    dataport.data_type                       IDL:RTC/TimedLong:1.0
    dataport.dataflow_type                   push,pull
    dataport.interface_option.corba_cdr\x20\x20\x20\x20\x20\x20 (esc)
    dataport.interface_option.data_service\x20\x20\x20 (esc)
    dataport.interface_option.direct\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    dataport.interface_option.shared_memory\x20\x20 (esc)
    dataport.interface_type                  corba_cdr,data_service,direct,shared_memory
    dataport.marshaling_types                cdr
    dataport.subscription_type               Any
    port.port_type                           DataInPort
  $ rtcon ../other.host_cxt/ConsoleIn0.rtc:out Arm.rtc:Sensor0.in
  $ rtcat -l Sensor0.rtc:in | tail -1
   +Connected to  /localhost:$PORT/other.host_cxt/ConsoleIn0.rtc:out
  $ rtdis Sensor0.rtc

The context of a member stops; it takes part in the composite's, and is activated there:

  $ rtec Motor0.rtc
  0  0     Periodic  1000  Stopped  Inactive  Motor0  -
  1  1000  Periodic  1000  Running  Inactive  Arm     Sensor0,Controller0,Motor0
  $ rtact --wait Arm.rtc; soon 'rtls -l Motor0.rtc | grep ^Active'
  $ rtls -l Arm.rtc Motor0.rtc
  Active  3/0  2/0  1/0  0/0  Arm.rtc
  Active  2/0  1/0  1/0  0/0  Motor0.rtc
  $ ctl slave 1 state Motor0 1000
  ACTIVE
  $ rtdeact --wait Arm.rtc

An existing one is changed at its own path, or as MANAGER:NAME. One more port of a member; a new member, from another
process; -v reports what was done, and what was already done:

  $ rtcomp -v -a Controller0.rtc:out Arm.rtc
  rtcomp: exported port Controller0.out
  rtcomp: component /localhost:$PORT/test.host_cxt/Controller0.rtc is a member already
  $ rtcomp -v -a Motor0.rtc:out -a ../other.host_cxt/ConsoleOut0.rtc:in manager.mgr:Arm
  rtcomp: exported port ConsoleOut0.in
  rtcomp: port Motor0.out is exported already
  rtcomp: added component /localhost:$PORT/other.host_cxt/ConsoleOut0.rtc
  rtcomp: component /localhost:$PORT/test.host_cxt/Motor0.rtc is a member already
  $ rtcat Arm.rtc | sed -n '/Execution/,$p'
  +Execution Context 0
  +DataInPort: Sensor0.in
  +DataOutPort: Controller0.out
  +DataInPort: Motor0.in
  +DataOutPort: Motor0.out
  +DataInPort: ConsoleOut0.in
  $ rtcat -l Arm.rtc | grep Member
    Member  /localhost:$PORT/test.host_cxt/Sensor0.rtc
    Member  /localhost:$PORT/test.host_cxt/Controller0.rtc
    Member  /localhost:$PORT/test.host_cxt/Motor0.rtc
    Member  /localhost:$PORT/other.host_cxt/ConsoleOut0.rtc
  $ rtcomp -v -a Motor0.rtc:out Arm.rtc
  rtcomp: port Motor0.out is exported already
  rtcomp: component /localhost:$PORT/test.host_cxt/Motor0.rtc is a member already

-r with ports hides them, without it removes the member, with the ports that are shown:

  $ rtcomp -v -r Motor0.rtc:in Arm.rtc
  rtcomp: hid port Motor0.in
  $ rtcomp -v -r Motor0.rtc -r Controller0.rtc:out Arm.rtc
  rtcomp: hid port Motor0.out
  rtcomp: hid port Controller0.out
  rtcomp: removed component Motor0
  $ rtcat Arm.rtc | sed -n '/Execution/,$p'
  +Execution Context 0
  +DataInPort: Sensor0.in
  +DataInPort: ConsoleOut0.in
  $ rtcat -l Arm.rtc | grep Member
    Member  /localhost:$PORT/test.host_cxt/Sensor0.rtc
    Member  /localhost:$PORT/test.host_cxt/Controller0.rtc
    Member  /localhost:$PORT/other.host_cxt/ConsoleOut0.rtc
  $ soon '! rtec Motor0.rtc | grep Arm'; rtec Motor0.rtc
  0  0  Periodic  1000  Running  Inactive  Motor0  -
  $ rtcomp -v -r Motor0.rtc:in Arm.rtc
  rtcomp: port Motor0.in is hidden already

Adding and removing at once:

  $ rtcomp -v -a Motor0.rtc -r ../other.host_cxt/ConsoleOut0.rtc Arm.rtc
  rtcomp: added component /localhost:$PORT/test.host_cxt/Motor0.rtc
  rtcomp: hid port ConsoleOut0.in
  rtcomp: removed component ConsoleOut0

Without a name it is CompositeRTC; -o gives more options to its creation, -t another type of composite; nothing need be added:

  $ rtcomp -v -o 'exec_cxt.periodic.rate=5&naming.formats=lab.host_cxt/%n.rtc' manager.mgr
  rtcomp: created composite CompositeRTC
  $ rtec ../lab.host_cxt/CompositeRTC.rtc
  0  0  Periodic  5  Running  Inactive  CompositeRTC  -
  $ rtcomp -v -a ConsoleOut0.rtc manager.mgr
  rtcomp: added component /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ rtcat -l ../lab.host_cxt/CompositeRTC.rtc | grep Member
    Member  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ rtcomp --type=PeriodicECSharedComposite --add ../other.host_cxt/ConsoleIn0.rtc:out \
  >     --options=conf.default.my=1 manager.mgr:More
  $ rtcat More.rtc | tail -1
  +DataOutPort: ConsoleIn0.out

--dry-run checks, and prints what would be done:

  $ rtcomp --dry-run -t Other -o a=b -a ConsoleOut0.rtc:in -a 'Motor0.rtc' manager.mgr:New
  rtcomp -t Other -o a=b -a /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in -a /localhost:$PORT/test.host_cxt/Motor0.rtc /localhost:$PORT/test.host_cxt/manager.mgr:New
  $ rtcomp --dry-run -o a=b -r Motor0.rtc:in Arm.rtc
  rtcomp -o a=b -r /localhost:$PORT/test.host_cxt/Motor0.rtc:in /localhost:$PORT/test.host_cxt/Arm.rtc
  $ rtcomp --dry-run manager.mgr
  rtcomp /localhost:$PORT/test.host_cxt/manager.mgr
  $ rtcomp --dry-run -a ConsoleOut0.rtc:none manager.mgr:New
  rtcomp: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no such port: none
  [3]
  $ rtls | grep -c New
  0
  [1]

Paths with a server, a port of its own, and ports of a component:

  $ RTCSH_CWD=/ rtcomp -v -a localhost:$PORT/other.host_cxt/ConsoleOut0.rtc:in \
  >     /localhost:$PORT/test.host_cxt/manager.mgr:Full
  rtcomp: created composite Full
  rtcomp: exported port ConsoleOut0.in
  rtcomp: added component /localhost:$PORT/other.host_cxt/ConsoleOut0.rtc
  $ RTCSH_CWD=/ rtcomp -v -r localhost:$PORT/other.host_cxt/ConsoleOut0.rtc:in \
  >     /localhost:$PORT/test.host_cxt/Full.rtc
  rtcomp: hid port ConsoleOut0.in
  $ RTCSH_CWD=/ rtcomp -v -r localhost:$PORT/other.host_cxt/ConsoleOut0.rtc \
  >     /localhost:$PORT/test.host_cxt/Full.rtc
  rtcomp: removed component ConsoleOut0

Below the manager, members and composites are the same:

  $ rtcomp -v -a manager.mgr/ConsoleOut0.rtc:in manager.mgr/Arm.rtc
  rtcomp: exported port ConsoleOut0.in
  rtcomp: added component /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleOut0.rtc
  $ rtcomp -v -r manager.mgr/ConsoleOut0.rtc manager.mgr/Arm.rtc
  rtcomp: hid port ConsoleOut0.in
  rtcomp: removed component ConsoleOut0

One component given several times is one member, with all the ports:

  $ rtcomp -v -a manager.mgr/ConsoleOut0.rtc -a manager.mgr/ConsoleOut0.rtc:in,in \
  >     -a manager.mgr/ConsoleOut0.rtc:in manager.mgr/Arm.rtc
  rtcomp: exported port ConsoleOut0.in
  rtcomp: added component /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleOut0.rtc
  $ rtcomp -v -r manager.mgr/ConsoleOut0.rtc -r manager.mgr/ConsoleOut0.rtc manager.mgr/Arm.rtc
  rtcomp: hid port ConsoleOut0.in
  rtcomp: removed component ConsoleOut0

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -a B A
invocation: -a B:in MGR:Arm
invocation: -r B A
broken component: 3
fatal: components that others need may end
