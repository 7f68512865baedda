rtresurrect --create lets managers create the components that are missing, and restores them.

world: manager SeqOut SeqIn Sensor Motor ConfigSample
world: two

  $ rtcon -i one -n n SequenceOutComponent0.rtc:Long SequenceInComponent0.rtc:Long
  $ rtcomp -a Sensor0.rtc:in -a Motor0.rtc:in,out manager.mgr:Arm
  $ rtcon -i two ConsoleIn0.rtc:out Arm.rtc:Sensor0.in
  $ rtconf ConfigSample0.rtc set str_param0=changed; rtec Motor0.rtc rate 250
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but changed does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  rtec: /localhost:$PORT/test.host_cxt/Motor0.rtc: this context is stopped; rtec lists those that execute it, -e N chooses one
  $ rtcryo --all > named.xml; grep -v -e '"MANAGER"' -e '"REFERENCE"' named.xml > a.xml
  $ grep -o 'name="MANAGER".*' named.xml | sort | uniq -c
        6 name="MANAGER" rtsExt:value="localhost:$PORT/test.host_cxt/manager.mgr"/>

  $ gone() {
  >     for c in Arm SequenceOutComponent0 SequenceInComponent0 Sensor0 Motor0 ConfigSample0; do
  >         rtmgr -d $c manager.mgr 2> /dev/null
  >     done
  >     rtdis ConsoleIn0.rtc
  > }
  $ same() { rtcryo --all | grep -v -e Date= -e '"MANAGER"' -e '"REFERENCE"' > b; grep -v Date= a.xml |
  > diff - b; }
  $ gone; rtresurrect a.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/Arm.rtc: no such path
  rtresurrect: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such path
  rtresurrect: /localhost:$PORT/test.host_cxt/Motor0.rtc: no such path
  rtresurrect: /localhost:$PORT/test.host_cxt/Sensor0.rtc: no such path
  rtresurrect: /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc: no such path
  rtresurrect: /localhost:$PORT/test.host_cxt/SequenceOutComponent0.rtc: no such path
  rtresurrect: 6 already done, 6 failed, 24 not tried
  [5]
  $ rtresurrect --create a.xml 2>&1 | head -2
  rtresurrect: /localhost:$PORT/test.host_cxt/Arm.rtc: is not there, and nothing names a manager to create it (see --manager)
  rtresurrect: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: is not there, and nothing names a manager to create it (see --manager)

The manager is given, and then does it; by hand with the commands of --dry-run, or at once:

  $ rtresurrect --create --manager manager.mgr --dry-run a.xml > script; grep -v -e rtconf -e rtec script
  rtmgr -c 'RTC:jp.go.aist:composite.PeriodicECShared:PeriodicECSharedComposite:Python:1.0?instance_name=Arm' --wait /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr -c 'RTC:Shinji Kurihara:example:ConfigSample:Python:1.0?instance_name=ConfigSample0' --wait /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr -c 'RTC:Shinji Kurihara, AIST:example:Motor:Python:1.0?instance_name=Motor0' --wait /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr -c 'RTC:Shinji Kurihara, AIST:example:Sensor:Python:1.0?instance_name=Sensor0' --wait /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr -c 'RTC:Shinji Kurihara:example:SeqIn:Python:1.0?instance_name=SequenceInComponent0' --wait /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr -c 'RTC:Shinji Kurihara:example:SeqOut:Python:1.0?instance_name=SequenceOutComponent0' --wait /localhost:$PORT/test.host_cxt/manager.mgr
  rtcomp -a /localhost:$PORT/test.host_cxt/Motor0.rtc -a /localhost:$PORT/test.host_cxt/Sensor0.rtc /localhost:$PORT/test.host_cxt/Arm.rtc
  rtcon -n outSensor0.in -i two -p dataport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.dataflow_type=push -p dataport.inport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.interface_type=corba_cdr -p dataport.outport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.serializer.cdr.endian=little,big -p dataport.subscription_type=new /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/Sensor0.rtc:in
  rtcon -n n -i one -p dataport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.dataflow_type=push -p dataport.inport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.interface_type=corba_cdr -p dataport.outport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.serializer.cdr.endian=little,big -p dataport.subscription_type=new /localhost:$PORT/test.host_cxt/SequenceOutComponent0.rtc:Long /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Long
  $ sh -e script
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but 12345 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param1 is set, but 98765 does not fit the component's constraint 0<=x<=1000
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: double_param0 is set, but 297992458 does not fit the component's constraint 0<=x<=100
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but -999 does not fit the component's constraint 0<=x<=150
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but changed does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  rtec: /localhost:$PORT/test.host_cxt/Motor0.rtc: this context is stopped; rtec lists those that execute it, -e N chooses one
  rtec: /localhost:$PORT/test.host_cxt/Sensor0.rtc: this context is stopped; rtec lists those that execute it, -e N chooses one
  $ same; gone
  $ rtresurrect --create --manager manager.mgr -v a.xml
  rtresurrect: component /localhost:$PORT/test.host_cxt/Arm.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: component /localhost:$PORT/test.host_cxt/ConfigSample0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: component /localhost:$PORT/test.host_cxt/Motor0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: component /localhost:$PORT/test.host_cxt/Sensor0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: component /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: component /localhost:$PORT/test.host_cxt/SequenceOutComponent0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: members Motor0, Sensor0 of /localhost:$PORT/test.host_cxt/Arm.rtc: done
  rtresurrect: configuration set default of /localhost:$PORT/test.host_cxt/Arm.rtc: done
  rtresurrect: configuration set mode1 of /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: done
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/Motor0.rtc: done
  rtresurrect: connection two of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/Sensor0.rtc:in: done
  rtresurrect: connection one of /localhost:$PORT/test.host_cxt/SequenceOutComponent0.rtc:Long to /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Long: done
  rtresurrect: 12 done, 24 already done
  $ same; rtresurrect --create --manager manager.mgr -v a.xml
  rtresurrect: 36 already done

If anything fails, --rollback deletes them again:

  $ gone; ctl @two fail connect 1 UNKNOWN
  $ rtresurrect --create --manager manager.mgr --rollback a.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/Sensor0.rtc:in: CORBA.UNKNOWN
  rtresurrect: 22 already done, 9 undone, 4 not tried, 1 failed
  [6]
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager.mgr/

The profile can name the manager: by paths below it, or with the property MANAGER. --map can, too:

  $ sed "s,\"localhost:$PORT/test.host_cxt/\(ConfigS\),\"localhost:$PORT/test.host_cxt/manager.mgr/\1,; s,\(COMP[^>]*_cxt\)/Seq,\1/manager.mgr/Seq," a.xml > b.xml
  $ rtresurrect --create -v -m Sensor0.rtc=manager.mgr/Sensor0.rtc b.xml 2>&1 | grep -e done -e nothing
  rtresurrect: /localhost:$PORT/test.host_cxt/Arm.rtc: is not there, and nothing names a manager to create it (see --manager)
  rtresurrect: component /localhost:$PORT/test.host_cxt/manager.mgr/ConfigSample0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: /localhost:$PORT/test.host_cxt/Motor0.rtc: is not there, and nothing names a manager to create it (see --manager)
  rtresurrect: component /localhost:$PORT/test.host_cxt/manager.mgr/Sensor0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: component /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: component /localhost:$PORT/test.host_cxt/SequenceOutComponent0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: configuration set mode1 of /localhost:$PORT/test.host_cxt/manager.mgr/ConfigSample0.rtc: done
  rtresurrect: connection two of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/manager.mgr/Sensor0.rtc:in: done
  rtresurrect: connection one of /localhost:$PORT/test.host_cxt/SequenceOutComponent0.rtc:Long to /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc:Long: done
  rtresurrect: 7 done, 18 already done, 2 failed, 10 not tried
  $ sed 's,\(instanceName="Arm".*\),\1<rtsExt:Properties rtsExt:name="MANAGER" rtsExt:value="old/test.host_cxt/manager.mgr"/>,' a.xml > c.xml
  $ rtresurrect --create -v -m old=localhost:$PORT --manager manager.mgr c.xml 2>&1 | grep -c done; same
  6

A manager that is not one, or cannot create; one that binds its components elsewhere:

  $ gone; rtresurrect --create --manager ConsoleIn0.rtc a.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a manager (it is a component)
  rtresurrect: 6 already done, 6 failed, 24 not tried
  [5]
  $ rtresurrect -q --create --manager corbaloc:: a.xml
  rtresurrect: corbaloc::: not corbaloc:iiop:HOST[:PORT][/KEY]
  [2]
  $ sed 's/example:Motor/example:Engine/' a.xml | rtresurrect -v --create --manager manager.mgr 2>&1 |
  > grep -v ': done$'
  rtresurrect: /localhost:$PORT/test.host_cxt/manager.mgr: does not create RTC:Shinji Kurihara, AIST:example:Engine:1.0?instance_name=Motor0 (no factory Engine; there are: ConfigSample, Controller, Motor, PeriodicECSharedComposite, Sensor, SeqIn, SeqOut)
  rtresurrect: members Motor0, Sensor0 of /localhost:$PORT/test.host_cxt/Arm.rtc: not tried because of /localhost:$PORT/test.host_cxt/manager.mgr
  rtresurrect: configuration set __type__ of /localhost:$PORT/test.host_cxt/Motor0.rtc: not tried because of /localhost:$PORT/test.host_cxt/manager.mgr
  rtresurrect: configuration set __widget__ of /localhost:$PORT/test.host_cxt/Motor0.rtc: not tried because of /localhost:$PORT/test.host_cxt/manager.mgr
  rtresurrect: configuration set default of /localhost:$PORT/test.host_cxt/Motor0.rtc: not tried because of /localhost:$PORT/test.host_cxt/manager.mgr
  rtresurrect: active configuration set default of /localhost:$PORT/test.host_cxt/Motor0.rtc: not tried because of /localhost:$PORT/test.host_cxt/manager.mgr
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/Motor0.rtc: not tried because of /localhost:$PORT/test.host_cxt/manager.mgr
  rtresurrect: 9 done, 20 already done, 1 failed, 6 not tried
  $ sed "s,test.host_cxt/SequenceOut,other.host_cxt/SequenceOut," a.xml > far.xml; gone
  $ rtresurrect -q --create --manager manager.mgr far.xml
  rtresurrect: /localhost:$PORT/other.host_cxt/SequenceOutComponent0.rtc: /localhost:$PORT/test.host_cxt/manager.mgr made it, but it is not bound here; deleted again
  [5]
  $ rtls
  Arm.rtc
  ConfigSample0.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Motor0.rtc
  Sensor0.rtc
  SequenceInComponent0.rtc
  manager.mgr/

One that gives a name of its own to what it makes: that is not left behind.

  $ rtcryo --all localhost:$PORT/test.host_cxt/ConfigSample0.rtc > one.xml
  $ rtmgr -d ConfigSample0 manager.mgr; ctl slave 1 misname Other0
  $ rtresurrect --create --manager manager.mgr one.xml; rtls
  rtresurrect: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: its manager made Other0 instead; deleted again
  rtresurrect: 1 failed, 7 not tried
  Arm.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Motor0.rtc
  Sensor0.rtc
  SequenceInComponent0.rtc
  manager.mgr/
  $ ctl slave 1 misname; rtresurrect --create --manager manager.mgr -v one.xml
  rtresurrect: component /localhost:$PORT/test.host_cxt/ConfigSample0.rtc, created by /localhost:$PORT/test.host_cxt/manager.mgr: done
  rtresurrect: configuration set mode1 of /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: done
  rtresurrect: 2 done, 6 already done

--manager alone means nothing:

  $ rtresurrect --manager manager.mgr a.xml
  rtresurrect: --manager is for --create (see --help)
  [2]

A master of C++ starts a new process for each id that no factory of its slaves has, as one without its language: so ids have one.

  $ mock manager SeqOut SeqIn Sensor --flavour cpp2 --context cpp2.host_cxt/%n.rtc
  $ slaves() { rtls --json /localhost:$PORT/cpp2.host_cxt/manager.mgr | grep -c '"kind": "manager"'; }
  $ rtcryo --all -o cpp2.rtsys /localhost:$PORT/cpp2.host_cxt; slaves
  1
  $ for c in SequenceOutComponent0 SequenceInComponent0 Sensor0; do
  >     rtmgr -d $c /localhost:$PORT/cpp2.host_cxt/manager.mgr
  > done
  $ rtresurrect -q --create --manager /localhost:$PORT/cpp2.host_cxt/manager.mgr cpp2.rtsys; slaves
  1
  $ rtmgr -c RTC:AIST:example:SeqOut:2.0.0?instance_name=Another /localhost:$PORT/cpp2.host_cxt/manager.mgr
  $ slaves
  1

An id that nothing has is not tried: that would start one, too.

  $ rtmgr -c RTC:AIST:example:Engine:2.0.0 /localhost:$PORT/cpp2.host_cxt/manager.mgr; slaves
  rtmgr: /localhost:$PORT/cpp2.host_cxt/manager.mgr: does not create RTC:AIST:example:Engine:2.0.0 (no factory Engine; there are: Controller, Motor, PeriodicECSharedComposite, Sensor, SeqIn, SeqOut)
  1
