What rtcomp refuses, and says; nothing has changed then.

world: composite --flavour cpp2
world: deadmember --flavour cpp2 --context dead.host_cxt/%n.rtc
world: manager ConsoleOut --flavour cpp2 --context m.host_cxt/%n.rtc
world: services --context other.host_cxt/%n.rtc
world: these Motor --flavour cpp2 --context twin.host_cxt/%n.rtc
world: zombie 1
world: deadmember --flavour py2 --context pydead.host_cxt/%n.rtc

Wrong usage:

  $ rtcomp
  rtcomp: the following arguments are required: MANAGER[:NAME] | COMPOSITE (see --help)
  [2]
  $ rtcomp a b
  rtcomp: unrecognized arguments: b (see --help)
  [2]
  $ rtcomp -c Sensor0.rtc manager.mgr
  rtcomp: -c is an option of old versions; now: -a PATH (see --help)
  [2]
  $ rtcomp --port=Sensor0.rtc:in manager.mgr
  rtcomp: --port is an option of old versions; now: -a PATH:PORT,… (see --help)
  [2]
  $ rtcomp manager.mgr -n Arm
  rtcomp: -n is an option of old versions; now: MANAGER:NAME (see --help)
  [2]
  $ rtcomp -a
  rtcomp: argument -a/--add: expected one argument (see --help)
  [2]
  $ rtcomp -a a.rtc:b:c composite0.rtc
  rtcomp: a.rtc:b:c: a single colon separates a component from its port; write \: in a name
  [2]
  $ rtcomp ../m.host_cxt/manager.mgr
  rtcomp: /localhost:$PORT/m.host_cxt/manager.mgr: nothing to do: name a composite (MANAGER:NAME), or its members (-a) (see --help)
  [2]
  $ rtcomp composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: nothing to do: name members to add (-a) or to remove (-r) (see --help)
  [2]
  $ rtcomp ../m.host_cxt/manager.mgr:'a&b=c'
  rtcomp: a composite cannot be called a&b=c (see --help)
  [2]
  $ rtcomp -o nonsense ../m.host_cxt/manager.mgr:New
  rtcomp: not KEY=VALUE&KEY=VALUE…: nonsense (see --help)
  [2]
  $ rtcomp -t 'A?b=c' ../m.host_cxt/manager.mgr:New
  rtcomp: not MODULE[?KEY=VALUE&KEY=VALUE…]: A?b=c?instance_name=New (see --help)
  [2]

What is no composite and no manager:

  $ rtcomp -a Sensor0.rtc Motor0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/Motor0.rtc: not a composite component (it is a component)
  [3]
  $ rtcomp -a Sensor0.rtc ../other.host_cxt
  rtcomp: /localhost:$PORT/other.host_cxt: not a component or manager (it is a directory)
  [3]
  $ rtcomp -a Sensor0.rtc composit0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composit0.rtc: no such path; did you mean composite0.rtc?
  [3]
  $ rtcomp -a Sensor0.rtc composite0.rtc:out
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc:out: not a component or manager (it is a port)
  [3]
  $ rtcomp -a Sensor0.rtc Mock0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/Mock0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtcomp ../m.host_cxt/manager.mgr:ConsoleOut0
  rtcomp: /localhost:$PORT/m.host_cxt/manager.mgr/ConsoleOut0.rtc: not a composite component (it is a component)
  [3]
  $ rtcomp -a Sensor0.rtc nowhere/composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/nowhere: no such path
  [3]

Members that are not there, are no components, lack the port, are dead:

  $ rtcomp -a Senso0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/Senso0.rtc: no such path; did you mean Sensor0.rtc?
  [3]
  $ rtcomp -a ../m.host_cxt/manager.mgr composite0.rtc
  rtcomp: /localhost:$PORT/m.host_cxt/manager.mgr: not a component (it is a manager)
  [3]
  $ rtcomp -a ../other.host_cxt composite0.rtc
  rtcomp: /localhost:$PORT/other.host_cxt: not a component (it is a directory)
  [3]
  $ rtcomp -a Sensor0.rtc:nothing composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/Sensor0.rtc: no such port: nothing
  [3]
  $ rtcomp -a Sensor0.rtc:in,nothing,out composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/Sensor0.rtc: no such port: nothing
  [3]
  $ rtcomp -a Mock0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/Mock0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtcomp -a composite0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: cannot be a member of itself
  [1]
  $ rtcomp -r ../other.host_cxt/MyServiceProvider0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: no such member: MyServiceProvider0
  [3]
  $ rtcomp -r nobody.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: no such member: nobody
  [3]
  $ rtcat composite0.rtc | tail -2
  +DataInPort: Sensor0.in
  +DataOutPort: Motor0.out

Members are known by their instance names; another one of the same name is not taken for it:

  $ rtcomp -a ../twin.host_cxt/Motor0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: has another member called Motor0
  [1]
  $ rtcomp -r ../twin.host_cxt/Motor0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: no such member: Motor0
  [3]

All is checked before the first change:

  $ rtcomp -a ../other.host_cxt/MyServiceConsumer0.rtc -r nobody.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: no such member: nobody
  [3]
  $ rtcat -l ../other.host_cxt/MyServiceConsumer0.rtc | grep -c Parent.composition
  0
  [1]

A new composite has nothing to be removed:

  $ rtcomp -r Motor0.rtc ../m.host_cxt/manager.mgr:New
  rtcomp: /localhost:$PORT/m.host_cxt/manager.mgr: cannot remove components or ports from a new composite
  [1]
  $ rtcomp -a ../m.host_cxt/ConsoleOut0.rtc -r Motor0.rtc:in ../m.host_cxt/manager.mgr:New
  rtcomp: /localhost:$PORT/m.host_cxt/manager.mgr: cannot remove components or ports from a new composite
  [1]
  $ rtls ../m.host_cxt
  ConsoleOut0.rtc
  manager.mgr/

A type that the manager does not know, a type that is no composite (what was made is deleted again):

  $ rtcomp -t Nonsense ../m.host_cxt/manager.mgr:New
  rtcomp: /localhost:$PORT/m.host_cxt/manager.mgr: does not create Nonsense?instance_name=New (no factory Nonsense; there are: ConsoleOut, Controller, Motor, PeriodicECSharedComposite, Sensor)
  [6]
  $ rtcomp -t ConsoleIn ../m.host_cxt/manager.mgr:New
  rtcomp: /localhost:$PORT/m.host_cxt/manager.mgr/New.rtc: not a composite component (it is a component)
  [3]
  $ rtls ../m.host_cxt | grep New
  [1]

Hiding what is not shown changes nothing:

  $ rtcomp -v -r Sensor0.rtc:out composite0.rtc
  rtcomp: port Sensor0.out is hidden already

A dead member cannot be removed: that would end the composite's process (C++), or the thread of its context (Python). The hint
does not advise it; its ports can be hidden, and then the composite's profile can be read again:

  $ rtls ../dead.host_cxt
  ConsoleIn0.rtc
  *Peer0.rtc
  composite0.rtc
  $ rtls -lv ../dead.host_cxt
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  -         -    -    -    -    *Peer0.rtc
  Inactive  ?    ?    ?    ?    composite0.rtc
  rtls: /localhost:$PORT/dead.host_cxt/composite0.rtc: the process of one of its ports is gone; if that is a member's, restart this composite's process (until then, rtcomp -r MEMBER:PORT hides the port)
  rtls: 1 of 3 did not report the ports (composite0.rtc)
  [5]
  $ rtcat -l ../dead.host_cxt/composite0.rtc | grep Member
  rtcat: /localhost:$PORT/dead.host_cxt/composite0.rtc: the process of one of its ports is gone; if that is a member's, restart this composite's process (until then, rtcomp -r MEMBER:PORT hides the port)
  [1]
  $ rtcat ../dead.host_cxt/composite0.rtc
  rtcat: /localhost:$PORT/dead.host_cxt/composite0.rtc: the process of one of its ports is gone; if that is a member's, restart this composite's process (until then, rtcomp -r MEMBER:PORT hides the port)
  [4]
  $ rtcomp -v -r ../dead.host_cxt/Peer0.rtc ../dead.host_cxt/composite0.rtc
  rtcomp: /localhost:$PORT/dead.host_cxt/composite0.rtc: cannot remove Peer0: letting go of a dead member would end this composite's process or stop its execution context; restart that process
  [1]
  $ rtcomp -v -r ../dead.host_cxt/Peer0.rtc:in ../dead.host_cxt/composite0.rtc
  rtcomp: hid port Peer0.in
  $ rtcat ../dead.host_cxt/composite0.rtc
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
  +DataOutPort: ConsoleIn0.out
  $ rtcat -l ../dead.host_cxt/composite0.rtc | grep Member
    Member  /localhost:$PORT/dead.host_cxt/ConsoleIn0.rtc
    Member  Unknown (it is gone)
  $ rtcomp -v -r ../dead.host_cxt/Peer0.rtc ../dead.host_cxt/composite0.rtc
  rtcomp: /localhost:$PORT/dead.host_cxt/composite0.rtc: cannot remove Peer0: letting go of a dead member would end this composite's process or stop its execution context; restart that process
  [1]
  $ rtcomp -r nobody.rtc ../dead.host_cxt/composite0.rtc
  rtcomp: /localhost:$PORT/dead.host_cxt/composite0.rtc: cannot remove nobody: letting go of a dead member would end this composite's process or stop its execution context; restart that process
  [1]

When it has been started again, it is another member of the same name; which of them would be removed is not known. What comes
before the dead one in the composite's list can be removed:

  $ rtcomp -v -a ../twin.host_cxt/Motor0.rtc ../dead.host_cxt/composite0.rtc
  rtcomp: added component /localhost:$PORT/twin.host_cxt/Motor0.rtc
  $ rtcomp -v -r ../twin.host_cxt/Motor0.rtc ../dead.host_cxt/composite0.rtc
  rtcomp: /localhost:$PORT/dead.host_cxt/composite0.rtc: cannot remove Motor0: letting go of a dead member would end this composite's process or stop its execution context; restart that process
  [1]
  $ rtcomp -v -r ../dead.host_cxt/ConsoleIn0.rtc ../dead.host_cxt/composite0.rtc
  rtcomp: hid port ConsoleIn0.out
  rtcomp: removed component ConsoleIn0
  $ rtls -l ../dead.host_cxt/composite0.rtc
  Inactive  0/0  0/0  0/0  0/0  composite0.rtc

It is the same in Python:

  $ rtact --wait ../pydead.host_cxt/composite0.rtc
  rtact: /localhost:$PORT/pydead.host_cxt/composite0.rtc: cannot activate: it went to Error
  [6]
  $ rtcomp -r ../pydead.host_cxt/Peer0.rtc ../pydead.host_cxt/composite0.rtc
  rtcomp: /localhost:$PORT/pydead.host_cxt/composite0.rtc: cannot remove Peer0: letting go of a dead member would end this composite's process or stop its execution context; restart that process
  [1]
  $ rtls -l ../pydead.host_cxt
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  -         -    -    -    -    *Peer0.rtc
  Error     ?    ?    ?    ?    composite0.rtc
  rtls: 1 of 3 did not report the ports (composite0.rtc)
  [5]

A composite that refuses or fails:

  $ ctl fail add_members 1 NO_PERMISSION; rtcomp -a ../other.host_cxt/MyServiceProvider0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: CORBA.NO_PERMISSION
  [6]
  $ rtcomp -a ../other.host_cxt/MyServiceProvider0.rtc composite0.rtc > nul
  $ ctl @services fail start 1 UNKNOWN
  $ rtcomp -r ../other.host_cxt/MyServiceProvider0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: has let MyServiceProvider0 go, and then failed (CORBA.UNKNOWN); whether that runs is not known
  [1]
  $ rtcat -l composite0.rtc | grep Provider
  [1]
  $ rtcomp -a ../other.host_cxt/MyServiceProvider0.rtc composite0.rtc > nul
  $ ctl fail remove_member 1 NO_PERMISSION; ctl @services fail get_sdo_id 4 NO_PERMISSION
  $ rtcomp -r ../other.host_cxt/MyServiceProvider0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: CORBA.NO_PERMISSION
  [6]
  $ rtcomp -r ../other.host_cxt/MyServiceProvider0.rtc composite0.rtc
  $ ctl fail remove_member 1 HANG; within 4-12 rtcomp --timeout 4 -r Motor0.rtc composite0.rtc
  rtcomp: hid port Motor0.out
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: no answer within 4s
  [5]
  $ ctl hang composite0 60
  $ within 4-12 rtcomp --timeout 4 -r Motor0.rtc composite0.rtc
  rtcomp: /localhost:$PORT/test.host_cxt/composite0.rtc: no answer within 4s
  [4]
  $ ctl hang composite0 0

Organization::get_owner is never called: C++ answers with the owner only once

  $ calls | grep get_owner
  [1]

Two new members of one name, which nobody could tell apart afterwards:

  $ rtcomp -a ../twin.host_cxt/Motor0.rtc -a Motor0.rtc ../m.host_cxt/manager.mgr:Pair
  rtcomp: /localhost:$PORT/test.host_cxt/Motor0.rtc: has the same name as /localhost:$PORT/twin.host_cxt/Motor0.rtc; a composite cannot have both
  [1]
