rtlog plays a recording of components that are bound by another name than their own (naming.formats).

world: these ConsoleIn ConsoleOut --context lab.host_cxt/My%n.rtc
server: other
orb: builtin

  $ export RTCSH_CWD=/localhost:$PORT/lab.host_cxt
  $ rtcon -q MyConsoleIn0.rtc:out MyConsoleOut0.rtc:in
  $ rtact MyConsoleOut0.rtc
  $ rtlog -q --events -f m.mcap . & pid=$!
  $ soon 'rtlog -d -f m.mcap | grep components-1.json'
  $ ctl write ConsoleIn0:out 7
  $ soon 'rtlog --json -f m.mcap | grep "data.: 7"'
  $ kill $pid; wait $pid
  [143]

They have the ports that they had, and no others, and send what was recorded:

  $ rtlog -p -f m.mcap --as-components --nameserver localhost:$PORT2 --when-connected --loop 2> told & pid=$!
  $ soon 'grep bound told'
  $ there=/localhost:$PORT2/lab.host_cxt; rtcat $there/MyConsoleIn0.rtc $there/MyConsoleOut0.rtc | grep Port:
  +DataOutPort: out
  +DataInPort: in
  $ rtprint -n 1 $there/MyConsoleIn0.rtc:out 2> nul
  [0.000000000] 7
  $ kill $pid; wait $pid
  [143]

To ports, as they were connected:

  $ ctl reset
  $ rtlog -q -p -f m.mcap .
  $ ctl received ConsoleOut0:in 2
  2 7
