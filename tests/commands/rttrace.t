rttrace follows a signal through components, and names the stage where it stops.

server: healthy
world: chain 4
world: services

Values and times differ from run to run; what stays is who is named:

  $ trace() { rttrace -t 2 "$@" > out; code=$?; tail -n +2 out |
  > sed -n 's/^\([A-Z][a-z]*\) .*yes  .*\/\(.*\)/\1 \2/p'; grep -v -e ' Hz ' -e ^STATE out; return $code; }
  $ trace Link0.rtc:out
  Active Link0.rtc:out
  Active Link1.rtc:out
  Active Link2.rtc:out
  no stage stops, holds, thins, delays or disorders the values; whether /localhost:$PORT/test.host_cxt/Link3.rtc takes what comes to it cannot be seen
  $ head -1 out
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  $ trace Link1.rtc:out --to Link2.rtc:in
  Active Link1.rtc:out
  Active Link2.rtc:out
  no stage stops, holds, thins, delays or disorders the values
  $ rttrace -t 2 --json Link2.rtc:out |
  > sed 's/[0-9]*[.][0-9]*[e0-9-]*/N/g; s/"values": [0-9]*/"values": N/; s/"changes": [0-9]*/"changes": N/'
  {"age": N, "buffer": null, "changes": N, "context": N, "delay": null, "jitter": N, "newest": N, "port": "/localhost:$PORT/testNhost_cxt/LinkNrtc:out", "rate": N, "stage": "/localhost:$PORT/testNhost_cxt/LinkNrtc", "state": "Active", "values": N}
  {"buffer": "replaces", "context": N, "delay": null, "stage": "/localhost:$PORT/testNhost_cxt/LinkNrtc", "state": "Active"}
  {"culprit": null, "sure": null, "why": null}

A connection is made to each port on the way, and removed:

  $ ctl @chain connectors Link1:out | wc -l
  1

Plotted, each port on the way, on equal axes:

  $ export COLUMNS=80; rttrace -t 2 --plot Link0.rtc:out > out
  $ sed -n 's/^⠤⠤.*/plot/p; /^no/p; s/.*test.host_cxt.\(.*\), values/\1, values/p' out
  Link0.rtc:out, values per second
  plot
  Link1.rtc:out, values per second
  plot
  Link2.rtc:out, values per second
  plot
  no stage stops, holds, thins, delays or disorders the values; whether /localhost:$PORT/test.host_cxt/Link3.rtc takes what comes to it cannot be seen
  $ rttrace --plot --json Link0.rtc:out
  rttrace: --plot and --json exclude each other (see --help)
  [2]

On a recording, with the connections that it had:

  $ trace_log() { rttrace --from chain.mcap "$@" | sed -n '/^-/s/.* yes  .*host_cxt//p; /^no stage/p'; }
  $ rtlog -q --events -t 4 -f chain.mcap .
  $ trace_log Link0.rtc:out
  /Link0.rtc:out
  /Link1.rtc:out
  /Link2.rtc:out
  no stage stops, holds, thins, delays or disorders the values; whether /localhost:$PORT/test.host_cxt/Link3.rtc takes what comes to it cannot be seen
  $ trace_log -u Link2.rtc:in
  /Link0.rtc:out
  /Link1.rtc:out
  no stage stops, holds, thins, delays or disorders the values; whether /localhost:$PORT/test.host_cxt/Link2.rtc takes what comes to it cannot be seen
  $ trace_log Link0.rtc:out --to Link1.rtc:in -t 1.5
  /Link0.rtc:out
  /Link1.rtc:out
  no stage stops, holds, thins, delays or disorders the values
  $ rttrace --from chain.mcap Apart0.rtc:in
  rttrace: /localhost:$PORT/test.host_cxt/Apart0.rtc:in: no such component with connections in the profile of this log: /localhost:$PORT/test.host_cxt/Apart0.rtc
  [3]
  $ rtlog -q -t 0.3 -f ports.mcap Link0.rtc:out; rttrace --from ports.mcap Link0.rtc:out
  rttrace: ports.mcap: no profile of the system is in this log: record it with rtlog record --events PATH
  [1]

  $ rttrace --from chain.mcap --plot Link1.rtc:out --to Link2.rtc:in > out
  $ grep -c '^⠤⠤ rate  min [0-9]' out
  2
  $ grep -c '^0 is 20' out
  1

What stops it; rtdoctor has the last word. (More of it: tests/sim/stories/rttrace-stops.t.)

  $ rtdeact --wait 20 Link2.rtc; trace Link0.rtc:out
  Active Link0.rtc:out
  Active Link1.rtc:out
  /localhost:$PORT/test.host_cxt/Link2.rtc: it is Inactive (certain)
    rtdoctor: try: rtact /localhost:$PORT/test.host_cxt/Link2.rtc
  [1]

Where it cannot begin or end:

  $ rttrace Link0.rtc:nothing
  rttrace: /localhost:$PORT/test.host_cxt/Link0.rtc: no such port: nothing (its ports: out)
  [3]
  $ rttrace Link0.rtc
  rttrace: /localhost:$PORT/test.host_cxt/Link0.rtc: no port specified; it has /localhost:$PORT/test.host_cxt/Link0.rtc:out (see --help)
  [2]
  $ rttrace MyServiceProvider0.rtc:MyService
  rttrace: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: not a data port (it is a CorbaPort)
  [3]
  $ rttrace Link0.rtc:out -u --to Link3.rtc:in
  rttrace: --to does not go with -u: give the port where the signal starts (see --help)
  [2]
  $ rttrace --from '' Link0.rtc:out
  rttrace: argument --from: the name is empty (see --help)
  [2]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A:out -t 0.3
broken component: 1 4
examples: asking
