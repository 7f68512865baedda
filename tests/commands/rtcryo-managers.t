rtcryo where there are managers, and composites that have lost a member.

server: lost
world: manager
world: deadmember --nameserver localhost:$PORT2

Components are saved from where they are bound, not from below their managers, and once:

  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all localhost:$PORT | grep -o 'pathUri="[^"]*"'
  pathUri="localhost:$PORT/test.host_cxt/ConsoleIn0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConsoleOut0.rtc"

So is a component that is bound twice, which is reported:

  $ rtcryo --all localhost:$PORT 127.0.0.1:$PORT | grep -o 'pathUri="[^"]*"'
  rtcryo: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: the same component as /127.0.0.1:$PORT/test.host_cxt/ConsoleIn0.rtc
  rtcryo: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: the same component as /127.0.0.1:$PORT/test.host_cxt/ConsoleOut0.rtc
  pathUri="127.0.0.1:$PORT/test.host_cxt/ConsoleIn0.rtc"
  pathUri="127.0.0.1:$PORT/test.host_cxt/ConsoleOut0.rtc"

A composite with a member whose process has been killed:

  $ rtcryo --all localhost:$PORT2 | grep -o -E 'pathUri="[^"]*"|Participant .*instanceName="[^"]*"'
  rtcryo: /localhost:$PORT2/test.host_cxt/composite0.rtc: the process of one of its ports is gone; if that is a member's, restart this composite's process (until then, rtcomp -r MEMBER:PORT hides the port)
  rtcryo: /localhost:$PORT2/test.host_cxt/Peer0.rtc: zombie, left out
  pathUri="localhost:$PORT2/test.host_cxt/ConsoleIn0.rtc"
  $ rtcryo --all -q localhost:$PORT2 | rtstodot | grep -c label
  rtcryo: /localhost:$PORT2/test.host_cxt/composite0.rtc: the process of one of its ports is gone; if that is a member's, restart this composite's process (until then, rtcomp -r MEMBER:PORT hides the port)
  1
