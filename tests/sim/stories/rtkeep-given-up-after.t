When one is given up, only what rtkeep keeps Active is deactivated: neither what is kept in any state, nor what is paused, nor what
comes after these alone.

world: these ConsoleIn Motor Sensor Controller
world: these ConsoleOut

  $ rtcryo --all -o a.xml
  $ extend a.xml b.xml ConsoleOut0 keep.state any
  $ order b.xml c.xml ConsoleIn0 Motor0 ConsoleOut0 Sensor0 Controller0
  $ rtkeep --burst 1/60 --delay 0.5-1 c.xml &
  $ rtact ConsoleOut0.rtc
  $ sleep 5
  $ rtkeep pause Sensor0
  $ ctl error ConsoleIn0
  $ sleep 5
  $ ctl error ConsoleIn0
  $ sleep 15
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Controller0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Motor0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: in Error: reset
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:10] /robot/test.host_cxt/ConsoleIn0.rtc: in Error; given up after more than 1 failure in 60s
  [08:00:10] /robot/test.host_cxt/Motor0.rtc: /robot/test.host_cxt/ConsoleIn0.rtc is given up: deactivated
  [08:00:10] /robot/test.host_cxt/Motor0.rtc: not tried: it waits for /robot/test.host_cxt/ConsoleIn0.rtc, which failed
  $ rtkeep status
  c.xml: pid 5, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Error (given up)  2027-01-15 08:00:10    in Error; given up after more than 1 failure in 60s
    /robot/test.host_cxt/ConsoleOut0.rtc  any     Active            2027-01-15 08:00:00
    /robot/test.host_cxt/Controller0.rtc  Active  Active            2027-01-15 08:00:00    Active
    /robot/test.host_cxt/Motor0.rtc       Active  Inactive          2027-01-15 08:00:10    not tried: it waits for /robot/test.host_cxt/ConsoleIn0.rtc, which failed
    /robot/test.host_cxt/Sensor0.rtc      paused  Active            2027-01-15 08:00:00    Active
