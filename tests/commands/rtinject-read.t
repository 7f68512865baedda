rtinject stays until what comes from stdin can have been read. (More of it is in tests/sim/stories/rtinject-read.t.)

world: these ConsoleOut ConsoleIn

  $ rtact ConsoleOut0.rtc ConsoleIn0.rtc; rtec ConsoleOut0.rtc rate 20
  $ yes 5 | head -n 30 | within 1.3-30 rtinject -r 0 ConsoleOut0.rtc:in
  $ ctl received ConsoleOut0:in
  30 5
  $ ctl waiting ConsoleOut0:in
  0

A context may claim more than it keeps, as real ones do on a busy computer; what was sent has been read all the same:

  $ rtec ConsoleOut0.rtc rate 5000; before=$(ctl received ConsoleOut0:in)
  $ seq 1 3000 | rtinject -r 0 ConsoleOut0.rtc:in; after=$(ctl received ConsoleOut0:in)
  $ echo $((${after% *} - ${before% *}))
  3000

Values from stdin that come all at once wait as well, and what a buffer refuses is not called lost:

  $ rtec ConsoleOut0.rtc rate 20; before=$(ctl received ConsoleOut0:in)
  $ seq 101 140 | rtinject -q -r 0 ConsoleOut0.rtc:in
  $ after=$(ctl received ConsoleOut0:in); echo $((${after% *} - ${before% *}))
  40

Who stops reading is not waited for any longer:

  $ rtec ConsoleOut0.rtc rate 1
  $ seq 1 40 | within 0.1-60 rtinject -q -r 0 ConsoleOut0.rtc:in & pid=$!
  $ soon 'ctl waiting ConsoleOut0:in | grep -q 4'
  $ rtdeact ConsoleOut0.rtc; wait $pid
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it is Inactive now; it has read about * of * values; the rest is dropped (glob)
  [5]
  $ ctl waiting ConsoleOut0:in; rtact ConsoleOut0.rtc
  0

Connections in which this command can take no part are refused before anybody is asked:

  $ ctl reset
  $ rtinject -c 1 --property dataport.dataflow_type=duplex ConsoleOut0.rtc:in
  rtinject: dataport.dataflow_type=duplex: this command can only take part in connections with push (see --help)
  [2]
  $ rtinject -c 1 --property dataport.interface_type=shared_memory ConsoleOut0.rtc:in
  rtinject: dataport.interface_type=shared_memory: this command can only take part in connections with corba_cdr or data_service (see --help)
  [2]
  $ rtprint --property dataport.dataflow_type=duplex ConsoleIn0.rtc:out
  rtprint: dataport.dataflow_type=duplex: this command can only take part in connections with push or pull (see --help)
  [2]
  $ rtlog -f a.rtlog --property dataport.interface_type=direct ConsoleIn0.rtc:out
  rtlog: dataport.interface_type=direct: this command can only take part in connections with corba_cdr or data_service (see --help)
  [2]
  $ rtlog -p -f a.rtlog --property dataport.interface_type=csp_channel ConsoleOut0.rtc:in
  rtlog: dataport.interface_type=csp_channel: this command can only take part in connections with corba_cdr or data_service (see --help)
  [2]
  $ ctl calls

Wrong usage:

  $ rtinject -c 1 --linger -1 ConsoleOut0.rtc:in
  rtinject: argument --linger: not a number of seconds above 0: -1 (see --help)
  [2]
  $ rtlog -f a.rtlog --anyway ConsoleIn0.rtc:out
  rtlog: --anyway is for rtlog play, not for rtlog record (see --help)
  [2]
