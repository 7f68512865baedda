rtlog records a whole robot: every out port below a directory, now and later, and what happens.

world: observed
world: senders 100 100

A directory with events. A component that dies and comes back goes on in its channel; no port has two connectors:

  $ rtlog -f a.mcap --events . &
  $ sleep 3
  $ ctl observers ConsoleIn0
  IDL:OpenRTM/ComponentObserver:1.0
  $ ctl @senders connectors Source0:number
  $UUID rtlog
  $ rtact ConsoleIn0.rtc
  $ ctl error ConsoleIn0
  $ kill senders
  $ sleep 5
  $ mock senders 100 100
  $ sleep 10
  $ strike TERM rtlog
  $ wait rtlog
  ! rtlog: Recording 5 ports.
  ! rtlog: /robot/test.host_cxt/Source0.rtc:number: the component is gone, and its process too
  ! rtlog: /robot/test.host_cxt/Source0.rtc:block: the component is gone, and its process too
  [143] after 18.1 s
  $ rtlog -d -f a.mcap
  …
    Name: /robot/test.host_cxt/Source0.rtc:number
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 1300
  …
  $ rtlog --json -f a.mcap
  …
  {.*rtlog.Event.*"ACTIVE".*} (re)
  …
  {.*rtlog.Event.*"ERROR".*"ConsoleIn0.rtc: Error".*} (re)
  …
  {.*rtlog.Event.*"DIED".*"Source0.rtc: died".*} (re)
  …
  {.*rtlog.Event.*"BACK".*Source0.rtc.*} (re)
  …
  $ rtplot -f a.mcap --ascii Source0.rtc:number
  /robot/test.host_cxt/Source0.rtc:number
  * data  min 2  max 1001  last 1001
  1000 |                                                                       ***
       |                                                                  ******
       |                                                              *****
       |                                                         ******
       |                                                     *****
   500 |                                                ******
       |           **                               *****
       |       *****                           ******
       |  ******                           *****
       |***                             ****
       ++-----------!-------+--------------------+-------------------+------------
        0                   5                   10                  15 s
  0 is 2027-01-15 08:00:00.010
  +2.999 s  ConsoleIn0.rtc: Error
  +2.999 s  Source0.rtc: died
  $ rtplot -f a.mcap --ascii ConsoleIn0.rtc Source0.rtc
  /robot/test.host_cxt/ConsoleIn0.rtc
  * state  min Inactive  max Error  last Error
     Error |            **********************************************************
           |            *
           |            *
           |            *
    Active |            *
           |            *
           |            *
           |            *
  Inactive |*************
  /robot/test.host_cxt/Source0.rtc
  * state  min Active  max Active  last Active
           |
           |
           |
           |
    Active |*************                          *******************************
           |
           |
           |
           |
           ++-----------!------+------------------+-------------------+-----------
            0                  5                 10                  15 s
  0 is 2027-01-15 08:00:00.010
  +3.000 s  ConsoleIn0.rtc: Error
  +3.000 s  Source0.rtc: died
  $ rtplot -f a.mcap --ascii Nobody0.rtc
  ! rtplot: a.mcap: no such channel: Nobody0.rtc (there are: /robot/test.host_cxt/ConsoleIn0.rtc:out, /robot/test.host_cxt/Mock0.rtc:out, /robot/test.host_cxt/Motor0.rtc:out, /robot/test.host_cxt/Source0.rtc:number, /robot/test.host_cxt/Source0.rtc:block, /events, /logs)
  [3]
  $ rtplot -f a.mcap --rate ConsoleIn0.rtc
  ! rtplot: a.mcap: no such channel: ConsoleIn0.rtc; did you mean /robot/test.host_cxt/ConsoleIn0.rtc:out?
  [3]
  $ ctl @senders2 connectors Source0:number
  $ ctl observers ConsoleIn0

Some ports, and some of their values:

  $ rtlog -q -t 2 -f b.mcap --only '*number' --every 10 .
  [0] after 2.0 s
  $ rtlog -d -f b.mcap
  Name: b.mcap
  Size: 4.41KiB (4511B)
  Start time: 2027-01-15 08:00:18 (18.1)
  First entry time: 2027-01-15 08:00:18 (18.1)
  End time: 2027-01-15 08:00:20 (20.0)
  Number of entries: 20
  Channel 1
    Name: /robot/test.host_cxt/Source0.rtc:number
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 20
    Sources:
      /robot/test.host_cxt/Source0.rtc:number
  $ rtlog -q -t 2 -f b.mcap --not TimedLong --at-most '5:*block' 'Sou*'
  [0] after 2.0 s
  $ rtlog -d -f b.mcap
  Name: b.mcap
  Size: 4.84KiB (4961B)
  Start time: 2027-01-15 08:00:20 (20.2)
  First entry time: 2027-01-15 08:00:20 (20.2)
  End time: 2027-01-15 08:00:22 (22.1)
  Number of entries: 11
  Channel 1
    Name: /robot/test.host_cxt/Source0.rtc:block
    Data type: IDL:RTC/TimedOctetSeq:1.0
    Number of entries: 11
    Sources:
      /robot/test.host_cxt/Source0.rtc:block

Connections come and go, are made again under their id, with another far end, too; those of tools are no part of the system:

  $ rtlog -q -f j.mcap --events --not '*Source0*' --not '*Console*' --not '*M*' . &
  $ sleep 2
  $ rtprint -q -n 1 Source0.rtc:number
  …
  $ rtcon -i again Source0.rtc:number ConsoleOut0.rtc:in
  $ sleep 5
  $ rtdis -i again Source0.rtc:number
  $ rtcon -i again Source0.rtc:number ConsoleOut0.rtc:in
  $ sleep 5
  $ rtdis -i again Source0.rtc:number
  $ rtcon -i again Source0.rtc:number Mock0.rtc:in
  $ sleep 5
  $ rtdis -i again Source0.rtc:number
  $ sleep 5
  $ strike TERM rtlog
  $ wait rtlog
  [143] after 22.1 s
  $ rtlog --json -f j.mcap
  {"number": 0, "port": "/events", "received": 22.2, "type": "rtlog.Event", "value": {"event": "APPEARED", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/ConsoleIn0.rtc", "subject": ""}}
  {"number": 1, "port": "/events", "received": 22.2, "type": "rtlog.Event", "value": {"event": "APPEARED", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/ConsoleOut0.rtc", "subject": ""}}
  {"number": 2, "port": "/events", "received": 22.2, "type": "rtlog.Event", "value": {"event": "APPEARED", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/Microwave0.rtc", "subject": ""}}
  {"number": 3, "port": "/events", "received": 22.2, "type": "rtlog.Event", "value": {"event": "APPEARED", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/Mock0.rtc", "subject": ""}}
  {"number": 4, "port": "/events", "received": 22.2, "type": "rtlog.Event", "value": {"event": "APPEARED", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/Motor0.rtc", "subject": ""}}
  {"number": 5, "port": "/events", "received": 22.2, "type": "rtlog.Event", "value": {"event": "APPEARED", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": ""}}
  {"number": 6, "port": "/events", "received": 24.5, "type": "rtlog.Event", "value": {"event": "PORT_CONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": "Source0.number"}}
  {"number": 7, "port": "/events", "received": 24.5, "type": "rtlog.Event", "value": {"event": "PORT_CONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/ConsoleOut0.rtc", "subject": "ConsoleOut0.in"}}
  {"number": 8, "port": "/events", "received": 30.5, "type": "rtlog.Event", "value": {"event": "PORT_DISCONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": "Source0.number"}}
  {"number": 9, "port": "/events", "received": 30.5, "type": "rtlog.Event", "value": {"event": "PORT_CONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": "Source0.number"}}
  {"number": 10, "port": "/events", "received": 30.5, "type": "rtlog.Event", "value": {"event": "PORT_DISCONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/ConsoleOut0.rtc", "subject": "ConsoleOut0.in"}}
  {"number": 11, "port": "/events", "received": 30.5, "type": "rtlog.Event", "value": {"event": "PORT_CONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/ConsoleOut0.rtc", "subject": "ConsoleOut0.in"}}
  {"number": 12, "port": "/events", "received": 34.5, "type": "rtlog.Event", "value": {"event": "PORT_DISCONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/ConsoleOut0.rtc", "subject": "ConsoleOut0.in"}}
  {"number": 13, "port": "/events", "received": 34.5, "type": "rtlog.Event", "value": {"event": "PORT_DISCONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": "Source0.number"}}
  {"number": 14, "port": "/events", "received": 34.5, "type": "rtlog.Event", "value": {"event": "PORT_CONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": "Source0.number"}}
  {"number": 15, "port": "/events", "received": 36.0, "type": "rtlog.Event", "value": {"event": "PORT_CONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/Mock0.rtc", "subject": "Mock0.in"}}
  {"number": 16, "port": "/events", "received": 40.5, "type": "rtlog.Event", "value": {"event": "PORT_DISCONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": "Source0.number"}}
  {"number": 17, "port": "/events", "received": 40.8, "type": "rtlog.Event", "value": {"event": "PORT_DISCONNECT", "kind": "PORT_EVENT", "path": "/robot/test.host_cxt/Mock0.rtc", "subject": "Mock0.in"}}

A recorder that stood still lets components go, which would have waited for it:

  $ rtlog -f h.mcap --events Source0.rtc &
  $ sleep 3
  $ stop rtlog
  $ sleep 3
  $ wake rtlog
  $ sleep 5
  $ rtcat --json Source0.rtc:number
  {.*"dataport.subscription_type": "new".*} (re)
  $ strike TERM rtlog
  $ wait rtlog
  ! rtlog: Recording 2 ports.
  ! rtlog: this machine has too much to do: for 50% of 5 s components would have waited for rtlog; 2 ports do not call it in their own cycle any more
  [143] after 11.0 s
  $ rtlog -d -f h.mcap
  Name: h.mcap
  Size: 221.55KiB (226867B)
  Start time: 2027-01-15 08:00:44 (44.2)
  First entry time: 2027-01-15 08:00:44 (44.2)
  End time: 2027-01-15 08:00:55 (55.2)
  Number of entries: 1809
  Attachment: system-1.rtsys, 2027-01-15 08:00:44 (44.2)
  Attachment: components-1.json, 2027-01-15 08:00:44 (44.2)
  Channel 1
    Name: /robot/test.host_cxt/Source0.rtc:number
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 902
    Sources:
      /robot/test.host_cxt/Source0.rtc:number
  Channel 2
    Name: /robot/test.host_cxt/Source0.rtc:block
    Data type: IDL:RTC/TimedOctetSeq:1.0
    Number of entries: 902
    Sources:
      /robot/test.host_cxt/Source0.rtc:block
  Channel 3
    Name: /events
    Data type: rtlog.Event
    Number of entries: 5
    Sources:
  Channel 4
    Name: /logs
    Data type: rtlog.Record
    Number of entries: 0
    Sources:
  $ rtlog -f i.mcap --property dataport.subscription_type=flush Source0.rtc:number &
  $ sleep 3
  $ stop rtlog
  $ sleep 3
  $ wake rtlog
  $ wait rtlog
  ! rtlog: this machine has too much to do: for 50% of 5 s components would have waited for rtlog; 1 ports do not call it in their own cycle any more
  ! rtlog: /robot/test.host_cxt/Source0.rtc:number: given up, as its component would be held up
  [1] after 6.1 s
