The last component is Active in time; a connection that is being made again then is not as the file says.

world: these ConsoleIn
world: these ConsoleOut
world: these Motor

  $ rtcon -i x ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o a.xml
  $ kill these3
  $ ctl delay connect 2.9
  $ later 5 rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ later 5.8 restart these3
  $ rtkeep --once --within 7.5 --look 0.3 a.xml
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:06] /robot/test.host_cxt/Motor0.rtc: Active
  ! rtkeep: /robot/test.host_cxt/ConsoleIn0.rtc: it is looked at again
  ! rtkeep: /robot/test.host_cxt/ConsoleOut0.rtc: it is looked at again
  [4] after 7.5 s
  $ rtls -l
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Active  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Active  2/0  1/0  1/0  0/0  Motor0.rtc
