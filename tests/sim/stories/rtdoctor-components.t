What rtdoctor says of components that answer late, and of rates that they do not keep.

world: these Mock:A0 Mock:B0 Mock:C0 SequenceOutComponent:Ports0 --context many.host_cxt/%n.rtc
world: these ConsoleIn:Fast0 ConsoleOut:Deaf0 --context rates.host_cxt/%n.rtc
world: these ConsoleIn:Calm0 ConsoleIn:Lazy0 --rate 10 --context rates.host_cxt/%n.rtc

An operation that hangs, in a process that goes on; the bound is kept, however many components it has:

  $ ctl delay get_port_profile 30
  $ rtdoctor -q --timeout 0.5 ../many.host_cxt
  fail  /robot/many.host_cxt/A0.rtc: no answer within 0.5s when asked for the profile of its port 1; try: ask it with more time: rtdoctor --timeout 30 /robot/many.host_cxt/A0.rtc
  fail  /robot/many.host_cxt/B0.rtc: no answer within 0.5s when asked for the profile of its port 1; try: ask it with more time: rtdoctor --timeout 30 /robot/many.host_cxt/B0.rtc
  warn  /robot/many.host_cxt/C0.rtc: not asked for the profile of its port 1: others of its process hang when asked; try: mend those that do not answer first, then: rtdoctor /robot/many.host_cxt/C0.rtc
  warn  /robot/many.host_cxt/Ports0.rtc: not asked for the profile of its port 1: others of its process hang when asked; try: mend those that do not answer first, then: rtdoctor /robot/many.host_cxt/Ports0.rtc
  [1] after 0.6 s
  $ ctl delay get_port_profile 0.5
  $ rtdoctor -q --timeout 1 ../many.host_cxt/Ports0.rtc
  fail  /robot/many.host_cxt/Ports0.rtc: slow: there was no time left to ask it; try: ask it with more time: rtdoctor --timeout 30 /robot/many.host_cxt/Ports0.rtc
  [1] after 3.0 s
  $ ctl delay get_port_profile 0

Questions that are refused:

  $ ctl fail get_port_profile 1 NO_PERMISSION
  $ rtdoctor -q ../many.host_cxt/A0.rtc
  fail  /robot/many.host_cxt/A0.rtc: its port 1 refuses its profile (CORBA.NO_PERMISSION); try: restart it; netstat -ltnp | grep :$PORT there names its process
  [1]
  $ ctl fail get_ports 1 NO_PERMISSION
  $ rtdoctor -q ../many.host_cxt/A0.rtc
  fail  /robot/many.host_cxt/A0.rtc: does not report its ports (CORBA.NO_PERMISSION); try: restart it; netstat -ltnp | grep :$PORT there names its process
  [1]
  $ ctl fail get_ports 1 BAD_OPERATION
  $ rtdoctor -q ../many.host_cxt/A0.rtc
  fail  /robot/many.host_cxt/A0.rtc: somebody else's: it is registered as a component, but is not one; try: see who uses this name; if nobody does: rtdel /robot/many.host_cxt/A0.rtc
  [1]

A context that claims more than it keeps: with --measure an out port of each active component shows it. A mock keeps 50 Hz at most.

  $ rtact --wait ../rates.host_cxt/Fast0.rtc ../rates.host_cxt/Deaf0.rtc ../rates.host_cxt/Calm0.rtc ../many.host_cxt/A0.rtc
  [0] after 0.2 s
  $ rtdoctor --measure ../rates.host_cxt ../many.host_cxt/A0.rtc
  warn  /robot/rates.host_cxt/Fast0.rtc: keeps 51.0 of 1000 Hz, or does not write to out in each cycle; try: look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 10.0.0.1)
  ok    here: Python 3.* (glob)
  ok    here: this host's name, robot, means 10.0.0.1
  ok    here: RTCTREE_NAMESERVERS: robot
  ok    /robot: answers (name 0.0 ms, TCP 0.1 ms, CORBA 5.1 ms, naming 0.1 ms) at 10.0.0.1, this host
  ok    /robot/many.host_cxt/A0.rtc: rate not measured: nothing was written to out in 1 s
  ok    /robot/many.host_cxt/A0.rtc: Active, claims 1000 Hz, 2 ports, 0 connections, at 10.0.0.1:$PORT
  ok    /robot/rates.host_cxt/Calm0.rtc: keeps 10.0 of 10 Hz (writes to out)
  ok    /robot/rates.host_cxt/Calm0.rtc: Active, claims 10 Hz, 1 port, 0 connections, at 10.0.0.1:$PORT
  ok    /robot/rates.host_cxt/Deaf0.rtc: rate not measured: it has no out port
  ok    /robot/rates.host_cxt/Deaf0.rtc: Active, claims 1000 Hz, 1 port, 0 connections, at 10.0.0.1:$PORT
  ok    /robot/rates.host_cxt/Fast0.rtc: Active, claims 1000 Hz, 1 port, 0 connections, at 10.0.0.1:$PORT
  ok    /robot/rates.host_cxt/Lazy0.rtc: rate not measured: it is Inactive
  ok    /robot/rates.host_cxt/Lazy0.rtc: Inactive, claims 10 Hz, 1 port, 0 connections, at 10.0.0.1:$PORT
  0 failed, 1 to be looked at, 13 ok
  [0] after 1.1 s
  $ rtact --wait ../many.host_cxt/Ports0.rtc
  $ rtdoctor -q --measure ../rates.host_cxt ../many.host_cxt
  warn  /robot/many.host_cxt/Ports0.rtc: keeps 51.0 of 1000 Hz, or does not write to Octet in each cycle; try: look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 10.0.0.1)
  warn  /robot/rates.host_cxt/Fast0.rtc: keeps 51.0 of 1000 Hz, or does not write to out in each cycle; try: look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 10.0.0.1)
  [0] after 1.1 s
  $ rtdeact --wait ../many.host_cxt/Ports0.rtc

Nothing of that is left, whether it ends by itself or not, also where the values do not come:

  $ rtdoctor -q --measure 60 ../rates.host_cxt &
  $ sleep 2
  $ ctl @these3 connectors Calm0:out
  $UUID rtshell_lite
  $ strike TERM rtdoctor
  $ wait rtdoctor
  [143] after 2.0 s
  $ ctl @these2 connectors Fast0:out
  $ ctl @these3 connectors Calm0:out
  $ ctl @these3 delay get 30
  $ rtdoctor -q --timeout 1 --measure 1.2 ../rates.host_cxt/Calm0.rtc
  warn  /robot/rates.host_cxt/Calm0.rtc: rate not measured: no answer within 1s; try: measure it alone: rtec --measure /robot/rates.host_cxt/Calm0.rtc
  ! rtdoctor: /robot/rates.host_cxt/Calm0.rtc:out: connection $UUID stays, because a call is unanswered and removing it now could end the component; when it answers again: rtdis --force -i $UUID /robot/rates.host_cxt/Calm0.rtc:out
  [0] after 1.2 s
  $ ctl @these3 reset
  $ rtdis --force ../rates.host_cxt/Calm0.rtc:out
  $ ctl @these3 connectors Calm0:out

One that is Inactive, while what it is connected with is Active:

  $ rtcon ../rates.host_cxt/Lazy0.rtc:out ../rates.host_cxt/Deaf0.rtc:in
  $ rtdoctor -q ../rates.host_cxt
  warn  /robot/rates.host_cxt/Lazy0.rtc: Inactive, while 1 component of its system is Active; it may have been reset; try: if it is to move, activate it: rtact /robot/rates.host_cxt/Lazy0.rtc

Components that get values, and write none or fewer than they execute: rttrace follows them.

  $ mock chain 4 stopped@1 --context stopped.host_cxt/%n.rtc
  $ mock chain 4 thinned@2 --context thinned.host_cxt/%n.rtc
  $ rtdoctor -q --measure ../stopped.host_cxt
  [0] after 1.1 s
  $ rttrace -t 2 -u /robot/stopped.host_cxt/Link1.rtc:out
  …
  /robot/stopped.host_cxt/Link1.rtc: values come in (50 Hz), none goes out of /robot/stopped.host_cxt/Link1.rtc:out (probable)
  …
  [1] after 2.1 s
  $ rtdoctor -q --measure ../thinned.host_cxt
  warn  /robot/thinned.host_cxt/Link2.rtc: keeps 5.0 of 50 Hz, or does not write to out in each cycle; try: see whether values come to it as often (rttrace -u /robot/thinned.host_cxt/Link2.rtc:out); if so, look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 10.0.0.1)
  [0] after 1.1 s
