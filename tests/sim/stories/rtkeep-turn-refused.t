A component that was not tried ends; when it is back, it is left alone where its policy says so.

world: these ConsoleOut
world: these Sensor

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml Sensor0 ConsoleOut0
  $ kill these2
  $ rtkeep --restart no b.xml &
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it waits for /robot/test.host_cxt/Sensor0.rtc, which failed
  $ kill these
  $ sleep 3
  $ restart these2
  $ sleep 3
  $ show rtkeep
  [08:00:05] /robot/test.host_cxt/ConsoleOut0.rtc: its process is gone
  [08:00:09] /robot/test.host_cxt/Sensor0.rtc: Active
  $ restart these
  $ sleep 5
  $ show rtkeep
  [08:00:11] /robot/test.host_cxt/ConsoleOut0.rtc: is back; its policy is no
  $ ctl error Sensor0
  $ sleep 3
  $ show rtkeep
  [08:00:16] /robot/test.host_cxt/Sensor0.rtc: is in Error; its policy is no
  $ rtkeep status
  b.xml: pid 5, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  unknown  2027-01-15 08:00:11  restarts: 1  is back; its policy is no
    /robot/test.host_cxt/Sensor0.rtc      Active  Error    2027-01-15 08:00:16               is in Error; its policy is no
