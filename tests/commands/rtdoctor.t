rtdoctor examines a system from the outside in and says what is wrong, and what would mend it.

world: robot --rate 10
world: managers --rate 20 --context mgr.host_cxt/%n.rtc
server: another
world: linked --nameserver localhost:$PORT2

  $ doctor() { rtdoctor "$@" > out; code=$?; grep -v -e "this host's name" -e ": slow (" out; return $code; }
  $ rtact --wait Sensor0.rtc Controller0.rtc Motor0.rtc Hokuyo_AIST0.rtc Clusterer0.rtc

A robot that works: a line for each object, a summary, status 0. With -q, nothing is left to say (a busy machine may not keep
a rate for a moment):

  $ soon 'rtdoctor > out; ! grep -e "warn.* keeps" -e ": slow (" out'
  $ grep -v -e "this host's name" -e failed out
  ok    here: Python [0-9.]*, (omniORBpy .*|builtin ORB) (re)
  ok    here: RTCTREE_NAMESERVERS: localhost:$PORT
  ok    /localhost:$PORT: answers (name * ms, TCP * ms, CORBA * ms, naming * ms) (glob)
  ok    /localhost:$PORT/mgr.host_cxt/ConsoleIn0.rtc: Inactive, claims 20 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/mgr.host_cxt/ConsoleOut0.rtc: Inactive, claims 20 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/test.host_cxt/Clusterer0.rtc: Active, claims 10 Hz, 2 ports, 1 connection, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/test.host_cxt/Controller0.rtc: Active, claims 10 Hz, 2 ports, 2 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc: Active, claims 10 Hz, 3 ports, 1 connection, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/test.host_cxt/Motor0.rtc: Active, claims 10 Hz, 2 ports, 2 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/test.host_cxt/Sensor0.rtc: Active, claims 10 Hz, 2 ports, 2 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/mgr.host_cxt/manager.mgr: manager of 2 components, 2 slaves, at 127.0.0.1:* (glob)
  $ rtdoctor | grep -c '^[0-9]* failed, [0-9]* to be looked at, [0-9]* ok$'
  1
  $ doctor -q
  $ doctor -q; rtdoctor -q --measure > out
  $ grep -v -e "this host's name" -e " keeps " -e ": slow (" out
  [1]
  $ rtdoctor -q localhost:$PORT localhost:$PORT2 > out
  $ rtdoctor -q /localhost:$PORT/test.host_cxt/Motor0.rtc > out

It only asks. What is bound twice, or by a manager, too, is asked once:

  $ ctl reset; ctl @managers slave 1 reset
  $ rtdoctor -q > out; ctl calls Motor0
  1 _non_existent
  1 get_component_profile
  1 get_component_state
  1 get_context_handle
  1 get_owned_contexts
  1 get_participating_contexts
  2 get_port_profile
  1 get_ports
  1 get_profile
  1 is_running
  $ ctl @managers slave 1 calls ConsoleIn0
  1 _non_existent
  1 get_component_profile
  1 get_component_state
  1 get_context_handle
  1 get_owned_contexts
  1 get_participating_contexts
  1 get_port_profile
  1 get_ports
  1 get_profile
  1 get_sdo_id
  1 is_running
  $ ctl reset; rtdoctor -q --measure > out
  $ ctl calls Motor0 | grep -v get
  1 _non_existent
  1 connect
  1 disconnect
  1 is_running
  $ test $(ctl highwater) -le 4

A path, several, a name server; relative paths start at the working directory:

  $ doctor Motor0.rtc | grep rtc
  ok    /localhost:$PORT/test.host_cxt/Motor0.rtc: Active, claims 10 Hz, 2 ports, 2 connections, at 127.0.0.1:* (glob)
  $ doctor Motor0.rtc ../mgr.host_cxt localhost:$PORT2 | sed -n 's/^ok  *\/\(.*rtc\|.*mgr\): .*/\1/p' | \
  > sed "s/localhost:$PORT2/other/" | sort
  localhost:$PORT/mgr.host_cxt/ConsoleIn0.rtc
  localhost:$PORT/mgr.host_cxt/ConsoleOut0.rtc
  localhost:$PORT/mgr.host_cxt/manager.mgr
  localhost:$PORT/test.host_cxt/Motor0.rtc
  other/test.host_cxt/ConsoleIn0.rtc
  other/test.host_cxt/ConsoleOut0.rtc
  $ doctor -q nobody.rtc /localhost:$PORT/nowhere.host_cxt/ Moto0.rtc
  fail  /localhost:$PORT/nowhere.host_cxt: no such path; try: see what is there: rtls /localhost:$PORT
  fail  /localhost:$PORT/test.host_cxt/Moto0.rtc: no such path; did you mean Motor0.rtc?; try: see what is there: rtls /localhost:$PORT/test.host_cxt
  fail  /localhost:$PORT/test.host_cxt/nobody.rtc: no such path; try: see what is there: rtls /localhost:$PORT/test.host_cxt
  [1]
  $ RTCSH_CWD= doctor -q localhost | grep -c '^fail  /localhost: '
  1

A word without a dot or a slash is a name server, as is an address, or what is in RTCTREE_NAMESERVERS:

  $ for each in localhost 127.0.0.1 '[::1]' 127.0.0.1:2809 robot.local; do
  > RTCTREE_NAMESERVERS=robot.local rtdoctor -q $each | sed -n 's/^fail  \(\/[^ ]*\): .*/\1/p'; done
  /localhost
  /127.0.0.1
  /[::1]
  /127.0.0.1:2809
  /robot.local
  $ for each in / ../.. '/ Motor0.rtc'; do doctor $each | grep -c 'rtc: Active'; done
  5
  5
  5
  $ doctor -q robot1.local nowhere/ | grep path
  fail  /localhost:$PORT/test.host_cxt/nowhere: no such path; try: see what is there: rtls /localhost:$PORT/test.host_cxt
  fail  /localhost:$PORT/test.host_cxt/robot1.local: no such path; try: see what is there: rtls /localhost:$PORT/test.host_cxt

One JSON object a line, whatever -q leaves:

  $ rtdoctor --json Motor0.rtc | tail -1
  {"cause": "", "check": "component", "level": "ok", "message": "Active, claims 10 Hz, 2 ports, 2 connections, at 127.0.0.1:*", "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "remedy": ""} (glob)
  $ rtdoctor --json -q nobody.rtc | grep nobody
  {"cause": "", "check": "path", "level": "fail", "message": "no such path", "path": "/localhost:$PORT/test.host_cxt/nobody.rtc", "remedy": "see what is there: rtls /localhost:$PORT/test.host_cxt"}
  $ rtdoctor --json | python3 -c 'import json, sys
  > for line in sys.stdin:
  >     each = json.loads(line)
  >     assert sorted(each) == ["cause", "check", "level", "message", "path", "remedy"], each
  >     assert each["level"] in ("ok", "warn", "fail") and bool(each["remedy"]) == (each["level"] != "ok"), each'

On a terminal the levels have colours:

  $ NO_COLOR= terminal 80 rtdoctor -q nobody.rtc | grep nobody
  \x1b[01;37;41mfail\x1b[00m  /localhost:$PORT/test.host_cxt/nobody.rtc: no such path; try: see what is there: rtls /localhost:$PORT/test.host_cxt (esc)

With a profile, all that rtcheck finds:

  $ rtcryo -q -o robot.rtsys localhost:$PORT; doctor -q --profile robot.rtsys
  $ doctor --profile robot.rtsys Motor0.rtc | tail -2 | head -1
  ok    /: as the profile says: 5 components, 4 connections
  $ rtconf Motor0.rtc set motor_id 7; rtdis Sensor0.rtc:out
  $ rtdeact --wait Clusterer0.rtc
  $ doctor -q --profile robot.rtsys
  fail  /localhost:$PORT/test.host_cxt/Sensor0.rtc:out and /localhost:$PORT/test.host_cxt/Controller0.rtc:in: No connection; try: rtresurrect robot.rtsys
  fail  /localhost:$PORT/test.host_cxt/Motor0.rtc: Configuration parameter motor_id in set default is incorrect (value: 7); try: rtresurrect robot.rtsys
  fail  /localhost:$PORT/test.host_cxt/Clusterer0.rtc: incorrect state Inactive, not Active; try: rtact /localhost:$PORT/test.host_cxt/Clusterer0.rtc
  [1]
  $ sed 's/Motor0/Motor1/g; s/isRequired="true"/isRequired="false"/' robot.rtsys > optional.xml
  $ doctor -q --profile optional.xml | grep Motor1
  warn  /localhost:$PORT/test.host_cxt/Motor1.rtc: Optional component missing; try: start it, or have its manager make it: rtresurrect --create optional.xml
  $ rtec Motor0.rtc rate 20; doctor -q --profile robot.rtsys | grep Hz
  fail  /localhost:$PORT/test.host_cxt/Motor0.rtc: its execution context has a rate of 20 Hz, in the file it is 10 Hz; try: rtec /localhost:$PORT/test.host_cxt/Motor0.rtc rate 10
  $ rtec Motor0.rtc rate 10
  $ doctor -q -s Inactive --profile robot.rtsys | grep -c 'incorrect state'
  4
  $ doctor --profile nofile
  rtdoctor: nofile: No such file or directory
  [1]
  $ echo '<a/>' > bad.xml; rtdoctor --profile bad.xml
  rtdoctor: bad.xml:1:1: not an RtsProfile: its root element is "a"
  [1]

Wrong usage:

  $ rtdoctor Motor0.rtc:in
  rtdoctor: Motor0.rtc:in: name its component, not a port (see --help)
  [2]
  $ rtdoctor --measure=0
  rtdoctor: argument --measure: not a number of seconds above 0: 0 (see --help)
  [2]
  $ rtdoctor -s Dead
  rtdoctor: argument -s/--state: not one of Active, Inactive, Error, Created, Unknown: Dead (see --help)
  [2]
  $ rtdoctor --profile
  rtdoctor: argument --profile: expected one argument (see --help)
  [2]
  $ rtdoctor --nonsense
  rtdoctor: unrecognized arguments: --nonsense (see --help)
  [2]

Ctrl-C ends it, whatever hangs:

  $ rtact --wait Clusterer0.rtc; hang robot
  $ interrupt 0.5 rtdoctor -q > out
  [130]
  $ within 4-16 rtdoctor -qv --timeout 4 --profile robot.rtsys > out
  [1]
  $ grep -c hung out
  4
  $ wake robot

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: SERVER
invocation: --json SERVER
invocation: A
invocation: --profile FILE SERVER
invocation: --report OUT SERVER
looking: -q A
broken server: 1
broken component: 1
examples: asking
example: rtdoctor --report incident.html --log run.mcap <- rtlog -q -f run.mcap -t 1 Source0.rtc:number
example: rtdoctor -q --from incident.html <- rtdoctor -q --report incident.html >/dev/null
