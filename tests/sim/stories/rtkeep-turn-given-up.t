A component is deactivated as one before it is given up, and started with that again; it sends no reports.

world: these ConsoleIn
world: these ConsoleOut --flavour java

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml ConsoleIn0 ConsoleOut0
  $ rtkeep --burst 1/60 --delay 0.5-1 b.xml &
  $ sleep 5
  $ ctl error ConsoleIn0
  $ sleep 5
  $ ctl error ConsoleIn0
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:10] /robot/test.host_cxt/ConsoleIn0.rtc: in Error; given up after more than 1 failure in 60s
  [08:00:10] /robot/test.host_cxt/ConsoleOut0.rtc: /robot/test.host_cxt/ConsoleIn0.rtc is given up: deactivated
  [08:00:10] /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleIn0.rtc, which failed
  $ rtkeep status
  b.xml: pid 5, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Error (given up)  2027-01-15 08:00:10    in Error; given up after more than 1 failure in 60s
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Inactive          2027-01-15 08:00:10    not tried: it waits for /robot/test.host_cxt/ConsoleIn0.rtc, which failed
  $ rtcon -i x ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ sleep 20
  $ show rtkeep
  [08:00:16] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:16] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:16] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  $ rtkeep status
  b.xml: pid 5, since 2027-01-15 08:00:00; all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Active  2027-01-15 08:00:16    Active
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active  2027-01-15 08:00:16    Active
