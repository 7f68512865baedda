What rtcat says when something does not work. (What hangs, and what else fails: tests/sim/stories/rtcat-faults.t.)

world: two
world: zombie --context test.host_cxt/Dead%n.rtc
world: hung --context test.host_cxt/Hung%n.rtc
world: contexts
world: orphan
world: names --context odd.host_cxt/%n.rtc
faulty: --bind localhost:$PORT/bad.host_cxt a=late-silent b=late-reset c=late-garbage d=sequence-bomb
alone: it measures
both: each ORB waits in its own way

A zombie, a hung component, a component whose process has lost it, names of something else and of nothing:

  $ rtcat DeadMock0.rtc
  rtcat: /localhost:$PORT/test.host_cxt/DeadMock0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ within 4-8 rtcat --timeout 4 HungMock0.rtc
  rtcat: /localhost:$PORT/test.host_cxt/HungMock0.rtc: no answer within 4s
  [4]
  $ RTCSH_CWD=/localhost:$PORT/odd.host_cxt; export RTCSH_CWD
  $ rtcat Gone0.rtc
  rtcat: /localhost:$PORT/odd.host_cxt/Gone0.rtc: zombie (the name is bound, but its object is gone)
  [4]
  $ rtcat NotAComponent0.rtc
  rtcat: /localhost:$PORT/odd.host_cxt/NotAComponent0.rtc: not a component or manager (it is a CORBA object of unknown kind)
  [3]
  $ rtcat NotAManager0.mgr
  rtcat: /localhost:$PORT/odd.host_cxt/NotAManager0.mgr: not a component or manager (it is a CORBA object of unknown kind)
  [3]
  $ rtcat Thing0.obj
  rtcat: /localhost:$PORT/odd.host_cxt/Thing0.obj: not a component or manager (it is a CORBA object of unknown kind)
  [3]
  $ rtcat Nil0.rtc
  rtcat: /localhost:$PORT/odd.host_cxt/Nil0.rtc: not a component or manager (it is a nil reference)
  [3]
  $ rtcat Nil0.rtc:in
  rtcat: /localhost:$PORT/odd.host_cxt/Nil0.rtc: not a component or manager (it is a nil reference)
  [3]
  $ rtcat empty.cxt
  rtcat: /localhost:$PORT/odd.host_cxt/empty.cxt: not a component or manager (it is a directory)
  [3]

Names that are hard to type:

  $ rtcat 'sl\/ash.rtc:in' 'co\:lon.rtc:out' './-l.rtc:in' '\e:in' 'esc\x1b[31mred.rtc:in' '日本語.rtc:in'
  +DataInPort: in

  +DataOutPort: out

  +DataInPort: in

  +DataInPort: in

  +DataInPort: in

  +DataInPort: in
  $ rtcat 'esc\x1b[31mred.rtc' | head -n 4
  esc\x1b[31mred.rtc  Inactive
    Category       test
    Description    Does nothing
    Instance name  esc\x1b[31mred
  $ rtcat '日本語.rtc' 'bad\xff\xfe.rtc' | grep Instance
    Instance name  日本語
    Instance name  bad\xff\xfe
  $ rtcat 'bad\xff\xfe.rtc:none'
  rtcat: /localhost:$PORT/odd.host_cxt/bad\xff\xfe.rtc: no such port: none (its ports: in, out)
  [3]
  $ rtls -0 | xargs -0 rtcat 2>/dev/null | grep -c Execution
  25

Several contexts; those that it takes part in belong to others and are not shown, but counted for the state:

  $ RTCSH_CWD=/localhost:$PORT/test.host_cxt; export RTCSH_CWD
  $ rtcat -l Multi0.rtc | sed -n '/^-Exec/,/^-Data/p'
  -Execution Context 0  Inactive
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  Multi0
   +Extra properties
  -Execution Context 1  Inactive
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  Multi0
   +Extra properties
  -Execution Context 1000 of Driver0  Inactive
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  Driver0
   +Participants
   +Extra properties
  -DataInPort: in
  $ rtcat -l Driver0.rtc | sed -n '/^-Exec/,/^-Data/p'
  -Execution Context 0
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  Driver0
   +Participants
   +Extra properties
  -DataInPort: in
  $ rtcat -ll Driver0.rtc | sed -n '/Participants/,/Extra/p'
     -Participants
        Multi0
     -Extra properties
  $ rtact -e 2 Multi0.rtc; rtcat Multi0.rtc | head -n 1
  Multi0.rtc  Active
  $ rtcat --json Multi0.rtc | python3 -c 'import json, sys
  > for context in json.load(sys.stdin)["execution_contexts"]:
  >     print(context["handle"], context["owner"], context["state"], context["participants"])'
  0 Multi0 Inactive []
  1 Multi0 Inactive []
  1000 Driver0 Active ['Multi0']

A component whose connected peer has died complains once; rtcat asks again and does not pass it on.

  $ rtcat -ll Orphan0.rtc | sed -n '1p;/DataOutPort: out/,$p' | grep -c .
  15
  $ rtcat -l Peer0.rtc
  rtcat: /localhost:$PORT/test.host_cxt/Peer0.rtc: connection refused; its process is gone (zombie)
  [4]

A component that fails to answer something. A failure that says that it is passing is asked once more, no more often.

  $ ctl fail get_port_profile 1 TRANSIENT
  $ ctl fail get_port_profile 2 TRANSIENT
  $ rtcat ConsoleIn0.rtc:out
  rtcat: /localhost:\$PORT/test.host_cxt/ConsoleIn0.rtc: (connection refused|cannot be reached now \(TRANSIENT_ConnectFailed\)) (re)
  [4]
  $ ctl fail get_component_profile 1 COMM_FAILURE; rtcat ConsoleIn0.rtc | head -n 1
  ConsoleIn0.rtc  Inactive

Peers that speak no sense:

  $ RTCSH_CWD=/localhost:$PORT/bad.host_cxt; export RTCSH_CWD
  $ within 4-8 rtcat --timeout 4 a.rtc
  rtcat: /localhost:$PORT/bad.host_cxt/a.rtc: no answer within 4s
  [4]
  $ rtcat b.rtc
  rtcat: /localhost:$PORT/bad.host_cxt/b.rtc: connection lost
  [4]
  $ rtcat c.rtc:in
  rtcat: /localhost:\$PORT/bad.host_cxt/c.rtc: (connection lost|garbled answer \(not GIOP\)) (re)
  [4]
  $ rtcat d.rtc
  rtcat: /localhost:$PORT/bad.host_cxt/d.rtc: garbled answer (*) (glob)
  [4]
