Values are fetched from components of C++ without ending them, by each ORB, also where the reader of the output goes away. (More of
it: tests/sim/stories/rtprint-pull.t.)

world: senders 200 100 --flavour cpp2
world: these ConsoleIn --flavour cpp12 --context old.host_cxt/%n.rtc
both: each ORB receives and sends values in its own way

  $ rtact --wait ../old.host_cxt/ConsoleIn0.rtc
  $ for i in 1 2 3; do
  >     rtprint --pull -n $i Source0.rtc:number ../old.host_cxt/ConsoleIn0.rtc:out > /dev/null || echo $?
  > done
  $ rtprint --pull Source0.rtc:number | head -n 2 | wc -l
  2
  $ for signal in INT TERM; do for command in "rtprint --pull" "rtlog -q -f a.rtlog --pull"; do
  >   interrupt 1:$signal $command Source0.rtc:number > nul && echo "ended by itself"
  >   grep " it$" nul
  > done; done
  [1]

Where a fetch is not answered, the connector stays; the command that is printed removes it later:

  $ ctl delay get 6
  $ RTSHELL_TIMEOUT=2 within 0.5-9 rtprint --pull -t 0.5 Source0.rtc:number > /dev/null 2>said
  [4]
  $ ctl reset
  $ until [ "$(ctl highwater)" = 0 ]; do ctl reset; done
  $ sh -c "$(grep -o 'rtdis.*' said)"
  $ rtls Source0.rtc ../old.host_cxt/ConsoleIn0.rtc
  Source0.rtc
  ConsoleIn0.rtc
  $ ctl connectors Source0:number; ctl @these connectors ConsoleIn0:out
