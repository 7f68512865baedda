A component that takes its time is not hung: 2 s are within the usual timeout, also for the second component of a process
that does one thing after the other. With a shorter timeout it may be slow, and nothing is restarted for that.

world: these Mock:Slow0
world: these Mock:Slow1 Mock:Slow2 --context two.host_cxt/%n.rtc

  $ ctl delay get_ports 2
  $ rtdoctor -q .
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/test.host_cxt/Slow0.rtc
  [0] after 2.0 s
  $ ctl @these2 delay get_ports 2
  $ rtdoctor -q ../two.host_cxt
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/two.host_cxt/Slow1.rtc /robot/two.host_cxt/Slow2.rtc
  [0] after 2.0 s
  $ rtdoctor -q --timeout 1 .
  fail  /robot/test.host_cxt/Slow0.rtc: no answer within 1s when asked for its ports; try: ask it with more time: rtdoctor --timeout 30 /robot/test.host_cxt/Slow0.rtc
  [1] after 1.1 s

One that takes longer than the usual timeout hangs, and its process does not:

  $ ctl delay get_ports 30
  $ rtdoctor -q .
  fail  /robot/test.host_cxt/Slow0.rtc: hangs when asked for its ports; try: restart it; netstat -ltnp | grep :$PORT there names its process
  [1] after 3.1 s
