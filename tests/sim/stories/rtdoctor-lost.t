rtdoctor where packets get lost: that is the network, and nothing advises to restart or delete anything.

hosts: robot1 robot2 laptop
seat: laptop
world: these ConsoleIn
world: these ConsoleOut --host robot2

  $ rtdoctor -q
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot1/test.host_cxt/ConsoleIn0.rtc /robot1/test.host_cxt/ConsoleOut0.rtc

Large ones: small questions are answered, a profile never comes.

  $ shrink_packets robot2
  $ rtdoctor -q
  fail  /robot1/test.host_cxt/ConsoleOut0.rtc: answers small questions, but not when asked for its execution contexts: perhaps large packets are lost on the way; try: ping -M do -s 1472 10.0.0.2, here and there back, shows whether large packets come through: if not, correct the MTU on the way; if they do, it hangs: netstat -ltnp | grep :$PORT there names its process
  [1] after 3.1 s

All of what it sends:

  $ lose_one_way robot2
  $ rtdoctor -q
  fail  /robot1/test.host_cxt/ConsoleOut0.rtc: cannot tell from here whether it lives: publishes 10.0.0.2:$PORT, out of reach (no answer within 3s); try: look at what is between here and 10.0.0.2: firewall (port 42001), route (ip route get 10.0.0.2), MTU and loss (ping 10.0.0.2)
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot1/test.host_cxt/ConsoleIn0.rtc
  [1] after 3.1 s
