rtlog plays a recording of a whole robot into in ports, as they were connected when it was recorded.

world: these ConsoleIn:Left ConsoleIn:Right ConsoleOut:One ConsoleOut:Two ConsoleOut:Three Motor
server: other
world: these ConsoleOut:Uno --nameserver localhost:$PORT2 --context new.host_cxt/%n.rtc

  $ got() { for one in "$@"; do echo $one $(ctl @these received $one:in | cut -d' ' -f1); done; }
  $ rtcon -q Left.rtc:out One.rtc:in; rtcon -q Left.rtc:out Two.rtc:in
  $ rtcon -q Right.rtc:out Two.rtc:in; rtact One.rtc Two.rtc Three.rtc
  $ rtlog --events -f a.mcap . 2> nul & pid=$!; soon 'rtlog -d -f a.mcap | grep system-1.rtsys'
  $ soon '[ $(ctl @these connectors Left:out | wc -l) = 3 ]'
  $ soon '[ $(ctl @these connectors Right:out | wc -l) = 2 ]'
  $ for i in 1 2 3 4; do ctl write Left:out $i; done
  $ ctl write Right:out 5
  $ soon 'rtlog --json -f a.mcap | grep "data.: 4"'
  $ soon 'rtlog --json -f a.mcap | grep "data.: 5"'
  $ kill $pid; wait $pid
  [143]
  $ rtdis -q Left.rtc; rtdis -q Right.rtc
  $ got One Two Three
  One 4
  Two 5
  Three 0

A directory, several components, a pattern, beside a port; nothing is left:

  $ rtlog -q -p -f a.mcap .; got One Two Three
  One 8
  Two 10
  Three 0
  $ rtlog -q -p -f a.mcap 'Tw*' /localhost:$PORT/test.host_cxt/One.rtc; got One Two Three
  One 12
  Two 15
  Three 0
  $ rtlog -q -p -f a.mcap Three.rtc:in One.rtc; got One Two Three
  One 16
  Two 15
  Three 4
  $ ctl @these connectors One:in; ctl @these connectors Two:in

Some of them, by either port or by type:

  $ rtlog -q -p --only 'Right.rtc:*' -f a.mcap .; got One Two Three
  One 16
  Two 16
  Three 4
  $ rtlog -q -p --only TimedLong --not '*Two.rtc:in' -f a.mcap .; got One Two Three
  One 20
  Two 16
  Three 4
  $ rtlog -q -p --only '*Image*' -f a.mcap .
  rtlog: a.mcap: --only and --not leave none of 3 connections
  [1]

They are elsewhere, or have other names; what is not there is reported, and the rest is played:

  $ N=/localhost:$PORT2/new.host_cxt
  $ M="--map localhost:$PORT=localhost:$PORT2 --map test.host_cxt=new.host_cxt"
  $ rtact $N/Uno.rtc
  $ rtlog -q -p $M --map One.rtc=Uno.rtc -f a.mcap $N
  rtlog: /localhost:$PORT2/new.host_cxt/Two.rtc: no such path
  [5]
  $ rtlog -q -p $M --map One.rtc=Uno.rtc -f a.mcap $N/Uno.rtc; ctl @these2 received Uno:in | cut -d' ' -f1
  8
  $ rtlog -q -p $M -f a.mcap $N
  rtlog: /localhost:$PORT2/new.host_cxt/One.rtc: no such path
  rtlog: /localhost:$PORT2/new.host_cxt/Two.rtc: no such path
  [3]
  $ rtlog -q -p --map One.rtc=Motor0.rtc -f a.mcap .
  rtlog: /localhost:$PORT/test.host_cxt/Motor0.rtc: the file has two components here
  [1]
  $ rtlog -q -p --map One.rtc=Motor0.rtc --map Motor0.rtc=Gone.rtc -f a.mcap .
  rtlog: /localhost:$PORT/test.host_cxt/Motor0.rtc:in: data types differ: IDL:RTC/TimedLong:1.0 in the log, IDL:RTC/TimedFloat:1.0 here
  [5]
  $ rtlog -q -p -f a.mcap Three.rtc One.rtc
  rtlog: /localhost:$PORT/test.host_cxt/Three.rtc: no connection in a.mcap leads from a recorded port to a port here
  [5]
  $ got One Two Three
  One 24
  Two 21
  Three 4

As components, too, some ports may be left out:

  $ R=/localhost:$PORT2/test.host_cxt/Right.rtc
  $ RTSHELL_ORB=builtin rtlog -q -p --as-components --not '*Left*' --not 'Motor0.rtc:*' \
  >     --when-connected --nameserver localhost:$PORT2 -f a.mcap &
  >     pid=$!
  $ soon "rtls $R"
  $ rtprint -q $R:out 2> nul
  [0.000000000] 5
  [4]
  $ wait $pid

What cannot be:

  $ rtlog -q -p -f a.mcap Three.rtc
  rtlog: /localhost:$PORT/test.host_cxt/Three.rtc: no connection in a.mcap leads from a recorded port to a port here
  [1]
  $ rtlog -q -p --map Gone=There -f a.mcap .
  rtlog: --map Gone=There: nothing in the file is there (see --help)
  [2]
  $ rtlog -q -f b.mcap -t 1 Left.rtc; rtlog -p -f b.mcap .
  rtlog: b.mcap: its connections are not in it: name ports, or record it with rtlog record --events PATH
  [1]
  $ rtlog -p -f b.mcap One.rtc
  rtlog: /localhost:$PORT/test.host_cxt/One.rtc: no port specified; it has /localhost:$PORT/test.host_cxt/One.rtc:in (see --help)
  [2]
  $ rtlog -p --only x -f a.mcap One.rtc:in
  rtlog: --only, --not and --map need a PATH without a port (see --help)
  [2]
  $ rtlog -p --map One.rtc=Two.rtc -f a.mcap One.rtc:in
  rtlog: --only, --not and --map need a PATH without a port (see --help)
  [2]
  $ rtlog --json --only x -f a.mcap
  rtlog: --only is for rtlog record, ring, play and serve, not for rtlog export (see --help)
  [2]
  $ rtlog -p --not x -f a.mcap
  rtlog: --only, --not and --map need a PATH without a port (see --help)
  [2]
  $ rtlog -d --every 2 -f a.mcap
  rtlog: --every is for rtlog record and ring, not for rtlog show (see --help)
  [2]
  $ rtlog --map a=b -f c.mcap .
  rtlog: --map is for rtlog play, not for rtlog record (see --help)
  [2]
  $ rtlog -p --as-components --map a=b -f a.mcap
  rtlog: --map is for rtlog play, not for rtlog serve (see --help)
  [2]
