A component waits for one that hangs, dies while rtkeep finds that out, and is back: what rtkeep says of it is that it is left alone.

hosts: robot desk
seat: desk
world: these Mock:In0 --context near.host_cxt/%n.rtc
world: these Mock:Out0 --context far.host_cxt/%n.rtc

  $ RTCSH_CWD=/robot/near.host_cxt
  $ rtcon ../far.host_cxt/Out0.rtc:out In0.rtc:in
  $ rtcryo -q --all -o a.xml /robot
  $ rtkeep --restart no --look 0.5 a.xml &
  $ sleep 5
  $ hang these2
  $ rtkeep resume In0
  $ later 3.6 restart these
  $ sleep 20
  $ show rtkeep
  [08:00:00] /robot/far.host_cxt/Out0.rtc: Active
  [08:00:00] /robot/near.host_cxt/In0.rtc: Active
  [08:00:08] /robot/near.host_cxt/In0.rtc: refuses: dead, or a firewall closes this port
  [08:00:09] /robot/near.host_cxt/In0.rtc: is back; its policy is no
  [08:00:11] /robot/far.host_cxt/Out0.rtc: no answer within 3s: left alone
  $ rtkeep status
  a.xml: pid 6, since 2027-01-15 08:00:00; not all is as the file says
    /robot/far.host_cxt/Out0.rtc  Active  hung     2027-01-15 08:00:11               no answer within 3s: left alone
    /robot/near.host_cxt/In0.rtc  Active  unknown  2027-01-15 08:00:09  restarts: 1  is back; its policy is no
