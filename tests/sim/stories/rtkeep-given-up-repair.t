That a repair is given up is reported, once; what is given up is tried again when it is resumed.

world: these ConsoleIn
world: these ConsoleOut

  $ rtcon -i x ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o a.xml
  $ rtkeep --burst 2/60 --look 0.5 a.xml &
  $ sleep 5
  $ ctl refuse ConsoleIn0:out RTC_ERROR
  $ ctl @these2 refuse ConsoleOut0:in RTC_ERROR
  $ rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ sleep 60
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: refused by the component (RTC_ERROR)
  [08:00:06] /robot/test.host_cxt/ConsoleIn0.rtc: refused by the component (RTC_ERROR); given up after more than 2 failures in 60s
  $ rtkeep status
  a.xml: pid 6, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Active (given up)  2027-01-15 08:00:00    refused by the component (RTC_ERROR); given up after more than 2 failures in 60s
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active             2027-01-15 08:00:00    Active
  $ rtkeep resume ConsoleIn0.rtc
  $ sleep 60
  $ show rtkeep
  [08:01:05] /robot/test.host_cxt/ConsoleIn0.rtc: refused by the component (RTC_ERROR)
  [08:01:05] /robot/test.host_cxt/ConsoleIn0.rtc: refused by the component (RTC_ERROR); given up after more than 2 failures in 60s
