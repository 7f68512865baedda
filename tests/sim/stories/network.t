What commands on a laptop say, and how long they take, while the network between them and a robot is broken.

hosts: robot1 robot2 laptop
seat: laptop
world: these ConsoleIn
world: these ConsoleOut --host robot2
world: manager Sensor --flavour cpp11

  $ RTSHELL_TIMEOUT=0.3
  $ rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtact --wait 2 ConsoleOut0.rtc
  $ ctl @these write ConsoleIn0:out 42
  $ ctl @these2 received ConsoleOut0:in 1
  1 42
  $ rtwatch ConsoleIn0.rtc ConsoleOut0.rtc &
  $ rtfind --wait 60 . -n none &
  $ rtprint ConsoleIn0.rtc:out &
  $ sleep 3

A cable is pulled. The component on the other robot waits for its peer, too: what asks that waits for it.

  $ unplug robot2
  $ rtls -l
  Inactive  ?    ?    ?    ?    ConsoleIn0.rtc
  ?         -    -    -    -    ?ConsoleOut0.rtc
  Inactive  2/0  1/0  1/0  0/0  Sensor0.rtc
  -         -    -    -    -    manager.mgr
  ! rtls: 1 of 4 did not report the ports (ConsoleIn0.rtc); 1 did not answer (ConsoleOut0.rtc)
  [5] after 0.3 s
  $ rtcat ConsoleOut0.rtc
  ! rtcat: /robot1/test.host_cxt/ConsoleOut0.rtc: no answer within 0.3s
  [4] after 0.3 s
  $ rtact ConsoleIn0.rtc ConsoleOut0.rtc
  ! rtact: /robot1/test.host_cxt/ConsoleOut0.rtc: no answer within 0.3s
  [5] after 0.3 s
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  ! rtcon: /robot1/test.host_cxt/ConsoleIn0.rtc: no answer within 0.3s
  ! rtcon: /robot1/test.host_cxt/ConsoleOut0.rtc: no answer within 0.3s
  [4] after 0.3 s
  $ rtfind . -t c
  /robot1/test.host_cxt/ConsoleIn0.rtc
  /robot1/test.host_cxt/ConsoleOut0.rtc
  /robot1/test.host_cxt/Sensor0.rtc
  /robot1/test.host_cxt/manager.mgr/Sensor0.rtc
  ! rtfind: /robot1/test.host_cxt/ConsoleOut0.rtc: no answer within 0.3s
  [5] after 0.3 s
  $ rtdel -z
  [0] after 0.3 s
  $ rtdis ConsoleOut0.rtc
  ! rtdis: /robot1/test.host_cxt/ConsoleOut0.rtc: no answer within 0.3s
  [4] after 0.3 s
  $ rtdoctor -q
  fail  /robot1/test.host_cxt/ConsoleOut0.rtc: cannot tell from here whether it lives: publishes 10.0.0.2:$PORT, out of reach (no answer within 0.3s); try: look at what is between here and 10.0.0.2: firewall (port 42001), route (ip route get 10.0.0.2), MTU and loss (ping 10.0.0.2)
  fail  /robot1/test.host_cxt/ConsoleIn0.rtc: hangs when asked for the profile of its port 1, maybe waiting for a far end that does not answer; try: mend /robot1/test.host_cxt/ConsoleOut0.rtc first
  warn  here: RTSHELL_TIMEOUT is 0.3: what answers after 0.3 s is taken for silent; try: unset RTSHELL_TIMEOUT
  [1] after 0.7 s

Commands that hold something there end while it is out of reach:

  $ strike INT rtwatch
  $ strike INT rtfind
  $ strike INT rtprint
  $ wait rtwatch
  [ConsoleIn0.rtc 1.1] HEARTBEAT
  [ConsoleOut0.rtc 1.1] HEARTBEAT
  [ConsoleIn0.rtc 2.1] HEARTBEAT
  [ConsoleOut0.rtc 2.1] HEARTBEAT
  [ConsoleIn0.rtc 3.1] HEARTBEAT
  [ConsoleIn0.rtc 3.7] default CFG_UPDATE_SET
  [ConsoleIn0.rtc 3.7] 0 ACTIVE
  [ConsoleIn0.rtc 3.7] ConsoleIn0.out PORT_SEND
  [ConsoleOut0.rtc 4.0] NO_ANSWER
  [ConsoleIn0.rtc 4.1] HEARTBEAT
  [ConsoleIn0.rtc 4.7] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 5.1] HEARTBEAT
  [ConsoleIn0.rtc 5.7] ConsoleIn0.out PORT_SEND
  ! rtwatch: /robot1/test.host_cxt/ConsoleOut0.rtc: no answer within 0.3s
  ! rtwatch: /robot1/test.host_cxt/ConsoleOut0.rtc: does not answer; it still has our observer, and drops it when a call to it fails
  [130] after 6.0 s
  $ wait rtfind
  [130] after 6.0 s
  $ wait rtprint
  [3.7] 1
  …
  ! rtprint: /robot1/test.host_cxt/ConsoleIn0.rtc:out: no value has come: it is Inactive; rtact /robot1/test.host_cxt/ConsoleIn0.rtc
  [130] after 6.0 s

It is plugged in again:

  $ sleep 10
  $ rtls -l
  Active    1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Active    1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  1/0  1/0  0/0  Sensor0.rtc
  -         -    -    -    -    manager.mgr
  $ rtdis ConsoleIn0.rtc
  $ ctl @these connectors ConsoleIn0:out
  $ ctl @these2 connectors ConsoleOut0:in
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o robot.rtsys

A firewall closes one port. It lives: nothing calls it dead, deletes its name, or creates it again.

  $ close_port these2
  $ rtls -l
  Active    1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  ?         -    -    -    -    ?ConsoleOut0.rtc
  Inactive  2/0  1/0  1/0  0/0  Sensor0.rtc
  -         -    -    -    -    manager.mgr
  ! rtls: 1 of 4 did not answer (ConsoleOut0.rtc)
  [5]
  $ rtdoctor -q --profile robot.rtsys .
  fail  /robot1/test.host_cxt/ConsoleOut0.rtc: 10.0.0.2:$PORT refuses: dead, or a firewall closes this port; try: on that host: rtdoctor, rtdel -z; netstat -ltnp | grep :$PORT there shows whether its process runs: if so, let this host through its firewall; if not, start it again
  fail  /robot1/test.host_cxt/ConsoleIn0.rtc:out: the far end of a connection, at 10.0.0.2:$PORT, refuses: dead, or a firewall closes this port; try: on that host: rtdoctor, rtdel -z; netstat -ltnp | grep :$PORT there shows whether its process runs: if so, let this host through its firewall; if not, start it again
  fail  /robot1/test.host_cxt/ConsoleOut0.rtc: refuses: dead, or a firewall closes this port; try: look at it: rtcat /robot1/test.host_cxt/ConsoleOut0.rtc
  fail  /robot1/test.host_cxt/Sensor0.rtc: incorrect state Inactive, not Active; try: rtact /robot1/test.host_cxt/Sensor0.rtc
  warn  here: RTSHELL_TIMEOUT is 0.3: what answers after 0.3 s is taken for silent; try: unset RTSHELL_TIMEOUT
  [1]
  $ rtdel -z
  ! rtdel: /robot1/test.host_cxt/ConsoleOut0.rtc: left: refuses: dead, or a firewall closes this port; on that host: rtdoctor, rtdel -z; here: rtdel -zf
  [1]
  $ rtdel -z ConsoleOut0.rtc
  ! rtdel: /robot1/test.host_cxt/ConsoleOut0.rtc: left: refuses: dead, or a firewall closes this port; on that host: rtdoctor, rtdel -z; here: rtdel -zf
  [1]
  $ rtfind . -t z
  $ rtact ConsoleOut0.rtc
  ! rtact: /robot1/test.host_cxt/ConsoleOut0.rtc: refuses: dead, or a firewall closes this port
  [4]
  $ rtresurrect --create robot.rtsys
  ! rtresurrect: /robot1/test.host_cxt/ConsoleOut0.rtc: refuses: dead, or a firewall closes this port
  ! rtresurrect: 6 already done, 1 failed, 3 not tried
  [5]
  $ rtresurrect --create --manager manager.mgr robot.rtsys
  ! rtresurrect: /robot1/test.host_cxt/ConsoleOut0.rtc: refuses: dead, or a firewall closes this port
  ! rtresurrect: 6 already done, 1 failed, 3 not tried
  [5]
