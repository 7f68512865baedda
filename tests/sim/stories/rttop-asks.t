Asking is cheap: rttop asks for the state twice a second, for contexts and ports now and then, four calls at a time.

world: robot
world: senders 50 100 --context src.host_cxt/%n.rtc

  $ rttop -n 2 .
  STATE         RATE  CONN  COMPONENT
  Inactive      1000     1  Clusterer0.rtc
  Inactive      1000     2  Controller0.rtc
  Inactive      1000     1  Hokuyo_AIST0.rtc
  Inactive      1000     2  Motor0.rtc
  Inactive      1000     2  Sensor0.rtc

  STATE         RATE  CONN  COMPONENT
  Inactive      1000     1  Clusterer0.rtc
  Inactive      1000     2  Controller0.rtc
  Inactive      1000     1  Hokuyo_AIST0.rtc
  Inactive      1000     2  Motor0.rtc
  Inactive      1000     2  Sensor0.rtc
  [0] after 0.5 s
  $ ctl calls Controller0
  2 get_component_state
  1 get_owned_contexts
  1 get_participating_contexts
  2 get_port_profile
  1 get_ports
  1 get_rate
  1 is_running
  $ ctl highwater
  1
  $ ctl reset
  $ rttop -n 8 -r 1 Controller0.rtc
  STATE         RATE  CONN  COMPONENT
  Inactive      1000     2  Controller0.rtc

  STATE         RATE  CONN  COMPONENT
  Inactive      1000     2  Controller0.rtc

  STATE         RATE  CONN  COMPONENT
  Inactive      1000     2  Controller0.rtc

  STATE         RATE  CONN  COMPONENT
  Inactive      1000     2  Controller0.rtc

  STATE         RATE  CONN  COMPONENT
  Inactive      1000     2  Controller0.rtc

  STATE         RATE  CONN  COMPONENT
  Inactive      1000     2  Controller0.rtc

  STATE         RATE  CONN  COMPONENT
  Inactive      1000     2  Controller0.rtc

  STATE         RATE  CONN  COMPONENT
  Inactive      1000     2  Controller0.rtc
  [0] after 7.0 s
  $ ctl calls Controller0
  8 get_component_state
  2 get_owned_contexts
  2 get_participating_contexts
  2 get_port_profile
  1 get_ports
  2 get_rate
  2 is_running

The flow of ports, over a second:

  $ rttop -n 1 -p ../src.host_cxt/Source0.rtc:number -p ../src.host_cxt/Source0.rtc:block -f source
  STATE         RATE  CONN  COMPONENT
  Active          50     2  Source0.rtc
      50.0 Hz      600 B/s  /robot/src.host_cxt/Source0.rtc:number
      50.0 Hz     5.6 kB/s  /robot/src.host_cxt/Source0.rtc:block
  [0] after 1.0 s
  $ ctl @senders connectors Source0:number
