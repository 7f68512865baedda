rtkeep brings a system to what its RtsProfile says, stays, and mends what changes.

world: these ConsoleIn ConsoleOut Motor ConfigSample
world: these ConsoleOut:Plain0 --flavour cpp2

  $ export XDG_RUNTIME_DIR=$PWD; rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon -i two ConsoleIn0.rtc:out Plain0.rtc:in
  $ rtcryo --all -o a.xml localhost:$PORT; rtdis ConsoleIn0.rtc
  $ rtconf ConfigSample0.rtc set int_param0 7

At boot: the commands that would do it; then it is done once. What is not so in time is the status.

  $ rtkeep --dry-run a.xml | said | sed 's/ -p .* / … /'
  rtconf ConfigSample0.rtc -s mode1 set int_param0=-999
  rtcon -n outin -i one … ConsoleOut0.rtc:in
  rtcon -n outin -i two … Plain0.rtc:in
  rtact --wait ConfigSample0.rtc
  rtact --wait ConsoleIn0.rtc
  rtact --wait ConsoleOut0.rtc
  rtact --wait Motor0.rtc
  rtact --wait Plain0.rtc
  $ rtkeep --once a.xml | said | sort
  ConfigSample0.rtc: Active
  ConfigSample0.rtc: restored configuration set mode1
  ConsoleIn0.rtc: Active
  ConsoleIn0.rtc: restored connection one
  ConsoleIn0.rtc: restored connection two
  ConsoleOut0.rtc: Active
  Motor0.rtc: Active
  Plain0.rtc: Active
  $ rtcheck a.xml; rtkeep --once a.xml
  $ rtdeact Motor0.rtc; mkfifo fifo
  $ rtkeep --once --events fifo a.xml
  rtkeep: fifo: No such device or address
  [1]
  $ rtkeep --once --events log.json a.xml > nul; grep -c Active.*Motor0 log.json
  1
  $ rtdeact Motor0.rtc; rtsh -c 'start -q a.xml; wait a.xml; keep --once a.xml' | said
  $ rtcheck a.xml
  $ sed 's/Motor0/Motor9/' a.xml > other.xml; rtkeep --once --within 10 other.xml
  rtkeep: /localhost:$PORT/test.host_cxt/Motor9.rtc: no such path; did you mean Motor0.rtc?
  [3]

It stays, and mends: a connection, an Error, a component that was killed and is there again; one that hangs is left alone.

  $ rtkeep a.xml >> out 2>&1 & keep=$!
  $ soon 'rtkeep status | grep ";.all.is"'; watched Motor0
  $ watched ConsoleIn0
  $ rtdis -i one ConsoleIn0.rtc:out; soon 'grep "connection one" out'
  $ ctl error Motor0; soon 'grep Motor0.*Active out'
  $ kill-mock these2; soon 'grep gone out'
  $ mock these ConsoleOut:Plain0 --flavour cpp2
  $ soon 'grep Plain0.*Active out'; soon 'grep "connection two" out'
  $ rtcheck a.xml
  $ hang these3; soon 'grep "left alone" out'
  $ wake these3; soon 'grep again out'
  $ soon 'rtcheck a.xml'
  $ said out | grep -v -e 'waits for Plain0' -e 'no answer within 3s$' | sort  # of what was looked at just then
  ConsoleIn0.rtc: restored connection one
  ConsoleIn0.rtc: restored connection two
  Motor0.rtc: Active
  Motor0.rtc: in Error: reset
  Plain0.rtc: Active
  Plain0.rtc: answers again
  Plain0.rtc: its process is gone
  Plain0.rtc: (not asked: its process gave )?no answer within 3s: left alone (re)

What a person does is reported, and left alone.

  $ soon 'rtkeep status | grep ";.all.is"'
  $ : > out; rtdeact Motor0.rtc
  $ rtconf ConfigSample0.rtc set int_param0 9; rtec Motor0.rtc rate 500
  $ soon '[ $(grep -c "by hand" out) = 3 ]'; ctl state Motor0
  INACTIVE
  $ rtconf ConfigSample0.rtc get int_param0
  9
  $ rtact Motor0.rtc; soon 'grep Active.again out'
  $ said out | sort
  ConfigSample0.rtc: configuration set mode1 was changed by hand: left alone
  Motor0.rtc: is Active again
  Motor0.rtc: rate of execution context 0 was changed by hand: left alone
  Motor0.rtc: was made Inactive by hand: left alone

Who reports nothing is seen to fail again as soon as it is Active.

  $ : > out; ctl @these3 error Plain0
  $ soon 'grep Plain0.*Active out'
  $ ctl @these3 error Plain0; soon '[ $(grep -c Plain0.*Active out) = 2 ]'

At the end no observer stays. (What is asked at rest: tests/sim/stories/rtkeep-rest.t.)

  $ kill $keep; wait $keep
  $ ctl observers Motor0; ctl observers ConsoleIn0

With --strict all is as in the file.

  $ rtkeep --strict a.xml > out 2>&1 & keep=$!
  $ soon 'grep rate.of out'; soon 'ctl observers Motor0 | grep Obs'
  $ rtdeact Motor0.rtc; soon 'grep Motor0.*Active out'
  $ soon 'rtcheck a.xml'; kill $keep
  $ wait $keep

What cannot be meant:

  $ rtkeep --within 5 a.xml
  rtkeep: --within is for --once (see --help)
  [2]
  $ rtkeep --manager x a.xml
  rtkeep: --manager is for --create (see --help)
  [2]
  $ rtkeep --restart never a.xml
  rtkeep: argument --restart: not one of always, on-error, no: never (see --help)
  [2]
  $ rtkeep --burst 5 a.xml
  rtkeep: argument --burst: not NUMBER/SECONDS: 5 (see --help)
  [2]
  $ rtkeep --delay 5 a.xml
  rtkeep: argument --delay: not FIRST-MOST: 5 (see --help)
  [2]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: --once --within 1 FILE
looking: --dry-run FILE
broken component: 5
examples: endless
example: rtkeep convert robot.launch -o new.rtsys <- echo '<launch/>' > robot.launch
