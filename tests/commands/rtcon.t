rtcon connects ports.

world: console
world: these Mock:Mock0 ConsoleIn:ConsoleIn1 Motor

  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcat -ll ConsoleIn0.rtc:out | sed -n '/Connected/,$p'
   -Connected to  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
      Name                            outin
      ID                              $UUID
      dataport.data_type              IDL:RTC/TimedLong:1.0
      dataport.dataflow_type          push
      dataport.interface_type         corba_cdr
      dataport.subscription_type      new
      dataport.serializer.cdr.endian  little,big
      dataport.outport.data_type      IDL:RTC/TimedLong:1.0
      dataport.inport.data_type       IDL:RTC/TimedLong:1.0

What OpenRTM-aist does not know is passed on, as a component may, but noted:

  $ rtcon --dry-run -p push_policy=new -p timeout=1 -p mine=2 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: push_policy: OpenRTM-aist has no such property, but dataport.publisher.push_policy
  rtcon: timeout: OpenRTM-aist has no such property, but dataport.buffer.write.timeout and dataport.buffer.read.timeout
  rtcon -p mine=2 -p push_policy=new -p timeout=1 /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ rtcon --dry-run -p inport.length=4 -p outport.buffer.size=3 -p mine.length=2 \
  >     ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: inport.length: OpenRTM-aist has no such property, but dataport.inport.buffer.length
  rtcon: outport.buffer.size: OpenRTM-aist has no such property; rtcon --help -v names some
  rtcon -p inport.length=4 -p mine.length=2 -p outport.buffer.size=3 /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ rtcon --dry-run -p dataport.outport.fast-rtps.topic=x ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon -p dataport.outport.fast-rtps.topic=x /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ rtcon --dry-run -p publisher.push_policy=newest -p inport.buffer.read.empty_policy=Block ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: dataport.publisher.push_policy: OpenRTM-aist has no newest (it has: all, fifo, skip, new)
  rtcon -p dataport.inport.buffer.read.empty_policy=Block -p dataport.publisher.push_policy=newest /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in

Data arrives:

  $ rtact ConsoleOut0.rtc
  $ ctl write ConsoleIn0:out 42; ctl received ConsoleOut0:in 1
  1 42

What it costs: of each component the list of its ports, each port's profile, and the request:

  $ rtdis ConsoleIn0.rtc; ctl reset
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ ctl calls ConsoleIn0
  1 connect
  1 get_port_profile
  1 get_ports

The component chooses the id; --verbose reports it:

  $ rtdis ConsoleIn0.rtc
  $ rtcon -v ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: connected, id $UUID

The order does not matter; options may follow the paths:

  $ rtdis ConsoleIn0.rtc
  $ ctl reset; rtcon ConsoleOut0.rtc:in ConsoleIn0.rtc:out -n backwards --id=b1
  $ ctl connectors ConsoleIn0:out
  b1 backwards
  $ ctl write ConsoleIn0:out 43; ctl received ConsoleOut0:in 2
  2 43

The out port is the one that is asked, and the first of the connection: ports disconnect in their order.

  $ ctl calls ConsoleIn0 | grep connect; ctl calls ConsoleOut0 | grep connect || echo none
  1 connect
  none
  $ rtdis ConsoleIn0.rtc

--name and --id may hold anything, a blank, a quote, an equals sign:

  $ rtcon -n 'a "name" = 日本' -i '$(id)' ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcat -ll ConsoleIn0.rtc:out | grep -E ' (Name|ID) '
      Name                            a "name" = 日本
      ID                              $(id)
  $ rtdis -i '$(id)' ConsoleIn0.rtc

--dry-run checks, prints a command that does it, and changes nothing:

  $ rtcon --dry-run -p 'a.key=x y=z' -n n -i i -p dataport.subscription_type=flush ConsoleIn0.rtc:out \
  >     ConsoleOut0.rtc:in
  rtcon -n n -i i -p 'a.key=x y=z' -p dataport.subscription_type=flush /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ ctl connectors ConsoleIn0:out
  $ rtcon --dry-run -p 'a.key=x y=z' -n n -i i -p dataport.subscription_type=flush ConsoleIn0.rtc:out \
  >     ConsoleOut0.rtc:in |
  >     sh
  $ rtcat -ll ConsoleIn0.rtc:out | grep -E 'a.key|subscr|ID'
    data_type                                IDL:RTC/TimedLong:1.0
    dataport.data_type                       IDL:RTC/TimedLong:1.0
    dataport.subscription_type               block,flush,new,nonblock,periodic
      ID                              i
      a.key                           x y=z
      dataport.data_type              IDL:RTC/TimedLong:1.0
      dataport.subscription_type      flush
      dataport.outport.data_type      IDL:RTC/TimedLong:1.0
      dataport.inport.data_type       IDL:RTC/TimedLong:1.0
  $ rtdis ConsoleIn0.rtc
  $ rtcon --dry-run ConsoleIn0.rtc:out SequenceInComponent0.rtc:Double
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Double: data types differ (RTC/TimedLong, RTC/TimedDouble)
  [2]

Properties: a value may hold an equals sign, or be empty; of two the last one counts:

  $ rtcon -p dataport.dataflow_type=pull -p dataport.buffer.length=3 -p 'x=a=b' \
  >     -p y= ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcat -ll ConsoleOut0.rtc:in | grep -E 'flow_type +pull|length|^    [xy]' | sed 's/ *$//'
      dataport.buffer.length          3
      dataport.dataflow_type          pull
      x                               a=b
      y
  $ rtdis ConsoleIn0.rtc

The properties that OpenRTM knows need no `dataport.`; one that is misspelt is refused, here and where commands make connections of
their own; what resembles none is the user's:

  $ rtcon --dry-run -p subscription_type=flush -p inport.buffer.length=3 -p mine=1 \
  >     -p dataport.mine=2 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon -p dataport.inport.buffer.length=3 -p dataport.mine=2 -p dataport.subscription_type=flush -p mine=1 /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ rtcon -p dataport.subscripton_type=flush ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: dataport.subscripton_type: no such property; did you mean dataport.subscription_type?
  [2]
  $ for key in Subscription_Type buffer.lenght publisher.rate; do
  >     for command in 'rtcon -p' 'rtprint --property' 'rtlog -f a --property'; do
  >         $command $key=1 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  >     done
  > done 2>&1 | uniq -f 1
  rtcon: Subscription_Type: no such property; did you mean dataport.subscription_type?
  rtcon: buffer.lenght: no such property; did you mean dataport.buffer.length?
  rtcon: publisher.rate: no such property; did you mean dataport.publisher.push_rate?
  $ rtinject -c 1 --property bufer.length=1 ConsoleOut0.rtc:in
  rtinject: bufer.length: no such property; did you mean dataport.buffer.length?
  [2]
  $ rtcon -p x=1 -p x=2 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: duplicate property, the last one counts: x=2
  $ rtcat -ll ConsoleOut0.rtc:in | grep -E '^    x'
      x                               2
  $ rtdis ConsoleIn0.rtc
  $ rtcon -q --property x=1 --property=x=2 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon -p novalue ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: not KEY=VALUE: novalue (see --help)
  [2]
  $ rtcon -p =novalue ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: not KEY=VALUE: =novalue (see --help)
  [2]

More than two ports make one connection:

  $ rtdis ConsoleIn0.rtc
  $ rtcon -i all ConsoleIn0.rtc:out ConsoleOut0.rtc:in ConsoleOut1.rtc:in
  $ ctl connectors ConsoleOut0:in; ctl connectors ConsoleOut1:in
  all outin_in
  all outin_in
  $ rtdis ConsoleIn0.rtc
  $ rtcon -v ConsoleOut0.rtc:in ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: connected, id $UUID
  $ rtdis ConsoleIn0.rtc

Connected already: OpenRTM refuses the same pair twice, unless told otherwise; -d refuses in any case:

  $ rtcon -n first -i id-1 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: already connected (id id-1)
  [6]
  $ rtcon -p buffer.write.full_policy=block -p subscription_type=new ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: already connected (id id-1: its dataport.buffer.write.full_policy is empty); to change that, first: rtdis -i id-1 /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  [6]
  $ said=$(rtcon -p buffer.length=4 ConsoleIn0.rtc:out ConsoleOut0.rtc:in 2>&1)
  [6]
  $ sh -c "${said##*first: }"; rtcon -p buffer.length=4 -n first -i id-1 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon -d ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: already connected (id id-1)
  [1]
  $ rtcon --no-duplicates ConsoleOut0.rtc:in ConsoleIn0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: already connected (id id-1)
  [1]
  $ rtcon -i id-1 ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: refused; id id-1 is in use, or the component takes no ids (RtORB)
  [6]
  $ rtcon -d -i id-1 ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: has a connection with id id-1 already
  [1]
  $ rtcon -d -n first ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: has a connection with name first already
  [1]
  $ rtcon -d -i id-1 ConsoleIn1.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: has a connection with id id-1 already
  [1]
  $ rtcon -d -n outin ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  $ rtcon -i twice -p dataport.allow_dup_connection=YES ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ ctl connectors ConsoleIn0:out
  id-1 first
  $UUID outin
  twice outin
  $ rtcon -d -p dataport.allow_dup_connection=YES ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: already connected (id id-1)
  [1]

--ensure leaves a connection that is as it is asked for, and refuses one that is otherwise:

  $ rtdis ConsoleIn0.rtc
  $ rtcon --ensure -v ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: connected, id $UUID
  $ rtcon --ensure -v ConsoleOut0.rtc:in ConsoleIn0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: connected already
  $ rtcon --ensure -n outin -p dataport.subscription_type=new ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon --ensure -p dataport.subscription_type=flush ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: connected otherwise (id $UUID: its dataport.subscription_type is new); to change that, first: rtdis -i $UUID /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  [1]
  $ rtcon --ensure --dry-run ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ ctl connectors ConsoleIn0:out
  $UUID outin
  $ rtcon --ensure --dry-run ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  rtcon /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A:out B:in
invocation: B:in A:out
invocation: --dry-run A:out B:in
looking: --dry-run A:out B:in
example: rtcon -p subscription_type=flush ConsoleIn0.rtc:out ConsoleOut0.rtc:in <- rtdis ConsoleIn0.rtc
example: rtcon -p dataport.interface_type=fast-rtps ConsoleIn0.rtc:out -> 2
