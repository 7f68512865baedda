rtstart activates the components of an RtsProfile, in the order that its Activation section gives.

world: robot
world: error
world: these ConsoleIn ConsoleOut

  $ rtexit --wait Err0.rtc
Without that section, all start at once. What is Active already counts as done:

  $ rtcryo -o a.xml; rtcryo -y -o a.yaml
  rtcryo: 4 components without connections left out; --all saves them, too
  rtcryo: 4 components without connections left out; --all saves them, too
  $ states() { rtls -l | awk '{print $1, $6}'; }
  $ rtstart a.xml 2> said; sort said
  Executing {1} Activate /localhost:$PORT/test.host_cxt/Clusterer0.rtc in execution context 0 (Required)
  Executing {2} Activate /localhost:$PORT/test.host_cxt/Controller0.rtc in execution context 0 (Required)
  Executing {3} Activate /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0 (Required)
  Executing {4} Activate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0 (Required)
  Executing {5} Activate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0 (Required)
  $ states
  Error Broken0.rtc
  Active Clusterer0.rtc
  Inactive ConsoleIn0.rtc
  Inactive ConsoleOut0.rtc
  Active Controller0.rtc
  Inactive ErrStart0.rtc
  Active Hokuyo_AIST0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  $ rtdeact --wait Motor0.rtc; rtstart -v a.yaml 2>&1 | sort
  Executing {1} Activate /localhost:$PORT/test.host_cxt/Clusterer0.rtc in execution context 0 (Required)
  Executing {2} Activate /localhost:$PORT/test.host_cxt/Controller0.rtc in execution context 0 (Required)
  Executing {3} Activate /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0 (Required)
  Executing {4} Activate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0 (Required)
  Executing {5} Activate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0 (Required)
  rtstart: /localhost:$PORT/test.host_cxt/Clusterer0.rtc: already Active
  rtstart: /localhost:$PORT/test.host_cxt/Controller0.rtc: already Active
  rtstart: /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc: already Active
  rtstart: /localhost:$PORT/test.host_cxt/Motor0.rtc: Active
  rtstart: /localhost:$PORT/test.host_cxt/Sensor0.rtc: already Active
  rtstart: Checking for required component /localhost:$PORT/test.host_cxt/Clusterer0.rtc with ID "RTC:Geoffrey Biggs, AIST:Perception:Clusterer:2.1" and instance name "Clusterer0"
  rtstart: Checking for required component /localhost:$PORT/test.host_cxt/Controller0.rtc with ID "RTC:Shinji Kurihara, AIST:example:Controller:1.0" and instance name "Controller0"
  rtstart: Checking for required component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc with ID "RTC:Geoffrey Biggs, AIST:Sensor:Hokuyo_AIST:1.0" and instance name "Hokuyo_AIST0"
  rtstart: Checking for required component /localhost:$PORT/test.host_cxt/Motor0.rtc with ID "RTC:Shinji Kurihara, AIST:example:Motor:1.0" and instance name "Motor0"
  rtstart: Checking for required component /localhost:$PORT/test.host_cxt/Sensor0.rtc with ID "RTC:Shinji Kurihara, AIST:example:Sensor:1.0" and instance name "Sensor0"
  $ rtstart -q -x - < a.xml; rtstart -q -y a.yaml
  $ rtstart --json -q --wait 1 a.xml | sort
  {"action": "activate", "context": "0", "error": null, "number": 1, "path": "/localhost:$PORT/test.host_cxt/Clusterer0.rtc", "required": true, "result": "already"}
  {"action": "activate", "context": "0", "error": null, "number": 2, "path": "/localhost:$PORT/test.host_cxt/Controller0.rtc", "required": true, "result": "already"}
  {"action": "activate", "context": "0", "error": null, "number": 3, "path": "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc", "required": true, "result": "already"}
  {"action": "activate", "context": "0", "error": null, "number": 4, "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "required": true, "result": "already"}
  {"action": "activate", "context": "0", "error": null, "number": 5, "path": "/localhost:$PORT/test.host_cxt/Sensor0.rtc", "required": true, "result": "already"}
  $ rtstop -q a.xml; ctl reset
  $ rtstart --dry-run a.xml
  Check for required component "RTC:Geoffrey Biggs, AIST:Perception:Clusterer:2.1", "Clusterer0" at path /localhost:$PORT/test.host_cxt/Clusterer0.rtc (Required)
  Check for required component "RTC:Shinji Kurihara, AIST:example:Controller:1.0", "Controller0" at path /localhost:$PORT/test.host_cxt/Controller0.rtc (Required)
  Check for required component "RTC:Geoffrey Biggs, AIST:Sensor:Hokuyo_AIST:1.0", "Hokuyo_AIST0" at path /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc (Required)
  Check for required component "RTC:Shinji Kurihara, AIST:example:Motor:1.0", "Motor0" at path /localhost:$PORT/test.host_cxt/Motor0.rtc (Required)
  Check for required component "RTC:Shinji Kurihara, AIST:example:Sensor:1.0", "Sensor0" at path /localhost:$PORT/test.host_cxt/Sensor0.rtc (Required)
  {1} Activate /localhost:$PORT/test.host_cxt/Clusterer0.rtc in execution context 0 (Required)
  {2} Activate /localhost:$PORT/test.host_cxt/Controller0.rtc in execution context 0 (Required)
  {3} Activate /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0 (Required)
  {4} Activate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0 (Required)
  {5} Activate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0 (Required)
  $ calls

Conditions: Motor0 comes first; 0.3 s after the others comes Clusterer0, when it is active comes Hokuyo_AIST0:

  $ plan $(when 1 Motor0) $(when 2 Sensor0) $(when 3 Clusterer0 "$(waiting 300)") \
  >     $(when 4 Hokuyo_AIST0 "$(preceding SYNC 2000 Clusterer0)") \
  >     $(when 5 Controller0 "$(preceding ASYNC 0 Clusterer0)") < a.xml > b.xml
  $ rtstart --dry-run b.xml | tail -5
  {4} [Order 1] Activate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0 (Required)
  {5} [Order 2] Activate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0 (Required)
  {1} [Order 3/Wait 300ms] Activate /localhost:$PORT/test.host_cxt/Clusterer0.rtc in execution context 0 (Required)
  {3} [Order 4/Sync to Clusterer0] Activate /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0 (Required)
  {2} [Order 5/After Clusterer0's action] Activate /localhost:$PORT/test.host_cxt/Controller0.rtc in execution context 0 (Required)
  $ within 0.3-9 rtstart -v b.xml 2> said; grep -v Check said | head -4
  Executing {4} Activate /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0 (Required)
  rtstart: /localhost:$PORT/test.host_cxt/Motor0.rtc: Active
  Executing {5} Activate /localhost:$PORT/test.host_cxt/Sensor0.rtc in execution context 0 (Required)
  rtstart: /localhost:$PORT/test.host_cxt/Sensor0.rtc: Active
  $ grep -c Active said
  5
  $ states
  Error Broken0.rtc
  Active Clusterer0.rtc
  Inactive ConsoleIn0.rtc
  Inactive ConsoleOut0.rtc
  Active Controller0.rtc
  Inactive ErrStart0.rtc
  Active Hokuyo_AIST0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  $ rtstop -q b.xml
  $ plan $(when 1 Clusterer0 "$(waiting 600)") $(when 1 Motor0 "$(preceding SYNC 100 Clusterer0)") \
  >     $(when 1 Sensor0 "$(preceding '' 0 Motor0)") < a.xml > late.xml
  $ rtstart -q late.xml
  rtstart: /localhost:$PORT/test.host_cxt/Motor0.rtc: not tried: Sync to Clusterer0: not Active within 100ms
  rtstart: /localhost:$PORT/test.host_cxt/Sensor0.rtc: not tried: it waits for /localhost:$PORT/test.host_cxt/Motor0.rtc, which was not tried
  [5]
  $ states | grep Inactive
  Inactive ConsoleIn0.rtc
  Inactive ConsoleOut0.rtc
  Inactive ErrStart0.rtc
  Inactive Motor0.rtc
  Inactive Sensor0.rtc
  $ rtstop -q a.xml; rtstart --json -q late.xml 2> said | grep -v null
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Motor0.rtc: not tried: Sync to Clusterer0: not Active within 100ms", "number": 4, "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Sensor0.rtc: not tried: it waits for /localhost:$PORT/test.host_cxt/Motor0.rtc, which was not tried", "number": 5, "path": "/localhost:$PORT/test.host_cxt/Sensor0.rtc", "required": true, "result": "not tried"}

What is wrong with a plan is found before anything is asked:

  $ rtstop -q a.xml; ctl reset
  $ plan $(when 1 Motor0 "$(preceding SYNC 0 Sensor0)") $(when 1 Sensor0 "$(preceding ASYNC 0 Motor0)") \
  >     < a.xml |
  > rtstart
  rtstart: -: Activation: these wait for each other: /localhost:$PORT/test.host_cxt/Motor0.rtc for /localhost:$PORT/test.host_cxt/Sensor0.rtc for /localhost:$PORT/test.host_cxt/Motor0.rtc
  [1]
  $ plan $(when 1 Ghost0) $(when 2 Motor0) $(when 3 Motor0) < a.xml | rtstart
  rtstart: -: Activation: Ghost0 (Ghost0) is not in the file; /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0: Order 2 contradicts Order 3
  [1]
  $ plan $(when 1 Motor0) $(when 1 Motor0) < a.xml | rtstart --dry-run 2>&1 | head -1
  rtstart: /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0 has a condition twice: Order 1
  $ calls

Nothing starts unless every required component is there and the one that is meant; of others it is reported:

  $ sed 's/Motor0.rtc/Gone0.rtc/; s/instanceName="Sensor0"/instanceName="Sensor1"/; s/:Clusterer:2.1/:Clusterer:2.0/' a.xml |
  > rtstart
  rtstart: /localhost:$PORT/test.host_cxt/Clusterer0.rtc: not a RTC:Geoffrey Biggs, AIST:Perception:Clusterer:2.0 (it is a RTC:Geoffrey Biggs, AIST:Perception:Clusterer:2.1)
  rtstart: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  rtstart: /localhost:$PORT/test.host_cxt/Sensor0.rtc: not a component named Sensor1 (it is a component named Sensor0)
  [3]
  $ sed 's/Motor0.rtc/Gone0.rtc/' a.xml > gone.xml; rtstart --wait 15 gone.xml
  rtstart: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  rtstart: to wait for what is absent: rtkeep --once --within 15 gone.xml
  [3]
  $ sed 's/Motor0.rtc/Gone0.rtc/' a.xml | rtstart --json | tail -2
  rtstart: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Gone0.rtc: no such path", "number": 4, "path": "/localhost:$PORT/test.host_cxt/Gone0.rtc", "required": true, "result": "failed"}
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Sensor0.rtc: not tried: something that is required failed", "number": 5, "path": "/localhost:$PORT/test.host_cxt/Sensor0.rtc", "required": true, "result": "not tried"}
  $ sed 's/rts:id="0" rts:kind/rts:id="7" rts:kind/' a.xml | rtstart 2>&1 | head -1
  rtstart: /localhost:$PORT/test.host_cxt/Clusterer0.rtc: no such execution context: 7 (it has 0)
  $ states | grep -c Inactive
  8
  $ sed 's/Motor0.rtc/Gone0.rtc/; s/isRequired="true"/isRequired="false"/' b.xml > optional.xml
  $ rtstart optional.xml 2>&1 | grep -v Executing
  Action failed: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  $ rtstart -q optional.xml
  Action failed: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  $ sed 's/Motor0.rtc/Gone0.rtc/; /Motor0.rtc/s/isRequired="true"/isRequired="false"/; /instanceName="Motor0"/s/isRequired="true"/isRequired="false"/' b.xml |
  > rtstart --json -q | grep Gone0
  Action failed: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  {"action": "activate", "context": "0", "error": "/localhost:$PORT/test.host_cxt/Gone0.rtc: no such path", "number": 5, "path": "/localhost:$PORT/test.host_cxt/Gone0.rtc", "required": false, "result": "failed"}
  $ rtstop -q a.xml

A component that fails stops what depends on it, and nothing else:

  $ rtcryo --all -o e.xml
  $ rtstart e.xml 2>&1 | grep -v Executing | sort
  rtstart: /localhost:$PORT/test.host_cxt/Broken0.rtc: cannot activate: it is in Error; reset it first
  rtstart: /localhost:$PORT/test.host_cxt/ErrStart0.rtc: cannot activate: it went to Error
  $ rtstop -q a.xml; rtdeact ConsoleIn0.rtc ConsoleOut0.rtc
  $ rtreset ErrStart0.rtc Broken0.rtc
  $ plan $(when 1 ErrStart0) $(when 2 Motor0) $(when 1 Sensor0 "$(preceding ASYNC 0 Motor0)") \
  >     $(when 1 Controller0 "$(waiting 1)") < e.xml > f.xml
  $ rtstart -q f.xml
  rtstart: /localhost:$PORT/test.host_cxt/ErrStart0.rtc: cannot activate: it went to Error
  rtstart: /localhost:$PORT/test.host_cxt/Motor0.rtc: not tried: it comes after /localhost:$PORT/test.host_cxt/ErrStart0.rtc, which failed
  rtstart: /localhost:$PORT/test.host_cxt/Sensor0.rtc: not tried: it waits for /localhost:$PORT/test.host_cxt/Motor0.rtc, which was not tried
  [5]
  $ states
  Active Broken0.rtc
  Active Clusterer0.rtc
  Active ConsoleIn0.rtc
  Active ConsoleOut0.rtc
  Active Controller0.rtc
  Error ErrStart0.rtc
  Active Hokuyo_AIST0.rtc
  Inactive Motor0.rtc
  Inactive Sensor0.rtc

Files that are not profiles:

  $ rtstart nofile
  rtstart: nofile: No such file or directory
  [1]
  $ echo '<a/>' | rtstart
  rtstart: -:1:1: not an RtsProfile: its root element is "a"
  [1]
  $ rtstart
  rtstart: -:1:1: the file is empty
  [1]
  $ rtstart -y a.xml
  rtstart: a.xml:1:1: not an RtsProfile: the key rtsProfile is missing
  [1]
  $ rtstart a.xml b.xml
  rtstart: unrecognized arguments: b.xml (see --help)
  [2]
  $ rtstart --wait 0 a.xml
  rtstart: argument --wait: not a number of seconds above 0: 0 (see --help)
  [2]
  $ echo '<rts:RtsProfile xmlns:rts="http://www.openrtp.org/namespaces/rts"/>' | rtstart --dry-run | wc -l
  1

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: FILE
invocation: --json --wait 0.5 FILE
looking: --dry-run FILE
broken component: 5
