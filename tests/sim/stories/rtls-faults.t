What rtls says when something does not work. Beside 15 live components, 20 others hang with their process
(it accepts connections and never answers), and 10 names are left of a process that has died.

world: many 15
world: many 20 --context test.host_cxt/Hung%n.rtc
world: many 10 --context test.host_cxt/Dead%n.rtc

  $ hang many2
  $ kill many3

The live ones are shown in full, the others marked. It takes one timeout however many hang.

  $ rtls -l --timeout 1
  -         -    -    -    -    *DeadMock0.rtc
  -         -    -    -    -    *DeadMock1.rtc
  -         -    -    -    -    *DeadMock2.rtc
  -         -    -    -    -    *DeadMock3.rtc
  -         -    -    -    -    *DeadMock4.rtc
  -         -    -    -    -    *DeadMock5.rtc
  -         -    -    -    -    *DeadMock6.rtc
  -         -    -    -    -    *DeadMock7.rtc
  -         -    -    -    -    *DeadMock8.rtc
  -         -    -    -    -    *DeadMock9.rtc
  ?         -    -    -    -    ?HungMock0.rtc
  ?         -    -    -    -    ?HungMock1.rtc
  ?         -    -    -    -    ?HungMock10.rtc
  ?         -    -    -    -    ?HungMock11.rtc
  -         -    -    -    -    ~HungMock12.rtc
  -         -    -    -    -    ~HungMock13.rtc
  -         -    -    -    -    ~HungMock14.rtc
  -         -    -    -    -    ~HungMock15.rtc
  -         -    -    -    -    ~HungMock16.rtc
  -         -    -    -    -    ~HungMock17.rtc
  -         -    -    -    -    ~HungMock18.rtc
  -         -    -    -    -    ~HungMock19.rtc
  -         -    -    -    -    ~HungMock2.rtc
  -         -    -    -    -    ~HungMock3.rtc
  -         -    -    -    -    ~HungMock4.rtc
  -         -    -    -    -    ~HungMock5.rtc
  -         -    -    -    -    ~HungMock6.rtc
  -         -    -    -    -    ~HungMock7.rtc
  -         -    -    -    -    ~HungMock8.rtc
  -         -    -    -    -    ~HungMock9.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock0.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock1.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock10.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock11.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock12.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock13.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock14.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock2.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock3.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock4.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock5.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock6.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock7.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock8.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock9.rtc
  ! rtls: 4 of 45 did not answer (HungMock0.rtc, HungMock1.rtc, HungMock10.rtc, HungMock11.rtc); 16 not asked, as the process did not answer others (HungMock12.rtc, HungMock13.rtc, HungMock14.rtc, HungMock15.rtc, HungMock16.rtc, …)
  [5] after 1.1 s
  $ rtls --timeout 0.5
  *DeadMock0.rtc
  …
  *DeadMock9.rtc
  ?HungMock0.rtc
  ?HungMock1.rtc
  ?HungMock10.rtc
  ?HungMock11.rtc
  ~HungMock12.rtc
  …
  ~HungMock9.rtc
  Mock0.rtc
  …
  [5] after 0.6 s
  $ rtls -q --timeout 0.3
  *DeadMock0.rtc
  …
  Mock9.rtc
  [5] after 0.3 s
  $ rtls --json -l --timeout 0.3
  …
  {"error": "/robot/test.host_cxt/DeadMock9.rtc: connection refused; its process is gone (zombie)", "kind": "zombie", "name": "DeadMock9.rtc", "path": "/robot/test.host_cxt/DeadMock9.rtc"}
  {"error": "/robot/test.host_cxt/HungMock0.rtc: no answer within 0.3s", "kind": "silent", "name": "HungMock0.rtc", "path": "/robot/test.host_cxt/HungMock0.rtc"}
  …
  {"error": "/robot/test.host_cxt/HungMock9.rtc: not asked: its process gave no answer within 0.3s", "kind": "unasked", "name": "HungMock9.rtc", "path": "/robot/test.host_cxt/HungMock9.rtc"}
  {"in_ports": 1, "in_ports_connected": 0, "kind": "component", "name": "Mock0.rtc", "out_ports": 1, "out_ports_connected": 0, "path": "/robot/test.host_cxt/Mock0.rtc", "ports": 2, "ports_connected": 0, "service_ports": 0, "service_ports_connected": 0, "state": "Inactive"}
  …
  [5] after 0.3 s
  $ rtls --verbose --timeout 0.3 HungMock0.rtc HungMock1.rtc Mock0.rtc
  ?HungMock0.rtc
  ?HungMock1.rtc
  Mock0.rtc
  ! rtls: /robot/test.host_cxt/HungMock0.rtc: no answer within 0.3s
  ! rtls: /robot/test.host_cxt/HungMock1.rtc: no answer within 0.3s
  ! rtls: 2 of 3 did not answer (HungMock0.rtc, HungMock1.rtc)
  [5] after 0.3 s
  $ RTSHELL_TIMEOUT=0.5 rtls -R -q /
  …
  [5] after 0.6 s
  $ RTSHELL_TIMEOUT=9 rtls --timeout 0.5
  …
  [5] after 0.6 s

A hung component by name, alone and beside another one:

  $ rtls --timeout 0.3 HungMock0.rtc
  ?HungMock0.rtc
  ! rtls: 1 of 1 did not answer (HungMock0.rtc)
  [4] after 0.3 s
  $ rtls --timeout 0.3 -l HungMock0.rtc Mock0.rtc DeadMock0.rtc
  ?         -    -    -    -    ?HungMock0.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock0.rtc
  -         -    -    -    -    *DeadMock0.rtc
  ! rtls: 1 of 3 did not answer (HungMock0.rtc)
  [5] after 0.3 s
  $ rtls --timeout 0.3 -q HungMock0.rtc
  ?HungMock0.rtc
  [4] after 0.3 s

Ctrl-C does not wait for it.

  $ interrupt 0.5 rtls -l
  [130] after 0.5 s

It may come back:

  $ wake many2
  $ rtls -l HungMock0.rtc
  Inactive  2/0  1/0  1/0  0/0  HungMock0.rtc

A mistyped name costs one look into the directory, and hangs nowhere:

  $ hang many2
  $ rtls HungMokc1.rtc
  ! rtls: /robot/test.host_cxt/HungMokc1.rtc: no such path; did you mean HungMock1.rtc?
  [3]

A name server that hangs: what is known without asking it is shown, and it costs one timeout.

  $ hang names
  $ rtls --timeout 0.3
  ! rtls: /robot: no answer within 0.3s
  [4] after 0.3 s
  $ rtls --timeout 0.3 -l Mock0.rtc
  ! rtls: /robot: no answer within 0.3s
  [4] after 0.3 s
  $ rtls --timeout 0.3 /robot /10.0.0.1
  ! rtls: /robot: no answer within 0.3s
  ! rtls: /10.0.0.1: no answer within 0.3s
  [4] after 0.3 s
  $ interrupt 0.5 rtls
  [130] after 0.5 s

Beside others, the names of which are known without asking anyone; what is in them is not.

  $ wake many2
  $ RTCTREE_NAMESERVERS='robot:1;robot'
  $ rtls /
  robot/
  robot:1/
  $ rtls -R --timeout 0.3 /
  .:
  robot/
  robot:1/

  ./robot:

  ./robot:1:

  ! rtls: /robot: no answer within 0.3s
  ! rtls: /robot:1: connection refused; is the name server running?
  [4] after 0.3 s
  $ wake names
  $ rtls -R -q --timeout 0.3 /
  …
  [5]
  $ rtls /robot:1 /robot
  /robot:
  test.host_cxt/

  ! rtls: /robot:1: connection refused; is the name server running?
  [5]
  $ rtls /robot:1
  ! rtls: /robot:1: connection refused; is the name server running?
  [4]
  $ RTCSH_CWD= rtls robot:1 /robot:1/a.cxt /robot:1/a.cxt/b.rtc
  ! rtls: /robot:1: connection refused; is the name server running?
  [4]
  $ rtls /no-such-host.invalid
  ! rtls: /no-such-host.invalid: host name not known
  [4]
  $ RTCTREE_NAMESERVERS=robot:1 rtls -R /
  .:
  robot:1/

  ./robot:1:

  ! rtls: /robot:1: connection refused; is the name server running?
  [4]
  $ RTCTREE_NAMESERVERS=robot:1 rtls -R --json /
  {"error": "/robot:1: connection refused; is the name server running?", "kind": "server", "name": "robot:1", "path": "/robot:1"}
  ! rtls: /robot:1: connection refused; is the name server running?
  [4]

What is no name server is told from one:

  $ rtcat -ll Mock0.rtc
  …
      corba.endpoints                          10.0.0.1:$PORT
  …
  $ rtls /10.0.0.1:40001
  ! rtls: /10.0.0.1:$PORT: not a name server (it is a CORBA process of another kind)
  [3]
  $ rtls /10.0.0.1:40001/a.cxt
  ! rtls: /10.0.0.1:$PORT: not a name server (it is a CORBA process of another kind)
  [3]

Two of one name are told apart:

  $ mock many 1 --context other.host_cxt/Hung%n.rtc
  $ hang many4
  $ rtls --timeout 0.3 HungMock1.rtc HungMock0.rtc ../other.host_cxt/HungMock0.rtc
  HungMock1.rtc
  HungMock0.rtc
  ?HungMock0.rtc
  ! rtls: 1 of 3 did not answer (/robot/other.host_cxt/HungMock0.rtc)
  [5] after 0.3 s

What a command computes at first, on a slow machine, is no time in which others were silent, nor is it added to what
they have:

  $ wake many2
  $ busy 0.7 rtls --timeout 0.5 Mock0.rtc
  Mock0.rtc
  [0] after 0.7 s
  $ hang names
  $ busy 0.7 rtls --timeout 1
  ! rtls: /robot: no answer within 1s
  [4] after 1.8 s
