What a component comes after is absent when its turn comes, and Active before those beside it are.

world: these Slow:A0 ConsoleOut
world: these Sensor

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml Sensor0 ConsoleOut0
  $ restart these2
  $ sleep 0.2
  $ rtkeep b.xml &
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:01] /robot/test.host_cxt/A0.rtc: Active
  [08:00:02] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  $ rtcheck b.xml
