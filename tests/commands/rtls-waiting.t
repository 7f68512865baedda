Calls that wait for a third party hide nothing: a process of ten components, four of them connected with one that hangs, one in Error.

world: these Mock:In0 Mock:In1 Mock:In2 Mock:In3 Mock:In4 Mock:In5 Mock:In6 Mock:In7 Mock:In8 Err:In9 --context near.host_cxt/%n.rtc
world: these Mock:Out0 --context far.host_cxt/%n.rtc
both: each ORB waits in its own way

  $ near=/localhost:$PORT/near.host_cxt; far=/localhost:$PORT/far.host_cxt
  $ for n in 0 1 2 3; do rtcon $far/Out0.rtc:out $near/In$n.rtc:in; done
  $ rtact $near/In9.rtc; rtfind --wait 10 --state Error $near
  /localhost:$PORT/near.host_cxt/In9.rtc
  $ hang these2

All are asked for their states before the first is asked for its ports, and two calls at most wait for others:

  $ within 1-3 rtls -l --timeout 1 $near > out; echo $?; awk '{print $1, $6}' out
  rtls: .* not asked for the ports, as others of the process hang when asked \(.* (re)
  5
  Inactive In0.rtc
  Inactive In1.rtc
  Inactive In2.rtc
  Inactive In3.rtc
  Inactive In4.rtc
  Inactive In5.rtc
  Inactive In6.rtc
  Inactive In7.rtc
  Inactive In8.rtc
  Error In9.rtc
  $ grep -c '?.*In[0-3]' out; grep '?.*In[4-9]' out
  2
  [1]
  $ rtls -l --json --timeout 1 $near 2>/dev/null | python3 -c 'import collections, json, sys
  > rows = [one for one in map(json.loads, sys.stdin) if "error" in one]
  > print({one["kind"] for one in rows}, any("ports" in one for one in rows), all("state" in one for one in rows))
  > print(sum(one["error"].endswith("no answer within 1s") for one in rows))
  > print({one["error"].partition(": ")[2] for one in rows if "not asked" in one["error"]})'
  {'component'} False True
  2
  {'not asked: questions like it got no answer within 1s from its process'}
  $ rtls --timeout 1 $near | tr '\n' ' '
  In0.rtc In1.rtc In2.rtc In3.rtc In4.rtc In5.rtc In6.rtc In7.rtc In8.rtc In9.rtc\x20 (esc) (no-eol)

A process that hangs itself: four of its components were asked. What was not asked is not called silent:

  $ hang these; within 1-3 rtls -l --timeout 1 $near > out; echo $?; awk '{print $1, $6}' out
  rtls: 4 of 10 did not answer (In0.rtc, In1.rtc, In2.rtc, In3.rtc); 6 not asked, as the process did not answer others (In4.rtc, In5.rtc, In6.rtc, In7.rtc, In8.rtc, …)
  4
  ? ?In0.rtc
  ? ?In1.rtc
  ? ?In2.rtc
  ? ?In3.rtc
  - ~In4.rtc
  - ~In5.rtc
  - ~In6.rtc
  - ~In7.rtc
  - ~In8.rtc
  - ~In9.rtc
  $ rtls --json --timeout 1 $near 2>/dev/null | tail -1
  {"error": "/localhost:$PORT/near.host_cxt/In9.rtc: not asked: its process gave no answer within 1s", "kind": "unasked", "name": "In9.rtc", "path": "/localhost:$PORT/near.host_cxt/In9.rtc"}
  $ rtfind --timeout 1 $near -t c --json 2>&1 | grep In9 | sort
  rtfind: /localhost:$PORT/near.host_cxt/In9.rtc: not asked: its process gave no answer within 1s
  {"kind": "unasked", "path": "/localhost:$PORT/near.host_cxt/In9.rtc"}
  $ rttop -n 1 --timeout 1 $near | awk '/^[?~]/ {print $1}' | sort | uniq -c | awk '{print $1, $2}'
  2 ?
  8 ~
  $ rtcat --timeout 1 $near/In9.rtc; wake these
  rtcat: /localhost:$PORT/near.host_cxt/In9.rtc: no answer within 1s

rtdoctor finds the component that hangs, and the one in Error beside those that wait. What one process explains is one line, but with -v:

  $ within 1-4 rtdoctor -q --timeout 1 $near $far | grep rtc
  fail  /localhost:$PORT/far.host_cxt/Out0.rtc: hung: 127.0.0.1:* accepts TCP, but no answer within 1s; this explains * more findings (-v shows them); try: restart it; netstat -ltnp | grep :* there names its process (glob)
  fail  /localhost:$PORT/near.host_cxt/In9.rtc: in Error; try: rtreset /localhost:$PORT/near.host_cxt/In9.rtc
  $ rtdoctor --timeout 1 $near $far | tail -1
  4 failed, \d+ to be looked at, \d+ ok; \d+ of them are not shown \(-v\) (re)
  $ rtdoctor -qv --timeout 1 $near $far > out; grep -c '^fail.*In[0-3].rtc: hangs.* mend /localhost:.*/Out0.rtc first$' out; grep '^fail.*In[4-8]' out
  2
  [1]
  $ rtdoctor --json -q --timeout 1 $near $far | grep -v here | grep -v In9 | sed 's/.*cause": "\([^:]*\):.*/\1/' | sort -u
  127.0.0.1
  $ wake these2
