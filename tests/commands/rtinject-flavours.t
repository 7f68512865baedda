rtinject sends to all implementations of OpenRTM. It waits for two cycles of a component and a bit: at 10 Hz
that is long enough for one on a busy machine, which may run 0.1 s late.

world: two --flavour cpp11 --rate 10 --context cpp11.host_cxt/%n.rtc
world: two --flavour cpp12 --rate 10 --context cpp12.host_cxt/%n.rtc
world: two --flavour cpp2 --rate 10 --context cpp2.host_cxt/%n.rtc
world: two --flavour py2 --rate 10 --context py2.host_cxt/%n.rtc
world: two --flavour java --rate 10 --context java.host_cxt/%n.rtc
world: two --flavour rtorb --rate 10 --context rtorb.host_cxt/%n.rtc

  $ for v in cpp11 cpp12 cpp2 py2 java rtorb; do rtact --wait ../$v.host_cxt/ConsoleOut0.rtc; done
  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do rtinject "$@" ../$v.host_cxt/ConsoleOut0.rtc:in; \
  >     done
  >   for w in two two2 two3 two4 two5 two6; do ctl @$w received ConsoleOut0:in 1; ctl @$w \
  >       connectors ConsoleOut0:in; done; }
  $ each -c '{"data": 1}'
  1 1
  1 1
  1 1
  1 1
  1 1
  1 1
  $ each -c 'RTC.TimedLong({time}, 2)' --property dataport.serializer.cdr.endian=big
  2 2
  2 2
  2 2
  2 2
  2 2
  2 2
  $ each -c '{"data": 3}' --property dataport.serializer.cdr.endian=big,little -n 2 -r 100
  4 3
  4 3
  4 3
  4 3
  4 3
  4 3

By data_service, where that is asked for; in both byte orders:

  $ for order in little big; do
  >     rtinject -c 7 --property dataport.interface_type=data_service \
  >         --property dataport.serializer.cdr.endian=$order ../cpp2.host_cxt/ConsoleOut0.rtc:in
  > done
  $ ctl @two3 received ConsoleOut0:in 6
  6 7
  $ ctl @two3 calls | grep push
  2 push
  $ ctl @two3 connectors ConsoleOut0:in
