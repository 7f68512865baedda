Connections of one port only are made by tools, ours or others, while they look: they are no part of a system.

world: linked
world: services

A running rtprint, and a service port that somebody has connected alone:

  $ rtcryo -o plain.rtsys
  rtcryo: 2 components without connections left out; --all saves them, too
  $ rtcryo -q -o plain.rtsys
  $ rtprint -q ConsoleIn0.rtc:out >/dev/null & printing=$!
  $ rtcon -i alone MyServiceProvider0.rtc:MyService
  $ soon 'ctl connectors ConsoleIn0:out | grep -q rtprint'

rtcat shows them, no other command does:

  $ rtcat -l ConsoleIn0.rtc:out MyServiceProvider0.rtc:MyService | grep onnect
   +Connected to  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
    (1 other connection)
    (1 other connection)
  $ rtcryo -q -o now.rtsys; grep -c rts:connectorId plain.rtsys now.rtsys
  plain.rtsys:1
  now.rtsys:1
  $ rtcryo -q --all -o all.rtsys; grep -c rts:connectorId all.rtsys
  1
  $ rtcheck --extra all.rtsys -s Inactive
  $ rtdoctor -q . | grep -v -e '^warn  here' -e 'examined are Inactive' -e ': slow ('
  [1]
  $ rtstodot --text --live
  ┌───────────────────────┐
  │ ConsoleIn0  Inactive  │
  │                   out ├─┐
  ├───────────────────────┤ │
  │ ConsoleOut0  Inactive │ │
  │ in                    │<┘
  └───────────────────────┘
  $ rtresurrect --dry-run all.rtsys
  $ rtteardown --dry-run all.rtsys
  rtdis -i $UUID /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  $ rtteardown -v all.rtsys
  rtteardown: connection $UUID of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: done
  rtteardown: 1 done

A file in which they have been saved is taken without them:

  $ old() { sed '/<rts:targetDataPort/,/<\/rts:targetDataPort/d' plain.rtsys; }
  $ old | grep -c -e rts:connectorId -e rts:sourceDataPort
  3
  $ old | rtcheck -s Inactive
  $ old | rtresurrect --dry-run
  $ old | rtteardown --dry-run
  $ old | rtstodot --text
  ┌─────────────┐
  │ ConsoleIn0  │
  ├─────────────┤
  │ ConsoleOut0 │
  └─────────────┘
  $ kill $printing; wait $printing
  [143]

Nothing at all, and composites:

  $ mock composite --context robot.host_cxt/%n.rtc
  $ rtcryo -o all.rtsys
  rtcryo: 7 components and 1 composite without connections left out; --all saves them, too
  $ rtcryo -o all.rtsys /localhost:$PORT/robot.host_cxt
  rtcryo: 3 components and 1 composite without connections left out; --all saves them, too
  $ rtcryo -o all.rtsys --all
