rtlog records into a ring; a trigger makes a file of the past and the future. It rotates files, and leaves some of the disk free.

world: observed
world: senders 100 100
alone: time

  $ span() { rtlog -d --json -f "$1" |
  > python3 -c 'import json, sys; log = json.load(sys.stdin); print(round(log["last"] - log["first"]))'; }

An error, with what came before it and after it; the ring is bounded, and goes on. (With `new` no port is let go where the
machine is busy.)

  $ rtlog --ring 4 --after 2 --trigger error --then 'echo complete:' \
  >     --property dataport.subscription_type=new -f a.mcap . > said 2> told &
  >     pid=$!
  $ soon 'ctl observers ConsoleIn0 | grep Observer'; sleep 6
  $ rtact ConsoleIn0.rtc; ctl error ConsoleIn0
  $ soon 'grep complete said'
  $ sed 's/20[0-9]*-[0-9]*/DATE/' said
  complete: a-DATE-error-ConsoleIn0.rtc.mcap
  $ [ $(span a-2*) -ge 5 ] && [ $(span a-2*) -le 7 ]
  $ rtlog --json -f a-2*error* | grep -c 'ERROR.*RTC_STATUS\|"mark": "trigger: error ConsoleIn0.rtc'
  2
  $ rtlog --csv -f a-2*error* | grep :number | cut -d, -f5 | grep . > numbers
  $ [ $(wc -l < numbers) -gt 400 ]
  $ seq $(head -n 1 numbers) $(tail -n 1 numbers) | cmp - numbers
  $ rtlog -d --json -f a-2*error* | grep -o 'attachments": ."system-'
  attachments": ["system-
  $ rm a-2*; for i in 1 2; do rtlog --trigger-now a.mcap; done
  $ soon 'grep trigger:.now told'; kill -USR1 $pid
  $ soon '[ $(ls a-2* | wc -l) = 1 ]'; soon '[ $(grep -c complete said) = 2 ]'
  $ [ $(ls a-0* | wc -l) -le 7 ]
  $ kill $pid; wait $pid
  [143]
  $ sed 's/20[0-9]*-[0-9]*/DATE/' told | LC_ALL=C sort -u
  rtlog: Recording * ports. (glob)
  rtlog: kept a-DATE-error-ConsoleIn0.rtc.mcap
  rtlog: kept a-DATE-now.mcap
  rtlog: trigger: SIGUSR1
  rtlog: trigger: error ConsoleIn0.rtc
  rtlog: trigger: now
  $ for part in a-0*; do rtlog -d --json -f $part; done | grep -vc '"closed": true'
  0
  [1]
  $ rtlog --trigger-now a.mcap
  rtlog: a.mcap: no rtlog records a ring of that name
  [1]
  $ ls a.mcap* 2>/dev/null
  [2]

A file of the user's that has the name of ours is left alone; what a killed rtlog has left is not:

  $ for words in mine ''; do
  >     printf "$words" > q.mcap.trigger
  >     rtlog --ring 4 --trigger error -f q.mcap .
  >     rtlog --trigger-now q.mcap
  >     cat q.mcap.trigger
  >     ls q*
  > done
  rtlog: q.mcap.trigger: exists, and is not rtlog's, which needs this name for triggers
  rtlog: q.mcap: no rtlog records a ring of that name
  mineq.mcap.trigger
  rtlog: q.mcap.trigger: exists, and is not rtlog's, which needs this name for triggers
  rtlog: q.mcap: no rtlog records a ring of that name
  q.mcap.trigger
  $ rm q*; rtlog -q --ring 4 --trigger error -f q.mcap . & pid=$!
  > soon 'grep -- --trigger q.mcap.trigger'
  > rtlog --trigger-now q.mcap
  > kill -KILL $pid; wait $pid 2>/dev/null
  [137]
  $ rtlog -q -t 0.5 --ring 4 --trigger error -f q.mcap .; ls q* | grep trigger
  [1]
  $ rm -f q*

A value, in memory; only the file of the trigger is written:

  $ rtlog -q -t 6 --ring 2 --in-memory --after 0.5 --trigger 'Source0.rtc:number.data > 0' \
  >     -f m.mcap Source0.rtc:number
  $ ls m* | sed 's/20[0-9]*-[0-9]*/DATE/'
  m-DATE-Source0.rtc-number.data-0.mcap
  $ rtlog -d --json -f m-2* | grep -o '"closed": true'
  "closed": true

Silence, after which what is left at the end is kept, too:

  $ rtlog -q -t 4 --ring 9 --after 60 --trigger 'silent Source0.rtc:number 0.4' -f s.mcap Source0.rtc:number &
  >     sleep 1.5
  $ rtdeact Source0.rtc
  $ wait $!
  $ rtact Source0.rtc
  $ ls s-2* | sed 's/20[0-9]*-[0-9]*/DATE/'; rtlog --json -q -f s-2* | grep -c TRIGGER
  s-DATE-silent-Source0.rtc-number-0.4.mcap
  1

Other files after some time; the last are kept:

  $ rtlog -q -t 4 --rotate 0.5 --keep 2 -f r.mcap Source0.rtc:number; ls r-0* | wc -l
  2
  $ rtlog -q -t 1 --rotate 2K -f q.mcap Source0.rtc:number; [ $(ls q-0* | wc -l) -gt 1 ]

A disk that is nearly full:

  $ rtlog -t 5 --leave 900000G -f l.mcap Source0.rtc:number
  rtlog: Recording for 5.0s.
  rtlog: l.mcap: stopped, as the disk is nearly full (--leave)
  [1]
  $ rtlog -d --json -f l.mcap | grep -o '"closed": true'
  "closed": true

kill -9 leaves what can be read:

  $ rtlog -q --ring 5 -f k.mcap Source0.rtc:number & soon 'rtlog --json -f k-000001.mcap | grep number'
  > kill -KILL $!; wait $! 2>/dev/null
  [137]
  $ rtlog -q --json -f k-000001.mcap | head -n 1 | cut -c1-13
  {"number": 0,

Wrong usage:

  $ rtlog --trigger error -f x Source0.rtc:number
  rtlog: --trigger, --then and --in-memory need --ring (see --help)
  [2]
  $ rtlog --ring 5 --trigger error -f x Source0.rtc:number
  rtlog: --events and such triggers need a PATH without a port (see --help)
  [2]
  $ ls x* 2>/dev/null
  [2]
  $ rtlog --ring 5 --trigger something -f x .
  rtlog: --trigger something: not error, death, disconnect, silent PATH:PORT SECONDS, or PATH:PORT.FIELD OP VALUE (see --help)
  [2]
  $ rtlog --ring 5 --rotate 5 -f x .
  rtlog: --ring takes neither --rotate nor --append; --keep needs --rotate (see --help)
  [2]
  $ rtlog --ring x -f x .
  rtlog: argument --ring: not a number of seconds above 0: x (see --help)
  [2]
  $ rtlog --ring-size x -f x .
  rtlog: argument --ring-size: not a size such as 500M: x (see --help)
  [2]
  $ rtlog --ring 5 -p -f x
  rtlog: --ring, --rotate and what belongs to them are for recording (see --help)
  [2]
