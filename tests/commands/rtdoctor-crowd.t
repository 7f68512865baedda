A robot of 40 with one hung process, one Error, one stopped context, and four connections that wait for what hangs: rtdoctor finds the three, and says nothing of those that are well.

world: these Mock:In0 Mock:In1 Mock:In2 Mock:In3 Mock:In4 Mock:In5 Mock:In6 Mock:In7 Mock:In8 Err:In9 --context near.host_cxt/%n.rtc
world: these Mock:Out0 Mock:Out1 Mock:Out2 Mock:Out3 Mock:Out4 --context far.host_cxt/%n.rtc
world: many 25

  $ near=/localhost:$PORT/near.host_cxt; far=/localhost:$PORT/far.host_cxt
  $ well=/localhost:$PORT/test.host_cxt
  $ for n in 0 1 2 3; do rtcon $far/Out$n.rtc:out $near/In$n.rtc:in; done
  $ rtact $near/In9.rtc 2> or-in-error; rtfind --wait 60 --state Error $near
  /localhost:$PORT/near.host_cxt/In9.rtc
  $ rtec $near/In8.rtc stop
  $ rtact $(for n in 0 1 2 3 4 5 6 7; do echo $near/In$n.rtc; done) $(rtfind $well -t c); hang these2

One line for each of the three, and none besides:

  $ rtdoctor -q --timeout 4 $near $far $well > out
  [1]
  $ grep /localhost out | grep -v -e '^warn.*Out4.rtc: not asked' -e ': slow ('
  fail  /localhost:$PORT/far.host_cxt/Out0.rtc: hung: 127.0.0.1:* accepts TCP, but no answer within 4s; this explains * more findings (-v shows them); try: restart it; netstat -ltnp | grep :* there names its process (glob)
  fail  /localhost:$PORT/near.host_cxt/In8.rtc: its execution context is stopped: nothing executes it; try: rtec /localhost:$PORT/near.host_cxt/In8.rtc start
  fail  /localhost:$PORT/near.host_cxt/In9.rtc: in Error; try: rtreset /localhost:$PORT/near.host_cxt/In9.rtc

What it explains has its cause; of the components that wait, two are asked, and nobody is told to restart one that is well:

  $ rtdoctor --json --timeout 4 $near $far $well > out; python3 -c 'import collections, json, re
  > told = collections.Counter()
  > for one in map(json.loads, open("out")):
  >     name = re.search(r"/([A-Z]\w*)\.rtc", one["path"])
  >     if name and one["level"] != "warn":
  >         told[name.group(1).rstrip("0123456789"), one["level"], re.split(" when|:|,", \
  >             one["message"])[0], bool(one["cause"])] += 1
  > for what, number in sorted(told.items()): print(number, *what)'
  2 In fail hangs True
  1 In fail in Error False
  1 In fail its execution context is stopped False
  25 Mock ok Active False
  4 Out fail hung True
  $ grep -c 'In[4-9].*restart' out; wake these2
  0
