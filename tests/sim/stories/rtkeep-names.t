rtkeep while its name server is gone, and back without a name: nothing changes for those that live.

world: these ConsoleIn:In0 ConsoleOut:Out0 ConfigSample:Set0 --flavour py2
world: these Motor --flavour cpp2

  $ rtcon -i straight In0.rtc:out Out0.rtc:in
  $ rtcryo --all -o robot.rtsys
  $ rtkeep --look 0.3 robot.rtsys &
  $ sleep 5
  $ no_names
  $ ctl error Set0
  $ ctl @these2 error Motor0
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/In0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Motor0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Out0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Set0.rtc: Active
  [08:00:05] /robot/test.host_cxt/Set0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/Set0.rtc: Active
  [08:00:05] /robot/test.host_cxt/Motor0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/Motor0.rtc: Active
  $ ctl @these state Set0
  ACTIVE

It is back without a name; a process that is started again binds its names, and its components are kept again:

  $ empty_names
  $ sleep 10
  $ show rtkeep
  $ restart these
  $ sleep 10
  $ show rtkeep
  [08:00:20] /robot/test.host_cxt/In0.rtc: its process is gone
  [08:00:20] /robot/test.host_cxt/Out0.rtc: its process is gone
  [08:00:20] /robot/test.host_cxt/Set0.rtc: its process is gone
  [08:00:21] /robot/test.host_cxt/In0.rtc: restored connection straight
  [08:00:21] /robot/test.host_cxt/In0.rtc: Active
  [08:00:21] /robot/test.host_cxt/Out0.rtc: Active
  [08:00:21] /robot/test.host_cxt/Set0.rtc: Active
  $ ctl @these state Set0
  ACTIVE
  $ ctl @these connectors In0:out
  straight outin
  $ strike TERM rtkeep
  $ wait rtkeep
  [0] after 30.0 s
