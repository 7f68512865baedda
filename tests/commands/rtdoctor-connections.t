rtdoctor looks at each connection from all its ends.

world: crossed
world: orphan --context lost.host_cxt/%n.rtc
world: fragile --context fragile.host_cxt/%n.rtc
world: these ConsoleIn:Near0 --context near.host_cxt/%n.rtc
world: these ConsoleOut:Far0 --context far.host_cxt/%n.rtc
world: linked --flavour cpp11 --context old.host_cxt/%n.rtc
world: linked --flavour cpp2 --context new.host_cxt/%n.rtc
world: linked --flavour rtorb --context small.host_cxt/%n.rtc
world: services --context service.host_cxt/%n.rtc
both: each ORB tells what is dead in its own way

  $ doctor() {
  >     rtdoctor "$@" > out
  >     code=$?
  >     grep -v -e "here: " -e " failed, " -e "^[a-z]* *[^ ]*$PORT: [as][nl]" out
  >     return $code
  > }
  $ rtact ../far.host_cxt/Far0.rtc

One-sided; told differently at both ends; of different types; left by a tool that has been killed:

  $ doctor -q .
  fail  /localhost:$PORT/test.host_cxt/Have0.rtc:MyService: connected to /localhost:$PORT/test.host_cxt/Have1.rtc:MyService: each end provides something, and none requires anything; try: rtdis -i $UUID /localhost:$PORT/test.host_cxt/Have0.rtc:MyService
  fail  /localhost:$PORT/test.host_cxt/Have1.rtc:MyService: connected to /localhost:$PORT/test.host_cxt/Want3.rtc:MyService: nobody in it provides interface myservice0 (MyService), which /localhost:$PORT/test.host_cxt/Want3.rtc:MyService requires; try: rtdis -i $UUID /localhost:$PORT/test.host_cxt/Have1.rtc:MyService
  fail  /localhost:$PORT/test.host_cxt/In0.rtc:out: connection out_in is one-sided: /localhost:$PORT/test.host_cxt/Out0.rtc:in does not know it; try: rtdis -i $UUID /localhost:$PORT/test.host_cxt/In0.rtc:out; rtcon -n out_in -p dataport.dataflow_type=push -p dataport.interface_type=corba_cdr -p dataport.subscription_type=flush /localhost:$PORT/test.host_cxt/In0.rtc:out /localhost:$PORT/test.host_cxt/Out0.rtc:in
  fail  /localhost:$PORT/test.host_cxt/Out2.rtc:in: connected to /localhost:$PORT/test.host_cxt/Sensor0.rtc:out: data types differ (RTC/TimedLong, RTC/TimedFloat); try: rtdis -i $UUID /localhost:$PORT/test.host_cxt/Out2.rtc:in
  fail  /localhost:$PORT/test.host_cxt/Want0.rtc:MyService: connected to /localhost:$PORT/test.host_cxt/Want1.rtc:MyService: nobody in it provides interface myservice0 (MyService), which /localhost:$PORT/test.host_cxt/Want0.rtc:MyService requires; try: rtdis -i $UUID /localhost:$PORT/test.host_cxt/Want0.rtc:MyService
  fail  /localhost:$PORT/test.host_cxt/Want0.rtc:MyService: connected to /localhost:$PORT/test.host_cxt/Want1.rtc:MyService: nobody in it provides interface myservice0 (MyService), which /localhost:$PORT/test.host_cxt/Want1.rtc:MyService requires; try: rtdis -i $UUID /localhost:$PORT/test.host_cxt/Want0.rtc:MyService
  warn  /: all components are Inactive: nothing has been started; try: activate those that are to move (rtact), or the whole system by its file (rtstart)
  warn  /localhost:$PORT/test.host_cxt/In1.rtc:out: dataport.subscription_type is flush here, new at /localhost:$PORT/test.host_cxt/Out1.rtc:in; try: rtdis -i $UUID /localhost:$PORT/test.host_cxt/In1.rtc:out; rtcon -n out_in -p dataport.dataflow_type=push -p dataport.interface_type=corba_cdr -p dataport.subscription_type=flush /localhost:$PORT/test.host_cxt/In1.rtc:out /localhost:$PORT/test.host_cxt/Out1.rtc:in
  [1]

The kind of finding is in the JSON:

  $ rtdoctor --json . | grep one-sided | grep -o '"check": "[^"]*"'
  "check": "connection"

What it says can be pasted:

  $ doctor -q . | sed -n 's/.*one-sided.*; try: //p' > mend; sh ./mend
  $ doctor -q . | grep In0.rtc
  [1]

Far ends that are dead: a component drops such connections when it is asked for its ports, and some report it. This
ends no component of C++ 2.1, which is asked in the right order:

  $ doctor -q ../lost.host_cxt/Orphan0.rtc
  warn  /localhost:$PORT/lost.host_cxt/Orphan0.rtc:out: had a connection whose far end is dead, and dropped it when asked; try: restart the far end and connect it again: rtcon
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/lost.host_cxt/Orphan0.rtc
  $ doctor -q ../lost.host_cxt/Orphan0.rtc
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/lost.host_cxt/Orphan0.rtc
  $ doctor -q ../fragile.host_cxt/Fragile0.rtc
  warn  /localhost:$PORT/fragile.host_cxt/Fragile0.rtc:out: had a connection whose far end is dead, and dropped it when asked; try: restart the far end and connect it again: rtcon
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/fragile.host_cxt/Fragile0.rtc
  $ rtls ../fragile.host_cxt
  Fragile0.rtc
  *Peer0.rtc

A far end that is not below the path is asked all the same, and may be gone when it is asked, refuse, or hang:

  $ rtcon -n c ../near.host_cxt/Near0.rtc:out ../far.host_cxt/Far0.rtc:in
  $ rtact ../near.host_cxt/Near0.rtc; ctl @these2 reset
  $ doctor ../near.host_cxt
  ok    /localhost:$PORT/near.host_cxt/Near0.rtc: Active, claims 1000 Hz, 1 port, 1 connection, at 127.0.0.1:* (glob)
  $ calls @these2 | grep -v -e put
  2 _non_existent
  1 get_port_profile
  $ for each in 1 2; do ctl @these2 fail get_port_profile $each OBJECT_NOT_EXIST; done
  $ doctor -q ../near.host_cxt
  fail  /localhost:$PORT/near.host_cxt/Near0.rtc:out: the far end of a connection is dead (at 127.0.0.1:*); try: rtdis -i $UUID /localhost:$PORT/near.host_cxt/Near0.rtc:out (glob)
  [1]
  $ ctl @these2 fail get_port_profile 1 NO_PERMISSION; doctor -q ../near.host_cxt
  fail  /localhost:$PORT/near.host_cxt/Near0.rtc:out: the far end of a connection, at 127.0.0.1:*, cannot be asked (CORBA.NO_PERMISSION); try: restart the process of the far end; netstat -ltnp | grep :* there names it (glob)
  [1]
  $ ctl @these2 delay get_port_profile 30
  $ within 0.4-2 rtdoctor -q --timeout 0.5 ../near.host_cxt | grep Near
  fail  /localhost:$PORT/near.host_cxt/Near0.rtc:out: the far end of a connection, at 127.0.0.1:*, cannot be asked (no answer within 0.5s); try: restart the process of the far end; netstat -ltnp | grep :* there names it (glob)
  $ ctl @these2 delay get_port_profile 0

A far end whose process hangs makes the near one hang, too, for it looks whether its far ends are there:

  $ hang these2
  $ within 2-6 rtdoctor -q --timeout 2 ../near.host_cxt ../far.host_cxt | grep rtc
  fail  /localhost:$PORT/far.host_cxt/Far0.rtc: hung: 127.0.0.1:* accepts TCP, but no answer within 2s; try: restart it; netstat -ltnp | grep :* there names its process (glob)
  fail  /localhost:$PORT/near.host_cxt/Near0.rtc: hangs when asked for the profile of its port 1, waiting for a far end that does not answer; try: mend /localhost:$PORT/far.host_cxt/Far0.rtc first
  $ wake these2

Of several that hang, it waits for the one that its process calls:

  $ mock these Mock:Alien0 --context alien.host_cxt/%n.rtc; hang these2 these3
  $ within 2-7 rtdoctor -q --timeout 2 ../near.host_cxt ../far.host_cxt ../alien.host_cxt | grep Near
  fail  /localhost:$PORT/near.host_cxt/Near0.rtc: hangs when asked for the profile of its port 1, waiting for a far end that does not answer; try: mend /localhost:$PORT/far.host_cxt/Far0.rtc first
  $ wake these2 these3

It is found, wherever it is bound, or bound nowhere; an inactive component keeps a connection that the other end has forgotten:

  $ rtdeact --wait ../near.host_cxt/Near0.rtc; rtdis ../near.host_cxt/Near0.rtc
  $ rtcon -i one ../near.host_cxt/Near0.rtc:out ../far.host_cxt/Far0.rtc:in
  $ ctl @these2 forget Far0:in; doctor -q ../near.host_cxt
  fail  /localhost:$PORT/near.host_cxt/Near0.rtc:out: connection outin is one-sided: /localhost:$PORT/far.host_cxt/Far0.rtc:in does not know it; try: rtdis -i one /localhost:$PORT/near.host_cxt/Near0.rtc:out; rtcon -n outin -p dataport.dataflow_type=push -p dataport.interface_type=corba_cdr -p dataport.subscription_type=new /localhost:$PORT/near.host_cxt/Near0.rtc:out /localhost:$PORT/far.host_cxt/Far0.rtc:in
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/near.host_cxt/Near0.rtc
  [1]
  $ rtdel -f ../far.host_cxt/Far0.rtc; doctor -q ../near.host_cxt
  fail  /localhost:$PORT/near.host_cxt/Near0.rtc:out: connection outin is one-sided: Far0.in at 127.0.0.1:*, bound nowhere, does not know it; try: disconnect it (rtdis -i one /localhost:$PORT/near.host_cxt/Near0.rtc:out), then connect its ends again: rtcon (glob)
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/near.host_cxt/Near0.rtc
  [1]
  $ rtdis ../near.host_cxt/Near0.rtc

Connections that are well, of all kinds:

  $ rtcon ../service.host_cxt/MyServiceConsumer0.rtc:MyService \
  >     ../service.host_cxt/MyServiceProvider0.rtc:MyService
  $ for each in old new small service; do doctor ../$each.host_cxt; done
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/old.host_cxt/ConsoleIn0.rtc /localhost:$PORT/old.host_cxt/ConsoleOut0.rtc
  ok    /localhost:$PORT/old.host_cxt/ConsoleIn0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/old.host_cxt/ConsoleOut0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 127.0.0.1:* (glob)
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/new.host_cxt/ConsoleIn0.rtc /localhost:$PORT/new.host_cxt/ConsoleOut0.rtc
  ok    /localhost:$PORT/new.host_cxt/ConsoleIn0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/new.host_cxt/ConsoleOut0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 127.0.0.1:* (glob)
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/small.host_cxt/ConsoleIn0.rtc /localhost:$PORT/small.host_cxt/ConsoleOut0.rtc
  ok    /localhost:$PORT/small.host_cxt/ConsoleIn0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/small.host_cxt/ConsoleOut0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 127.0.0.1:* (glob)
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/service.host_cxt/MyServiceConsumer0.rtc /localhost:$PORT/service.host_cxt/MyServiceProvider0.rtc
  ok    /localhost:$PORT/service.host_cxt/MyServiceConsumer0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/service.host_cxt/MyServiceProvider0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 127.0.0.1:* (glob)

In ports that refuse values, as their full buffers do not overwrite: known where nothing reads them, probable where --measure
finds that more is written than the component executes:

  $ mock senders 100 --context flow.host_cxt/%n.rtc
  $ mock these ConsoleOut:Slow0 --rate 10 --context flow.host_cxt/%n.rtc
  $ full() {
  >     rtcon -p dataport.subscription_type=flush -p $1 ../flow.host_cxt/Source0.rtc:number \
  >         ../flow.host_cxt/Slow0.rtc:in
  > }
  $ full dataport.buffer.write.full_policy=overwrite; rtdoctor -q --measure ../flow.host_cxt | grep buffer
  [1]
  $ rtdis ../flow.host_cxt/Source0.rtc; full dataport.buffer.write.full_policy=do_nothing
  $ rtdoctor -q ../flow.host_cxt | grep buffer
  warn  /localhost:$PORT/flow.host_cxt/Slow0.rtc:in: nothing reads the values of /localhost:$PORT/flow.host_cxt/Source0.rtc:number: its buffer refuses what it has no room for, once it is full (do_nothing); try: if it is to move, activate it: rtact /localhost:$PORT/flow.host_cxt/Slow0.rtc
  $ rtact --wait ../flow.host_cxt/Slow0.rtc; rtdoctor -q ../flow.host_cxt | grep buffer
  [1]
  $ rtdoctor -q --measure ../flow.host_cxt | grep buffer
  warn  /localhost:$PORT/flow.host_cxt/Slow0.rtc:in: the values of /localhost:$PORT/flow.host_cxt/Source0.rtc:number probably find its buffer full (* Hz are written, it executes at 10 Hz), which refuses what it has no room for (do_nothing); try: raise the rate of its context (rtec /localhost:$PORT/flow.host_cxt/Slow0.rtc rate HZ), or, if old values may go, connect it with -p dataport.buffer.write.full_policy=overwrite (glob)
  $ rtdis ../flow.host_cxt/Source0.rtc
  $ full dataport.inport.buffer.write.full_policy=block
  rtcon: /localhost:$PORT/flow.host_cxt/Source0.rtc:number to /localhost:$PORT/flow.host_cxt/Slow0.rtc:in: writers wait while its buffer is full (full_policy=block): remove it only while its source is Inactive, as rtdis does
  $ rtdoctor -q --measure ../flow.host_cxt | grep buffer
  warn  /localhost:$PORT/flow.host_cxt/Slow0.rtc:in: the values of /localhost:$PORT/flow.host_cxt/Source0.rtc:number probably find its buffer full (100 Hz are written, it executes at 10 Hz), which makes its writers wait (block); try: raise the rate of its context (rtec /localhost:$PORT/flow.host_cxt/Slow0.rtc rate HZ), or, if old values may go, connect it with -p dataport.buffer.write.full_policy=overwrite (glob)
  $ rtdoctor --json --measure ../flow.host_cxt | grep -c '"check": "buffer"'
  1
  $ rtec ../flow.host_cxt/Slow0.rtc rate 200; rtdoctor -q --measure ../flow.host_cxt | grep buffer
  [1]
