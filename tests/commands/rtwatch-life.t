rtwatch reports when a component exits, dies, falls silent, and when it is there again.

world: observed
world: these ConsoleIn:Plain0 --flavour cpp2
world: these ConsoleIn:Dies0 --flavour py2
world: these ConsoleIn:Gone0 --flavour cpp2
both: each ORB serves observers in its own way

One that exits in good order, one that dies, observed and polled, and come back. Once back, it is observed again:

  $ rtwatch -f RTC_STATUS -f LIFE_EVENT Motor0.rtc Plain0.rtc Dies0.rtc Gone0.rtc > out 2>&1 & watch=$!
  $ watched Motor0; soon 'ctl @these2 observers Dies0 | grep Obs'; soon 'ctl @these3 calls | grep get_component_state'
  $ soon 'ctl @these calls | grep get_component_state'
  $ rtexit Motor0.rtc Plain0.rtc; kill-mock these2; kill-mock these3
  $ soon 'grep Dies0.*DIED out'; soon 'grep Gone0.*DIED out'; soon 'grep Plain0.*EXITED out'; soon 'grep Motor0.*EXITED out'
  $ plain out | sort
  [Dies0.rtc T] DIED
  [Gone0.rtc T] DIED
  [Motor0.rtc T] 0 FINALIZE
  [Motor0.rtc T] EXITED
  [Plain0.rtc T] EXITED
  rtwatch: /localhost:$PORT/test.host_cxt/Gone0.rtc: offers no observer; it is polled (5 Hz), which shows no connections
  rtwatch: /localhost:$PORT/test.host_cxt/Plain0.rtc: offers no observer; it is polled (5 Hz), which shows no connections
  $ mock these ConsoleIn:Dies0 ConsoleIn:Gone0 --flavour py2; soon '[ $(grep -c BACK out) = 2 ]'
  $ rtact Dies0.rtc Gone0.rtc; soon '[ $(grep -c "ACTIVE" out) = 2 ]'; kill $watch; wait $watch
  [143]
  $ plain out | grep -E 'BACK|ACTIVE' | sort
  [Dies0.rtc T] 0 ACTIVE
  [Dies0.rtc T] BACK
  [Gone0.rtc T] 0 ACTIVE
  [Gone0.rtc T] BACK
  $ ctl @these4 observers Dies0; ctl @these4 observers Gone0

A component whose process hangs, and goes on. What is not wanted as an event is reported on stderr; and SIGTERM ends the watch
within the timeout, although nothing can be taken back:

  $ rtwatch -f RTC_STATUS --timeout 0.5 Dies0.rtc > out 2> err & watch=$!
  $ soon 'ctl @these4 observers Dies0 | grep Obs'; hang these4; soon 'grep answer err'
  $ wake these4; soon 'grep again err'; rtdeact Dies0.rtc; soon 'grep INACTIVE out'
  $ hang these4; soon '[ $(grep -c "no answer" err) = 2 ]'; begun=$(date +%s); kill -TERM $watch; wait $watch
  [143]
  $ echo $(($(date +%s) - begun < 3)); wake these4; plain out; cat err
  1
  [T] 0 INACTIVE
  rtwatch: /localhost:$PORT/test.host_cxt/Dies0.rtc: no answer within 0.5s
  rtwatch: /localhost:$PORT/test.host_cxt/Dies0.rtc: answers again
  rtwatch: /localhost:$PORT/test.host_cxt/Dies0.rtc: no answer within 0.5s
  rtwatch: /localhost:$PORT/test.host_cxt/Dies0.rtc: does not answer; it still has our observer, and drops it when a call to it fails

One that answers, but has lost its observer: it is lent once more, then the component is polled.

  $ rtwatch -f RTC_STATUS -f LIFE_EVENT -f PORT_EVENT ConsoleIn0.rtc ConsoleOut0.rtc > out 2>&1 & watch=$!
  $ watched ConsoleIn0; watched ConsoleOut0; rtact ConsoleIn0.rtc ConsoleOut0.rtc; soon '[ $(grep -c " ACTIVE" out) = 2 ]'
  $ ctl mute ConsoleIn0; ctl mute ConsoleOut0 9
  $ soon 'grep polled out'; rtdeact ConsoleIn0.rtc ConsoleOut0.rtc; soon '[ $(grep -c " INACTIVE" out) = 2 ]'; kill $watch
  $ wait $watch; plain out | grep -v SEND | sort
  [ConsoleIn0.rtc T] 0 ACTIVE
  [ConsoleIn0.rtc T] 0 INACTIVE
  [ConsoleIn0.rtc T] ANSWERS
  [ConsoleIn0.rtc T] NO_HEARTBEAT
  [ConsoleOut0.rtc T] 0 ACTIVE
  [ConsoleOut0.rtc T] 0 INACTIVE
  [ConsoleOut0.rtc T] NO_HEARTBEAT
  rtwatch: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no heartbeat for 3 s
  rtwatch: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: cannot call us at HOST:PORT; it is polled from now on
  rtwatch: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no heartbeat for 3 s
  $ ctl observers ConsoleIn0; ctl observers ConsoleOut0

One that takes the observer only after some seconds is watched from then on:

  $ ctl delay add_service_profile 4; rtwatch -f RTC_STATUS -f LIFE_EVENT --timeout 60 ConsoleIn0.rtc > out 2>&1 & watch=$!
  $ soon 'ctl observers ConsoleIn0 | grep Obs'; ctl reset; rtact ConsoleIn0.rtc; soon 'grep ACTIVE out'; kill $watch; wait $watch
  [143]
  $ plain out; rtdeact ConsoleIn0.rtc
  [T] 0 ACTIVE

An observer of C++ is removed at once, but the component answers only when its heart would have beaten again. Nobody waits for
that after Ctrl-C, SIGTERM or SIGHUP; the observer is gone all the same.

  $ mock observed --flavour cpp2 --context cpp.host_cxt/%n.rtc
  $ cd=/localhost:$PORT/cpp.host_cxt
  $ for signal in INT TERM HUP; do
  >     python3 -c 'import signal, sys, os; signal.signal(signal.SIGINT, signal.SIG_DFL); os.execvp(sys.argv[1], sys.argv[1:])' \
  >         rtwatch $cd/ConsoleIn0.rtc $cd/ConsoleOut0.rtc $cd/Microwave0.rtc > nul & watch=$!
  >     for name in ConsoleIn0 ConsoleOut0 Microwave0; do soon "ctl @observed2 observers $name | grep Obs"; done
  >     kill -$signal $watch; within 0-0.6 tail --pid=$watch -s 0.01 -f /dev/null; wait $watch; echo $?
  >     for name in ConsoleIn0 ConsoleOut0 Microwave0; do soon "! ctl @observed2 observers $name | grep Obs"; done
  > done
  130
  143
  129
  $ within 0.9-3 rtwatch -f LIFE_EVENT -t 0.1 $cd/ConsoleIn0.rtc
