rtlog records into a ring: what is run when a trigger's file is complete, what signals and kill -9 do, how a disk is left free.
(What is in the files, and when: tests/sim/stories/rtlog-ring.t.)

world: observed
world: senders 100 100
alone: time

  $ rtlog --ring 4 --after 0.5 --trigger error --then 'echo complete:' -f a.mcap . > said 2> told & pid=$!
  $ soon 'ctl observers ConsoleIn0 | grep Observer'
  $ rtact ConsoleIn0.rtc
  $ ctl error ConsoleIn0
  $ soon 'grep complete said'
  $ sed 's/20[0-9]*-[0-9]*/DATE/' said
  complete: a-DATE-error-ConsoleIn0.rtc.mcap
  $ rtlog -d --json -f a-2*error* | grep -o 'attachments": ."system-'
  attachments": ["system-
  $ kill -USR1 $pid; soon '[ $(grep -c complete said) = 2 ]'
  $ kill $pid; wait $pid
  [143]
  $ grep -o 'trigger: .*' told
  trigger: error ConsoleIn0.rtc
  trigger: SIGUSR1

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

A disk that is nearly full:

  $ rtlog -t 99 --leave 900000G -f l.mcap Source0.rtc:number
  rtlog: Recording for 99.0s.
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
  rtlog: --trigger is for rtlog ring, not for rtlog record (see --help)
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
  rtlog: --rotate is for rtlog record, not for rtlog ring (see --help)
  [2]
  $ rtlog --ring x -f x .
  rtlog: argument --last/--ring: not a number of seconds above 0: x (see --help)
  [2]
  $ rtlog --ring-size x -f x .
  rtlog: argument --size/--ring-size: not a size such as 500M: x (see --help)
  [2]
  $ rtlog --ring 5 -p -f x
  rtlog: --ring is for rtlog ring, not for rtlog play (see --help)
  [2]
