While one hangs, not all is as the file says. One that waits for it, and could not be looked at, is not absent.

hosts: robot desk
seat: desk
world: these Mock:In0 --context near.host_cxt/%n.rtc
world: these Mock:Out0 --context far.host_cxt/%n.rtc --flavour java

  $ RTCSH_CWD=/robot/near.host_cxt
  $ rtcon ../far.host_cxt/Out0.rtc:out In0.rtc:in
  $ rtcryo -q --all -o a.xml ../far.host_cxt
  $ rtcryo -q --all -o b.xml .
  $ rtkeep --look 0.5 a.xml &
  $ sleep 5
  $ hang these2
  $ rtkeep --look 0.5 b.xml &
  $ sleep 10
  $ rtkeep status a.xml b.xml
  a.xml: pid 7, since 2027-01-15 08:00:00; not all is as the file says
    /robot/far.host_cxt/Out0.rtc  Active  hung  2027-01-15 08:00:11    no answer within 3s: left alone
  b.xml: pid 8, since 2027-01-15 08:00:05; not all is as the file says
    /robot/near.host_cxt/In0.rtc  Active  unknown  2027-01-15 08:00:05    no answer within 3s
