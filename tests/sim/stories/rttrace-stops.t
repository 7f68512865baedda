rttrace follows a signal through components, live and in a recording, and names the stage where it stops.

world: chain 4
world: services
world: these ConsoleOut:Apart0
world: parts

Nothing stops it. What is on the way is connected with while it is traced:

  $ rttrace -t 2 Link0.rtc:out
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active      50 Hz * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link1.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link2.rtc:out (glob)
  Active      50 Hz                                                                    replaces  /robot/test.host_cxt/Link3.rtc
  no stage stops, holds, thins, delays or disorders the values; whether /robot/test.host_cxt/Link3.rtc takes what comes to it cannot be seen
  [0] after 2.0 s
  $ rttrace -t 2 -u Link3.rtc:in
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active      50 Hz * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link1.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link2.rtc:out (glob)
  Active      50 Hz                                                                    replaces  /robot/test.host_cxt/Link3.rtc
  no stage stops, holds, thins, delays or disorders the values; whether /robot/test.host_cxt/Link3.rtc takes what comes to it cannot be seen
  [0] after 2.0 s
  $ rttrace -t 2 Link1.rtc:out --to Link2.rtc:in
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active      50 Hz * 50* yes * - * /robot/test.host_cxt/Link1.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link2.rtc:out (glob)
  no stage stops, holds, thins, delays or disorders the values
  [0] after 2.0 s
  $ rttrace -t 2 --json Link2.rtc:out
  …
  {"buffer": "replaces", "context": 50.0, "delay": null, "stage": "/robot/test.host_cxt/Link3.rtc", "state": "Active"}
  {"culprit": null, "sure": null, "why": null}
  [0] after 2.0 s
  $ ctl connectors Link1:out
  $UUID out_in

Branches and loops are shown once; service connections are shown:

  $ rtcon -q Sensor0.rtc:out Controller0.rtc:in
  $ rtcon -q Controller0.rtc:out Motor0.rtc:in
  $ rtcon -q Motor0.rtc:out Sensor0.rtc:in
  $ rtcon -q Sensor0.rtc:out Motor0.rtc:in
  $ rtcon -q Hokuyo_AIST0.rtc:ranges Clusterer0.rtc:ranges
  $ rtcon -q Hokuyo_AIST0.rtc:control MyServiceConsumer0.rtc:MyService
  $ rtact --wait 5 Sensor0.rtc Controller0.rtc Motor0.rtc Hokuyo_AIST0.rtc Clusterer0.rtc
  $ rttrace -t 2 Sensor0.rtc:out
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active    1000 Hz * 50* yes * replaces * /robot/test.host_cxt/Sensor0.rtc:out (glob)
  Active    1000 Hz * 50* yes * replaces * /robot/test.host_cxt/Controller0.rtc:out (glob)
  Active    1000 Hz * 50* yes * replaces * /robot/test.host_cxt/Motor0.rtc:out (glob)
  no stage stops, holds, thins, delays or disorders the values
  [0] after 2.0 s
  $ rttrace -t 0.5 Hokuyo_AIST0.rtc:ranges
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active    1000 Hz * 50* yes * - * /robot/test.host_cxt/Hokuyo_AIST0.rtc:ranges (glob)
  service   /robot/test.host_cxt/Hokuyo_AIST0.rtc:control and /robot/test.host_cxt/MyServiceConsumer0.rtc:MyService
  Active    1000 Hz * 50* yes * replaces * /robot/test.host_cxt/Clusterer0.rtc:clusters (glob)
  no stage stops, holds, thins, delays or disorders the values
  [0] after 0.5 s
  $ rttrace -t 0.5 --json Hokuyo_AIST0.rtc:ranges
  {"age": 3.188347999999999e-05, "buffer": null, "changes": 24, "context": 1000.0, "delay": null, "jitter": 1.110567006333019e-05, "newest": 0.009685248, "port": "/robot/test.host_cxt/Hokuyo_AIST0.rtc:ranges", "rate": 50.00386696571203, "stage": "/robot/test.host_cxt/Hokuyo_AIST0.rtc", "state": "Active", "values": 25}
  {"far": "/robot/test.host_cxt/MyServiceConsumer0.rtc:MyService", "service": "/robot/test.host_cxt/Hokuyo_AIST0.rtc:control", "stage": "/robot/test.host_cxt/Hokuyo_AIST0.rtc"}
  {"age": null, "buffer": "replaces", "changes": 24, "context": 1000.0, "delay": null, "jitter": 7.540782629586441e-06, "newest": 0.009635584, "port": "/robot/test.host_cxt/Clusterer0.rtc:clusters", "rate": 49.99968000204799, "stage": "/robot/test.host_cxt/Clusterer0.rtc", "state": "Active", "values": 25}
  {"culprit": null, "sure": null, "why": null}
  [0] after 0.5 s

On a recording, with the connections that it had:

  $ rtlog -q --events -t 4 -f chain.mcap .
  [0] after 4.0 s
  $ rttrace --from chain.mcap Link0.rtc:out
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  -               - * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  -               - * 50* yes * - * /robot/test.host_cxt/Link1.rtc:out (glob)
  -               - * 50* yes * - * /robot/test.host_cxt/Link2.rtc:out (glob)
  -               -                                                                    -         /robot/test.host_cxt/Link3.rtc
  no stage stops, holds, thins, delays or disorders the values; whether /robot/test.host_cxt/Link3.rtc takes what comes to it cannot be seen
  $ rttrace --from chain.mcap -u Link2.rtc:in
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  -               - * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  -               - * 50* yes * - * /robot/test.host_cxt/Link1.rtc:out (glob)
  -               -                                                                    -         /robot/test.host_cxt/Link2.rtc
  no stage stops, holds, thins, delays or disorders the values; whether /robot/test.host_cxt/Link2.rtc takes what comes to it cannot be seen
  $ rttrace --from chain.mcap Link0.rtc:out --to Link1.rtc:in -t 1.5
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  -               - * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  -               - * 50* yes * - * /robot/test.host_cxt/Link1.rtc:out (glob)
  no stage stops, holds, thins, delays or disorders the values
  $ rttrace --from chain.mcap Apart0.rtc:in
  ! rttrace: /robot/test.host_cxt/Apart0.rtc:in: no such component with connections in the profile of this log: /robot/test.host_cxt/Apart0.rtc
  [3]
  $ rtlog -q -t 0.3 -f ports.mcap Link0.rtc:out
  [0] after 0.3 s
  $ rttrace --from ports.mcap Link0.rtc:out
  ! rttrace: ports.mcap: no profile of the system is in this log: record it with rtlog record --events PATH
  [1]

What stops it; rtdoctor has the last word:

  $ rtdeact --wait 2 Link2.rtc
  $ rttrace -t 2 Link0.rtc:out
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active      50 Hz * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link1.rtc:out (glob)
  Inactive    50 Hz * 0* no * replaces * /robot/test.host_cxt/Link2.rtc:out (glob)
  Active      50 Hz                                                                    replaces  /robot/test.host_cxt/Link3.rtc
  /robot/test.host_cxt/Link2.rtc: it is Inactive (certain)
    rtdoctor: try: rtact /robot/test.host_cxt/Link2.rtc
  [1] after 2.1 s
  $ rttrace -t 2 --json Link0.rtc:out
  …
  {"buffer": "replaces", "context": 50.0, "delay": null, "stage": "/robot/test.host_cxt/Link3.rtc", "state": "Active"}
  {"culprit": "/robot/test.host_cxt/Link2.rtc", "sure": "certain", "why": "it is Inactive"}
  [1] after 2.1 s
  $ rtec Link2.rtc stop
  $ rttrace -t 2 Link0.rtc:out
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active      50 Hz * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link1.rtc:out (glob)
  Inactive  stopped * 0* no * replaces * /robot/test.host_cxt/Link2.rtc:out (glob)
  Active      50 Hz                                                                    replaces  /robot/test.host_cxt/Link3.rtc
  /robot/test.host_cxt/Link2.rtc: its execution context is stopped (certain)
    rtdoctor: fail  /robot/test.host_cxt/Link2.rtc: its execution context is stopped: nothing executes it; try: rtec /robot/test.host_cxt/Link2.rtc start
  [1] after 2.1 s
  $ rttrace -t 2 --plot Link1.rtc:out
  …
  /robot/test.host_cxt/Link2.rtc:out, values per second
  ⠤⠤ rate  min 0  max 0  last 0
  …
  /robot/test.host_cxt/Link2.rtc: its execution context is stopped (certain)
    rtdoctor: fail  /robot/test.host_cxt/Link2.rtc: its execution context is stopped: nothing executes it; try: rtec /robot/test.host_cxt/Link2.rtc start
  [1] after 2.1 s
  $ rtec Link2.rtc start
  $ rtact --wait 2 Link2.rtc
  [0] after 0.1 s
  $ rtcon Link2.rtc:out Apart0.rtc:in
  $ hang these
  $ rttrace -t 8 Link0.rtc:out
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active      50 Hz * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link1.rtc:out (glob)
  ?         /robot/test.host_cxt/Link2.rtc: it waits for /robot/test.host_cxt/Apart0.rtc, which does not answer
  ?         /robot/test.host_cxt/Apart0.rtc: it does not answer
  /robot/test.host_cxt/Apart0.rtc: it does not answer (certain)
    rtdoctor: fail  /robot/test.host_cxt/Apart0.rtc: hung: 10.0.0.1:$PORT accepts TCP, but no answer within 3s; try: restart it; netstat -ltnp | grep :$PORT there names its process
  [1] after 11.3 s
  $ wake these
  $ rtdis Link1.rtc:out Link2.rtc:in
  $ rttrace -t 2 Link0.rtc:out --to Link3.rtc:in
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active      50 Hz * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link1.rtc:out (glob)
  /robot/test.host_cxt/Link1.rtc: no connection leads on from it to /robot/test.host_cxt/Link2.rtc (certain)
  [1] after 2.0 s
  $ rtdis Link2.rtc:out Apart0.rtc:in
  $ rttrace -t 2 Link0.rtc:out --to Apart0.rtc:in
  STATE     CONTEXT  VALUES        HZ       AGE    NEWEST    JITTER     DELAY  CHANGE  BUFFER    PORT
  Active      50 Hz * 50* yes * - * /robot/test.host_cxt/Link0.rtc:out (glob)
  Active      50 Hz * 50* yes * replaces * /robot/test.host_cxt/Link1.rtc:out (glob)
  /robot/test.host_cxt/Link1.rtc: no connection leads on from it to /robot/test.host_cxt/Apart0.rtc (certain)
  [1] after 2.0 s
