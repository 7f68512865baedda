rtls lists the RTC Tree: name servers, naming contexts, components and managers. Two components of this
transcript are connected; the working directory is the naming context that holds them.

world: linked

  $ echo $RTCSH_CWD
  /localhost:$PORT/test.host_cxt
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc

One name a line when the output is no terminal, as ls does, and sorted: a name server's order means
nothing. Directories end in a slash.

  $ rtls /
  localhost:$PORT/
  $ rtls /localhost:$PORT
  test.host_cxt/

-l shows the state, and the connected ports of all ports, in ports, out ports and service ports. The
name comes last, so that awk and read find the rest by number. What is no component shows dashes.

  $ rtls -l
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  $ rtls -l /
  -  -  -  -  -  localhost:$PORT
  $ rtls -l | awk '$1 == "Inactive" {print $NF}'
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ rtls -l ConsoleIn0.rtc
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc

Paths are relative to RTCSH_CWD, or absolute.

  $ rtls ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls .
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ rtls ..
  test.host_cxt/
  $ rtls ../..
  localhost:$PORT/
  $ rtls ../../../..
  localhost:$PORT/
  $ rtls ./../test.host_cxt/ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls /localhost:$PORT/test.host_cxt/
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ rtls //localhost:$PORT///test.host_cxt/./ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ RTCSH_CWD= rtls localhost:$PORT
  test.host_cxt/
  $ (unset RTCSH_CWD; rtls localhost:$PORT/test.host_cxt)
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ RTCSH_CWD=/localhost:$PORT rtls test.host_cxt
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ RTCSH_CWD=localhost rtls
  rtls: localhost: a working directory (RTCSH_CWD) starts with /
  [2]
  $ RTCSH_CWD=/localhost/Motor0.rtc:out rtls ..
  rtls: /localhost/Motor0.rtc:out: a port has no directory below it (it is the working directory, RTCSH_CWD)
  [2]

A name server needs no slash after its TCP port, and need not be in RTCTREE_NAMESERVERS.

  $ rtls /127.0.0.1:$PORT
  test.host_cxt/
  $ rtls /127.0.0.1:$PORT/
  test.host_cxt/
  $ RTCTREE_NAMESERVERS= rtls /localhost:$PORT/test.host_cxt
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ (unset RTCTREE_NAMESERVERS; rtls /iiop:localhost:$PORT/test.host_cxt)
  ConsoleIn0.rtc
  ConsoleOut0.rtc

Without the variable, the name server of this machine is meant; empty items and repetitions in it do no
harm.

  $ (unset RTCTREE_NAMESERVERS; rtls -q /)
  localhost/
  $ RTCTREE_NAMESERVERS=' ' rtls -q /
  localhost/
  $ RTCTREE_NAMESERVERS=";localhost:$PORT; 127.0.0.1:$PORT;;localhost:$PORT" rtls /
  127.0.0.1:$PORT/
  localhost:$PORT/

-R lists the directories below, too, an empty line after each.

  $ rtls -R /
  .:
  localhost:$PORT/

  ./localhost:$PORT:
  test.host_cxt/

  ./localhost:$PORT/test.host_cxt:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
   (esc)
  $ rtls -lR ..
  .:
  -  -  -  -  -  test.host_cxt

  ./test.host_cxt:
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
   (esc)
  $ rtls -R ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls --recurse .
  .:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
   (esc)

Several paths: what is in a directory follows its name. Options may be anywhere.

  $ rtls ConsoleIn0.rtc ConsoleOut0.rtc -l
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  $ rtls .. . -l
  ..:
  -  -  -  -  -  test.host_cxt

  .:
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
   (esc)
  $ rtls ConsoleIn0.rtc ..
  ConsoleIn0.rtc

  ..:
  test.host_cxt/
   (esc)
  $ rtls ConsoleIn0.rtc ConsoleIn0.rtc
  ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls -- ConsoleIn0.rtc
  ConsoleIn0.rtc

-0 is for xargs -0: full paths, each ended by a NUL byte.

  $ rtls -0 | tr '\0' '\n'
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ rtls -0 .. ConsoleIn0.rtc | od -An -c | tr -d ' \n' | sed "s/$PORT/PORT/g"; echo
  /localhost:PORT/test.host_cxt/ConsoleIn0.rtc\0/localhost:PORT/test.host_cxt\0
  $ rtls --null | xargs -0 rtls -l
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  $ rtls -R0 / | tr '\0' '\n'
  /localhost:$PORT
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc

--json is for programs: one object a line.

  $ rtls --json
  {"kind": "component", "name": "ConsoleIn0.rtc", "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc"}
  {"kind": "component", "name": "ConsoleOut0.rtc", "path": "/localhost:$PORT/test.host_cxt/ConsoleOut0.rtc"}
  $ rtls --json -l
  {"in_ports": 0, "in_ports_connected": 0, "kind": "component", "name": "ConsoleIn0.rtc", "out_ports": 1, "out_ports_connected": 1, "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc", "ports": 1, "ports_connected": 1, "service_ports": 0, "service_ports_connected": 0, "state": "Inactive"}
  {"in_ports": 1, "in_ports_connected": 1, "kind": "component", "name": "ConsoleOut0.rtc", "out_ports": 0, "out_ports_connected": 0, "path": "/localhost:$PORT/test.host_cxt/ConsoleOut0.rtc", "ports": 1, "ports_connected": 1, "service_ports": 0, "service_ports_connected": 0, "state": "Inactive"}
  $ rtls --json /
  {"kind": "server", "name": "localhost:$PORT", "path": "/localhost:$PORT"}
  $ rtls --json -l -R / | python3 -c 'import json, sys
  > for line in sys.stdin:
  >     found = json.loads(line)
  >     print(found["kind"], found["path"], found.get("state"), found.get("ports_connected"))'
  server /localhost:$PORT None None
  directory /localhost:$PORT/test.host_cxt None None
  component /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc Inactive 1
  component /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc Inactive 1

What does not exist. Of the directory that should have held it, the name nearest to it is offered.

  $ rtls nothing.like.it
  rtls: /localhost:$PORT/test.host_cxt/nothing.like.it: no such path; a name server is written with a slash: /nothing.like.it
  [3]
  $ rtls ConsolIn0.rtc
  rtls: /localhost:$PORT/test.host_cxt/ConsolIn0.rtc: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ rtls ConsoleIn0
  rtls: /localhost:$PORT/test.host_cxt/ConsoleIn0: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ rtls /localhost:$PORT/text.host_cxt
  rtls: /localhost:$PORT/text.host_cxt: no such path; did you mean test.host_cxt?
  [3]
  $ rtls /localhost:$PORT/text.host_cxt/ConsoleIn0.rtc
  rtls: /localhost:$PORT/text.host_cxt: no such path; did you mean test.host_cxt?
  [3]
  $ rtls ../test.host_cxt/ConsolIn0.rtc ConsoleOut0.rtc
  rtls: /localhost:$PORT/test.host_cxt/ConsolIn0.rtc: no such path; did you mean ConsoleIn0.rtc?
  ConsoleOut0.rtc
  [5]
  $ rtls nothing.rtc nowhere.rtc
  rtls: /localhost:$PORT/test.host_cxt/nothing.rtc: no such path
  rtls: /localhost:$PORT/test.host_cxt/nowhere.rtc: no such path
  [3]

What is of another kind.

  $ rtls ConsoleIn0.rtc/
  rtls: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtls ConsoleIn0.rtc/below.rtc
  rtls: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtls ConsoleIn0.rtc:out
  rtls: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not a directory or component (it is a port; rtcat shows it)
  [3]
  $ rtls /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out/
  rtls: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out/: a port has no directory below it
  [2]
  $ rtls ConsoleIn0.rtc:
  rtls: ConsoleIn0.rtc:: no port after the colon
  [2]
  $ rtls a:b:c
  rtls: a:b:c: a single colon separates a component from its port; write \: in a name
  [2]

An empty path is the working directory. A name server needs no slash before it (see rtls-lookup.t):

  $ rtls ''
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ rtls localhost:1
  rtls: /localhost:1: connection refused; is the name server running?
  [4]
  $ rtls localhost:$PORT
  test.host_cxt/
  $ rtls Nope0.rtc:in
  rtls: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [3]
  $ RTCSH_CWD=/ rtls localhost:1
  rtls: /localhost:1: connection refused; is the name server running?
  [4]

Wrong usage contacts nobody.

  $ rtls -x
  rtls: unrecognized arguments: -x (see --help)
  [2]
  $ rtls --rec
  rtls: unrecognized arguments: --rec (see --help)
  [2]
  $ rtls -R --l
  rtls: unrecognized arguments: --l (see --help)
  [2]
  $ rtls /:2809
  rtls: /:2809: :2809 is not a name server (host or host:tcpport)
  [2]
  $ rtls /localhost:65536
  rtls: /localhost:65536: 65536 is not a TCP port (1 to 65535)
  [2]
  $ rtls /localhost:port
  rtls: /localhost:port: port is not a TCP port (1 to 65535)
  [2]
  $ rtls 'ConsoleIn0.rtc\q'
  rtls: ConsoleIn0.rtc\q: bad escape \q
  [2]
  $ rtls --timeout
  rtls: argument --timeout: expected one argument (see --help)
  [2]
  $ rtls --timeout 0
  rtls: argument --timeout: not a number of seconds above 0: 0 (see --help)
  [2]
  $ rtls --timeout 86401
  rtls: argument --timeout: more than a day, 86400 s: 86401 (see --help)
  [2]
  $ rtls --timeout=-1
  rtls: argument --timeout: not a number of seconds above 0: -1 (see --help)
  [2]
  $ rtls --timeout soon
  rtls: argument --timeout: not a number of seconds above 0: soon (see --help)
  [2]
  $ rtls --timeout nan
  rtls: argument --timeout: not a number of seconds above 0: nan (see --help)
  [2]
  $ RTSHELL_TIMEOUT=never rtls
  rtls: RTSHELL_TIMEOUT: not a number of seconds above 0: never (see --help)
  [2]
  $ RTSHELL_TIMEOUT= rtls ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ RTSHELL_TIMEOUT=9.5 rtls ConsoleIn0.rtc
  ConsoleIn0.rtc

-v and -q change nothing while all goes well.

  $ rtls -v ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls -q ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls --verbose --quiet ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls --version
  1.0.0

Help is short, and fits on a screen; with -v it holds all that the command is for, and the exit statuses.

  $ COLUMNS=80 rtls --help
  usage: rtls [OPTION ...] [PATH ...]

  List the RTC Tree: name servers, directories, components.

    [PATH ...]     path in the RTC Tree
    -l             long listing: states and ports
    -R, --recurse  also list everything below directories
    -0, --null     print full paths, each followed by a NUL byte (for xargs -0)
    --json         print JSON, one object a line
    -v, -q, --timeout SECONDS, --version, -h: as all commands have them

  examples:
    rtls                               the working directory
    rtls -l localhost                  states and ports of what is there
    rtls -R /                          everything on all name servers
    rtls -l | awk '$1 == "Error"'      components in Error

  `rtls --help -v` says more, as does `man rtls`.
  $ rtls --help -v | sed -n '/^examples/,$p'
  examples:
    rtls                               the working directory
    rtls -l localhost                  states and ports of what is there
    rtls -R /                          everything on all name servers
    rtls -l | awk '$1 == "Error"'      components in Error

  exit status:
    0 done, 1 the answer is no or local work failed, 2 wrong usage,
    3 no such path or not that kind of object, 4 the peer is dead, silent or
    garbled, 5 some succeeded and some failed, 6 the peer refused,
    70 a bug in the tool, 130 Ctrl-C, 141 the reader of the output went away,
    129 SIGHUP, 143 SIGTERM (rtkeep and rtmount -f: 0)
  $ rtls -h -v | grep -o '^  --*[a-zR0-9]*' | tr -d '\n'; echo
    -l  -R  -0  --json  -v  -q  --timeout  --version  -h

A reader that goes away, a full disk, no stdout at all, no stdin, no stderr.

  $ python3 -c 'import os, subprocess
  > reader, writer = os.pipe()
  > os.close(reader)
  > print(subprocess.call(["rtls", "-R", "/"], stdout=writer))'
  141
  $ rtls >/dev/full
  rtls: No space left on device
  [1]
  $ rtls >&-
  rtls: cannot write the output: Bad file descriptor
  [1]
  $ rtls <&- ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls 2>&- nothing.like.it
  [3]

A component that has gone without a word leaves a zombie, marked with a star: in a listing that is no
failure, for the path given by name neither.

  $ mock zombie
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  *Mock0.rtc
  $ rtls -l
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  -         -    -    -    -    *Mock0.rtc
  $ rtls Mock0.rtc
  *Mock0.rtc
  $ rtls -l Mock0.rtc
  -  -  -  -  -  *Mock0.rtc
  $ rtls --json -l Mock0.rtc
  {"error": "/localhost:$PORT/test.host_cxt/Mock0.rtc: connection refused; its process is gone (zombie)", "kind": "zombie", "name": "Mock0.rtc", "path": "/localhost:$PORT/test.host_cxt/Mock0.rtc"}
  $ rtls -0 Mock0.rtc | tr '\0' '\n'
  /localhost:$PORT/test.host_cxt/Mock0.rtc

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -lR SERVER
invocation: -l SERVER
invocation: SERVER
invocation: --json -l SERVER
invocation: A
looking: -lR SERVER
looking: --json -l SERVER
broken component: 0 5
examples: asking
