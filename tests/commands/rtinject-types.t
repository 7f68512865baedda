rtinject knows a user's own data types from IDL, or from the component; rtlog records and plays them without.

world: custom
world: custom --flavour cpp11 --context cpp11.host_cxt/%n.rtc

  $ rtact --wait Arm0.rtc ../cpp11.host_cxt/Arm0.rtc
  $ mkdir idl; cat >idl/arm.idl <<END
  > #include <BasicDataType.idl>
  > module Arm {
  >   enum Mode { IDLE, MOVING };
  >   struct Joint { string name; double angle; };
  >   struct Status { RTC::Time tm; Mode doing; sequence<Joint> joints; };
  > };
  > END
  $ rtinject -c '{"doing": "IDLE", "joints": []}' Arm0.rtc:command
  rtinject: /localhost:$PORT/test.host_cxt/Arm0.rtc:command: no such data type known: IDL:Arm/Status:1.0; name its IDL file (--idl FILE) or compiled stubs (-m MODULE -p DIR)
  [3]
  $ rtinject -c '{"doing": "IDLE", "joints": []}' --idl idl/arm.idl Arm0.rtc:command
  $ ctl received Arm0:command 1
  1 ('IDLE', [])
  $ rtinject -c 'Arm.Status({time}, Arm.MOVING, [Arm.Joint("a", 1), Arm.Joint("b", -0.5)])' \
  >     --idl idl/arm.idl Arm0.rtc:command
  $ ctl received Arm0:command 2; ctl times Arm0:command
  2 ('MOVING', [('a', 1.0), ('b', -0.5)])
  2
  $ rtinject -c '{"doing": "MOVING", "joints": [{"name": "a", "angle": 2}]}' \
  >     ../cpp11.host_cxt/Arm0.rtc:command
  rtinject: /localhost:$PORT/cpp11.host_cxt/Arm0.rtc:command: no such data type known: IDL:Arm/Status:1.0; name its IDL file (--idl FILE) or compiled stubs (-m MODULE -p DIR)
  [3]
  $ RTSHELL_IDL=/nowhere:idl rtinject -v -c '{"doing": "FLYING", "joints": []}' Arm0.rtc:command
  rtinject: /nowhere: No such file or directory
  rtinject: IDL:Arm/Status:1.0 is read from idl/arm.idl
  rtinject: Arm.Status: doing: no Mode: 'FLYING' (they are IDLE, MOVING)
  [2]
  $ rtinject -c '{"doing": "FLYING", "joints": []}' --idl idl/arm.idl Arm0.rtc:command
  rtinject: Arm.Status: doing: no Mode: 'FLYING' (they are IDLE, MOVING)
  [2]
  $ rtinject -c '{"doing": "IDLE", "joints": [{"name": "a", "angle": 2}, {"name": "a", "angle": "2"}]}' \
  >     --idl idl/arm.idl Arm0.rtc:command
  rtinject: Arm.Status: joints[1].angle: not a double: '2'
  [2]
  $ rtinject -c 'Arm.Status({time}, Arm.IDLE, [Arm.Joint("a")])' --idl idl/arm.idl Arm0.rtc:command
  rtinject: Arm.Status: joints[0]: angle is missing
  [2]
  $ rtinject -c '{"joints": []}' --idl idl/arm.idl Arm0.rtc:command
  rtinject: Arm.Status: doing is missing
  [2]
  $ rtinject -c 'RTC.TimedLong({time}, 1)' --idl idl/arm.idl Arm0.rtc:command
  rtinject: RTC.TimedLong: not the type that is wanted, Arm.Status
  [2]

A log has the description of its types, if there was one:

  $ rtdeact --wait Arm0.rtc ../cpp11.host_cxt/Arm0.rtc
  $ recorded() { w=$1; shift; rtlog -i -e 1 "$@" & pid=$!; \
  >     soon 'ctl @$w connectors Arm0:status | grep -q . || ! kill -0 $pid 2>&-'
  >   ctl @$w write Arm0:status 3; wait $pid; }
  $ recorded custom2 -f known.rtlog ../cpp11.host_cxt/Arm0.rtc:status.arm; rtlog -p -f known.rtlog
  rtlog: Recording 1 entries.
  [0.000000000] doing=MOVING joints=[(name='shoulder', angle=3.0), (name='elbow', angle=1.5)]
  $ recorded custom -f idl.rtlog --idl idl/arm.idl Arm0.rtc:status.arm; rtlog --csv -f idl.rtlog
  rtlog: Recording 1 entries.
  number,time,port,tm,doing,joints[0].name,joints[0].angle,joints[1].name,joints[1].angle
  0,*,arm,0.000000000,MOVING,shoulder,3.0,elbow,1.5 (glob)
  $ recorded custom -f bytes.rtlog Arm0.rtc:status.arm
  > rtlog -p -f bytes.rtlog
  > rtlog -q -p --idl idl/arm.idl -f bytes.rtlog
  rtlog: /localhost:$PORT/test.host_cxt/Arm0.rtc:status: recorded as bytes: IDL:Arm/Status:1.0 is not known; name its IDL file (--idl FILE) or compiled stubs (-m MODULE -p DIR)
  rtlog: Recording 1 entries.
  64 bytes: 000000000000000001000000020000000900000073686f756c64657200??????000000000000084006000000656c626f7700????????????000000000000f83f (glob)
  [0.000000000] doing=MOVING joints=[(name='shoulder', angle=3.0), (name='elbow', angle=1.5)]
  $ rtact Arm0.rtc
  $ for log in known idl bytes; do rtlog -p -q -f $log.rtlog Arm0.rtc:command.arm; done
  $ ctl received Arm0:command 5
  5 ('MOVING', [('shoulder', 3.0), ('elbow', 1.5)])
