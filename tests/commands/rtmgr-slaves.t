rtmgr and the slaves of a master of C++ 2.1: a typo leaves none behind, and none aborts because of a composite.

world: managers --flavour cpp2

A master starts a new slave for a name that no factory has; what remains empty is ended again. One that is used stays.

  $ slaves() { rtls manager.mgr | grep / | sed 's/manager_[0-9]*/manager_N/'; }
  $ rtmgr -c Typo manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: does not create Typo (no factory Typo; there are: ConsoleIn, ConsoleOut, Controller, Motor, PeriodicECSharedComposite, Sensor)
  [6]
  $ rtmgr -c Typo manager.mgr > nul 2>&1; slaves
  manager_N/
  manager_N/
  $ rtmgr -c 'Motor?manager_name=fresh' manager.mgr
  $ rtmgr -c 'Typo?manager_name=fresh' manager.mgr > nul 2>&1
  [6]
  $ slaves
  fresh/
  manager_N/
  manager_N/

A slave that ends with a composite aborts, and leaves names behind: composites are deleted first.

  $ rtcomp -v -a ConsoleIn0.rtc:out manager.mgr/fresh:Arm
  rtcomp: created composite Arm
  rtcomp: exported port ConsoleIn0.out
  rtcomp: added component /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ rtmgr -v --shutdown manager.mgr 2>&1 | sed 's/manager_[0-9]*/manager_N/'; rtls
  rtmgr: shut down /localhost:$PORT/test.host_cxt/manager.mgr/manager_N
  rtmgr: shut down /localhost:$PORT/test.host_cxt/manager.mgr/manager_N
  rtmgr: shut down /localhost:$PORT/test.host_cxt/manager.mgr/fresh
  rtmgr: shut down /localhost:$PORT/test.host_cxt/manager.mgr
