rtdoctor asks each component that lives for its ports, execution contexts, states and profile, and each manager for what it has.

world: idle
world: error --context error.host_cxt/%n.rtc
world: these Mock:A0 Mock:A1 Mock:A2 Mock:A3 Mock:A4 Mock:A5 SequenceOutComponent:Ports0 --context many.host_cxt/%n.rtc
world: composite --context robot.host_cxt/%n.rtc
world: deadmember --context half.host_cxt/%n.rtc
world: these ConsoleIn:Fast0 ConsoleOut:Deaf0 --rate 1000 --context rates.host_cxt/%n.rtc
world: these ConsoleIn:Calm0 ConsoleIn:Lazy0 --rate 10 --context rates.host_cxt/%n.rtc
world: managers --context mgr.host_cxt/%n.rtc
world: deadslave --context lost.host_cxt/%n.rtc
world: deadchild --context forgotten.host_cxt/%n.rtc

  $ doctor() {
  >     rtdoctor "$@" > out
  >     code=$?
  >     grep -v -e "here: " -e " failed, " -e "^[a-z]* *[^ ]*$PORT: [as][nl]" out
  >     return $code
  > }

Nothing executes them:

  $ doctor -q .
  fail  /localhost:$PORT/test.host_cxt/Bare0.rtc: has no execution context: nothing executes it; try: restart it; netstat -ltnp | grep :* there names its process (glob)
  fail  /localhost:$PORT/test.host_cxt/Still0.rtc: its execution context has a rate of 0 Hz; try: rtec /localhost:$PORT/test.host_cxt/Still0.rtc rate 100
  fail  /localhost:$PORT/test.host_cxt/Stopped0.rtc: its execution context is stopped: nothing executes it; try: rtec /localhost:$PORT/test.host_cxt/Stopped0.rtc start
  [1]

In Error; the others are fine:

  $ doctor ../error.host_cxt
  fail  /localhost:$PORT/error.host_cxt/Broken0.rtc: in Error; try: rtreset /localhost:$PORT/error.host_cxt/Broken0.rtc
  ok    /localhost:$PORT/error.host_cxt/Err0.rtc: Inactive, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/error.host_cxt/ErrStart0.rtc: Inactive, claims 1000 Hz, 0 ports, 0 connections, at 127.0.0.1:* (glob)
  [1]

Members of a composite have stopped contexts of their own, and are driven by the composite's:

  $ rtact ../robot.host_cxt/composite0.rtc; doctor ../robot.host_cxt
  ok    /localhost:$PORT/robot.host_cxt/Controller0.rtc: Active, claims 1000 Hz, 2 ports, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/robot.host_cxt/Motor0.rtc: Active, claims 1000 Hz, 2 ports, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/robot.host_cxt/Sensor0.rtc: Active, claims 1000 Hz, 2 ports, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/robot.host_cxt/composite0.rtc: Active, claims 1000 Hz, 2 ports, 0 connections, at 127.0.0.1:* (glob)

A port that refuses its profile; the component's own profile is not asked for then. A port of a member whose process is dead:

  $ ctl @these fail get_port_profile 1 NO_PERMISSION; doctor -q ../many.host_cxt/A0.rtc
  fail  /localhost:$PORT/many.host_cxt/A0.rtc: its port 1 refuses its profile (CORBA.NO_PERMISSION); try: restart it; netstat -ltnp | grep :* there names its process (glob)
  [1]
  $ calls @these | grep component
  1 get_component_state
  $ doctor -q ../half.host_cxt/composite0.rtc
  fail  /localhost:$PORT/half.host_cxt/composite0.rtc: its port 2 is out of reach: perhaps a member of this composite is dead; try: restart its process, with all members alive (rtcomp cannot remove a dead one); netstat -ltnp | grep :* there names it (glob)
  fail  /localhost:$PORT/half.host_cxt/composite0.rtc: one of its members is dead: nothing answers at 127.0.0.1:*; try: restart its process, with all members alive (rtcomp cannot remove a dead one); netstat -ltnp | grep :* there names it (glob)
  [1]

Other questions refused; what has none of a component's operations; a context of another component, which is gone:

  $ ctl @these fail get_ports 1 NO_PERMISSION; doctor -q ../many.host_cxt/A0.rtc | grep A0
  fail  /localhost:$PORT/many.host_cxt/A0.rtc: does not report its ports (CORBA.NO_PERMISSION); try: restart it; netstat -ltnp | grep :* there names its process (glob)
  $ ctl @these fail get_ports 1 BAD_OPERATION; doctor -q ../many.host_cxt/A0.rtc | grep A0
  fail  /localhost:$PORT/many.host_cxt/A0.rtc: somebody else's: it is registered as a component, but is not one; try: see who uses this name; if nobody does: rtdel /localhost:$PORT/many.host_cxt/A0.rtc
  $ mock these Mock:Guest0 --context guest.host_cxt/%n.rtc
  $ mock these Mock:Host0 --context host.host_cxt/%n.rtc
  $ rtec ../host.host_cxt/Host0.rtc attach ../guest.host_cxt/Guest0.rtc; kill-mock these5
  $ doctor -q ../guest.host_cxt | grep context
  warn  /localhost:$PORT/guest.host_cxt/Guest0.rtc: its execution context 1 belongs to another component, which does not answer; try: look at its contexts: rtec /localhost:$PORT/guest.host_cxt/Guest0.rtc

An operation that hangs, in a process that goes on; the bound is kept, however many components it has:

  $ ctl @these delay get_port_profile 30; ctl @these2 reset
  $ within 0.4-1.8 rtdoctor -q --timeout 0.5 ../many.host_cxt > out
  [1]
  $ sed 's/[^/]*[.]rtc/X.rtc/g' out | grep X.rtc
  fail  /localhost:$PORT/many.host_cxt/X.rtc: no answer within 0.5s when asked for the profile of its port 1; try: ask it with more time: rtdoctor --timeout 30 /localhost:$PORT/many.host_cxt/X.rtc
  fail  /localhost:$PORT/many.host_cxt/X.rtc: no answer within 0.5s when asked for the profile of its port 1; try: ask it with more time: rtdoctor --timeout 30 /localhost:$PORT/many.host_cxt/X.rtc
  warn  /localhost:$PORT/many.host_cxt/X.rtc: not asked for the profile of its port 1: others of its process hang when asked; the same with /localhost:$PORT/many.host_cxt/X.rtc, /localhost:$PORT/many.host_cxt/X.rtc, /localhost:$PORT/many.host_cxt/X.rtc and 1 more; try: mend those that do not answer first, then: rtdoctor /localhost:$PORT/many.host_cxt/X.rtc
  $ ctl @these delay get_port_profile 0.5
  $ within 2.8-6 rtdoctor -q --timeout 1 ../many.host_cxt/Ports0.rtc | grep rtc
  fail  /localhost:$PORT/many.host_cxt/Ports0.rtc: slow: there was no time left to ask it; try: ask it with more time: rtdoctor --timeout 30 /localhost:$PORT/many.host_cxt/Ports0.rtc
  $ ctl @these delay get_port_profile 0

A context that claims more than it keeps: with --measure an out port of each active component shows it. A mock keeps 50 Hz at most.

  $ rtact --wait ../rates.host_cxt/Fast0.rtc ../rates.host_cxt/Deaf0.rtc ../rates.host_cxt/Calm0.rtc \
  >     ../many.host_cxt/A0.rtc
  $ within 1-4 rtdoctor --measure ../rates.host_cxt ../many.host_cxt/A0.rtc | grep rtc
  warn  /localhost:$PORT/rates.host_cxt/Fast0.rtc: keeps * of 1000 Hz, or does not write to out in each cycle; try: look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 127.0.0.1) (glob)
  ok    /localhost:$PORT/many.host_cxt/A0.rtc: rate not measured: nothing is written to out
  ok    /localhost:$PORT/many.host_cxt/A0.rtc: Active, claims 1000 Hz, 2 ports, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/rates.host_cxt/Calm0.rtc: keeps * of 10 Hz (writes to out) (glob)
  ok    /localhost:$PORT/rates.host_cxt/Calm0.rtc: Active, claims 10 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/rates.host_cxt/Deaf0.rtc: rate not measured: it has no out port
  ok    /localhost:$PORT/rates.host_cxt/Deaf0.rtc: Active, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/rates.host_cxt/Fast0.rtc: Active, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/rates.host_cxt/Lazy0.rtc: rate not measured: it is Inactive
  ok    /localhost:$PORT/rates.host_cxt/Lazy0.rtc: Inactive, claims 10 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  $ rtact --wait ../many.host_cxt/Ports0.rtc
  $ rtdoctor -q --measure ../rates.host_cxt ../many.host_cxt | grep rtc
  warn  /localhost:$PORT/many.host_cxt/Ports0.rtc: keeps * of 1000 Hz, or does not write to Octet in each cycle; try: look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 127.0.0.1) (glob)
  warn  /localhost:$PORT/rates.host_cxt/Fast0.rtc: keeps * of 1000 Hz, or does not write to out in each cycle; try: look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 127.0.0.1) (glob)
  $ rtdeact --wait ../many.host_cxt/Ports0.rtc; doctor ../rates.host_cxt
  ok    /localhost:$PORT/rates.host_cxt/Calm0.rtc: Active, claims 10 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/rates.host_cxt/Deaf0.rtc: Active, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/rates.host_cxt/Fast0.rtc: Active, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/rates.host_cxt/Lazy0.rtc: Inactive, claims 10 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)

Nothing of that is left, whether it ends by itself or not, also where the values do not come:

  $ rtdoctor -q --measure 60 ../rates.host_cxt > out & soon 'ctl @these3 connectors Calm0:out | grep -q lite'
  $ kill -TERM $!; wait $!
  [143]
  $ ctl @these2 connectors Fast0:out; ctl @these3 connectors Calm0:out
  $ ctl @these3 delay get 30
  $ within 1-5 rtdoctor -q --timeout 1 --measure 1.2 ../rates.host_cxt/Calm0.rtc | grep rtc
  rtdoctor: /localhost:$PORT/rates.host_cxt/Calm0.rtc:out: connection $UUID stays, because a call is unanswered and removing it now could end the component; when it answers again: rtdis -i $UUID /localhost:$PORT/rates.host_cxt/Calm0.rtc:out
  warn  /localhost:$PORT/rates.host_cxt/Calm0.rtc: rate not measured: no answer within 1s; try: measure it alone: rtec --measure /localhost:$PORT/rates.host_cxt/Calm0.rtc
  $ ctl @these3 reset
  $ rtdis -i $(ctl @these3 connectors Calm0:out | cut -d' ' -f1) ../rates.host_cxt/Calm0.rtc:out
  $ ctl @these3 connectors Calm0:out

Managers: what they list must be there:

  $ doctor ../mgr.host_cxt
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/mgr.host_cxt/ConsoleIn0.rtc /localhost:$PORT/mgr.host_cxt/ConsoleOut0.rtc
  ok    /localhost:$PORT/mgr.host_cxt/ConsoleIn0.rtc: Inactive, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/mgr.host_cxt/ConsoleOut0.rtc: Inactive, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/mgr.host_cxt/manager.mgr: manager of 2 components, 2 slaves, at 127.0.0.1:* (glob)
  $ doctor -q ../lost.host_cxt
  fail  /localhost:$PORT/lost.host_cxt/ConsoleOut0.rtc: dead (zombie): * at 127.0.0.1:*; try: rtdel -z /localhost:$PORT/lost.host_cxt/ConsoleOut0.rtc (glob)
  fail  /localhost:$PORT/lost.host_cxt/manager.mgr: lists a slave that is gone; try: restart it; rtls /localhost:$PORT/lost.host_cxt/manager.mgr marks what is gone
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/lost.host_cxt/ConsoleIn0.rtc
  [1]
  $ doctor -q ../forgotten.host_cxt
  fail  /localhost:$PORT/forgotten.host_cxt/manager.mgr: lists a component that is gone; try: restart it; rtls /localhost:$PORT/forgotten.host_cxt/manager.mgr marks what is gone
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/forgotten.host_cxt/ConsoleIn0.rtc
  [1]
  $ ctl @managers fail get_slave_managers 1 NO_PERMISSION; doctor -q ../mgr.host_cxt | grep mgr:
  fail  /localhost:$PORT/mgr.host_cxt/manager.mgr: does not report what it has (CORBA.NO_PERMISSION); try: restart it; netstat -ltnp | grep :* there names its process (glob)
  $ ctl @managers fail get_components 1 TRANSIENT; doctor -q ../mgr.host_cxt | grep mgr:
  fail  /localhost:$PORT/mgr.host_cxt/manager.mgr: one of its slaves has died, and its components with it; try: restart that slave
  $ ctl @managers slave 1 hang manager 30; doctor -q --timeout 1 ../mgr.host_cxt | grep mgr:
  fail  /localhost:$PORT/mgr.host_cxt/manager.mgr: does not report what it has (no answer within 1s); try: restart it, or a slave that it waits for; netstat -ltnp | grep :* there names its process (glob)

A composite with a dead member, whether that exports a port or not:

  $ rtcomp -r Peer0:in ../half.host_cxt/composite0.rtc 2> out; doctor -q ../half.host_cxt/composite0.rtc
  fail  /localhost:$PORT/half.host_cxt/composite0.rtc: one of its members is dead: nothing answers at 127.0.0.1:*; try: restart its process, with all members alive (rtcomp cannot remove a dead one); netstat -ltnp | grep :* there names it (glob)
  warn  /: all components are Inactive: nothing has been started; try: rtact /localhost:$PORT/half.host_cxt/composite0.rtc
  [1]

One that is Inactive, while what it is connected with is Active:

  $ rtcon ../rates.host_cxt/Lazy0.rtc:out ../rates.host_cxt/Deaf0.rtc:in; doctor -q ../rates.host_cxt
  warn  /localhost:$PORT/rates.host_cxt/Lazy0.rtc: Inactive, while 1 component of its system is Active; it may have been reset; try: if it is to move, activate it: rtact /localhost:$PORT/rates.host_cxt/Lazy0.rtc

Components that get values, and write none or fewer than they execute: rttrace follows them.

  $ mock chain 4 stopped@1 --context stopped.host_cxt/%n.rtc
  $ mock chain 4 thinned@2 --context thinned.host_cxt/%n.rtc
  $ rtdoctor --measure ../stopped.host_cxt | grep Link1.rtc: | grep rttrace
  ok    /localhost:$PORT/stopped.host_cxt/Link1.rtc: rate not measured: nothing is written to out (rttrace -u /localhost:$PORT/stopped.host_cxt/Link1.rtc:out shows whether values come to it)
  $ rttrace -t 2 -u /localhost:$PORT/stopped.host_cxt/Link1.rtc:out | tail -n 1 | sed 's/([0-9.]* Hz)/(… Hz)/'
  /localhost:$PORT/stopped.host_cxt/Link1.rtc: values come in (… Hz), none goes out of /localhost:$PORT/stopped.host_cxt/Link1.rtc:out (probable)
  $ rtdoctor -q --measure ../thinned.host_cxt | grep Link2.rtc:
  warn  /localhost:$PORT/thinned.host_cxt/Link2.rtc: keeps * of 50 Hz, or does not write to out in each cycle; try: see whether values come to it as often (rttrace -u /localhost:$PORT/thinned.host_cxt/Link2.rtc:out); if so, look for what takes the time of its host, or of the component itself (top there), or what is lost on the way (ping 127.0.0.1) (glob)

The times in values:

  $ MOCK_CLOCK=-864000 mock senders 20 --context clock.host_cxt/%n.rtc
  $ rtdoctor -q --measure ../clock.host_cxt | grep days
  warn  /localhost:$PORT/clock.host_cxt/Source0.rtc: the times in its values are 10.0 days behind this host's clock; try: compare the clocks (date, here and there) and set the wrong one: timedatectl
