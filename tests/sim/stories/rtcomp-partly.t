What rtcomp has done before it fails is said: status 5.

world: these ConsoleOut
world: manager Motor --flavour cpp2

  $ ctl @manager.1 fail add_members 1 TRANSIENT
  $ rtcomp -a Motor0.rtc:in manager.mgr:Arm
  ! rtcomp: created composite Arm
  ! rtcomp: exported port Motor0.in
  ! rtcomp: /robot/test.host_cxt/manager.mgr/Arm.rtc: cannot be reached now (CORBA.TRANSIENT)
  [5]
  $ rtcomp -a Motor0.rtc:in manager.mgr:Arm
  $ ctl @manager.1 fail get_components 4 TRANSIENT
  $ rtcomp -v -a ConsoleOut0.rtc:in manager.mgr:Leg
  ! rtcomp: created composite Leg
  ! rtcomp: /robot/test.host_cxt/manager.mgr: does not list Leg, which it has just created: whether it is there is not known
  [5]
