rtkeep is asked and steered by others: status, pause, resume, stop, reload, adopt; it reports to a service manager and to a log.

world: these ConsoleIn ConsoleOut Motor ConfigSample

  $ export XDG_RUNTIME_DIR=$PWD; mkdir -p rtkeep
  $ chmod 700 rtkeep
  $ rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o a.xml localhost:$PORT; rtcryo --all -o b.xml localhost:$PORT
  $ rtkeep status
  rtkeep: no rtkeep runs
  [1]

To systemd it says when all is as the file says, what happens, that it lives, and that it ends:

  $ cat > manager.py <<'EOF'
  > import os, socket
  > server = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
  > server.bind("notify")
  > while True:
  >     print(server.recv(4096).decode(), flush=True)
  > EOF
  $ python3 manager.py > told & manager=$!
  $ soon '[ -S notify ]'
  $ NOTIFY_SOCKET=$PWD/notify WATCHDOG_USEC=1000000 rtkeep --events log.json a.xml >> out 2>&1 & keep=$!
  $ soon 'grep READY=1 told'; soon '[ $(grep -c WATCHDOG=1 told) -ge 3 ]'
  $ grep STATUS told | said | sed 's/\[.*\] //' | sort
  STATUS=ConfigSample0.rtc: Active
  STATUS=ConsoleIn0.rtc: Active
  STATUS=ConsoleOut0.rtc: Active
  STATUS=Motor0.rtc: Active
  $ ls -l rtkeep | awk 'NR > 1 {print $1, $9}' | sed 's/-[0-9a-f]*\./-N./'
  -rw------- a.xml-N.lock
  srw------- a.xml-N.socket
  $ rtkeep status | said; rtkeep status b.xml
  a.xml: pid N, since T; all is as the file says
    ConfigSample0.rtc  Active  Active  T    Active
    ConsoleIn0.rtc     Active  Active  T    Active
    ConsoleOut0.rtc    Active  Active  T    Active
    Motor0.rtc         Active  Active  T    Active
  rtkeep: b.xml: no rtkeep keeps it
  [1]

What is paused is not mended, until it is resumed; that takes back what a person has done, too.

  $ rtkeep pause Motor0 ConsoleIn0 ConsoleOut0; ctl error Motor0
  $ rtdis ConsoleIn0.rtc; sleep 1
  $ ctl state Motor0
  ERROR
  $ rtls -l | grep ConsoleIn0
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtkeep resume Motor0 /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc ConsoleOut0
  $ soon 'rtcheck a.xml'; soon 'rtkeep status | grep ";.all.is"'
  $ rtdeact Motor0.rtc; soon 'grep Motor0.*by.hand out'
  $ rtkeep status | said | head -n 1
  a.xml: pid N, since T; all is as the file says, but for what is left alone
  $ rtkeep status --json | grep -o '"by_hand": .".*hand"'
  "by_hand": ["was made Inactive by hand"
  $ rtkeep resume; soon 'rtcheck a.xml'
  $ soon 'rtkeep status | grep ";.all.is"'
  $ rtkeep stop Motor0; soon 'rtkeep status | grep Motor0.*on.request'
  $ rtkeep status | grep Motor0 | said
    Motor0.rtc         paused  Inactive  T    deactivated on request
  $ rtkeep resume
  $ rtkeep pause Motor0.rtc; rtkeep status | grep -c paused
  1
  $ rtkeep resume; soon 'rtcheck a.xml && rtkeep status | grep all.is.as'
  $ rtkeep pause Nothing0; rtkeep --of b.xml pause
  rtkeep: a.xml: no such component or process in it: Nothing0
  rtkeep: b.xml: no rtkeep keeps it
  [1]

What a person has done stays when the file is read again, and so does a pause; what the file wants otherwise than before is done.

  $ : > out; rtdeact Motor0.rtc
  $ rtconf ConfigSample0.rtc -s mode1 set int_param0=7; rtec ConfigSample0.rtc rate 250
  $ soon '[ $(grep -c by.hand out) = 3 ]'
  $ rtkeep pause ConsoleOut0; cp a.xml before
  $ sed 's/\(int_param0" rts:data=\)"-999"/\1"8"/' before > a.xml; cmp -s before a.xml
  [1]
  $ : > out; rtkeep reload
  $ soon '[ "$(rtconf ConfigSample0.rtc -s mode1 get int_param0)" = 8 ]'
  $ soon 'grep ConfigSample0.*restored out'; cp before a.xml
  $ rtkeep reload
  $ soon '[ $(grep -c ConfigSample0.*restored out) = 2 ]'; soon 'rtkeep status | grep ";.all.is"'
  $ soon 'rtkeep status | grep Motor0.*Inactive'
  $ rtkeep status --json | grep -o '"by_hand": .".*hand"\|"ConsoleOut0.*"\|"wanted": "paused"'
  "by_hand": ["rate of execution context 0 was changed by hand"
  "wanted": "paused"
  "by_hand": ["was made Inactive by hand"
  $ said out | sort
  ConfigSample0.rtc: restored configuration set mode1
  ConfigSample0.rtc: restored configuration set mode1
  $ ctl state Motor0
  INACTIVE
  $ rtec ConfigSample0.rtc | head -3
  0  0  Periodic  250  Running  Active  ConfigSample0  -
  $ rtkeep resume; soon 'rtcheck a.xml'
  $ soon 'rtkeep status | grep ";.all.is"'

Its file can be read again; one that is wrong changes nothing.

  $ sed 's/rts:name="outin"/rts:name="renamed"/; s/rts:connectorId="one"/rts:connectorId="new"/' b.xml > c.xml
  $ rtdis ConsoleIn0.rtc; cp c.xml a.xml
  $ rtkeep reload; soon 'rtcheck a.xml'
  $ echo nonsense > a.xml; rtkeep reload
  rtkeep: a.xml:1:1: not an RtsProfile: the key rtsProfile is missing
  [1]
  $ sed 's|\(<rts:Components [^>]*Motor0[^>]*>\)|\1<rtsExt:Properties rtsExt:name="keep.burst" rtsExt:value="many"/>|' c.xml > a.xml
  $ rtkeep reload | said
  rtkeep: /localhost:$PORT/test.host_cxt/Motor0.rtc: its property keep.burst: not NUMBER/SECONDS
  $ rm a.xml; rtkeep reload
  rtkeep: a.xml: No such file or directory
  [1]
  $ kill -0 $keep
  $ kill -HUP $keep; cp c.xml a.xml
  $ soon 'rtcheck a.xml'; soon 'rtkeep status | grep ";.all.is"'

What a person has done can be made the file's.

  $ : > out; rtconf ConfigSample0.rtc -s mode1 set int_param0=5
  $ rtec Motor0.rtc rate 500; soon '[ $(grep -c by.hand out) = 2 ]'
  $ rtkeep pause; rtdis ConsoleIn0.rtc
  $ rtcon -i more ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtkeep adopt --dry-run a.xml | grep '^[-+]' | sed 's/ *<[^ ]*//; s/rtc.*//' | head -7
  --- a.xml
  +++ now
  - rts:name="int_param0" rts:data="-999"/>
  + rts:name="int_param0" rts:data="5"/>
  - xsi:type="rtsExt:execution_context_ext" rts:id="0" rts:kind="PERIODIC" rts:rate="1000.0"/>
  + xsi:type="rtsExt:execution_context_ext" rts:id="0" rts:kind="PERIODIC" rts:rate="500.0"/>
  - xsi:type="rtsExt:dataport_connector_ext" rts:connectorId="new" rts:name="renamed" rts:dataType="IDL:RTC/TimedLong:1.0" rts:interfaceType="corba_cdr" rts:dataflowType="push" rts:subscriptionType="new">
  $ rtkeep adopt a.xml; rtcheck a.xml
  $ rtkeep adopt --dry-run a.xml; rtkeep reload
  $ soon 'rtcheck a.xml'; sleep 0.5
  $ rtcheck a.xml

Every action is in the log; with --teardown all is deactivated, and disconnected.

  $ grep -m 1 ConfigSample0 log.json | sed 's/[0-9]*\.[0-9]*/N/g'
  {"done": "Active", "error": null, "object": "/localhost:$PORT/testNhost_cxt/ConfigSampleNrtc", "seconds": N, "seen": "", "time": N}
  $ kill $keep; wait $keep
  $ soon 'grep STOPPING=1 told'; grep -o STOPPING=1 told
  STOPPING=1
  $ kill $manager
  $ rtkeep --teardown a.xml > out 2>&1 & keep=$!
  $ soon 'rtkeep status | grep ";.all.is"'
  $ rtkeep stop
  $ wait $keep
  $ rtls -l | awk '{print $1, $2, $6}'
  Inactive 0/0 ConfigSample0.rtc
  Inactive 1/0 ConsoleIn0.rtc
  Inactive 1/0 ConsoleOut0.rtc
  Inactive 2/0 Motor0.rtc
  $ rtkeep --leave a.xml > out 2>&1 & keep=$!
  $ soon 'rtkeep status | grep ";.all.is"'
  $ rtkeep stop
  $ wait $keep
  $ rtcheck a.xml
  $ ls rtkeep | grep socket
  [1]

It goes on when nobody reads what it prints, when its log cannot be written, and when a request is nonsense.

  $ rtkeep --leave --events /dev/full a.xml 2> err | true & soon 'rtkeep status a.xml'
  > rtdis ConsoleIn0.rtc
  > soon 'rtcheck a.xml'; soon 'grep log err'
  > cat err
  rtkeep: nothing more goes to the log of events: No space left on device
  $ python3 - <<'EOF'
  > import glob, socket
  > for words in b"", b"x\n", b"[]\n", b'{"command": "dance"}\n', b'{"command": "pause"}\n', b'{"command": "stop", "names": 5}\n', b"[" * 99999 + b"\n":
  >     with socket.socket(socket.AF_UNIX) as door:
  >         door.connect(glob.glob("rtkeep/a.xml*.socket")[0])
  >         door.sendall(words)
  >         door.shutdown(socket.SHUT_WR)
  >         print(door.makefile().read(), end="")
  > EOF
  {"error": "not understood"}
  {"error": "not understood"}
  {"error": "not understood"}
  {"error": "no such command: dance (see --help)"}
  {"error": "not understood"}
  {"error": "not understood"}
  {"error": "not understood"}
  $ rtkeep stop; soon '! rtkeep status a.xml'

A directory that is not ours alone is not used.

  $ chmod 777 rtkeep; rtkeep status
  rtkeep: $TMP/rtkeep: not a directory of ours that nobody else can write to
  [1]
  $ rtkeep adopt
  rtkeep: FILE is missing: what is adopted is written into it (see --help)
  [2]
  $ rtkeep a.xml b.xml
  rtkeep: unrecognized arguments: b.xml (see --help)
  [2]
  $ rtkeep
  rtkeep: FILE is missing: what is kept must have a name (see --help)
  [2]

Each verb has its own help and options; what is not a verb is a file, as are words with a directory:

  $ rtkeep --help | grep '^  [a-z]* *[A-Z]'; rtkeep --help | wc -l
    keep     Keep the system of an RtsProfile, and mend what changes
    status   Print the wanted and present states of what is kept
    pause    Leave components and processes alone until they are resumed
    resume   Keep components and processes again, and undo what a person did
    stop     Stop components and processes, or all of them and rtkeep
    reload   Read the RtsProfile again
    adopt    Write the present state of a system into its RtsProfile
    convert  Make an RtsProfile from a launch file of rtmlaunch
  22
  $ for verb in status pause resume stop reload adopt convert; do echo $verb \
  >     $(rtkeep $verb --help | grep -o '[ []--[a-z-]*' | tr -d ' [' | sort -u |
  > grep -v 'verbose\|quiet\|timeout\|version\|help'); done
  status --json
  pause --of
  resume --of
  stop --of
  reload --of
  adopt --dry-run --xml --yaml
  convert --output --xml --yaml
  $ rtkeep keep --dry-run none.xml; rtkeep --dry-run none.xml
  rtkeep: none.xml: No such file or directory
  rtkeep: none.xml: No such file or directory
  [1]
  $ rtkeep --dry-run ./status
  rtkeep: ./status: No such file or directory
  [1]
  $ rtkeep --dry-run keep ./status
  rtkeep: ./status: No such file or directory
  [1]
  $ rtkeep pause --strict; rtkeep --json adopt a.xml
  rtkeep: --strict is for rtkeep keep, not for rtkeep pause (see --help)
  rtkeep: --json is for rtkeep keep and status, not for rtkeep adopt (see --help)
  [2]
  $ rtkeep --of b.xml a.xml
  rtkeep: --of is for rtkeep pause, resume, stop and reload, not for rtkeep keep (see --help)
  [2]
  $ rtkeep --dry-run adopt b.xml | wc -l
  25
