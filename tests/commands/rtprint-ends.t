However rtprint ends, its connections are removed; ports that die, hang or are disconnected are reported.

world: two
world: senders 50 12
world: these Mock:Quiet0
both: each ORB receives and sends values in its own way

  $ connected() { [ -n "$(ctl connectors ConsoleIn0:out 2>&-)$(ctl @these connectors Quiet0:out 2>&-)" ]; }
  $ told() { soon "grep -q '$1' told || ! kill -0 $pid"; cat told; }
  $ start() { "$@" & pid=$!; soon 'connected || ! kill -0 $pid 2>&-'; }
  $ none() { if connected; then echo "a connector is left"; fi; }

Signals, also two at a time:

  $ for s in TERM HUP; do
  >     start rtprint ConsoleIn0.rtc:out Quiet0.rtc:out
  >     kill -$s $pid
  >     wait $pid
  >     echo $?
  >     none
  > done
  143
  129
  $ start rtprint --pull ConsoleIn0.rtc:out
  $ kill -HUP $pid; kill -TERM $pid
  $ wait $pid; none
  $ interrupt 1 rtprint ConsoleIn0.rtc:out; none
  $ interrupt 1 rtprint --stats Quiet0.rtc:out; none
  all in all: no values
  $ start nohup rtprint -q -t 3 Quiet0.rtc:out
  > kill -HUP $pid; wait $pid
  > echo $?
  > none
  0

A component that is not Active sends nothing, which is said:

  $ rtprint -t 5 Quiet0.rtc:out
  rtprint: /localhost:$PORT/test.host_cxt/Quiet0.rtc:out: no value has come: it is Inactive; rtact /localhost:$PORT/test.host_cxt/Quiet0.rtc
  $ rtact --wait=30 Quiet0.rtc; rtprint -t 5 Quiet0.rtc:out
  $ rtdeact Quiet0.rtc

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

Someone removes the connection, or the component exits:

  $ start rtprint ConsoleIn0.rtc:out
  > rtdis ConsoleIn0.rtc:out
  > wait $pid
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: the connection has been removed; if the component did that, it cannot reach this machine (pull may do), or its values exceed its ORB's giopMaxMsgSize
  [4]
  $ start rtprint --pull ConsoleIn0.rtc:out
  > rtdis ConsoleIn0.rtc:out
  > wait $pid
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: the connection has been removed
  [4]
  $ start rtprint -q ConsoleIn0.rtc:out.a Quiet0.rtc:out.b 2>told
  > rtexit Quiet0.rtc
  > told Quiet0
  rtprint: /localhost:$PORT/test.host_cxt/Quiet0.rtc:out: the component has ended
  $ ctl write ConsoleIn0:out 6
  a: [0.000000000] 6
  $ ctl write ConsoleIn0:out 7
  a: [0.000000000] 7
  $ rtdis ConsoleIn0.rtc:out
  $ wait $pid
  [4]

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

Hung for a while: that is reported, and it continues:

  $ export RTSHELL_TIMEOUT=0.5
  $ rtprint Source0.rtc:number >lines 2>told & pid=$!; soon '[ -s lines ]'
  $ hang senders
  $ told answer
  rtprint: /localhost:$PORT/test.host_cxt/Source0.rtc:number: no answer within 0.5s
  $ wake senders
  $ told again
  rtprint: /localhost:$PORT/test.host_cxt/Source0.rtc:number: no answer within 0.5s
  rtprint: /localhost:$PORT/test.host_cxt/Source0.rtc:number: answers again
  $ kill $pid; wait $pid
  [143]

Hung when it ends:

  $ rm lines; start rtprint ConsoleIn0.rtc:out >lines
  > until [ -s lines ]; do ctl write ConsoleIn0:out 1; done
  > hang two
  > kill $pid; within 0-2 tail --pid=$pid -f /dev/null
  > wait $pid
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: no answer within 0.5s
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: connection $UUID may stay, because the component does not answer; when it does again: rtdis -i $UUID /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  [143]
  $ wake two
  $ ctl write ConsoleIn0:out 1
  $ while connected; do :; done

Killed in the middle of its stream:

  $ rm lines; rtprint Source0.rtc:number >lines & pid=$!
  > soon '[ -s lines ]'
  > kill-mock senders; wait $pid
  rtprint: /localhost:$PORT/test.host_cxt/Source0.rtc:number: the component is gone, and its process too
  [4]
  $ start rtprint --pull ConsoleIn0.rtc:out
  > kill-mock two; wait $pid
  rtprint: /localhost:\$PORT/test.host_cxt/ConsoleIn0.rtc:out: connection (lost|refused) (re)
  [4]
  $ rtprint ConsoleIn0.rtc:out
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: connection refused; its process is gone (zombie)
  [4]
