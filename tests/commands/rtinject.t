rtinject sends values to in ports.

world: two
world: these ConsoleOut:Far0 SequenceInComponent

One value, as its constructor or as JSON:

  $ rtinject -c 'RTC.TimedLong({time}, 42)' ConsoleOut0.rtc:in; ctl received ConsoleOut0:in 1
  $ rtinject -c '{"data": -5}' ConsoleOut0.rtc:in; ctl received ConsoleOut0:in 2
  $ rtinject -c 'RTC.TimedLong(RTC.Time(1, 2), 43)' -n 3 -r 50 ConsoleOut0.rtc:in.name; ctl received ConsoleOut0:in 5

{time} is fresh for every value:

  $ rtprint -n 3 ConsoleIn0.rtc:out >lines & pid=$!; until ctl connectors ConsoleIn0:out | grep -q .; do :; done
  $ ctl write ConsoleIn0:out 1; ctl write ConsoleIn0:out 2; ctl write ConsoleIn0:out 3; wait $pid; wc -l <lines

From stdin, a value a line:

  $ printf '# a comment\n\n{"data": 6}\n  RTC.TimedLong({time}, 7)\n' | rtinject -r 0 ConsoleOut0.rtc:in; ctl received ConsoleOut0:in 7
  $ printf '{"data": 1}\n{"data": 2}\n{"data": 3}\n' | rtinject -v -n 2 -r 20 ConsoleOut0.rtc:in; ctl received ConsoleOut0:in 9
  $ printf '{"data": 1}\n{"data": 2}\n' | within 0.9-2.5 rtinject ConsoleOut0.rtc:in
  $ (echo '{"data": 8}'; sleep 5) | within 0.4-2 rtinject -t 0.5 -r 0 ConsoleOut0.rtc:in; ctl received ConsoleOut0:in 12

Several ports, all types of the standard:

  $ rtinject -c 'RTC.TimedLong({time}, 9)' ConsoleOut0.rtc:in Far0.rtc:in; ctl @these received Far0:in 1
  $ rtinject -c 'RTC.TimedDoubleSeq({time}, [1, 2.5])' SequenceInComponent0.rtc:DoubleSeq; ctl @these received SequenceInComponent0:DoubleSeq 1
  $ rtinject -c '{"data": "AQI="}' SequenceInComponent0.rtc:OctetSeq; ctl @these received SequenceInComponent0:OctetSeq 1

-t ends it, -n too; -1 is for ever, which Ctrl-C and SIGTERM end:

  $ within 0.3-1.5 rtinject -c '{"data": 1}' -r 20 -t 0.3 ConsoleOut0.rtc:in
  $ interrupt 1 rtinject -c '{"data": 1}' -r 20 -n -1 ConsoleOut0.rtc:in
  $ timeout 1 rtinject -c '{"data": 1}' -r 20 -n -1 ConsoleOut0.rtc:in </dev/null
  $ sleep 9 | interrupt 1 rtinject ConsoleOut0.rtc:in

It leaves no connection:

  $ ctl connectors ConsoleOut0:in; ctl @these connectors Far0:in; rtls

--dry-run prints commands; the values are checked all the same:

  $ rtinject --dry-run -c '{"data": 1}' -t 5 -r 10 ConsoleOut0.rtc:in
  $ printf '{"data": 1}\nRTC.TimedLong({time}, 2)\n' | rtinject --dry-run ConsoleOut0.rtc:in
  $ rtinject --dry-run -c '{"data": "x"}' ConsoleOut0.rtc:in

What does not fit is told before anything is sent:

  $ ctl reset
  $ rtinject -c 'foo(' ConsoleOut0.rtc:in
  $ rtinject -c 5 ConsoleOut0.rtc:in
  $ rtinject -c '__import__("os").system("true")' ConsoleOut0.rtc:in
  $ rtinject -c 'Nomod.TimedLong({time}, 5)' ConsoleOut0.rtc:in
  $ rtinject -c 'RTC.TimedLong({time}, "abc")' ConsoleOut0.rtc:in
  $ rtinject -c '{"data": 1.5}' ConsoleOut0.rtc:in
  $ rtinject -c '{"date": 1}' ConsoleOut0.rtc:in
  $ rtinject -c 'RTC.TimedFloat({time}, 1)' ConsoleOut0.rtc:in
  $ rtinject -c 'RTC.TimedLong({time}, 1)' ConsoleOut0.rtc:in SequenceInComponent0.rtc:Float
  $ calls | grep connect
  $ printf '{"data": 1}\n\n{"data": "x"}\n{"data": 3}\n' | rtinject -r 0 ConsoleOut0.rtc:in; calls | grep put
  $ rtinject ConsoleOut0.rtc:in </dev/null
  $ rtinject ConsoleOut0.rtc:in <&-

Wrong usage:

  $ rtinject
  $ rtinject -c 1 ConsoleOut0.rtc
  $ rtinject -c 1 -r 0 ConsoleOut0.rtc:in
  $ rtinject -c 1 -r -1 ConsoleOut0.rtc:in
  $ rtinject -c 1 --property x ConsoleOut0.rtc:in

What is no in port, some of several:

  $ rtinject -c '{"data": 1}' ConsoleIn0.rtc:out
  $ rtinject -c '{"data": 1}' nobody.rtc:in
  $ rtinject -c '{"data": 1}' nobody.rtc:in ConsoleOut0.rtc:in

Refused, dead, silent:

  $ ctl answer ConsoleOut0:in BUFFER_FULL; rtinject -n 3 -r 50 -c '{"data": 1}' ConsoleOut0.rtc:in Far0.rtc:in
  $ ctl answer ConsoleOut0:in PORT_ERROR; rtinject -c '{"data": 1}' ConsoleOut0.rtc:in
  $ ctl answer ConsoleOut0:in PORT_OK; ctl refuse ConsoleOut0:in RTC_ERROR; rtinject -c '{"data": 1}' ConsoleOut0.rtc:in
  $ ctl refuse ConsoleOut0:in RTC_OK; ctl fail put 1 UNKNOWN; rtinject -c '{"data": 1}' ConsoleOut0.rtc:in
  $ rtinject -n -1 -r 20 -c '{"data": 1}' ConsoleOut0.rtc:in & pid=$!; until ctl connectors ConsoleOut0:in | grep -q .; do :; done
  $ rtdis ConsoleOut0.rtc:in; wait $pid
  $ rtinject -n -1 -r 20 -c '{"data": 1}' ConsoleOut0.rtc:in & pid=$!; until ctl connectors ConsoleOut0:in | grep -q .; do :; done
  $ kill-mock two; wait $pid
  $ hang these; RTSHELL_TIMEOUT=0.5 within 0.5-2 rtinject -c '{"data": 1}' Far0.rtc:in; resume these
