Signals that strike while connections are made or removed leave none of them behind.

world: two
world: senders 500 12
world: these ConsoleIn:Hangs0 ConsoleIn:Lives0
both: each ORB receives and sends values in its own way

  $ six=$(yes ConsoleIn0.rtc:out | head -n 6)
  $ called() { [ "$(calls | grep -c " $1\$")" -gt 0 ]; }
  $ all_removed() { calls |
  > awk '/ connect$/ { n = $1 } / disconnect$/ { m = $1 } END { exit !(n && n == m) }'; }
  $ connected() { [ $(ctl connectors ConsoleIn0:out | wc -l) -ge $1 ]; }

While they are made, which takes its time here:

  $ ctl delay connect 1; rtprint -q $six & pid=$!; until called connect; do :; done; kill $pid; wait $pid
  [143]
  $ all_removed
  $ rtact ConsoleOut0.rtc; ctl reset; ctl delay connect 1; rtinject -c 1 -n -1 ConsoleOut0.rtc:in & pid=$!; until called connect; do :; done; kill -HUP $pid; wait $pid
  [129]
  $ all_removed; ctl reset

While they are removed, at the command's own end; at most four are being removed at one time:

  $ rtprint -q -n 1 $six & pid=$!; soon 'connected 6'; ctl delay disconnect 0.5; ctl write ConsoleIn0:out 1
  > until called disconnect; do :; done; kill $pid; wait $pid
  ConsoleIn0.rtc:out: [0.000000000] 1
  [143]
  $ connected 1
  [1]

Where the component does not answer then, or refuses, the connection stays, and that is said:

  $ export RTSHELL_TIMEOUT=1; ctl reset; rtprint -q ConsoleIn0.rtc:out & pid=$!; soon 'connected 1'
  > ctl fail disconnect 1 HANG; kill $pid; wait $pid
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  [143]
  $ ctl reset; rtdis ConsoleIn0.rtc:out; rtprint -q ConsoleIn0.rtc:out & pid=$!; soon 'connected 1'
  > ctl fail disconnect 1 UNKNOWN; ctl fail notify_disconnect 1 UNKNOWN; kill $pid; wait $pid
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: CORBA.UNKNOWN
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component refused to remove it; to try again: rtdis -i $UUID /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  [143]
  $ rtdis ConsoleIn0.rtc:out
  $ ctl reset; ctl fail connect 1 HANG; rtprint -q ConsoleIn0.rtc:out & pid=$!; until called connect; do :; done; kill $pid; wait $pid
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  [143]
  $ ctl reset; ctl delay connect 0.5; ctl fail disconnect 1 HANG; rtprint -q ConsoleIn0.rtc:out & pid=$!; until called connect; do :; done
  > kill $pid; wait $pid
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  [143]
  $ ctl reset; rtdis ConsoleIn0.rtc:out; rtlog -q -f log ConsoleIn0.rtc:out & pid=$!; soon 'connected 1'
  > ctl fail disconnect 1 HANG; kill $pid; wait $pid
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  [143]
  $ ctl reset; rtdis ConsoleIn0.rtc:out

One that hangs does not keep the others of its process connected:

  $ rtprint -q Hangs0.rtc:out Lives0.rtc:out 2>said & pid=$!; soon '[ -n "$(ctl @these connectors Lives0:out)" ]'
  > ctl @these hang Hangs0 60; soon 'grep -q answer said'; kill $pid; wait $pid
  [143]
  $ cat said
  rtprint: /localhost:$PORT/test.host_cxt/Hangs0.rtc:out: no answer within 1s
  rtprint: /localhost:$PORT/test.host_cxt/Hangs0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /localhost:$PORT/test.host_cxt/Hangs0.rtc:out
  $ ctl @these connectors Lives0:out; ctl @these reset
  $ export RTSHELL_TIMEOUT=3

While the reader of the output takes nothing:

  $ mkfifo pipe; sleep 30 < pipe & reader=$!
  $ rtprint --json Source0.rtc:number > pipe & pid=$!
  $ soon '[ -n "$(ctl @senders connectors Source0:number)" ]'; n=$(ctl @senders sent Source0:number)
  $ soon '[ $(ctl @senders sent Source0:number) -gt $((n + 999)) ]'; kill $pid; within 0-9 tail --pid=$pid -f /dev/null; wait $pid
  [143]
  $ kill $reader; ctl @senders connectors Source0:number

A component that is silent when it is to connect; it may have taken the connection all the same, or may yet:

  $ export RTSHELL_TIMEOUT=1; ctl reset
  $ ctl fail connect 1 HANG; rtprint -n 1 ConsoleIn0.rtc:out
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: no answer within 1s
  [4]
  $ ctl fail connect 1 HANG; rtinject -c 1 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: no answer within 1s
  [4]
