However rtprint ends, its connections are removed. (Signals, and ports that die, hang or are disconnected:
tests/sim/stories/rtprint-ends.t.)

world: two
world: senders 50 12
world: these Mock:Quiet0
both: each ORB receives and sends values in its own way

  $ connected() { [ -n "$(ctl connectors ConsoleIn0:out 2>&-)$(ctl @these connectors Quiet0:out 2>&-)" ]; }
  $ start() { "$@" & pid=$!; soon 'connected || ! kill -0 $pid 2>&-'; }
  $ none() { if connected; then echo "a connector is left"; fi; }

SIGHUP where it is ignored:

  $ start nohup rtprint -q -t 3 Quiet0.rtc:out
  > kill -HUP $pid; wait $pid
  > echo $?
  > none
  0

Without stdin, without stdout, without a terminal, as in cron:

  $ start rtprint -q -n 1 ConsoleIn0.rtc:out <&-
  > ctl write ConsoleIn0:out 1
  > wait $pid
  > none
  [0.000000000] 1
  $ start rtprint -q -n 1 ConsoleIn0.rtc:out </dev/null
  > ctl write ConsoleIn0:out 2
  > wait $pid
  > none
  [0.000000000] 2
  $ start setsid -w rtprint -q -n 1 ConsoleIn0.rtc:out </dev/null 2>&-
  > ctl write ConsoleIn0:out 3
  > wait $pid
  > none
  [0.000000000] 3
  $ start rtprint -q -n 1 ConsoleIn0.rtc:out >&-
  > ctl write ConsoleIn0:out 4
  > wait $pid
  > none
  rtprint: cannot write the output: Bad file descriptor
  $ start rtprint -q -n 1 ConsoleIn0.rtc:out >/dev/full
  > ctl write ConsoleIn0:out 5
  > wait $pid
  > none
  rtprint: No space left on device

The reader of the output goes away, whether anything is printed or not:

  $ rtprint Source0.rtc:number | head -1 | cut -c1
  [
  $ none; ctl @senders connectors Source0:number
  $ (within 0-5 rtprint Quiet0.rtc:out; echo $? >status) | true; cat status
  141
  $ none

Where components cannot reach us, they drop the connection at their first value; then --pull may do:

  $ export RTCTREE_ORB_ARGS='-ORBendPoint;giop:tcp:127.0.0.1:;-ORBendPointPublish;giop:tcp:127.0.0.2:'
  $ rtprint Source0.rtc:number
  rtprint: /localhost:$PORT/test.host_cxt/Source0.rtc:number: the connection has been removed; if the component did that, it cannot reach this machine (pull may do), or its values exceed its ORB's giopMaxMsgSize
  [4]
  $ rtprint --pull -n 2 Source0.rtc:number | wc -l
  2
  $ RTCTREE_ORB_ARGS='-ORBendPoint;giop:tcp:192.0.2.222:' rtprint Source0.rtc:number
  rtprint: this machine cannot be reached at the address that ORBendPoint names (see --help)
  [2]
  $ export RTCTREE_ORB_ARGS=
