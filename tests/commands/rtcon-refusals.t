When rtcon does not connect: it says why, and nothing is left behind.

world: console
world: these Mock:Mock0 ConsoleIn:ConsoleIn1 Motor MyServiceProvider
world: these ConsoleOut:Dead0
world: these ConsoleOut:Hung0
world: fragile
both: each ORB reads and writes values in its own way

Ports that do not match are recognised before anything is asked of them. Components themselves would not mind:

  $ ctl reset
  $ rtcon ConsoleIn0.rtc:out SequenceInComponent0.rtc:Double
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Double: data types differ (RTC/TimedLong, RTC/TimedDouble)
  [2]
  $ rtcon SequenceInComponent0.rtc:Double ConsoleIn0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Double to /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: data types differ (RTC/TimedDouble, RTC/TimedLong)
  [2]
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in SequenceInComponent0.rtc:Short
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Short: data types differ (RTC/TimedLong, RTC/TimedLong, RTC/TimedShort)
  [2]
  $ rtcon ConsoleOut0.rtc:in ConsoleOut1.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: each is a DataInPort; a connection needs an in port and an out port
  [2]
  $ rtcon ConsoleIn0.rtc:out ConsoleIn1.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleIn1.rtc:out: each is a DataOutPort; a connection needs an in port and an out port
  [2]
  $ rtcon ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: a data port alone; name another port, or the transport that carries its data: -p dataport.interface_type=ros, ros2, fast-rtps, ssm … (see --help)
  [2]
  $ rtcon ConsoleIn0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: a data port alone; name another port, or the transport that carries its data: -p dataport.interface_type=ros, ros2, fast-rtps, ssm … (see --help)
  [2]
  $ rtcon ConsoleIn0.rtc:out MyServiceProvider0.rtc:MyService
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: a data port and a service port do not go together
  [2]
  $ rtcon ConsoleIn0.rtc:out ConsoleIn0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: a port is named twice
  [2]
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: a port is named twice
  [2]

Properties that a port does not offer, with what it does:

  $ rtcon -p dataport.dataflow_type=Push ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: no port has dataflow_type Push (all have: push, pull, duplex)
  [2]
  $ rtcon -p dataport.interface_type=CORBA_CDR ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: no port has interface_type CORBA_CDR (all have: corba_cdr, csp_channel, data_service, direct, shared_memory)
  [2]
  $ rtcon -p dataport.interface_type=corba_cdr,direct ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: no port has interface_type corba_cdr,direct (all have: corba_cdr, csp_channel, data_service, direct, shared_memory)
  [2]
  $ rtcon -p dataport.subscription_type=sometimes ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out has no subscription_type sometimes (it has: block, flush, new, nonblock, periodic)
  [2]
  $ rtcon -p dataport.marshaling_types=json ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: dataport.marshaling_types: no such property; did you mean dataport.marshaling_type?
  [2]
  $ rtcon -p dataport.subscription_type=periodic ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: a periodic connection needs a rate: dataport.publisher.push_rate=HZ
  [2]
  $ rtcon -p dataport.subscription_type=periodic -p dataport.publisher.push_rate=often ConsoleIn0.rtc:out \
  >     ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: a periodic connection needs a rate in Hz above 0, not often
  [2]
  $ rtcon -p dataport.subscription_type=periodic -p dataport.push_rate=0 ConsoleIn0.rtc:out \
  >     ConsoleOut0.rtc:in --dry-run
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: a periodic connection needs a rate in Hz above 0, not 0
  [2]
  $ rtprint --property dataport.subscription_type=periodic ConsoleIn0.rtc:out
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: a periodic connection needs a rate: dataport.publisher.push_rate=HZ
  [2]
  $ rtlog -f log --property dataport.subscription_type=periodic \
  >     --property dataport.publisher.push_rate=-1 ConsoleIn0.rtc:out
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: a periodic connection needs a rate in Hz above 0, not -1
  [2]
  $ calls | grep -E ' (connect|notify_connect)$'
  [1]

What only the component knows, it refuses itself:

  $ rtcon -p dataport.interface_type=direct ConsoleIn0.rtc:out Mock0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/Mock0.rtc:in: refused by the component (RTC_ERROR)
  [6]
  $ rtcon -p dataport.serializer.cdr.endian=middle ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: refused by the component (RTC_ERROR)
  [6]
  $ rtcon -p dataport.marshaling_types=json ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: dataport.marshaling_types: no such property; did you mean dataport.marshaling_type?
  [2]
  $ rtcon -p dataport.fan_out=0 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: refused by the component (PRECONDITION_NOT_MET)
  [6]
  $ rtcon -p dataport.serializer.cdr.endian=middle ConsoleOut0.rtc:in ConsoleIn0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: refused by the component (RTC_ERROR)
  [6]

Nothing is left of all that:

  $ ctl connectors ConsoleIn0:out
  $ ctl connectors ConsoleOut0:in
  $ ctl @these connectors Mock0:in

Nor does an attempt that fails touch another connection:

  $ rtcon -i good ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon -p dataport.marshaling_type=json ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: refused by the component (RTC_ERROR)
  [6]
  $ ctl connectors ConsoleIn0:out
  good outin
  $ ctl connectors ConsoleOut0:in
  good outin
  $ ctl connectors ConsoleOut1:in

Dead and silent peers:

  $ kill-mock these2; hang these3
  $ rtcon ConsoleIn0.rtc:out Dead0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ within 4-8 rtcon --timeout 4 ConsoleIn0.rtc:out Hung0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/Hung0.rtc: no answer within 4s
  [4]
  $ within 4-8 rtcon --timeout 4 Nope0.rtc:out Hung0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  rtcon: /localhost:$PORT/test.host_cxt/Hung0.rtc: no answer within 4s
  [5]
  $ interrupt 0.5 rtcon ConsoleIn0.rtc:out Hung0.rtc:in
  [130]
  $ wake these3
  $ rtdis ConsoleIn0.rtc
  $ ctl fail connect 1 UNKNOWN; rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: CORBA.UNKNOWN
  [6]
  $ ctl fail connect 1 COMM_FAILURE; rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: connection lost
  [4]
  $ ctl fail connect 1 HANG; within 4-8 rtcon --timeout 4 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: no answer within 4s
  [4]
  $ ctl fail get_port_profile 1 TRANSIENT; rtcon -i once-more ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ ctl connectors ConsoleIn0:out
  once-more outin

The component that dies of being asked for its profile at the wrong time stays alive:

  $ rtcon -d -i alive Fragile0.rtc:out ConsoleOut1.rtc:in
  $ ctl @fragile connectors Fragile0:out
  alive outin

Usage, and no such port:

  $ rtcon
  rtcon: the following arguments are required: PATH:PORT (see --help)
  [2]
  $ rtcon ConsoleIn0.rtc ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no source port specified; these fit: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in (see --help)
  [2]
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no destination port specified; these fit: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in (see --help)
  [2]
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in/
  rtcon: ConsoleOut0.rtc:in/: a port has no directory below it
  [2]
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:input
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no such port: input (its ports: in)
  [3]
  $ rtcon ConsoleIn0.rtc:in ConsoleOut0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such port: in (its ports: out)
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no such port: out (its ports: in)
  [3]
  $ rtcon ConsoleIn0.rtc:out ConsoleOutX.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOutX.rtc: no such path; did you mean ConsoleOut1.rtc?
  [3]
  $ rtcon ConsoleIn0.rtc:out ../test.host_cxt:in
  rtcon: /localhost:$PORT/test.host_cxt: not a component (it is a directory)
  [3]
  $ rtcon /:out ConsoleOut0.rtc:in
  rtcon: /:out: :out is not a name server (host or host:tcpport)
  [2]
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in -i
  rtcon: argument -i/--id: expected one argument (see --help)
  [2]
