What is gone, and is not to be restarted, is not created.

world: manager

  $ rtmgr -c ConsoleIn manager.mgr
  $ rtcryo -q --all -o a.xml
  $ rtkeep --create --restart no --manager manager.mgr a.xml &
  $ sleep 5
  $ rtexit --wait ConsoleIn0.rtc
  [0] after 0.7 s
  $ sleep 20
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleIn1.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: has exited
  $ rtkeep status
  a.xml: pid 6, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  absent  2027-01-15 08:00:05    has exited
    /robot/test.host_cxt/ConsoleIn1.rtc   Active  Active  2027-01-15 08:00:00    Active
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active  2027-01-15 08:00:00    Active
