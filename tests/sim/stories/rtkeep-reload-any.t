What a person has made Inactive is not called Active again where the file leaves its state alone after a reload.

world: these ConsoleIn

  $ rtcryo --all -o a.xml
  $ rtkeep a.xml &
  $ sleep 5
  $ rtdeact ConsoleIn0.rtc
  $ sleep 2
  $ extend a.xml a.xml ConsoleIn0 keep.state any
  $ rtkeep reload
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:05] /robot/test.host_cxt/ConsoleIn0.rtc: was made Inactive by hand: left alone
  $ rtkeep status
  a.xml: pid 4, since 2027-01-15 08:00:00; all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc  any  Inactive  2027-01-15 08:00:05    was made Inactive by hand: left alone
