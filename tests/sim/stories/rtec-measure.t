rtec --measure watches a component that writes to an out port in each cycle. A mock runs at 50 Hz at most; its context's rate may be less.

world: these ConsoleIn --flavour cpp2 --rate 10
world: these ConsoleIn:Old0 --flavour cpp11 --rate 50
world: these ConsoleIn:Py0 --flavour py2 --rate 1000

  $ rtact --wait ConsoleIn0.rtc Old0.rtc Py0.rtc
  [0] after 0.2 s
  $ rtec --measure=1 ConsoleIn0.rtc
  0  0  Periodic  10  Running  Active  ConsoleIn0  -
  measured  10.0 Hz (writes to out)
  [0] after 1.1 s
  $ rtec --measure 1 Old0.rtc
  0  0  Periodic  50  Running  Active  Old0  -
  measured  51.0 Hz (writes to out)
  [0] after 1.1 s
  $ rtec --measure Py0.rtc
  0  0  Periodic  1000  Running  Active  Py0  -
  measured  51.0 Hz (writes to out)
  [0] after 1.1 s
  $ ctl @these connectors ConsoleIn0:out
