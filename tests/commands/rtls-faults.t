What rtls says when something does not work. Beside 15 live components, 20 others hang with their process
(it accepts connections and never answers), and 10 names are left of a process that has died.

world: many 15
world: hung 20 --context test.host_cxt/Hung%n.rtc
world: zombie 10 --context test.host_cxt/Dead%n.rtc
alone: it measures
both: each ORB waits in its own way

The live ones are shown in full, the others marked. It takes one timeout however many hang.

  $ within 1-1.5 rtls -l --timeout 1
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
  rtls: 4 of 45 did not answer (HungMock0.rtc, HungMock1.rtc, HungMock10.rtc, HungMock11.rtc); 16 not asked, as the process did not answer others (HungMock12.rtc, HungMock13.rtc, HungMock14.rtc, HungMock15.rtc, HungMock16.rtc, …)
  [5]
  $ within 0.5-1 rtls --timeout 0.5 2>&1 | head -n 13
  *DeadMock0.rtc
  *DeadMock1.rtc
  *DeadMock2.rtc
  *DeadMock3.rtc
  *DeadMock4.rtc
  *DeadMock5.rtc
  *DeadMock6.rtc
  *DeadMock7.rtc
  *DeadMock8.rtc
  *DeadMock9.rtc
  ?HungMock0.rtc
  ?HungMock1.rtc
  ?HungMock10.rtc
  $ rtls -q --timeout 0.3 | sort | sed 's/[0-9]*[.]rtc//' | uniq -c | awk '{print $1, $2}'
  10 *DeadMock
  4 ?HungMock
  15 Mock
  16 ~HungMock
  $ rtls --json -l --timeout 0.3 2>note | python3 -c 'import collections, json, sys
  > found = [json.loads(line) for line in sys.stdin]
  > print(sorted(collections.Counter((one["kind"], one.get("state")) for one in found).items(), key=str))
  > print(found[10]["error"], found[25]["error"], sep="\n")'; cat note
  [(('component', 'Inactive'), 15), (('silent', None), 4), (('unasked', None), 16), (('zombie', None), 10)]
  /localhost:$PORT/test.host_cxt/HungMock0.rtc: no answer within 0.3s
  /localhost:$PORT/test.host_cxt/HungMock5.rtc: not asked: its process gave no answer within 0.3s
  rtls: 4 of 45 did not answer (HungMock0.rtc, HungMock1.rtc, HungMock10.rtc, HungMock11.rtc); 16 not asked, as the process did not answer others (HungMock12.rtc, HungMock13.rtc, HungMock14.rtc, HungMock15.rtc, HungMock16.rtc, …)
  $ rtls --verbose --timeout 0.3 HungMock0.rtc HungMock1.rtc Mock0.rtc
  ?HungMock0.rtc
  ?HungMock1.rtc
  Mock0.rtc
  rtls: /localhost:$PORT/test.host_cxt/HungMock0.rtc: no answer within 0.3s
  rtls: /localhost:$PORT/test.host_cxt/HungMock1.rtc: no answer within 0.3s
  rtls: 2 of 3 did not answer (HungMock0.rtc, HungMock1.rtc)
  [5]
  $ RTSHELL_TIMEOUT=0.5 within 0.5-1 rtls -R / >/dev/null
  rtls: 4 of 45 did not answer (HungMock0.rtc, HungMock1.rtc, HungMock10.rtc, HungMock11.rtc); 16 not asked, as the process did not answer others (HungMock12.rtc, HungMock13.rtc, HungMock14.rtc, HungMock15.rtc, HungMock16.rtc, …)
  [5]
  $ RTSHELL_TIMEOUT=9 within 0.5-1 rtls --timeout 0.5 -0 | tr '\0' '\n' | grep -c Hung
  rtls: 4 of 45 did not answer (HungMock0.rtc, HungMock1.rtc, HungMock10.rtc, HungMock11.rtc); 16 not asked, as the process did not answer others (HungMock12.rtc, HungMock13.rtc, HungMock14.rtc, HungMock15.rtc, HungMock16.rtc, …)
  20

A hung component by name, alone and beside another one:

  $ within 0.3-0.8 rtls --timeout 0.3 HungMock0.rtc
  ?HungMock0.rtc
  rtls: 1 of 1 did not answer (HungMock0.rtc)
  [4]
  $ within 0.3-0.8 rtls --timeout 0.3 -l HungMock0.rtc Mock0.rtc DeadMock0.rtc
  ?         -    -    -    -    ?HungMock0.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock0.rtc
  -         -    -    -    -    *DeadMock0.rtc
  rtls: 1 of 3 did not answer (HungMock0.rtc)
  [5]
  $ within 0.3-0.8 rtls --timeout 0.3 -q HungMock0.rtc
  ?HungMock0.rtc
  [4]

Ctrl-C does not wait for it.

  $ interrupt 0.5 rtls -l
  [130]

It may come back:

  $ wake hung
  $ rtls -l HungMock0.rtc
  Inactive  2/0  1/0  1/0  0/0  HungMock0.rtc

A mistyped name costs one look into the directory, and hangs nowhere:

  $ hang hung
  $ within 0-0.5 rtls HungMokc1.rtc
  rtls: /localhost:$PORT/test.host_cxt/HungMokc1.rtc: no such path; did you mean HungMock1.rtc?
  [3]

Name servers: one where nothing listens, one that never answers, and something that is no name server.

  $ rtls localhost:1
  rtls: /localhost:1: connection refused; is the name server running?
  [4]
  $ RTCSH_CWD= rtls localhost:1 /localhost:1/a.cxt /localhost:1/a.cxt/b.rtc
  rtls: /localhost:1: connection refused; is the name server running?
  [4]
  $ RTCSH_CWD=/ rtls no-such-host.invalid
  rtls: /no-such-host.invalid: host name not known
  [4]
  $ component=$(rtcat -ll Mock0.rtc | awk '$1 == "corba.endpoints" {print $2}')
  $ RTCSH_CWD=/ rtls $component 2>&1 | sed "s/$component/HOST:PORT/g"
  rtls: /HOST:PORT: not a name server (it is a CORBA process of another kind)
  $ RTCSH_CWD=/ rtls $component/a.cxt 2>&1 | sed "s/$component/HOST:PORT/g"
  rtls: /HOST:PORT: not a name server (it is a CORBA process of another kind)

The names of name servers are known without asking anyone; what is in them is not.

  $ export RTCTREE_NAMESERVERS="localhost:1;localhost:$PORT"
  $ rtls /
  localhost:1/
  localhost:$PORT/
  $ rtls -R -q --timeout 0.3 / | grep -v Mock
  rtls: /localhost:1: connection refused; is the name server running?
  .:
  localhost:1/
  localhost:$PORT/

  ./localhost:1:

  ./localhost:$PORT:
  test.host_cxt/

  ./localhost:$PORT/test.host_cxt:
   (esc)
  $ rtls -R -q --timeout 0.3 / >/dev/null
  rtls: /localhost:1: connection refused; is the name server running?
  [5]
  $ rtls -0 / | xargs -0 rtls
  rtls: /localhost:1: connection refused; is the name server running?
  /localhost:$PORT:
  test.host_cxt/

  [123]
  $ RTCSH_CWD=/ rtls localhost:1 localhost:$PORT
  rtls: /localhost:1: connection refused; is the name server running?
  localhost:$PORT:
  test.host_cxt/

  [5]
  $ RTCTREE_NAMESERVERS=localhost:1 rtls -R /
  .:
  localhost:1/

  ./localhost:1:

  rtls: /localhost:1: connection refused; is the name server running?
  [4]
  $ RTCTREE_NAMESERVERS=localhost:1 rtls -R --json /
  {"error": "/localhost:1: connection refused; is the name server running?", "kind": "server", "name": "localhost:1", "path": "/localhost:1"}
  rtls: /localhost:1: connection refused; is the name server running?
  [4]
  $ hang names
  $ within 0.3-0.8 rtls --timeout 0.3
  rtls: /localhost:$PORT: no answer within 0.3s
  [4]
  $ within 0.3-0.8 rtls --timeout 0.3 -l Mock0.rtc
  rtls: /localhost:$PORT: no answer within 0.3s
  [4]
  $ within 0.3-0.8 rtls --timeout 0.3 -R /
  .:
  localhost:1/
  localhost:$PORT/

  ./localhost:1:

  ./localhost:$PORT:

  rtls: /localhost:1: connection refused; is the name server running?
  rtls: /localhost:$PORT: no answer within 0.3s
  [4]
  $ within 0.3-0.8 rtls --timeout 0.3 /localhost:$PORT /127.0.0.1:$PORT
  rtls: /localhost:$PORT: no answer within 0.3s
  rtls: /127.0.0.1:$PORT: no answer within 0.3s
  [4]
  $ rtls /
  localhost:1/
  localhost:$PORT/
  $ interrupt 0.5 rtls
  [130]
  $ wake names
