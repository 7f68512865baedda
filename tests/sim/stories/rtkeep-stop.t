`rtkeep stop` says what it could not deactivate, with a name and without. One that was left alone, as its policy says, is deactivated.

world: these ConsoleIn
world: these ConsoleOut
world: these Motor

  $ rtcryo --all -o a.xml
  $ rtkeep --restart no a.xml &
  $ sleep 5
  $ restart these3
  $ ctl delay get_ports 5
  $ rtkeep resume ConsoleIn0
  $ sleep 5
  $ rtact Motor0.rtc
  $ rtkeep stop Motor0
  $ rtkeep stop ConsoleIn0
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Motor0.rtc: Active
  [08:00:05] /robot/test.host_cxt/Motor0.rtc: its process is gone
  [08:00:05] /robot/test.host_cxt/Motor0.rtc: is back; its policy is no
  [08:00:08] /robot/test.host_cxt/ConsoleIn0.rtc: no answer within 3s
  [08:00:10] /robot/test.host_cxt/Motor0.rtc: deactivated on request
  $ rtact Motor0.rtc
  $ rtkeep stop
  $ wait rtkeep
  [08:00:15] /robot/test.host_cxt/ConsoleIn0.rtc: cannot deactivate: no answer within 3s
  [08:00:20] /robot/test.host_cxt/ConsoleOut0.rtc: Inactive
  [08:00:20] /robot/test.host_cxt/Motor0.rtc: Inactive
  [0] after 20.4 s
