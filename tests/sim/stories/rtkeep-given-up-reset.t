One that was given up is tried again when a person resets it.

world: these ConsoleIn
world: these Err --flavour java

  $ rtcryo --all -o a.xml
  $ rtkeep --burst 1/60 --delay 0.5-1 --look 0.5 a.xml &
  $ sleep 5
  $ ctl error ConsoleIn0
  $ sleep 5
  $ ctl error ConsoleIn0
  $ sleep 5
  $ rtkeep status
  a.xml: pid 5, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc  Active  Error (given up)  2027-01-15 08:00:10    in Error; given up after more than 1 failure in 60s
    /robot/test.host_cxt/Err0.rtc        Active  Error (given up)  2027-01-15 08:00:00    cannot activate: it went to Error; given up after more than 1 failure in 60s
  $ rtreset ConsoleIn0.rtc
  $ sleep 5
  $ rtkeep status
  a.xml: pid 5, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc  Active  Active            2027-01-15 08:00:15    Active
    /robot/test.host_cxt/Err0.rtc        Active  Error (given up)  2027-01-15 08:00:00    cannot activate: it went to Error; given up after more than 1 failure in 60s
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Err0.rtc: cannot activate: it went to Error
  [08:00:00] /robot/test.host_cxt/Err0.rtc: in Error: reset
  [08:00:00] /robot/test.host_cxt/Err0.rtc: cannot activate: it went to Error; given up after more than 1 failure in 60s
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:10] /robot/test.host_cxt/ConsoleIn0.rtc: in Error; given up after more than 1 failure in 60s
  [08:00:15] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  $ rtreset Err0.rtc
  $ sleep 5
  $ show rtkeep
  [08:00:20] /robot/test.host_cxt/Err0.rtc: cannot activate: it went to Error
  [08:00:20] /robot/test.host_cxt/Err0.rtc: in Error: reset
  [08:00:20] /robot/test.host_cxt/Err0.rtc: cannot activate: it went to Error; given up after more than 1 failure in 60s
