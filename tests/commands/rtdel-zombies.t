rtdel -z deletes what is dead, and asks little of what lives. (The rest: tests/sim/stories/rtdel-zombies.t.)

world: two
world: fragile
world: zombie 2 --context left.host_cxt/arm.cxt/%n.rtc
both: each ORB tells what is dead in its own way

The commands that it prints do the same as itself:

  $ rtdel -z --dry-run | head -1
  rtdel -z /localhost:$PORT/left.host_cxt/arm.cxt/Mock0.rtc
  $ rtdel -z --dry-run | head -1 | sh
  $ rtdel -z -v
  rtdel: /localhost:$PORT/left.host_cxt/arm.cxt/Mock1.rtc: deleted
  rtdel: /localhost:$PORT/test.host_cxt/Peer0.rtc: deleted

Nothing is left to do; of the living it has asked one question each:

  $ ctl reset
  $ rtdel -z
  $ calls
  2 _non_existent

Who dies or comes back in the meantime: the first answer is not enough.

  $ ctl fail _non_existent 1 TRANSIENT; rtdel -z -v
  $ ctl fail _non_existent 1 OBJECT_NOT_EXIST; ctl fail _non_existent 2 OBJECT_NOT_EXIST
  $ rtdel -z -v
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Fragile0.rtc
