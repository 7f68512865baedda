What the buffer of a port could not hold while rtlog stood still is missing, which is in the log (about how much, only the component knows), and told at the end.

world: senders 2000 8

  $ rtlog record -q --events --only '*:number' -f d.mcap Source0.rtc &
  $ sleep 5
  $ stop rtlog
  $ sleep 6
  $ wake rtlog
  $ sleep 10
  $ ctl @senders sent Source0:number
  42001
  $ strike TERM rtlog
  $ wait rtlog
  ! rtlog: values are missing (intervals: 1); rtlog show says when
  [143] after 21.0 s
  $ rtlog show d.mcap
  Name: d.mcap
  Size: 2.08MiB (2177748B)
  Start time: 2027-01-15 08:00:00 (0.0)
  First entry time: 2027-01-15 08:00:00 (0.0)
  End time: 2027-01-15 08:00:20 (21.0)
  Number of entries: 34085
  Missing: 2027-01-15 08:00:05 (5.0) until 2027-01-15 08:00:11 (11.0): 7908 values of /robot/test.host_cxt/Source0.rtc:number: rtlog stood still, and they exceeded the port's buffer
  Attachment: system-1.rtsys, 2027-01-15 08:00:00 (0.0)
  Attachment: components-1.json, 2027-01-15 08:00:00 (0.0)
  Channel 1
    Name: /robot/test.host_cxt/Source0.rtc:number
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 34081
    Sources:
      /robot/test.host_cxt/Source0.rtc:number
  Channel 2
    Name: /events
    Data type: rtlog.Event
    Number of entries: 4
    Sources:
  Channel 3
    Name: /logs
    Data type: rtlog.Record
    Number of entries: 0
    Sources:

The events beside the values say it at once:

  $ rtlog record -q --events --only '*:number' --at-most 0.5 -f e.mcap Source0.rtc &
  $ sleep 5
  $ stop rtlog
  $ sleep 6
  $ wake rtlog
  $ sleep 10
  $ rtlog export --json e.mcap
  {"number": 0, "port": "/events", "received": 21.0, "type": "rtlog.Event", "value": {"event": "APPEARED", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": ""}}
  {"number": 1, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 21.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 42024, "tm": {"nsec": 11810779, "sec": 1800000021}}}
  {"number": 2, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 22.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 44023, "tm": {"nsec": 11310815, "sec": 1800000022}}}
  {"number": 3, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 24.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 48024, "tm": {"nsec": 11810779, "sec": 1800000024}}}
  {"number": 4, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 32.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 52008, "tm": {"nsec": 3810644, "sec": 1800000026}}}
  {"number": 5, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 33.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 66008, "tm": {"nsec": 3810644, "sec": 1800000033}}}
  {"number": 6, "port": "/events", "received": 34.0, "type": "rtlog.Event", "value": {"event": "MISSING", "kind": "RECORDER", "path": "/robot/test.host_cxt/Source0.rtc", "subject": "number"}}
  {"number": 7, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 35.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 70009, "tm": {"nsec": 4310846, "sec": 1800000035}}}
  {"number": 8, "port": "/events", "received": 35.9, "type": "rtlog.Event", "value": {"event": "NO_HEARTBEAT", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": ""}}
  {"number": 9, "port": "/events", "received": 36.9, "type": "rtlog.Event", "value": {"event": "ANSWERS", "kind": "LIFE_EVENT", "path": "/robot/test.host_cxt/Source0.rtc", "subject": ""}}
  {"number": 10, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 37.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 74008, "tm": {"nsec": 3810644, "sec": 1800000037}}}
  {"number": 11, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 39.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 78009, "tm": {"nsec": 4310846, "sec": 1800000039}}}
  {"number": 12, "port": "/robot/test.host_cxt/Source0.rtc:number", "received": 41.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 82008, "tm": {"nsec": 3810644, "sec": 1800000041}}}
  ! rtlog: e.mcap: recording has not ended regularly, or goes on
  ! rtlog: e.mcap: other readers may refuse it; rtlog mend makes a copy that they open
  ! rtlog: e.mcap: values are missing in it (intervals: 1); rtlog show says when
  $ strike TERM rtlog
  $ wait rtlog
  ! rtlog: values are missing (intervals: 1); rtlog show says when
  [143] after 21.0 s
