rtcat of composites and of their members, which know each other.

world: composite --flavour cpp2
world: deadmember --flavour cpp2 --context dead.host_cxt/%n.rtc
world: composite --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: composite --flavour py2 --context py2.host_cxt/%n.rtc

  $ rtcat composite0.rtc
  composite0.rtc  Inactive
    Category       composite.PeriodicECShared
    Description    PeriodicECSharedComposite
    Instance name  composite0
    Type name      PeriodicECSharedComposite
    Vendor         jp.go.aist
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Composite
   +Extra properties
  +Composition composite0
  +Execution Context 0
  +DataInPort: Sensor0.in
  +DataOutPort: Motor0.out
  $ rtcat Motor0.rtc
  Motor0.rtc  Inactive
    Category       example
    Description    Motor component
    Instance name  Motor0
    Type name      Motor
    Vendor         AIST
    Version        2.0.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic composite member
   +Extra properties
  +Parent composition composite0
  +Execution Context 0  Inactive
  +Execution Context 1000 of composite0  Inactive
  +DataInPort: in
  +DataOutPort: out
  $ rtcat -l composite0.rtc | sed '/^-Data/,$d'
  composite0.rtc  Inactive
    Category       composite.PeriodicECShared
    Description    PeriodicECSharedComposite
    Instance name  composite0
    Type name      PeriodicECSharedComposite
    Vendor         jp.go.aist
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Composite
   +Extra properties
  -Composition composite0
    ID      $UUID
    Member  /localhost:$PORT/test.host_cxt/Sensor0.rtc
    Member  /localhost:$PORT/test.host_cxt/Controller0.rtc
    Member  /localhost:$PORT/test.host_cxt/Motor0.rtc
  -Execution Context 0
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  composite0
   +Participants
   +Extra properties
  $ rtcat -l Motor0.rtc | sed '/^-Data/,$d'
  Motor0.rtc  Inactive
    Category       example
    Description    Motor component
    Instance name  Motor0
    Type name      Motor
    Vendor         AIST
    Version        2.0.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic composite member
   +Extra properties
  -Parent composition composite0
    ID    $UUID
    Path  /localhost:$PORT/test.host_cxt/composite0.rtc
  -Execution Context 0  Inactive
    State  Stopped
    Kind   Periodic
    Rate   1000.0
    Owner  Motor0
   +Extra properties
  -Execution Context 1000 of composite0  Inactive
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  composite0
   +Participants
   +Extra properties
  $ rtcat -ll composite0.rtc | sed -n '/Composition/,/Extra/p'
   -Composition composite0
      ID      $UUID
      Member  /localhost:$PORT/test.host_cxt/Sensor0.rtc
      Member  /localhost:$PORT/test.host_cxt/Controller0.rtc
      Member  /localhost:$PORT/test.host_cxt/Motor0.rtc
   -Execution Context 0
      State  Running
      Kind   Periodic
      Rate   1000.0
      Owner  composite0
     -Participants
        Sensor0
        Controller0
        Motor0
     -Extra properties
  $ rtcat -ll Motor0.rtc | sed -n '/composition/,/Extra/p'
   -Parent composition composite0
      ID    $UUID
      Path  /localhost:$PORT/test.host_cxt/composite0.rtc
   -Execution Context 0  Inactive
      State  Stopped
      Kind   Periodic
      Rate   1000.0
      Owner  Motor0
     -Extra properties

An exported port is one of the composite's, with its member's name before it; and one of the member's:

  $ rtcat composite0.rtc:Sensor0.in Sensor0.rtc:in
  +DataInPort: Sensor0.in

  +DataInPort: in
  $ rtcomp -a Motor0.rtc:in composite0.rtc
  $ rtcat composite0.rtc:in
  rtcat: /localhost:$PORT/test.host_cxt/composite0.rtc: no such port: in (its ports: Sensor0.in, Motor0.in, Motor0.out)
  [3]
  $ rtcat composite0.rtc:Sensor0.out
  rtcat: /localhost:$PORT/test.host_cxt/composite0.rtc: no such port: Sensor0.out (its ports: Sensor0.in, Motor0.in, Motor0.out)
  [3]

--json:

  $ show() { python3 -c 'import json, sys
  > found = json.load(sys.stdin)
  > print(found["composite"], found["composite_member"])
  > for each in found["compositions"]: print(sorted(each), each["members"])
  > for each in found["parent_compositions"]: print(sorted(each), each["name"], each["path"])
  > for each in found["execution_contexts"]: print(each["handle"], each["owner"], each["participants"], \
  >     each["running"])
  > print([port["name"] for port in found["ports"]])'; }
  $ rtcat --json composite0.rtc | show
  True False
  ['id', 'members'] ['/localhost:$PORT/test.host_cxt/Sensor0.rtc', '/localhost:$PORT/test.host_cxt/Controller0.rtc', '/localhost:$PORT/test.host_cxt/Motor0.rtc']
  0 composite0 ['Sensor0', 'Controller0', 'Motor0'] True
  ['Sensor0.in', 'Motor0.in', 'Motor0.out']
  $ rtcat --json Motor0.rtc | show
  False True
  ['id', 'name', 'path'] composite0 /localhost:$PORT/test.host_cxt/composite0.rtc
  0 Motor0 [] False
  1000 composite0 ['Sensor0', 'Controller0', 'Motor0'] True
  ['Motor0.in', 'Motor0.out']

Members are found wherever they are bound; a composite of components of other processes:

  $ rtcomp -a ../dead.host_cxt/ConsoleIn0.rtc -r Motor0.rtc composite0.rtc
  $ rtcat -l composite0.rtc | grep Member
    Member  /localhost:$PORT/test.host_cxt/Sensor0.rtc
    Member  /localhost:$PORT/test.host_cxt/Controller0.rtc
    Member  /localhost:$PORT/dead.host_cxt/ConsoleIn0.rtc
  $ rtcat -l ../dead.host_cxt/ConsoleIn0.rtc | grep -A2 Parent.comp
  -Parent composition composite0
    ID    $UUID
    Path  /localhost:$PORT/dead.host_cxt/composite0.rtc
  -Parent composition composite0
    ID    $UUID
    Path  /localhost:$PORT/test.host_cxt/composite0.rtc

A composite with a dead member, whose name it does not know any more:

  $ rtcomp -r ../dead.host_cxt/Peer0.rtc:in ../dead.host_cxt/composite0.rtc
  $ rtcat ../dead.host_cxt/composite0.rtc | sed -n '/Composition/,$p'
  +Composition composite0
  +Execution Context 0
  +DataOutPort: ConsoleIn0.out
  $ rtcat -l ../dead.host_cxt/composite0.rtc | sed -n '/Composition/,/Execution/p'
  -Composition composite0
    ID      $UUID
    Member  /localhost:$PORT/dead.host_cxt/ConsoleIn0.rtc
    Member  Unknown (it is gone)
  -Execution Context 0
  $ rtcat -l ../dead.host_cxt/ConsoleIn0.rtc | grep -A2 Parent.comp
  -Parent composition composite0
    ID    $UUID
    Path  /localhost:$PORT/dead.host_cxt/composite0.rtc
  -Parent composition composite0
    ID    $UUID
    Path  /localhost:$PORT/test.host_cxt/composite0.rtc

Other versions:

  $ rtcat -l ../cpp11.host_cxt/composite0.rtc | sed -n '/Composition/,/Owner/p'
  -Composition composite0
    ID      $UUID
    Member  /localhost:$PORT/cpp11.host_cxt/Sensor0.rtc
    Member  /localhost:$PORT/cpp11.host_cxt/Controller0.rtc
    Member  /localhost:$PORT/cpp11.host_cxt/Motor0.rtc
  -Execution Context 0
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  composite0
  $ rtcat -l ../cpp11.host_cxt/Motor0.rtc | grep -A2 Parent.comp
  -Parent composition composite0
    ID    $UUID
    Path  /localhost:$PORT/cpp11.host_cxt/composite0.rtc
  $ rtcat -l ../py2.host_cxt/composite0.rtc | sed -n '/Composition/,/Owner/p'
  -Composition composite0
    ID      $UUID
    Member  /localhost:$PORT/py2.host_cxt/Sensor0.rtc
    Member  /localhost:$PORT/py2.host_cxt/Controller0.rtc
    Member  /localhost:$PORT/py2.host_cxt/Motor0.rtc
  -Execution Context 0
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  composite0
  $ rtcat -l ../py2.host_cxt/Motor0.rtc | grep -A2 Parent.comp
  -Parent composition composite0
    ID    $UUID
    Path  /localhost:$PORT/py2.host_cxt/composite0.rtc

Organization::get_owner is never called: C++ answers it once in its life. How often a composite and its member are asked:

  $ for world in composite deadmember composite2 composite3; do calls @$world | grep owner; done
  [1]
  $ ctl reset
  $ rtcat composite0.rtc >/dev/null
  $ calls
  1 get_component_profile
  1 get_component_state
  1 get_context_handle
  1 get_organizations
  1 get_owned_contexts
  1 get_owned_organizations
  1 get_participating_contexts
  1 get_port_profile
  1 get_ports
  $ ctl reset
  $ rtcat Sensor0.rtc >/dev/null
  $ calls
  1 get_component_profile
  2 get_component_state
  2 get_context_handle
  2 get_organization_id
  1 get_organizations
  1 get_owned_contexts
  2 get_owned_organizations
  1 get_participating_contexts
  2 get_port_profile
  1 get_ports
  1 get_profile
  2 get_sdo_id
  1 is_running
