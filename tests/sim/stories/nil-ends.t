A port that shows nil in the place of the far end of its connection is not taken for one that is connected alone.

world: linked

  $ ctl blind ConsoleIn0:out
  $ rtls -l
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  $ rtcat ConsoleIn0.rtc:out -l
  -DataOutPort: out
  …
   +Connected to  Unknown (nil)
  $ rtdoctor -q
  fail  /robot/test.host_cxt/ConsoleIn0.rtc:out: connection out_in has an end that is nothing (nil); try: rtdis -i $UUID /robot/test.host_cxt/ConsoleIn0.rtc:out
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/test.host_cxt/ConsoleIn0.rtc /robot/test.host_cxt/ConsoleOut0.rtc
  [1]

What its other port shows whole is saved, once; the port that shows it half is compared as not connected:

  $ rtcryo -o system.rtsys /robot
  $ rtstodot --text system.rtsys
  ┌─────────────┐
  │ ConsoleIn0  │
  │         out ├─┐
  ├─────────────┤ │
  │ ConsoleOut0 │ │
  │ in          │<┘
  └─────────────┘
  $ rtstodot --text --live /robot
  ┌───────────────────────┐
  │ ConsoleIn0  Inactive  │
  │                   out ├─┐
  ├───────────────────────┤ │
  │ ConsoleOut0  Inactive │ │
  │ in                    │<┘
  └───────────────────────┘
  $ rtcheck -s Inactive system.rtsys
  ! No connection between /robot/test.host_cxt/ConsoleIn0.rtc:out and /robot/test.host_cxt/ConsoleOut0.rtc:in
  [1]
  $ rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  ! rtdis: /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut0.rtc:in: not connected
  [1]

Where no port shows it whole, it is left out:

  $ ctl blind ConsoleOut0:in
  $ rtcryo -o system.rtsys /robot
  ! rtcryo: connection $UUID of /robot/test.host_cxt/ConsoleIn0.rtc:out: an end of it is nothing (nil), left out
  ! rtcryo: connection $UUID of /robot/test.host_cxt/ConsoleOut0.rtc:in: an end of it is nothing (nil), left out
  $ rtstodot --text system.rtsys
  ┌─────────────┐
  │ ConsoleIn0  │
  ├─────────────┤
  │ ConsoleOut0 │
  └─────────────┘
  $ rtcheck -s Inactive system.rtsys

It can be removed:

  $ rtdis ConsoleIn0.rtc:out
  $ ctl connectors ConsoleIn0:out
  $ ctl connectors ConsoleOut0:in
