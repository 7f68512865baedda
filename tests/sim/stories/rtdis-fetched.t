rtdis leaves a connection through which a tool fetches values to that tool: a process of C++ ends when one is removed whose fetch is still being served.

world: sources 1 100 8 --flavour cpp2

  $ rtprint --pull -q Source0.rtc:number &
  $ sleep 1
  $ rtdis Source0.rtc
  ! rtdis: /robot/test.host_cxt/Source0.rtc:number: connection $UUID is that of a tool which fetches values: to remove it while the tool runs may end the process of /robot/test.host_cxt/Source0.rtc; first: end the tool (if it was killed: rtdis --force)
  [6]
  $ rtls -l
  Active  2/1  0/0  2/1  0/0  Source0.rtc
  $ strike INT rtprint
  $ wait rtprint
  …
  [130] after 1.0 s
  $ rtls -l
  Active  2/0  0/0  2/0  0/0  Source0.rtc

Of one that fetches no more, as it was killed or is stopped, --force removes it.

  $ rtprint --pull Source0.rtc:number &
  $ sleep 1
  $ stop rtprint
  $ sleep 0.1
  $ rtdis Source0.rtc
  ! rtdis: /robot/test.host_cxt/Source0.rtc:number: connection $UUID is that of a tool which fetches values: to remove it while the tool runs may end the process of /robot/test.host_cxt/Source0.rtc; first: end the tool (if it was killed: rtdis --force)
  [6]
  $ rtdis --force Source0.rtc
  $ rtls -l
  Active  2/0  0/0  2/0  0/0  Source0.rtc
  $ wake rtprint
  $ wait rtprint
  …
  [4] after 1.2 s
