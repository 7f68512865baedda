rtstart and rtstop where components are slow, silent, or die, and when they are interrupted: what is said is so.

world: two
world: these Slow Stuck
world: these Motor Sensor --flavour cpp11 --rate 50

  $ states() { rtls -l 2> said | awk '{print $1, $6}'; }
  $ rtcryo --all -o all.xml

What takes longer than the timeout failed, --wait gives it more; what answers before it has changed is waited for:

  $ ctl @these delay activate_component 3; rtstart -q --timeout 0.4 all.xml 2> said
  [5]
  $ ctl @these reset; sed 's/;.*//' said | sort
  rtstart: /localhost:$PORT/test.host_cxt/Slow0.rtc: no answer within 0.4s
  rtstart: /localhost:$PORT/test.host_cxt/Stuck0.rtc: no answer within 0.4s
  $ states | grep -v Slow0
  Active ConsoleIn0.rtc
  Active ConsoleOut0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  Inactive Stuck0.rtc
  $ rtstop -q --wait 2 all.xml; within 0.7-6 rtstart -q --wait 2 all.xml
  rtstart: /localhost:$PORT/test.host_cxt/Stuck0.rtc: not Active within 2s, still Inactive
  [5]

Ctrl-C and SIGTERM, during the checks too:

  $ ctl delay get_ports 9; interrupt 1 rtstart --json -q --timeout 9 all.xml 2> said | cut -c1-160
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not tried: interrupted", "number": 1, "path": "/localhost:$PORT/
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not tried: interrupted", "number": 2, "path": "/localhost:$PORT
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Motor0.rtc: not tried: interrupted", "number": 3, "path": "/localhost:$PORT/test
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Sensor0.rtc: not tried: interrupted", "number": 4, "path": "/localhost:$PORT/tes
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Slow0.rtc: not tried: interrupted", "number": 5, "path": "/localhost:$PORT/test.
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Stuck0.rtc: not tried: interrupted", "number": 6, "path": "/localhost:$PORT/test
  $ cat said; ctl reset
  rtstart: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not tried: interrupted
  rtstart: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not tried: interrupted
  rtstart: /localhost:$PORT/test.host_cxt/Motor0.rtc: not tried: interrupted
  rtstart: /localhost:$PORT/test.host_cxt/Sensor0.rtc: not tried: interrupted
  rtstart: /localhost:$PORT/test.host_cxt/Slow0.rtc: not tried: interrupted
  rtstart: /localhost:$PORT/test.host_cxt/Stuck0.rtc: not tried: interrupted

  $ plan $(when 1 Sensor0 "$(waiting 9000)") $(when 2 ConsoleIn0 "$(preceding SYNC 0 Sensor0)") < all.xml > c.xml
  $ rtdeact --wait ConsoleIn0.rtc Sensor0.rtc; interrupt 4 rtstart -q --wait 9 c.xml
  rtstart: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not tried: interrupted
  rtstart: /localhost:$PORT/test.host_cxt/Sensor0.rtc: not tried: interrupted
  rtstart: /localhost:$PORT/test.host_cxt/Stuck0.rtc: interrupted; whether it has been done is not known
  [130]
  $ timeout 4 rtstart --json --wait 9 c.xml 2> said | grep -v null
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not tried: interrupted", "number": 1, "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Sensor0.rtc: not tried: interrupted", "number": 4, "path": "/localhost:$PORT/test.host_cxt/Sensor0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Stuck0.rtc: interrupted; whether it has been done is not known", "number": 6, "path": "/localhost:$PORT/test.host_cxt/Stuck0.rtc", "required": true, "result": "uncertain"}
  $ rtexit --wait=5 Stuck0.rtc; rtcryo --all -o all.xml
  $ rtstop -q all.xml

Sync waits for the state, After does not:

  $ plan $(when 1 ConsoleIn0 "$(preceding SYNC 400 Slow0)") $(when 1 ConsoleOut0 "$(preceding ASYNC 1000 Motor0)") $(when 1 Slow0 "$(waiting 1)") $(when 1 Motor0 "$(waiting 1)") < all.xml > b.xml
  $ rtstart -q b.xml
  rtstart: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not tried: Sync to Slow0: not Active within 400ms
  [5]
  $ states; rtstop -q all.xml
  Inactive ConsoleIn0.rtc
  Active ConsoleOut0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  Active Slow0.rtc

A call whose answer is lost may have been heard: the state shows it, and where it cannot, rtstart says so

  $ ctl @two fail activate_component 1 HANG
  $ rtstart -q --timeout 1 all.xml 2>&1 | sed 's/Console[InOut]*/Console/'
  rtstart: /localhost:$PORT/test.host_cxt/Console0.rtc: no answer within 1s; it is Inactive now
  $ ctl @two reset; rtstart -q all.xml
  $ states | grep -v ^Active
  [1]
  $ rtstop -q all.xml
  $ ctl @two fail activate_component 1 COMM_FAILURE
  $ rtstart -q all.xml 2>&1 | sed 's/Console[InOut]*/Console/'
  rtstart: /localhost:$PORT/test.host_cxt/Console0.rtc: connection lost; it is Inactive now
  $ rtstop -q all.xml; ctl @two delay activate_component 2
  $ plan $(when 1 ConsoleIn0) $(when 2 Slow0) $(when 3 ConsoleOut0) < all.xml > d.xml
  $ rtstart -q d.xml --timeout 1
  rtstart: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no answer within 1s; whether it has been done is not known
  rtstart: /localhost:$PORT/test.host_cxt/Slow0.rtc: not tried: it comes after /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc, which failed
  rtstart: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not tried: it comes after /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc, which failed
  [5]
  $ soon '[ "$(ctl @two state ConsoleIn0)" = ACTIVE ]'
  $ ctl @two reset; rtstop -q all.xml
  $ ctl @two fail activate_component 1 DIE; rtstart -q d.xml 2> said
  [5]
  $ sed 's/lost.*/lost/; s/refused.*/lost/' said
  rtstart: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: connection lost
  rtstart: /localhost:$PORT/test.host_cxt/Slow0.rtc: not tried: it comes after /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc, which failed
  rtstart: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not tried: it comes after /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc, which failed
  $ states
  - *ConsoleIn0.rtc
  - *ConsoleOut0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  Inactive Slow0.rtc
  $ rtdel -z; mock two
  $ rtstart -q d.xml; states
  Active ConsoleIn0.rtc
  Active ConsoleOut0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  Active Slow0.rtc
