rtcheck compares a running system with an RtsProfile. It says nothing when they agree.

server: composites
world: linked
world: services
world: these ConsoleOut:ConsoleOut1 Motor Hokuyo_AIST
world: composite --nameserver localhost:$PORT2

Save a system, with service connections, a connection of three ends, and configuration; then look at it:

  $ rtcon -i service MyServiceConsumer0.rtc:MyService MyServiceProvider0.rtc:MyService
  $ rtdis ConsoleIn0.rtc; rtcon -i three -p x=y ConsoleIn0.rtc:out ConsoleOut0.rtc:in ConsoleOut1.rtc:in
  $ rtcryo --all -o a.xml; rtcryo --all -y -o a.yaml
  $ rtcheck -s Inactive a.xml; rtcheck --state=inactive < a.yaml
  $ rtcheck -x -s Inactive - < a.xml
  $ rtcheck -y -s Inactive a.yaml

Without a file it reads standard input, and says so on a terminal, unless that is not wanted:

  $ printf '\004' | terminal 80 rtcheck
  rtcheck: reading an RtsProfile from standard input; Ctrl-D ends it
  rtcheck: -:1:1: the file is empty
  [1]
  $ printf '\004' | terminal 80 rtcheck -q
  rtcheck: -:1:1: the file is empty
  [1]

States are to be Active unless you say otherwise:

  $ rtcheck a.xml
  Component /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc is in incorrect state Inactive, not Active
  Component /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc is in incorrect state Inactive, not Active
  Component /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc is in incorrect state Inactive, not Active
  Component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc is in incorrect state Inactive, not Active
  Component /localhost:$PORT/test.host_cxt/Motor0.rtc is in incorrect state Inactive, not Active
  Component /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc is in incorrect state Inactive, not Active
  Component /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc is in incorrect state Inactive, not Active
  rtcheck: all of them are Inactive: -s Inactive compares with that
  [1]
  $ rtact ConsoleIn0.rtc ConsoleOut0.rtc ConsoleOut1.rtc MyServiceConsumer0.rtc MyServiceProvider0.rtc \
  >     Motor0.rtc Hokuyo_AIST0.rtc
  $ rtcheck a.xml
  $ rtcheck -s Error a.xml 2>&1 | head -1
  Component /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc is in incorrect state Active, not Error
  $ rtcheck -s bogus a.xml
  rtcheck: argument -s/--state: no such state: bogus (there are: active, inactive, error, created, unknown) (see --help)
  [2]

Configuration: values in any set, hidden or not, and which set is active:

  $ rtconf Hokuyo_AIST0.rtc set start_angle 9
  $ rtconf -a -s __constraints__ Hokuyo_AIST0.rtc set cluster_count 'x > 2'
  $ rtconf Hokuyo_AIST0.rtc act fast
  $ rtcheck a.xml
  Wrong configuration set is active on /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc (Active set: fast)
  Configuration parameter cluster_count in set __constraints__ on component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc is incorrect (value: x > 2)
  Configuration parameter start_angle in set default on component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc is incorrect (value: 9)
  [1]
  $ sed 's/rts:id="fast"/rts:id="quick"/; s/rts:name="motor_id" rts:data="0"/rts:name="motor" rts:data="0"/' a.xml > b.xml
  $ rtcheck b.xml
  Wrong configuration set is active on /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc (Active set: fast)
  Configuration parameter cluster_count in set __constraints__ on component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc is incorrect (value: x > 2)
  Configuration parameter start_angle in set default on component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc is incorrect (value: 9)
  Invalid configuration set: quick on component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc
  Invalid configuration parameter: motor in set default on component /localhost:$PORT/test.host_cxt/Motor0.rtc
  [1]
  $ rtconf Hokuyo_AIST0.rtc set start_angle -0.5; rtconf Hokuyo_AIST0.rtc act default
  $ rtconf Hokuyo_AIST0.rtc set start_angle -1.57
  $ rtconf -a -s __constraints__ Hokuyo_AIST0.rtc set cluster_count 'x >= 1'
  $ rtcheck a.xml

Connections, of both kinds, with all their ends and all their properties:

  $ sed 's/dataflowType="push"/dataflowType="pull"/; s/rtsExt:name="x" rtsExt:value="y"/rtsExt:name="x" rtsExt:value="z"/' a.xml |
  > rtcheck
  Property dataport.dataflow_type of connection from /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in is incorrect.
  Property x of connection from /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in is incorrect.
  [1]
  $ rtdis ConsoleIn0.rtc; rtdis MyServiceConsumer0.rtc
  $ rtcheck a.xml
  No connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in and /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in
  No connection between /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService and /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService
  [1]
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in; rtcheck --json a.xml
  {"actual": "$UUID", "check": "connection", "expected": "three", "message": "No connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in and /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in", "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in and /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in", "required": true}
  {"actual": null, "check": "connection", "expected": "service", "message": "No connection between /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService and /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService", "path": "/localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService and /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService", "required": true}
  [1]
  $ rtdis ConsoleIn0.rtc; rtcon -i three -p x=y ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ sed '/<rtsExt:FurtherEnds/,/<.rtsExt:FurtherEnds/d' a.xml > two.xml
  $ sed 's/ConsoleOut1.in/ConsoleOut1.gone/' a.xml | rtcheck
  Destination port missing: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:gone
  No connection between /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService and /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService
  [1]
  $ rtcon -i service MyServiceConsumer0.rtc:MyService MyServiceProvider0.rtc:MyService

Components: missing ones, other ones. What is not required is reported, and does not count:

  $ rtdis ConsoleIn0.rtc
  $ rtcon -i three -p x=y ConsoleIn0.rtc:out ConsoleOut0.rtc:in ConsoleOut1.rtc:in
  $ rtcheck a.xml
  $ rtcheck two.xml
  Connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in has 3 ends, not 2
  [1]
  $ sed 's/ConsoleIn:1.0/ConsoleIn:1.1/' a.xml | rtcheck
  Component IDs mismatched: RTC:Shinji Kurihara:example:ConsoleIn:1.0 != RTC:Shinji Kurihara:example:ConsoleIn:1.1
  [1]
  $ sed 's/instanceName="Motor0"/instanceName="Motor1"/' a.xml | rtcheck
  Component instance names mismatched: Motor0 != Motor1
  [1]
  $ rtexit --wait=60 ConsoleOut1.rtc; rtcheck a.xml
  Required component missing: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  [1]
  $ sed 's/isRequired="true"/isRequired="false"/' a.xml > optional.xml; rtcheck optional.xml
  Action failed: Optional component missing: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  $ rtcheck --json optional.xml
  {"actual": null, "check": "component", "expected": "/localhost:$PORT/test.host_cxt/ConsoleOut1.rtc", "message": "Optional component missing: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc", "path": "/localhost:$PORT/test.host_cxt/ConsoleOut1.rtc", "required": false}

--verbose reports every check, --dry-run does so without asking anyone:

  $ rtcheck -v optional.xml 2>&1 | grep -v -e configuration -e parameter
  rtcheck: Checking for optional component /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc with ID "RTC:Shinji Kurihara:example:ConsoleIn:1.0" and instance name "ConsoleIn0"
  rtcheck: Checking for optional component /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc with ID "RTC:Shinji Kurihara:example:ConsoleOut:1.0" and instance name "ConsoleOut0"
  rtcheck: Checking for optional component /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc with ID "RTC:Shinji Kurihara:example:ConsoleOut:1.0" and instance name "ConsoleOut1"
  rtcheck: Checking for optional component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc with ID "RTC:Geoffrey Biggs, AIST:Sensor:Hokuyo_AIST:1.0" and instance name "Hokuyo_AIST0"
  rtcheck: Checking for optional component /localhost:$PORT/test.host_cxt/Motor0.rtc with ID "RTC:Shinji Kurihara, AIST:example:Motor:1.0" and instance name "Motor0"
  rtcheck: Checking for optional component /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc with ID "RTC:Shinji Kurihara:example:MyServiceConsumer:1.0" and instance name "MyServiceConsumer0"
  rtcheck: Checking for optional component /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc with ID "RTC:Shinji Kurihara:example:MyServiceProvider:1.0" and instance name "MyServiceProvider0"
  rtcheck: Checking for connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in and /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in
  rtcheck: Checking for connection between /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService and /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService
  rtcheck: Checking for set "default" on component "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc"
  rtcheck: Checking for set "default" on component "/localhost:$PORT/test.host_cxt/ConsoleOut0.rtc"
  rtcheck: Checking for set "default" on component "/localhost:$PORT/test.host_cxt/ConsoleOut1.rtc"
  rtcheck: Checking for set "default" on component "/localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc"
  rtcheck: Checking for set "default" on component "/localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc"
  rtcheck: Checking state is Active for /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc in execution context 0
  rtcheck: Checking state is Active for /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc in execution context 0
  rtcheck: Checking state is Active for /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc in execution context 0
  rtcheck: Checking state is Active for /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0
  rtcheck: Checking state is Active for /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0
  rtcheck: Checking state is Active for /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc in execution context 0
  rtcheck: Checking state is Active for /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc in execution context 0
  Action failed: Optional component missing: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  $ ctl reset; rtcheck --dry-run a.xml
  Check for required component "RTC:Shinji Kurihara:example:ConsoleIn:1.0", "ConsoleIn0" at path /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc (Required)
  Check for required component "RTC:Shinji Kurihara:example:ConsoleOut:1.0", "ConsoleOut0" at path /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc (Required)
  Check for required component "RTC:Shinji Kurihara:example:ConsoleOut:1.0", "ConsoleOut1" at path /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc (Required)
  Check for required component "RTC:Geoffrey Biggs, AIST:Sensor:Hokuyo_AIST:1.0", "Hokuyo_AIST0" at path /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc (Required)
  Check for required component "RTC:Shinji Kurihara, AIST:example:Motor:1.0", "Motor0" at path /localhost:$PORT/test.host_cxt/Motor0.rtc (Required)
  Check for required component "RTC:Shinji Kurihara:example:MyServiceConsumer:1.0", "MyServiceConsumer0" at path /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc (Required)
  Check for required component "RTC:Shinji Kurihara:example:MyServiceProvider:1.0", "MyServiceProvider0" at path /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc (Required)
  Check for connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in and /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in (Required)
  Check for connection between /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService and /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService (Required)
  Check configuration set "default" is active on component /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc (Required)
  Check for set "default" on component "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc" (Required)
  Check configuration set "default" is active on component /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc (Required)
  Check for set "default" on component "/localhost:$PORT/test.host_cxt/ConsoleOut0.rtc" (Required)
  Check configuration set "default" is active on component /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc (Required)
  Check for set "default" on component "/localhost:$PORT/test.host_cxt/ConsoleOut1.rtc" (Required)
  Check configuration set "default" is active on component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc (Required)
  Check parameter "cluster_count" in set "__constraints__" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "x >= 1" (Required)
  Check parameter "high_sens" in set "__constraints__" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "(0,1)" (Required)
  Check parameter "port_opts" in set "default" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "type=serial,device=/dev/ttyACM0,timeout=1" (Required)
  Check parameter "start_angle" in set "default" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "-1.57" (Required)
  Check parameter "end_angle" in set "default" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "1.57" (Required)
  Check parameter "cluster_count" in set "default" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "1" (Required)
  Check parameter "high_sens" in set "default" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "0" (Required)
  Check parameter "port_opts" in set "fast" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "type=serial,device=/dev/ttyACM0,timeout=1" (Required)
  Check parameter "start_angle" in set "fast" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "-0.5" (Required)
  Check parameter "end_angle" in set "fast" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "0.5" (Required)
  Check parameter "cluster_count" in set "fast" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "4" (Required)
  Check parameter "high_sens" in set "fast" on component "/localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc" is "0" (Required)
  Check configuration set "default" is active on component /localhost:$PORT/test.host_cxt/Motor0.rtc (Required)
  Check parameter "motor_id" in set "__type__" on component "/localhost:$PORT/test.host_cxt/Motor0.rtc" is "int" (Required)
  Check parameter "motor_id" in set "__widget__" on component "/localhost:$PORT/test.host_cxt/Motor0.rtc" is "text" (Required)
  Check parameter "motor_id" in set "default" on component "/localhost:$PORT/test.host_cxt/Motor0.rtc" is "0" (Required)
  Check configuration set "default" is active on component /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc (Required)
  Check for set "default" on component "/localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc" (Required)
  Check configuration set "default" is active on component /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc (Required)
  Check for set "default" on component "/localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc" (Required)
  Check state is Active for /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc in execution context 0 (Required)
  Check state is Active for /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc in execution context 0 (Required)
  Check state is Active for /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc in execution context 0 (Required)
  Check state is Active for /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc in execution context 0 (Required)
  Check state is Active for /localhost:$PORT/test.host_cxt/Motor0.rtc in execution context 0 (Required)
  Check state is Active for /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc in execution context 0 (Required)
  Check state is Active for /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc in execution context 0 (Required)
  $ calls

Composites and their members:

  $ rtcryo --all localhost:$PORT2 -o c.xml; rtcheck -s Inactive c.xml
  $ rtcomp -r /localhost:$PORT2/test.host_cxt/Motor0.rtc /localhost:$PORT2/test.host_cxt/composite0.rtc
  $ rtcheck -s inactive c.xml
  Configuration parameter exported_ports in set default on component /localhost:$PORT2/test.host_cxt/composite0.rtc is incorrect (value: Sensor0.in)
  Component /localhost:$PORT2/test.host_cxt/Motor0.rtc is not a member of /localhost:$PORT2/test.host_cxt/composite0.rtc
  [1]
  $ rtcomp -a /localhost:$PORT2/test.host_cxt/Motor0.rtc /localhost:$PORT2/test.host_cxt/composite0.rtc

The context of the composite counts, not those of its members, which are stopped:

  $ rtcryo --all -q localhost:$PORT2 -o c.xml; rtact --wait=30 /localhost:$PORT2/test.host_cxt/composite0.rtc
  $ soon '[ $(rtfind /localhost:$PORT2 --state active -t c | wc -l) = 4 ]'
  $ rtcheck c.xml

What cannot be asked is reported once, and is no difference:

  $ hang linked; within 4-12 rtcheck --timeout 4 a.xml
  rtcheck: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no answer within 4s
  rtcheck: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no answer within 4s
  Required component missing: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  [5]
  $ wake linked; kill-mock linked
  $ rtcheck a.xml
  Required component missing: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  Required component missing: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  Required component missing: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  [1]
  $ RTCTREE_NAMESERVERS=localhost:1; sed "s/localhost:$PORT/localhost:1/" a.xml | rtcheck --timeout 10
  rtcheck: /localhost:1: connection refused; is the name server running?
  [4]

Files that are not profiles:

  $ rtcheck nofile
  rtcheck: nofile: No such file or directory
  [1]
  $ echo '<a/>' > bad.xml; rtcheck bad.xml
  rtcheck: bad.xml:1:1: not an RtsProfile: its root element is "a"
  [1]
  $ rtcheck
  rtcheck: -:1:1: the file is empty
  [1]
  $ rtcheck -y a.xml
  rtcheck: a.xml:1:1: not an RtsProfile: the key rtsProfile is missing
  [1]
  $ rtcheck a.xml b.xml
  rtcheck: unrecognized arguments: b.xml (see --help)
  [2]

What the components have beyond the file is reported with --extra:

  $ mock robot; rtdeact --wait MyServiceConsumer0.rtc MyServiceProvider0.rtc
  $ rtcryo -o r.xml /localhost:$PORT
  rtcryo: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: zombie, left out
  rtcryo: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: zombie, left out
  $ rtcheck --extra -s Inactive r.xml
  $ rtcon -i less Sensor0.rtc:out Motor0.rtc:in
  $ sed '/ConfigurationSets rts:id="fast"/,/<.rts:ConfigurationSets>/d; /rts:name="motor_id" rts:data="0"/d' r.xml > less.xml
  $ rtcheck -s Inactive less.xml
  $ rtcheck --extra -s Inactive less.xml
  Configuration set not in the file: fast on component /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc
  Connection not in the file: less between /localhost:$PORT/test.host_cxt/Sensor0.rtc:out and /localhost:$PORT/test.host_cxt/Motor0.rtc:in
  Configuration parameter not in the file: motor_id in set default on component /localhost:$PORT/test.host_cxt/Motor0.rtc
  [1]
  $ rtexit --wait=60 MyServiceConsumer0.rtc; rtcryo --all -q -o all.xml /localhost:$PORT
  $ rtcheck --extra -s Inactive all.xml
  $ sed '/pathUri="[^"]*MyServiceProvider0.rtc"/,/<.rts:Components>/d' all.xml > one.xml
  $ mock hung 1 --context hung.host_cxt/%n.rtc; rtcheck -s Inactive one.xml
  $ rtcheck --extra --timeout 4 -s Inactive one.xml
  rtcheck: /localhost:$PORT/hung.host_cxt/Mock0.rtc: no answer within 4s
  Component not in the file: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc
  [5]
  $ rtcheck --extra --json -s Inactive less.xml 2> said | tail -2
  {"actual": "less", "check": "connection", "expected": null, "message": "Connection not in the file: less between /localhost:$PORT/test.host_cxt/Sensor0.rtc:out and /localhost:$PORT/test.host_cxt/Motor0.rtc:in", "path": "/localhost:$PORT/test.host_cxt/Sensor0.rtc:out and /localhost:$PORT/test.host_cxt/Motor0.rtc:in", "required": true}
  {"actual": "0", "check": "configuration", "expected": null, "message": "Configuration parameter not in the file: motor_id in set default on component /localhost:$PORT/test.host_cxt/Motor0.rtc", "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "required": true}

Paths are written as commands take them:

  $ sed 's,/ConsoleIn0.rtc",/Con\\/sole\\.In.rtc",' a.xml | rtcheck --dry-run | head -1
  Check for required component "RTC:Shinji Kurihara:example:ConsoleIn:1.0", "ConsoleIn0" at path /localhost:$PORT/test.host_cxt/Con\/sole.In.rtc (Required)

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: FILE
invocation: --extra --json FILE
looking: -s Inactive FILE
broken component: 1 5
prepared: rtresurrect robot.rtsys && rtstart -q robot.rtsys >/dev/null
example: rtcheck -s Inactive robot.rtsys <- rtstop -q robot.rtsys >/dev/null
example: rtcheck --extra robot.rtsys -> 1
