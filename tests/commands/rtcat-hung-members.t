Composites whose members hang, each in a process of its own: they are shown all the same, and together they cost one timeout.

world: managers --flavour cpp2
world: console --context h1.host_cxt/%n.rtc
world: console --context h2.host_cxt/%n.rtc
world: console --context h3.host_cxt/%n.rtc
world: console --context h4.host_cxt/%n.rtc
both: each ORB waits in its own way

  $ for i in 1 2 3 4; do rtcomp -a ../h$i.host_cxt/ConsoleIn0.rtc manager.mgr:Arm$i; done
  $ members() { rtcat -ll "$@" | sed -n -e '/ Member /p' -e '/Participants/{n;p;}'; }
  $ members Arm1.rtc
      Member  /localhost:$PORT/h1.host_cxt/ConsoleIn0.rtc
        ConsoleIn0
  $ rtcat --json Arm1.rtc | grep -o '"participants": [^]]*]'
  "participants": ["ConsoleIn0"]
  $ for i in '' 2 3 4; do ctl @console$i stop; done
  $ export RTSHELL_TIMEOUT=1
  $ members Arm1.rtc
      Member  Unknown (no answer within 1s)
        Unknown
  $ rtcat --json Arm1.rtc | grep -o '"participants": [^]]*]'
  "participants": ["Unknown"]
  $ export RTSHELL_TIMEOUT=5; start=$(date +%s); members Arm1.rtc Arm2.rtc Arm3.rtc Arm4.rtc | grep -c Unknown; [ $(($(date +%s) - start)) -lt 15 ]
  8
