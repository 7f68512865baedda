An Error that is reported while others are still being activated is one failure.

world: these ConsoleIn Slow

  $ rtcryo --all -o a.xml
  $ rtkeep --burst 1/60 a.xml &
  $ sleep 0.6
  $ ctl error ConsoleIn0
  $ sleep 5
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:00:00] /robot/err.host_cxt/Err0.rtc: cannot activate: it went to Error
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Slow0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:01] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:01] /robot/err.host_cxt/Err0.rtc: in Error: reset
  [08:00:01] /robot/err.host_cxt/Err0.rtc: cannot activate: it went to Error; given up after more than 1 failure in 60s
  [0] after 5.6 s

That it waited for more than a minute before it was tried again, and failed, was no minute of health.

world: these Err --context err.host_cxt/%n.rtc

  $ rtcryo --all -o b.xml /robot/err.host_cxt
  $ rtkeep --burst 3/3600 --delay 70-1000 b.xml &
  $ sleep 1000
  $ show rtkeep
  [08:00:05] /robot/err.host_cxt/Err0.rtc: in Error: reset
  [08:00:05] /robot/err.host_cxt/Err0.rtc: cannot activate: it went to Error
  [08:01:30] /robot/err.host_cxt/Err0.rtc: in Error: reset
  [08:04:03] /robot/err.host_cxt/Err0.rtc: in Error: reset
  [08:04:03] /robot/err.host_cxt/Err0.rtc: cannot activate: it went to Error; given up after more than 3 failures in 3600s
