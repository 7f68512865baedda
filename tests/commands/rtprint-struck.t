Signals that strike while the reader of the output takes nothing leave no connection behind. (While connections are made or
removed: tests/sim/stories/rtprint-struck.t.)

world: senders 500 12

While the reader of the output takes nothing:

  $ mkfifo pipe; sleep 600 < pipe & reader=$!
  $ rtprint --json Source0.rtc:number > pipe & pid=$!
  $ soon '[ -n "$(ctl connectors Source0:number)" ]'; n=$(ctl sent Source0:number)
  $ soon '[ $(ctl sent Source0:number) -gt $((n + 999)) ]'
  $ kill $pid; within 0-9 tail --pid=$pid -f /dev/null
  $ wait $pid
  [143]
  $ kill $reader; ctl connectors Source0:number
