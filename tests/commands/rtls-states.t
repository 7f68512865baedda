The states that rtls -l shows, and the ports it counts.

world: error
world: contexts
world: services
world: fragile
world: these Slow

Components in Error, in one of several contexts, with service ports, and two sorts of neighbours of the dead:
Fragile0 was connected to Peer0, whose process was killed, and does not survive being asked carelessly.

  $ rtls -l
  Error     1/0  0/0  1/0  0/0  Broken0.rtc
  Inactive  2/0  1/0  1/0  0/0  Driver0.rtc
  Inactive  1/0  0/0  1/0  0/0  Err0.rtc
  Inactive  0/0  0/0  0/0  0/0  ErrStart0.rtc
  Inactive  1/0  0/0  1/0  0/0  Fragile0.rtc
  Inactive  2/0  1/0  1/0  0/0  Multi0.rtc
  Inactive  1/0  0/0  0/0  1/0  MyServiceConsumer0.rtc
  Inactive  1/0  0/0  0/0  1/0  MyServiceProvider0.rtc
  -         -    -    -    -    *Peer0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
  $ rtact Driver0.rtc MyServiceConsumer0.rtc
  $ rtact Err0.rtc 2> or-in-error; rtfind --wait -q --state error Err0.rtc
  $ rtls -l | grep -v Inactive
  Error     1/0  0/0  1/0  0/0  Broken0.rtc
  Active    2/0  1/0  1/0  0/0  Driver0.rtc
  Error     1/0  0/0  1/0  0/0  Err0.rtc
  Active    1/0  0/0  0/0  1/0  MyServiceConsumer0.rtc
  -         -    -    -    -    *Peer0.rtc

A component is shown in the state that matters most, of all those it has in the contexts that it takes part in:

  $ rtact -e 2 Multi0.rtc; rtls -l Multi0.rtc
  Active  2/0  1/0  1/0  0/0  Multi0.rtc

A port that is connected twice counts once. The connection to the dead is gone since the first question: a
component checks its connections when it is asked for a port. Fragile0 has survived that.

  $ rtcon Slow0.rtc:out Driver0.rtc:in; rtcon Slow0.rtc:out Multi0.rtc:in
  $ rtls -l Slow0.rtc Fragile0.rtc
  Inactive  1/1  0/0  1/1  0/0  Slow0.rtc
  Inactive  1/0  0/0  1/0  0/0  Fragile0.rtc
  $ ctl @fragile components
  Fragile0

A component that fails to answer with one of the figures:

  $ ctl @these fail get_ports 1 NO_IMPLEMENT; rtls -l -v Slow0.rtc
  Inactive  ?  ?  ?  ?  Slow0.rtc
  rtls: /localhost:$PORT/test.host_cxt/Slow0.rtc: CORBA.NO_IMPLEMENT
  rtls: 1 of 1 did not report the ports (Slow0.rtc)
  [5]
  $ ctl @these fail get_owned_contexts 1 INV_OBJREF; rtls -lv Slow0.rtc
  ?  -  -  -  -  ?Slow0.rtc
  rtls: /localhost:$PORT/test.host_cxt/Slow0.rtc: garbled answer (CORBA.INV_OBJREF)
  rtls: 1 of 1 did not answer (Slow0.rtc)
  [4]
  $ ctl @these fail get_port_profile 1 TRANSIENT; rtls -lv Slow0.rtc
  Inactive  1/1  0/0  1/1  0/0  Slow0.rtc
  $ ctl @these fail get_component_state 1 UNKNOWN; rtls -l --json Slow0.rtc
  {"error": "/localhost:$PORT/test.host_cxt/Slow0.rtc: CORBA.UNKNOWN", "kind": "silent", "name": "Slow0.rtc", "path": "/localhost:$PORT/test.host_cxt/Slow0.rtc"}
  rtls: 1 of 1 did not answer (Slow0.rtc)
  [6]
  $ ctl @these fail get_ports 1 OBJECT_NOT_EXIST; rtls -lv Slow0.rtc
  Inactive  ?  ?  ?  ?  Slow0.rtc
  rtls: /localhost:$PORT/test.host_cxt/Slow0.rtc: does not report its ports or states (one of them is gone)
  rtls: 1 of 1 did not report the ports (Slow0.rtc)
  [5]
  $ ctl @these fail _non_existent 1 UNKNOWN; rtls -v Slow0.rtc
  ?Slow0.rtc
  rtls: /localhost:$PORT/test.host_cxt/Slow0.rtc: CORBA.UNKNOWN
  rtls: 1 of 1 did not answer (Slow0.rtc)
  [6]
  $ ctl @these fail get_port_profile 1 DIE; rtls -lv Slow0.rtc MyServiceProvider0.rtc
  Inactive  ?    ?    ?    ?    Slow0.rtc
  Inactive  1/0  0/0  0/0  1/0  MyServiceProvider0.rtc
  rtls: /localhost:\$PORT/test.host_cxt/Slow0.rtc: (does not report its ports or states \(connection refused\)|connection lost) (re)
  rtls: 1 of 2 did not report the ports (Slow0.rtc)
  [5]
