rtdel -z cleans up: it deletes all zombies on all name servers, and nothing else.

world: two
world: these Mock:Dead0 Mock:Dead1 Mock:Dead2
world: these Mock:Hung0
world: these ConsoleIn:Fragile0 --flavour cpp2
world: these ConsoleOut:Peer0
world: many 2 --context left.host_cxt/arm.cxt/%n.rtc

  $ rtcon Fragile0.rtc:out Peer0.rtc:in
  $ kill these4
  $ kill many

  $ kill these
  $ hang these2
  $ rtls -R /robot --timeout 0.5
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

  ! rtls: 1 of 10 did not answer (Hung0.rtc)
  [5] after 0.6 s
  $ rtdel -z --dry-run --timeout 0.5
  rtdel -z /robot/left.host_cxt/arm.cxt/Mock0.rtc
  rtdel -z /robot/left.host_cxt/arm.cxt/Mock1.rtc
  rtdel -z /robot/test.host_cxt/Dead0.rtc
  rtdel -z /robot/test.host_cxt/Dead1.rtc
  rtdel -z /robot/test.host_cxt/Dead2.rtc
  rtdel -z /robot/test.host_cxt/Peer0.rtc
  [0] after 0.6 s
  $ rtls --timeout 0.5
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  *Dead0.rtc
  *Dead1.rtc
  *Dead2.rtc
  Fragile0.rtc
  ?Hung0.rtc
  *Peer0.rtc
  ! rtls: 1 of 8 did not answer (Hung0.rtc)
  [5] after 0.6 s

By its name one is deleted only if it is dead:

  $ rtdel -z /robot/left.host_cxt/arm.cxt/Mock0.rtc
  $ rtls --timeout 0.5
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  *Dead0.rtc
  *Dead1.rtc
  *Dead2.rtc
  Fragile0.rtc
  ?Hung0.rtc
  *Peer0.rtc
  ! rtls: 1 of 8 did not answer (Hung0.rtc)
  [5] after 0.6 s

A name server that is down does not keep it from cleaning up the others, nor does one that is listed twice; what lives or
does not answer stays:

  $ RTCTREE_NAMESERVERS="robot:1;robot;10.0.0.1"
  $ rtdel -z -v --timeout 0.5
  ! rtdel: /robot:1: connection refused; is the name server running?
  ! rtdel: /10.0.0.1/left.host_cxt/arm.cxt/Mock1.rtc: deleted
  ! rtdel: /10.0.0.1/test.host_cxt/Dead0.rtc: deleted
  ! rtdel: /10.0.0.1/test.host_cxt/Dead1.rtc: deleted
  ! rtdel: /10.0.0.1/test.host_cxt/Dead2.rtc: deleted
  ! rtdel: /10.0.0.1/test.host_cxt/Peer0.rtc: deleted
  [5] after 0.6 s
  $ rtls -R /robot --timeout 0.5
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

  ! rtls: 1 of 4 did not answer (Hung0.rtc)
  [5] after 0.5 s

Nothing is left to do:

  $ RTCTREE_NAMESERVERS="robot"
  $ rtdel -z --timeout 0.5
  [0] after 0.5 s

No name server at all:

  $ RTCTREE_NAMESERVERS=robot:1 rtdel -z
  ! rtdel: /robot:1: connection refused; is the name server running?
  [4]
  $ RTCTREE_NAMESERVERS='robot:1;robot:2' rtdel -z
  ! rtdel: /robot:1: connection refused; is the name server running?
  ! rtdel: /robot:2: connection refused; is the name server running?
  [4]
  $ hang names
  $ rtdel -z --timeout 0.5
  ! rtdel: /robot: no answer within 0.5s
  [4] after 0.6 s
  $ interrupt 0.5 rtdel -z
  [130] after 0.5 s
