rtlog records a whole robot: every out port below a directory, now and later, and what happens.

world: observed
world: senders 100 100
alone: kills and time

  $ entries() { rtlog -d --json -f $1 2>/dev/null |
  > python3 -c "import json, sys; print([c['entries'] for c in json.load(sys.stdin)['channels'] if c['name'].endswith('$2')][0])"; }

A directory with events. A component that dies and comes back goes on in its channel; no port has two connectors. (With `new` none
is let go where the machine is busy.)

  $ rtlog -f a.mcap --events --property dataport.subscription_type=new . 2> told & pid=$!
  $ soon '[ $(entries a.mcap :number) -gt 20 ]'
  $ soon 'ctl observers ConsoleIn0 | grep Observer'; rtact ConsoleIn0.rtc
  $ ctl error ConsoleIn0
  $ ctl @senders connectors Source0:number | wc -l
  1
  $ kill-mock senders; soon 'rtlog --json -q -f a.mcap | grep DIED'
  $ before=$(entries a.mcap :number)
  $ mock senders 100 100; soon '[ $(entries a.mcap :number) -gt $((before + 50)) ]'
  $ soon 'rtlog --json -q -f a.mcap | grep BACK'
  $ kill $pid; wait $pid
  [143]
  $ cat told
  rtlog: Recording * ports. (glob)
  rtlog: /localhost:$PORT/test.host_cxt/Source0.rtc:number: the component is gone, and its process too
  rtlog: /localhost:$PORT/test.host_cxt/Source0.rtc:block: the component is gone, and its process too
  $ rtlog -d --json -f a.mcap | grep -o '"name": "[^"]*Source0[^"]*"\|closed": [a-z]*\|"system-1.rtsys"'
  "system-1.rtsys"
  "name": "/localhost:$PORT/test.host_cxt/Source0.rtc:number"
  "name": "/localhost:$PORT/test.host_cxt/Source0.rtc:block"
  closed": true
  $ rtlog --json -f a.mcap | grep rtlog.Event | grep 'RTC_STATUS\|DIED\|BACK' | sed 's/.*"value": //' |
  > sort -u
  {"event": "ACTIVE", "kind": "RTC_STATUS", "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc", "subject": "0"}}
  {"event": "BACK", "kind": "LIFE_EVENT", "path": "/localhost:$PORT/test.host_cxt/Source0.rtc", "subject": ""}}
  {"event": "DIED", "kind": "LIFE_EVENT", "mark": "Source0.rtc: died", "path": "/localhost:$PORT/test.host_cxt/Source0.rtc", "subject": ""}}
  {"event": "ERROR", "kind": "RTC_STATUS", "mark": "ConsoleIn0.rtc: Error", "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc", "subject": "0"}}
  $ rtplot -f a.mcap --ascii Source0.rtc:number | grep 's  .*rtc:' | sed 's/^[^ ]* s  //' | sort -u
  ConsoleIn0.rtc: Error
  Source0.rtc: died
  $ soon '[ -z "$(ctl @senders2 connectors Source0:number)" ]'; ctl observers ConsoleIn0

A channel says at which rate its component is executed, for others:

  $ python3 -c 'import re; print(*sorted(set(re.findall(rb"rate.{4}([0-9]+)", open("a.mcap", "rb").read(4000)))))'
  b'100' b'1000'

The profile of the system can be taken out:

  $ rtlog --attachment system-1.rtsys -f a.mcap > system.rtsys; grep -q Source0 system.rtsys
  $ rtlog --attachment other -f a.mcap
  rtlog: a.mcap: no such attachment: other (there are: *) (glob)
  [3]
  $ rtlog --attachment x -d -f a.mcap
  rtlog: --attachment takes only -f FILE (see --help)
  [2]

Some ports, and some of their values:

  $ rtlog -q -t 2 -f b.mcap --only '*number' --every 10 .
  $ [ $(entries b.mcap :number) -lt 30 ]; rtlog -d -f b.mcap | grep -c Channel
  1
  $ rtlog -q -t 2 -f b.mcap --not TimedLong --at-most '5:*block' 'Sou*'
  $ [ $(entries b.mcap :block) -lt 15 ]; rtlog -d -f b.mcap | grep -c Channel
  1
  $ rtlog -q -t 0.5 -f b.mcap Source0.rtc:number.x Source0.rtc
  $ rtlog -d --json -f b.mcap | grep -o '"name": "[^"]*"'
  "name": "x"
  "name": "/localhost:$PORT/test.host_cxt/Source0.rtc:block"

A component that may send more than 1,000 values a second does not call us in its own cycle, others do; all leave no connector:

  $ rtlog -q -f f.mcap . & pid=$!
  > soon '[ $(entries f.mcap :number) -gt 1 ]'
  > rtcat --json Source0.rtc:number | grep -o 'subscription_type": "[a-z]*"' | tail -n 1
  subscription_type": "flush"
  $ kill $pid; wait $pid
  [143]

A recorder that stood still lets components go, which would have waited for it:

  $ rtlog -f h.mcap --events Source0.rtc 2> told & pid=$!
  $ soon '[ $(entries h.mcap :number) -gt 1 ]'
  $ kill -STOP $pid; sleep 3
  $ kill -CONT $pid
  $ soon 'rtcat --json Source0.rtc:number | grep "subscription_type.: .new"'
  $ before=$(entries h.mcap :number); soon '[ $(entries h.mcap :number) -gt $before ]'
  $ kill $pid; wait $pid
  [143]
  $ cat told
  rtlog: Recording 2 ports.
  rtlog: this machine has too much to do: for *% of 5 s components would have waited for rtlog; 2 ports do not call it in their own cycle any more (glob)
  $ rtlog --json -f h.mcap | grep -c LET_GO
  2
  $ rtlog -f i.mcap --property dataport.subscription_type=flush Source0.rtc:number 2> told & pid=$!
  $ soon '[ $(entries i.mcap input0) -gt 1 ]'
  $ kill -STOP $pid; sleep 3
  $ kill -CONT $pid
  $ wait $pid
  [1]
  $ grep -v much told
  rtlog: /localhost:$PORT/test.host_cxt/Source0.rtc:number: given up, as its component would be held up

  $ kill-mock senders2; mock senders 2000 8
  $ rtlog -q -f g.mcap Source0.rtc & pid=$!
  > soon '[ $(entries g.mcap :number) -gt 1 ]'
  > rtcat --json Source0.rtc:number | grep -o 'subscription_type": "[a-z]*"' | tail -n 1
  subscription_type": "new"
  $ kill $pid; wait $pid
  [143]
  $ soon '[ -z "$(ctl @senders3 connectors Source0:number)" ]'

Connections come and go, are made again under their id, with another far end, too; those of tools are no part of the system:

  $ rtlog -q -f j.mcap --events . 2> nul & pid=$!
  $ soon '[ $(entries j.mcap :number) -gt 1 ]'
  $ number=/localhost:$PORT/test.host_cxt/Source0.rtc:number
  $ events() { rtlog --json -f j.mcap 2> nul | grep PORT_ | sed 's/.*"value": //'; }
  $ seen() { [ $(events | grep -c $1) = $2 ]; }
  $ rtprint -n 1 $number > nul; rtcon -i again $number ConsoleOut0.rtc:in
  $ soon 'seen _CONNECT 2'; rtdis -i again $number
  $ rtcon -i again $number ConsoleOut0.rtc:in
  $ soon 'seen _CONNECT 4'; rtdis -i again $number
  $ rtcon -i again $number Mock0.rtc:in; soon 'seen _CONNECT 6'
  $ rtdis -i again $number; soon 'seen _DISCONNECT 6'
  $ kill $pid; wait $pid
  [143]
  $ events | sed 's/.*event": "//; s/".*subject": "/ /; s/".*//' | sort | uniq -c | sed 's/^ *//'
  2 PORT_CONNECT ConsoleOut0.in
  1 PORT_CONNECT Mock0.in
  3 PORT_CONNECT Source0.number
  2 PORT_DISCONNECT ConsoleOut0.in
  1 PORT_DISCONNECT Mock0.in
  3 PORT_DISCONNECT Source0.number

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
