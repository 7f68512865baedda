A component whose answers about its connections come late each time, as while Python 2.1 waits for a neighbour that hangs: it is
asked ever more seldom, and its late answers do not change that.

hosts: robot desk
seat: desk
world: these Mock:In0 Mock:In1 --context near.host_cxt/%n.rtc
world: these Mock:Out0 --context far.host_cxt/%n.rtc

  $ RTCSH_CWD=/robot/near.host_cxt
  $ rtcon ../far.host_cxt/Out0.rtc:out In0.rtc:in
  $ rtcryo -q --all -o a.xml .
  $ rtkeep --look 1 a.xml &
  $ sleep 5
  $ ctl @these reset
  $ ctl @these delay get_connector_profiles 10
  $ sleep 1000
  $ ctl @these calls In0
  9 get_connector_profiles
