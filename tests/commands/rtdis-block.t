rtdis, rtteardown and rtkeep leave a connection in which a value may wait: full_policy=block.

world: sources 1 100 8 --flavour cpp2
world: these ConsoleOut --flavour cpp2
both: each ORB waits in its own way

A component of C++ ends when such a connection is removed while a value waits for room in the buffer of its in port.

  $ export XDG_RUNTIME_DIR=$PWD
  $ rtcon -i one -p dataport.inport.buffer.write.full_policy=block Source0.rtc:number ConsoleOut0.rtc:in
  rtcon: /localhost:$PORT/test.host_cxt/Source0.rtc:number to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: writers wait while its buffer is full (full_policy=block): remove it only while its source is Inactive, as rtdis does
  $ rtcryo --all -o a.xml localhost:$PORT
  $ soon '[ $(ctl @these blocked ConsoleOut0:in) = 1 ]'; rtdis Source0.rtc:number
  rtdis: /localhost:$PORT/test.host_cxt/Source0.rtc:number: connection one makes its writers wait (full_policy=block), and /localhost:$PORT/test.host_cxt/Source0.rtc is Active: to remove it now may end the process of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc; first: rtdeact /localhost:$PORT/test.host_cxt/Source0.rtc (rtdis --force removes it all the same)
  [6]
  $ rtdis -i one ConsoleOut0.rtc
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: connection one makes its writers wait (full_policy=block), and /localhost:$PORT/test.host_cxt/Source0.rtc is Active: to remove it now may end the process of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc; first: rtdeact /localhost:$PORT/test.host_cxt/Source0.rtc (rtdis --force removes it all the same)
  [6]
  $ rtteardown a.xml
  rtteardown: /localhost:$PORT/test.host_cxt/Source0.rtc:number: connection one makes its writers wait (full_policy=block), and /localhost:$PORT/test.host_cxt/Source0.rtc is Active: to remove it now may end the process of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc; first: rtdeact /localhost:$PORT/test.host_cxt/Source0.rtc (rtdis --force removes it all the same)
  rtteardown: 1 failed
  [6]
  $ rtsh -c 'dis Source0.rtc'
  rtdis: /localhost:$PORT/test.host_cxt/Source0.rtc:number: connection one makes its writers wait (full_policy=block), and /localhost:$PORT/test.host_cxt/Source0.rtc is Active: to remove it now may end the process of /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc; first: rtdeact /localhost:$PORT/test.host_cxt/Source0.rtc (rtdis --force removes it all the same)
  [6]

rtdoctor says how to remove it.

  $ rtdoctor -q | grep full_policy | said
  warn  ConsoleOut0.rtc:in: connection one makes its writers wait (full_policy=block): to remove it while one of them is Active may end this process; try: before you remove it: rtdeact Source0.rtc (rtdis then waits until no value waits)

While nothing is written to it, and nothing waits any more, it is removed; also where its source is gone.

  $ rtdeact Source0.rtc; rtdis -v Source0.rtc:number
  rtdis: /localhost:$PORT/test.host_cxt/Source0.rtc:number: removed connection one
  $ rtls -l
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  0/0  2/0  0/0  Source0.rtc
  $ rtcon -q -i one -p dataport.buffer.write.full_policy=block Source0.rtc:number ConsoleOut0.rtc:in
  $ rtdis -v ConsoleOut0.rtc
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: removed connection one
  $ rtcon -q -i one -p dataport.buffer.write.full_policy=block Source0.rtc:number ConsoleOut0.rtc:in
  $ rtteardown a.xml

  $ rtcon -q -i one -p dataport.buffer.write.full_policy=block Source0.rtc:number ConsoleOut0.rtc:in
  $ rtact --wait Source0.rtc
  $ soon '[ $(ctl @these blocked ConsoleOut0:in) = 1 ]'; kill-mock sources
  $ rtdis -v ConsoleOut0.rtc; mock sources 1 100 8 --flavour cpp2
  $ rtls -l
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Active    2/0  0/0  2/0  0/0  Source0.rtc

rtkeep waits, too:

  $ rtkeep --teardown a.xml > out 2>&1 & keep=$!
  $ soon 'rtcheck a.xml'; kill $keep
  $ wait $keep; said out | sort
  ConsoleOut0.rtc: Active
  ConsoleOut0.rtc: Inactive
  Source0.rtc: Inactive
  Source0.rtc: restored connection one
  $ rtls -l
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  0/0  2/0  0/0  Source0.rtc

With --force it is removed at once, and a component of C++ ends of it.

  $ rtcon -q -i one -p dataport.buffer.write.full_policy=block \
  >     -p dataport.buffer.write.timeout=60 Source0.rtc:number ConsoleOut0.rtc:in
  $ rtact --wait Source0.rtc; soon '[ $(ctl @these blocked ConsoleOut0:in) = 1 ]'
  $ rtdis --force Source0.rtc:number > nul 2>&1; rtls -l
  -       -    -    -    -    *ConsoleOut0.rtc
  Active  2/0  0/0  2/0  0/0  Source0.rtc
