rtresurrect restores a system from an RtsProfile: members of composites, configuration, rates, connections of all kinds.

server: composites
world: these ConsoleIn ConsoleOut ConsoleOut:ConsoleOut1 ConfigSample Motor
world: services
world: composite --nameserver localhost:$PORT2

Save a system, with a connection of three ends and a composite on another name server:

  $ C=/localhost:$PORT2/test.host_cxt
  $ rtcon -i one -n 'odd "name"' -p 'my key=$x' ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon -i three Motor0.rtc:out ConsoleOut0.rtc:in ConsoleOut1.rtc:in
  $ rtcon -i service MyServiceConsumer0.rtc:MyService MyServiceProvider0.rtc:MyService
  $ rtcryo --all localhost:$PORT localhost:$PORT2 > a.xml
  $ rtcryo --all -y localhost:$PORT localhost:$PORT2 > a.yaml

All is already as the file says, and nothing is done:

  $ rtresurrect -y a.yaml; rtresurrect --xml - < a.xml
  $ rtresurrect < a.yaml
  $ ctl reset; rtresurrect -v a.xml
  rtresurrect: 49 already done
  $ calls | grep -E ' (connect|disconnect|notify.*|set_.*|activate_.*)$'
  [1]

Tear it down and change it; --dry-run prints the commands that restore it, and does nothing:

  $ rtteardown a.xml; rtconf ConfigSample0.rtc act mode0
  $ rtconf ConfigSample0.rtc set str_param0="it's \$5" int_param0=-5
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0 is set, but it's $5 does not fit the component's constraint (default,mode0,mode1,foo,bar,radio)
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but -5 does not fit the component's constraint 0<=x<=150
  $ rtec Motor0.rtc rate 500; rtcomp -r $C/Motor0.rtc $C/composite0.rtc
  $ rtresurrect --dry-run a.xml > script; cat script
  rtcomp -a /localhost:$PORT2/test.host_cxt/Motor0.rtc /localhost:$PORT2/test.host_cxt/composite0.rtc
  rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode0 set int_param0=12345 str_param0=mode0
  rtconf /localhost:$PORT/test.host_cxt/ConfigSample0.rtc -s mode1 act
  rtec /localhost:$PORT/test.host_cxt/Motor0.rtc rate 1000.0
  rtconf /localhost:$PORT2/test.host_cxt/composite0.rtc -s default set 'exported_ports=Sensor0.in, Motor0.out'
  rtcon -n 'odd "name"' -i one -p dataport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.dataflow_type=push -p dataport.inport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.interface_type=corba_cdr -p dataport.outport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.serializer.cdr.endian=little,big -p dataport.subscription_type=new -p 'my key=$x' /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  rtcon -n outin_in -i three -p dataport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.dataflow_type=push -p dataport.inport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.interface_type=corba_cdr -p dataport.outport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.serializer.cdr.endian=little,big -p dataport.subscription_type=new /localhost:$PORT/test.host_cxt/Motor0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in
  rtcon -n MyServiceMyService -i service -p port.port_type=CorbaPort /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService

They can be given to a shell, and then nothing is left to do:

  $ sh -e script
  rtconf: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: int_param0 is set, but 12345 does not fit the component's constraint 0<=x<=150
  $ rtcheck -s inactive a.xml; rtresurrect --dry-run a.xml

What rtresurrect does, step by step:

  $ rtteardown a.xml; rtconf ConfigSample0.rtc set int_param0 7
  $ rtec Motor0.rtc rate 500; rtcomp -r $C/Motor0.rtc $C/composite0.rtc
  $ rtresurrect -v a.xml
  rtresurrect: members Controller0, Motor0, Sensor0 of /localhost:$PORT2/test.host_cxt/composite0.rtc: done
  rtresurrect: configuration set mode1 of /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: done
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/Motor0.rtc: done
  rtresurrect: configuration set default of /localhost:$PORT2/test.host_cxt/composite0.rtc: done
  rtresurrect: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: done
  rtresurrect: connection three of /localhost:$PORT/test.host_cxt/Motor0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: done
  rtresurrect: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: done
  rtresurrect: 7 done, 42 already done
  $ rtcryo --all localhost:$PORT localhost:$PORT2 | grep -v Date= > b; grep -v Date= a.xml | cmp - b
  $ rtresurrect a.yaml; rtcheck -s inactive a.yaml

As JSON:

  $ rtdis ConsoleIn0.rtc; rtresurrect --json a.xml | grep -v '"already"'
  {"command": "rtcon -n 'odd \"name\"' -i one -p dataport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.dataflow_type=push -p dataport.inport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.interface_type=corba_cdr -p dataport.outport.data_type=IDL:RTC/TimedLong:1.0 -p dataport.serializer.cdr.endian=little,big -p dataport.subscription_type=new -p 'my key=$x' /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in", "error": null, "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in", "required": true, "result": "done", "step": "connect"}
  $ rtresurrect --json a.xml | sed -n '1p; $p'
  {"command": null, "error": null, "path": "/localhost:$PORT/test.host_cxt/ConfigSample0.rtc", "required": true, "result": "already", "step": "component"}
  {"command": "rtcon -n MyServiceMyService -i service -p port.port_type=CorbaPort /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService", "error": null, "path": "/localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService", "required": true, "result": "already", "step": "connect"}

Components that are missing, or are others than they should be, are reported; the rest is restored. What was not tried is reported
with -v:

  $ rtteardown a.xml; rtdel -f MyServiceProvider0.rtc
  $ rtec Motor0.rtc rate 500
  $ sed 's/example:ConsoleOut:1.0" rts:pathUri/example:ConsoleOut:2.0" rts:pathUri/' a.xml > other.xml
  $ rtresurrect --rollback other.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not a RTC:Shinji Kurihara:example:ConsoleOut:2.0 (it is a RTC:Shinji Kurihara:example:ConsoleOut:1.0)
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: not a RTC:Shinji Kurihara:example:ConsoleOut:2.0 (it is a RTC:Shinji Kurihara:example:ConsoleOut:1.0)
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: 36 already done, 3 failed, 10 not tried
  [3]

So it is with --rollback: all or nothing, and checked before the first change. Without it:

  $ rtresurrect -v other.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not a RTC:Shinji Kurihara:example:ConsoleOut:2.0 (it is a RTC:Shinji Kurihara:example:ConsoleOut:1.0)
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: not a RTC:Shinji Kurihara:example:ConsoleOut:2.0 (it is a RTC:Shinji Kurihara:example:ConsoleOut:1.0)
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: active configuration set default of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  rtresurrect: active configuration set default of /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/Motor0.rtc: done
  rtresurrect: active configuration set default of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: not tried because of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: not tried because of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc
  rtresurrect: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  rtresurrect: connection three of /localhost:$PORT/test.host_cxt/Motor0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  rtresurrect: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: not tried because of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc
  rtresurrect: 1 done, 36 already done, 3 failed, 9 not tried
  [5]

That is no failure for those which the file does not require:

  $ sed 's/isRequired="true"/isRequired="false"/' other.xml > optional.xml; rtec Motor0.rtc rate 500
  $ rtresurrect -v --rollback optional.xml 2>&1 | grep -v 'not tried ('
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not a RTC:Shinji Kurihara:example:ConsoleOut:2.0 (it is a RTC:Shinji Kurihara:example:ConsoleOut:1.0) (not required)
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: not a RTC:Shinji Kurihara:example:ConsoleOut:2.0 (it is a RTC:Shinji Kurihara:example:ConsoleOut:1.0) (not required)
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc? (not required)
  rtresurrect: active configuration set default of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  rtresurrect: active configuration set default of /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/Motor0.rtc: done
  rtresurrect: active configuration set default of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: not tried because of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc
  rtresurrect: rate of execution context 0 of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: not tried because of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc
  rtresurrect: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  rtresurrect: connection three of /localhost:$PORT/test.host_cxt/Motor0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: not tried because of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  rtresurrect: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: not tried because of /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc
  rtresurrect: 1 done, 36 already done, 3 failed, 9 not tried

Sets and parameters that are not there do not stop it:

  $ sed 's/rts:id="mode0"/rts:id="mode9"/; s/name="int_param0" rts:data="0"/name="int_param9" rts:data="0"/' a.xml > sets.xml
  $ rtconf ConfigSample0.rtc -s mode1 set int_param0 8
  $ rtresurrect sets.xml; rtconf ConfigSample0.rtc -s mode1 get int_param0
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration parameter: int_param9 in set default
  rtresurrect: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: mode9
  rtresurrect: 3 done, 41 already done, 3 failed, 3 not tried
  -999
  $ sed 's/activeConfigurationSet="mode1"/activeConfigurationSet="mode9"/' a.xml | rtresurrect
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: mode9
  rtresurrect: 44 already done, 2 failed, 3 not tried
  [5]

Ports that are missing or do not match, ids that are taken, other connections in the way:

  $ rtdis Motor0.rtc; sed 's/portName="ConsoleOut1.in"/portName="ConsoleOut1.on"/' a.xml | rtresurrect
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: no such port: on (its ports: in)
  rtresurrect: 44 already done, 2 failed, 3 not tried
  [5]
  $ sed 's/Motor0.out/Motor0.in/' a.xml | rtresurrect
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: /localhost:$PORT/test.host_cxt/Motor0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: each is a DataInPort; a connection needs an in port and an out port
  rtresurrect: 1 done, 43 already done, 2 failed, 3 not tried
  [5]
  $ rtdis ConsoleIn0.rtc; rtcon -i one ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  $ rtcon -i mine ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtresurrect a.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: connection one joins other ports; rtdis removes it
  rtresurrect: 2 done, 42 already done, 2 failed, 3 not tried
  [5]
  $ rtdis ConsoleIn0.rtc
  $ rtcon -i one -p 'my key=$y' ConsoleIn0.rtc:out ConsoleOut0.rtc:in; rtresurrect a.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: is connected with my key=$y, not $x; rtdis removes that
  rtresurrect: 44 already done, 2 failed, 3 not tried
  [5]
  $ rtdis ConsoleIn0.rtc; rtcon -i mine ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtresurrect a.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: already connected with another id (mine); rtdis removes that
  rtresurrect: 44 already done, 2 failed, 3 not tried
  [5]
  $ rtdis ConsoleIn0.rtc

Files that contradict themselves; --strict-path takes nothing for what is only called the same:

  $ sed 's/rtsExt:value="localhost:[0-9]*.test.host_cxt.ConsoleIn0.rtc"/rtsExt:value="localhost\/X.rtc"/' \
  >     a.xml > path.xml
  $ rtresurrect --strict-path path.xml; rtresurrect -v path.xml 2>&1 | grep done
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtresurrect: connection one: the file has no component for its end ConsoleIn0.out
  rtresurrect: 44 already done, 2 failed, 3 not tried
  rtresurrect: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: done
  rtresurrect: 1 done, 44 already done, 1 failed, 3 not tried
  $ sed 's/ConsoleOut1.rtc" rts:active/ConsoleOut0.rtc" rts:active/' a.xml | rtresurrect
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: the file has two components here
  [1]
  $ sed 's/pathUri="[^"]*Motor0/pathUri="a:b:c/' a.xml | rtresurrect -q
  rtresurrect: /a:b:c.rtc: not the path of a component
  rtresurrect: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  [5]

What is no profile, no such option:

  $ rtresurrect nofile
  rtresurrect: nofile: No such file or directory
  [1]
  $ echo garbage | rtresurrect
  rtresurrect: -:1:1: not an RtsProfile: the key rtsProfile is missing
  [1]
  $ rtresurrect < /dev/null
  rtresurrect: -:1:1: the file is empty
  [1]
  $ rtresurrect a.xml b.xml
  rtresurrect: unrecognized arguments: b.xml (see --help)
  [2]
  $ rtresurrect --no-partial a.xml
  rtresurrect: unrecognized arguments: --no-partial (see --help)
  [2]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: FILE
invocation: --dry-run FILE
invocation: --rollback FILE
looking: --dry-run FILE
broken component: 5
