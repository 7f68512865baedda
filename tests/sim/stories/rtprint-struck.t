Signals that strike while connections are made or removed leave none of them behind.

world: two
world: these ConsoleIn:Hangs0 ConsoleIn:Lives0

While they are made, which takes its time here:

  $ ctl delay connect 1
  $ rtprint -q ConsoleIn0.rtc:out.a ConsoleIn0.rtc:out.b ConsoleIn0.rtc:out.c ConsoleIn0.rtc:out.d ConsoleIn0.rtc:out.e ConsoleIn0.rtc:out.f &
  $ sleep 0.5
  $ strike TERM rtprint
  $ wait rtprint
  [143] after 2.1 s
  $ ctl connectors ConsoleIn0:out
  $ calls
  6 connect
  6 disconnect
  40 get_connector_profile
  6 get_port_profile
  6 get_ports
  $ ctl reset
  $ rtact ConsoleOut0.rtc
  $ ctl delay connect 1
  $ rtinject -c 1 -n -1 ConsoleOut0.rtc:in &
  $ sleep 0.5
  $ strike HUP rtinject
  $ wait rtinject
  [129] after 1.0 s
  $ ctl connectors ConsoleOut0:in
  $ ctl reset

While they are removed, at the command's own end; at most four are being removed at one time:

  $ rtprint -q -n 1 ConsoleIn0.rtc:out.a ConsoleIn0.rtc:out.b ConsoleIn0.rtc:out.c ConsoleIn0.rtc:out.d ConsoleIn0.rtc:out.e ConsoleIn0.rtc:out.f &
  $ sleep 1
  $ ctl delay disconnect 0.5
  $ ctl write ConsoleIn0:out 1
  $ sleep 0.3
  $ strike TERM rtprint
  $ wait rtprint
  c: [0.000000000] 1
  [143] after 2.1 s
  $ ctl connectors ConsoleIn0:out

Where the component does not answer then, or refuses, the connection stays, and that is said:

  $ RTSHELL_TIMEOUT=1
  $ ctl reset
  $ rtprint -q ConsoleIn0.rtc:out &
  $ sleep 1
  $ ctl fail disconnect 1 HANG
  $ strike TERM rtprint
  $ wait rtprint
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /robot/test.host_cxt/ConsoleIn0.rtc:out
  [143] after 2.2 s
  $ ctl reset
  $ rtdis ConsoleIn0.rtc:out
  $ rtprint -q ConsoleIn0.rtc:out &
  $ sleep 1
  $ ctl fail disconnect 1 UNKNOWN
  $ ctl fail notify_disconnect 1 UNKNOWN
  $ strike TERM rtprint
  $ wait rtprint
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: CORBA.UNKNOWN
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component refused to remove it; to try again: rtdis -i $UUID /robot/test.host_cxt/ConsoleIn0.rtc:out
  [143] after 1.1 s
  $ rtdis ConsoleIn0.rtc:out
  $ ctl reset
  $ ctl fail connect 1 HANG
  $ rtprint -q ConsoleIn0.rtc:out &
  $ sleep 0.5
  $ strike TERM rtprint
  $ wait rtprint
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  [143] after 1.1 s
  $ ctl reset
  $ ctl delay connect 0.5
  $ ctl fail disconnect 1 HANG
  $ rtprint -q ConsoleIn0.rtc:out &
  $ sleep 0.3
  $ strike TERM rtprint
  $ wait rtprint
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /robot/test.host_cxt/ConsoleIn0.rtc:out
  [143] after 1.7 s
  $ ctl reset
  $ rtdis ConsoleIn0.rtc:out
  $ rtlog -q -f log ConsoleIn0.rtc:out &
  $ sleep 1
  $ ctl fail disconnect 1 HANG
  $ strike TERM rtlog
  $ wait rtlog
  ! rtlog: /robot/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  ! rtlog: /robot/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /robot/test.host_cxt/ConsoleIn0.rtc:out
  [143] after 2.2 s
  $ ctl reset
  $ rtdis ConsoleIn0.rtc:out

One that hangs does not keep the others of its process connected:

  $ rtprint -q Hangs0.rtc:out Lives0.rtc:out &
  $ sleep 1
  $ ctl @these hang Hangs0 60
  $ sleep 10
  $ show rtprint
  ! rtprint: /robot/test.host_cxt/Hangs0.rtc:out: no answer within 1s
  $ strike TERM rtprint
  $ wait rtprint
  ! rtprint: /robot/test.host_cxt/Hangs0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /robot/test.host_cxt/Hangs0.rtc:out
  [143] after 11.1 s
  $ ctl @these connectors Lives0:out
  $ ctl @these reset

A component that is silent when it is to connect; it may have taken the connection all the same, or may yet:

  $ ctl reset
  $ ctl fail connect 1 HANG
  $ rtprint -n 1 ConsoleIn0.rtc:out
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  [4] after 1.1 s
  $ ctl fail connect 1 HANG
  $ rtinject -c 1 ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: no answer within 1s
  [4] after 1.1 s

What rtec --measure puts into a component is taken out again, however it ends:

  $ mock senders 100 4
  $ interrupt 1 rtec --measure 20 Source0.rtc
  [130] after 1.0 s
  $ ctl @senders connectors Source0:number
  $ terminate 1 rtec --measure 20 Source0.rtc
  [143] after 1.0 s
  $ ctl @senders connectors Source0:number
  $ rtec --measure 20 Source0.rtc &
  $ sleep 1
  $ strike HUP rtec
  $ wait rtec
  [129] after 1.0 s
  $ ctl @senders connectors Source0:number
