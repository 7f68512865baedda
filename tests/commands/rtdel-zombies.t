rtdel -z cleans up: it deletes all zombies on all name servers, and nothing else.

world: two
world: these Mock:Dead0 Mock:Dead1 Mock:Dead2
world: these Mock:Hung0
world: fragile
world: zombie 2 --context left.host_cxt/arm.cxt/%n.rtc
both: each ORB tells what is dead in its own way

  $ kill-mock these; hang these2
  $ rtls -R /localhost:$PORT --timeout 0.5 2>/dev/null
  .:
  left.host_cxt/
  test.host_cxt/

  ./left.host_cxt:
  arm.cxt/

  ./left.host_cxt/arm.cxt:
  *Mock0.rtc
  *Mock1.rtc

  ./test.host_cxt:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  *Dead0.rtc
  *Dead1.rtc
  *Dead2.rtc
  Fragile0.rtc
  ?Hung0.rtc
  *Peer0.rtc

  [5]
  $ rtdel -z --dry-run --timeout 0.5
  rtdel -z /localhost:$PORT/left.host_cxt/arm.cxt/Mock0.rtc
  rtdel -z /localhost:$PORT/left.host_cxt/arm.cxt/Mock1.rtc
  rtdel -z /localhost:$PORT/test.host_cxt/Dead0.rtc
  rtdel -z /localhost:$PORT/test.host_cxt/Dead1.rtc
  rtdel -z /localhost:$PORT/test.host_cxt/Dead2.rtc
  rtdel -z /localhost:$PORT/test.host_cxt/Peer0.rtc
  $ rtls --timeout 0.5 2>/dev/null | grep Dead0
  *Dead0.rtc

The commands that it prints do the same:

  $ rtdel -z --dry-run --timeout 0.5 | head -1 | sh
  $ rtls --timeout 0.5 2>/dev/null
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  *Dead0.rtc
  *Dead1.rtc
  *Dead2.rtc
  Fragile0.rtc
  ?Hung0.rtc
  *Peer0.rtc
  [5]

A name server that is down does not keep it from cleaning up the others, nor does one that is listed twice; what lives or
does not answer stays:

  $ export RTCTREE_NAMESERVERS="localhost:1;localhost:$PORT;127.0.0.1:$PORT"
  $ within 0.4-2 rtdel -z -v --timeout 0.5
  rtdel: /localhost:1: connection refused; is the name server running?
  rtdel: /127.0.0.1:$PORT/left.host_cxt/arm.cxt/Mock1.rtc: deleted
  rtdel: /127.0.0.1:$PORT/test.host_cxt/Dead0.rtc: deleted
  rtdel: /127.0.0.1:$PORT/test.host_cxt/Dead1.rtc: deleted
  rtdel: /127.0.0.1:$PORT/test.host_cxt/Dead2.rtc: deleted
  rtdel: /127.0.0.1:$PORT/test.host_cxt/Peer0.rtc: deleted
  [5]
  $ rtls -R /localhost:$PORT --timeout 0.5 2>/dev/null
  .:
  left.host_cxt/
  test.host_cxt/

  ./left.host_cxt:
  arm.cxt/

  ./left.host_cxt/arm.cxt:

  ./test.host_cxt:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Fragile0.rtc
  ?Hung0.rtc

  [5]

Nothing is left to do; of the living it has asked one question each:

  $ export RTCTREE_NAMESERVERS="localhost:$PORT"
  $ ctl reset
  $ within 0.4-2 rtdel -z --timeout 0.5
  $ calls
  2 _non_existent

Who dies or comes back in the meantime: the first answer is not enough.

  $ ctl fail _non_existent 1 TRANSIENT; rtdel -z -v --timeout 0.5
  $ ctl fail _non_existent 1 OBJECT_NOT_EXIST; ctl fail _non_existent 2 OBJECT_NOT_EXIST
  $ rtdel -z -v --timeout 0.5 2>&1 | grep -v Hung
  [1]
  $ rtls --timeout 0.5 2>/dev/null
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Fragile0.rtc
  ?Hung0.rtc
  [5]

No name server at all:

  $ RTCTREE_NAMESERVERS=localhost:1 rtdel -z
  rtdel: /localhost:1: connection refused; is the name server running?
  [4]
  $ RTCTREE_NAMESERVERS='localhost:1;localhost:2' rtdel -z
  rtdel: /localhost:1: connection refused; is the name server running?
  rtdel: /localhost:2: connection refused; is the name server running?
  [4]
  $ hang names
  $ within 0.4-1.4 rtdel -z --timeout 0.5
  rtdel: /localhost:$PORT: no answer within 0.5s
  [4]
  $ interrupt 0.5 rtdel -z
  [130]
