rtfind where components or name servers hang. (Hostile names: tests/commands/rtfind-faults.t.)

hosts: robot arm desk
seat: desk
world: two
world: hung 3 --context test.host_cxt/Hung%n.rtc

A hung component is a component, but nobody knows its state. By its name it is found without asking.

  $ hang hung
  $ rtfind --timeout 0.3 . -t c
  /robot/test.host_cxt/ConsoleIn0.rtc
  /robot/test.host_cxt/ConsoleOut0.rtc
  /robot/test.host_cxt/HungMock0.rtc
  /robot/test.host_cxt/HungMock1.rtc
  /robot/test.host_cxt/HungMock2.rtc
  ! rtfind: /robot/test.host_cxt/HungMock0.rtc: no answer within 0.3s
  ! rtfind: /robot/test.host_cxt/HungMock1.rtc: no answer within 0.3s
  ! rtfind: /robot/test.host_cxt/HungMock2.rtc: no answer within 0.3s
  [5] after 0.3 s
  $ rtfind --timeout 0.3 . --state inactive
  /robot/test.host_cxt/ConsoleIn0.rtc
  /robot/test.host_cxt/ConsoleOut0.rtc
  ! rtfind: /robot/test.host_cxt/HungMock0.rtc: no answer within 0.3s
  ! rtfind: /robot/test.host_cxt/HungMock1.rtc: no answer within 0.3s
  ! rtfind: /robot/test.host_cxt/HungMock2.rtc: no answer within 0.3s
  [5] after 0.3 s
  $ rtfind --timeout 0.3 -q . --state inactive -n 'Hung*'
  ! rtfind: /robot/test.host_cxt/HungMock0.rtc: no answer within 0.3s
  ! rtfind: /robot/test.host_cxt/HungMock1.rtc: no answer within 0.3s
  ! rtfind: /robot/test.host_cxt/HungMock2.rtc: no answer within 0.3s
  [4] after 0.3 s
  $ rtfind . -n 'Hung*'
  /robot/test.host_cxt/HungMock0.rtc
  /robot/test.host_cxt/HungMock1.rtc
  /robot/test.host_cxt/HungMock2.rtc
  $ interrupt 0.3 rtfind . -t c
  [130] after 0.3 s
  $ interrupt 0.3 rtfind --wait 30 . -n nothing
  [130] after 0.3 s

Name servers: one that cannot be reached, and one that hangs.

  $ cut arm
  $ rtfind --timeout 0.3 /arm
  ! rtfind: /arm: no answer within 0.3s
  [4] after 0.3 s
  $ RTCTREE_NAMESERVERS="robot;arm;robot:1" rtfind --timeout 0.3 / -n 'Console*'
  /robot/test.host_cxt/ConsoleIn0.rtc
  /robot/test.host_cxt/ConsoleOut0.rtc
  ! rtfind: /arm: no answer within 0.3s
  ! rtfind: /robot:1: connection refused; is the name server running?
  [5] after 0.3 s
  $ hang names
  $ rtfind --timeout 0.3 -q ConsoleIn0.rtc
  ! rtfind: /robot: no answer within 0.3s
  [4] after 0.3 s
  $ wake names
