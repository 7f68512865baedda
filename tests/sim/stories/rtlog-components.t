A component that exits while it is recorded goes when it did, with its name, where the recording is played as components.

world: these ConsoleIn ConsoleOut Motor

  $ rtlog -q --events -f b.mcap . &
  $ sleep 3
  $ rtexit Motor0.rtc
  $ sleep 3
  $ ctl write ConsoleIn0:out 11
  $ sleep 1
  $ strike TERM rtlog
  $ wait rtlog
  ! rtlog: /robot/test.host_cxt/Motor0.rtc:out: the component has ended
  [143] after 7.1 s
  $ rtlog -p -f b.mcap --as-components replay.host_cxt &
  $ sleep 1
  $ rtls ../replay.host_cxt/test.host_cxt
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Motor0.rtc
  $ sleep 4
  $ rtls ../replay.host_cxt/test.host_cxt
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ wait rtlog
  ! rtlog: 3 components are bound in /robot
  [0] after 6.0 s
  $ rtls ..
  test.host_cxt/
