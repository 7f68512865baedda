Where something of a component is tried again later, the rest of it does not wait for that: an Error is reset while a connection is
refused.

world: these ConsoleIn
world: these ConsoleOut

  $ rtcon -i x ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o a.xml
  $ rtkeep --delay 20-100 --look 0.5 a.xml &
  $ sleep 5
  $ ctl refuse ConsoleIn0:out RTC_ERROR
  $ ctl @these2 refuse ConsoleOut0:in RTC_ERROR
  $ rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: refused by the component (RTC_ERROR)
  $ ctl error ConsoleIn0
  $ sleep 5
  $ show rtkeep
  [08:00:10] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:10] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  $ sleep 200
  $ show rtkeep
