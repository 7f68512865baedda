What is to start after another component waits until that one has had its turn, and is not called untried before.

world: these Sensor
world: these ConsoleOut

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml Sensor0 ConsoleOut0
  $ rtkeep b.xml &
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Sensor0.rtc: Active

Sensor0 is back after 0.5 s, and looked at soon after; ConsoleOut0, which is in Error, is looked at between the two.

  $ later 0.6 ctl @these2 error ConsoleOut0
  $ restart these
  $ sleep 5
  $ show rtkeep
  [08:00:05] /robot/test.host_cxt/Sensor0.rtc: its process is gone
  [08:00:05] /robot/test.host_cxt/ConsoleOut0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:06] /robot/test.host_cxt/ConsoleOut0.rtc: Active

Where Sensor0 is not there, its own line says why ConsoleOut0 has to wait:

  $ kill these
  $ sleep 5
  $ ctl @these2 error ConsoleOut0
  $ sleep 5
  $ show rtkeep
  [08:00:10] /robot/test.host_cxt/Sensor0.rtc: its process is gone
  [08:00:15] /robot/test.host_cxt/ConsoleOut0.rtc: in Error: reset
  [08:00:15] /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it waits for /robot/test.host_cxt/Sensor0.rtc, which failed
