One that comes after one that was not tried says so once.

world: these Sensor
world: these ConsoleOut
world: these ConsoleIn

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml Sensor0 ConsoleOut0 ConsoleIn0
  $ kill these
  $ rtkeep b.xml &
  $ sleep 5
  $ ctl @these3 error ConsoleIn0
  $ sleep 5
  $ ctl @these2 error ConsoleOut0
  $ sleep 5
  $ ctl @these3 error ConsoleIn0
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleOut0.rtc, which was not tried
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it waits for /robot/test.host_cxt/Sensor0.rtc, which failed
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleOut0.rtc, which failed
  [08:00:10] /robot/test.host_cxt/ConsoleOut0.rtc: in Error: reset
  [08:00:15] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
