A service port that is connected alone, by a transport that its properties name, is saved, compared, drawn and connected again.

world: services

  $ rtcon -i b -n topic -p dataport.interface_type=ros MyServiceProvider0.rtc:MyService
  $ rtcryo -q -o alone.rtsys .
  $ rtcheck -s Inactive alone.rtsys
  $ rtstodot --text alone.rtsys
  ┌────────────────────┐
  │ MyServiceProvider0 │
  │          MyService ├─┐
  ├────────────────────┤ │
  │ ros                │ │
  │                    │<┘
  └────────────────────┘
  $ rtstodot --live --text .
  ┌──────────────────────────────┐
  │ MyServiceProvider0  Inactive │
  │                    MyService ├─┐
  ├──────────────────────────────┤ │
  │ ros                          │ │
  │                              │<┘
  └──────────────────────────────┘
  $ rtteardown alone.rtsys
  $ rtcheck -s Inactive alone.rtsys
  ! No connection of /robot/test.host_cxt/MyServiceProvider0.rtc:MyService by ros
  [1]
  $ rtresurrect alone.rtsys
  $ ctl connectors MyServiceProvider0:MyService
  b topic
  $ rtdoctor --report report.html .
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/test.host_cxt/MyServiceConsumer0.rtc /robot/test.host_cxt/MyServiceProvider0.rtc
  ok    here: Python 3.11.7, builtin ORB
  ok    here: this host's name, robot, means 10.0.0.1
  ok    here: RTCTREE_NAMESERVERS: robot
  ok    /robot: answers (name 0.0 ms, TCP 0.1 ms, CORBA 5.1 ms, naming 0.1 ms) at 10.0.0.1, this host
  ok    /robot/test.host_cxt/MyServiceConsumer0.rtc: Inactive, claims 1000 Hz, 1 port, 0 connections, at 10.0.0.1:$PORT
  ok    /robot/test.host_cxt/MyServiceProvider0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  0 failed, 1 to be looked at, 6 ok
