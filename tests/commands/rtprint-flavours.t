rtprint reads from all implementations of OpenRTM, by push and pull, in both byte orders.

world: senders 50 12 --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: senders 50 12 --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: senders 50 12 --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: senders 50 12 --flavour py2 --context py2.host_cxt/%n.rtc
world: senders 50 12 --flavour java --context java.host_cxt/%n.rtc
world: senders 50 12 --flavour rtorb --context rtorb.host_cxt/%n.rtc
world: senders 50 12 dataflow=pull --context pull.host_cxt/%n.rtc
world: senders 50 12 interfaces=data_service,direct --context service.host_cxt/%n.rtc
world: senders 50 12 interfaces=direct,shared_memory --context direct.host_cxt/%n.rtc
world: senders 4 10000000 --flavour cpp2 --context big.host_cxt/%n.rtc

  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do rtprint -n 3 ../$v.host_cxt/Source0.rtc:number \
  >     "$@" 2>&1 |
  >   awk -v v=$v '/^\[/ { if ($2 > 0 && $2 < 65536) n++; next } { print } END { print v, n }'; done; }
  $ each
  cpp11 3
  cpp12 3
  cpp2 3
  py2 3
  java 3
  rtorb 3
  $ each --property dataport.serializer.cdr.endian=big
  cpp11 3
  cpp12 3
  cpp2 3
  py2 3
  java 3
  rtorb 3
  $ each --property dataport.serializer.cdr.endian=big,little --property dataport.subscription_type=flush
  cpp11 3
  cpp12 3
  cpp2 3
  py2 3
  java 3
  rtorb 3
  $ each --property dataport.subscription_type=periodic --property dataport.publisher.push_rate=40
  cpp11 3
  cpp12 3
  cpp2 3
  py2 3
  java 3
  rtprint: /localhost:$PORT/rtorb.host_cxt/Source0.rtc:number: has no subscription_type periodic (it has: flush)
  rtorb\x20 (esc)
  $ each --pull
  cpp11 3
  cpp12 3
  cpp2 3
  py2 3
  java 3
  rtprint: /localhost:$PORT/rtorb.host_cxt/Source0.rtc:number: has no dataflow_type pull (it has: push)
  rtorb\x20 (esc)
  $ each --pull --property dataport.serializer.cdr.endian=big
  cpp11 3
  cpp12 3
  cpp2 3
  py2 3
  java 3
  rtprint: /localhost:$PORT/rtorb.host_cxt/Source0.rtc:number: has no dataflow_type pull (it has: push)
  rtorb\x20 (esc)

Ports that offer something else only:

  $ rtprint -v -n 2 ../pull.host_cxt/Source0.rtc:number | wc -l
  rtprint: /localhost:$PORT/pull.host_cxt/Source0.rtc:number: connected (pull), id $UUID
  2
  $ rtprint -v -n 2 ../service.host_cxt/Source0.rtc:number | wc -l
  rtprint: /localhost:$PORT/service.host_cxt/Source0.rtc:number: connected (push), id $UUID
  2
  $ rtprint -v --pull -n 2 ../service.host_cxt/Source0.rtc:number | wc -l
  rtprint: /localhost:$PORT/service.host_cxt/Source0.rtc:number: connected (pull), id $UUID
  2
  $ rtprint -n 2 ../direct.host_cxt/Source0.rtc:number
  rtprint: /localhost:$PORT/direct.host_cxt/Source0.rtc:number: offers no corba_cdr and no data_service (it has: direct, shared_memory)
  [6]
  $ rtprint -n 2 ../service.host_cxt/Source0.rtc:number --property dataport.interface_type=corba_cdr
  rtprint: /localhost:$PORT/service.host_cxt/Source0.rtc:number: offers no corba_cdr (it has: data_service, direct)
  [6]

Values of 10 MB, pushed and fetched, shown and recorded:

  $ rtprint --stats -n 3 ../big.host_cxt/Source0.rtc:block | tail -n 1 | sed 's/.*all: //; s/, .*//'
  3 values
  $ rtprint --stats --pull -n 3 ../big.host_cxt/Source0.rtc:block | tail -n 1 | sed 's/.*all: //; s/, .*//'
  3 values
  $ rtprint -n 1 ../big.host_cxt/Source0.rtc:block 2>/dev/null | wc -c
  30000025
  $ rtprint --json -n 1 ../big.host_cxt/Source0.rtc:block 2>/dev/null | awk '{ print int(length($0) / 1000) }'
  13333
  $ rtlog -q -i -e 3 -f big.rtlog ../big.host_cxt/Source0.rtc:block
  $ rtlog --json -f big.rtlog | awk '{ print int(length($0) / 1000) }'
  13333
  13333
  13333

None is left:

  $ for w in senders senders2 senders3 senders4 senders5 senders6 senders7 senders8 senders9 senders10; do
  >   ctl @$w connectors Source0:number; ctl @$w connectors Source0:block; done

Refused by the component; RtORB takes one connection a port:

  $ ctl refuse Source0:number RTC_ERROR; rtprint -n 1 ../cpp11.host_cxt/Source0.rtc:number
  rtprint: /localhost:$PORT/cpp11.host_cxt/Source0.rtc:number: refused by the component (RTC_ERROR)
  [6]
  $ ctl fail connect 1 NO_PERMISSION; rtprint -n 1 ../cpp11.host_cxt/Source0.rtc:number
  rtprint: /localhost:$PORT/cpp11.host_cxt/Source0.rtc:number: CORBA.NO_PERMISSION
  [6]
  $ rtprint --property dataport.serializer.cdr.endian=middle ../cpp2.host_cxt/Source0.rtc:number
  rtprint: /localhost:$PORT/cpp2.host_cxt/Source0.rtc:number: refused by the component (UNSUPPORTED)
  [6]
