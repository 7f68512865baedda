One in Error that is to be tried later is not waited for, and is named.

world: these Sensor
world: these ConsoleOut

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml Sensor0 ConsoleOut0
  $ rtkeep --delay 20-100 b.xml &
  $ sleep 5
  $ ctl error Sensor0
  $ sleep 2
  $ ctl error Sensor0
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:05] /robot/test.host_cxt/Sensor0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/Sensor0.rtc: Active
  $ restart these2
  $ sleep 5
  $ show rtkeep
  [08:00:12] /robot/test.host_cxt/ConsoleOut0.rtc: its process is gone
  [08:00:12] /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it waits for /robot/test.host_cxt/Sensor0.rtc, which failed
  $ sleep 40
  $ show rtkeep
  [08:00:29] /robot/test.host_cxt/Sensor0.rtc: in Error: reset
  [08:00:29] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:29] /robot/test.host_cxt/ConsoleOut0.rtc: Active
