rtlog records into a ring; a trigger makes a file of the past and the future. It rotates files.

world: observed
world: senders 100 100

An error, with what came before it and after it; the ring is bounded, and goes on:

  $ rtlog --ring 4 --after 2 --trigger error -f a.mcap . &
  $ sleep 6
  $ rtact ConsoleIn0.rtc
  $ ctl error ConsoleIn0
  $ sleep 4
  $ show rtlog
  ! rtlog: Recording 5 ports.
  ! rtlog: trigger: error ConsoleIn0.rtc
  ! rtlog: kept a-20270115-080006-error-ConsoleIn0.rtc.mcap
  $ ls a-2*
  a-20270115-080006-error-ConsoleIn0.rtc.mcap
  $ rtlog -d -f a-20270115-080006-error-ConsoleIn0.rtc.mcap
  Name: a-20270115-080006-error-ConsoleIn0.rtc.mcap
  Size: 162.67KiB (166569B)
  Start time: 2027-01-15 08:00:02 (2.1)
  First entry time: 2027-01-15 08:00:02 (2.1)
  End time: 2027-01-15 08:00:08 (8.1)
  Number of entries: 1204
  Attachment: system-1.rtsys, 2027-01-15 08:00:00 (0.0)
  Attachment: components-1.json, 2027-01-15 08:00:00 (0.0)
  Channel 1
    Name: /robot/test.host_cxt/ConsoleIn0.rtc:out
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 0
    Sources:
      /robot/test.host_cxt/ConsoleIn0.rtc:out
  Channel 2
    Name: /robot/test.host_cxt/Mock0.rtc:out
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 0
    Sources:
      /robot/test.host_cxt/Mock0.rtc:out
  Channel 3
    Name: /robot/test.host_cxt/Motor0.rtc:out
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 0
    Sources:
      /robot/test.host_cxt/Motor0.rtc:out
  Channel 4
    Name: /robot/test.host_cxt/Source0.rtc:number
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 600
    Sources:
      /robot/test.host_cxt/Source0.rtc:number
  Channel 5
    Name: /robot/test.host_cxt/Source0.rtc:block
    Data type: IDL:RTC/TimedOctetSeq:1.0
    Number of entries: 600
    Sources:
      /robot/test.host_cxt/Source0.rtc:block
  Channel 6
    Name: /triggers
    Data type: rtlog.Event
    Number of entries: 1
    Sources:
  Channel 7
    Name: /events
    Data type: rtlog.Event
    Number of entries: 3
    Sources:
  Channel 8
    Name: /logs
    Data type: rtlog.Record
    Number of entries: 0
    Sources:
  $ rtlog --trigger-now a.mcap
  $ rtlog --trigger-now a.mcap
  $ sleep 4
  $ show rtlog
  ! rtlog: trigger: now
  ! rtlog: kept a-20270115-080010-now.mcap
  $ ls a-*
  a-000006.mcap
  a-000007.mcap
  a-000008.mcap
  a-000009.mcap
  a-000010.mcap
  a-20270115-080006-error-ConsoleIn0.rtc.mcap
  a-20270115-080010-now.mcap
  $ strike TERM rtlog
  $ wait rtlog
  [143] after 14.1 s
  $ rtlog --trigger-now a.mcap
  ! rtlog: a.mcap: no rtlog records a ring of that name
  [1]
  $ ls a*
  a-000006.mcap
  a-000007.mcap
  a-000008.mcap
  a-000009.mcap
  a-000010.mcap
  a-20270115-080006-error-ConsoleIn0.rtc.mcap
  a-20270115-080010-now.mcap

A value, in memory; only the file of the trigger is written:

  $ rtlog -q -t 6 --ring 2 --in-memory --after 0.5 --trigger 'Source0.rtc:number.data > 0' -f m.mcap Source0.rtc:number
  [0] after 6.0 s
  $ ls m*
  m-20270115-080014-Source0.rtc-number.data-0.mcap

Silence, after which what is left at the end is kept, too:

  $ rtlog -q -t 4 --ring 9 --after 60 --trigger 'silent Source0.rtc:number 0.4' -f s.mcap Source0.rtc:number &
  $ sleep 1.5
  $ rtdeact Source0.rtc
  $ wait rtlog
  [0] after 4.2 s
  $ rtact Source0.rtc
  $ ls s*
  s-000001.mcap
  s-000002.mcap
  s-20270115-080022-silent-Source0.rtc-number-0.4.mcap

Other files after some time; the last are kept:

  $ rtlog -q -t 4 --rotate 0.5 --keep 2 -f r.mcap Source0.rtc:number
  [0] after 4.0 s
  $ ls r*
  r-000007.mcap
  r-000008.mcap
  $ rtlog -q -t 1 --rotate 2K -f q.mcap Source0.rtc:number
  [0] after 1.0 s
  $ ls q*
  q-000001.mcap
  q-000002.mcap
  q-000003.mcap
  q-000004.mcap
  $ rtlog show q.mcap
  ! rtlog: q.mcap: no such file; it was recorded as q-000001.mcap … q-000004.mcap
  [1]
