Naming contexts and managers that are bound by several names, and name servers that are bound in one another.

server: another
faulty: silent
world: aliased localhost:$PORT2
world: two --nameserver localhost:$PORT2
world: twonames --context managers.host_cxt/%n.rtc

Each is entered once, by the first of its names in the order of the listing; the others are marked. The root of another name
server is entered, too: its reference does not say what it is, but it is bound as a directory.

  $ rtls -R /localhost:$PORT
  .:
  managers.host_cxt/
  test.host_cxt/

  ./managers.host_cxt:
  ConsoleIn0.rtc
  manager.mgr/
  second.mgr/ -> /localhost:$PORT/managers.host_cxt/manager.mgr

  ./managers.host_cxt/manager.mgr:
  ConsoleIn0.rtc
  manager/

  ./managers.host_cxt/manager.mgr/manager:
  ConsoleIn0.rtc

  ./test.host_cxt:
  again.cxt/
  far0.cxt/
  real.cxt/ -> /localhost:$PORT/test.host_cxt/again.cxt
  top.cxt/ -> /localhost:$PORT

  ./test.host_cxt/again.cxt:
  Inner0.rtc
  loop.cxt/ -> /localhost:$PORT/test.host_cxt/again.cxt

  ./test.host_cxt/far0.cxt:
  test.host_cxt/

  ./test.host_cxt/far0.cxt/test.host_cxt:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
   (esc)
  $ rtls
  again.cxt/
  far0.cxt/
  real.cxt/
  top.cxt/
  $ rtls -R -l . | grep -e '->'
  -  -  -  -  -  real.cxt -> /localhost:$PORT/test.host_cxt/again.cxt
  -         -    -    -    -    loop.cxt -> /localhost:$PORT/test.host_cxt/again.cxt
  -  -  -  -  -  test.host_cxt -> /localhost:$PORT/test.host_cxt
  -         -    -    -    -    second.mgr -> /localhost:$PORT/test.host_cxt/top.cxt/managers.host_cxt/manager.mgr
  $ rtls -R --json . | grep alias
  {"alias": "/localhost:$PORT/test.host_cxt/again.cxt", "kind": "directory", "name": "real.cxt", "path": "/localhost:$PORT/test.host_cxt/real.cxt"}
  {"alias": "/localhost:$PORT/test.host_cxt/again.cxt", "kind": "directory", "name": "loop.cxt", "path": "/localhost:$PORT/test.host_cxt/again.cxt/loop.cxt"}
  {"alias": "/localhost:$PORT/test.host_cxt", "kind": "directory", "name": "test.host_cxt", "path": "/localhost:$PORT/test.host_cxt/top.cxt/test.host_cxt"}
  {"alias": "/localhost:$PORT/test.host_cxt/top.cxt/managers.host_cxt/manager.mgr", "kind": "manager", "name": "second.mgr", "path": "/localhost:$PORT/test.host_cxt/top.cxt/managers.host_cxt/second.mgr"}
  $ rtfind /localhost:$PORT
  /localhost:$PORT
  /localhost:$PORT/managers.host_cxt
  /localhost:$PORT/managers.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/managers.host_cxt/manager.mgr
  /localhost:$PORT/managers.host_cxt/manager.mgr/ConsoleIn0.rtc
  /localhost:$PORT/managers.host_cxt/manager.mgr/manager
  /localhost:$PORT/managers.host_cxt/manager.mgr/manager/ConsoleIn0.rtc
  /localhost:$PORT/managers.host_cxt/second.mgr -> /localhost:$PORT/managers.host_cxt/manager.mgr
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/again.cxt
  /localhost:$PORT/test.host_cxt/again.cxt/Inner0.rtc
  /localhost:$PORT/test.host_cxt/again.cxt/loop.cxt -> /localhost:$PORT/test.host_cxt/again.cxt
  /localhost:$PORT/test.host_cxt/far0.cxt
  /localhost:$PORT/test.host_cxt/far0.cxt/test.host_cxt
  /localhost:$PORT/test.host_cxt/far0.cxt/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/far0.cxt/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/real.cxt -> /localhost:$PORT/test.host_cxt/again.cxt
  /localhost:$PORT/test.host_cxt/top.cxt -> /localhost:$PORT
  $ rtfind /localhost:$PORT -t d -0 | tr '\0' '\n'
  /localhost:$PORT
  /localhost:$PORT/managers.host_cxt
  /localhost:$PORT/managers.host_cxt/manager.mgr
  /localhost:$PORT/managers.host_cxt/manager.mgr/manager
  /localhost:$PORT/managers.host_cxt/second.mgr
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/again.cxt
  /localhost:$PORT/test.host_cxt/again.cxt/loop.cxt
  /localhost:$PORT/test.host_cxt/far0.cxt
  /localhost:$PORT/test.host_cxt/far0.cxt/test.host_cxt
  /localhost:$PORT/test.host_cxt/real.cxt
  /localhost:$PORT/test.host_cxt/top.cxt
  $ rtfind --json . -n '*again.cxt' -n loop.cxt
  {"kind": "directory", "path": "/localhost:$PORT/test.host_cxt/again.cxt"}
  {"alias": "/localhost:$PORT/test.host_cxt/again.cxt", "kind": "directory", "path": "/localhost:$PORT/test.host_cxt/again.cxt/loop.cxt"}
  $ rtfind . -m 1
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/again.cxt
  /localhost:$PORT/test.host_cxt/far0.cxt
  /localhost:$PORT/test.host_cxt/real.cxt
  /localhost:$PORT/test.host_cxt/top.cxt

Paths lead through any of the names:

  $ rtls again.cxt/ again.cxt/loop.cxt top.cxt/test.host_cxt/real.cxt
  again.cxt/:
  Inner0.rtc
  loop.cxt/

  again.cxt/loop.cxt:
  Inner0.rtc
  loop.cxt/

  top.cxt/test.host_cxt/real.cxt:
  Inner0.rtc
  loop.cxt/
   (esc)
  $ rtls -l far0.cxt/test.host_cxt
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  $ rtls far0.cxt
  test.host_cxt/
  $ rtcat far0.cxt/test.host_cxt/ConsoleIn0.rtc | head -1
  ConsoleIn0.rtc  Inactive
  $ rtact far0.cxt/test.host_cxt/ConsoleIn0.rtc
  $ rtls far0.cxt/test.host_cxt/ConsoleIn.rtc
  rtls: /localhost:$PORT/test.host_cxt/far0.cxt/test.host_cxt/ConsoleIn.rtc: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ RTCSH_CWD=$RTCSH_CWD/far0.cxt rtcwd test.host_cxt
  /localhost:$PORT/test.host_cxt/far0.cxt/test.host_cxt
  $ rtdel --dry-run far0.cxt/test.host_cxt/ConsoleIn0.rtc
  rtdel /localhost:$PORT/test.host_cxt/far0.cxt/test.host_cxt/ConsoleIn0.rtc

Where both servers are listed, each is entered by its own name:

  $ export RTCTREE_NAMESERVERS="localhost:$PORT;localhost:$PORT2"
  $ rtfind /
  /
  /localhost:$PORT
  /localhost:$PORT/managers.host_cxt
  /localhost:$PORT/managers.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/managers.host_cxt/manager.mgr
  /localhost:$PORT/managers.host_cxt/manager.mgr/ConsoleIn0.rtc
  /localhost:$PORT/managers.host_cxt/manager.mgr/manager
  /localhost:$PORT/managers.host_cxt/manager.mgr/manager/ConsoleIn0.rtc
  /localhost:$PORT/managers.host_cxt/second.mgr -> /localhost:$PORT/managers.host_cxt/manager.mgr
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/again.cxt
  /localhost:$PORT/test.host_cxt/again.cxt/Inner0.rtc
  /localhost:$PORT/test.host_cxt/again.cxt/loop.cxt -> /localhost:$PORT/test.host_cxt/again.cxt
  /localhost:$PORT/test.host_cxt/far0.cxt -> /localhost:$PORT2
  /localhost:$PORT/test.host_cxt/real.cxt -> /localhost:$PORT/test.host_cxt/again.cxt
  /localhost:$PORT/test.host_cxt/top.cxt -> /localhost:$PORT
  /localhost:$PORT2
  /localhost:$PORT2/test.host_cxt
  /localhost:$PORT2/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT2/test.host_cxt/ConsoleOut0.rtc
  $ RTCTREE_NAMESERVERS="localhost:$PORT2;localhost:$PORT" rtfind / -n '*far*' -n '*top*'
  /localhost:$PORT/test.host_cxt/far0.cxt -> /localhost:$PORT2
  /localhost:$PORT/test.host_cxt/top.cxt -> /localhost:$PORT

A name server that is listed by two addresses is itself listed twice, but what is in it once:

  $ RTCTREE_NAMESERVERS="localhost:$PORT2;127.0.0.1:$PORT2" rtfind /
  /
  /127.0.0.1:$PORT2
  /127.0.0.1:$PORT2/test.host_cxt
  /127.0.0.1:$PORT2/test.host_cxt/ConsoleIn0.rtc
  /127.0.0.1:$PORT2/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT2
  /localhost:$PORT2/test.host_cxt -> /127.0.0.1:$PORT2/test.host_cxt

A server that is gone or does not answer costs its own name only, and the error is at that name:

  $ export RTCTREE_NAMESERVERS=localhost:$PORT
  $ mock aliased localhost:1 localhost:$SILENT --context broken.host_cxt/%n.rtc
  $ within 1.9-6 rtfind --timeout 2 ../broken.host_cxt -m 2
  /localhost:$PORT/broken.host_cxt
  /localhost:$PORT/broken.host_cxt/again.cxt
  /localhost:$PORT/broken.host_cxt/again.cxt/Inner0.rtc
  /localhost:$PORT/broken.host_cxt/again.cxt/loop.cxt -> /localhost:$PORT/broken.host_cxt/again.cxt
  /localhost:$PORT/broken.host_cxt/far0.cxt
  /localhost:$PORT/broken.host_cxt/far1.cxt
  /localhost:$PORT/broken.host_cxt/real.cxt -> /localhost:$PORT/broken.host_cxt/again.cxt
  /localhost:$PORT/broken.host_cxt/top.cxt
  /localhost:$PORT/broken.host_cxt/top.cxt/broken.host_cxt -> /localhost:$PORT/broken.host_cxt
  /localhost:$PORT/broken.host_cxt/top.cxt/managers.host_cxt
  /localhost:$PORT/broken.host_cxt/top.cxt/test.host_cxt
  rtfind: /localhost:$PORT/broken.host_cxt/far0.cxt: connection refused; is the name server running?
  rtfind: /localhost:$PORT/broken.host_cxt/far1.cxt: no answer within 2s
  [5]
  $ rtls ../broken.host_cxt/far0.cxt
  rtls: /localhost:$PORT/broken.host_cxt/far0.cxt: connection refused; is the name server running?
  [4]
  $ rtcat ../broken.host_cxt/far0.cxt/test.host_cxt/ConsoleIn0.rtc
  rtcat: /localhost:$PORT/broken.host_cxt/far0.cxt: connection refused; is the name server running?
  [4]
  $ rtls ../broken.host_cxt/
  again.cxt/
  far0.cxt/
  far1.cxt/
  real.cxt/
  top.cxt/
  $ within 1.9-6 rtls --timeout 2 ../broken.host_cxt/far1.cxt
  rtls: /localhost:$PORT/broken.host_cxt/far1.cxt: no answer within 2s
  [4]
  $ within 1.9-6 rtcat --timeout 2 ../broken.host_cxt/far1.cxt/x.rtc
  rtcat: /localhost:$PORT: no answer within 2s
  [4]

