One that rtkeep leaves alone, as its policy says, is left alone, too, when it answers again.

hosts: robot desk
seat: desk
world: these Mock:In0 --context near.host_cxt/%n.rtc
world: these Mock:Out0 --context far.host_cxt/%n.rtc

  $ RTCSH_CWD=/robot/near.host_cxt
  $ rtcon ../far.host_cxt/Out0.rtc:out In0.rtc:in
  $ rtcryo -q --all -o a.xml /robot
  $ rtkeep --restart no --look 0.5 a.xml &
  $ sleep 5
  $ restart these2
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/far.host_cxt/Out0.rtc: Active
  [08:00:00] /robot/near.host_cxt/In0.rtc: Active
  [08:00:05] /robot/far.host_cxt/Out0.rtc: refuses: dead, or a firewall closes this port
  [08:00:05] /robot/far.host_cxt/Out0.rtc: is back; its policy is no
  $ rtcon ../far.host_cxt/Out0.rtc:out In0.rtc:in
  $ sleep 5
  $ hang these2
  $ rtkeep resume In0
  $ sleep 20
  $ show rtkeep
  [08:00:21] /robot/far.host_cxt/Out0.rtc: no answer within 3s: left alone
  [08:00:21] /robot/near.host_cxt/In0.rtc: waits for /robot/far.host_cxt/Out0.rtc
  $ rtkeep status
  a.xml: pid 6, since 2027-01-15 08:00:00; not all is as the file says
    /robot/far.host_cxt/Out0.rtc  Active  hung    2027-01-15 08:00:21  restarts: 1  no answer within 3s: left alone
    /robot/near.host_cxt/In0.rtc  Active  Active  2027-01-15 08:00:00               waits for /robot/far.host_cxt/Out0.rtc
  $ wake these2
  $ sleep 20
  $ show rtkeep
  [08:00:35] /robot/far.host_cxt/Out0.rtc: answers again
  $ rtkeep status
  a.xml: pid 6, since 2027-01-15 08:00:00; not all is as the file says
    /robot/far.host_cxt/Out0.rtc  Active  unknown  2027-01-15 08:00:35  restarts: 1  answers again
    /robot/near.host_cxt/In0.rtc  Active  Active   2027-01-15 08:00:00               waits for /robot/far.host_cxt/Out0.rtc
