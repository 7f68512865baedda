One is deactivated slowly, as one before it is given up; that it is still Active when its ports are looked at meanwhile does not
mean that a person has made it Inactive then.

world: these ConsoleIn
world: these Slow
world: these ConsoleOut

  $ rtcon -i y Slow0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o a.xml
  $ order a.xml b.xml ConsoleIn0 Slow0
  $ rtkeep --burst 1/60 --delay 0.5-1 --look 0.5 b.xml &
  $ sleep 5
  $ ctl error ConsoleIn0
  $ sleep 5
  $ ctl error ConsoleIn0
  $ sleep 0.1
  $ rtdis Slow0.rtc:out ConsoleOut0.rtc:in
  $ sleep 15
  $ rtcon -i x ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ sleep 15
  $ show rtkeep
  [08:00:01] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:01] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:01] /robot/test.host_cxt/Slow0.rtc: Active
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:10] /robot/test.host_cxt/ConsoleIn0.rtc: in Error; given up after more than 1 failure in 60s
  [08:00:10] /robot/test.host_cxt/Slow0.rtc: restored connection y
  [08:00:10] /robot/test.host_cxt/Slow0.rtc: /robot/test.host_cxt/ConsoleIn0.rtc is given up: deactivated
  [08:00:11] /robot/test.host_cxt/Slow0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleIn0.rtc, which failed
  [08:00:25] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:25] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:26] /robot/test.host_cxt/Slow0.rtc: Active
