rtinject keeps its rate within 1 % for ten seconds.

alone: it measures
world: two

  $ rtact ConsoleOut0.rtc
  $ rtinject -v -r 100 -n 1001 -c '{"data": 1}' ConsoleOut0.rtc:in 2>&1 | grep -o '[0-9.]* Hz'
  (99|100)\.[0-9]* Hz (re)
  $ ctl received ConsoleOut0:in 1001
  1001 1
  $ ctl times ConsoleOut0:in
  1001
