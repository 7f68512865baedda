rtlog plays logs into in ports, or to the terminal.

world: senders 100 1000
world: these ConsoleOut ConsoleOut:ConsoleOut1
alone: time

  $ rtact ConsoleOut0.rtc ConsoleOut1.rtc
  $ rtlog -q -i -e 10 -f a.rtlog Source0.rtc:number.numbers
  $ rtlog -q -i -e 10 --append -f a.rtlog Source0.rtc:block.blocks
  $ rtlog --csv -f a.rtlog | grep numbers | cut -d, -f5 > numbers; last=$(tail -n 1 numbers)

By NAME, or by place; as long as recording took; nothing is left behind:

  $ within 0.05-10 rtlog -v -p -i -e 10 -f a.rtlog ConsoleOut0.rtc:in.numbers
  rtlog: Playing 10 entries.
  $ [ "$(ctl @these received ConsoleOut0:in 10)" = "10 $last" ]
  $ within 0.05-10 rtlog -p -i -e 10 -f a.rtlog ConsoleOut0.rtc:in ConsoleOut1.rtc:in.numbers
  rtlog: Playing 10 entries.
  $ ctl @these received ConsoleOut0:in 20 | cut -d' ' -f1
  20
  $ ctl @these received ConsoleOut1:in 10 | cut -d' ' -f1
  10
  $ ctl @these connectors ConsoleOut0:in

Faster, slower, not longer than, in cycles, several a cycle:

  $ rtlog -q -i -e 5 -f b.rtlog --property dataport.subscription_type=periodic \
  >     --property dataport.publisher.push_rate=10 --property dataport.publisher.push_policy=new \
  >     Source0.rtc:number.n
  $ within 0.3-10 rtlog -p -f b.rtlog ConsoleOut0.rtc:in.n
  rtlog: End of log reached.
  $ within 0-10 rtlog -p -f b.rtlog -r 100 ConsoleOut0.rtc:in.n
  rtlog: End of log reached.
  $ within 0.6-10 rtlog -p -f b.rtlog -r 0.5 ConsoleOut0.rtc:in.n
  rtlog: End of log reached.
  $ within 0.2-10 rtlog -p -f b.rtlog -t 0.2 ConsoleOut0.rtc:in.n
  rtlog: Playing for 0.2s.
  $ within 0.4-10 rtlog -p -f b.rtlog -x 2.5 ConsoleOut0.rtc:in.n
  rtlog: End of log reached.
  $ within 0.8-10 rtlog -p -f b.rtlog -n -r 2 -x 2.5 ConsoleOut0.rtc:in.n
  rtlog: End of log reached.
  $ within 0-10 rtlog -p -f b.rtlog -n ConsoleOut0.rtc:in.n
  rtlog: End of log reached.
  $ rtlog -p -f b.rtlog -n -r 0.5 ConsoleOut0.rtc:in.n
  rtlog: -n plays the whole part of -r entries in a cycle: -r must be 1 or more (see --help)
  [2]

A part:

  $ ctl @these received ConsoleOut0:in | cut -d' ' -f1 > before
  $ rtlog -p -f b.rtlog -i -e 2 ConsoleOut0.rtc:in.n
  rtlog: Playing 2 entries.
  $ rtlog -p -f b.rtlog -i -s 1 -e 2 ConsoleOut0.rtc:in.n
  rtlog: Playing from entry 1 to entry 2.
  $ rtlog -p -f b.rtlog -i -s 3 ConsoleOut0.rtc:in.n
  rtlog: Playing from entry 3.
  rtlog: End of log reached.
  $ echo $(($(ctl @these received ConsoleOut0:in | cut -d' ' -f1) - $(cat before)))
  6
  $ rtlog -p -f b.rtlog -i -s 99 ConsoleOut0.rtc:in.n
  rtlog: b.rtlog: the start is after the last entry
  [1]
  $ rtlog -p -f b.rtlog -e 99 ConsoleOut0.rtc:in.n
  rtlog: b.rtlog: the end is before the first entry
  [1]
  $ rtlog -p -f b.rtlog -i -s 4 -e 1 ConsoleOut0.rtc:in.n
  rtlog: the end is before the start (see --help)
  [2]
  $ rtlog -p -f b.rtlog -i -s -3 ConsoleOut0.rtc:in.n
  rtlog: start or end out of bounds (see --help)
  [2]
  $ rtlog -p -f b.rtlog -s 1e300 ConsoleOut0.rtc:in.n
  rtlog: start or end out of bounds (see --help)
  [2]
  $ rtlog -p -f b.rtlog -i ConsoleOut0.rtc:in.n
  rtlog: WARNING: --index has no effect without --start or --end
  rtlog: End of log reached.

What was recorded big-endian is played to a port that wants little-endian data:

  $ rtlog -q -i -e 3 -f big.rtlog --property dataport.serializer.cdr.endian=big Source0.rtc:number.n
  $ ctl @these received ConsoleOut0:in | cut -d' ' -f1 > before; rtlog -q -p -f big.rtlog ConsoleOut0.rtc:in
  $ [ "$(ctl @these received ConsoleOut0:in $(($(cat before) + 3)))" = \
  >     "$(($(cat before) + 3)) $(rtlog --csv -f big.rtlog | tail -n 1 | cut -d, -f5)" ]

To the terminal, at their pace; --json and --csv, too:

  $ rtlog -p -r 1000 -f a.rtlog | sed 's/\[[0-9.]*\] <.*/<BYTES>/; s/\[[0-9.]*\] [0-9]*/[TIME] N/' | sort |
  > uniq -c
       10 blocks: <BYTES>
       10 numbers: [TIME] N
  $ rtlog -p -f b.rtlog -i -e 1 | sed 's/[0-9]\{1,\}/N/g'
  [N.N] N
  $ within 0.3-10 rtlog -p --json -f b.rtlog | wc -l
  5
  $ within 0.3-10 rtlog -p --csv --ns -f b.rtlog > paced
  $ rtlog --csv --ns -f b.rtlog | cmp - paced; wc -l < paced
  6
  $ terminal 100 rtlog -p -f a.rtlog -i -s 10 -e 10 | sed 's/\[[0-9.]*\] <.. ../[TIME] <NN NN/'
  blocks: [TIME] <NN NN 00 00 00 00 00 00 … 992 more>
  $ rtlog -p -f a.rtlog | head -n 1 | wc -l
  1

Wrong ports:

  $ rtlog -p -f b.rtlog ConsoleOut0.rtc:in.foo
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: no such channel in b.rtlog: foo (there are: n)
  [3]
  $ rtlog -p -f b.rtlog ConsoleOut0.rtc:in ConsoleOut0.rtc:in
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: no such channel in b.rtlog: number 2 (there are: n)
  rtlog: End of log reached.
  [5]
  $ rtlog -p -f a.rtlog ConsoleOut0.rtc:in.blocks
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: data types differ: IDL:RTC/TimedOctetSeq:1.0 in the log, IDL:RTC/TimedLong:1.0 here
  [1]
  $ rtlog -p -f b.rtlog Source0.rtc:number.n
  rtlog: /localhost:$PORT/test.host_cxt/Source0.rtc:number: not a DataInPort (it is a DataOutPort)
  [3]
  $ rtlog -p -f b.rtlog ConsoleOut0.rtc
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no port specified; it has /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in (see --help)
  [2]
  $ rtlog -p -f b.rtlog Gone0.rtc:in
  rtlog: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  [3]
  $ rtlog -p -f b.rtlog Gone0.rtc:in.n ConsoleOut0.rtc:in.n
  rtlog: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  rtlog: End of log reached.
  [5]

Ctrl-C, and other signals (a component that dies meanwhile: tests/sim/stories/rtlog-play.t):

  $ rtlog -q -i -e 3 -f c.rtlog --property dataport.subscription_type=periodic \
  >     --property dataport.publisher.push_rate=2 --property dataport.publisher.push_policy=new \
  >     Source0.rtc:number.n
  $ interrupt 0.7 rtlog -p -f c.rtlog -r 0.05 ConsoleOut0.rtc:in.n
  [130]
  $ ctl @these connectors ConsoleOut0:in
  $ for s in TERM HUP; do rtlog -p -f c.rtlog -r 0.05 ConsoleOut0.rtc:in.n & \
  >     soon '[ -n "$(ctl @these connectors ConsoleOut0:in)" ]'
  > kill -$s $!; wait $!; echo $?; ctl @these connectors ConsoleOut0:in; done
  143
  129
