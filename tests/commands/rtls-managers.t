Managers are directories: of their slaves, which are in no name server, and of their components.

world: managers --flavour cpp2
world: manager11 --context old.host_cxt/%n.rtc
world: manager Motor?instance_name=M0 --flavour rtorb --context small.host_cxt/%n.rtc
world: deadslave --flavour cpp2 --context dead.host_cxt/%n.rtc

The components of a master's slaves are the master's, too. Two slaves of one name are told apart by their process ids:

  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager.mgr/
  $ rtls manager.mgr
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager_*/ (glob)
  manager_*/ (glob)
  $ rtls manager.mgr/ | head -2
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ SLAVE=manager_$(ctl slave 1 pid)/
  $ rtls -l manager.mgr/$SLAVE manager.mgr/${SLAVE%/}
  manager.mgr/manager_*/: (glob)
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc

  manager.mgr/manager_*: (glob)
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
   (esc)
  $ rtls -R
  .:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager.mgr/

  ./manager.mgr:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager_*/ (glob)
  manager_*/ (glob)

  ./manager.mgr/manager_*: (glob)
  ConsoleIn0.rtc

  ./manager.mgr/manager_*: (glob)
  ConsoleOut0.rtc
   (esc)
  $ rtls -lR manager.mgr
  .:
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  -         -    -    -    -    manager_* (glob)
  -         -    -    -    -    manager_* (glob)

  ./manager_*: (glob)
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc

  ./manager_*: (glob)
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
   (esc)
  $ rtls --json manager.mgr | sed 's/manager_[0-9]*/manager_N/g'
  {"kind": "component", "name": "ConsoleIn0.rtc", "path": "/localhost:$PORT/test.host_cxt/manager.mgr/ConsoleIn0.rtc"}
  {"kind": "component", "name": "ConsoleOut0.rtc", "path": "/localhost:$PORT/test.host_cxt/manager.mgr/ConsoleOut0.rtc"}
  {"kind": "manager", "name": "manager_N", "path": "/localhost:$PORT/test.host_cxt/manager.mgr/manager_N"}
  {"kind": "manager", "name": "manager_N", "path": "/localhost:$PORT/test.host_cxt/manager.mgr/manager_N"}
  $ rtls -0 manager.mgr/$SLAVE | tr '\0' '\n'
  /localhost:$PORT/test.host_cxt/manager.mgr/manager_*/ConsoleIn0.rtc (glob)

Paths lead through them, for every command; .. leads back:

  $ rtls -l manager.mgr/ConsoleIn0.rtc manager.mgr/ConsoleOut0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  $ rtls manager.mgr/$SLAVE/ConsoleIn0.rtc manager.mgr/$SLAVE/../ConsoleOut0.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ rtact --wait manager.mgr/ConsoleIn0.rtc; ctl slave 1 state ConsoleIn0
  ACTIVE
  $ rtls -l manager.mgr
  Active    1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  -         -    -    -    -    manager_* (glob)
  -         -    -    -    -    manager_* (glob)
  $ rtdeact manager.mgr/${SLAVE}ConsoleIn0.rtc; ctl slave 1 state ConsoleIn0
  INACTIVE
  $ rtcon manager.mgr/ConsoleIn0.rtc:out manager.mgr/ConsoleOut0.rtc:in
  $ rtcat -l manager.mgr/ConsoleIn0.rtc:out | tail -1
   +Connected to  /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleOut0.rtc:in
  $ rtdis manager.mgr/ConsoleOut0.rtc
  $ eval "$(rtcwd --shell)"
  $ rtcwd manager.mgr
  $ rtpwd
  /localhost:$PORT/test.host_cxt/manager.mgr
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager_*/ (glob)
  manager_*/ (glob)
  $ rtcwd ${SLAVE%/}
  $ rtls
  ConsoleIn0.rtc
  $ rtcwd ../..
  $ rtpwd | sed "s,/manager_.*,,"
  /localhost:$PORT/test.host_cxt
  $ rtls manager.mgr/nobody.rtc manager.mgr/ConsoleIn1.rtc manager.mgr/nobody/ConsoleIn0.rtc \
  >     manager.mgr/ConsoleIn0.rtc/x
  rtls: /localhost:$PORT/test.host_cxt/manager.mgr/nobody.rtc: no such path
  rtls: /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleIn1.rtc: no such path; did you mean ConsoleIn0.rtc?
  rtls: /localhost:$PORT/test.host_cxt/manager.mgr/nobody: no such path
  rtls: /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleIn0.rtc: not a directory (it is a component)
  [3]

A master of C++ 1.1 makes its components itself and has no slaves, one of RtORB does not know what slaves are:

  $ rtls ../old.host_cxt ../old.host_cxt/manager.mgr
  ../old.host_cxt:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager.mgr/

  ../old.host_cxt/manager.mgr:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
   (esc)
  $ rtls ../small.host_cxt/manager.mgr
  M0.rtc

rtls asks a manager for its lists, and each component for its name and whether it lives:

  $ ctl reset
  $ ctl slave 1 reset
  $ ctl slave 2 reset
  $ rtls >/dev/null
  $ calls
  $ ctl slave 1 calls
  1 _non_existent
  $ ctl reset
  $ rtls manager.mgr >/dev/null
  $ calls
  1 get_components
  1 get_slave_managers
  $ ctl slave 1 calls
  2 _non_existent
  1 get_components
  1 get_profile
  1 get_sdo_id

A slave that has died; the master forgets it when it has to ask it:

  $ rtls ../dead.host_cxt
  ConsoleIn0.rtc
  *ConsoleOut0.rtc
  manager.mgr/
  $ rtls ../dead.host_cxt/manager.mgr
  ConsoleIn0.rtc
  manager/
  *slave1

A slave that hangs holds up its master, which lives all the same:

  $ ctl slave 1 stop
  $ within 2-9 rtls --timeout 2
  ?ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager.mgr/
  rtls: 1 of 3 did not answer (ConsoleIn0.rtc)
  [5]
  $ within 2-9 rtls --timeout 2 manager.mgr
  rtls: /localhost:$PORT/test.host_cxt/manager.mgr: no answer within 2s
  [4]
  $ within 2-9 rtls --timeout 2 -R
  .:
  ?ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager.mgr/

  ./manager.mgr:
  manager/
  ?slave0

  ./manager.mgr/manager:
  ConsoleOut0.rtc

  rtls: /localhost:$PORT/test.host_cxt/manager.mgr: no answer within 2s
  rtls: 2 of 6 did not answer (ConsoleIn0.rtc, slave0)
  [5]
  $ within 2-9 rtfind --timeout 2 . -t m
  /localhost:$PORT/test.host_cxt/manager.mgr
  /localhost:$PORT/test.host_cxt/manager.mgr/manager
  rtfind: /localhost:$PORT/test.host_cxt/manager.mgr: no answer within 2s
  rtfind: /localhost:$PORT/test.host_cxt/manager.mgr/slave0: no answer within 2s
  [5]
