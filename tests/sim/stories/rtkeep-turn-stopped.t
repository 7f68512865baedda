What a person stops, or pauses, while others are activated does not become Active after that.

world: these Slow ConsoleOut ConsoleIn
world: these Motor

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml Slow0 ConsoleOut0 Motor0
  $ rtkeep b.xml &
  $ sleep 0.4
  $ rtkeep stop ConsoleOut0
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: deactivated on request
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it is paused
  [08:00:00] /robot/test.host_cxt/Motor0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleOut0.rtc, which was not tried
  [08:00:00] /robot/test.host_cxt/Slow0.rtc: Active
  [08:00:01] /robot/test.host_cxt/Motor0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleOut0.rtc, which failed
  $ rtkeep status
  b.xml: pid 5, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Active    2027-01-15 08:00:00    Active
    /robot/test.host_cxt/ConsoleOut0.rtc  paused  Inactive  2027-01-15 08:00:00    not tried: it is paused
    /robot/test.host_cxt/Motor0.rtc       Active  Inactive  2027-01-15 08:00:00    not tried: it waits for /robot/test.host_cxt/ConsoleOut0.rtc, which failed
    /robot/test.host_cxt/Slow0.rtc        Active  Active    2027-01-15 08:00:00    Active
  $ rtkeep resume ConsoleOut0
  $ sleep 5
  $ show rtkeep
  [08:00:05] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:05] /robot/test.host_cxt/Motor0.rtc: Active

Nor does one that is stopped as it becomes Active stay so:

  $ rtkeep stop Slow0
  $ sleep 5
  $ rtkeep resume Slow0
  $ sleep 0.4
  $ rtkeep stop Slow0
  $ sleep 5
  $ show rtkeep
  [08:00:11] /robot/test.host_cxt/Slow0.rtc: deactivated on request
  [08:00:15] /robot/test.host_cxt/Slow0.rtc: deactivated on request
  [08:00:16] /robot/test.host_cxt/Slow0.rtc: Active
  [08:00:17] /robot/test.host_cxt/Slow0.rtc: deactivated on request
  $ rtls -l Slow0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
