rtdel and managers: their own names can be deleted, what is below them cannot, for that no name server knows.

world: managers --flavour cpp2
world: deadchild --flavour cpp2 --context dead.host_cxt/%n.rtc

  $ rtdel manager.mgr/ConsoleIn0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/manager.mgr: not a directory with names in it (it is a manager; rtmgr deletes its components)
  [3]
  $ SLAVE=manager_$(ctl slave 1 pid)/
  $ rtdel manager.mgr/${SLAVE%/} 2>&1 | sed 's/manager_[0-9]*/manager_N/'
  rtdel: /localhost:$PORT/test.host_cxt/manager.mgr: not a directory with names in it (it is a manager; rtmgr deletes its components)
  $ rtdel manager.mgr/nobody.rtc
  rtdel: /localhost:$PORT/test.host_cxt/manager.mgr/nobody.rtc: no such path
  [3]
  $ rtdel -z manager.mgr
  rtdel: /localhost:$PORT/test.host_cxt/manager.mgr: not a zombie (it is a manager)
  [3]
  $ rtls manager.mgr/${SLAVE}
  ConsoleIn0.rtc

-z never enters a manager: what it lists, dead or alive, is its own business

  $ rtls ../dead.host_cxt/manager.mgr
  ConsoleIn0.rtc
  manager/
  *unknown1.rtc
  $ ctl @deadchild reset; ctl reset
  $ rtdel -v -z
  $ calls @deadchild; calls
  $ rtls ../dead.host_cxt/manager.mgr
  ConsoleIn0.rtc
  manager/
  *unknown1.rtc

A manager whose process is gone is a zombie as others are; the slaves' components live:

  $ kill-mock managers
  $ rtdel -v -z
  rtdel: /localhost:$PORT/test.host_cxt/manager.mgr: deleted
  $ rtls -R ..
  .:
  dead.host_cxt/
  test.host_cxt/

  ./dead.host_cxt:
  ConsoleIn0.rtc
  manager.mgr/

  ./dead.host_cxt/manager.mgr:
  ConsoleIn0.rtc
  manager/
  *unknown1.rtc

  ./dead.host_cxt/manager.mgr/manager:
  ConsoleIn0.rtc
  *unknown1.rtc

  ./test.host_cxt:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
   (esc)

A name of a live manager:

  $ rtdel -v ../dead.host_cxt/manager.mgr
  rtdel: /localhost:$PORT/dead.host_cxt/manager.mgr: alive, with its connections, but no longer found by this name; a restart binds it again, or, by itself, naming.update.enable: YES in its rtc.conf
  rtdel: /localhost:$PORT/dead.host_cxt/manager.mgr: deleted
  $ rtls ../dead.host_cxt
  ConsoleIn0.rtc
