One that was left alone, and resumed by a person, is kept after a reload, too.

world: these Sensor
world: these ConsoleOut

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml Sensor0 ConsoleOut0
  $ rtkeep --restart on-error b.xml &
  $ sleep 5
  $ rtexit --wait Sensor0.rtc
  [0] after 0.7 s
  $ mock these Sensor
  $ sleep 5
  $ rtkeep resume Sensor0
  $ sleep 5
  $ rtkeep reload
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:05] /robot/test.host_cxt/Sensor0.rtc: has exited
  [08:00:06] /robot/test.host_cxt/Sensor0.rtc: is back; its policy is on-error
  [08:00:10] /robot/test.host_cxt/Sensor0.rtc: Active
  $ rtkeep status
  b.xml: pid 5, since 2027-01-15 08:00:00; all is as the file says
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active  2027-01-15 08:00:00               Active
    /robot/test.host_cxt/Sensor0.rtc      Active  Active  2027-01-15 08:00:10  restarts: 1  Active
  $ ctl @these2 error ConsoleOut0
  $ sleep 10
  $ show rtkeep
  [08:00:20] /robot/test.host_cxt/ConsoleOut0.rtc: in Error: reset
  [08:00:20] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  $ rtkeep status
  b.xml: pid 5, since 2027-01-15 08:00:00; all is as the file says
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active  2027-01-15 08:00:20               Active
    /robot/test.host_cxt/Sensor0.rtc      Active  Active  2027-01-15 08:00:10  restarts: 1  Active
  $ ctl @these3 error Sensor0
  $ sleep 10
  $ show rtkeep
  [08:00:30] /robot/test.host_cxt/Sensor0.rtc: in Error: reset
  [08:00:30] /robot/test.host_cxt/Sensor0.rtc: Active
  $ rtkeep status
  b.xml: pid 5, since 2027-01-15 08:00:00; all is as the file says
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active  2027-01-15 08:00:20               Active
    /robot/test.host_cxt/Sensor0.rtc      Active  Active  2027-01-15 08:00:30  restarts: 1  Active
