rtkeep lets managers create components that are gone, and gives composites back the members that they have lost.

world: manager
world: composite

  $ export XDG_RUNTIME_DIR=$PWD; rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o a.xml localhost:$PORT
  $ rtkeep --create --look 0.2 a.xml > out 2>&1 & keep=$!
  $ soon 'rtcheck a.xml'; soon 'rtkeep status | grep ";.all.is"'

A component that is deleted is created, and all is as it was:

  $ rtmgr -d ConsoleIn0 manager.mgr
  $ soon 'grep ConsoleIn0.*created out'
  $ soon 'rtcheck a.xml'
  $ soon 'said out | grep ConsoleIn0 | tail -1 | grep Active'
  $ said out | grep ConsoleIn0 | tail -4
  ConsoleIn0.rtc: has exited
  ConsoleIn0.rtc: was not there: created
  ConsoleIn0.rtc: restored connection one
  ConsoleIn0.rtc: Active

Its manager lists it late, when it has been seen already:

  $ soon 'rtkeep status | grep ";.all.is"'
  $ ctl @manager delay get_components 1
  $ rtmgr -d ConsoleIn0 manager.mgr
  $ soon 'grep -c ConsoleIn0.*created out | grep 2'
  $ soon 'said out | grep ConsoleIn0 | tail -1 | grep Active'
  $ ctl @manager delay get_components 0
  $ soon 'rtcheck a.xml'

A member that a composite has lost:

  $ soon 'rtkeep status | grep ";.all.is"'; rtcomp -r Motor0.rtc composite0.rtc
  $ soon 'grep restored.members out'; soon 'grep composite0.*by.hand out'
  $ rtkeep resume; soon 'grep composite0.*restored.configuration out'
  $ soon 'rtcheck a.xml'
  $ said out | grep -e members -e composite0.*set | sort
  composite0.rtc: configuration set default was changed by hand: left alone
  composite0.rtc: restored configuration set default
  composite0.rtc: restored members Controller0, Motor0, Sensor0
  $ rtcat -l composite0.rtc | grep -A3 -i member
    Member  /localhost:$PORT/test.host_cxt/Sensor0.rtc
    Member  /localhost:$PORT/test.host_cxt/Controller0.rtc
    Member  /localhost:$PORT/test.host_cxt/Motor0.rtc
  -Execution Context 0
    State  Running
    Kind   Periodic
  $ kill $keep; wait $keep

Without a manager nothing is created.

  $ rtmgr -d ConsoleIn0 manager.mgr; soon '! rtls ConsoleIn0.rtc'
  $ rtkeep --once --within 5 a.xml > nul
  rtkeep: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such path; did you mean ConsoleOut0.rtc?
  [3]
