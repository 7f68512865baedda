rtkeep gives up what fails again and again, with what depends on it, and begins again when something about it changes.

world: these Err ConsoleIn ConsoleOut Motor
world: these Sensor --flavour cpp2

Err0 goes to Error as soon as it is Active. ConsoleIn0 starts after it, ConsoleOut0 after that; Motor0 and Sensor0 need neither.

  $ rtcryo --all -o a.xml
  $ order a.xml b.xml Err0 ConsoleIn0 ConsoleOut0
  $ rtkeep --stop-at-end --burst 3/60 --delay 0.5-1 b.xml &
  $ sleep 30
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: not tried: it waits for /robot/test.host_cxt/Err0.rtc, which failed
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleIn0.rtc, which was not tried
  [08:00:00] /robot/test.host_cxt/Err0.rtc: cannot activate: it went to Error
  [08:00:00] /robot/test.host_cxt/Motor0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Err0.rtc: in Error: reset
  [08:00:00] /robot/test.host_cxt/Err0.rtc: in Error: reset
  [08:00:02] /robot/test.host_cxt/Err0.rtc: in Error: reset
  [08:00:02] /robot/test.host_cxt/Err0.rtc: cannot activate: it went to Error; given up after more than 3 failures in 60s
  $ rtkeep status
  b.xml: pid 5, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Inactive          2027-01-15 08:00:00    not tried: it waits for /robot/test.host_cxt/Err0.rtc, which failed
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Inactive          2027-01-15 08:00:00    not tried: it waits for /robot/test.host_cxt/ConsoleIn0.rtc, which was not tried
    /robot/test.host_cxt/Err0.rtc         Active  Error (given up)  2027-01-15 08:00:02    cannot activate: it went to Error; given up after more than 3 failures in 60s
    /robot/test.host_cxt/Motor0.rtc       Active  Active            2027-01-15 08:00:00    Active
    /robot/test.host_cxt/Sensor0.rtc      Active  Active            2027-01-15 08:00:00    Active
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:00:30] /robot/test.host_cxt/ConsoleIn0.rtc: Inactive
  [08:00:30] /robot/test.host_cxt/ConsoleOut0.rtc: Inactive
  [08:00:30] /robot/test.host_cxt/Err0.rtc: cannot deactivate: it is in Error; reset it first
  [08:00:30] /robot/test.host_cxt/Sensor0.rtc: Inactive
  [08:00:30] /robot/test.host_cxt/Motor0.rtc: Inactive
  [0] after 30.0 s

A required component that is given up takes those with it that were started after it:

  $ rtexit --wait Err0.rtc
  [0] after 0.7 s
  $ rtcryo --all -o c.xml
  $ order c.xml d.xml ConsoleIn0 ConsoleOut0 Motor0
  $ rtkeep --burst 2/60 --delay 0.5-1 d.xml &
  $ sleep 5
  $ rtcheck d.xml
  $ ctl error ConsoleIn0
  $ sleep 5
  $ rtcheck d.xml
  $ ctl error ConsoleIn0
  $ sleep 5
  $ rtcheck d.xml
  $ show rtkeep
  [08:00:30] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:30] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:30] /robot/test.host_cxt/Motor0.rtc: Active
  [08:00:30] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:35] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:35] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:41] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:41] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  $ ctl error ConsoleIn0
  $ sleep 30
  $ show rtkeep
  [08:00:45] /robot/test.host_cxt/ConsoleIn0.rtc: in Error; given up after more than 2 failures in 60s
  [08:00:45] /robot/test.host_cxt/Motor0.rtc: /robot/test.host_cxt/ConsoleIn0.rtc is given up: deactivated
  [08:00:45] /robot/test.host_cxt/ConsoleOut0.rtc: /robot/test.host_cxt/ConsoleIn0.rtc is given up: deactivated
  [08:00:46] /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleIn0.rtc, which failed
  [08:00:47] /robot/test.host_cxt/Motor0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleOut0.rtc, which failed
  $ ctl state ConsoleIn0
  ERROR
  $ ctl state ConsoleOut0
  INACTIVE
  $ ctl state Motor0
  INACTIVE

When something about it changes, it is tried again, and they follow.

  $ rtcon -i x ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ sleep 5
  $ show rtkeep
  [08:01:17] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:01:17] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:01:17] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:01:17] /robot/test.host_cxt/Motor0.rtc: Active
  $ rtcheck d.xml
  $ strike TERM rtkeep
  $ wait rtkeep
  [0] after 50.0 s
