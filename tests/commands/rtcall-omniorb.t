rtcall with omniORB: the same values, once, too.

orb: omniorb
world: these Robot

  $ export RTSHELL_IDL="$MOCKS"; rtact --wait Robot0.rtc
  $ rtcall Robot0.rtc:svc say '日本'
  日本
  $ rtcall Robot0.rtc:svc move_to 'Point(3, 4)' 0
  {"distance": 5.0, "result": {"x": 3.0, "y": 4.0}}
  $ rtcall Robot0.rtc:svc move_to 'Point(30, 4)' 0
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm move_to: OutOfReach(nearest=(x=10.0, y=4.0), by=20.0)
  [6]
  $ rtcall Robot0.rtc:svc turn '[1, 2]' true
  {"joints": [-1.0, -2.0], "now": "MOVING"}
  $ rtcall Robot0.rtc:svc aim '{"to": {"x": 1, "y": 2}}'
  {"_d": "MOVING", "to": {"x": 1.0, "y": 2.0}}
  $ rtcall Robot0.rtc:svc follow '[{"name": "a", "goal": {"x": 1, "y": 2}, "mode": "MOVING"}]'
  [{"goal": {"x": 1.0, "y": 2.0}, "mode": "MOVING", "name": "a"}]
  $ rtcall Robot0.rtc:svc picture 5
  AAECAwQ=
  $ rtcall Robot0.rtc:svc sum -- -1 2 -3 4 -5 6 A
  68
  $ rtcall Robot0.rtc:svc wide '日本' abc
  日本abc
  $ rtcall Robot0.rtc:svc keep '{"_type": "Mock::Goal", "_value": {"to": {"x": 1, "y": 2}}}'
  {"_type": "IDL:Mock/Goal:1.0", "_value": {"_d": "MOVING", "to": {"x": 1.0, "y": 2.0}}}
  $ rtcall Robot0.rtc:svc friend "$(rtcall Robot0.rtc:svc itself)" | sed 's/IOR:[0-9a-f]*/IOR/'
  {"_ior": "IOR", "_type": "IDL:Mock/Robot:1.0"}
  $ rtcall Robot0.rtc:svc friend null
  null
  $ rtcall Robot0.rtc:svc speed=2.5; rtcall Robot0.rtc:svc speed
  2.5
  $ rtcall Robot0.rtc:svc beep twice; rtcall Robot0.rtc:svc ending
  日本; beep: twice
  $ rtcall Robot0.rtc get_sdo_id
  Robot0

What fails:

  $ ctl reset
  $ rtcall Robot0.rtc:svc fail
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm fail: it raised what $MOCKS/robot.idl does not declare; it may have been done
  [6]
  $ rtcall Robot0.rtc:svc rest 20 --limit 0.5
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: no answer within 0.5s; it may have been done, or be going on
  [4]
  $ ctl fail rest 1 NO_PERMISSION; rtcall Robot0.rtc:svc rest 0
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: it raised NO_PERMISSION; it may have been done
  [6]
  $ echo 'module Mock { interface Robot { void nix(); string say(in string words, in double more); void move_to(); long ending(); }; };' >wrong.idl
  $ rtcall Robot0.rtc:svc nix --idl wrong.idl
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm nix: it has no such operation: wrong.idl is probably not its IDL (IDL:Mock/Robot:1.0)
  [6]
  $ rtcall Robot0.rtc:svc say a 1 --idl wrong.idl
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm say: it cut the connection and lives: it probably takes other arguments, and did nothing; wrong.idl is probably not its IDL (IDL:Mock/Robot:1.0)
  [6]
  $ rtcall Robot0.rtc:svc move_to --idl wrong.idl
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm move_to: it takes other arguments: wrong.idl is probably not its IDL (IDL:Mock/Robot:1.0)
  [6]
  $ rtcall Robot0.rtc:svc ending --idl wrong.idl
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm ending: done, but its answer is of another type: wrong.idl is probably not its IDL (IDL:Mock/Robot:1.0)
  [4]
  $ ctl calls Robot0 | grep 'rest\|fail\|say\|ending'
  1 ending
  1 fail
  2 rest
  1 say
