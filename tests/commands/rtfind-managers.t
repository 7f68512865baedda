rtfind looks into managers: slaves and components are found there, too.

world: managers --flavour cpp2
world: manager11 --context old.host_cxt/%n.rtc
world: deadchild --flavour cpp2 --context dead.host_cxt/%n.rtc

  $ pids() { sed 's/manager_[0-9]*/manager_N/'; }
  $ rtfind . | pids
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr
  /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr/manager_N
  /localhost:$PORT/test.host_cxt/manager.mgr/manager_N/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr/manager_N
  /localhost:$PORT/test.host_cxt/manager.mgr/manager_N/ConsoleOut0.rtc
  $ rtfind . -t m | pids
  /localhost:$PORT/test.host_cxt/manager.mgr
  /localhost:$PORT/test.host_cxt/manager.mgr/manager_N
  /localhost:$PORT/test.host_cxt/manager.mgr/manager_N
  $ rtfind . -t d -m 1
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/manager.mgr
  $ rtfind . -n 'ConsoleIn*' | pids
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr/manager_N/ConsoleIn0.rtc
  $ rtfind manager.mgr/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleIn0.rtc
  $ rtfind --json . -t m -m 1
  {"kind": "manager", "path": "/localhost:$PORT/test.host_cxt/manager.mgr"}
  $ rtfind ../old.host_cxt
  /localhost:$PORT/old.host_cxt
  /localhost:$PORT/old.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/old.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/old.host_cxt/manager.mgr
  /localhost:$PORT/old.host_cxt/manager.mgr/ConsoleIn0.rtc
  /localhost:$PORT/old.host_cxt/manager.mgr/ConsoleOut0.rtc

A state is found once a path, in a manager as well:

  $ rtact --wait ConsoleIn0.rtc
  $ rtfind .. --state active | pids
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr/manager_N/ConsoleIn0.rtc

A component that has ended and is still listed by its manager is a zombie in a live manager:

  $ rtfind ../dead.host_cxt -t z
  /localhost:$PORT/dead.host_cxt/manager.mgr/manager/unknown1.rtc
  /localhost:$PORT/dead.host_cxt/manager.mgr/unknown1.rtc
  $ rtfind ../dead.host_cxt -t m
  /localhost:$PORT/dead.host_cxt/manager.mgr
  /localhost:$PORT/dead.host_cxt/manager.mgr/manager
  $ rtfind ../dead.host_cxt
  /localhost:$PORT/dead.host_cxt
  /localhost:$PORT/dead.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/dead.host_cxt/manager.mgr
  /localhost:$PORT/dead.host_cxt/manager.mgr/ConsoleIn0.rtc
  /localhost:$PORT/dead.host_cxt/manager.mgr/manager
  /localhost:$PORT/dead.host_cxt/manager.mgr/manager/ConsoleIn0.rtc
  /localhost:$PORT/dead.host_cxt/manager.mgr/manager/unknown1.rtc
  /localhost:$PORT/dead.host_cxt/manager.mgr/unknown1.rtc

Slaves that are gone:

  $ ctl slave 1 die
  $ until rtfind -q . -t z; do :; done
  $ rtfind . -t z
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ kill-mock managers
  $ rtfind .
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/manager.mgr
  $ rtfind . -t m
