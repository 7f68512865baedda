rtfsm shows and changes the state machine of a component, by the service of FSM4RTC.

world: fsm --flavour py2
world: fsm dies --flavour cpp2 --context dies.host_cxt/%n.rtc
world: fsm keeps --flavour cpp2 --context keeps.host_cxt/%n.rtc
world: fsm refuses --flavour cpp2 --context refuses.host_cxt/%n.rtc
world: these ConsoleIn
world: zombie 1
world: hung 1 --context hung.host_cxt/%n.rtc

Its state, its events, its structure. The service is taken from the list of all: asking for it by its id ends components
of C++.

  $ rtfsm Microwave0.rtc getstate
  closed
  $ ctl fsm Microwave0 cooking
  $ rtfsm getstate Microwave0.rtc; rtfsm Microwave0.rtc getstate
  rtfsm: the path comes first: Microwave0.rtc getstate … (see --help)
  cooking
  $ rtfsm Microwave0.rtc geteventprofiles
  open:TimedLong, close:TimedLong, start:TimedLong, stop:TimedLong
  $ rtfsm Microwave0.rtc getstructure
  <scxml xmlns="http://www.w3.org/2005/07/scxml" version="1.0" name="Microwave" initial="closed">
    <state id="closed"><transition event="open" target="opened"/><transition event="start" target="cooking"/></state>
    <state id="opened"><transition event="close" target="closed"/></state>
    <state id="cooking"><transition event="stop" target="closed"/><transition event="open" target="opened"/></state>
  </scxml>
  $ rtfsm ../dies.host_cxt/Microwave0.rtc getstate
  closed
  $ ctl @fsm2 calls
  1 get_current_state
  1 get_service_profiles

As JSON:

  $ rtfsm --json Microwave0.rtc getstate
  {"path": "/localhost:$PORT/test.host_cxt/Microwave0.rtc", "state": "cooking"}
  $ rtfsm --json Microwave0.rtc geteventprofiles
  {"event_profiles": [{"data_type": "TimedLong", "name": "open"}, {"data_type": "TimedLong", "name": "close"}, {"data_type": "TimedLong", "name": "start"}, {"data_type": "TimedLong", "name": "stop"}], "name": "Microwave", "path": "/localhost:$PORT/test.host_cxt/Microwave0.rtc", "properties": {}, "structure": "<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" version=\"1.0\" name=\"Microwave\" initial=\"closed\">\n  <state id=\"closed\"><transition event=\"open\" target=\"opened\"/><transition event=\"start\" target=\"cooking\"/></state>\n  <state id=\"opened\"><transition event=\"close\" target=\"closed\"/></state>\n  <state id=\"cooking\"><transition event=\"stop\" target=\"closed\"/><transition event=\"open\" target=\"opened\"/></state>\n</scxml>\n"}

Another structure; what getstructure printed can be given back as it was:

  $ rtfsm Microwave0.rtc getstructure > before.scxml
  $ printf '<scxml name="Toaster">\n\t<state id="\303\244\302\240"/></scxml>' > toaster.scxml
  $ rtfsm -v --dry-run Microwave0.rtc setstructure toaster.scxml
  rtfsm /localhost:$PORT/test.host_cxt/Microwave0.rtc setstructure toaster.scxml
  $ rtfsm Microwave0.rtc getstructure | cmp - before.scxml
  $ rtfsm -v Microwave0.rtc setstructure toaster.scxml
  rtfsm: /localhost:$PORT/test.host_cxt/Microwave0.rtc: changed
  $ rtfsm -v Microwave0.rtc setstructure toaster.scxml
  rtfsm: /localhost:$PORT/test.host_cxt/Microwave0.rtc: as it was
  $ rtfsm Microwave0.rtc getstructure | cmp - toaster.scxml
  $ rtfsm Microwave0.rtc setstructure - < before.scxml
  $ rtfsm Microwave0.rtc getstructure | cmp - before.scxml

Other events, the type as a name or as an id, blanks as geteventprofiles prints them:

  $ rtfsm --dry-run Microwave0.rtc seteventprofiles 'toggle:TimedShort, open:IDL:RTC/TimedLong:1.0'
  rtfsm /localhost:$PORT/test.host_cxt/Microwave0.rtc seteventprofiles 'toggle:TimedShort, open:IDL:RTC/TimedLong:1.0'
  $ rtfsm -v Microwave0.rtc seteventprofiles 'toggle:TimedShort, open:IDL:RTC/TimedLong:1.0'
  rtfsm: /localhost:$PORT/test.host_cxt/Microwave0.rtc: changed
  $ rtfsm Microwave0.rtc geteventprofiles
  toggle:TimedShort, open:IDL:RTC/TimedLong:1.0
  $ rtfsm -v --dry-run Microwave0.rtc seteventprofiles toggle:TimedShort,open:IDL:RTC/TimedLong:1.0
  $ rtfsm Microwave0.rtc getstructure | cmp - before.scxml

A terminal is not harmed, whatever the machine says:

  $ ctl fsm Microwave0 "$(printf 'a\033[2J\\b')"
  $ rtfsm Microwave0.rtc getstate
  a\x1b[2J\\b
  $ printf '<a>\033[2J\t\\<\n</a>\n' > hostile.scxml; rtfsm Microwave0.rtc setstructure hostile.scxml
  $ terminal 80 rtfsm Microwave0.rtc getstructure
  <a>\x1b[2J \<
  </a>
  $ rtfsm Microwave0.rtc getstructure | cmp - hostile.scxml

What goes wrong. A machine that says RTC_OK and changes nothing, and one that refuses:

  $ rtfsm ../keeps.host_cxt/Microwave0.rtc setstructure toaster.scxml
  rtfsm: /localhost:$PORT/keeps.host_cxt/Microwave0.rtc: does not take it (RTC_OK but unchanged)
  [6]
  $ rtfsm ../refuses.host_cxt/Microwave0.rtc seteventprofiles a:TimedLong
  rtfsm: /localhost:$PORT/refuses.host_cxt/Microwave0.rtc: does not take it (UNSUPPORTED)
  [6]

A component without the service, or none, or none that answers:

  $ rtfsm ConsoleIn0.rtc getstate
  rtfsm: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such SDO service: ExtendedFsmService (it is not a state machine of FSM4RTC)
  [3]
  $ rtfsm Microwav0.rtc getstate
  rtfsm: /localhost:$PORT/test.host_cxt/Microwav0.rtc: no such path; did you mean Microwave0.rtc?
  [3]
  $ rtfsm Mock0.rtc getstructure
  rtfsm: /localhost:$PORT/test.host_cxt/Mock0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtfsm --timeout 4 ../hung.host_cxt/Mock0.rtc seteventprofiles a:TimedLong
  rtfsm: /localhost:$PORT/hung.host_cxt/Mock0.rtc: no answer within 4s
  [4]
  $ rtfsm Microwave0.rtc:event getstate
  rtfsm: /localhost:$PORT/test.host_cxt/Microwave0.rtc:event: not a component (it is a port)
  [3]
  $ rtfsm .. getstate
  rtfsm: /localhost:$PORT: not a component (it is a name server)
  [3]
  $ ctl fail get_fsm_structure 1 UNKNOWN
  $ rtfsm Microwave0.rtc getstructure
  rtfsm: /localhost:$PORT/test.host_cxt/Microwave0.rtc: CORBA.UNKNOWN
  [6]
  $ ctl fail get_current_state 1 TRANSIENT
  $ rtfsm Microwave0.rtc getstate
  rtfsm: /localhost:\$PORT/test.host_cxt/Microwave0.rtc: (connection refused|cannot be reached now \(TRANSIENT_ConnectFailed\)) (re)
  [4]

The file:

  $ rtfsm Microwave0.rtc setstructure nofile
  rtfsm: nofile: No such file or directory
  [1]
  $ printf 'a\0b' > nul; rtfsm Microwave0.rtc setstructure nul
  rtfsm: nul: holds a NUL character, which cannot be sent
  [1]
  $ head -c 1048577 /dev/zero | tr '\0' x > large; rtfsm Microwave0.rtc setstructure large
  rtfsm: large: more than 1 MiB
  [1]
  $ head -c 1048576 large > whole; rtfsm -v Microwave0.rtc setstructure whole
  rtfsm: /localhost:$PORT/test.host_cxt/Microwave0.rtc: changed
  $ rtfsm Microwave0.rtc getstructure | cmp - whole
  $ rtfsm Microwave0.rtc setstructure - < /dev/null
  rtfsm: -: is empty: the state machine would be lost
  [1]
  $ rtfsm Microwave0.rtc setstructure - <&-
  rtfsm: -: there is no standard input
  [1]

Wrong usage is found before anything is asked:

  $ ctl reset
  $ rtfsm Microwave0.rtc
  rtfsm: the following arguments are required: COMMAND (see --help)
  [2]
  $ rtfsm Microwave0.rtc explode
  rtfsm: no such command: explode (there are: getstate, geteventprofiles, getstructure, seteventprofiles, setstructure) (see --help)
  [2]
  $ rtfsm Microwave0.rtc seteventprofiles
  rtfsm: seteventprofiles: no argument given (see --help)
  [2]
  $ rtfsm Microwave0.rtc getstate now
  rtfsm: getstate: too many arguments (see --help)
  [2]
  $ rtfsm Microwave0.rtc setstructure a b
  rtfsm: setstructure: too many arguments (see --help)
  [2]
  $ rtfsm Microwave0.rtc seteventprofiles bad
  rtfsm: seteventprofiles: not NAME:TYPE: bad (see --help)
  [2]
  $ rtfsm Microwave0.rtc seteventprofiles 'a:TimedLong,,b:TimedLong'
  rtfsm: seteventprofiles: not NAME:TYPE: '' (see --help)
  [2]
  $ rtfsm Microwave0.rtc seteventprofiles a:
  rtfsm: seteventprofiles: not NAME:TYPE: a: (see --help)
  [2]
  $ ctl calls

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A getstate
invocation: A getstructure
invocation: A seteventprofiles a:TimedLong
looking: A getstate
