However rtprint ends, its connections are removed; ports that die, hang or are disconnected are reported.

hosts: robot desk
seat: desk
world: two
world: senders 50 12
world: these Mock:Quiet0

Signals, also two at a time:

  $ rtprint ConsoleIn0.rtc:out Quiet0.rtc:out &
  $ sleep 1
  $ ctl connectors ConsoleIn0:out
  $UUID rtprint
  $ ctl @these connectors Quiet0:out
  $UUID rtprint
  $ strike TERM rtprint
  $ wait rtprint
  [143] after 1.1 s
  $ ctl connectors ConsoleIn0:out
  $ ctl @these connectors Quiet0:out
  $ rtprint ConsoleIn0.rtc:out Quiet0.rtc:out &
  $ sleep 1
  $ strike HUP rtprint
  $ wait rtprint
  [129] after 1.1 s
  $ ctl connectors ConsoleIn0:out
  $ ctl @these connectors Quiet0:out
  $ rtprint --pull ConsoleIn0.rtc:out &
  $ sleep 1
  $ ctl connectors ConsoleIn0:out
  $UUID rtprint
  $ strike HUP rtprint
  $ strike TERM rtprint
  $ wait rtprint
  [129] after 1.0 s
  $ ctl connectors ConsoleIn0:out
  $ interrupt 1 rtprint ConsoleIn0.rtc:out
  [130] after 1.1 s
  $ ctl connectors ConsoleIn0:out
  $ interrupt 1 rtprint --stats Quiet0.rtc:out
  all in all: no values
  [130] after 1.1 s
  $ ctl @these connectors Quiet0:out

A component that is not Active sends nothing, which is said:

  $ rtprint -t 5 Quiet0.rtc:out
  ! rtprint: /robot/test.host_cxt/Quiet0.rtc:out: no value has come: it is Inactive; rtact /robot/test.host_cxt/Quiet0.rtc
  [0] after 5.1 s
  $ rtact --wait=30 Quiet0.rtc
  $ rtprint -t 5 Quiet0.rtc:out
  [0] after 5.1 s
  $ rtdeact Quiet0.rtc

Someone removes the connection, or the component exits:

  $ rtprint ConsoleIn0.rtc:out &
  $ sleep 1
  $ rtdis ConsoleIn0.rtc:out
  $ wait rtprint
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: the connection has been removed; if the component did that, it cannot reach this machine (pull may do), or its values exceed its ORB's giopMaxMsgSize
  [4] after 2.1 s
  $ rtprint --pull ConsoleIn0.rtc:out &
  $ sleep 1
  $ rtdis --force ConsoleIn0.rtc:out
  $ wait rtprint
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: the connection has been removed
  [4] after 1.0 s
  $ rtprint -q ConsoleIn0.rtc:out.a Quiet0.rtc:out.b &
  $ sleep 1
  $ rtexit Quiet0.rtc
  $ sleep 5
  $ show rtprint
  ! rtprint: /robot/test.host_cxt/Quiet0.rtc:out: the component has ended
  $ ctl write ConsoleIn0:out 6
  $ ctl write ConsoleIn0:out 7
  $ rtdis ConsoleIn0.rtc:out
  $ wait rtprint
  a: [0.000000000] 6
  a: [0.000000000] 7
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: the connection has been removed
  [4] after 7.0 s

Hung for a while: that is reported, and it continues:

  $ RTSHELL_TIMEOUT=0.5
  $ rtprint Source0.rtc:number &
  $ sleep 1
  $ hang senders
  $ sleep 10
  $ show rtprint
  …
  ! rtprint: /robot/test.host_cxt/Source0.rtc:number: no answer within 0.5s
  $ wake senders
  $ sleep 10
  $ show rtprint
  …
  ! rtprint: /robot/test.host_cxt/Source0.rtc:number: answers again
  $ strike TERM rtprint
  $ wait rtprint
  [143] after 21.0 s
  $ ctl @senders connectors Source0:number

Hung when it ends:

  $ rtprint ConsoleIn0.rtc:out &
  $ sleep 1
  $ ctl write ConsoleIn0:out 1
  $ sleep 1
  $ hang two
  $ strike TERM rtprint
  $ wait rtprint
  [0.000000000] 1
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: no answer within 0.5s
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /robot/test.host_cxt/ConsoleIn0.rtc:out
  [143] after 2.6 s
  $ wake two
  $ ctl write ConsoleIn0:out 1
  $ sleep 1
  $ ctl connectors ConsoleIn0:out
  $UUID rtprint

Killed in the middle of its stream:

  $ rtprint Source0.rtc:number &
  $ sleep 1
  $ kill senders
  $ wait rtprint
  …
  ! rtprint: /robot/test.host_cxt/Source0.rtc:number: the component is gone, and its process too
  [4] after 1.2 s
  $ rtprint --pull ConsoleIn0.rtc:out &
  $ sleep 1
  $ kill two
  $ wait rtprint
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc:out: connection refused
  [4] after 1.1 s
  $ rtprint ConsoleIn0.rtc:out
  ! rtprint: /robot/test.host_cxt/ConsoleIn0.rtc: refuses: dead, or a firewall closes this port
  [4]
