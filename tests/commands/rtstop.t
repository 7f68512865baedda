rtstop deactivates the components of an RtsProfile, in the order that its Deactivation section gives.

world: robot
world: composite --context c.host_cxt/%n.rtc --rate 100
world: these ConsoleIn ConsoleOut
world: contexts

  $ states() { rtls -l $1 | awk '$1 ~ /tive/ {print $1, $6}'; }
  $ rtcryo -o a.xml; rtcryo -y -o a.yaml
  rtcryo: 7 components and 1 composite without connections left out; --all saves them, too
  rtcryo: 7 components and 1 composite without connections left out; --all saves them, too
  $ rtstart -q a.xml; rtstop a.xml 2> said
  $ sort said
  Executing {1} Deactivate /localhost:$PORT/test.host_cxt/Clusterer0.rtc in execution context 0
  Executing {2} Deactivate /localhost:$PORT/test.host_cxt/Controller0.rtc in execution context 0
  Executing {3} Deactivate /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0
  Executing {4} Deactivate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0
  Executing {5} Deactivate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0
  $ states
  Inactive Clusterer0.rtc
  Inactive ConsoleIn0.rtc
  Inactive ConsoleOut0.rtc
  Inactive Controller0.rtc
  Inactive Driver0.rtc
  Inactive Hokuyo_AIST0.rtc
  Inactive Motor0.rtc
  Inactive Multi0.rtc
  Inactive Sensor0.rtc
  $ rtstart -q a.xml; rtstop -v -x - < a.xml 2>&1 | sort
  Executing {1} Deactivate /localhost:$PORT/test.host_cxt/Clusterer0.rtc in execution context 0
  Executing {2} Deactivate /localhost:$PORT/test.host_cxt/Controller0.rtc in execution context 0
  Executing {3} Deactivate /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0
  Executing {4} Deactivate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0
  Executing {5} Deactivate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0
  rtstop: /localhost:$PORT/test.host_cxt/Clusterer0.rtc: Inactive
  rtstop: /localhost:$PORT/test.host_cxt/Controller0.rtc: Inactive
  rtstop: /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc: Inactive
  rtstop: /localhost:$PORT/test.host_cxt/Motor0.rtc: Inactive
  rtstop: /localhost:$PORT/test.host_cxt/Sensor0.rtc: Inactive
  $ rtstop -q -y a.yaml; rtstop --json -q a.xml | sort
  {"action": "deactivate", "context": "0", "error": null, "number": 1, "path": "/localhost:$PORT/test.host_cxt/Clusterer0.rtc", "required": true, "result": "already"}
  {"action": "deactivate", "context": "0", "error": null, "number": 2, "path": "/localhost:$PORT/test.host_cxt/Controller0.rtc", "required": true, "result": "already"}
  {"action": "deactivate", "context": "0", "error": null, "number": 3, "path": "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc", "required": true, "result": "already"}
  {"action": "deactivate", "context": "0", "error": null, "number": 4, "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "required": true, "result": "already"}
  {"action": "deactivate", "context": "0", "error": null, "number": 5, "path": "/localhost:$PORT/test.host_cxt/Sensor0.rtc", "required": true, "result": "already"}
  $ rtstart -q a.xml; ctl reset
  $ rtstop --dry-run a.xml
  {1} Deactivate /localhost:$PORT/test.host_cxt/Clusterer0.rtc in execution context 0
  {2} Deactivate /localhost:$PORT/test.host_cxt/Controller0.rtc in execution context 0
  {3} Deactivate /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0
  {4} Deactivate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0
  {5} Deactivate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0
  $ calls

In order, with timeouts:

  $ plan -d $(when 1 Motor0) $(when 2 Sensor0) $(when 3 Controller0 "$(preceding SYNC 0 Motor0)") \
  >     $(when 3 Clusterer0 "$(preceding '' 0 Motor0)") < a.xml > b.xml
  $ rtstop --dry-run b.xml
  {3} Deactivate /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0
  {4} [Order 1] Deactivate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0
  {5} [Order 2] Deactivate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0
  {1} [Order 3/After Motor0's action] Deactivate /localhost:$PORT/test.host_cxt/Clusterer0.rtc in execution context 0
  {2} [Order 3/Sync to Motor0] Deactivate /localhost:$PORT/test.host_cxt/Controller0.rtc in execution context 0
  $ rtstop b.xml 2> said; tail -4 said | sort
  Executing {1} Deactivate /localhost:$PORT/test.host_cxt/Clusterer0.rtc in execution context 0
  Executing {2} Deactivate /localhost:$PORT/test.host_cxt/Controller0.rtc in execution context 0
  Executing {4} Deactivate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0
  Executing {5} Deactivate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0
  $ states
  Inactive Clusterer0.rtc
  Inactive ConsoleIn0.rtc
  Inactive ConsoleOut0.rtc
  Inactive Controller0.rtc
  Inactive Driver0.rtc
  Inactive Hokuyo_AIST0.rtc
  Inactive Motor0.rtc
  Inactive Multi0.rtc
  Inactive Sensor0.rtc
  $ plan -d $(when 1 Motor0 "$(preceding SYNC 0 Motor0)") < a.xml | rtstop
  rtstop: -: Deactivation: these wait for each other: /localhost:$PORT/test.host_cxt/Motor0.rtc for /localhost:$PORT/test.host_cxt/Motor0.rtc
  [1]

What is gone keeps nothing from being stopped; what fails, only what was to be in sync with it:

  $ rtstart -q a.xml; sed 's/Motor0.rtc/Gone0.rtc/' b.xml > gone.xml
  $ rtstop -q gone.xml
  rtstop: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  [5]
  $ states
  Inactive Clusterer0.rtc
  Inactive ConsoleIn0.rtc
  Inactive ConsoleOut0.rtc
  Inactive Controller0.rtc
  Inactive Driver0.rtc
  Inactive Hokuyo_AIST0.rtc
  Active Motor0.rtc
  Inactive Multi0.rtc
  Inactive Sensor0.rtc
  $ rtstop --json -q gone.xml | grep Gone0
  rtstop: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  {"action": "deactivate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Gone0.rtc: no such path", "number": 4, "path": "/localhost:$PORT/test.host_cxt/Gone0.rtc", "required": true, "result": "gone"}
  $ rtdeact Motor0.rtc; rtstart -q a.xml
  $ ctl error Motor0; rtstop -q b.xml
  rtstop: /localhost:$PORT/test.host_cxt/Motor0.rtc: cannot deactivate: it is in Error; reset it first
  rtstop: /localhost:$PORT/test.host_cxt/Controller0.rtc: not tried: it waits for /localhost:$PORT/test.host_cxt/Motor0.rtc, which failed
  [5]
  $ states
  Inactive Clusterer0.rtc
  Inactive ConsoleIn0.rtc
  Inactive ConsoleOut0.rtc
  Active Controller0.rtc
  Inactive Driver0.rtc
  Inactive Hokuyo_AIST0.rtc
  Inactive Multi0.rtc
  Inactive Sensor0.rtc
  $ rtreset --wait Motor0.rtc; sed 's/isRequired="true"/isRequired="false"/' gone.xml | rtstop -q
  Action failed: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  $ sed 's/rts:id="0" rts:kind/rts:id="7" rts:kind/' a.xml | rtstop -q 2>&1 | sort | head -1
  rtstop: /localhost:$PORT/test.host_cxt/Clusterer0.rtc: no such execution context: 7 (it has 0)

A composite takes its members along, whose own contexts are stopped; several contexts:

  $ rtcryo --all -o c.xml /localhost:$PORT/c.host_cxt
  $ rtstart -q c.xml; states /localhost:$PORT/c.host_cxt
  Active Controller0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  Active composite0.rtc
  $ rtstop -q c.xml; states /localhost:$PORT/c.host_cxt
  Inactive Controller0.rtc
  Inactive Motor0.rtc
  Inactive Sensor0.rtc
  Inactive composite0.rtc
  $ rtcryo --all -o m.xml; rtstart m.xml 2>&1 | grep Multi0
  Executing {12} Activate /localhost:$PORT/test.host_cxt/Multi0.rtc in execution context 0 (Required)
  Executing {13} Activate /localhost:$PORT/test.host_cxt/Multi0.rtc in execution context 1 (Required)
  $ ctl @contexts state Multi0 0
  ACTIVE
  $ ctl @contexts state Multi0 1
  ACTIVE
  $ rtstop -q m.xml; ctl @contexts state Multi0 0
  INACTIVE
  $ ctl @contexts state Multi0 1
  INACTIVE

A process that hangs keeps the others waiting no longer than the timeout:

  $ rtcryo --all -o all.xml; rtstart -q all.xml
  $ hang these
  $ within 1.9-7 rtstop -q --timeout 2 all.xml 2> said
  [5]
  $ sort said; states 2> said
  rtstop: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no answer within 2s
  rtstop: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no answer within 2s
  Inactive Clusterer0.rtc
  Inactive Controller0.rtc
  Inactive Driver0.rtc
  Inactive Hokuyo_AIST0.rtc
  Inactive Motor0.rtc
  Inactive Multi0.rtc
  Inactive Sensor0.rtc
  $ wake these; rtstop -q all.xml

  $ rtstop nofile
  rtstop: nofile: No such file or directory
  [1]
  $ rtstop a.xml b.xml
  rtstop: unrecognized arguments: b.xml (see --help)
  [2]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: FILE
invocation: --json --wait 0.5 FILE
broken component: 5
