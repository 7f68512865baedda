rtlog records a whole robot: what is in the file besides values, and who calls whom. (What becomes of it while components die,
come back and change: tests/sim/stories/rtlog-robot.t.)

world: observed
world: senders 100 100

  $ entries() { rtlog -d --json -f $1 2>/dev/null |
  > python3 -c "import json, sys; print([c['entries'] for c in json.load(sys.stdin)['channels'] if c['name'].endswith('$2')][0])"; }
  $ rtlog -q -f a.mcap --events . & pid=$!
  > soon '[ $(entries a.mcap :number) -gt 20 ]' && soon 'rtlog --attachment system-1.rtsys -f a.mcap'
  > kill $pid; wait $pid
  [143]

A channel says at which rate its component is executed, for others:

  $ python3 -c 'import re; print(*sorted(set(re.findall(rb"rate.{4}([0-9]+)", open("a.mcap", "rb").read(4000)))))'
  b'100' b'1000'

The profile of the system can be taken out:

  $ rtlog --attachment system-1.rtsys -f a.mcap > system.rtsys; grep -q Source0 system.rtsys
  $ rtlog --attachment other -f a.mcap
  rtlog: a.mcap: no such attachment: other (there are: *) (glob)
  [3]
  $ rtlog --attachment x -d -f a.mcap
  rtlog: --attachment is for rtlog export, not for rtlog show (see --help)
  [2]

Some ports, and some of their values:

  $ rtlog -q -t 0.5 -f b.mcap Source0.rtc:number.x Source0.rtc
  $ rtlog -d --json -f b.mcap | grep -o '"name": "[^"]*"'
  "name": "x"
  "name": "/localhost:$PORT/test.host_cxt/Source0.rtc:block"

A component that may send more than 1,000 values a second does not call us in its own cycle (others do, unless we are late:
tests/sim/stories/rtlog-subscription.t); it is left no connector:

  $ kill-mock senders; mock senders 2000 8
  $ rtlog -q -f g.mcap Source0.rtc & pid=$!
  > soon '[ $(entries g.mcap :number) -gt 1 ]'
  > rtcat --json Source0.rtc:number | grep -o 'subscription_type": "[a-z]*"' | tail -n 1
  subscription_type": "new"
  $ kill $pid; wait $pid
  [143]
  $ soon '[ -z "$(ctl @senders2 connectors Source0:number)" ]'

What cannot be:

  $ rtlog -t 1 -f c.mcap ./nothing
  rtlog: /localhost:$PORT/test.host_cxt/nothing: no such path
  [3]
  $ rtlog -t 1 --events -f c.mcap Source0.rtc:number
  rtlog: --only, --not, --every, --at-most and --events need a PATH without a port (see --help)
  [2]
  $ rtlog -t 1 --every x -f c.mcap .
  rtlog: --every: not N or N:GLOB: x (see --help)
  [2]
  $ rtlog -t 1 --at-most 0:a -f c.mcap .
  rtlog: --at-most: not above 0: 0:a (see --help)
  [2]
  $ rtlog -t 1 -l text -f c.mcap .
  rtlog: -l text takes ports only (see --help)
  [2]
