A port that does not answer does not hold up the others; it gets values again when it answers.

world: two
world: these ConsoleOut:Far0

  $ RTSHELL_TIMEOUT=1
  $ rtact ConsoleOut0.rtc Far0.rtc
  $ rtinject -n -1 -r 50 -c 1 ConsoleOut0.rtc:in Far0.rtc:in &
  $ sleep 1
  $ ctl received ConsoleOut0:in
  50 1
  $ hang these
  $ sleep 4
  $ show rtinject
  ! rtinject: /robot/test.host_cxt/Far0.rtc:in: no answer within 1s
  $ ctl received ConsoleOut0:in
  250 1
  $ wake these
  $ ctl @these received Far0:in
  50 1
  $ sleep 4
  $ ctl @these received Far0:in
  250 1
  $ strike TERM rtinject
  $ wait rtinject
  ! rtinject: /robot/test.host_cxt/Far0.rtc:in: answers again
  [143] after 9.0 s
  $ ctl @these connectors Far0:in
