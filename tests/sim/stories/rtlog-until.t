rtlog records until a time, in seconds since 1970.

world: senders 200 8

  $ rtlog -e 1800000002 -f a.mcap Source0.rtc:number
  ! rtlog: Recording until 2027-01-15 08:00:02 (2.0).
  [0] after 2.0 s
  $ rtlog show a.mcap
  Name: a.mcap
  Size: 28.67KiB (29359B)
  Start time: 2027-01-15 08:00:00 (0.0)
  First entry time: 2027-01-15 08:00:00 (0.0)
  End time: 2027-01-15 08:00:01 (2.0)
  Number of entries: 398
  Channel 1
    Name: input0
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 398
    Sources:
      /robot/test.host_cxt/Source0.rtc:number
  $ rtlog -e 1800000001 -f a.mcap Source0.rtc:number
  ! rtlog: end time/index out of bounds (see --help)
  [2]
