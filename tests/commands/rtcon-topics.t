Data ports that are connected alone: ROS, DDS, shared memory or the like carries their data.

world: topics --flavour cpp2
world: these ConsoleIn:A0 ConsoleOut:B0 ConsoleOut:B1 ConsoleOut:B2 ConsoleOut:B3 --context plain.host_cxt/%n.rtc

  $ rtcon -n chatter -i topic1 -p dataport.interface_type=fast-rtps \
  >     -p dataport.fast-rtps.topic=chatter ConsoleIn0.rtc:out
  $ rtcon -v -p dataport.interface_type=ssm ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: connected, id $UUID
  $ ctl connectors ConsoleIn0:out
  topic1 chatter

Without a transport, or by one of CORBA, which joins two ports, nothing would be connected:

  $ rtcon ConsoleIn0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: a data port alone; name another port, or the transport that carries its data: -p dataport.interface_type=ros, ros2, fast-rtps, ssm … (see --help)
  [2]
  $ rtcon -p dataport.interface_type=corba_cdr ConsoleIn0.rtc:out 2>/dev/null
  [2]
  $ rtcon -p dataport.interface_type=ros ConsoleIn0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out has no interface_type ros (it has: corba_cdr, * (glob)
  [2]
  $ rtcon --dry-run -p dataport.interface_type=ssm ConsoleIn0.rtc:out
  rtcon -p dataport.interface_type=ssm /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out

They are shown, saved, drawn, compared, removed and restored like all others:

  $ rtcat -l ConsoleIn0.rtc:out ConsoleOut0.rtc:in | grep onnect
   +Connected by  fast-rtps
   +Connected by  ssm
  $ rtcat -ll ConsoleIn0.rtc:out | sed -n '/Connected/,$p'
   -Connected by  fast-rtps
      Name                            chatter
      ID                              topic1
      dataport.data_type              IDL:RTC/TimedLong:1.0
      dataport.dataflow_type          push
      dataport.fast-rtps.topic        chatter
      dataport.interface_type         fast-rtps
      dataport.subscription_type      new
      dataport.serializer.cdr.endian  little,big
  $ rtcryo -o robot.rtsys .
  $ rtcryo -y -o robot.yaml .
  $ rtcheck -s Inactive robot.rtsys
  $ sed -n '/OnePort/,/<\/rtsExt:OnePort/p' robot.rtsys |
  >     grep -o 'connectorId="topic1"\|rts:sourceDataPort\|rts:targetDataPort' | sort | uniq -c
        1 connectorId="topic1"
        2 rts:sourceDataPort
        2 rts:targetDataPort
  $ rtstodot --text robot.rtsys
  ┌─────────────┐
  │ ConsoleIn0  │
  │         out ├─┐
  ├─────────────┤ │
  │ fast-rtps   │ │
  │             │<┘
  ├─────────────┤
  │ ssm         │
  │             ├─┐
  ├─────────────┤ │
  │ ConsoleOut0 │ │
  │ in          │<┘
  └─────────────┘
  $ for form in rtsys yaml; do
  >     rtteardown -q robot.$form
  >     rtcheck -s Inactive robot.$form
  >     rtresurrect -q robot.$form
  >     rtcheck -s Inactive robot.$form
  > done
  No connection of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out by fast-rtps
  No connection of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in by ssm
  No connection of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out by fast-rtps
  No connection of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in by ssm
  $ ctl connectors ConsoleIn0:out
  topic1 chatter
  $ rtdis -i topic1 ConsoleIn0.rtc:out
  $ rtresurrect --dry-run robot.rtsys
  rtcon -n chatter -i topic1 -p dataport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.dataflow_type=push -p dataport.fast-rtps.topic=chatter -p dataport.interface_type=fast-rtps -p dataport.serializer.cdr.endian=little,big -p dataport.subscription_type=new /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  $ rtresurrect robot.rtsys
  $ rtdoctor -q . | grep -v -e '^warn  here' -e 'examined are Inactive' -e ': slow ('
  [1]

The connectors of tools, which are no part of a system, are known by their names: ours, and rtshell's.

  $ for tool in rtprint rtinject rtlog rtmount rtshell_lite; do
  >     rtcon -n $tool -p dataport.interface_type=ssm ConsoleIn0.rtc:out
  > done
  $ cd_plain() { export RTCSH_CWD=/localhost:$PORT/plain.host_cxt; }; cd_plain
  $ rtcon -n rtprint_reader0_out A0.rtc:out B0.rtc:in; rtcon -n rtinject_writer1_out A0.rtc:out B1.rtc:in
  $ rtcon -n rtlog_recorder0_out A0.rtc:out B2.rtc:in; rtcon -n rtlog_player2_out A0.rtc:out B3.rtc:in
  $ ctl connectors ConsoleIn0:out | wc -l; ctl @these connectors A0:out | wc -l
  6
  4
  $ rtcheck --extra -s Inactive robot.rtsys 2>&1 | grep "Connection not"
  [1]
  $ rtcryo -q -o now.rtsys /localhost:$PORT
  $ grep -c '<rts:DataPortConnectors\|<rtsExt:OnePortConnectors' now.rtsys
  2
