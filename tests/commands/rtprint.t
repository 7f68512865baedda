rtprint prints what out ports send. Nothing of it is bound anywhere, and its connections go with it.

world: two
world: senders 100 12

A mock sends a value made of a number on command; its time is 0 then:

  $ printing() { "$@" & pid=$!; soon 'ctl connectors ConsoleIn0:out | grep -q . || ! kill -0 $pid 2>&-'; }
  $ printing rtprint -n 2 ConsoleIn0.rtc:out
  > ctl write ConsoleIn0:out 42
  > ctl write ConsoleIn0:out -1
  > wait $pid
  [0.000000000] 42
  [0.000000000] -1
  $ ctl connectors ConsoleIn0:out
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Source0.rtc

Others stamp their values. They are printed as they come, all of them:

  $ rtprint -n 3 Source0.rtc:number
  \[[0-9]{10}\.[0-9]{9}\] [0-9]+ (re)
  \[[0-9]{10}\.[0-9]{9}\] [0-9]+ (re)
  \[[0-9]{10}\.[0-9]{9}\] [0-9]+ (re)
  $ rtprint -n 40 Source0.rtc:number >lines; awk '{ print $2 - last; last = $2 }' lines | sed 1d | sort -u
  1

-r looks at times and prints the newest; -n counts looks then (tests/sim/stories/rtprint-rate.t):

  $ within 0.7-20 rtprint -r 4 -n 3 Source0.rtc:number >lines
  $ awk '{ print ($2 > last); last = $2 }' lines | sed 1d
  1
  1

Several ports; NAME is another name for the port before it:

  $ rtprint -q -n 2 ConsoleIn0.rtc:out.console /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out >lines &
  >     pid=$!
  $ soon '[ $(ctl connectors ConsoleIn0:out | wc -l) = 2 ]'
  $ ctl write ConsoleIn0:out 5; wait $pid
  $ sort lines
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: [0.000000000] 5
  console: [0.000000000] 5
  $ rtprint -n 99 Source0.rtc:number.n Source0.rtc:block | cut -d: -f1 | sort | uniq -c |
  > awk '$1 > 10 { print $2 }'
  Source0.rtc
  n

One member, Python's spelling, a function of one's own:

  $ echo 'def half(value): return value.data / 2
  > def wrong(value): return value.nothing
  > number = 3' >spell.py
  $ printing rtprint --field data -n 1 ConsoleIn0.rtc:out
  > ctl write ConsoleIn0:out 7
  > wait $pid
  7
  $ printing rtprint -n 1 ConsoleIn0.rtc:out#rtshell.rawpy
  > ctl write ConsoleIn0:out 7
  > wait $pid
  RTC.TimedLong(tm=RTC.Time(sec=0, nsec=0), data=7)
  $ printing rtprint -p . -n 1 ConsoleIn0.rtc:out#spell.half
  > ctl write ConsoleIn0:out 7
  > wait $pid
  3.5
  $ printing rtprint -p . -n 1 ConsoleIn0.rtc:out#spell.wrong
  > ctl write ConsoleIn0:out 7
  > wait $pid
  rtprint: ConsoleIn0.rtc:out: the formatter fails (AttributeError: 'TimedLong' object has no attribute 'nothing')
  [1]
  $ rtprint -p . ConsoleIn0.rtc:out#spell.missing
  rtprint: #spell.missing: no such formatter: module.function is wanted, with one argument
  [3]
  $ rtprint -p . ConsoleIn0.rtc:out#spell.number
  rtprint: #spell.number: no such formatter: module.function is wanted, with one argument
  [3]
  $ rtprint ConsoleIn0.rtc:out#nomodule.f
  rtprint: #nomodule.f: cannot import nomodule (No module named 'nomodule')
  [1]
  $ printing rtprint --field tm.year -n 1 ConsoleIn0.rtc:out
  > ctl write ConsoleIn0:out 7
  > wait $pid
  rtprint: tm.year: no such field: year (there are sec, nsec)
  [3]

Bytes:

  $ printing rtprint -n 1 --raw ConsoleIn0.rtc:out
  > ctl write ConsoleIn0:out 258
  > wait $pid
  12 bytes
  00000000  00 00 00 00 00 00 00 00 02 01 00 00              ............
  maybe: time 0.000000000
  maybe: long 258
  $ printing rtprint -n 1 --raw --json ConsoleIn0.rtc:out
  > ctl write ConsoleIn0:out 258
  > wait $pid
  {"hex": "000000000000000002010000", "little_endian": true, "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out", "received": *, "size": 12, "type": "IDL:RTC/TimedLong:1.0"} (glob)

For programs:

  $ printing rtprint -n 1 --json ConsoleIn0.rtc:out
  > ctl write ConsoleIn0:out 258
  > wait $pid
  {"path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out", "received": *, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 258, "tm": {"nsec": 0, "sec": 0}}} (glob)
  $ rtprint -n 1 --json --field data Source0.rtc:block
  {"path": "/localhost:$PORT/test.host_cxt/Source0.rtc:block", "received": *, "type": "IDL:RTC/TimedOctetSeq:1.0", "value": "*AAAAAA"} (glob)

-t ends it; with -n, too few values are a no:

  $ within 0.2-5 rtprint -t 0.2 ConsoleIn0.rtc:out
  $ rtprint -n 2 -t 0.2 ConsoleIn0.rtc:out
  rtprint: ConsoleIn0.rtc:out: 0 of 2 values came within 0.2s
  [1]
  $ rtprint -n 0 ConsoleIn0.rtc:out
  rtprint: -n 0: no values are printed; without -n there is no end
  $ within 0.2-5 rtprint -n -1 -t 0.2 ConsoleIn0.rtc:out

Figures, each second and at the end. The sender is a Python process beside others, so its gaps vary:

  $ rtprint -n 300 --stats Source0.rtc:number > out || echo $?
  $ grep -m 1 '^[0-9].*gap' out; tail -n 1 out
  [0-9]+ values, [0-9]+\.[0-9] Hz, gap [0-9.e+]+/[0-9.e+]+/[0-9.e+]+ ms, jitter [0-9.e+]+ ms, [0-9.]+ k?B/s, age [0-9.e+]+ ms.* (re)
  all in all: [0-9]+ values, [0-9]+\.[0-9] Hz, gap [0-9.e+]+/[0-9.e+]+/[0-9.e+]+ ms, jitter [0-9.e+]+ ms, [0-9.]+ k?B/s, age [0-9.e+]+ ms.* (re)
  $ rtprint -n 50 --stats Source0.rtc:number.n ConsoleIn0.rtc:out.silent > out || echo $?; tail -n 2 out
  all in all: n: 50 values, [0-9]+\.[0-9] Hz, gap [0-9.e+]+/[0-9.e+]+/[0-9.e+]+ ms, jitter [0-9.e+]+ ms, [0-9.]+ k?B/s, age [0-9.e+]+ ms.* (re)
  all in all: silent: no values
  $ rtprint -n 30 --stats --json Source0.rtc:number | tail -n 1 | python3 -c 'import json, sys
  > for line in sys.stdin: found = json.loads(line); print(sorted(found), found["total"], found["values"], found["bytes"])'
  ['absent', 'age_max', 'age_mean', 'bytes', 'bytes_per_second', 'disordered', 'dropped', 'gap_max', 'gap_mean', 'gap_min', 'jitter', 'missing', 'path', 'rate', 'repeated', 'seconds', 'total', 'values'] True 30 360
  $ MOCK_CLOCK=300 mock senders 100 12 --context ahead.host_cxt/%n.rtc
  $ rtprint -n 5 --stats ../ahead.host_cxt/Source0.rtc:number > out
  rtprint: /localhost:$PORT/ahead.host_cxt/Source0.rtc:number: the times in its values are 5 minutes ahead of this host's clock
  $ rtprint -q -n 5 --stats ../ahead.host_cxt/Source0.rtc:number > out
  $ rtprint -n 5 ../ahead.host_cxt/Source0.rtc:number > out
  $ terminal 30 rtprint -n 300 --stats Source0.rtc:number | sed 's/\(no\|[0-9.]*\) [vHg].*/…/' |
  > sed -n '1p; $p'
  \x1b[2K… (esc)
  \x1b[1A\x1b[2Kall in all: … (esc)
  $ rtprint --raw -n 30 --stats Source0.rtc:number | tail -n 1 | sed 's/.*values/values/'
  values, [0-9]+\.[0-9] Hz, gap [0-9.e+]+/[0-9.e+]+/[0-9.e+]+ ms, jitter [0-9.e+]+ ms, [0-9.]+ k?B/s (re)

A connection's properties can be set, and data can be fetched instead:

  $ printing rtprint -n 1 --property dataport.subscription_type=flush ConsoleIn0.rtc:out
  $ rtcat -ll ConsoleIn0.rtc:out | grep '  *dataport.subscription_type'
    dataport.subscription_type               block,flush,new,nonblock,periodic
  $ ctl write ConsoleIn0:out 1; wait $pid
  [0.000000000] 1
  $ rtprint -v --pull -n 2 Source0.rtc:number
  rtprint: /localhost:$PORT/test.host_cxt/Source0.rtc:number: connected (pull), id $UUID
  \[[0-9]{10}\.[0-9]{9}\] [0-9]+ (re)
  \[[0-9]{10}\.[0-9]{9}\] [0-9]+ (re)

Wrong usage:

  $ rtprint
  rtprint: the following arguments are required: PATH:PORT[.NAME][#FORMATTER] (see --help)
  [2]
  $ rtprint ConsoleIn0.rtc
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no port specified; it has /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out (see --help)
  [2]
  $ rtprint -r 0 ConsoleIn0.rtc:out
  rtprint: argument -r/--rate: not a number of Hz above 0: 0 (see --help)
  [2]
  $ rtprint -t soon ConsoleIn0.rtc:out
  rtprint: argument -t/--timeout: not a number of seconds above 0: soon (see --help)
  [2]
  $ rtprint -n all ConsoleIn0.rtc:out
  rtprint: argument -n/--number: not a whole number: 'all' (see --help)
  [2]
  $ rtprint --raw --field data ConsoleIn0.rtc:out
  rtprint: --raw and --field exclude each other (see --help)
  [2]
  $ rtprint --field tm --field data ConsoleIn0.rtc:out
  rtprint: --field: only one (see --help)
  [2]
  $ rtprint --property push ConsoleIn0.rtc:out
  rtprint: not KEY=VALUE: push (see --help)
  [2]

What is no out port:

  $ rtprint ConsoleOut0.rtc:in
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: not a DataOutPort (it is a DataInPort)
  [3]
  $ rtprint ConsoleIn0.rtc:nothing
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such port: nothing (its ports: out)
  [3]
  $ rtprint ConsoleIn0.rtc:nothing.name
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such port: nothing.name (its ports: out)
  [3]
  $ rtprint nobody.rtc:out ..:out
  rtprint: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  rtprint: /localhost:$PORT/test.host_cxt/\.: no such path
  [3]
  $ rtprint -n 1 nobody.rtc:out Source0.rtc:number | cut -d: -f1
  rtprint: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  \[[0-9]{10}\.[0-9]{9}\] [0-9]+ (re)
  $ rtprint -p . -m nomodule ConsoleIn0.rtc:out
  rtprint: nomodule: no such module in .: No module named 'nomodule'
  [3]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -t 0.5 A:out
invocation: -n 1 -t 0.5 --raw A:out B:out
invocation: --pull -t 0.5 A:out
invocation: --stats -t 0.5 A:out
lasting: A:out
broken component: 5
examples: endless
examples: asking
example: rtprint --idl arm.idl Arm0.rtc:status <- echo 'module Arm { struct Status { long error; }; };' >arm.idl
