rtlog -p stays until what it plays can have been read, as rtinject does, and says so where it cannot.

world: senders 100 100
world: these ConsoleOut

  $ rtact ConsoleOut0.rtc; rtlog -q -i -e 30 -f a.rtlog Source0.rtc:number.n
  $ rtec ConsoleOut0.rtc rate 50
  $ rtlog -q -p -f a.rtlog -r 0.1 ConsoleOut0.rtc:in.n; ctl @these received ConsoleOut0:in | cut -d' ' -f1
  30
  $ ctl @these buffer ConsoleOut0:in; ctl @these connectors ConsoleOut0:in
  8 overwrite

What it refuses is counted:

  $ rtec ConsoleOut0.rtc rate 10
  $ rtlog -q -p -f a.rtlog -r 10 ConsoleOut0.rtc:in.n
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it refused * of 30 values: they came faster than it reads them (* Hz) (glob)
  [5]
  $ ctl @these waiting ConsoleOut0:in
  0

Who is not going to read is sent nothing, without --anyway:

  $ rtdeact ConsoleOut0.rtc
  $ ctl @these reset
  $ rtlog -q -p -f a.rtlog ConsoleOut0.rtc:in.n
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it is Inactive and would read the values at some later connection; rtact /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc first, or --anyway
  [1]
  $ ctl @these calls ConsoleOut0 | grep -c 'connect\|put'
  0
  [1]
  $ rtlog -q -p -f a.rtlog -r 10 --anyway ConsoleOut0.rtc:in.n; ctl @these waiting ConsoleOut0:in
  8

What has not been read after --linger is dropped:

  $ rtact ConsoleOut0.rtc
  $ rtec ConsoleOut0.rtc rate 0.1; rtlog -q -p -f a.rtlog -r 10 --linger 0.1 ConsoleOut0.rtc:in.n
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: its buffer is full (BUFFER_FULL)
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it refused 2? of 30 values (glob)
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it executes at 0.1 Hz; it has read about ? of ? values; the rest is dropped (glob)
  [5]
  $ ctl @these waiting ConsoleOut0:in; ctl @these buffer ConsoleOut0:in
  0
  8 overwrite
