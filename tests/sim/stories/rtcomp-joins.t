A composite of C++ 2.1 takes a new member in its context's next cycle; one that is activated before that leaves it Inactive. rtcomp waits
until the context knows it.

world: composite --flavour cpp2
world: two --flavour cpp2

  $ rtec composite0.rtc rate 5
  $ rtcomp -a ConsoleIn0.rtc composite0.rtc
  [0] after 0.3 s
  $ rtact --wait composite0.rtc
  [0] after 0.4 s
  $ rtec ConsoleIn0.rtc
  0  0     Periodic  1000  Stopped  Inactive  ConsoleIn0  -
  1  1000  Periodic  5     Running  Active    composite0  Sensor0,Controller0,Motor0,ConsoleIn0
