One that is to be tried later is tried at once when a person resumes it, or when its process is another one.

world: these Sensor
world: these ConsoleOut

  $ rtcryo --all -o a.xml
  $ rtkeep --delay 20-100 a.xml &
  $ sleep 5
  $ ctl error Sensor0
  $ ctl @these2 error ConsoleOut0
  $ sleep 2
  $ ctl error Sensor0
  $ ctl @these2 error ConsoleOut0
  $ sleep 2
  $ rtkeep resume Sensor0
  $ restart these2
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:05] /robot/test.host_cxt/Sensor0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/ConsoleOut0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:05] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:09] /robot/test.host_cxt/ConsoleOut0.rtc: its process is gone
  [08:00:09] /robot/test.host_cxt/Sensor0.rtc: in Error: reset
  [08:00:09] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:09] /robot/test.host_cxt/ConsoleOut0.rtc: Active
