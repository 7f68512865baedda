rtdoctor asks each component that lives for its ports, execution contexts, states and profile, and each manager for what it has.
(Those that answer late, refuse, or do not keep their rates: tests/sim/stories/rtdoctor-components.t.)

world: idle
world: error --context error.host_cxt/%n.rtc
world: these Mock:A0 Mock:A1 Mock:A2 Mock:A3 Mock:A4 Mock:A5 SequenceOutComponent:Ports0 --context many.host_cxt/%n.rtc
world: composite --context robot.host_cxt/%n.rtc
world: deadmember --context half.host_cxt/%n.rtc
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

  $ rtact ../robot.host_cxt/composite0.rtc
  $ soon '[ $(rtfind ../robot.host_cxt --state active -t c | wc -l) = 4 ]'; doctor ../robot.host_cxt
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

A context of another component, which is gone:

  $ mock these Mock:Guest0 --context guest.host_cxt/%n.rtc
  $ mock these Mock:Host0 --context host.host_cxt/%n.rtc
  $ rtec ../host.host_cxt/Host0.rtc attach ../guest.host_cxt/Guest0.rtc; kill-mock these3
  $ doctor -q ../guest.host_cxt | grep context
  warn  /localhost:$PORT/guest.host_cxt/Guest0.rtc: its execution context 1 belongs to another component, which does not answer; try: look at its contexts: rtec /localhost:$PORT/guest.host_cxt/Guest0.rtc

Managers: what they list must be there:

  $ doctor ../mgr.host_cxt
  warn  /: all components examined are Inactive: none has been started; try: rtact /localhost:$PORT/mgr.host_cxt/ConsoleIn0.rtc /localhost:$PORT/mgr.host_cxt/ConsoleOut0.rtc
  ok    /localhost:$PORT/mgr.host_cxt/ConsoleIn0.rtc: Inactive, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/mgr.host_cxt/ConsoleOut0.rtc: Inactive, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/mgr.host_cxt/manager.mgr: manager of 2 components, 2 slaves, at 127.0.0.1:* (glob)
  $ doctor -q ../lost.host_cxt
  fail  /localhost:$PORT/lost.host_cxt/ConsoleOut0.rtc: dead (zombie): * at 127.0.0.1:*; try: rtdel -z /localhost:$PORT/lost.host_cxt/ConsoleOut0.rtc (glob)
  fail  /localhost:$PORT/lost.host_cxt/manager.mgr: lists a slave that is gone; try: restart it; rtls /localhost:$PORT/lost.host_cxt/manager.mgr marks what is gone
  warn  /: all components examined are Inactive: none has been started; try: rtact /localhost:$PORT/lost.host_cxt/ConsoleIn0.rtc
  [1]
  $ doctor -q ../forgotten.host_cxt
  fail  /localhost:$PORT/forgotten.host_cxt/manager.mgr: lists a component that is gone; try: restart it; rtls /localhost:$PORT/forgotten.host_cxt/manager.mgr marks what is gone
  warn  /: all components examined are Inactive: none has been started; try: rtact /localhost:$PORT/forgotten.host_cxt/ConsoleIn0.rtc
  [1]
  $ ctl @managers fail get_slave_managers 1 NO_PERMISSION; doctor -q ../mgr.host_cxt | grep mgr:
  fail  /localhost:$PORT/mgr.host_cxt/manager.mgr: does not report what it has (CORBA.NO_PERMISSION); try: restart it; netstat -ltnp | grep :* there names its process (glob)
  $ ctl @managers fail get_components 1 TRANSIENT; doctor -q ../mgr.host_cxt | grep mgr:
  fail  /localhost:$PORT/mgr.host_cxt/manager.mgr: one of its slaves has died, and its components with it; try: restart that slave
  $ ctl @managers slave 1 hang manager 120; doctor -q --timeout 4 ../mgr.host_cxt | grep mgr:
  fail  /localhost:$PORT/mgr.host_cxt/manager.mgr: does not report what it has (no answer within 4s); try: restart it, or a slave that it waits for; netstat -ltnp | grep :* there names its process (glob)

A composite with a dead member, whether that exports a port or not:

  $ rtcomp -r Peer0:in ../half.host_cxt/composite0.rtc 2> out; doctor -q ../half.host_cxt/composite0.rtc
  fail  /localhost:$PORT/half.host_cxt/composite0.rtc: one of its members is dead: nothing answers at 127.0.0.1:*; try: restart its process, with all members alive (rtcomp cannot remove a dead one); netstat -ltnp | grep :* there names it (glob)
  warn  /: all components examined are Inactive: none has been started; try: rtact /localhost:$PORT/half.host_cxt/composite0.rtc
  [1]

The times in values:

  $ MOCK_CLOCK=-864000 mock senders 20 --context clock.host_cxt/%n.rtc
  $ rtdoctor -q --measure=5 ../clock.host_cxt | grep days
  warn  /localhost:$PORT/clock.host_cxt/Source0.rtc: the times in its values are 10.0 days behind this host's clock; try: compare the clocks (date, here and there) and set the wrong one: timedatectl
