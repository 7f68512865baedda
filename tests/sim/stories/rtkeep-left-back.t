A component dies while it is looked at, and is back before the look at another one ends: it is left alone.

world: these ConsoleIn
world: these ConsoleOut

  $ rtcryo --all -o a.xml
  $ ctl delay get_ports 2.5
  $ ctl @these2 delay get_ports 1
  $ later 0.6 restart these2
  $ rtkeep --restart no a.xml &
  $ sleep 20
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: its process is gone
  [08:00:01] /robot/test.host_cxt/ConsoleOut0.rtc: is back; its policy is no
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  $ rtkeep status
  a.xml: pid 5, since 2027-01-15 08:00:00; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Active   2027-01-15 08:00:05               Active
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  unknown  2027-01-15 08:00:01  restarts: 1  is back; its policy is no
  $ ctl @these2 state ConsoleOut0
  INACTIVE
