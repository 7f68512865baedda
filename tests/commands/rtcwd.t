rtcwd prints the full path of a directory of the RTC Tree, after looking whether it is one. A program cannot change
its shell's variables: the function that does is below, and in rtcwd-shells.t.

world: two
world: zombie --context test.host_cxt/Dead%n.rtc
world: names --context odd.host_cxt/%n.rtc
faulty: silent garbage
alone: it measures

  $ rtcwd ..
  /localhost:$PORT
  $ rtcwd /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt
  $ rtcwd localhost:$PORT
  /localhost:$PORT
  $ RTCSH_CWD= rtcwd localhost:$PORT
  /localhost:$PORT
  $ RTCSH_CWD=/localhost:$PORT rtcwd test.host_cxt/
  /localhost:$PORT/test.host_cxt
  $ rtcwd ../../localhost:$PORT//odd.host_cxt/./a.cxt/b.cxt/..
  /localhost:$PORT/odd.host_cxt/a.cxt
  $ rtcwd /127.0.0.1:$PORT/odd.host_cxt/loop.cxt/loop.cxt
  /127.0.0.1:$PORT/odd.host_cxt/loop.cxt/loop.cxt

Without a path, the root; neither it nor . nor .. asks anyone.

  $ rtcwd
  /
  $ rtcwd /
  /
  $ export RTCTREE_NAMESERVERS=localhost:1
  $ RTCSH_CWD=/localhost:1/a.cxt/b.cxt rtcwd .
  /localhost:1/a.cxt/b.cxt
  $ RTCSH_CWD=/localhost:1/a.cxt/b.cxt rtcwd ./
  /localhost:1/a.cxt/b.cxt
  $ RTCSH_CWD=/localhost:1/a.cxt/b.cxt rtcwd ..
  /localhost:1/a.cxt
  $ RTCSH_CWD=/localhost:1/a.cxt/b.cxt rtcwd ../
  /localhost:1/a.cxt
  $ RTCSH_CWD=/ rtcwd ..
  /
  $ (unset RTCSH_CWD; rtcwd .)
  /
  $ RTCSH_CWD=/localhost:1/a.cxt/b.cxt rtcwd ../..
  rtcwd: /localhost:1: connection refused; is the name server running?
  [4]

A directory is spelt in one way, and in no way that harms a terminal:

  $ rtcwd '/localhost:'$PORT'/\x6fdd.host_cxt/\x61.cxt/'
  /localhost:$PORT/odd.host_cxt/a.cxt
  $ rtcwd /localhost:$PORT/odd.host_cxt/'e\x6dpty.cxt'
  /localhost:$PORT/odd.host_cxt/empty.cxt

Not a directory; no component is asked.

  $ rtcwd ConsoleIn0.rtc
  rtcwd: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtcwd ConsoleIn0.rtc/
  rtcwd: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtcwd ConsoleIn0.rtc:out
  rtcwd: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not a directory (it is a port)
  [3]
  $ rtcwd ConsoleIn0.rtc/..
  /localhost:$PORT/test.host_cxt
  $ rtcwd DeadMock0.rtc
  rtcwd: /localhost:$PORT/test.host_cxt/DeadMock0.rtc: not a directory (it is a component)
  [3]
  $ rtcwd ../odd.host_cxt/Nil0.rtc
  rtcwd: /localhost:$PORT/odd.host_cxt/Nil0.rtc: not a directory (it is a nil reference)
  [3]
  $ rtcwd ../odd.host_cxt/NotAComponent0.rtc
  rtcwd: /localhost:$PORT/odd.host_cxt/NotAComponent0.rtc: not a directory (it is a CORBA object of unknown kind)
  [3]
  $ rtcwd ../odd.host_cxt/NotAManager0.mgr
  rtcwd: /localhost:$PORT/odd.host_cxt/NotAManager0.mgr: not a directory (it is a CORBA object of unknown kind)
  [3]
  $ rtcwd ../odd.host_cxt/Thing0.obj
  rtcwd: /localhost:$PORT/odd.host_cxt/Thing0.obj: not a directory (it is a CORBA object of unknown kind)
  [3]
  $ calls

What does not exist, or does not answer:

  $ rtcwd nothing.cxt
  rtcwd: /localhost:$PORT/test.host_cxt/nothing.cxt: no such path
  [3]
  $ rtcwd /localhost:$PORT/text.host_cxt
  rtcwd: /localhost:$PORT/text.host_cxt: no such path; did you mean test.host_cxt?
  [3]
  $ rtcwd /localhost:1
  rtcwd: /localhost:1: connection refused; is the name server running?
  [4]
  $ rtcwd /no-such-host.invalid/a.cxt
  rtcwd: /no-such-host.invalid: host name not known
  [4]
  $ within 0.3-2.5 rtcwd --timeout 0.3 /localhost:$SILENT
  rtcwd: /localhost:$SILENT: no answer within 0.3s
  [4]
  $ RTSHELL_TIMEOUT=0.3 within 0.3-2.5 rtcwd /localhost:$SILENT/a.cxt
  rtcwd: /localhost:$SILENT: no answer within 0.3s
  [4]
  $ rtcwd /localhost:$GARBAGE
  rtcwd: /localhost:\$GARBAGE: (connection lost|garbled answer \(not GIOP\)) (re)
  [4]
  $ component=$(rtcat -ll ConsoleIn0.rtc | awk '$1 == "corba.endpoints" {print $2}')
  $ rtcwd /$component 2>&1 | sed "s/$component/HOST:PORT/g"
  rtcwd: /HOST:PORT: not a name server (it is a CORBA process of another kind)
  $ interrupt 0.3 rtcwd /localhost:$SILENT
  [130]

Completion gives up after about a second when a name server hangs:

  $ within 0.7-2.5 rtcwd --shell fish --line "rtls /localhost:$SILENT/a"

An empty directory is the root:

  $ rtcwd ''
  /

Wrong usage:

  $ rtcwd a b
  rtcwd: unrecognized arguments: b (see --help)
  [2]
  $ rtcwd --lang
  rtcwd: unrecognized arguments: --lang (see --help)
  [2]
  $ rtcwd --shell tcl
  rtcwd: --shell: no such shell: tcl (see --help)
  [2]
  $ rtcwd --shell=tcl
  rtcwd: argument --shell: not one of bash, csh, fish, sh, zsh: tcl (see --help)
  [2]
  $ rtcwd a:b:c
  rtcwd: a:b:c: a single colon separates a component from its port; write \: in a name
  [2]
  $ rtcwd /:1
  rtcwd: /:1: :1 is not a name server (host or host:tcpport)
  [2]
  $ RTCSH_CWD=robot rtcwd .
  rtcwd: robot: a working directory (RTCSH_CWD) starts with /
  [2]
  $ rtcwd --timeout never ..
  rtcwd: argument --timeout: not a number of seconds above 0: never (see --help)
  [2]
  $ rtcwd -x
  rtcwd: unrecognized arguments: -x (see --help)
  [2]

The common options:

  $ rtcwd -v -q ..
  /localhost:$PORT
  $ rtcwd --verbose --quiet --timeout 10 ..
  /localhost:$PORT
  $ rtcwd -- ..
  /localhost:$PORT
  $ rtcwd --version
  1.0.0
  $ rtcwd --help -v | sed -n '/^examples/,/^$/p'
  examples:
    rtcwd localhost
    rtcwd ..
    rtcwd --find
          from now on, Motor0 is the Motor0.rtc of any directory
   (esc)
  $ rtcwd .. >/dev/full
  rtcwd: No space left on device
  [1]
  $ rtcwd .. >&-
  rtcwd: cannot write the output: Bad file descriptor
  [1]

Typed on a terminal without the function, it says what is missing; -q does not.

  $ terminal 120 rtcwd ..
  /localhost:$PORT
  rtcwd: this shell has not changed; put  eval "$(rtcwd --shell)"  in your profile
  $ terminal 120 rtcwd -q ..
  /localhost:$PORT

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: SERVER/x.host_cxt
looking: SERVER
broken component: 3
examples: asking
