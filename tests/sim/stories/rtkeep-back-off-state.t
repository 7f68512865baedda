A connection is made again while one of its components waits to be reset.

world: these ConsoleIn
world: these ConsoleOut

  $ rtcon -i x ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o a.xml
  $ rtkeep --delay 60-100 --look 0.5 a.xml &
  $ sleep 5
  $ ctl error ConsoleIn0
  $ sleep 5
  $ ctl error ConsoleIn0
  $ sleep 5
  $ rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:15] /robot/test.host_cxt/ConsoleIn0.rtc: restored connection x
  $ rtreset ConsoleIn0.rtc
  $ sleep 5
  $ rtkeep status
  a.xml: pid 6, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Inactive  2027-01-15 08:00:20    restored connection x
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active    2027-01-15 08:00:00    Active
  $ sleep 100
  $ show rtkeep
  [08:01:19] /robot/test.host_cxt/ConsoleIn0.rtc: Active
