Calls that wait for a third party hide nothing: a process of ten components, four of them connected with one that hangs, one in Error.

hosts: robot desk
seat: desk
world: these Mock:In0 Mock:In1 Mock:In2 Mock:In3 Mock:In4 Mock:In5 Mock:In6 Mock:In7 Mock:In8 Err:In9 --context near.host_cxt/%n.rtc
world: these Mock:Out0 --context far.host_cxt/%n.rtc

  $ RTCSH_CWD=/robot/near.host_cxt
  $ rtcon ../far.host_cxt/Out0.rtc:out In0.rtc:in
  $ rtcon ../far.host_cxt/Out0.rtc:out In1.rtc:in
  $ rtcon ../far.host_cxt/Out0.rtc:out In2.rtc:in
  $ rtcon ../far.host_cxt/Out0.rtc:out In3.rtc:in
  $ rtact In9.rtc
  $ sleep 1
  $ hang these2

All are asked for their states before the first is asked for its ports, and two calls at most wait for others:

  $ rtls -l --timeout 1
  Inactive  ?  ?  ?  ?  In0.rtc
  Inactive  ?  ?  ?  ?  In1.rtc
  Inactive  -  -  -  -  In2.rtc
  Inactive  -  -  -  -  In3.rtc
  Inactive  -  -  -  -  In4.rtc
  Inactive  -  -  -  -  In5.rtc
  Inactive  -  -  -  -  In6.rtc
  Inactive  -  -  -  -  In7.rtc
  Inactive  -  -  -  -  In8.rtc
  Error     -  -  -  -  In9.rtc
  ! rtls: 2 of 10 did not report the ports (In0.rtc, In1.rtc); 8 not asked for the ports, as others of the process hang when asked (In2.rtc, In3.rtc, In4.rtc, In5.rtc, In6.rtc, …)
  [5] after 1.1 s
  $ rtls -l --json --timeout 1
  {"error": "/robot/near.host_cxt/In0.rtc: no answer within 1s", "kind": "component", "name": "In0.rtc", "path": "/robot/near.host_cxt/In0.rtc", "state": "Inactive"}
  {"error": "/robot/near.host_cxt/In1.rtc: no answer within 1s", "kind": "component", "name": "In1.rtc", "path": "/robot/near.host_cxt/In1.rtc", "state": "Inactive"}
  {"error": "/robot/near.host_cxt/In2.rtc: not asked: questions like it got no answer within 1s from its process", "kind": "component", "name": "In2.rtc", "path": "/robot/near.host_cxt/In2.rtc", "state": "Inactive"}
  {"error": "/robot/near.host_cxt/In3.rtc: not asked: questions like it got no answer within 1s from its process", "kind": "component", "name": "In3.rtc", "path": "/robot/near.host_cxt/In3.rtc", "state": "Inactive"}
  {"error": "/robot/near.host_cxt/In4.rtc: not asked: questions like it got no answer within 1s from its process", "kind": "component", "name": "In4.rtc", "path": "/robot/near.host_cxt/In4.rtc", "state": "Inactive"}
  {"error": "/robot/near.host_cxt/In5.rtc: not asked: questions like it got no answer within 1s from its process", "kind": "component", "name": "In5.rtc", "path": "/robot/near.host_cxt/In5.rtc", "state": "Inactive"}
  {"error": "/robot/near.host_cxt/In6.rtc: not asked: questions like it got no answer within 1s from its process", "kind": "component", "name": "In6.rtc", "path": "/robot/near.host_cxt/In6.rtc", "state": "Inactive"}
  {"error": "/robot/near.host_cxt/In7.rtc: not asked: questions like it got no answer within 1s from its process", "kind": "component", "name": "In7.rtc", "path": "/robot/near.host_cxt/In7.rtc", "state": "Inactive"}
  {"error": "/robot/near.host_cxt/In8.rtc: not asked: questions like it got no answer within 1s from its process", "kind": "component", "name": "In8.rtc", "path": "/robot/near.host_cxt/In8.rtc", "state": "Inactive"}
  {"error": "/robot/near.host_cxt/In9.rtc: not asked: questions like it got no answer within 1s from its process", "kind": "component", "name": "In9.rtc", "path": "/robot/near.host_cxt/In9.rtc", "state": "Error"}
  ! rtls: 2 of 10 did not report the ports (In0.rtc, In1.rtc); 8 not asked for the ports, as others of the process hang when asked (In2.rtc, In3.rtc, In4.rtc, In5.rtc, In6.rtc, …)
  [5] after 1.1 s
  $ rtls --timeout 1
  In0.rtc
  In1.rtc
  In2.rtc
  In3.rtc
  In4.rtc
  In5.rtc
  In6.rtc
  In7.rtc
  In8.rtc
  In9.rtc

A process that hangs itself: four of its components were asked. What was not asked is not called silent:

  $ hang these
  $ rtls -l --timeout 1
  ?  -  -  -  -  ?In0.rtc
  ?  -  -  -  -  ?In1.rtc
  ?  -  -  -  -  ?In2.rtc
  ?  -  -  -  -  ?In3.rtc
  -  -  -  -  -  ~In4.rtc
  -  -  -  -  -  ~In5.rtc
  -  -  -  -  -  ~In6.rtc
  -  -  -  -  -  ~In7.rtc
  -  -  -  -  -  ~In8.rtc
  -  -  -  -  -  ~In9.rtc
  ! rtls: 4 of 10 did not answer (In0.rtc, In1.rtc, In2.rtc, In3.rtc); 6 not asked, as the process did not answer others (In4.rtc, In5.rtc, In6.rtc, In7.rtc, In8.rtc, …)
  [4] after 1.1 s
  $ rtls --json --timeout 1 .
  {"error": "/robot/near.host_cxt/In0.rtc: no answer within 1s", "kind": "silent", "name": "In0.rtc", "path": "/robot/near.host_cxt/In0.rtc"}
  {"error": "/robot/near.host_cxt/In1.rtc: no answer within 1s", "kind": "silent", "name": "In1.rtc", "path": "/robot/near.host_cxt/In1.rtc"}
  {"error": "/robot/near.host_cxt/In2.rtc: no answer within 1s", "kind": "silent", "name": "In2.rtc", "path": "/robot/near.host_cxt/In2.rtc"}
  {"error": "/robot/near.host_cxt/In3.rtc: no answer within 1s", "kind": "silent", "name": "In3.rtc", "path": "/robot/near.host_cxt/In3.rtc"}
  {"error": "/robot/near.host_cxt/In4.rtc: not asked: its process gave no answer within 1s", "kind": "unasked", "name": "In4.rtc", "path": "/robot/near.host_cxt/In4.rtc"}
  {"error": "/robot/near.host_cxt/In5.rtc: not asked: its process gave no answer within 1s", "kind": "unasked", "name": "In5.rtc", "path": "/robot/near.host_cxt/In5.rtc"}
  {"error": "/robot/near.host_cxt/In6.rtc: not asked: its process gave no answer within 1s", "kind": "unasked", "name": "In6.rtc", "path": "/robot/near.host_cxt/In6.rtc"}
  {"error": "/robot/near.host_cxt/In7.rtc: not asked: its process gave no answer within 1s", "kind": "unasked", "name": "In7.rtc", "path": "/robot/near.host_cxt/In7.rtc"}
  {"error": "/robot/near.host_cxt/In8.rtc: not asked: its process gave no answer within 1s", "kind": "unasked", "name": "In8.rtc", "path": "/robot/near.host_cxt/In8.rtc"}
  {"error": "/robot/near.host_cxt/In9.rtc: not asked: its process gave no answer within 1s", "kind": "unasked", "name": "In9.rtc", "path": "/robot/near.host_cxt/In9.rtc"}
  ! rtls: 4 of 10 did not answer (In0.rtc, In1.rtc, In2.rtc, In3.rtc); 6 not asked, as the process did not answer others (In4.rtc, In5.rtc, In6.rtc, In7.rtc, In8.rtc, …)
  [4] after 1.1 s
  $ rtfind --timeout 1 . -t c --json
  {"kind": "silent", "path": "/robot/near.host_cxt/In0.rtc"}
  {"kind": "silent", "path": "/robot/near.host_cxt/In1.rtc"}
  {"kind": "silent", "path": "/robot/near.host_cxt/In2.rtc"}
  {"kind": "silent", "path": "/robot/near.host_cxt/In3.rtc"}
  {"kind": "unasked", "path": "/robot/near.host_cxt/In4.rtc"}
  {"kind": "unasked", "path": "/robot/near.host_cxt/In5.rtc"}
  {"kind": "unasked", "path": "/robot/near.host_cxt/In6.rtc"}
  {"kind": "unasked", "path": "/robot/near.host_cxt/In7.rtc"}
  {"kind": "unasked", "path": "/robot/near.host_cxt/In8.rtc"}
  {"kind": "unasked", "path": "/robot/near.host_cxt/In9.rtc"}
  ! rtfind: /robot/near.host_cxt/In0.rtc: no answer within 1s
  ! rtfind: /robot/near.host_cxt/In1.rtc: no answer within 1s
  ! rtfind: /robot/near.host_cxt/In2.rtc: no answer within 1s
  ! rtfind: /robot/near.host_cxt/In3.rtc: no answer within 1s
  ! rtfind: /robot/near.host_cxt/In4.rtc: not asked: its process gave no answer within 1s
  ! rtfind: /robot/near.host_cxt/In5.rtc: not asked: its process gave no answer within 1s
  ! rtfind: /robot/near.host_cxt/In6.rtc: not asked: its process gave no answer within 1s
  ! rtfind: /robot/near.host_cxt/In7.rtc: not asked: its process gave no answer within 1s
  ! rtfind: /robot/near.host_cxt/In8.rtc: not asked: its process gave no answer within 1s
  ! rtfind: /robot/near.host_cxt/In9.rtc: not asked: its process gave no answer within 1s
  [5] after 1.1 s
  $ rttop -n 1 --timeout 1 .
  STATE         RATE  CONN  COMPONENT
  [?~] +- +- +[?~]In0.rtc: (no answer within 1s|not asked: .*) (re)
  [?~] +- +- +[?~]In1.rtc: (no answer within 1s|not asked: .*) (re)
  [?~] +- +- +[?~]In2.rtc: (no answer within 1s|not asked: .*) (re)
  [?~] +- +- +[?~]In3.rtc: (no answer within 1s|not asked: .*) (re)
  [?~] +- +- +[?~]In4.rtc: (no answer within 1s|not asked: .*) (re)
  [?~] +- +- +[?~]In5.rtc: (no answer within 1s|not asked: .*) (re)
  [?~] +- +- +[?~]In6.rtc: (no answer within 1s|not asked: .*) (re)
  [?~] +- +- +[?~]In7.rtc: (no answer within 1s|not asked: .*) (re)
  [?~] +- +- +[?~]In8.rtc: (no answer within 1s|not asked: .*) (re)
  [?~] +- +- +[?~]In9.rtc: (no answer within 1s|not asked: .*) (re)
  [0] after 2.1 s
  $ rtcat --timeout 1 In9.rtc
  ! rtcat: /robot/near.host_cxt/In9.rtc: no answer within 1s
  [4] after 1.1 s
  $ wake these

rtdoctor finds the component that hangs, and the one in Error beside those that wait. What one process explains is one line, but
with -v. (From the same host it sees for whom the process waits: tests/commands/rtls-waiting.t.)

  $ rtdoctor -q --timeout 1 /robot/near.host_cxt /robot/far.host_cxt
  fail  /robot/near.host_cxt/In0.rtc: hangs when asked for the profile of its port 1, maybe waiting for a far end that does not answer; this explains 9 more findings (-v shows them); try: mend /robot/far.host_cxt/Out0.rtc first
  fail  /robot/far.host_cxt/Out0.rtc: hung: 10.0.0.1:$PORT accepts TCP, but no answer within 1s; try: restart it; netstat -ltnp | grep :$PORT there names its process
  fail  /robot/near.host_cxt/In9.rtc: in Error; try: rtreset /robot/near.host_cxt/In9.rtc
  [1] after 2.4 s
  $ rtdoctor -qv --timeout 1 /robot/near.host_cxt /robot/far.host_cxt
  fail  /robot/far.host_cxt/Out0.rtc: hung: 10.0.0.1:$PORT accepts TCP, but no answer within 1s; try: restart it; netstat -ltnp | grep :$PORT there names its process
  fail  /robot/near.host_cxt/In0.rtc: hangs when asked for the profile of its port 1, maybe waiting for a far end that does not answer; try: mend /robot/far.host_cxt/Out0.rtc first
  fail  /robot/near.host_cxt/In1.rtc: hangs when asked for the profile of its port 1, maybe waiting for a far end that does not answer; try: mend /robot/far.host_cxt/Out0.rtc first
  fail  /robot/near.host_cxt/In9.rtc: in Error; try: rtreset /robot/near.host_cxt/In9.rtc
  warn  /robot/near.host_cxt/In2.rtc: not asked for the profile of its port 1: others of its process hang when asked; the same with /robot/near.host_cxt/In3.rtc, /robot/near.host_cxt/In4.rtc, /robot/near.host_cxt/In5.rtc and 4 more; try: mend those that do not answer first, then: rtdoctor /robot/near.host_cxt/In2.rtc
  [1] after 2.4 s
  $ rtdoctor --json -q --timeout 1 /robot/near.host_cxt /robot/far.host_cxt
  …
  [1] after 2.4 s
