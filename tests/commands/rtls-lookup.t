One rule for what a path may look like, for all commands.

world: managers --flavour cpp2
world: many 1 --context arm.host_cxt/left.host_cxt/%n.rtc
world: many 2 --context arm.host_cxt/right.host_cxt/%n.rtc
both: each ORB waits in its own way

Without the slash before it, a server is taken from the root, unless the working directory has such an entry:

  $ rtls localhost:$PORT
  arm.host_cxt/
  test.host_cxt/
  $ rtls localhost:$PORT/arm.host_cxt
  left.host_cxt/
  right.host_cxt/
  $ rtact localhost:$PORT/test.host_cxt/ConsoleIn0.rtc localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ rtcat localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  +DataOutPort: out
  $ rtcon localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ rtprint -n 1 localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  [*] * (glob)
  $ rtcryo -q localhost:$PORT/test.host_cxt | grep -c rtsExt:component_ext
  2
  $ rtcryo -q . | grep -c rtsExt:component_ext
  2
  $ rtstodot --text localhost:$PORT/test.host_cxt | grep -c Console
  2
  $ rttop -n 1 localhost:$PORT/arm.host_cxt/left.host_cxt | tail -1
  Inactive      1000     0  Mock0.rtc
  $ rtmgr -r localhost:$PORT/test.host_cxt/manager.mgr | grep instance
  instance name:\tConsoleIn0 (esc)
  instance name:\tConsoleOut0 (esc)
  $ rtdoctor localhost:$PORT/arm.host_cxt/left.host_cxt | grep -o ok.*Mock0.rtc
  ok    /localhost:*/arm.host_cxt/left.host_cxt/Mock0.rtc (glob)
  $ rtls localhost:99999
  rtls: /localhost:99999: 99999 is not a TCP port (1 to 65535)
  [2]
  $ rtls localhost:abc/x.host_cxt
  rtls: /localhost:abc/x.host_cxt: abc is not a TCP port (1 to 65535)
  [2]
  $ rtls /fe80::1
  rtls: /fe80::1: an IPv6 address is written in brackets: /[fe80::1]
  [2]
  $ rtls /::1:65535
  rtls: /::1:65535: an IPv6 address is written in brackets: /[::1]:65535
  [2]
  $ rtls ConsoleIn0.rtc:99
  rtls: /localhost:*/test.host_cxt/ConsoleIn0.rtc:99: not a directory or component (it is a port; rtcat shows it) (glob)
  [3]

A name alone, of what is in a directory of that one, or in several, or deeper. A name server is asked, and no
component:

  $ rtcat /localhost:$PORT/ConsoleIn0.rtc
  rtcat: /localhost:$PORT/ConsoleIn0.rtc: no such path; did you mean test.host_cxt/ConsoleIn0.rtc?
  [3]
  $ rtact /localhost:$PORT/arm.host_cxt/Mock1
  rtact: /localhost:$PORT/arm.host_cxt/Mock1: no such path; did you mean right.host_cxt/Mock1.rtc?
  [3]
  $ rtcat /localhost:$PORT/arm.host_cxt/Mock0.rtc
  rtcat: /localhost:$PORT/arm.host_cxt/Mock0.rtc: no such path; did you mean left.host_cxt/Mock0.rtc or right.host_cxt/Mock0.rtc?
  [3]
  $ rtcat /localhost:$PORT/Mock1.rtc
  rtcat: /localhost:$PORT/Mock1.rtc: no such path; did you mean arm.host_cxt/right.host_cxt/Mock1.rtc?
  [3]
  $ rtcat /localhost:$PORT/Nosuch0.rtc
  rtcat: /localhost:$PORT/Nosuch0.rtc: no such path
  [3]

A star is any one directory, two are any number of them. One object has to fit:

  $ rtls "/localhost:$PORT/*/ConsoleIn0.rtc"
  ConsoleIn0.rtc
  $ rtcat "/*/**/ConsoleIn0.rtc:out"
  +DataOutPort: out
  $ rtact "/localhost:$PORT/**/Mock1.rtc"
  $ rtls -l "/localhost:$PORT/**/Mock1.rtc"
  Active  2/0  1/0  1/0  0/0  Mock1.rtc
  $ rtact "/localhost:$PORT/**/Mock0.rtc"
  rtact: /localhost:*/**/Mock0.rtc: is one of 2: /localhost:*/arm.host_cxt/left.host_cxt/Mock0.rtc, /localhost:*/arm.host_cxt/right.host_cxt/Mock0.rtc; which one? (glob)
  [3]
  $ rtls "/localhost:$PORT/*/Mock0.rtc"
  rtls: /localhost:*/\*/Mock0.rtc: no such path (glob)
  [3]
  $ rtls "/*/*/nosuch.rtc"
  rtls: /*/*/nosuch.rtc: no such path
  [3]

By the name alone, where that is wanted:

  $ export RTSHELL_FIND=1
  $ rtls Mock1.rtc Mock1
  Mock1.rtc
  Mock1.rtc
  $ rtact -v Mock1
  rtact: /**/Mock1 is /localhost:*/arm.host_cxt/right.host_cxt/Mock1.rtc (glob)
  rtact: /localhost:*/arm.host_cxt/right.host_cxt/Mock1.rtc: * (glob)
  $ rtls Mock0
  rtls: /**/Mock0: is one of 2: /localhost:*/arm.host_cxt/left.host_cxt/Mock0.rtc, /localhost:*/arm.host_cxt/right.host_cxt/Mock0.rtc; which one? (glob)
  [3]
  $ rtls Mock9
  rtls: /**/Mock9: no such path
  [3]
  $ unset RTSHELL_FIND
  $ rtcwd --find
  /**
  $ RTCSH_CWD='/**' rtls
  localhost:*/ (glob)
  $ RTCSH_CWD='/**' rtcat Mock1:out0
  rtcat: /localhost:*/arm.host_cxt/right.host_cxt/Mock1.rtc: no such port: out0 (its ports: *) (glob)
  [3]
  $ RTCSH_CWD='/**' rtls left.host_cxt/Mock0.rtc left.host_cxt
  Mock0.rtc

  left.host_cxt:
  Mock0.rtc
   (esc)

A manager and what it has are reached without a name server:

  $ M=$(ctl port)
  $ rtls corbaloc:iiop:localhost:$M/manager
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager_*/ (glob)
  manager_*/ (glob)
  $ rtls corbaloc::localhost:$M | head -1
  ConsoleIn0.rtc
  $ rtls -l corbaloc:iiop:localhost:$M/manager/ConsoleIn0.rtc rtcloc://localhost:$M/example/ConsoleIn0
  Active  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Active  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  $ rtcat rtcloc://localhost:$M/example/ConsoleIn0.out
  +DataOutPort: out
  $ rtls rtcloc://localhost:$M/other/ConsoleIn0
  rtls: corbaloc:iiop:localhost:*/manager/ConsoleIn0.rtc: no such component of that category: it is of the category example (glob)
  [3]
  $ rtls "rtcloc://*/example/ConsoleIn0"
  rtls: rtcloc://*/example/ConsoleIn0: name the host of the manager
  [2]
  $ rtcat rtcname://localhost:$PORT/test.host_cxt/ConsoleIn0.out
  +DataOutPort: out
  $ rtcat "rtcname://localhost:$PORT/*/Mock1" | head -1
  Mock1.rtc  Active
  $ rtdoctor corbaloc::localhost:$M/manager | grep -c -e itself -e 'same component'
  0
  [1]
  $ RTCTREE_NAMESERVERS=corbaloc::localhost:$M/manager rtls -R / | head -5
  .:
  corbaloc:iiop:localhost:*/manager/ (glob)

  ./corbaloc:iiop:localhost:*/manager: (glob)
  ConsoleIn0.rtc
  $ RTCTREE_NAMESERVERS=corbaloc::localhost:$M/manager rtcryo -q |
  >     grep -o pathUri=.*manager/Console[A-Za-z0-9]*.rtc
  pathUri="corbaloc:iiop:localhost:*/manager/ConsoleIn0.rtc (glob)
  pathUri="corbaloc:iiop:localhost:*/manager/ConsoleOut0.rtc (glob)
  $ RTCTREE_NAMESERVERS=corbaloc::localhost:$M/manager rtcryo -q > made.rtsys; rtcheck made.rtsys
  $ RTCSH_CWD=corbaloc::localhost:$M rtls -l ConsoleIn0.rtc
  Active  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  $ rtls corbaloc::localhost:1
  rtls: corbaloc:iiop:localhost:1/manager: connection refused; is the manager running?
  [4]
  $ rtls corbaloc::localhost:$PORT/NameService
  arm.host_cxt/
  test.host_cxt/
  $ RTCTREE_NAMESERVERS=localhost:1 RTSHELL_FIND=1 rtls Nobody0
  rtls: /localhost:1: connection refused; is the name server running?
  [4]
  $ rtls IOR:00
  rtls: IOR:00: not a reference (its octets make no sense)
  [4]
  $ rtls IOR:xyz
  rtls: IOR:xyz: not a stringified reference (IOR:…)
  [2]
