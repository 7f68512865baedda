rtinject keeps its rate for ten seconds, value after value.

world: two

  $ rtact ConsoleOut0.rtc
  $ rtinject -v -r 100 -n 1001 -c '{"data": 1}' ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: connected, id $UUID
  ! rtinject: 1001 sent, 100.00 Hz
  [0] after 10.1 s
  $ ctl received ConsoleOut0:in
  1001 1
