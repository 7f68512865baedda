rtinject sends values to in ports.

world: two
world: these ConsoleOut:Far0 SequenceInComponent

One value, as its constructor or as JSON:

  $ rtact ConsoleOut0.rtc Far0.rtc SequenceInComponent0.rtc
  $ rtinject -c 'RTC.TimedLong({time}, 42)' ConsoleOut0.rtc:in; ctl received ConsoleOut0:in 1
  1 42
  $ rtinject -c 1 -n 0 ConsoleOut0.rtc:in; rtinject -c '{"data": -5}' ConsoleOut0.rtc:in
  $ ctl received ConsoleOut0:in 2
  2 -5
  $ rtinject -c 'RTC.TimedLong(RTC.Time(1, 2), 43)' -n 3 -r 50 ConsoleOut0.rtc:in.name
  $ ctl received ConsoleOut0:in 5
  5 43

A number alone is the data:

  $ rtinject -c 44 ConsoleOut0.rtc:in; ctl received ConsoleOut0:in 6
  6 44

A number among the ports is taken for what it is:

  $ rtinject ConsoleOut0.rtc:in 44
  rtinject: 44: no port; to send that value: -c 44 (see --help)
  [2]

{time} is fresh for every value; so is a time that is left out:

  $ ctl times ConsoleOut0:in
  4
  $ rtinject -c 'RTC.TimedLong({time}, 1)' -n 3 -r 50 ConsoleOut0.rtc:in
  $ ctl times ConsoleOut0:in
  7
  $ rtinject -c '{"data": 1}' -n 3 -r 50 ConsoleOut0.rtc:in; ctl times ConsoleOut0:in
  10

From stdin, a value a line:

  $ printf '# a comment\n\n{"data": 6}\n  RTC.TimedLong({time}, 7)\n' | rtinject -r 0 ConsoleOut0.rtc:in
  $ ctl received ConsoleOut0:in 14
  14 7
  $ printf '{"data": 1}\n{"data": 2}\n{"data": 3}\n' | rtinject -v -n 2 -r 20 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: connected, id $UUID
  rtinject: 2 sent, [0-9.]+ Hz (re)
  $ ctl received ConsoleOut0:in 16
  16 2
  $ printf '{"data": 1}\n{"data": 2}\n' | within 0.9-9 rtinject ConsoleOut0.rtc:in
  $ (echo '{"data": 8}'; sleep 12) | within 3-10 rtinject -t 3 -r 0 ConsoleOut0.rtc:in
  $ ctl received ConsoleOut0:in 19
  19 8

Several ports, all types of the standard:

  $ rtinject -c 'RTC.TimedLong({time}, 9)' ConsoleOut0.rtc:in Far0.rtc:in; ctl @these received Far0:in 1
  1 9
  $ rtinject -c 'RTC.TimedDoubleSeq({time}, [1, 2.5])' SequenceInComponent0.rtc:DoubleSeq
  $ ctl @these received SequenceInComponent0:DoubleSeq 1
  1 [1.0, 2.5]
  $ rtinject -c '{"data": "AQI="}' SequenceInComponent0.rtc:OctetSeq
  $ ctl @these received SequenceInComponent0:OctetSeq 1
  1 b'\x01\x02'

-t ends it, -n too; -1 is for ever, which Ctrl-C and SIGTERM end:

  $ within 0.3-8 rtinject -c '{"data": 1}' -r 20 -t 0.3 ConsoleOut0.rtc:in
  $ interrupt 'ctl connectors ConsoleOut0:in | grep .' \
  >     rtinject -c '{"data": 1}' -r 20 -n -1 ConsoleOut0.rtc:in
  [130]
  $ timeout 1 rtinject -c '{"data": 1}' -r 20 -n -1 ConsoleOut0.rtc:in </dev/null
  [124]
  $ sleep 9 | interrupt 1 rtinject ConsoleOut0.rtc:in
  [130]

It leaves no connection:

  $ ctl connectors ConsoleOut0:in; ctl @these connectors Far0:in
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Far0.rtc
  SequenceInComponent0.rtc

--dry-run prints commands; the values are checked all the same:

  $ rtinject --dry-run -c '{"data": 1}' -t 5 -r 10 ConsoleOut0.rtc:in
  rtinject -c '{"data": 1}' -n -1 -r 10 -t 5 /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ printf '{"data": 1}\nRTC.TimedLong({time}, 2)\n' | rtinject --dry-run ConsoleOut0.rtc:in
  rtinject -c '{"data": 1}' /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  rtinject -c 'RTC.TimedLong({time}, 2)' /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ rtinject --dry-run -c '{"data": "x"}' ConsoleOut0.rtc:in
  rtinject: RTC.TimedLong: data: not a long: 'x'
  [2]

What does not fit is reported before anything is sent:

  $ ctl reset
  $ rtinject -c 'foo(' ConsoleOut0.rtc:in
  rtinject: foo(: column 5: expected a value: the end
  [2]
  $ rtinject -c '__import__("os").system("true")' ConsoleOut0.rtc:in
  rtinject: __import__("os").system("true"): column 17: cannot be read: .system("true")
  [2]
  $ rtinject -c 'Nomod.TimedLong({time}, 5)' ConsoleOut0.rtc:in
  rtinject: Nomod.TimedLong: no such data type: name its IDL file (--idl FILE) or compiled stubs (-m MODULE -p DIR), or look at the bytes (--raw)
  [3]
  $ rtinject -c 'RTC.TimedLong({time}, "abc")' ConsoleOut0.rtc:in
  rtinject: RTC.TimedLong: data: not a long: 'abc'
  [2]
  $ rtinject -c '{"data": 1.5}' ConsoleOut0.rtc:in
  rtinject: RTC.TimedLong: data: not a long: 1.5
  [2]
  $ rtinject -c '{"date": 1}' ConsoleOut0.rtc:in
  rtinject: RTC.TimedLong: no member date (its members: tm, data)
  [2]
  $ rtinject -c 'RTC.TimedFloat({time}, 1)' ConsoleOut0.rtc:in
  rtinject: RTC.TimedFloat: not the type that is wanted, RTC.TimedLong
  [2]
  $ rtinject -c 'RTC.TimedLong({time}, 1)' ConsoleOut0.rtc:in SequenceInComponent0.rtc:Float
  rtinject: RTC.TimedLong: not the type that is wanted, RTC.TimedFloat
  [2]
  $ calls | grep connect
  [1]
  $ printf '{"data": 1}\n\n{"data": "x"}\n{"data": 3}\n' | rtinject -r 0 ConsoleOut0.rtc:in; calls | grep put
  rtinject: line 3: RTC.TimedLong: data: not a long: 'x'
  1 put
  $ rtinject ConsoleOut0.rtc:in </dev/null
  rtinject: no values on stdin
  [1]
  $ rtinject ConsoleOut0.rtc:in <&-
  rtinject: no -c VALUE, and stdin is closed (see --help)
  [2]

Wrong usage:

  $ rtinject
  rtinject: the following arguments are required: PATH:PORT[.NAME] (see --help)
  [2]
  $ rtinject -c 1 ConsoleOut0.rtc
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no port specified; it has /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in (see --help)
  [2]
  $ rtinject -c 1 -r 0 ConsoleOut0.rtc:in
  rtinject: -r 0 is for values from stdin (see --help)
  [2]
  $ rtinject -c 1 -r -1 ConsoleOut0.rtc:in
  rtinject: argument -r/--rate: not a number of Hz above 0: -1 (see --help)
  [2]
  $ rtinject -c 1 --property x ConsoleOut0.rtc:in
  rtinject: not KEY=VALUE: x (see --help)
  [2]

What is no in port, some of several:

  $ rtinject -c '{"data": 1}' ConsoleIn0.rtc:out
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not a DataInPort (it is a DataOutPort)
  [3]
  $ rtinject -c '{"data": 1}' nobody.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  [3]
  $ rtinject -c '{"data": 1}' nobody.rtc:in ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  [5]

Refused, dead, silent:

  $ ctl answer ConsoleOut0:in BUFFER_FULL; rtinject -n 3 -r 50 -c '{"data": 1}' ConsoleOut0.rtc:in Far0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: its buffer is full (BUFFER_FULL)
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it refused 3 of 3 values
  [5]
  $ ctl answer ConsoleOut0:in PORT_ERROR; rtinject -c '{"data": 1}' ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it reports an error of the port (PORT_ERROR)
  [6]
  $ ctl answer ConsoleOut0:in PORT_OK; ctl refuse ConsoleOut0:in RTC_ERROR
  $ rtinject -c '{"data": 1}' ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: refused by the component (RTC_ERROR)
  [6]
  $ ctl refuse ConsoleOut0:in RTC_OK; ctl fail put 1 UNKNOWN
  $ rtinject -c '{"data": 1}' ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: CORBA.UNKNOWN
  [6]
  $ rtinject -n -1 -r 20 -c '{"data": 1}' ConsoleOut0.rtc:in & pid=$!
  $ soon 'ctl connectors ConsoleOut0:in | grep -q .'
  $ rtdis ConsoleOut0.rtc:in; wait $pid
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: the connection has been removed
  [4]
  $ rtinject -n -1 -r 20 -c '{"data": 1}' ConsoleOut0.rtc:in & pid=$!
  $ soon 'ctl connectors ConsoleOut0:in | grep -q .'
  $ kill-mock two; wait $pid
  rtinject: /localhost:\$PORT/test.host_cxt/ConsoleOut0.rtc:in: (connection lost|the component is gone, and its process too) (re)
  [4]
  $ hang these
  $ RTSHELL_TIMEOUT=4 within 4-8 rtinject -c '{"data": 1}' Far0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/Far0.rtc: no answer within 4s
  [4]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: --anyway -c {"data":1} A:in
invocation: -c {"data":1} -n 3 -r 100 B:in A:in
invocation: --anyway -c 1 -n 3 -r 100 B:in A:in
lasting: --anyway -n -1 -r 50 -c {"data":1} B:in
broken component: 5
example: rtinject -c 'RTC.TimedLong({time}, 42)' ConsoleOut0.rtc:in <- rtact ConsoleOut0.rtc
