A reader on this host is called by the component in its own cycle, and leaves without touching its connector: removing that
of a publisher has ended components.

world: senders 500 100
world: senders 50 100 --context slow.host_cxt/%n.rtc
both: each ORB receives and sends values in its own way

  $ rtprint -q Source0.rtc:number >/dev/null & pid=$!; soon 'ctl connectors Source0:number | grep -q rtprint'
  $ rtcat --json Source0.rtc:number | grep -o 'subscription_type": "[a-z]*"' | tail -n 1
  subscription_type": "flush"
  $ kill $pid; wait $pid
  [143]
  $ ctl connectors Source0:number

It waits 0.2 s, which a component on a busy machine may need for itself: some of five removals may be rtprint's.

  $ leave() {
  >     rtprint -q Source0.rtc:number >/dev/null & soon 'ctl connectors Source0:number | grep rtprint'
  >     kill $!
  >     wait $!
  > }
  $ ctl reset; for i in 1 2 3 4 5; do leave; done
  [143]
  $ test $(calls Source0 | grep -c disconnect) -lt 4; ctl connectors Source0:number

Again and again; none of it touches a reference that is in use:

  $ for i in 1 2 3 4 5 6 7 8 9 10; do
  >     rtprint -q -n 2 Source0.rtc:number >/dev/null
  >     rtlog -q -i -e 2 -f a.rtlog Source0.rtc:number
  > done
  $ ctl near_misses; ctl connectors Source0:number
  0

What the user asks for counts:

  $ rtprint -q --property dataport.subscription_type=new Source0.rtc:number >/dev/null & pid=$!
  $ soon 'ctl connectors Source0:number | grep -q rtprint'
  $ rtcat --json Source0.rtc:number | grep -o 'subscription_type": "[a-z]*"' | tail -n 1
  subscription_type": "new"
  $ kill $pid; wait $pid
  [143]

Its connector is removed when an answer has been sent (test_connection). A publisher on a busy machine may not have taken that
yet, which we cannot know: most removals are in time.

  $ for i in 1 2 3 4 5 6 7 8 9 10; do
  >     rtprint -q -n 2 --property dataport.subscription_type=new ../slow.host_cxt/Source0.rtc:number \
  >         >/dev/null
  > done
  $ ctl @senders2 near_misses | grep -c '^[0-3]$'; ctl @senders2 connectors Source0:number
  1

Nobody reads what rtprint prints into a pipe that is full; the component goes on:

  $ mkfifo full; sleep 600 >/dev/null <full & reader=$!
  $ head -c 65536 /dev/zero >full
  $ rtprint -q Source0.rtc:number >full & pid=$!
  $ soon 'ctl connectors Source0:number | grep -q rtprint'
  $ sent() { test $(ctl sent Source0:number) -gt $1; }
  $ many=$(($(ctl sent Source0:number) + 1000)); soon 'sent $many'
  $ kill $pid; wait $pid
  [143]
  $ kill $reader

Ctrl-Z leaves before it stops, for a stopped reader would stop the component; fg connects again:

  $ rtprint -q Source0.rtc:number >printed & pid=$!; soon 'test -s printed'
  $ kill -TSTP $pid; soon "grep -q 'State:.*stopped' /proc/$pid/status"
  $ ctl connectors Source0:number
  $ many=$(($(ctl sent Source0:number) + 300)); soon 'sent $many'
  $ lines=$(wc -l <printed); kill -CONT $pid
  $ soon 'test $(wc -l <printed) -gt $lines'; kill $pid
  $ wait $pid
  [143]
  $ ctl connectors Source0:number
