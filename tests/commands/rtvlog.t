rtvlog shows the log of components that take loggers, as it is written.

world: observed
world: these ConsoleIn:Plain0 --flavour cpp2
world: these Motor:Other0 --flavour cpp2 --context other.host_cxt/Motor0.rtc
world: observed --flavour cpp2 --context cpp.host_cxt/%n.rtc
world: hung 1 --context hung.host_cxt/%n.rtc

  $ logged() { soon "ctl observers Motor0 | grep Logger"; }

Records up to level NORMAL, or another; of all sources, or some. The level may be written small, and a component named twice:

  $ rtvlog -n 2 Motor0.rtc ./Motor0.rtc > out & logged
  $ ctl log Motor0 DEBUG motor secret
  $ ctl log Motor0 ERROR motor "it is hot"
  $ ctl log Motor0 INFO arm "it is warm"
  $ wait; plain out
  [Motor0.rtc T] ERROR <motor> it is hot
  [Motor0.rtc T] INFO <arm> it is warm
  $ rtvlog -n 2 -l debug -f arm -f hand Motor0.rtc > out & logged
  $ ctl log Motor0 ERROR motor hot
  $ ctl log Motor0 DEBUG arm cold
  $ ctl log Motor0 TRACE arm cold
  $ ctl log Motor0 WARN hand wet
  $ wait; plain out
  [Motor0.rtc T] DEBUG <arm> cold
  [Motor0.rtc T] WARN <hand> wet

A line is a line, and harms no terminal:

  $ rtvlog -n 1 Motor0.rtc > out & logged
  $ ctl log Motor0 WARN "$(printf 'a\033[2J')" "$(printf 'two\tlines\\')"
  $ wait
  $ plain out
  [Motor0.rtc T] WARN <a\x1b[2J> two\x09lines\\
  $ rtvlog --json -n 1 Motor0.rtc > out & logged
  $ ctl log Motor0 WARN "$(printf 'a\033[2J')" "$(printf 'two\tlines\\')"
  $ wait
  $ plain out
  {"level": "WARN", "logger": "a\u001b[2J", "message": "two\tlines\\", "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "time": T}

Each is written at once, and what ends the command leaves nothing behind:

  $ interrupt 1 rtvlog Motor0.rtc
  [130]
  $ echo $?
  130
  $ ctl observers Motor0
  $ for signal in TERM HUP; do
  >     rtvlog Motor0.rtc > out <&- & log=$!; logged; ctl log Motor0 WARN motor hot; soon 'grep hot out'
  >     kill -$signal $log; wait $log; echo $?; ctl observers Motor0
  > done
  143
  129
  $ (rtvlog Motor0.rtc; echo $? >&2) | true
  141
  $ ctl observers Motor0

One of C++ takes a logger, and never writes to it; rtvlog says why nothing comes:

  $ rtvlog ../cpp.host_cxt/Motor0.rtc > out 2> said & log=$!
  $ soon "ctl @observed2 observers Motor0 | grep Logger"; soon 'grep Motor0 said'
  $ ctl @observed2 log Motor0 ERROR motor hot
  $ kill $log; wait $log
  [143]
  $ cat out said
  rtvlog: /localhost:$PORT/cpp.host_cxt/Motor0.rtc: takes a logger, but components of C++ (up to 2.1) write nothing to it

A component that takes no loggers, as most do not; one beside it is not disturbed:

  $ rtvlog ConsoleIn0.rtc
  rtvlog: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: takes no loggers
  [6]
  $ rtvlog -t 0.3 ConsoleIn0.rtc Motor0.rtc Plain0.rtc
  rtvlog: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: takes no loggers
  rtvlog: /localhost:$PORT/test.host_cxt/Plain0.rtc: takes no loggers
  [5]
  $ ctl calls ConsoleIn0 | grep service
  [1]
  $ rtvlog --timeout 2 ../hung.host_cxt/Mock0.rtc
  rtvlog: /localhost:$PORT/hung.host_cxt/Mock0.rtc: no answer within 2s
  [4]
  $ rtvlog .
  rtvlog: /localhost:$PORT/test.host_cxt: not a component (it is a directory; rtfind /localhost:$PORT/test.host_cxt -t c prints the components in it)
  [3]
  $ rtvlog MotorO.rtc
  rtvlog: /localhost:$PORT/test.host_cxt/MotorO.rtc: no such path; did you mean Motor0.rtc?
  [3]
  $ rtvlog -n 1 -t 0.3 Motor0.rtc
  rtvlog: /localhost:$PORT/test.host_cxt/Motor0.rtc: 0 of 1 within 0.3s
  [1]

One that ends is reported on stderr:

  $ rtvlog Motor0.rtc > out 2> err & log=$!; logged
  $ rtexit Motor0.rtc
  $ soon 'grep exited err'
  $ kill $log; wait $log
  [143]
  $ cat err
  rtvlog: /localhost:$PORT/test.host_cxt/Motor0.rtc: has exited

Wrong usage:

  $ rtvlog
  rtvlog: nothing to show: no component specified; --listen receives what is sent (see --help)
  [2]
  $ rtvlog -l LOUD Motor0.rtc
  rtvlog: argument -l/--level: not one of SILENT, FATAL, ERROR, WARN, INFO, NORMAL, DEBUG, TRACE, VERBOSE, PARANOID: LOUD (see --help)
  [2]
  $ rtvlog -n x Motor0.rtc
  rtvlog: argument -n/--number: not a whole number: 'x' (see --help)
  [2]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -t 0.5 A
lasting: A
examples: endless
prepared: world observed
