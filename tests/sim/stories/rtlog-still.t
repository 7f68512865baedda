What the buffer of a port could not hold while rtlog stood still is missing, which is in the log (about how much, only the component knows), and told at the end.

world: senders 1000 8

  $ rtlog record -q --events --only '*:number' -f d.mcap Source0.rtc &
  $ sleep 2
  $ stop rtlog
  $ sleep 6
  $ wake rtlog
  $ sleep 4
  $ ctl @senders sent Source0:number
  12001
  $ strike TERM rtlog
  $ wait rtlog
  ! rtlog: values are missing (intervals: 1); rtlog show says when
  [143] after 12.0 s
  $ rtlog show d.mcap
  Name: d.mcap
  Size: 637.49KiB (652786B)
  Start time: 2027-01-15 08:00:00 (0.0)
  First entry time: 2027-01-15 08:00:00 (0.0)
  End time: 2027-01-15 08:00:11 (12.0)
  Number of entries: 10091
  Missing: 2027-01-15 08:00:02 (2.0) until 2027-01-15 08:00:08 (8.0): 1906 values of /robot/test.host_cxt/Source0.rtc:number: rtlog stood still, and they exceeded the port's buffer
  Attachment: system-1.rtsys, 2027-01-15 08:00:00 (0.0)
  Attachment: components-1.json, 2027-01-15 08:00:00 (0.0)
  Channel 1
    Name: /robot/test.host_cxt/Source0.rtc:number
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 10088
    Sources:
      /robot/test.host_cxt/Source0.rtc:number
  Channel 2
    Name: /events
    Data type: rtlog.Event
    Number of entries: 3
    Sources:
  Channel 3
    Name: /logs
    Data type: rtlog.Record
    Number of entries: 0
    Sources:

The events beside the values say it at once:

  $ rtlog record -q --events --only '*:number' --at-most 0.5 -f e.mcap Source0.rtc &
  $ sleep 2
  $ stop rtlog
  $ sleep 6
  $ wake rtlog
  $ sleep 4
  $ rtlog export --json e.mcap
  {"number": 0, "port": "/events", "received": 12.0, "type": "rtlog.Event", "value": {"event": "APPEARED", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": ""}}
  {"number": 1, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 12.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 12013, "tm": {"nsec": 12310743, "sec": 1800000012}}}
  {"number": 2, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 13.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 13013, "tm": {"nsec": 12310743, "sec": 1800000013}}}
  {"number": 3, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 20.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 14005, "tm": {"nsec": 4310846, "sec": 1800000014}}}
  {"number": 4, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 21.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 21005, "tm": {"nsec": 4310846, "sec": 1800000021}}}
  {"number": 5, "port": "/events", "received": 22.0, "type": "rtlog.Event", "value": {"event": "MISSING", "kind": "RECORDER", "path": "/robot/test.host_cxt/Source0.rtc", "subject": "number"}}
  {"number": 6, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 23.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 23006, "tm": {"nsec": 5310773, "sec": 1800000023}}}
  {"number": 7, "port": "/events", "received": 23.9, "type": "rtlog.Event", "value": {"event": "NO_HEARTBEAT", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": ""}}
  ! rtlog: e.mcap: recording has not ended regularly, or goes on
  ! rtlog: e.mcap: other readers may refuse it; rtlog mend makes a copy that they open
  ! rtlog: e.mcap: values are missing in it (intervals: 1); rtlog show says when
  $ strike TERM rtlog
  $ wait rtlog
  ! rtlog: values are missing (intervals: 1); rtlog show says when
  [143] after 12.0 s
