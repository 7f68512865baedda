rtdoctor looks at each connection from all its ends: what it says can be pasted, and it sees for whom a process waits, where the
kernel of its host says that. (The rest: tests/sim/stories/rtdoctor-connections.t.)

world: crossed
world: fragile --context fragile.host_cxt/%n.rtc
world: these ConsoleIn:Near0 --context near.host_cxt/%n.rtc
world: these ConsoleOut:Far0 --context far.host_cxt/%n.rtc
both: each ORB tells what is dead in its own way

  $ rtdoctor -q . | sed -n 's/.*one-sided.*; try: //p' > mend; sh ./mend
  $ rtdoctor -q . | grep In0.rtc
  [1]

The kind of finding is in the JSON:

  $ rtdoctor --json . | grep 'data types differ' | grep -o '"check": "[^"]*"'
  "check": "connection"

A far end that is dead; a component of C++ 2.1 does not die of being asked:

  $ rtdoctor -q ../fragile.host_cxt/Fragile0.rtc | grep Fragile0.rtc:out
  warn  /localhost:$PORT/fragile.host_cxt/Fragile0.rtc:out: had a connection whose far end is dead, and dropped it when asked; try: restart the far end and connect it again: rtcon
  $ rtls ../fragile.host_cxt
  Fragile0.rtc
  *Peer0.rtc

A far end whose process hangs makes the near one hang, too, for it looks whether its far ends are there. Of several that hang, it
waits for the one that its process calls:

  $ rtcon -n c ../near.host_cxt/Near0.rtc:out ../far.host_cxt/Far0.rtc:in
  $ rtact ../far.host_cxt/Far0.rtc ../near.host_cxt/Near0.rtc
  $ mock these Mock:Alien0 --context alien.host_cxt/%n.rtc; hang these2 these3
  $ within 4-14 rtdoctor -q --timeout 4 ../near.host_cxt ../far.host_cxt ../alien.host_cxt | grep Near
  fail  /localhost:$PORT/near.host_cxt/Near0.rtc: hangs when asked for the profile of its port 1, waiting for a far end that does not answer; try: mend /localhost:$PORT/far.host_cxt/Far0.rtc first
  $ wake these2 these3
