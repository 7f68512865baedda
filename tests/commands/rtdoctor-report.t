rtdoctor --report writes what it has seen into one page, from which --from and other commands read.

world: robot --rate 10
world: these ConfigSample
world: hostile --context h.host_cxt/%n.rtc
world: managers --context m.host_cxt/%n.rtc
world: zombie 1 --context z.host_cxt/%n.rtc
faulty: bad-profiles

  $ rtact --wait Sensor0.rtc Motor0.rtc

The findings are printed as ever, and are in the file:

  $ rtdoctor --report a.html > now; echo $?
  1
  $ rtdoctor --from a.html > again
  [1]
  $ cmp now again
  $ rtdoctor --from a.html -q --json | grep -c zombie
  1
  $ has a.html '"level":"fail"' 'dead (zombie)' '"name":"Motor0"' '"state":"Active"' \
  >     'Configuration set mode1 (active)' 'manager of 2'
  $ grep -o '"name":"Mock0","path":"[^"]*","state":"[A-Za-z]*"' a.html
  "name":"Mock0","path":"/localhost:$PORT/z.host_cxt/Mock0.rtc","state":"Unknown"
  $ has a.html 'RTCTREE_NAMESERVERS=' '/etc/hosts' 'mock_components' 'It contains the findings' \
  >     'Max open files'

The profile in it is one for other commands. The dead one is on the map, and not in the profile:

  $ rtcheck a.html 2>&1 | grep -e Mock0 -e Motor0 -e Controller0; rtstodot a.html | grep 'Motor0:'
  Component /localhost:$PORT/test.host_cxt/Controller0.rtc is in incorrect state Inactive, not Active
    Controller0:out -> Motor0:in;
    Motor0:out -> Sensor0:in;
  $ rtdis Motor0.rtc:out Sensor0.rtc:in; rtcheck a.html 2>&1 | grep Motor0
  No connection between /localhost:$PORT/test.host_cxt/Motor0.rtc:out and /localhost:$PORT/test.host_cxt/Sensor0.rtc:in
  $ rtresurrect -q a.html; rtcheck a.html 2>&1 | grep -c Motor0
  0
  [1]

Each component is asked once:

  $ ctl reset; rtdoctor -q --report a.html > now
  [1]
  $ ctl calls Motor0
  1 _non_existent
  1 get_active_configuration_set
  1 get_component_profile
  1 get_component_state
  1 get_configuration
  1 get_configuration_sets
  1 get_context_handle
  1 get_organizations
  1 get_owned_contexts
  1 get_owned_organizations
  1 get_participating_contexts
  2 get_port_profile
  1 get_ports
  1 get_profile
  1 is_running

With --measure, clocks are compared where values have times:

  $ mock senders 50 8 --context s.host_cxt/%n.rtc
  $ rtdoctor -q --measure=5 --report a.html ../s.host_cxt > now
  $ grep -o 'Source0.rtc  at 127.0.0.1:[0-9]*: a value of number was stamped [0-9.]* s before it came here' \
  >     a.html |
  > sed 's/1:[0-9]*/1:PORT/; s/[0-9.]* s /N s /'
  Source0.rtc  at 127.0.0.1:PORT: a value of number was stamped N s before it came here

What others are not to see:

  $ rtdoctor -q --report a.html --no-values --no-environment > now
  [1]
  $ grep -c -e mode1 -e RTCTREE_NAMESERVERS= -e 'open files' -e 'Interfaces' a.html
  0
  [1]
  $ has a.html '"name":"ConfigSample0"' 'dead (zombie)'

To stdout; nothing that a component says is markup:

  $ rtdoctor --report - > a.html
  [1]
  $ grep -c '<script' a.html
  2
  $ has a.html u003cscript

The last values of a log, and what happened, as a plot:

  $ rtlog -q -i -e 5 -f run.mcap Sensor0.rtc:out
  $ rtdoctor -q --report a.html --log run.mcap > now; has a.html '"plots":.."The last 30 s of run.mcap"'

The component that a finding is about comes first, with its values and its events:

  $ ctl error Sensor0; rtdoctor -q --report a.html --log run.mcap > now
  [1]
  $ grep -o '"plots":.."[^"]*"' a.html
  "plots":[["/localhost:$PORT/test.host_cxt/Sensor0.rtc: in Error: the last 30 s of its out ports"
  $ rtlog -q --events -f events.mcap . & recording=$!
  $ watched Sensor0; rtreset Sensor0.rtc
  $ ctl error Sensor0
  $ soon 'rtlog --json -f events.mcap | grep ERROR'
  $ kill $recording; wait $recording
  [143]
  $ rtdoctor -q --report a.html --log events.mcap > now
  [1]
  $ grep -o '"[^"]*: its last events in events.mcap"' a.html
  "/localhost:$PORT/test.host_cxt/Sensor0.rtc: in Error: its last events in events.mcap"
  $ rtreset Sensor0.rtc; rtact --wait Sensor0.rtc

  $ rtdoctor -q --report a.html --log gone.mcap > now
  rtdoctor: gone.mcap: No such file or directory
  [1]

As what a trigger of a recording starts, which adds the name of its file:

  $ rtlog -q --ring 4 --after 0.5 --then 'rtdoctor -q --report b.html --log' \
  >     -f c.mcap Sensor0.rtc:out > told 2>&1 &
  >     pid=$!
  $ soon 'ctl connectors Sensor0:out | grep rtlog'; sent=$(ctl sent Sensor0:out)
  $ soon '[ $(ctl sent Sensor0:out) -gt $((sent + 2)) ]'
  $ until rtlog --trigger-now c.mcap 2>/dev/null; do :; done; soon '[ -e b.html ]'
  $ kill $pid; wait $pid
  [143]
  $ grep -c '"plots":.."The last 30 s of c-[-0-9]*now.mcap"' b.html
  1

Where nothing can be looked at, the file says so:

  $ rtdoctor -q --report a.html localhost:1 > now
  [1]
  $ has a.html 'connection refused'

A name that is bound to nothing usable:

  $ rtdoctor -q --report a.html localhost:$BAD_PROFILES > now
  [1]
  $ has a.html 'Evil0.rtc.*garbled answer'

Files that are no report, wrong usage:

  $ rtstodot --html b.html a.html
  rtstodot: nothing to draw: the file has no components
  $ rtdoctor --from b.html
  rtdoctor: b.html: a page without a profile; rtdoctor --report writes one with a profile
  [1]
  $ rtcheck b.html
  rtcheck: b.html: a page without a profile; rtdoctor --report writes one with a profile
  [1]
  $ echo hello > c.html; rtdoctor --from c.html
  rtdoctor: c.html: not a page of these commands
  [1]
  $ rtdoctor --from gone.html
  rtdoctor: gone.html: No such file or directory
  [1]
  $ block='<!DOCTYPE html><script type="application/json" id="system">'
  $ echo "$block"'{"profile":"","findings":[{}]}</script>' > d.html
  $ rtdoctor --from d.html
  rtdoctor: d.html: not a report of rtdoctor
  [1]
  $ rtcheck d.html
  rtcheck: d.html:1:1: the file is empty
  [1]
  $ echo "$block"'[[[</script>' > d.html; rtdoctor --from d.html
  rtdoctor: d.html: its data are damaged
  [1]
  $ rtdoctor --from a.html --report b.html
  rtdoctor: --from examines nothing: no PATH, --profile, --measure, --twice or --report goes with it (see --help)
  [2]
  $ rtdoctor --no-values
  rtdoctor: --log, --no-values and --no-environment are for --report (see --help)
  [2]
  $ rtdoctor --report a.html --no-values --log run.mcap
  rtdoctor: --log does not go with --no-values: a log has nothing but values (see --help)
  [2]
  $ rtdoctor --report "$OUT" > now
  rtdoctor: argument --report: the name is empty (see --help)
  [2]
  $ rtdoctor --report nowhere/a.html > now
  rtdoctor: nowhere/a.html: No such file or directory
  [1]
