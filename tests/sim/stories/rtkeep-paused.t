`rtkeep status` knows what becomes of one that is paused, of which nothing is mended.

world: these ConsoleIn
world: these ConsoleOut

  $ rtcryo --all -o a.xml
  $ rtkeep --look 0.5 a.xml &
  $ sleep 5
  $ rtkeep pause ConsoleIn0
  $ rtdeact ConsoleIn0.rtc
  $ sleep 5
  $ rtkeep status
  a.xml: pid 5, since 2027-01-15 08:00:00; all is as the file says, but for what is left alone
    /robot/test.host_cxt/ConsoleIn0.rtc   paused  Inactive  2027-01-15 08:00:05    Active
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active    2027-01-15 08:00:00    Active
  $ rtact ConsoleIn0.rtc
  $ rtkeep stop ConsoleOut0
  $ sleep 5
  $ rtact ConsoleOut0.rtc
  $ sleep 5
  $ rtkeep status
  a.xml: pid 5, since 2027-01-15 08:00:00; all is as the file says, but for what is left alone
    /robot/test.host_cxt/ConsoleIn0.rtc   paused  Active  2027-01-15 08:00:10    Active
    /robot/test.host_cxt/ConsoleOut0.rtc  paused  Active  2027-01-15 08:00:15    deactivated on request
  $ restart these2
  $ ctl error ConsoleIn0
  $ sleep 5
  $ rtkeep status
  a.xml: pid 5, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   paused  Error     2027-01-15 08:00:20               Active
    /robot/test.host_cxt/ConsoleOut0.rtc  paused  Inactive  2027-01-15 08:00:20  restarts: 1  its process is gone
  $ rtkeep resume
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:10] /robot/test.host_cxt/ConsoleOut0.rtc: deactivated on request
  [08:00:20] /robot/test.host_cxt/ConsoleOut0.rtc: its process is gone
  [08:00:25] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:25] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:25] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  $ rtkeep status
  a.xml: pid 5, since 2027-01-15 08:00:00; all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Active  2027-01-15 08:00:25               Active
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active  2027-01-15 08:00:25  restarts: 1  Active
