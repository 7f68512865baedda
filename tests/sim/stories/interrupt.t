Ctrl-C ends at once every command that waits for a peer: status 130, and not a word.

world: two
world: two --context hung.host_cxt/%n.rtc

  $ hang two2
  $ RTCSH_CWD=/robot/hung.host_cxt
  $ interrupt 0.5 rtls -l
  [130] after 0.5 s
  $ interrupt 0.5 rtcat ConsoleIn0.rtc
  [130] after 0.5 s
  $ interrupt 0.5 rtfind . -t c
  [130] after 0.5 s
  $ interrupt 0.5 rtact --wait=60 ConsoleIn0.rtc
  [130] after 0.5 s
  $ interrupt 0.5 rtdeact ConsoleIn0.rtc ConsoleOut0.rtc
  [130] after 0.5 s
  $ interrupt 0.5 rtreset ConsoleIn0.rtc
  [130] after 0.5 s
  $ interrupt 0.5 rtexit ConsoleIn0.rtc
  [130] after 0.5 s
  $ interrupt 0.5 rtconf ConsoleIn0.rtc set a 1
  [130] after 0.5 s
  $ interrupt 0.5 rtec ConsoleIn0.rtc
  [130] after 0.5 s
  $ interrupt 0.5 rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  [130] after 0.5 s
  $ interrupt 0.5 rtdis ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  [130] after 0.5 s
  $ interrupt 0.5 rtdel -z
  [130] after 0.5 s

A name server that hangs:

  $ hang names
  $ interrupt 0.5 rtls
  [130] after 0.5 s
  $ interrupt 0.5 rtcwd /robot/test.host_cxt
  [130] after 0.5 s
  $ interrupt 0.5 rtfind . --wait 60 -n ConsoleIn0.rtc
  [130] after 0.5 s
  $ interrupt 0.5 rtact --wait=60 ConsoleIn0.rtc
  [130] after 0.5 s
  $ interrupt 0.5 rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  [130] after 0.5 s
  $ interrupt 0.5 rtconf ConsoleIn0.rtc
  [130] after 0.5 s
  $ interrupt 0.5 rtdel -z
  [130] after 0.5 s
