Values are fetched from components of C++ without ending them: no connector goes while a fetch is being served.

world: senders 200 100 --flavour cpp2
world: these ConsoleIn --flavour cpp12 --context old.host_cxt/%n.rtc

  $ rtact --wait ../old.host_cxt/ConsoleIn0.rtc

Ended by itself, by each signal:

  $ rtprint --pull -n 1 Source0.rtc:number ../old.host_cxt/ConsoleIn0.rtc:out
  ../old.host_cxt/ConsoleIn0.rtc:out: [0.1] 3
  [0] after 0.1 s
  $ rtprint --pull -n 2 Source0.rtc:number ../old.host_cxt/ConsoleIn0.rtc:out
  Source0.rtc:number: [0.1] 25
  ../old.host_cxt/ConsoleIn0.rtc:out: [0.1] 6
  [0] after 0.1 s
  $ rtprint --pull -n 5 Source0.rtc:number ../old.host_cxt/ConsoleIn0.rtc:out
  Source0.rtc:number: [0.2] 40
  ../old.host_cxt/ConsoleIn0.rtc:out: [0.2] 10
  Source0.rtc:number: [0.2] 41
  Source0.rtc:number: [0.2] 42
  Source0.rtc:number: [0.2] 43
  [0] after 0.1 s
  $ rtprint --pull -t 0.5 --stats Source0.rtc:number
  all in all: 98 values, 207.7 Hz, gap 0.0402/4.81/20.2 ms, jitter 8.53 ms, 2.33 kB/s, age 9.72 ms
  [0] after 0.5 s
  $ rtprint --pull Source0.rtc:number &
  $ sleep 1
  $ strike INT rtprint
  $ wait rtprint
  …
  [130] after 1.0 s
  $ rtprint --pull Source0.rtc:number &
  $ sleep 1
  $ strike TERM rtprint
  $ wait rtprint
  …
  [143] after 1.1 s
  $ rtprint --pull Source0.rtc:number &
  $ sleep 1
  $ strike HUP rtprint
  $ wait rtprint
  …
  [129] after 1.1 s
  $ rtlog -q -f a.rtlog --pull Source0.rtc:number &
  $ sleep 1
  $ strike INT rtlog
  $ wait rtlog
  [130] after 1.0 s
  $ rtlog -q -f a.rtlog --pull Source0.rtc:number &
  $ sleep 1
  $ strike TERM rtlog
  $ wait rtlog
  [143] after 1.0 s
  $ rtlog -q -f a.rtlog --pull Source0.rtc:number &
  $ sleep 1
  $ strike HUP rtlog
  $ wait rtlog
  [129] after 1.0 s
  $ rtec --measure 20 Source0.rtc &
  $ sleep 1
  $ strike INT rtec
  $ wait rtec
  [130] after 1.0 s
  $ rtec --measure 20 Source0.rtc &
  $ sleep 1
  $ strike TERM rtec
  $ wait rtec
  [143] after 1.0 s
  $ rtec --measure 20 Source0.rtc &
  $ sleep 1
  $ strike HUP rtec
  $ wait rtec
  [129] after 1.0 s
  $ rtls Source0.rtc ../old.host_cxt/ConsoleIn0.rtc
  Source0.rtc
  ConsoleIn0.rtc
  $ ctl connectors Source0:number
  $ ctl @these connectors ConsoleIn0:out
  $ rtlog -q --pull -i -e 20 -f b.rtlog Source0.rtc:number Source0.rtc:block ../old.host_cxt/ConsoleIn0.rtc:out
  [0] after 0.2 s
  $ rtlog -d -f b.rtlog
  Name: b.rtlog
  Size: 5.14KiB (5266B)
  Start time: 2027-01-15 08:00:10 (10.1)
  First entry time: 2027-01-15 08:00:10 (10.2)
  End time: 2027-01-15 08:00:10 (10.2)
  Number of entries: 20
  Channel 1
    Name: input0
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 9
    Sources:
      /robot/test.host_cxt/Source0.rtc:number
  Channel 2
    Name: input1
    Data type: IDL:RTC/TimedOctetSeq:1.0
    Number of entries: 8
    Sources:
      /robot/test.host_cxt/Source0.rtc:block
  Channel 3
    Name: input2
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 3
    Sources:
      /robot/old.host_cxt/ConsoleIn0.rtc:out
  $ rtec --measure 0.3 Source0.rtc
  0  0  Periodic  200  Running  Active  Source0  -
  measured  203.3 Hz (writes to number)
  [0] after 0.4 s
  $ rtec --measure 0.3 ../old.host_cxt/ConsoleIn0.rtc
  0  0  Periodic  1000  Running  Active  ConsoleIn0  -
  measured  50.0 Hz (writes to out)
  [0] after 0.4 s
  $ rtdoctor -q --measure 0.3 Source0.rtc ../old.host_cxt/ConsoleIn0.rtc
  warn  /robot/old.host_cxt/ConsoleIn0.rtc: keeps 50.0 of 1000 Hz, or does not write to out in each cycle; try: look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 10.0.0.1)
  [0] after 0.4 s

Where a fetch is not answered, the connector stays; the command that is printed removes it later:

  $ ctl delay get 2
  $ RTSHELL_TIMEOUT=0.5 rtprint --pull -t 0.5 Source0.rtc:number
  ! rtprint: /robot/test.host_cxt/Source0.rtc:number: connection $UUID stays, because a call is unanswered and removing it now could end the component; when it answers again: rtdis --force -i $UUID /robot/test.host_cxt/Source0.rtc:number
  ! rtprint: /robot/test.host_cxt/Source0.rtc:number: no answer within 0.5s
  [4] after 0.6 s
  $ ctl connectors Source0:number
  $UUID rtprint
  $ sleep 3
  $ ctl reset
  $ rtdis --force Source0.rtc:number
  $ rtls Source0.rtc ../old.host_cxt/ConsoleIn0.rtc
  Source0.rtc
  ConsoleIn0.rtc
  $ ctl connectors Source0:number
  $ ctl @these connectors ConsoleIn0:out
  $ ctl near_misses
  0
