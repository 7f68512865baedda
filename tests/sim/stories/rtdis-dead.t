rtdis when the far end of a connection is dead or does not answer. Nothing of that may keep a connection alive, nor end the component that is asked.

world: two
world: these ConsoleOut:Far0 ConsoleIn:Far1
world: these ConsoleIn:Fragile0 --flavour cpp2 --context old.host_cxt/%n.rtc
world: these ConsoleOut:Peer0
world: two --flavour cpp2 --context cpp.host_cxt/%n.rtc

  $ rtcon ../old.host_cxt/Fragile0.rtc:out Peer0.rtc:in
  $ kill these3
  $ rtdis -v ../old.host_cxt/Fragile0.rtc:out
  $ rtdis -v ../old.host_cxt/Fragile0.rtc
  $ ctl @these2 connectors Fragile0:out

The dead end listed behind, and in front:

  $ rtcon -i behind ConsoleIn0.rtc:out Far0.rtc:in
  $ rtcon -i before Far1.rtc:out ConsoleOut0.rtc:in
  $ rtcon -i cpp-behind ../cpp.host_cxt/ConsoleIn0.rtc:out Far0.rtc:in
  $ rtcon -i cpp-before Far1.rtc:out ../cpp.host_cxt/ConsoleOut0.rtc:in

While a far end hangs, the near component waits for it when it is asked anything about its port; rtdis does not wait for ever:

  $ hang these
  $ rtdis --timeout 0.5 ConsoleIn0.rtc:out
  ! rtdis: /robot/test.host_cxt/ConsoleIn0.rtc: no answer within 0.5s
  [4] after 0.5 s
  $ rtdis --timeout 0.5 -i before ConsoleOut0.rtc
  ! rtdis: /robot/test.host_cxt/ConsoleOut0.rtc: no answer within 0.5s
  [4] after 0.5 s
  $ rtdis --timeout 0.5 ConsoleIn0.rtc:out Far0.rtc:in
  ! rtdis: /robot/test.host_cxt/ConsoleIn0.rtc: no answer within 0.5s
  [4] after 0.5 s
  $ wake these
  $ ctl connectors ConsoleIn0:out
  behind outin

Once it is dead, the component drops the connection by itself when it is asked:

  $ kill these
  $ rtdis Far0.rtc:in
  ! rtdis: /robot/test.host_cxt/Far0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtdis ConsoleIn0.rtc:out Far0.rtc:in
  ! rtdis: /robot/test.host_cxt/Far0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtdis ConsoleOut0.rtc:in
  $ rtdis ../cpp.host_cxt/ConsoleIn0.rtc
  $ rtdis ../cpp.host_cxt/ConsoleOut0.rtc
  $ ctl connectors ConsoleIn0:out
  $ ctl connectors ConsoleOut0:in
  $ ctl @two2 connectors ConsoleIn0:out
  $ ctl @two2 connectors ConsoleOut0:in

A component that does not answer the request itself:

  $ rtcon -i near ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ ctl fail disconnect 1 UNKNOWN
  $ rtdis ConsoleIn0.rtc
  ! rtdis: /robot/test.host_cxt/ConsoleIn0.rtc:out: CORBA.UNKNOWN
  [6]
  $ ctl fail disconnect 1 HANG
  $ rtdis --timeout 0.5 ConsoleIn0.rtc:out
  ! rtdis: /robot/test.host_cxt/ConsoleIn0.rtc:out: no answer within 0.5s
  [4] after 0.5 s
  $ ctl fail disconnect 1 TRANSIENT
  $ rtdis -v ConsoleIn0.rtc:out
  ! rtdis: /robot/test.host_cxt/ConsoleIn0.rtc:out: removed connection near
  $ ctl connectors ConsoleIn0:out
