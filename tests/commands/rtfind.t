rtfind finds objects in the RTC Tree and prints their full paths.

server: another
world: console
world: error --context test.host_cxt/arm.cxt/%n.rtc
world: zombie --context test.host_cxt/Dead%n.rtc
world: two --nameserver localhost:$PORT2
alone: it measures

Everything at and below a path, a directory before what is in it:

  $ rtfind /
  /
  /localhost:$PORT
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  /localhost:$PORT/test.host_cxt/DeadMock0.rtc
  /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc
  /localhost:$PORT/test.host_cxt/SequenceOutComponent0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt
  /localhost:$PORT/test.host_cxt/arm.cxt/Broken0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Err0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/ErrStart0.rtc
  $ rtfind .
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  /localhost:$PORT/test.host_cxt/DeadMock0.rtc
  /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc
  /localhost:$PORT/test.host_cxt/SequenceOutComponent0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt
  /localhost:$PORT/test.host_cxt/arm.cxt/Broken0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Err0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/ErrStart0.rtc
  $ rtfind arm.cxt
  /localhost:$PORT/test.host_cxt/arm.cxt
  /localhost:$PORT/test.host_cxt/arm.cxt/Broken0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Err0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/ErrStart0.rtc
  $ rtfind .. | head -n 2
  /localhost:$PORT
  /localhost:$PORT/test.host_cxt
  $ rtfind arm.cxt/Err0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Err0.rtc
  $ rtfind DeadMock0.rtc arm.cxt/
  /localhost:$PORT/test.host_cxt/DeadMock0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt
  /localhost:$PORT/test.host_cxt/arm.cxt/Broken0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Err0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/ErrStart0.rtc

-n matches the whole name against a shell pattern; -i whatever its case. Several are alternatives.

  $ rtfind / -n 'Console*'
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  $ rtfind / -n 'console*'
  $ rtfind / -i 'CONSOLE*'
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  $ rtfind / -n ConsoleIn0
  rtfind: nothing found; did you mean ConsoleIn0.rtc? The kind belongs to the name
  $ rtfind / -n ConsoleIn0 -q
  [1]
  $ rtfind / -n ConsoleIn
  $ rtfind . -n 'Console???.rtc' -n ErrStart0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/ErrStart0.rtc
  $ rtfind . --name '*.rtd' --iname=CONSOLEin0.RTC
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ rtfind . -n Err
  $ rtfind . -n '[CE]*' -n '.*' -n '*In0.rtc$'
  $ rtfind . -n 'Err*' -i 'err*'
  /localhost:$PORT/test.host_cxt/arm.cxt/Err0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/ErrStart0.rtc
  $ rtfind / -n '*_cxt' -n "local*:*"
  /localhost:$PORT
  /localhost:$PORT/test.host_cxt

-m limits how far down; 0 does not.

  $ rtfind -m 1 ../..
  /
  /localhost:$PORT
  $ rtfind --maxdepth 1 . | wc -l
  8
  $ rtfind / -m 0 | wc -l
  13
  $ rtfind / -m3 -n '*Start0.rtc'; rtfind / -m 4 -n '*Start0.rtc'
  /localhost:$PORT/test.host_cxt/arm.cxt/ErrStart0.rtc

-t wants components, directories, managers, name servers, zombies; letters add up. Only then is asked who lives.

  $ rtfind . -t c
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc
  /localhost:$PORT/test.host_cxt/SequenceOutComponent0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Broken0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Err0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/ErrStart0.rtc
  $ rtfind / -t d
  /
  /localhost:$PORT
  /localhost:$PORT/test.host_cxt
  /localhost:$PORT/test.host_cxt/arm.cxt
  $ rtfind / -t n
  /localhost:$PORT
  $ rtfind / -t m
  $ rtfind / -t z
  /localhost:$PORT/test.host_cxt/DeadMock0.rtc
  $ rtfind / --type zn -m 2
  /localhost:$PORT
  $ rtfind . -t cz -n 'DeadM*' -n 'Err0*'
  /localhost:$PORT/test.host_cxt/DeadMock0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Err0.rtc

--state wants components in that state.

  $ rtfind . --state error
  /localhost:$PORT/test.host_cxt/arm.cxt/Broken0.rtc
  $ rtact ConsoleIn0.rtc; rtfind . --state Active
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ rtfind . --state inactive -n '*In*'
  /localhost:$PORT/test.host_cxt/SequenceInComponent0.rtc
  $ rtfind . --state created --state=unknown
  $ rtfind . --state active --state error
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Broken0.rtc

Names alone ask no component anything; types one question each, states a few.

  $ ctl reset
  $ rtfind / -n '*Out*' >/dev/null
  $ rtfind . -m 1 >/dev/null
  $ rtfind / -t nd >/dev/null
  $ calls
  $ rtfind . -t z -n '*Out*'
  $ calls
  3 _non_existent
  $ ctl reset
  $ rtfind . --state inactive -n ConsoleOut1.rtc; calls
  /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  1 _non_existent
  1 get_component_state
  1 get_owned_contexts
  1 get_participating_contexts

Paths as everywhere; options may be anywhere.

  $ rtfind . -n ConsoleIn0.rtc localhost:$PORT2
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT2/test.host_cxt/ConsoleIn0.rtc
  $ RTCSH_CWD= rtfind -n ConsoleIn0.rtc localhost:$PORT2 localhost:$PORT
  /localhost:$PORT2/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ (unset RTCTREE_NAMESERVERS; rtfind /localhost:$PORT2/ -n 'C*')
  /localhost:$PORT2/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT2/test.host_cxt/ConsoleOut0.rtc
  $ RTCTREE_NAMESERVERS="localhost:$PORT;127.0.0.1:$PORT2;" rtfind / -n ConsoleIn0.rtc
  /127.0.0.1:$PORT2/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ RTCTREE_NAMESERVERS="localhost:$PORT;localhost:1;127.0.0.1:$PORT2" rtfind / -n ConsoleIn0.rtc \
  >     -n 'localhost*'
  /127.0.0.1:$PORT2/test.host_cxt/ConsoleIn0.rtc
  /localhost:1
  /localhost:$PORT
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  rtfind: /localhost:1: connection refused; is the name server running?
  [5]

-0 for xargs -0, --json for programs:

  $ rtfind -0 . -n 'Console*' | xargs -0 rtls -l
  Active    1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut1.rtc
  $ rtfind . --null -t z | tr '\0' '\n'
  /localhost:$PORT/test.host_cxt/DeadMock0.rtc
  $ rtfind --json -m 1 .. ; rtfind --json . -t z
  {"kind": "server", "path": "/localhost:$PORT"}
  {"kind": "directory", "path": "/localhost:$PORT/test.host_cxt"}
  {"kind": "zombie", "path": "/localhost:$PORT/test.host_cxt/DeadMock0.rtc"}

Whether there is anything is a matter of --quiet: 1 when not. Without it, to find nothing is no failure.

  $ rtfind . -n nothing
  $ rtfind -q . -n nothing
  [1]
  $ rtfind -q . -n 'Console*'
  $ if rtfind -q . --state error; then echo trouble; fi
  trouble

--wait looks again until there is something:

  $ rtfind --wait . -n ConsoleOut1.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc
  $ within 0.3-6 rtfind --wait=0.3 . -n nothing
  rtfind: found nothing within 0.3s
  [1]
  $ within 0.3-6 rtfind -q --wait 0.3 . -n nothing
  [1]
  $ { rtfind --wait 120 / -n Late0.rtc && rtfind --wait 120 -q / -n Late0.rtc; } & mock these ConsoleIn:Late0
  > wait
  /localhost:$PORT/test.host_cxt/Late0.rtc
  $ (rtfind --wait 120 . --state active -n ConsoleOut0.rtc) & rtact ConsoleOut0.rtc; wait
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc

What cannot be:

  $ rtfind nothing.rtc
  rtfind: /localhost:$PORT/test.host_cxt/nothing.rtc: no such path
  [3]
  $ rtfind Konsole0.rtc ConsoleOtu0.rtc arm.cxt/Err0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/Err0.rtc
  rtfind: /localhost:$PORT/test.host_cxt/Konsole0.rtc: no such path; did you mean ConsoleIn0.rtc?
  rtfind: /localhost:$PORT/test.host_cxt/ConsoleOtu0.rtc: no such path; did you mean ConsoleOut0.rtc?
  [5]
  $ rtfind ConsoleIn0.rtc/
  rtfind: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtfind ConsoleIn0.rtc:out
  rtfind: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not a directory (it is a port)
  [3]
  $ rtfind ConsoleIn0.rtc/below
  rtfind: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtfind
  rtfind: the following arguments are required: PATH (see --help)
  [2]
  $ rtfind a:b:c
  rtfind: a:b:c: a single colon separates a component from its port; write \: in a name
  [2]
  $ rtfind / -t cx
  rtfind: -t: no such type: x (there are: c, d, m, n, z) (see --help)
  [2]
  $ rtfind / --state sleepy
  rtfind: argument --state: no such state: sleepy (there are: active, inactive, error, created, unknown) (see --help)
  [2]
  $ rtfind / -m -1
  rtfind: -m: below 0: -1 (see --help)
  [2]
  $ rtfind / -m few
  rtfind: argument -m/--maxdepth: not a whole number: 'few' (see --help)
  [2]
  $ rtfind / --wait=0
  rtfind: argument --wait: not a number of seconds above 0: 0 (see --help)
  [2]
  $ rtfind / -n
  rtfind: argument -n/--name: expected one argument (see --help)
  [2]
  $ rtfind --nam ConsoleIn0.rtc /
  rtfind: unrecognized arguments: --nam (see --help)
  [2]
  $ rtfind --timeout 0 /
  rtfind: argument --timeout: not a number of seconds above 0: 0 (see --help)
  [2]
  $ rtfind /localhost:1
  rtfind: /localhost:1: connection refused; is the name server running?
  [4]
  $ rtfind localhost:1 /no-such-host.invalid
  rtfind: /localhost:1: connection refused; is the name server running?
  rtfind: /no-such-host.invalid: host name not known
  [4]

The common options:

  $ rtfind -v --timeout 20 . -n ErrStart0.rtc
  /localhost:$PORT/test.host_cxt/arm.cxt/ErrStart0.rtc
  $ rtfind --version
  1.0.0
  $ rtfind --help -v | sed -n '/^examples/,/^$/p'
  examples:
    rtfind / -n 'Console*'
    rtfind localhost -t z                       zombies
    rtfind / --state error                      components in Error
    rtfind --wait 30 -q / -n Motor0.rtc         wait until it is there
   (esc)
  $ rtfind / >/dev/full
  rtfind: No space left on device
  [1]
  $ rtfind / >&-
  rtfind: cannot write the output: Bad file descriptor
  [1]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: SERVER
invocation: SERVER --state error
invocation: --json SERVER -t z
invocation: SERVER -n none --wait 0.5
looking: --json SERVER
lasting: SERVER -n none --wait 60
broken component: 0 1
examples: asking
