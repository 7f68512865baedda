rtdis when the far end of a connection is dead or does not answer. Nothing of that may keep a connection alive, nor end the component that is asked.

world: two
world: these ConsoleOut:Far0 ConsoleIn:Far1
world: fragile
world: fragile --flavour cpp2 --context old.host_cxt/%n.rtc
world: two --flavour cpp2 --context cpp.host_cxt/%n.rtc
both: each ORB tells what is dead in its own way

  $ rtdis -v Fragile0.rtc:out
  $ rtdis -v Fragile0.rtc
  $ ctl @fragile connectors Fragile0:out

  $ rtdis -v ../old.host_cxt/Fragile0.rtc
  $ ctl @fragile2 connectors Fragile0:out

The dead end listed behind, and in front:

  $ rtcon -i behind ConsoleIn0.rtc:out Far0.rtc:in
  $ rtcon -i before Far1.rtc:out ConsoleOut0.rtc:in
  $ rtcon -i cpp-behind ../cpp.host_cxt/ConsoleIn0.rtc:out Far0.rtc:in
  $ rtcon -i cpp-before Far1.rtc:out ../cpp.host_cxt/ConsoleOut0.rtc:in

While a far end hangs, the near component waits for it when it is asked anything about its port; rtdis does not wait for ever:

  $ hang these
  $ within 0.4-1.4 rtdis --timeout 0.5 ConsoleIn0.rtc:out
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no answer within 0.5s
  [4]
  $ within 0.4-1.4 rtdis --timeout 0.5 -i before ConsoleOut0.rtc
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no answer within 0.5s
  [4]
  $ within 0.4-1.4 rtdis --timeout 0.5 ConsoleIn0.rtc:out Far0.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no answer within 0.5s
  [4]
  $ wake these
  $ ctl connectors ConsoleIn0:out
  behind outin

Once it is dead, the component drops the connection by itself when it is asked:

  $ kill-mock these
  $ rtdis Far0.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/Far0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtdis ConsoleIn0.rtc:out Far0.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/Far0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtdis ConsoleOut0.rtc:in
  $ rtdis ../cpp.host_cxt/ConsoleIn0.rtc
  $ rtdis ../cpp.host_cxt/ConsoleOut0.rtc
  $ for w in two two2; do ctl @$w connectors ConsoleIn0:out; ctl @$w connectors ConsoleOut0:in; done

A component that does not answer the request itself:

  $ rtcon -i near ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ ctl fail disconnect 1 UNKNOWN; rtdis ConsoleIn0.rtc
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: CORBA.UNKNOWN
  [6]
  $ ctl fail disconnect 1 HANG; within 0.4-1.4 rtdis --timeout 0.5 ConsoleIn0.rtc:out
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: no answer within 0.5s
  [4]
  $ ctl fail disconnect 1 TRANSIENT; rtdis -v ConsoleIn0.rtc:out
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: removed connection near
  $ ctl connectors ConsoleIn0:out
