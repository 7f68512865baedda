rtlog when things go wrong: a file is always left whole, and nothing is left in a component that lives. (Components that hang
or die: tests/sim/stories/rtlog-faults.t.)

world: senders 200 1000
world: these ConsoleOut ConsoleIn
world: sources 2 100 8 --flavour cpp2 --context cpp2.host_cxt/%n.rtc
alone: kills and time

Ended by a signal, in every way but one:

  $ rtlog -q -f t.rtlog Source0.rtc:number & soon 'rtlog --json -f t.rtlog 2>/dev/null | grep -q number'
  $ kill -TERM $!; wait $!
  [143]
  $ rtlog -d --json -f t.rtlog | grep -o 'closed": [a-z]*'
  closed": true
  $ rtlog -q -f h.rtlog Source0.rtc:number & soon 'rtlog --json -f h.rtlog 2>/dev/null | grep -q number'
  $ kill -HUP $!; wait $!
  [129]
  $ rtlog -d --json -f h.rtlog | grep -o 'closed": [a-z]*'
  closed": true
  $ ctl connectors Source0:number

kill -9 costs what was on its way; the file can be read, played, appended to:

  $ rtlog -q -f k.rtlog Source0.rtc:number & soon '[ $(rtlog --json -f k.rtlog 2>/dev/null | wc -l) -gt 20 ]'
  $ kill -KILL $!; wait $! 2>/dev/null
  [137]
  $ [ $(rtlog --json -f k.rtlog | wc -l) -gt 20 ]
  rtlog: k.rtlog: recording has not ended regularly, or goes on
  rtlog: k.rtlog: other readers may refuse it; rtlog mend makes a copy that they open
  $ rtlog -q -i -e 1 --append -f k.rtlog Source0.rtc:number; rtlog -d -f k.rtlog | grep Channel
  Channel 1
  $ rtlog --csv -f k.rtlog | sed 1d | cut -d, -f1 > numbers; seq 0 $(tail -n 1 numbers) | cmp - numbers

The component drops the connection of the killed one when it sends next:

  $ soon '[ -z "$(ctl connectors Source0:number)" ]'

It leaves nothing that can hang a component when it drops these connections. (An observer of its ports would, in C++ 2.1.)

  $ cd() { RTCSH_CWD=/localhost:$PORT/$1; export RTCSH_CWD; }
  $ observed() { ctl @sources observers Source0 | grep -c Observer; }
  $ cd cpp2.host_cxt; rtlog -q -f o.mcap --events . & pid=$!
  $ soon '[ "$(observed)" = 1 ] && rtlog --json -q -f o.mcap | grep -q :number'
  $ kill -KILL $pid; wait $pid 2>/dev/null
  [137]
  $ left() { for n in 0 1; do for p in number block; do ctl @sources connectors Source$n:$p; done; done; }
  $ soon '[ -z "$(left)" ]'
  $ rtls -l
  Active  2/0  0/0  2/0  0/0  Source0.rtc
  Active  2/0  0/0  2/0  0/0  Source1.rtc
  $ cd test.host_cxt

Files that cannot be written:

  $ rtlog -t 1 -f /dev/full Source0.rtc:number
  rtlog: /dev/full: No space left on device
  [1]
  $ rtlog -t 1 -f . Source0.rtc:number
  rtlog: $TMP: Is a directory
  [1]
  $ rtlog -t 1 -f /none/x Source0.rtc:number
  rtlog: /none/x: No such file or directory
  [1]
  $ rtlog -t 99 -l text -f /dev/full Source0.rtc:number
  rtlog: Recording for 99.0s.
  rtlog: /dev/full: No space left on device
  [1]
  $ (ulimit -f 100; rtlog -t 99 -f full.rtlog Source0.rtc:block)
  rtlog: Recording for 99.0s.
  rtlog: full.rtlog: File too large
  [1]
  $ rtlog -d --json -f full.rtlog | grep -o '"closed.*damaged": 0\|"torn.*'
  rtlog: full.rtlog: recording has not ended regularly, or goes on
  rtlog: full.rtlog: other readers may refuse it; rtlog mend makes a copy that they open
  "closed": false, "damaged": 0
  "torn": 0}
  $ (ulimit -f 1; rtlog --mend full.rtlog -f m.rtlog; rtlog -q --csv tables -f full.rtlog) 2>&1 | cat
  rtlog: m.rtlog: File too large
  rtlog: tables/input0.csv: File too large
  $ ls -A tables; ls m.rtlog 2> nul
  [2]
  $ ctl connectors Source0:number

A pipe is no place for a log to be read from, but one to write to:

  $ mkfifo pipe
  > cat pipe > copy & rtlog -q -i -e 3 -f pipe Source0.rtc:number
  > wait
  > rtlog --json -f copy | wc -l
  3
  $ rtlog --json -f pipe
  rtlog: pipe: a pipe; logs are read from files
  [1]
