A component ends, and is back, while those beside it are activated; its policy is to leave it alone then.

world: these Slow:A0
world: these ConsoleOut
world: these Slow:S0

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml S0 ConsoleOut0
  $ restart these
  $ restart these2
  $ sleep 0.2
  $ later 1.1 restart these2
  $ rtkeep --restart no b.xml &
  $ sleep 10
  $ show rtkeep
  [08:00:01] /robot/test.host_cxt/S0.rtc: Active
  [08:00:01] /robot/test.host_cxt/ConsoleOut0.rtc: its process is gone
  [08:00:01] /robot/test.host_cxt/A0.rtc: Active
  [08:00:01] /robot/test.host_cxt/ConsoleOut0.rtc: is back; its policy is no
  $ rtkeep status
  b.xml: pid 6, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/A0.rtc           Active  Active   2027-01-15 08:00:01               Active
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  unknown  2027-01-15 08:00:01  restarts: 1  is back; its policy is no
    /robot/test.host_cxt/S0.rtc           Active  Active   2027-01-15 08:00:01               Active
