What can go wrong with rtact, and with rtdeact and rtreset, which share all of this.

world: two
world: these Mock:Dead0 Mock:Dead1
world: these Mock:Hung0 Mock:Hung1
world: fragile
world: names --context odd.host_cxt/%n.rtc
faulty: silent garbage

Wrong usage:

  $ rtact
  rtact: the following arguments are required: PATH (see --help)
  [2]
  $ rtact --now ConsoleIn0.rtc
  rtact: unrecognized arguments: --now (see --help)
  [2]
  $ rtact --dry ConsoleIn0.rtc
  rtact: unrecognized arguments: --dry (see --help)
  [2]
  $ rtact 'a\q.rtc'
  rtact: a\q.rtc: bad escape \q
  [2]
  $ rtact ConsoleIn0.rtc:out:in
  rtact: ConsoleIn0.rtc:out:in: a single colon separates a component from its port; write \: in a name
  [2]
  $ RTCSH_CWD=nowhere rtact ConsoleIn0.rtc
  rtact: nowhere: a working directory (RTCSH_CWD) starts with /
  [2]
  $ rtact --timeout 0 ConsoleIn0.rtc
  rtact: argument --timeout: not a number of seconds above 0: 0 (see --help)
  [2]
  $ rtact --wait=soon ConsoleIn0.rtc
  rtact: argument --wait: not a number of seconds above 0: soon (see --help)
  [2]

Nothing is done when one path cannot be one:

  $ rtact ConsoleIn0.rtc ConsoleOut0.rtc:a:b
  rtact: ConsoleOut0.rtc:a:b: a single colon separates a component from its port; write \: in a name
  [2]
  $ ctl state ConsoleIn0
  INACTIVE

No such path:

  $ rtact Nope0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [3]
  $ rtact ConsolIn0.rtc
  rtact: /localhost:$PORT/test.host_cxt/ConsolIn0.rtc: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ rtact /localhost:$PORT/nowhere.host_cxt/ConsoleIn0.rtc
  rtact: /localhost:$PORT/nowhere.host_cxt: no such path
  [3]
  $ rtact ConsoleIn0.rtc/below.rtc
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]

Not a component:

  $ rtact /
  rtact: /: not a component (it is a root directory; --all takes the components in it)
  [3]
  $ rtact .
  rtact: /localhost:$PORT/test.host_cxt: not a component (it is a directory; --all takes the components in it)
  [3]
  $ rtact /localhost:$PORT
  rtact: /localhost:$PORT: not a component (it is a name server; --all takes the components in it)
  [3]
  $ rtact ConsoleIn0.rtc/
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtact ConsoleIn0.rtc:out
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not a component (it is a port)
  [3]

… among components, which are activated all the same, as beside what is not there:

  $ rtact ConsoleIn0.rtc ConsoleOut0.rtc:in . ConsoleOut0.rtc
  rtact: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: not a component (it is a port)
  rtact: /localhost:$PORT/test.host_cxt: not a component (it is a directory; --all takes the components in it)
  [5]
  $ rtls -l ConsoleIn0.rtc ConsoleOut0.rtc | cut -c 1-8
  Active\x20\x20 (esc)
  Active\x20\x20 (esc)
  $ rtdeact ConsoleOut0.rtc nosuch.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/nosuch.rtc: no such path
  [5]
  $ rtls -l ConsoleOut0.rtc | cut -c 1-8
  Inactive

What else has such a name:

  $ odd=../odd.host_cxt
  $ rtact $odd/NotAComponent0.rtc
  rtact: /localhost:$PORT/odd.host_cxt/NotAComponent0.rtc: not a component (it is a CORBA object of unknown kind)
  [3]
  $ rtact $odd/NotAManager0.mgr
  rtact: /localhost:$PORT/odd.host_cxt/NotAManager0.mgr: not a component (it is a CORBA object of unknown kind)
  [3]
  $ rtact $odd/Thing0.obj
  rtact: /localhost:$PORT/odd.host_cxt/Thing0.obj: not a component (it is a CORBA object of unknown kind)
  [3]
  $ rtact $odd/Nil0.rtc
  rtact: /localhost:$PORT/odd.host_cxt/Nil0.rtc: not a component (it is a nil reference)
  [3]
  $ rtact $odd/empty.cxt
  rtact: /localhost:$PORT/odd.host_cxt/empty.cxt: not a component (it is a directory; --all takes the components in it)
  [3]
  $ rtact $odd/Gone0.rtc
  rtact: /localhost:$PORT/odd.host_cxt/Gone0.rtc: zombie (the name is bound, but its object is gone)
  [4]

Odd names are typed as they are listed, and can be quoted from an error message:

  $ rtact -v "$odd/"'sl\/ash.rtc' "$odd/"'esc\x1b[31mred.rtc' "$odd/日本語.rtc" "$odd/"'bad\xff\xfe.rtc'
  rtact: /localhost:$PORT/odd.host_cxt/sl\/ash.rtc: accepted
  rtact: /localhost:$PORT/odd.host_cxt/esc\x1b[31mred.rtc: accepted
  rtact: /localhost:$PORT/odd.host_cxt/日本語.rtc: accepted
  rtact: /localhost:$PORT/odd.host_cxt/bad\xff\xfe.rtc: accepted
  $ rtact --dry-run "$odd/"'$(id);'"'"'"*.rtc'
  rtact '/localhost:$PORT/odd.host_cxt/$(id);'"'"'"*.rtc'
  $ rtact --dry-run "$odd/"'$(id);'"'"'"*.rtc' "$odd/"'co\:lon.rtc' "$odd/"'\e' "$odd/"'\...rtc' | sh
  $ rtact --dry-run "$odd/"'$(id);'"'"'"*.rtc' "$odd/"'co\:lon.rtc' "$odd/"'\e' "$odd/"'\...rtc'

Dead and silent peers. The dead are reported at once, the silent after --timeout, once for all of a process:

  $ kill-mock these; hang these2
  $ rtact Dead0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ within 4-7.9 rtact --timeout 4 Hung0.rtc Hung1.rtc
  rtact: /localhost:$PORT/test.host_cxt/Hung0.rtc: no answer within 4s
  rtact: /localhost:$PORT/test.host_cxt/Hung1.rtc: no answer within 4s
  [4]
  $ interrupt 0.5 rtact Hung0.rtc
  [130]
  $ RTSHELL_TIMEOUT=4 within 4-8 rtact Hung0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Hung0.rtc: no answer within 4s
  [4]
  $ RTSHELL_TIMEOUT=never rtact Hung0.rtc
  rtact: RTSHELL_TIMEOUT: not a number of seconds above 0: never (see --help)
  [2]

Several paths: all are tried, each failure is reported, and the status is 5 when something was done or when the failures differ:

  $ within 4-8 rtact --timeout 4 -v Dead0.rtc ConsoleIn0.rtc Nope0.rtc Hung0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: Active
  rtact: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  rtact: /localhost:$PORT/test.host_cxt/Hung0.rtc: no answer within 4s
  [5]
  $ ctl state ConsoleIn0
  ACTIVE
  $ rtact Nope0.rtc Nope1.rtc
  rtact: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  rtact: /localhost:$PORT/test.host_cxt/Nope1.rtc: no such path
  [3]
  $ rtact Nope0.rtc Dead0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  rtact: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  [5]
  $ rtdeact ConsoleIn0.rtc Dead0.rtc Dead1.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  rtdeact: /localhost:$PORT/test.host_cxt/Dead1.rtc: connection refused; its process is gone (zombie)
  [5]
  $ ctl state ConsoleIn0
  INACTIVE
  $ rtreset ConsoleIn0.rtc Dead0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Dead0.rtc: connection refused; its process is gone (zombie)
  [5]
  $ wake these2

A component that breaks down while it is asked:

  $ ctl fail activate_component 1 UNKNOWN; rtact ConsoleIn0.rtc
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: CORBA.UNKNOWN
  [6]
  $ ctl fail activate_component 1 COMM_FAILURE; rtact ConsoleIn0.rtc
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: connection lost
  [4]
  $ ctl fail activate_component 1 TRANSIENT; rtact ConsoleIn0.rtc
  rtact: /localhost:\$PORT/test.host_cxt/ConsoleIn0.rtc: (connection refused|cannot be reached now \(TRANSIENT_ConnectFailed\)) (re)
  [4]
  $ ctl fail activate_component 1 HANG; within 4-8 rtact --timeout 4 ConsoleIn0.rtc
  rtact: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no answer within 4s
  [4]
  $ ctl state ConsoleIn0
  INACTIVE
  $ ctl fail activate_component 1 DIE
  $ ctl fail activate_component 2 DIE
  $ rtact ConsoleIn0.rtc ConsoleOut0.rtc
  rtact: /localhost:\$PORT/test.host_cxt/ConsoleIn0.rtc: connection (lost|refused|refused; its process is gone \(zombie\)) (re)
  rtact: /localhost:\$PORT/test.host_cxt/ConsoleOut0.rtc: connection (lost|refused|refused; its process is gone \(zombie\)) (re)
  [4]

The component that dies of being asked for its profile at the wrong time is never asked:

  $ rtact -v Fragile0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Fragile0.rtc: accepted
  $ rtact -v --wait Fragile0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Fragile0.rtc: Active
  $ rtact --dry-run Fragile0.rtc
  $ ctl @fragile state Fragile0
  ACTIVE
  $ rtdeact -v --wait Fragile0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Fragile0.rtc: Inactive
  $ rtreset -v Fragile0.rtc
  rtreset: /localhost:$PORT/test.host_cxt/Fragile0.rtc: Inactive
  $ rtdeact --dry-run Fragile0.rtc
  $ ctl @fragile state Fragile0
  INACTIVE

Name servers: nobody listens on one, and ours falls silent:

  $ rtact /localhost:1/a.host_cxt/ConsoleIn0.rtc
  rtact: /localhost:1: connection refused; is the name server running?
  [4]
  $ rtact /localhost:99999/ConsoleIn0.rtc
  rtact: /localhost:99999/ConsoleIn0.rtc: 99999 is not a TCP port (1 to 65535)
  [2]
  $ within 0.4-1.4 rtact --timeout 0.5 /localhost:$SILENT/ConsoleIn0.rtc
  rtact: /localhost:$SILENT: no answer within 0.5s
  [4]
  $ within 0-3.9 rtact --timeout 4 /localhost:$GARBAGE/ConsoleIn0.rtc
  rtact: /localhost:\$GARBAGE: (connection lost|garbled answer \(not GIOP\)) (re)
  [4]
  $ hang names
  $ within 0.4-1.4 rtact --timeout 0.5 ConsoleIn0.rtc Fragile0.rtc
  rtact: /localhost:$PORT: no answer within 0.5s
  [4]
