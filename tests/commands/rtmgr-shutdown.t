rtmgr --shutdown ends a master's slaves before the master: alone, it would leave processes to which no manager leads. What it
says is gone is gone.

world: managers --flavour cpp2
world: managers --flavour py2 --context py2.host_cxt/%n.rtc
world: deadslave --context dead.host_cxt/%n.rtc
world: managers --context hung.host_cxt/%n.rtc

A slave alone; its master lives, with the other one:

  $ rtls manager.mgr | sed 's/_[0-9]*/_PID/'
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager_PID/
  manager_PID/
  $ S=$(ctl slave 1 port); rtmgr -v --shutdown corbaloc::localhost:$S 2>&1 | sed s/$S/S/
  rtmgr: shut down corbaloc::localhost:S
  $ rtls manager.mgr
  ConsoleOut0.rtc
  manager/

A slave that refuses, or does not end: it is named, and the master is left running. Time is what --wait says, or 5 s:

  $ ctl slave 2 fail shutdown 1 NO_PERMISSION; rtmgr -v --shutdown manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr/manager: CORBA.NO_PERMISSION
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: not tried: its slave /localhost:$PORT/test.host_cxt/manager.mgr/manager still runs, and cannot be found without it
  [5]
  $ ctl slave 2 fail shutdown 1 COMM_FAILURE; within 0.9-8 rtmgr -v --wait=1 --shutdown manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr/manager: its process has not ended within 1s
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: not tried: its slave /localhost:$PORT/test.host_cxt/manager.mgr/manager still runs, and cannot be found without it
  [5]
  $ rtls
  ConsoleOut0.rtc
  manager.mgr/
  $ ctl fail shutdown 1 NO_PERMISSION; rtmgr -v --shutdown manager.mgr
  rtmgr: shut down /localhost:$PORT/test.host_cxt/manager.mgr/manager
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: CORBA.NO_PERMISSION
  [5]

Some slaves ended, one did not:

  $ cd() { export RTCSH_CWD=$1; }
  $ cd /localhost:$PORT/hung.host_cxt
  $ H=$(ctl @managers3 slave 1 pid); kill -STOP $H
  $ rtmgr -v --timeout 2 --shutdown manager.mgr 2>&1 | sed "s/_[0-9][0-9]*/_PID/g"
  rtmgr: /localhost:$PORT/hung.host_cxt/manager.mgr/slave0: no answer within 2s
  rtmgr: shut down /localhost:$PORT/hung.host_cxt/manager.mgr/manager
  rtmgr: /localhost:$PORT/hung.host_cxt/manager.mgr: not tried: its slave /localhost:$PORT/hung.host_cxt/manager.mgr/slave0 still runs, and cannot be found without it
  $ rtls --timeout 2 -R
  .:
  ?ConsoleIn0.rtc
  manager.mgr/

  ./manager.mgr:
  ?slave0

  rtls: /localhost:$PORT/hung.host_cxt/manager.mgr: no answer within 2s
  rtls: 2 of 3 did not answer (ConsoleIn0.rtc, slave0)
  [4]
  $ kill -CONT $H; rtmgr -v --shutdown manager.mgr
  rtmgr: shut down /localhost:$PORT/hung.host_cxt/manager.mgr/manager
  rtmgr: shut down /localhost:$PORT/hung.host_cxt/manager.mgr
  $ rtls

Managers of Python; one of whose slaves has died; and what --dry-run prints:

  $ cd /localhost:$PORT/py2.host_cxt
  $ rtmgr --dry-run --shutdown manager.mgr
  rtmgr --shutdown /localhost:$PORT/py2.host_cxt/manager.mgr
  $ rtmgr --shutdown manager.mgr
  $ rtls
  $ cd /localhost:$PORT/dead.host_cxt
  $ rtmgr -v --shutdown manager.mgr
  rtmgr: shut down /localhost:$PORT/dead.host_cxt/manager.mgr/manager
  rtmgr: shut down /localhost:$PORT/dead.host_cxt/manager.mgr
  $ rtls
