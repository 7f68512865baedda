rtlog where a component hangs, or dies: that is said, the others are recorded, and the file is whole.

world: senders 200 1000
world: these ConsoleOut ConsoleIn

A component that hangs is reported, and does not hold up the others, or the end:

  $ RTSHELL_TIMEOUT=0.5 rtlog -t 5 -f g.rtlog Source0.rtc:number.a ConsoleIn0.rtc:out &
  $ sleep 1
  $ hang senders
  $ wait rtlog
  ! rtlog: Recording for 5.0s.
  ! rtlog: /robot/test.host_cxt/Source0.rtc:number: no answer within 0.5s
  ! rtlog: /robot/test.host_cxt/Source0.rtc:number: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /robot/test.host_cxt/Source0.rtc:number
  [5] after 5.6 s
  $ wake senders
  $ rtlog -d --json -f g.rtlog
  {"attachments": [], "channels": [{"entries": 199, *"closed": true, "damaged": 0, "entries": 199,* (glob)

A component that dies ends its part of the recording; when none is left, recording ends:

  $ rtlog -f d.rtlog -t 4 Source0.rtc:number.a ConsoleIn0.rtc:out &
  $ rtlog -f e.rtlog Source0.rtc:number &
  $ sleep 2
  $ kill senders
  $ wait rtlog2
  ! rtlog: /robot/test.host_cxt/Source0.rtc:number: the component is gone, and its process too
  [4] after 2.1 s
  $ wait rtlog
  ! rtlog: Recording for 4.0s.
  ! rtlog: /robot/test.host_cxt/Source0.rtc:number: the component is gone, and its process too
  [5] after 4.1 s
  $ rtlog -d --json -f d.rtlog
  {"attachments": [], "channels": [{"entries": 547, *"closed": true, "damaged": 0, "entries": 547,* (glob)
  $ rtlog -d --json -f e.rtlog
  {"attachments": [], "channels": [{"entries": 548, *"closed": true, "damaged": 0, "entries": 548,* (glob)
