A component that takes its time is not hung: 2 s are within the usual timeout, also for the second component of a process
that does one thing after the other. With a shorter timeout it may be slow, and nothing is restarted for that.

world: these Mock:Slow0
world: these Mock:Slow1 Mock:Slow2 --context two.host_cxt/%n.rtc

  $ ctl delay get_ports 2; within 2-8 rtdoctor -q . | grep -c Slow0.rtc:
  0
  [1]
  $ ctl @these2 delay get_ports 2; within 2-8 rtdoctor -q ../two.host_cxt | grep -c 'Slow[12].rtc:'
  0
  [1]
  $ within 1-4 rtdoctor -q --timeout 1 . | grep Slow0.rtc:
  fail  /localhost:$PORT/test.host_cxt/Slow0.rtc: no answer within 1s when asked for its ports; try: ask it with more time: rtdoctor --timeout 30 /localhost:$PORT/test.host_cxt/Slow0.rtc

One that takes longer than the usual timeout hangs, and its process does not:

  $ ctl delay get_ports 30; within 3-10 rtdoctor -q . | grep Slow0.rtc:
  fail  /localhost:$PORT/test.host_cxt/Slow0.rtc: hangs when asked for its ports; try: restart it; netstat -ltnp | grep :* there names its process (glob)
