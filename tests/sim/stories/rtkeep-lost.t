Ports of which three answers each are lost are asked once more after a quarter of an hour, and as before when they answer that.

hosts: robot desk
seat: desk
world: these Mock:In0 --context near.host_cxt/%n.rtc
world: these Mock:Out0 --context far.host_cxt/%n.rtc

  $ RTCSH_CWD=/robot/near.host_cxt
  $ rtcon ../far.host_cxt/Out0.rtc:out In0.rtc:in
  $ rtcryo -q --all -o a.xml .
  $ rtkeep --look 1 a.xml &
  $ sleep 5
  $ ctl @these reset
  $ ctl @these fail get_connector_profiles 1 HANG
  $ ctl @these fail get_connector_profiles 2 HANG
  $ ctl @these fail get_connector_profiles 3 HANG
  $ ctl @these fail get_connector_profiles 4 HANG
  $ ctl @these fail get_connector_profiles 5 HANG
  $ ctl @these fail get_connector_profiles 6 HANG
  $ ctl @these fail get_connector_profiles 7 HANG
  $ ctl @these fail get_connector_profiles 8 HANG
  $ ctl @these fail get_connector_profiles 9 HANG
  $ sleep 700
  $ ctl @these reset
  $ sleep 100
  $ ctl @these calls In0
  $ sleep 1200
  $ ctl @these reset
  $ sleep 100
  $ ctl @these calls In0
  100 get_connector_profiles
  $ show rtkeep
  [08:00:00] /robot/near.host_cxt/In0.rtc: Active
