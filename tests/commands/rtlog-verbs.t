rtlog has verbs: each has a help of its own, and only its options. Without a verb, flags say which is meant (the other
transcripts, and tests/unit/test_verbs.py).

world: senders 100 100
world: these ConsoleOut
server: other
orb: builtin

  $ rtlog --help
  usage: rtlog VERB ...

  Record what out ports send; play, show and export logs.

  verbs:
    record  Record what out ports send, or a whole robot
    ring    Record into a ring of files; a trigger keeps a part of it
    play    Play a log into in ports, or to the terminal
    serve   Play a log as components, which others list, ask and connect with
    show    Show what is in a log
    export  Print the entries of a log, as JSON, as a table, or as text
    mend    Complete a copy of a log that was cut off

  `rtlog VERB --help` says more. A PATH called play is written ./play. Without a
  verb, flags choose it, as those of rtshell: -p play, -p --as-components serve,
  -d show, --json, --csv and --attachment export, --mend mend, --ring,
  --ring-size and --trigger-now ring; without any of them: record.

  examples:
    rtlog record -f run.mcap -t 60 Arm0.rtc:joints
    rtlog play run.mcap -r 0.5 Viewer0.rtc:in
    rtlog show run.mcap

  $ for verb in record ring play serve show export mend; do
  >     rtlog $verb --help | grep '^[A-Z].*[.]$' | head -n 1
  > done
  Record what out ports send, or a whole robot.
  Record into a ring of files; a trigger keeps a part of it.
  Play a log into in ports, or to the terminal.
  Play a log as components, which others list, ask and connect with.
  Show what is in a log.
  Print the entries of a log, as JSON, as a table, or as text.
  Complete a copy of a log that was cut off.
  $ rtlog show --help -v | grep -o -e ' --[a-z]*' | sort -u
   --filename
   --help
   --idl
   --include
   --json
   --mod
   --path
   --quiet
   --timeout
   --verbose
   --version
  $ for option in --ring --csv --every --map --trigger --in-place; do for verb in record ring play serve \
  >     show export mend; do
  > rtlog $verb --help -v | grep -q -e " $option " && echo $option $verb; done; done
  --ring ring
  --csv play
  --csv export
  --every record
  --every ring
  --map play
  --trigger ring
  --in-place mend

record, and what is a verb: a PATH or a file called as one is written with its directory.

  $ rtlog record -i -e 10 -f a.mcap Source0.rtc:number.numbers
  rtlog: Recording 10 entries.
  $ rtlog -q record -i -e 3 --append -f a.mcap Source0.rtc:number.numbers
  $ rtlog record -q -i -e 1 -f play Source0.rtc:number
  $ rtlog show play | head -n 1
  Name: play
  $ rtlog show -f play | head -n 1
  Name: play
  $ rtlog play ./play | wc -l
  1
  $ rtlog ./play
  rtlog: ./play: a log; show, play and export read it, -f names what is recorded to (see --help)
  [2]
  $ rtlog -f x ./play
  rtlog: /localhost:$PORT/test.host_cxt/play: no such path
  [3]
  $ rtlog play
  rtlog: no log file specified (see --help)
  [2]

show, export, mend:

  $ rtlog show a.mcap | grep entries:; rtlog show --json a.mcap | grep -o '"closed": [a-z]*'
  Number of entries: 13
    Number of entries: 13
  "closed": true
  $ rtlog export a.mcap --json -i -s 2 -e 2 | cut -c1-30
  {"number": 2, "port": "numbers
  $ rtlog export a.mcap --csv | wc -l
  14
  $ rtlog export a.mcap tables --csv
  $ ls tables
  numbers.csv
  $ rtlog export a.mcap -i -e 1 | sed 's/[0-9]\{1,\}/N/g'
  [N.N] N
  $ head -c 700 a.mcap > cut.mcap
  $ rtlog mend cut.mcap
  rtlog: cut.mcap: the last 110 octets are not a whole record and are left out
  rtlog: the copy is cut-mended.mcap
  $ rtlog mend cut.mcap -f out.mcap
  rtlog: cut.mcap: the last 110 octets are not a whole record and are left out
  $ rtlog mend cut.mcap --in-place
  rtlog: cut.mcap: the last 110 octets are not a whole record and are left out
  $ cmp out.mcap cut.mcap && cmp out.mcap cut-mended.mcap
  $ rtlog show -q cut.mcap | grep State
  [1]

play, serve:

  $ rtact ConsoleOut0.rtc
  $ rtlog play a.mcap -r 10 ConsoleOut0.rtc:in
  rtlog: End of log reached.
  $ ctl @these received ConsoleOut0:in 13 | cut -d' ' -f1
  13
  $ rtlog play -q -f a.mcap -i -e 2 ConsoleOut0.rtc:in.numbers
  $ ctl @these received ConsoleOut0:in 15 | cut -d' ' -f1
  15
  $ rtlog play -q -r 100 a.mcap --csv | cut -d, -f3 | uniq
  port
  numbers
  $ rtlog serve a.mcap copy.host_cxt --nameserver localhost:$PORT2 --loop 2> told & pid=$!
  > soon 'grep bound told'
  > rtls -R /localhost:$PORT2 | grep rtc
  > kill $pid; wait $pid
  Source0.rtc
  [143]

ring:

  $ rtlog ring -q --last 5 --after 0.1 -f r.mcap Source0.rtc & pid=$!
  > until rtlog ring --trigger-now r.mcap 2> nul; do :; done
  > soon 'ls r-2*'
  > kill $pid; wait $pid
  [143]
  $ rtlog ring -q --size 1M -t 0.5 -f s.mcap Source0.rtc; rtlog show s-000001.mcap | grep -c Channel
  3

What cannot be; both spellings have the same messages:

  $ for line in 'show a.mcap --map a=b' '-d -f a.mcap --map a=b' 'record -s 5 Source0.rtc:number' \
  >     '-s 5 Source0.rtc:number' 'play a.mcap --trigger error' '-p -f a.mcap --trigger error';
  >     do
  >     rtlog $line
  > done
  rtlog: --map is for rtlog play, not for rtlog show (see --help)
  rtlog: --map is for rtlog play, not for rtlog show (see --help)
  rtlog: -s is for rtlog play, serve and export, not for rtlog record (see --help)
  rtlog: -s is for rtlog play, serve and export, not for rtlog record (see --help)
  rtlog: --trigger is for rtlog ring, not for rtlog play (see --help)
  rtlog: --trigger is for rtlog ring, not for rtlog play (see --help)
  [2]
  $ rtlog show
  rtlog: no log file specified (see --help)
  [2]
  $ rtlog show a.mcap b.mcap
  rtlog: unrecognized arguments: b.mcap (see --help)
  [2]
  $ rtlog show -f a.mcap b.mcap
  rtlog: one log at a time: b.mcap (see --help)
  [2]
  $ rtlog show none.mcap
  rtlog: none.mcap: No such file or directory
  [1]
  $ rtlog play Source0.rtc:number
  rtlog: no log file specified (see --help)
  [2]
  $ rtlog play a.mcap --json ConsoleOut0.rtc:in
  rtlog: --json and --csv exclude each other, and ports (see --help)
  [2]
  $ rtlog play a.mcap --only x
  rtlog: --only, --not and --map need a PATH without a port (see --help)
  [2]
  $ rtlog play a.mcap --linger 1
  rtlog: --linger and --anyway are for playing to ports (see --help)
  [2]
  $ rtlog play a.mcap --loop -n
  rtlog: --loop does not go with -n or --csv (see --help)
  [2]
  $ rtlog serve a.mcap one two
  rtlog: unrecognized arguments: two (see --help)
  [2]
  $ rtlog serve -f a.mcap one two
  rtlog: one PREFIX at a time: two (see --help)
  [2]
  $ rtlog serve a.mcap --json
  rtlog: --json is for rtlog play, show and export, not for rtlog serve (see --help)
  [2]
  $ rtlog export a.mcap tables
  rtlog: not a DIRECTORY for --csv, which writes a table for each channel: tables (see --help)
  [2]
  $ rtlog export a.mcap tables --json
  rtlog: not a DIRECTORY for --csv, which writes a table for each channel: tables (see --help)
  [2]
  $ rtlog export --csv tables a.mcap
  rtlog: the log comes first: rtlog export --csv a.mcap tables (see --help)
  [2]
  $ rtlog export a.mcap Source0.rtc:number
  rtlog: not a DIRECTORY for --csv, which writes a table for each channel: Source0.rtc:number; of one channel: rtlog export --json LOG | grep Source0.rtc:number (see --help)
  [2]
  $ rtlog record -f -t 5 Source0.rtc:number
  rtlog: argument -f: a file is expected before -t (./-t is one) (see --help)
  [2]
  $ rtlog mend a.mcap -f -
  rtlog: -f -: the copy is a file, which is not written to stdout (./- is a file) (see --help)
  [2]
  $ rtlog export a.mcap --csv --attachment x
  rtlog: --attachment takes only the log (see --help)
  [2]
  $ rtlog export -f a.mcap --csv one two
  rtlog: one DIRECTORY at a time: two (see --help)
  [2]
  $ rtlog mend
  rtlog: no log file specified (see --help)
  [2]
  $ rtlog mend a.mcap -f b.mcap --in-place
  rtlog: --in-place and -f OUT exclude each other (see --help)
  [2]
  $ rtlog ring -f x .
  rtlog: how long is the ring? --last SECONDS or --size SIZE says so (see --help)
  [2]
  $ rtlog ring --last 5
  rtlog: nothing to record: no port specified; rtlog show prints what is in a log (see --help)
  [2]
  $ rtlog ring --size 1M --in-memory .
  rtlog: --in-memory needs --last SECONDS (see --help)
  [2]
  $ rtlog ring --last 5 --after 1e9 .
  rtlog: --after out of bounds (see --help)
  [2]
  $ rtlog ring --trigger-now a.mcap .
  rtlog: --trigger-now takes only its FILE (see --help)
  [2]
  $ rtlog ring --last 5 --rotate 5 .
  rtlog: --rotate is for rtlog record, not for rtlog ring (see --help)
  [2]
  $ rtlog ring --last 5 -l text .
  rtlog: argument -l/--logger: not one of mcap, simpkl: text (see --help)
  [2]
  $ rtlog record
  rtlog: nothing to record: no port specified; rtlog show prints what is in a log (see --help)
  [2]
  $ rtlog record -f - Source0.rtc:number
  rtlog: -f -: a log is a file, which is not written to stdout; rtprint prints values (./- is a file) (see --help)
  [2]
  $ rtlog record a.mcap
  rtlog: a.mcap: a log; show, play and export read it, -f names what is recorded to (see --help)
  [2]
  $ rtlog merge a.mcap a.mcap
  rtlog: no such verb: merge (there are: record, ring, play, serve, show, export, mend); a.mcap is a log (see --help)
  [2]
  $ rtlog record Source0.rtc a.mcap
  rtlog: a.mcap: a log; show, play and export read it, -f names what is recorded to (see --help)
  [2]
  $ rtlog record --keep 3 -f x Source0.rtc:number
  rtlog: --keep needs --rotate, and a number above 0 (see --help)
  [2]
  $ rtlog record -l text --leave 1M -f x Source0.rtc:number
  rtlog: -l text takes no --rotate or --leave (see --help)
  [2]
  $ rtlog play --nonsense a.mcap
  rtlog: unrecognized arguments: --nonsense (see --help)
  [2]
  $ ls x 2> nul
  [2]
