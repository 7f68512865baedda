Values are fetched from components of C++ without ending them: no connector goes while a fetch is being served.

world: senders 200 100 --flavour cpp2
world: these ConsoleIn --flavour cpp12 --context old.host_cxt/%n.rtc
both: each ORB receives and sends values in its own way

  $ rtact --wait ../old.host_cxt/ConsoleIn0.rtc
  $ alive() {
  >     rtls Source0.rtc ../old.host_cxt/ConsoleIn0.rtc && ctl connectors Source0:number &&
  >         ctl @these connectors ConsoleIn0:out
  > }

Ended by itself, by a reader that goes away, by each signal:

  $ for i in 1 2 3 4 5 6 7 8; do
  >     rtprint --pull -n $i Source0.rtc:number ../old.host_cxt/ConsoleIn0.rtc:out > /dev/null || echo $?
  > done
  $ rtprint --pull -t 0.5 --stats Source0.rtc:number | grep -c 'all in all: [1-9]'
  1
  $ rtprint --pull Source0.rtc:number | head -n 2 | wc -l
  2
  $ for signal in INT TERM HUP; do for command in "rtprint --pull" "rtlog -q -f a.rtlog --pull" \
  >     "rtec --measure 20"; do
  >   port=:number; [ "$command" != "rtec --measure 20" ] || port=
  >   timeout -s $signal --foreground 1 $command Source0.rtc$port > /dev/null &&
  >       echo "ended by itself"; done; done
  [124]
  $ alive
  Source0.rtc
  ConsoleIn0.rtc
  $ rtlog -q --pull -i -e 20 -f b.rtlog Source0.rtc:number Source0.rtc:block \
  >     ../old.host_cxt/ConsoleIn0.rtc:out
  $ rtlog -d -f b.rtlog | grep -c '^Number of entries: 20'
  1
  $ rtec --measure 0.3 Source0.rtc | grep -c 'measured.*Hz'
  1
  $ rtec --measure 0.3 ../old.host_cxt/ConsoleIn0.rtc | grep -c 'measured.*Hz'
  1
  $ rtdoctor -q --measure 0.3 Source0.rtc ../old.host_cxt/ConsoleIn0.rtc | grep keeps
  warn  /localhost:$PORT/old.host_cxt/ConsoleIn0.rtc: keeps * of 1000 Hz, or does not write to out in each cycle; * (glob)
  $ alive
  Source0.rtc
  ConsoleIn0.rtc

Where a fetch is not answered, the connector stays; the command that is printed removes it later:

  $ ctl delay get 2
  $ RTSHELL_TIMEOUT=0.5 within 0.5-3 rtprint --pull -t 0.5 Source0.rtc:number > /dev/null 2>said
  [4]
  $ grep -o 'rtdis.*' said
  rtdis -i $UUID /localhost:$PORT/test.host_cxt/Source0.rtc:number
  $ ctl reset
  > until [ "$(ctl highwater)" = 0 ]; do ctl reset; done
  > sh -c "$(grep -o 'rtdis.*' said)"
  > alive
  Source0.rtc
  ConsoleIn0.rtc
