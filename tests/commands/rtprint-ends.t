However rtprint ends, its connections are removed; ports that die, hang or are disconnected are told.

world: two
world: senders 50 12
world: these Mock:Quiet0

  $ connected() { [ -n "$(ctl connectors ConsoleIn0:out)$(ctl @these connectors Quiet0:out)" ]; }
  $ start() { "$@" & pid=$!; until connected || ! kill -0 $pid 2>&-; do :; done; }
  $ none() { if connected; then echo "a connector is left"; fi; }

Signals, also two at a time:

  $ for s in TERM HUP; do start rtprint ConsoleIn0.rtc:out Quiet0.rtc:out; kill -$s $pid; wait $pid; echo $?; none; done
  $ start rtprint --pull ConsoleIn0.rtc:out; kill -HUP $pid; kill -TERM $pid; wait $pid; none
  $ interrupt 1 rtprint ConsoleIn0.rtc:out; none
  $ interrupt 1 rtprint --stats Quiet0.rtc:out; none
  $ start nohup rtprint -t 1 Quiet0.rtc:out; kill -HUP $pid; wait $pid; echo $?; none

Without stdin, without stdout, without a terminal, as in cron:

  $ start rtprint -n 1 ConsoleIn0.rtc:out <&-; ctl write ConsoleIn0:out 1; wait $pid; none
  $ start rtprint -n 1 ConsoleIn0.rtc:out </dev/null; ctl write ConsoleIn0:out 2; wait $pid; none
  $ start setsid -w rtprint -n 1 ConsoleIn0.rtc:out </dev/null 2>&-; ctl write ConsoleIn0:out 3; wait $pid; none
  $ start rtprint -n 1 ConsoleIn0.rtc:out >&-; ctl write ConsoleIn0:out 4; wait $pid; none
  $ start rtprint -n 1 ConsoleIn0.rtc:out >/dev/full; ctl write ConsoleIn0:out 5; wait $pid; none

The reader of the output goes away, whether anything is printed or not:

  $ rtprint Source0.rtc:number | head -1 | cut -c1; none; ctl @senders connectors Source0:number
  $ (within 0-5 rtprint Quiet0.rtc:out; echo $? >status) | true; cat status; none

Someone removes the connection, or the component exits:

  $ start rtprint ConsoleIn0.rtc:out; rtdis ConsoleIn0.rtc:out; wait $pid
  $ start rtprint --pull ConsoleIn0.rtc:out; rtdis ConsoleIn0.rtc:out; wait $pid
  $ start rtprint -t 8 ConsoleIn0.rtc:out.a Quiet0.rtc:out.b; rtexit Quiet0.rtc; sleep 0; kill -0 $pid; ctl write ConsoleIn0:out 6; ctl write ConsoleIn0:out 7; sleep 3; kill -TERM $pid; wait $pid; none

Hung for a while: that is told, and it goes on:

  $ export RTSHELL_TIMEOUT=0.5
  $ (rtprint -n 300 Source0.rtc:number >lines; echo $? >status) & while [ ! -s lines ]; do :; done
  $ hang senders; sleep 3.5; resume senders; wait; cat status; wc -l <lines

Hung when it ends, and killed in the middle of its stream:

  $ start rtprint ConsoleIn0.rtc:out; hang two; within 0-2 kill $pid; wait $pid; resume two; ctl disconnect ConsoleIn0:out
  $ (rtprint Source0.rtc:number >lines; echo $? >status) & while [ ! -s lines ]; do :; done
  $ kill-mock senders; wait; cat status
  $ (rtprint --pull ConsoleIn0.rtc:out; echo $? >status) & until connected; do :; done; kill-mock two; wait; cat status
  $ rtprint ConsoleIn0.rtc:out
