rtprint knows a user's own data types from IDL, from stubs, or from the component.

orb: omniorb
world: custom
world: custom --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: custom --flavour java --context java.host_cxt/%n.rtc

  $ printing() { w=$1; shift; "$@" & pid=$!; \
  >     soon 'ctl @$w connectors Arm0:status | grep -q . || ! kill -0 $pid 2>&-'
  >   ctl @$w write Arm0:status 3; wait $pid; }

Nobody knows it; what fills the gaps between values may be anything:

  $ rtprint -n 1 Arm0.rtc:status
  rtprint: /localhost:$PORT/test.host_cxt/Arm0.rtc:status: no such data type known: IDL:Arm/Status:1.0; name its IDL file (--idl FILE) or compiled stubs (-m MODULE -p DIR), or look at the bytes (--raw)
  [3]
  $ printing custom rtprint -n 1 --raw Arm0.rtc:status
  64 bytes
  00000000  00 00 00 00 00 00 00 00 01 00 00 00 02 00 00 00  ................
  00000010  09 00 00 00 73 68 6f 75 6c 64 65 72 00 .. .. ..  \.\.\.\.shoulder\.... (re)
  00000020  00 00 00 00 00 00 08 40 06 00 00 00 65 6c 62 6f  .......@....elbo
  00000030  77 00 .. .. .. .. .. .. 00 00 00 00 00 00 f8 3f  w\..{6}\.{6}.\? (re)
  maybe: time 0.000000000

The component knows it:

  $ printing custom2 rtprint -n 1 ../cpp11.host_cxt/Arm0.rtc:status
  [0.000000000] doing=MOVING joints=[(name='shoulder', angle=3.0), (name='elbow', angle=1.5)]
  $ printing custom3 rtprint -n 1 --json ../java.host_cxt/Arm0.rtc:status
  {"path": "/localhost:$PORT/java.host_cxt/Arm0.rtc:status", "received": *, "type": "IDL:Arm/Status:1.0", "value": {"doing": "MOVING", "joints": [{"angle": 3.0, "name": "shoulder"}, {"angle": 1.5, "name": "elbow"}], "tm": {"nsec": 0, "sec": 0}}} (glob)

An IDL file; what it includes is looked for beside it, in -I, and among the standard files:

  $ mkdir parts; echo 'module Arm { struct Joint { string name; double angle; }; };' >parts/joint.idl
  $ cat >arm.idl <<END
  > #include <BasicDataType.idl>
  > #include "joint.idl"
  > module Arm {
  >   enum Mode { IDLE, MOVING };
  >   struct Status { RTC::Time tm; Mode doing; sequence<Joint> joints; };
  > };
  > END
  $ printing custom rtprint -n 1 --idl arm.idl -I parts Arm0.rtc:status
  [0.000000000] doing=MOVING joints=[(name='shoulder', angle=3.0), (name='elbow', angle=1.5)]
  $ printing custom rtprint -n 1 --idl arm.idl -I parts --field joints Arm0.rtc:status
  [(name='shoulder', angle=3.0), (name='elbow', angle=1.5)]
  $ printing custom rtprint -n 1 --idl arm.idl -I parts --json --field doing Arm0.rtc:status
  {"path": "/localhost:$PORT/test.host_cxt/Arm0.rtc:status", "received": *, "type": "IDL:Arm/Status:1.0", "value": "MOVING"} (glob)
  $ rtprint --idl arm.idl Arm0.rtc:status
  rtprint: arm.idl:2:1: no such file to include: joint.idl (-I DIR names where to look)
  [1]
  $ rtprint --idl none.idl Arm0.rtc:status
  rtprint: none.idl: No such file or directory
  [1]
  $ echo 'module Arm { struct Status { lung a; }; };' >wrong.idl; rtprint --idl wrong.idl Arm0.rtc:status
  rtprint: wrong.idl:1:30: not declared: lung
  [1]
  $ echo 'module Arm { struct Status { long a; double b[200]; }; };' >other.idl
  > printing custom rtprint -n 1 --idl other.idl Arm0.rtc:status
  rtprint: /localhost:$PORT/test.host_cxt/Arm0.rtc:status: Arm.Status: ends within an array
  [4]

Stubs that omniidl has made; they import those of the standard types, which come along:

  $ mkdir stubs; cat >stubs/Arm.py <<END
  > import omniORB
  > import BasicDataType_idl
  > class Joint(omniORB.StructBase):
  >     _NP_RepositoryId = "IDL:Arm/Joint:1.0"
  >     def __init__(self, name, angle): self.name, self.angle = name, angle
  > class Status(omniORB.StructBase):
  >     _NP_RepositoryId = "IDL:Arm/Status:1.0"
  >     def __init__(self, tm, doing, joints): self.tm, self.doing, self.joints = tm, doing, joints
  > Mode = omniORB.Enum("IDL:Arm/Mode:1.0", (omniORB.EnumItem("IDLE", 0), omniORB.EnumItem("MOVING", 1)))
  > _d_Mode = (omniORB.tcInternal.tv_enum, Mode._NP_RepositoryId, "Mode", Mode._items)
  > _d_Joint = (omniORB.tcInternal.tv_struct, Joint, Joint._NP_RepositoryId, "Joint", "name", (omniORB.tcInternal.tv_string, 0), "angle", omniORB.tcInternal.tv_double)
  > _d_Status = (omniORB.tcInternal.tv_struct, Status, Status._NP_RepositoryId, "Status", "tm", omniORB.typeMapping["IDL:RTC/Time:1.0"], "doing", _d_Mode, "joints", (omniORB.tcInternal.tv_sequence, _d_Joint, 0))
  > END
  $ printing custom rtprint -n 1 -m Arm -p stubs Arm0.rtc:status
  [0.000000000] doing=MOVING joints=[(name='shoulder', angle=3.0), (name='elbow', angle=1.5)]
  $ rtprint -m Arm Arm0.rtc:status
  rtprint: Arm: no such module: No module named 'Arm'
  [3]
