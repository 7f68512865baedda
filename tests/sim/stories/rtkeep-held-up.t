A component that waits for a neighbour answers rtkeep when that answers it. Until then each question may hold one of its threads: it
is asked three times, and owes the answers. That it gives them says that the neighbour answers again, whom nobody follows here.

hosts: robot desk
seat: desk
world: these Mock:In0 Mock:In1 --context near.host_cxt/%n.rtc
world: these Mock:Out0 --context far.host_cxt/%n.rtc

  $ RTCSH_CWD=/robot/near.host_cxt
  $ rtcon ../far.host_cxt/Out0.rtc:out In0.rtc:in
  $ rtcryo -q --all -o a.xml .
  $ hang these2
  $ ctl reset
  $ rtkeep --look 1 a.xml &
  $ sleep 30
  $ show rtkeep
  [08:00:03] /robot/near.host_cxt/In0.rtc: no answer within 3s
  [08:00:03] /robot/near.host_cxt/In1.rtc: Active
  [08:00:16] /robot/near.host_cxt/In0.rtc: no answer to 3 earlier questions
  $ sleep 300
  $ ctl calls In0
  3 get_port_profile
  9 get_ports
  $ wake these2
  $ sleep 1
  $ show rtkeep
  [08:05:30] /robot/near.host_cxt/In0.rtc: Active
  $ sleep 60
  $ show rtkeep
  $ rtls -l
  Active  2/1  1/1  1/0  0/0  In0.rtc
  Active  2/0  1/0  1/0  0/0  In1.rtc
