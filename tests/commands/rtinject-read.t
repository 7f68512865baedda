rtinject stays until what it sends can have been read, and says so where it cannot.

alone: time
world: these ConsoleOut Mock:Mock0 ConsoleOut:Slow0 ConsoleIn
world: composite --context robot.host_cxt/%n.rtc
both: each ORB receives and sends values in its own way

A component reads in its own cycles, however seldom they come; none of its values stays behind:

  $ rtact ConsoleOut0.rtc Slow0.rtc ConsoleIn0.rtc
  $ for hz in 1000 100 10 2; do
  >     rtec ConsoleOut0.rtc rate $hz
  >     rtinject -c $hz ConsoleOut0.rtc:in
  >     ctl received ConsoleOut0:in
  > done
  1 1000
  2 100
  3 10
  4 2
  $ rtec ConsoleOut0.rtc rate 20
  $ yes 5 | head -n 30 | within 1.3-9 rtinject -r 0 ConsoleOut0.rtc:in
  $ ctl received ConsoleOut0:in
  34 5
  $ ctl waiting ConsoleOut0:in
  0
  $ ctl buffer ConsoleOut0:in
  8 overwrite
  $ ctl connectors ConsoleOut0:in
  $ rtec ConsoleOut0.rtc rate 1; rtinject -c 6 -n 4 -r 400 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: waiting * s until it has read the values (--linger limits it) (glob)
  $ ctl received ConsoleOut0:in
  38 6

A rate that it does not reach is reported once, and what was refused is counted; all that was taken is read:

  $ rtec ConsoleOut0.rtc rate 20; rtinject -c 7 -n 100 -r 400 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: values come faster than it reads them (* Hz) (glob)
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it refused * of 100 values: they came faster than it reads them (* Hz) (glob)
  [5]
  $ ctl waiting ConsoleOut0:in
  0

A context may claim more than it keeps, as real ones do on a busy computer; what was sent has been read all the same:

  $ rtec ConsoleOut0.rtc rate 5000; before=$(ctl received ConsoleOut0:in)
  $ seq 1 3000 | rtinject -r 0 ConsoleOut0.rtc:in; after=$(ctl received ConsoleOut0:in)
  $ echo $((${after% *} - ${before% *}))
  3000

--linger limits that; what has not been read is reported, and dropped, so that no later connection brings it:

  $ rtec Slow0.rtc rate 0.1; within 0.1-5 rtinject -c 7 --linger 0.1 Slow0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/Slow0.rtc:in: it executes at 0.1 Hz; it has read about 0 of 1 values; the rest is dropped
  [5]
  $ ctl waiting Slow0:in; ctl connectors Slow0:in
  0
  $ rtec ConsoleOut0.rtc rate 0.1; rtinject -q -c 7 --linger 0 Slow0.rtc:in ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/Slow0.rtc:in: it executes at 0.1 Hz; it has read about 0 of 1 values; the rest is dropped
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it executes at 0.1 Hz; it has read about 0 of 1 values; the rest is dropped
  [5]

Who is not going to read is sent nothing, without --anyway:

  $ rtec Slow0.rtc rate 20; rtec ConsoleOut0.rtc rate 20
  $ rtdeact --wait=30 Slow0.rtc; ctl reset
  $ rtinject -c 8 Slow0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/Slow0.rtc:in: it is Inactive and would read the values at some later connection; rtact /localhost:$PORT/test.host_cxt/Slow0.rtc first, or --anyway
  [1]
  $ ctl error Mock0; rtinject -c 8 Mock0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/Mock0.rtc:in: it is in Error and would read the values at some later connection; rtreset /localhost:$PORT/test.host_cxt/Mock0.rtc, then rtact /localhost:$PORT/test.host_cxt/Mock0.rtc first, or --anyway
  [1]
  $ rtact Slow0.rtc; rtec Slow0.rtc stop
  $ rtinject -c 8 Slow0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/Slow0.rtc:in: its execution context is stopped and would read the values at some later connection; rtec /localhost:$PORT/test.host_cxt/Slow0.rtc start first, or --anyway
  [1]
  $ rtinject -c 8 Slow0.rtc:in ConsoleOut0.rtc:in 2>/dev/null
  [5]
  $ rtinject -c 8 -n 20 -r 100 Slow0.rtc:in 2>/dev/null
  [1]
  $ ctl calls Slow0 | grep -c 'connect\|put'; ctl waiting Slow0:in
  0
  0
  $ rtinject -c 8 --anyway Slow0.rtc:in; ctl waiting Slow0:in
  1
  $ within 0.5-2 rtinject -c 8 --anyway --linger 0.5 Slow0.rtc:in; ctl waiting Slow0:in
  2
  $ rtinject -c 8 -n 20 -r 100 --anyway Slow0.rtc:in; ctl waiting Slow0:in
  8
  $ ctl buffer Slow0:in
  8 overwrite
  $ rtinject --dry-run -c 8 --anyway --linger 0.5 Slow0.rtc:in
  rtinject -c 8 -n 1 -r 1 --linger 0.5 --anyway /localhost:$PORT/test.host_cxt/Slow0.rtc:in

A member of a composite reads in the composite's context, and is activated there:

  $ rtinject -c 1 ../robot.host_cxt/Motor0.rtc:in
  rtinject: /localhost:$PORT/robot.host_cxt/Motor0.rtc:in: it is Inactive and would read the values at some later connection; rtact -e 1 /localhost:$PORT/robot.host_cxt/Motor0.rtc first, or --anyway
  [1]
  $ rtact --wait ../robot.host_cxt/composite0.rtc
  $ rtinject -c 1 ../robot.host_cxt/Motor0.rtc:in ../robot.host_cxt/composite0.rtc:Sensor0.in
  $ ctl @composite received Motor0:in; ctl @composite received Sensor0:in
  1 1.0
  1 1

Who stops reading meanwhile gets no more:

  $ rtec ConsoleOut0.rtc rate 100; rtdeact --wait=30 ConsoleOut0.rtc; rtact --wait=30 ConsoleOut0.rtc  # a period that has begun lasts
  $ rtinject -q -n -1 -r 50 -c 9 ConsoleOut0.rtc:in & pid=$!; soon 'ctl connectors ConsoleOut0:in | grep -q .'
  $ rtdeact ConsoleOut0.rtc; wait $pid
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it is Inactive now; it has read about * of * values; the rest is dropped (glob)
  [5]
  $ ctl waiting ConsoleOut0:in
  0
  $ ctl connectors ConsoleOut0:in; rtact ConsoleOut0.rtc

Values from stdin that come all at once wait as well, and what a buffer refuses is not called lost:

  $ rtec ConsoleOut0.rtc rate 20; before=$(ctl received ConsoleOut0:in)
  $ seq 101 140 | rtinject -q -r 0 ConsoleOut0.rtc:in
  $ after=$(ctl received ConsoleOut0:in); echo $((${after% *} - ${before% *}))
  40

Who stops reading is not waited for any longer:

  $ rtec ConsoleOut0.rtc rate 1
  $ seq 1 40 | within 0.1-15 rtinject -q -r 0 ConsoleOut0.rtc:in & pid=$!
  $ soon 'ctl waiting ConsoleOut0:in | grep -q 4'
  $ rtdeact ConsoleOut0.rtc; wait $pid
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it is Inactive now; it has read about ? of ? values; the rest is dropped (glob)
  [5]
  $ ctl waiting ConsoleOut0:in; rtact ConsoleOut0.rtc
  0

The buffer of a port that others are connected to stays as it is; sending faster than it is read is reported once:

  $ rtec ConsoleOut0.rtc rate 20; rtdeact ConsoleIn0.rtc
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtinject -c 1 -n 100 -r 400 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: values come faster than it executes (20 Hz)
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it executes at 20 Hz; it has probably read about 1? of 100 values; the rest is in its buffer, or overwritten (glob)
  [5]
  $ rtinject -c 1 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it has probably read the value: others are connected, and share its buffer

Whoever writes to the port, too, may push values out of its buffer: an Active component, or another tool. That fetched values wait
elsewhere:

  $ rtact --wait=30 ConsoleIn0.rtc; rtinject -c 1 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: sent; others write to this port, so whether it was read is not known
  [5]
  $ rtinject -c 1 -n 3 -r 10 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: sent; others write to this port, so whether the 3 values were read is not known
  [5]
  $ rtdis ConsoleOut0.rtc:in
  $ rtcon -p dataflow_type=pull ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtinject -c 1 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it has probably read the value: others are connected, and share its buffer
  $ rtdis ConsoleOut0.rtc:in
  $ rtinject -q -c 1 -n -1 -r 20 ConsoleOut0.rtc:in & pid=$!
  $ soon 'ctl connectors ConsoleOut0:in | grep -q .'
  $ rtinject -c 1 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: sent; others write to this port, so whether it was read is not known
  [5]
  $ kill $pid; wait $pid
  [143]
  $ ctl buffer ConsoleOut0:in
  8 overwrite
  $ ctl connectors ConsoleOut0:in; rtact ConsoleIn0.rtc

One that the user asks for is reckoned with:

  $ rtec ConsoleOut0.rtc rate 20; before=$(ctl received ConsoleOut0:in)
  $ rtinject -q -c 5 -n 40 -r 400 --property dataport.buffer.length=100 ConsoleOut0.rtc:in
  $ after=$(ctl received ConsoleOut0:in); echo $((${after% *} - ${before% *}))
  40

A buffer that somebody else asks for meanwhile stays as it is:

  $ rtdeact ConsoleIn0.rtc
  $ rtec ConsoleOut0.rtc rate 1
  $ rtinject -q -c 1 -n 12 -r 400 --linger 2 ConsoleOut0.rtc:in 2>/dev/null & pid=$!
  $ soon "ctl buffer ConsoleOut0:in | grep -q '^4 '"
  $ rtcon -p dataport.buffer.length=64 ConsoleIn0.rtc:out ConsoleOut0.rtc:in; wait $pid
  [5]
  $ ctl buffer ConsoleOut0:in
  64 overwrite
  $ rtdis ConsoleOut0.rtc:in; rtact ConsoleIn0.rtc

What a port refuses is counted; a buffer that the user has asked for is left alone:

  $ rtec Slow0.rtc rate 0.1; rtec Slow0.rtc start
  $ rtinject -q -c 1 -n 20 -r 400 --linger 0 --property dataport.buffer.length=2 \
  >     --property dataport.buffer.write.full_policy=do_nothing Slow0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/Slow0.rtc:in: its buffer is full (BUFFER_FULL)
  rtinject: /localhost:$PORT/test.host_cxt/Slow0.rtc:in: it refused 1? of 20 values (glob)
  rtinject: /localhost:$PORT/test.host_cxt/Slow0.rtc:in: it executes at 0.1 Hz; it has read about ? of ? values; the rest is dropped (glob)
  [5]

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
  rtlog: --linger and --anyway are for playing to ports (see --help)
  [2]
