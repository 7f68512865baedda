rtlog -p stays until what it plays can have been read, as rtinject does, and says so where it cannot.

world: senders 100 100
world: these ConsoleOut
once: it is the clock that counts here

  $ rtact ConsoleOut0.rtc; rtlog -q -i -e 30 -f a.rtlog Source0.rtc:number.n
  $ rtec ConsoleOut0.rtc rate 10; rtlog -q -p -f a.rtlog -r 10 ConsoleOut0.rtc:in.n; ctl @these received ConsoleOut0:in | cut -d' ' -f1
  30
  $ ctl @these buffer ConsoleOut0:in; ctl @these connectors ConsoleOut0:in
  8 overwrite
  $ rtec ConsoleOut0.rtc rate 1; rtlog -q -p -f a.rtlog -r 10 --linger 0.1 ConsoleOut0.rtc:in.n
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it executes at 1 Hz; it has read about * of 30 values; the rest is dropped (glob)
  [5]
  $ ctl @these waiting ConsoleOut0:in; ctl @these buffer ConsoleOut0:in
  0
  8 overwrite

Who is not going to read is sent nothing, without --anyway:

  $ rtdeact ConsoleOut0.rtc; ctl @these reset; rtlog -q -p -f a.rtlog ConsoleOut0.rtc:in.n
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it is Inactive and would read the values at some later connection; rtact /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc first, or --anyway
  [1]
  $ ctl @these calls ConsoleOut0 | grep -c 'connect\|put'
  0
  [1]
  $ rtlog -q -p -f a.rtlog -r 10 --anyway ConsoleOut0.rtc:in.n; ctl @these waiting ConsoleOut0:in
  8
