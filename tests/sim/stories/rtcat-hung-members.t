Composites whose members hang, each in a process of its own: they are shown all the same, and together they cost one timeout.

world: manager --flavour cpp11
world: console --context h1.host_cxt/%n.rtc
world: console --context h2.host_cxt/%n.rtc
world: console --context h3.host_cxt/%n.rtc
world: console --context h4.host_cxt/%n.rtc

  $ rtcomp -a ../h1.host_cxt/ConsoleIn0.rtc manager.mgr:Arm1
  $ rtcomp -a ../h2.host_cxt/ConsoleIn0.rtc manager.mgr:Arm2
  $ rtcomp -a ../h3.host_cxt/ConsoleIn0.rtc manager.mgr:Arm3
  $ rtcomp -a ../h4.host_cxt/ConsoleIn0.rtc manager.mgr:Arm4
  $ rtcat -ll Arm1.rtc
  …
      Member  /robot/h1.host_cxt/ConsoleIn0.rtc
  …
     -Participants
        ConsoleIn0
  …
  $ hang console
  $ hang console2
  $ hang console3
  $ hang console4
  $ RTSHELL_TIMEOUT=1
  $ rtcat -ll Arm1.rtc
  …
      Member  Unknown (no answer within 1s)
  …
     -Participants
        Unknown
  …
  [0] after 1.1 s
  $ rtcat -ll Arm1.rtc Arm2.rtc Arm3.rtc Arm4.rtc
  …
      Member  Unknown (no answer within 1s)
  …
     -Participants
        Unknown
  …
      Member  Unknown (no answer within 1s)
  …
     -Participants
        Unknown
  …
      Member  Unknown (no answer within 1s)
  …
     -Participants
        Unknown
  …
      Member  Unknown (no answer within 1s)
  …
     -Participants
        Unknown
  …
  [0] after 1.1 s
