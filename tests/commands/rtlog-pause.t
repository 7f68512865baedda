What comes while rtlog is held up waits in the component, as far as its memory is not burdened by that.

alone: time
world: senders 500 100
world: senders 20 300000 --context big.host_cxt/%n.rtc
both: each ORB receives and sends values in its own way

Values of any size, 500 a second, while rtlog does nothing for 0.2 s, four times:

  $ rtlog -q -f a.rtlog Source0.rtc:block.blocks & pid=$!
  $ soon '[ "$(wc -c 2>/dev/null <a.rtlog || echo 0)" -gt 10000 ]'
  $ for i in 1 2 3 4; do
  >     kill -STOP $pid
  >     sleep 0.2
  >     kill -CONT $pid
  >     sleep 0.3
  > done
  $ kill $pid; wait $pid
  [143]
  $ rtlog --json -f a.rtlog | python3 -c 'import base64, json, sys
  > numbers = [int.from_bytes(base64.b64decode(json.loads(line)["value"]["data"])[:8], "little") for line \
  >     in sys.stdin]
  > print(len(numbers) > 100, [n for n, m in zip(numbers, numbers[1:]) if m != n + 1])'
  True []

With the subscription that keeps a slow network from slowing the component, values wait in its buffer. How large they are is known
when they come: then the port gets a shorter one:

  $ rtlog -q -f b.rtlog --property dataport.subscription_type=new ../big.host_cxt/Source0.rtc:block & pid=$!
  $ until rtcat --json ../big.host_cxt/Source0.rtc:block | grep -o 'buffer.length": "55"'; do :; done
  buffer.length": "55"
  $ kill $pid; wait $pid
  [143]
  $ ctl @senders2 connectors Source0:block

A recorder that stood still lets components go: it connects anew before it leaves, and records each value once, with a time or
without one:

  $ entries() { rtlog --json -f $1 2>nul | grep -c "\"port\".*$2"; }
  $ numbers() { rtlog --json -f $1 | python3 -c 'import json, sys
  > numbers = [entry["value"]["data"] for entry in map(json.loads, sys.stdin) if \
  >     entry["port"].endswith(":number")]
  > print([(n, m) for n, m in zip(numbers, numbers[1:]) if m != n + 1])'; }
  $ rtlog -q -f c.mcap Source0.rtc & pid=$!
  $ soon '[ $(entries c.mcap :number) -gt 100 ]'
  $ kill -STOP $pid; sleep 3
  $ kill -CONT $pid
  $ soon 'rtcat --json Source0.rtc:number | grep "subscription_type.: .new"'
  $ before=$(entries c.mcap :number)
  $ soon '[ $(entries c.mcap :number) -gt $((before + 1000)) ]'
  $ ctl connectors Source0:number | wc -l
  1
  $ kill $pid; wait $pid
  [143]
  $ numbers c.mcap; rtlog -d -f c.mcap | grep Missing
  []
  [1]
