rtdoctor looks at each connection from all its ends.

world: crossed
world: these ConsoleIn:Near0 --context near.host_cxt/%n.rtc
world: these ConsoleOut:Far0 --context far.host_cxt/%n.rtc
world: linked --flavour cpp11 --context old.host_cxt/%n.rtc
world: linked --flavour cpp2 --context new.host_cxt/%n.rtc
world: linked --flavour rtorb --context small.host_cxt/%n.rtc
world: services --context service.host_cxt/%n.rtc

  $ rtact ../far.host_cxt/Far0.rtc

One-sided; told differently at both ends; of different types; left by a tool that has been killed; what would mend them:

  $ rtdoctor -q .
  fail  /robot/test.host_cxt/Have0.rtc:MyService: connected to /robot/test.host_cxt/Have1.rtc:MyService: each end provides something, and none requires anything; try: rtdis -i $UUID /robot/test.host_cxt/Have0.rtc:MyService
  fail  /robot/test.host_cxt/Have1.rtc:MyService: connected to /robot/test.host_cxt/Want3.rtc:MyService: nobody in it provides interface myservice0 (MyService), which /robot/test.host_cxt/Want3.rtc:MyService requires; try: rtdis -i $UUID /robot/test.host_cxt/Have1.rtc:MyService
  fail  /robot/test.host_cxt/In0.rtc:out: connection out_in is one-sided: /robot/test.host_cxt/Out0.rtc:in does not know it; try: rtdis -i $UUID /robot/test.host_cxt/In0.rtc:out; rtcon -n out_in -p dataport.dataflow_type=push -p dataport.interface_type=corba_cdr -p dataport.subscription_type=flush /robot/test.host_cxt/In0.rtc:out /robot/test.host_cxt/Out0.rtc:in
  fail  /robot/test.host_cxt/Out2.rtc:in: connected to /robot/test.host_cxt/Sensor0.rtc:out: data types differ (RTC/TimedLong, RTC/TimedFloat); try: rtdis -i $UUID /robot/test.host_cxt/Out2.rtc:in
  fail  /robot/test.host_cxt/Want0.rtc:MyService: connected to /robot/test.host_cxt/Want1.rtc:MyService: nobody in it provides interface myservice0 (MyService), which /robot/test.host_cxt/Want0.rtc:MyService requires; try: rtdis -i $UUID /robot/test.host_cxt/Want0.rtc:MyService
  fail  /robot/test.host_cxt/Want0.rtc:MyService: connected to /robot/test.host_cxt/Want1.rtc:MyService: nobody in it provides interface myservice0 (MyService), which /robot/test.host_cxt/Want1.rtc:MyService requires; try: rtdis -i $UUID /robot/test.host_cxt/Want0.rtc:MyService
  warn  /: all components examined are Inactive: none has been started; try: activate those that are to move (rtact), or the whole system by its file (rtstart)
  warn  /robot/test.host_cxt/In1.rtc:out: dataport.subscription_type is flush here, new at /robot/test.host_cxt/Out1.rtc:in; try: rtdis -i $UUID /robot/test.host_cxt/In1.rtc:out; rtcon -n out_in -p dataport.dataflow_type=push -p dataport.interface_type=corba_cdr -p dataport.subscription_type=flush /robot/test.host_cxt/In1.rtc:out /robot/test.host_cxt/Out1.rtc:in
  [1]

Far ends that are dead: a component drops such connections when it is asked for its ports, and some report it. This
ends no component of C++ 2.1, which is asked in the right order:

  $ mock these ConsoleIn:Orphan0 --context lost.host_cxt/%n.rtc
  $ mock these ConsoleIn:Fragile0 --flavour cpp2 --context lost.host_cxt/%n.rtc
  $ mock these ConsoleOut:Peer0 --context lost.host_cxt/%n.rtc
  $ rtcon ../lost.host_cxt/Orphan0.rtc:out ../lost.host_cxt/Peer0.rtc:in
  $ rtcon ../lost.host_cxt/Fragile0.rtc:out ../lost.host_cxt/Peer0.rtc:in
  $ kill these5
  $ rtdoctor -q ../lost.host_cxt/Orphan0.rtc
  warn  /robot/lost.host_cxt/Orphan0.rtc:out: had a connection whose far end is dead, and dropped it when asked; try: restart the far end and connect it again: rtcon
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/lost.host_cxt/Orphan0.rtc
  $ rtdoctor -q ../lost.host_cxt/Orphan0.rtc
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/lost.host_cxt/Orphan0.rtc
  $ rtdoctor -q ../lost.host_cxt/Fragile0.rtc
  warn  /robot/lost.host_cxt/Fragile0.rtc:out: had a connection whose far end is dead, and dropped it when asked; try: restart the far end and connect it again: rtcon
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/lost.host_cxt/Fragile0.rtc
  $ rtls ../lost.host_cxt
  Fragile0.rtc
  Orphan0.rtc
  *Peer0.rtc

A far end that is not below the path is asked all the same, and may be gone when it is asked, refuse, or hang:

  $ rtcon -n c ../near.host_cxt/Near0.rtc:out ../far.host_cxt/Far0.rtc:in
  $ rtact ../near.host_cxt/Near0.rtc
  $ ctl @these2 reset
  $ rtdoctor ../near.host_cxt
  ok    here: Python 3.* (glob)
  ok    here: this host's name, robot, means 10.0.0.1
  ok    here: RTCTREE_NAMESERVERS: robot
  ok    /robot: answers (name 0.0 ms, TCP 0.1 ms, CORBA 5.1 ms, naming 0.1 ms) at 10.0.0.1, this host
  ok    /robot/near.host_cxt/Near0.rtc: Active, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  0 failed, 0 to be looked at, 5 ok
  $ calls @these2
  1 get_port_profile
  $ ctl @these2 fail get_port_profile 1 OBJECT_NOT_EXIST
  $ ctl @these2 fail get_port_profile 2 OBJECT_NOT_EXIST
  $ rtdoctor -q ../near.host_cxt
  fail  /robot/near.host_cxt/Near0.rtc:out: the far end of a connection is dead (at 10.0.0.1:$PORT); try: rtdis -i $UUID /robot/near.host_cxt/Near0.rtc:out
  [1]
  $ ctl @these2 fail get_port_profile 1 NO_PERMISSION
  $ rtdoctor -q ../near.host_cxt
  fail  /robot/near.host_cxt/Near0.rtc:out: the far end of a connection, at 10.0.0.1:$PORT, cannot be asked (CORBA.NO_PERMISSION); try: restart the process of the far end; netstat -ltnp | grep :$PORT there names it
  [1]
  $ ctl @these2 delay get_port_profile 30
  $ rtdoctor -q --timeout 0.5 ../near.host_cxt
  fail  /robot/near.host_cxt/Near0.rtc:out: the far end of a connection, at 10.0.0.1:$PORT, cannot be asked (no answer within 0.5s); try: restart the process of the far end; netstat -ltnp | grep :$PORT there names it
  [1] after 0.6 s
  $ ctl @these2 delay get_port_profile 0

A far end whose process hangs makes the near one hang, too, for it looks whether its far ends are there:

  $ hang these2
  $ rtdoctor -q --timeout 2 ../near.host_cxt ../far.host_cxt
  fail  /robot/far.host_cxt/Far0.rtc: hung: 10.0.0.1:$PORT accepts TCP, but no answer within 2s; try: restart it; netstat -ltnp | grep :$PORT there names its process
  fail  /robot/near.host_cxt/Near0.rtc: hangs when asked for the profile of its port 1, maybe waiting for a far end that does not answer; try: mend /robot/far.host_cxt/Far0.rtc first
  [1] after 4.4 s
  $ wake these2

It is found, wherever it is bound, or bound nowhere; an inactive component keeps a connection that the other end has forgotten:

  $ rtdeact --wait ../near.host_cxt/Near0.rtc
  $ rtdis ../near.host_cxt/Near0.rtc
  $ rtcon -i one ../near.host_cxt/Near0.rtc:out ../far.host_cxt/Far0.rtc:in
  $ ctl @these2 forget Far0:in
  $ rtdoctor -q ../near.host_cxt
  fail  /robot/near.host_cxt/Near0.rtc:out: connection outin is one-sided: /robot/far.host_cxt/Far0.rtc:in does not know it; try: rtdis -i one /robot/near.host_cxt/Near0.rtc:out; rtcon -n outin -p dataport.dataflow_type=push -p dataport.interface_type=corba_cdr -p dataport.subscription_type=new /robot/near.host_cxt/Near0.rtc:out /robot/far.host_cxt/Far0.rtc:in
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/near.host_cxt/Near0.rtc
  [1]
  $ rtdel -f ../far.host_cxt/Far0.rtc
  $ rtdoctor -q ../near.host_cxt
  fail  /robot/near.host_cxt/Near0.rtc:out: connection outin is one-sided: Far0.in at 10.0.0.1:$PORT, bound nowhere, does not know it; try: disconnect it (rtdis -i one /robot/near.host_cxt/Near0.rtc:out), then connect its ends again: rtcon
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/near.host_cxt/Near0.rtc
  [1]
  $ rtdis ../near.host_cxt/Near0.rtc

Connections that are well, of all kinds:

  $ rtcon ../service.host_cxt/MyServiceConsumer0.rtc:MyService ../service.host_cxt/MyServiceProvider0.rtc:MyService
  $ rtdoctor ../old.host_cxt ../new.host_cxt ../small.host_cxt ../service.host_cxt
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/new.host_cxt/ConsoleIn0.rtc /robot/new.host_cxt/ConsoleOut0.rtc /robot/old.host_cxt/ConsoleIn0.rtc /robot/old.host_cxt/ConsoleOut0.rtc /robot/service.host_cxt/MyServiceConsumer0.rtc /robot/service.host_cxt/MyServiceProvider0.rtc /robot/small.host_cxt/ConsoleIn0.rtc /robot/small.host_cxt/ConsoleOut0.rtc
  ok    here: Python 3.11.7, builtin ORB
  ok    here: this host's name, robot, means 10.0.0.1
  ok    here: RTCTREE_NAMESERVERS: robot
  ok    /robot: answers (name 0.0 ms, TCP 0.1 ms, CORBA 5.1 ms, naming 0.1 ms) at 10.0.0.1, this host
  ok    /robot/new.host_cxt/ConsoleIn0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  ok    /robot/new.host_cxt/ConsoleOut0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  ok    /robot/old.host_cxt/ConsoleIn0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  ok    /robot/old.host_cxt/ConsoleOut0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  ok    /robot/service.host_cxt/MyServiceConsumer0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  ok    /robot/service.host_cxt/MyServiceProvider0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  ok    /robot/small.host_cxt/ConsoleIn0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  ok    /robot/small.host_cxt/ConsoleOut0.rtc: Inactive, claims 1000 Hz, 1 port, 1 connection, at 10.0.0.1:$PORT
  0 failed, 1 to be looked at, 12 ok

In ports that refuse values, as their full buffers do not overwrite: known where nothing reads them, probable where --measure
finds that more is written than the component executes:

  $ mock senders 100 --context flow.host_cxt/%n.rtc
  $ mock these ConsoleOut:Slow0 --rate 10 --context flow.host_cxt/%n.rtc
  $ rtcon -p dataport.subscription_type=flush -p dataport.buffer.write.full_policy=overwrite ../flow.host_cxt/Source0.rtc:number ../flow.host_cxt/Slow0.rtc:in
  $ rtdoctor -q --measure ../flow.host_cxt
  warn  /robot/flow.host_cxt/Slow0.rtc: Inactive, while 1 component of its system is Active; it may have been reset; try: if it is to move, activate it: rtact /robot/flow.host_cxt/Slow0.rtc
  [0] after 1.1 s
  $ rtdis ../flow.host_cxt/Source0.rtc
  $ rtcon -p dataport.subscription_type=flush -p dataport.buffer.write.full_policy=do_nothing ../flow.host_cxt/Source0.rtc:number ../flow.host_cxt/Slow0.rtc:in
  $ rtdoctor -q ../flow.host_cxt
  warn  /robot/flow.host_cxt/Slow0.rtc: Inactive, while 1 component of its system is Active; it may have been reset; try: if it is to move, activate it: rtact /robot/flow.host_cxt/Slow0.rtc
  warn  /robot/flow.host_cxt/Slow0.rtc:in: nothing reads the values of /robot/flow.host_cxt/Source0.rtc:number: its buffer refuses what it has no room for, once it is full (do_nothing); try: if it is to move, activate it: rtact /robot/flow.host_cxt/Slow0.rtc
  $ rtact --wait ../flow.host_cxt/Slow0.rtc
  [0] after 0.2 s
  $ rtdoctor -q ../flow.host_cxt
  $ rtdoctor -q --measure ../flow.host_cxt
  warn  /robot/flow.host_cxt/Slow0.rtc:in: the values of /robot/flow.host_cxt/Source0.rtc:number probably find its buffer full (101 Hz are written, it executes at 10 Hz), which refuses what it has no room for (do_nothing); try: raise the rate of its context (rtec /robot/flow.host_cxt/Slow0.rtc rate HZ), or, if old values may go, connect it with -p dataport.buffer.write.full_policy=overwrite
  [0] after 1.1 s
  $ rtdis ../flow.host_cxt/Source0.rtc
  $ rtcon -p dataport.subscription_type=flush -p dataport.inport.buffer.write.full_policy=block ../flow.host_cxt/Source0.rtc:number ../flow.host_cxt/Slow0.rtc:in
  ! rtcon: /robot/flow.host_cxt/Source0.rtc:number to /robot/flow.host_cxt/Slow0.rtc:in: writers wait while its buffer is full (full_policy=block): remove it only while its source is Inactive, as rtdis does
  $ rtdoctor -q --measure ../flow.host_cxt
  warn  /robot/flow.host_cxt/Source0.rtc: keeps 9.0 of 100 Hz, or does not write to number in each cycle; try: look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 10.0.0.1)
  warn  /robot/flow.host_cxt/Slow0.rtc:in: the values of /robot/flow.host_cxt/Source0.rtc:number probably find its buffer full (100 Hz are written, it executes at 10 Hz), which makes its writers wait (block); try: raise the rate of its context (rtec /robot/flow.host_cxt/Slow0.rtc rate HZ), or, if old values may go, connect it with -p dataport.buffer.write.full_policy=overwrite
  warn  /robot/flow.host_cxt/Slow0.rtc:in: connection $UUID makes its writers wait (full_policy=block): to remove it while one of them is Active may end this process; try: before you remove it: rtdeact /robot/flow.host_cxt/Source0.rtc (rtdis then waits until no value waits)
  [0] after 1.1 s
  $ rtdoctor --json --measure ../flow.host_cxt
  …
  {.*"check": "buffer".*} (re)
  …
  [0] after 1.1 s
  $ rtec ../flow.host_cxt/Slow0.rtc rate 200
  $ rtdoctor -q --measure ../flow.host_cxt
  warn  /robot/flow.host_cxt/Slow0.rtc:in: connection $UUID makes its writers wait (full_policy=block): to remove it while one of them is Active may end this process; try: before you remove it: rtdeact /robot/flow.host_cxt/Source0.rtc (rtdis then waits until no value waits)
  [0] after 1.1 s
