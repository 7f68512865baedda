Calls that wait for a third party hide nothing, whichever ORB asks: a process of ten components, four of them connected with one
that hangs, one in Error. (More of it is in tests/sim/stories/rtls-waiting.t.)

world: these Mock:In0 Mock:In1 Mock:In2 Mock:In3 Mock:In4 Mock:In5 Mock:In6 Mock:In7 Mock:In8 Err:In9 --context near.host_cxt/%n.rtc
world: these Mock:Out0 --context far.host_cxt/%n.rtc
both: each ORB waits in its own way

  $ near=/localhost:$PORT/near.host_cxt; far=/localhost:$PORT/far.host_cxt
  $ for n in 0 1 2 3; do rtcon $far/Out0.rtc:out $near/In$n.rtc:in; done
  $ rtact $near/In9.rtc 2> or-in-error; rtfind --wait 10 --state Error $near
  /localhost:$PORT/near.host_cxt/In9.rtc
  $ hang these2

All are asked for their states before the first is asked for its ports, and two calls at most wait for others:

  $ within 1-3 rtls -l --timeout 1 $near > out
  rtls: .* not asked for the ports, as others of the process hang when asked \(.* (re)
  [5]
  $ awk '{print $1, $6}' out | uniq -c -w 5
        9 Inactive In0.rtc
        1 Error In9.rtc
  $ grep -c '?.*In[0-3]' out; grep '?.*In[4-9]' out
  2
  [1]

rtdoctor sees for whom the process waits, where the kernel of its host says that:

  $ within 2-8 rtdoctor -q --timeout 2 $near $far | grep rtc
  fail  /localhost:$PORT/far.host_cxt/Out0.rtc: hung: 127.0.0.1:* accepts TCP, but no answer within 2s; this explains * more findings (-v shows them); try: restart it; netstat -ltnp | grep :* there names its process (glob)
  fail  /localhost:$PORT/near.host_cxt/In9.rtc: in Error; try: rtreset /localhost:$PORT/near.host_cxt/In9.rtc
  $ rtdoctor -qv --timeout 2 $near $far > out
  [1]
  $ grep -c '^fail.*In[0-3].rtc: hangs.* mend /localhost:.*/Out0.rtc first$' out; grep '^fail.*In[4-8]' out
  2
  [1]

A process that hangs itself: four of its components were asked. What was not asked is not called silent:

  $ hang these; within 1-3 rtls -l --timeout 1 $near
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
  rtls: 4 of 10 did not answer (In0.rtc, In1.rtc, In2.rtc, In3.rtc); 6 not asked, as the process did not answer others (In4.rtc, In5.rtc, In6.rtc, In7.rtc, In8.rtc, …)
  [4]
