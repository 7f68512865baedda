A member of a composite leaves it before it exits: a composite of C++ calls it in its next cycle to say that it has left, and its process
ends where the member is gone by then. So does that of any execution context that a component takes part in.

world: manager Sensor --flavour cpp2
world: two --flavour cpp2 --context other.host_cxt/%n.rtc
world: contexts --flavour cpp2 --rate 2 --context slow.host_cxt/%n.rtc

  $ rtcomp -o exec_cxt.periodic.rate=2 -a Sensor0.rtc -a ../other.host_cxt/ConsoleOut0.rtc \
  >     -a ../other.host_cxt/ConsoleIn0.rtc manager.mgr:Arm
  $ rtact --wait Arm.rtc
  $ within 0-9 rtexit -v --wait ../other.host_cxt/ConsoleOut0.rtc
  rtexit: /localhost:$PORT/other.host_cxt/ConsoleOut0.rtc: exited
  $ rtec Arm.rtc
  0  0  Periodic  2  Running  Active  Arm  Sensor0,ConsoleIn0
  $ rtact ../slow.host_cxt/Driver0.rtc
  $ within 0-9 rtexit -v --wait ../slow.host_cxt/Multi0.rtc
  rtexit: /localhost:$PORT/slow.host_cxt/Multi0.rtc: exited
  $ rtec ../slow.host_cxt/Driver0.rtc
  0  0  Periodic  2  Running  Active  Driver0  -

rtmgr -d does the same:

  $ rtmgr -v -d Sensor0 manager.mgr
  rtmgr: deleted Sensor0
  $ rtec Arm.rtc
  0  0  Periodic  2  Running  Active  Arm  ConsoleIn0
  $ rtec ../other.host_cxt/ConsoleIn0.rtc
  0  0     Periodic  1000  Stopped  Inactive  ConsoleIn0  -
  1  1000  Periodic  2     Running  Active    Arm         ConsoleIn0
