rtlog records what out ports send.

world: senders 200 1000
world: these Mock ConsoleIn Sensor

A number of entries, over all ports; nothing is left behind in the components, and the file is whole:

  $ rtlog -v -f a.rtlog -i -e 5 Source0.rtc:number.numbers
  rtlog: Recording 5 entries.
  rtlog: 5 messages, 60 octets recorded
  $ TZ=UTC rtlog -d -f a.rtlog | sed 's/[0-9]\{4\}-.*/TIME/'
  Name: a.rtlog
  Size: 1.79KiB (1829B)
  Start time: TIME
  First entry time: TIME
  End time: TIME
  Number of entries: 5
  Channel 1
    Name: numbers
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 5
    Sources:
      /localhost:$PORT/test.host_cxt/Source0.rtc:number
  $ rtlog --json -f a.rtlog | cut -c1-30
  {"number": 0, "port": "numbers
  {"number": 1, "port": "numbers
  {"number": 2, "port": "numbers
  {"number": 3, "port": "numbers
  {"number": 4, "port": "numbers
  $ ls -A
  a.rtlog
  $ ctl connectors Source0:number

Clocks that differ by minutes are reported, once a port:

  $ MOCK_CLOCK=-864000 mock senders 100 12 --context behind.host_cxt/%n.rtc
  $ rtlog -f clock.rtlog -i -e 5 ../behind.host_cxt/Source0.rtc:number
  rtlog: Recording 5 entries.
  rtlog: /localhost:$PORT/behind.host_cxt/Source0.rtc:number: the times in its values are 10.0 days behind this host's clock
  $ rtlog -q -f clock.rtlog -i -e 5 ../behind.host_cxt/Source0.rtc:number; rm clock.rtlog

For some time, from several ports; without a NAME they are input0, input1 …, and ports of one NAME share a channel:

  $ within 0.4-30 rtlog -t 0.4 -f b.rtlog Source0.rtc:number Source0.rtc:block
  rtlog: Recording for 0.4s.
  $ rtlog -d --json -f b.rtlog | grep -o '"name": "[^"]*"\|"sources": [^]]*\|"type": "[^"]*"\|closed": [a-z]*'
  "name": "input0"
  "sources": ["/localhost:$PORT/test.host_cxt/Source0.rtc:number"
  "type": "IDL:RTC/TimedLong:1.0"
  "name": "input1"
  "sources": ["/localhost:$PORT/test.host_cxt/Source0.rtc:block"
  "type": "IDL:RTC/TimedOctetSeq:1.0"
  closed": true
  $ rtlog -t 0.1 -q -f c.rtlog Source0.rtc:number.x ConsoleIn0.rtc:out.x
  $ rtlog -d --json -f c.rtlog | grep -o '"name": "[^"]*"\|"sources": [^]]*'
  "name": "x"
  "sources": ["/localhost:$PORT/test.host_cxt/Source0.rtc:number", "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out"
  $ rtlog -t 0.1 -f d.rtlog Source0.rtc:number.x Source0.rtc:block.x
  rtlog: /localhost:$PORT/test.host_cxt/Source0.rtc:block: x has another data type (IDL:RTC/TimedLong:1.0, IDL:RTC/TimedOctetSeq:1.0)
  rtlog: Recording for 0.1s.
  [5]
  $ rtlog -d --json -f d.rtlog | grep -o '"name": "[^"]*"\|"sources": [^]]*'
  "name": "x"
  "sources": ["/localhost:$PORT/test.host_cxt/Source0.rtc:number"

All that was sent is there, in its order:

  $ rtlog -q -i -e 99 -f o.rtlog Source0.rtc:number Source0.rtc:block
  $ rtlog --csv -f o.rtlog | grep input0 | cut -d, -f5 > numbers
  $ [ $(wc -l < numbers) -gt 20 ] && seq $(head -n 1 numbers) $(tail -n 1 numbers) | cmp - numbers

Until a time (tests/sim/stories/rtlog-until.t); -1, or no end at all, is until Ctrl-C, and stdin does not matter:

  $ interrupt 1.5 rtlog -e -1 -f e.rtlog Source0.rtc:number
  [130]
  $ interrupt 1.5 rtlog -f e.rtlog Source0.rtc:number < /dev/null
  [130]
  $ rtlog -d --json -f e.rtlog | grep -o 'closed": [a-z]*'
  closed": true
  $ ctl connectors Source0:number

Without a file name there is one of the time; -q does not report it:

  $ mkdir here; cd here
  $ rtlog -i -e 1 Source0.rtc:number 2>&1 | sed 's/[0-9]\{5,\}/EPOCH/'
  rtlog: recording to rtlog_EPOCH.mcap
  rtlog: Recording 1 entries.
  $ ls | sed 's/[0-9]\{5,\}/EPOCH/'
  rtlog_EPOCH.mcap
  $ cd ..
  $ cd here; rm *
  $ rtlog -q -i -e 1 Source0.rtc:number; ls | sed 's/[0-9]\{5,\}/EPOCH/'
  rtlog_EPOCH.mcap
  $ cd ..

A file of that name is replaced, not before there is something to record; --append goes on with it:

  $ rtlog -q -i -e 3 -f a.rtlog Source0.rtc:number.numbers; rtlog --json -f a.rtlog | wc -l
  3
  $ rtlog -q -i -e 4 --append -f a.rtlog Source0.rtc:number.numbers; rtlog --json -f a.rtlog | cut -c1-30
  {"number": 0, "port": "numbers
  {"number": 1, "port": "numbers
  {"number": 2, "port": "numbers
  {"number": 3, "port": "numbers
  {"number": 4, "port": "numbers
  {"number": 5, "port": "numbers
  {"number": 6, "port": "numbers
  $ rtlog -q -i -e 1 --append -f a.rtlog Source0.rtc:block.numbers
  rtlog: a.rtlog: numbers is of type IDL:RTC/TimedLong:1.0 in it, not IDL:RTC/TimedOctetSeq:1.0
  [1]
  $ rtlog -f a.rtlog Gone0.rtc:out; rtlog --json -f a.rtlog | wc -l
  rtlog: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  7
  $ rtlog -q -i -e 1 --append -f new.rtlog Source0.rtc:number; rtlog --json -f new.rtlog | wc -l
  1

A file that was cut off is read up to its last whole record, and can be appended to:

  $ head -c 1000 a.rtlog > cut.rtlog; rtlog -q --csv -f cut.rtlog | cut -d, -f1,3
  number,port
  0,numbers
  1,numbers
  2,numbers
  $ rtlog -d --json -f cut.rtlog 2>&1 | sed 's/.*closed/closed/; s/[0-9][0-9.]\{1,\}/N/g'
  closed": false, "damaged": 0, "entries": 3, "file": "cut.rtlog", "first": N, "form": "mcap", "gaps": [], "last": N, "size": N, "started": N, "torn": N}
  rtlog: cut.rtlog: the last N octets are not a whole record and are left out
  rtlog: cut.rtlog: other readers may refuse it; rtlog mend makes a copy that they open
  $ rtlog -q -i -e 1 --append -f cut.rtlog Source0.rtc:number.numbers
  $ rtlog -d --json -f cut.rtlog | grep -o '"closed": [a-z]*\|"torn": [0-9]*'
  "closed": true
  "torn": 0

While somebody records to it nobody else does; reading it is fine:

  $ rtlog -q -f busy.rtlog Source0.rtc:number & soon 'rtlog --json -f busy.rtlog 2>/dev/null | grep -q number'
  $ rtlog -t 1 -f busy.rtlog Source0.rtc:number
  rtlog: busy.rtlog: another rtlog is recording to it
  [1]
  $ rtlog -t 1 --append -f busy.rtlog Source0.rtc:number
  rtlog: busy.rtlog: another rtlog is recording to it
  [1]
  $ kill $!; wait $!
  [143]
  $ rtlog -d --json -f busy.rtlog | grep -o 'closed": [a-z]*'
  closed": true

Who removes the log meanwhile is told what has become of it:

  $ rtlog -q -f gone.rtlog Source0.rtc:number & soon 'rtlog --json -f gone.rtlog 2>/dev/null | grep -q number'
  $ rm gone.rtlog
  > kill $!; wait $!
  rtlog: gone.rtlog: was moved or removed while it was recorded
  [143]

In the two other forms of rtshell: text, and simpkl, which is only read:

  $ rtlog -l text -i -e 2 -f t.log Source0.rtc:number.numbers
  rtlog: Recording 2 entries.
  $ tr '\t' '|' < t.log | sed 's/data=[0-9]*/data=N/g; s/[0-9]\{5,\}/N/g'
  N.N|('numbers', RTC.TimedLong(tm=RTC.Time(sec=N, nsec=N), data=N))
  N.N|('numbers', RTC.TimedLong(tm=RTC.Time(sec=N, nsec=N), data=N))
  $ rtlog -l text -i -e 1 --append -f t.log Source0.rtc:number; wc -l < t.log
  rtlog: Recording 1 entries.
  3
  $ rtlog -l simpkl -i -e 1 -f s.log Source0.rtc:number; rtlog -d --json -f s.log | grep -o 'form": "[a-z]*'
  rtlog: simpkl files are only read; recording as MCAP
  rtlog: Recording 1 entries.
  form": "mcap

Fetched instead of pushed; with properties of the connection, as in rtcon:

  $ rtlog -v --pull -i -e 5 -f p.rtlog Source0.rtc:number
  rtlog: Recording 5 entries.
  rtlog: 5 messages, 60 octets recorded
  $ rtlog --json -f p.rtlog | wc -l
  5
  $ rtlog --property dataport.subscription_type=periodic --property dataport.publisher.push_rate=50 -i -e 2 \
  >     -f p.rtlog Source0.rtc:number
  rtlog: Recording 2 entries.
  $ rtlog --property dataport.subscription_type=odd -i -e 2 -f p.rtlog Source0.rtc:number
  rtlog: /localhost:$PORT/test.host_cxt/Source0.rtc:number: has no subscription_type odd (it has: block, flush, new, nonblock, periodic)
  [6]

Wrong usage:

  $ rtlog
  rtlog: nothing to record: no port specified; rtlog show prints what is in a log (see --help)
  [2]
  $ rtlog Source0.rtc:number -e -5 -i
  rtlog: end time/index out of bounds (see --help)
  [2]
  $ rtlog Source0.rtc:number -e 5
  rtlog: end time/index out of bounds (see --help)
  [2]
  $ rtlog Source0.rtc:number -e 0 -i
  rtlog: end time/index out of bounds (see --help)
  [2]
  $ rtlog Source0.rtc:number -s 5 -i
  rtlog: -s is for rtlog play, serve and export, not for rtlog record (see --help)
  [2]
  $ rtlog Source0.rtc:number -l foo
  rtlog: argument -l/--logger: not one of mcap, simpkl, text: foo (see --help)
  [2]
  $ rtlog Source0.rtc:number -t x
  rtlog: argument -t/--timeout: not a number of seconds above 0: x (see --help)
  [2]
  $ rtlog Source0.rtc:number --property x
  rtlog: not KEY=VALUE: x (see --help)
  [2]
  $ rtlog Source0.rtc:number --json -f x
  rtlog: not a DIRECTORY for --csv, which writes a table for each channel: Source0.rtc:number; of one channel: rtlog export --json LOG | grep Source0.rtc:number (see --help)
  [2]
  $ rtlog -q Source0.rtc:number -i -t 0.1 -f x
  $ rtlog Source0.rtc:number -i -t 0.1 -f x
  rtlog: WARNING: --index has no effect without --end
  rtlog: Recording for 0.1s.

What cannot be recorded; the others are:

  $ rtlog -t 0.1 -f x Source0.rtc:nothing
  rtlog: /localhost:$PORT/test.host_cxt/Source0.rtc: no such port: nothing (its ports: number, block)
  [3]
  $ rtlog -t 0.1 -f x Mock0.rtc:in
  rtlog: /localhost:$PORT/test.host_cxt/Mock0.rtc:in: not a DataOutPort (it is a DataInPort)
  [3]
  $ rtlog -t 0.1 -f x Mock0.rtc:in Gone0.rtc:out Source0.rtc:number.n
  rtlog: /localhost:$PORT/test.host_cxt/Mock0.rtc:in: not a DataOutPort (it is a DataInPort)
  rtlog: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  rtlog: Recording for 0.1s.
  [5]
  $ rtlog -d --json -f x | grep -o '"name": "[^"]*"'
  "name": "n"
  $ rtlog -t 0.1 -f x /localhost:x
  rtlog: /localhost:x: x is not a TCP port (1 to 65535)
  [2]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -f OUT -t 0.5 A:out
invocation: -p -f LOG A:in
invocation: -p --anyway -f LOG A:in
lasting: -f OUT A:out
prepared: rtec Source0.rtc rate 40; rtact Source0.rtc ConsoleOut0.rtc
example: rtlog play robot.mcap --map robot=localhost --only '*Image*' /localhost <- rtcon --ensure ConsoleIn0.rtc:out ConsoleOut0.rtc:in; rtlog -q --events -t 3 -f robot.mcap .
example: rtlog serve robot.mcap --serve 2809 --loop <- rtcon --ensure ConsoleIn0.rtc:out ConsoleOut0.rtc:in; rtlog -q --events -t 3 -f robot.mcap .
example: rtlog serve robot.mcap --when-connected replay.host_cxt <- rtcon --ensure ConsoleIn0.rtc:out ConsoleOut0.rtc:in; rtlog -q --events -t 3 -f robot.mcap .
example: rtlog export run.mcap --json | grep force <- rtlog -f run.mcap -t 1 Source0.rtc:number.force
