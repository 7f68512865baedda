rtdis, rtteardown and rtkeep leave a connection in which a value may wait: full_policy=block.

world: sources 1 100 8 --flavour cpp2
world: these ConsoleOut --flavour cpp2

A component of C++ ends when such a connection is removed while a value waits for room in the buffer of its in port.

  $ rtcon -i one -p dataport.inport.buffer.write.full_policy=block Source0.rtc:number ConsoleOut0.rtc:in
  ! rtcon: /robot/test.host_cxt/Source0.rtc:number to /robot/test.host_cxt/ConsoleOut0.rtc:in: writers wait while its buffer is full (full_policy=block): remove it only while its source is Inactive, as rtdis does
  $ rtcryo --all -o a.xml robot
  $ sleep 1
  $ ctl @these blocked ConsoleOut0:in
  1
  $ rtdis Source0.rtc:number
  ! rtdis: /robot/test.host_cxt/Source0.rtc:number: connection one makes its writers wait (full_policy=block), and /robot/test.host_cxt/Source0.rtc is Active: to remove it now may end the process of /robot/test.host_cxt/ConsoleOut0.rtc; first: rtdeact /robot/test.host_cxt/Source0.rtc (rtdis --force removes it all the same)
  [6]
  $ rtdis -i one ConsoleOut0.rtc
  ! rtdis: /robot/test.host_cxt/ConsoleOut0.rtc:in: connection one makes its writers wait (full_policy=block), and /robot/test.host_cxt/Source0.rtc is Active: to remove it now may end the process of /robot/test.host_cxt/ConsoleOut0.rtc; first: rtdeact /robot/test.host_cxt/Source0.rtc (rtdis --force removes it all the same)
  [6]
  $ rtteardown a.xml
  ! rtteardown: /robot/test.host_cxt/Source0.rtc:number: connection one makes its writers wait (full_policy=block), and /robot/test.host_cxt/Source0.rtc is Active: to remove it now may end the process of /robot/test.host_cxt/ConsoleOut0.rtc; first: rtdeact /robot/test.host_cxt/Source0.rtc (rtdis --force removes it all the same)
  ! rtteardown: 1 failed
  [6]
  $ rtsh -c 'dis Source0.rtc'
  ! rtdis: /robot/test.host_cxt/Source0.rtc:number: connection one makes its writers wait (full_policy=block), and /robot/test.host_cxt/Source0.rtc is Active: to remove it now may end the process of /robot/test.host_cxt/ConsoleOut0.rtc; first: rtdeact /robot/test.host_cxt/Source0.rtc (rtdis --force removes it all the same)
  [6]

rtdoctor says how to remove it.

  $ rtdoctor -q .
  warn  /robot/test.host_cxt/ConsoleOut0.rtc: Inactive, while 1 component of its system is Active; it may have been reset; try: if it is to move, activate it: rtact /robot/test.host_cxt/ConsoleOut0.rtc
  warn  /robot/test.host_cxt/ConsoleOut0.rtc:in: nothing reads the values of /robot/test.host_cxt/Source0.rtc:number: its buffer makes its writers wait, once it is full (block); try: if it is to move, activate it: rtact /robot/test.host_cxt/ConsoleOut0.rtc
  warn  /robot/test.host_cxt/ConsoleOut0.rtc:in: connection one makes its writers wait (full_policy=block): to remove it while one of them is Active may end this process; try: before you remove it: rtdeact /robot/test.host_cxt/Source0.rtc (rtdis then waits until no value waits)

While nothing is written to it, and nothing waits any more, it is removed; also where its source is gone.

  $ rtdeact Source0.rtc
  $ rtdis -v Source0.rtc:number
  ! rtdis: /robot/test.host_cxt/Source0.rtc:number: removed connection one
  [0] after 2.5 s
  $ rtls -l
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  0/0  2/0  0/0  Source0.rtc
  $ rtcon -q -i one -p dataport.buffer.write.full_policy=block Source0.rtc:number ConsoleOut0.rtc:in
  $ rtdis -v ConsoleOut0.rtc
  ! rtdis: /robot/test.host_cxt/ConsoleOut0.rtc:in: removed connection one
  [0] after 2.5 s
  $ rtcon -q -i one -p dataport.buffer.write.full_policy=block Source0.rtc:number ConsoleOut0.rtc:in
  $ rtteardown a.xml
  [0] after 2.5 s

  $ rtcon -q -i one -p dataport.buffer.write.full_policy=block Source0.rtc:number ConsoleOut0.rtc:in
  $ rtact --wait Source0.rtc
  $ sleep 1
  $ ctl @these blocked ConsoleOut0:in
  1
  $ kill sources
  $ rtdis -v ConsoleOut0.rtc
  $ mock sources 1 100 8 --flavour cpp2
  $ rtls -l
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Active    2/0  0/0  2/0  0/0  Source0.rtc

rtkeep waits, too:

  $ rtkeep --teardown a.xml &
  $ sleep 5
  $ rtcheck a.xml
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:00:09] /robot/test.host_cxt/Source0.rtc: restored connection one
  [08:00:09] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:14] /robot/test.host_cxt/Source0.rtc: Inactive
  [08:00:14] /robot/test.host_cxt/ConsoleOut0.rtc: Inactive
  [0] after 7.8 s
  $ rtls -l
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  0/0  2/0  0/0  Source0.rtc

With --force it is removed at once, and a component of C++ ends of it.

  $ rtcon -q -i one -p dataport.buffer.write.full_policy=block -p dataport.buffer.write.timeout=60 Source0.rtc:number ConsoleOut0.rtc:in
  $ rtact --wait Source0.rtc
  $ sleep 1
  $ ctl @these blocked ConsoleOut0:in
  1
  $ rtdis --force Source0.rtc:number
  $ rtls -l
  -       -    -    -    -    *ConsoleOut0.rtc
  Active  2/0  0/0  2/0  0/0  Source0.rtc
