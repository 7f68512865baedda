As in rtkeep-turn-gone.t, and it is back before the others are Active.

world: these Slow:A0 Slow:A1 Slow:A2 Slow:A3 Slow:A4 Slow:A5 Slow:A6 Slow:A7 Slow:A8 Slow:A9
world: these ConsoleOut
world: these Slow:S0

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml S0 ConsoleOut0
  $ restart these
  $ restart these2
  $ sleep 0.2
  $ later 1.1 restart these2
  $ rtkeep --restart no b.xml &
  $ sleep 20
  $ show rtkeep
  [08:00:01] /robot/test.host_cxt/S0.rtc: Active
  [08:00:01] /robot/test.host_cxt/ConsoleOut0.rtc: its process is gone
  [08:00:01] /robot/test.host_cxt/ConsoleOut0.rtc: is back; its policy is no
  [08:00:03] /robot/test.host_cxt/A0.rtc: Active
  [08:00:03] /robot/test.host_cxt/A1.rtc: Active
  [08:00:03] /robot/test.host_cxt/A2.rtc: Active
  [08:00:03] /robot/test.host_cxt/A3.rtc: Active
  [08:00:03] /robot/test.host_cxt/A4.rtc: Active
  [08:00:03] /robot/test.host_cxt/A5.rtc: Active
  [08:00:03] /robot/test.host_cxt/A6.rtc: Active
  [08:00:03] /robot/test.host_cxt/A7.rtc: Active
  [08:00:03] /robot/test.host_cxt/A8.rtc: Active
  [08:00:03] /robot/test.host_cxt/A9.rtc: Active
  $ ctl @these2 state ConsoleOut0
  INACTIVE
