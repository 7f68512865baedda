rtcall calls operations of service ports, and of components themselves.

world: these Robot
world: manager ConsoleIn
world: services --context py.host_cxt/%n.rtc
world: services --flavour cpp2 --context cpp.host_cxt/%n.rtc

  $ IDL="--idl $MOCKS/robot.idl"

What a component provides, and whether its IDL is known:

  $ rtcall Robot0.rtc
  svc  arm    Mock::Robot    IDL:Mock/Robot:1.0    IDL not known
  svc  tally  Mock::Counter  IDL:Mock/Counter:1.0  IDL not known
  $ rtcall Robot0.rtc $IDL
  svc  arm    Mock::Robot    IDL:Mock/Robot:1.0    $MOCKS/robot.idl
  svc  tally  Mock::Counter  IDL:Mock/Counter:1.0  $MOCKS/robot.idl
  $ rtcall --json ../py.host_cxt/MyServiceProvider0.rtc
  {"idl": null, "instance": "myservice0", "port": "/localhost:$PORT/py.host_cxt/MyServiceProvider0.rtc:MyService", "repository_id": "IDL:SimpleService/MyService:1.0", "type_name": "MyService"}
  $ rtcall ../cpp.host_cxt/MyServiceProvider0.rtc:MyService
  MyService  myservice  SimpleService::MyService  IDL:SimpleService/MyService:1.0  IDL not known
  $ rtcall ../cpp.host_cxt/MyServiceConsumer0.rtc
  rtcall: /localhost:$PORT/cpp.host_cxt/MyServiceConsumer0.rtc: it has no ports that provide interfaces; rtcall /localhost:$PORT/cpp.host_cxt/MyServiceConsumer0.rtc -l lists what it serves itself
  $ rtcall manager.mgr
  rtcall: /localhost:$PORT/test.host_cxt/manager.mgr: it has no ports that provide interfaces; rtcall /localhost:$PORT/test.host_cxt/manager.mgr -l lists what it serves itself
  $ rtcall manager.mgr:svc
  rtcall: /localhost:$PORT/test.host_cxt/manager.mgr: not a component (it is a manager)
  [3]
  $ rtcall nothing.mgr
  rtcall: /localhost:$PORT/test.host_cxt/nothing.mgr: no such path
  [3]
  $ rtcall ../cpp.host_cxt/MyServiceConsumer0.rtc:MyService
  rtcall: /localhost:$PORT/cpp.host_cxt/MyServiceConsumer0.rtc:MyService: no such interface: it provides none (it is a CorbaPort)
  [3]
  $ rtcall Robot0.rtc:out
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:out: no such interface: it provides none (it is a DataOutPort)
  [3]
  $ rtcall Robot0.rtc:none
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc: no such port: none (its ports: svc, out)
  [3]
  $ rtcall Robot0.rtc:svc.none
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc: no such interface: none (there are: arm, tally)
  [3]

Its operations and attributes, as IDL:

  $ rtcall Robot0.rtc:svc.arm -l $IDL
  attribute double speed;
  readonly attribute string model;
  string say(in string words);
  Mock::Point move_to(in Mock::Point goal, in double seconds, out double distance) raises (Mock::OutOfReach, Mock::Busy);
  void turn(inout Mock::Joints joints, in boolean back, out Mock::Mode now);
  Mock::Goal aim(in Mock::Goal goal);
  Mock::Steps follow(in Mock::Steps steps);
  Mock::Matrix transposed(in Mock::Matrix given);
  Mock::Picture picture(in unsigned long size);
  any keep(in any value);
  Object friend(in Object other);
  Mock::Counter itself();
  long long sum(in short a, in unsigned short b, in long c, in unsigned long d, in long long e, in octet f, in char g);
  wstring wide(in wstring text, in string<5> brief);
  oneway void beep(in string why);
  void rest(in double seconds);
  void fail();
  void lose();
  string ending();
  readonly attribute long calls;
  void reset();
  $ rtcall Robot0.rtc:svc -l $IDL --json | tail -n 2
  {"idl": "readonly attribute long calls;", "name": "calls", "provider": "/localhost:$PORT/test.host_cxt/Robot0.rtc:svc.tally"}
  {"idl": "void reset();", "name": "reset", "provider": "/localhost:$PORT/test.host_cxt/Robot0.rtc:svc.tally"}
  $ rtcall Robot0.rtc:svc say reset -l $IDL
  /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm:
    string say(in string words);
    void reset();
  /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.tally:
    void reset();
  $ rtcall Robot0.rtc:svc.tally sey -l $IDL
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.tally: no such operation: sey (there are: calls, reset)
  [3]
  $ rtcall Robot0.rtc:svc Robot0.rtc:svc $IDL
  rtcall: Robot0.rtc:svc: not the name of an operation; -l takes several paths (see --help)
  [2]
  $ rtcall -l -n 3 Robot0.rtc:svc $IDL
  rtcall: -l only lists: it does not go with -t, -d, -r and -n (see --help)
  [2]
  $ rtcall Robot0.rtc:svc.tally ../py.host_cxt/MyServiceProvider0.rtc:MyService -l $IDL
  /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.tally:
    readonly attribute long calls;
    void reset();
  rtcall: /localhost:$PORT/py.host_cxt/MyServiceProvider0.rtc:MyService.myservice0: no such IDL: IDL:SimpleService/MyService:1.0; name its file (--idl FILE), or its directory (RTSHELL_IDL)
  [5]

A provider serves while its component is Active only:

  $ rtcall Robot0.rtc:svc say hello $IDL
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm say: the component is Inactive, and serves only while it is Active: rtact /localhost:$PORT/test.host_cxt/Robot0.rtc first
  [6]
  $ rtcall Robot0.rtc:svc beep hello $IDL
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm beep: the component is Inactive, and serves only while it is Active: rtact /localhost:$PORT/test.host_cxt/Robot0.rtc first
  [6]
  $ rtact --wait Robot0.rtc
  $ rtcall Robot0.rtc:svc say hello $IDL
  hello

Arguments are constants or JSON, by position or by name:

  $ rtcall Robot0.rtc:svc move_to '{"x": 3, "y": 4}' 0 $IDL
  {"distance": 5.0, "result": {"x": 3.0, "y": 4.0}}
  $ rtcall Robot0.rtc:svc move_to 'Mock::Point(3, y=4)' seconds=0 $IDL
  {"distance": 5.0, "result": {"x": 3.0, "y": 4.0}}
  $ rtcall Robot0.rtc:svc move_to seconds=0 goal='{"x": 3, "y": 4}' $IDL
  {"distance": 5.0, "result": {"x": 3.0, "y": 4.0}}
  $ rtcall Robot0.rtc:svc move_to -d '{"goal": {"x": 3, "y": 4}, "seconds": 0}' $IDL
  {"distance": 5.0, "result": {"x": 3.0, "y": 4.0}}
  $ echo '{"goal": {"x": 3, "y": 4}, "seconds": 0}' > move.json
  $ rtcall Robot0.rtc:svc move_to -d @move.json $IDL
  {"distance": 5.0, "result": {"x": 3.0, "y": 4.0}}
  $ rtcall Robot0.rtc:svc move_to -d - $IDL < move.json
  {"distance": 5.0, "result": {"x": 3.0, "y": 4.0}}
  $ rtcall Robot0.rtc:svc turn '[1, 2.5]' true $IDL
  {"joints": [-1.0, -2.5], "now": "MOVING"}
  $ rtcall Robot0.rtc:svc say '"a=b"' $IDL
  a=b
  $ rtcall Robot0.rtc:svc say 42 $IDL
  42
  $ rtcall Robot0.rtc:svc say '日本' $IDL
  日本
  $ rtcall Robot0.rtc:svc say '日本' $IDL --json
  {"result": "\u65e5\u672c"}

Attributes, and what two interfaces have:

  $ rtcall Robot0.rtc:svc speed $IDL
  1.0
  $ rtcall Robot0.rtc:svc speed=2.5 $IDL
  $ rtcall Robot0.rtc:svc speed $IDL
  2.5
  $ rtcall Robot0.rtc:svc model=x $IDL
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm: its attribute model is readonly
  [6]
  $ rtcall Robot0.rtc:svc calls $IDL
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc: no such operation for certain: calls may be that of /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm or /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.tally
  [3]
  $ rtcall Robot0.rtc:svc.tally calls $IDL
  0

An exception of its IDL; what its IDL does not declare:

  $ rtcall Robot0.rtc:svc move_to 'Point(30, 4)' 0 $IDL
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm move_to: OutOfReach(nearest=(x=10.0, y=4.0), by=20.0)
  [6]
  $ rtcall Robot0.rtc:svc move_to 'Point(30, 4)' 0 $IDL --json
  {"exception": "OutOfReach", "members": {"by": 20.0, "nearest": {"x": 10.0, "y": 4.0}}}
  [6]
  $ rtcall Robot0.rtc:svc fail $IDL
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm fail: it raised what $MOCKS/robot.idl does not declare; it may have been done
  [6]

A template, to be edited and sent:

  $ rtcall Robot0.rtc:svc move_to -t $IDL > move.json; cat move.json
  {"goal": {"x": 0.0, "y": 0.0}, "seconds": 0.0}
  $ rtcall Robot0.rtc:svc move_to -d @move.json $IDL
  {"distance": 0.0, "result": {"x": 0.0, "y": 0.0}}
  $ rtcall Robot0.rtc:svc aim -t $IDL
  {"goal": {"_d": "STANDING", "why": ""}}
  $ rtcall Robot0.rtc:svc speed -t $IDL
  {}
  $ rtcall Robot0.rtc:svc speed= -t $IDL
  {"speed": 0.0}

What would be sent:

  $ rtcall Robot0.rtc:svc move_to 'Point(3, 4)' 0 --dry-run --idl $MOCKS/robot.idl
  rtcall --idl $MOCKS/robot.idl /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm move_to -d '{"goal": {"x": 3.0, "y": 4.0}, "seconds": 0.0}'
  $ rtcall Robot0.rtc:svc speed=3 --dry-run $IDL
  rtcall --idl $MOCKS/robot.idl /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm _set_speed -d '{"speed": 3.0}'

oneway is sent, and nobody reports what becomes of it:

  $ rtcall Robot0.rtc:svc beep twice $IDL
  $ rtcall Robot0.rtc:svc ending $IDL
  hello; a=b; 42; 日本; 日本; beep: twice

Several in one process:

  $ printf 'call Robot0.rtc:svc say one %s\ncall Robot0.rtc:svc rest 20 --limit 0.2 %s\ncall Robot0.rtc:svc say two %s\n' "$IDL" "$IDL" "$IDL" |
  >     rtsh
  one
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: no answer within 0.2s; it may have been done, or be going on
  two

Nothing is left behind:

  $ rtcat -ll Robot0.rtc:svc | grep -i connect
  [1]

Without a port, the component, manager or name server itself is called; its IDL is known:

  $ rtcall Robot0.rtc get_sdo_id
  Robot0
  $ rtcall Robot0.rtc get_component_profile | cut -c 1-30
  {"category": "test", "descript
  $ rtcall Robot0.rtc -l | grep 'get_sdo_id\|exit'
  RTC::ReturnCode_t exit();
  SDOPackage::UniqueIdentifier get_sdo_id() raises (SDOPackage::NotAvailable, SDOPackage::InternalError);
  $ rtcall Robot0.rtc:svc get_sdo_id $IDL
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc: no such operation: get_sdo_id (there are: speed, model, say, move_to, turn, aim, follow, transposed, picture, keep, friend, itself, …)
  [3]
  $ rtcall /localhost:$PORT -l | grep ' list('
  void list(in unsigned long how_many, out CosNaming::BindingList bl, out CosNaming::BindingIterator bi);
  $ rtcall /localhost:$PORT resolve '[{"id": "test", "kind": "host_cxt"}, {"id": "none", "kind": "rtc"}]'
  rtcall: /localhost:$PORT resolve: NotFound(why=missing_node, rest_of_name=[(id='none', kind='rtc')])
  [6]
  $ rtcall manager.mgr get_components | sed 's/IOR:[0-9a-f]*/IOR/'
  [{"_ior": "IOR", "_type": "IDL:openrtm.aist.go.jp/OpenRTM/DataFlowComponent:1.0"}]
  $ rtcall ../none.rtc get_sdo_id
  rtcall: /localhost:$PORT/none.rtc: no such path
  [3]

invocation: A
invocation: A get_sdo_id --limit 2
invocation: -l A
looking: A
broken component: 0 6
prepared: echo 'module SimpleService { interface MyService { string echo(in string msg); void set_value(in float value); float get_value(); }; };' >MyService.idl; rtact --wait MyServiceProvider0.rtc
