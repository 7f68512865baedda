rtcryo of robots of which a part hangs, or has died.

world: linked --context good.host_cxt/%n.rtc
world: hung 2 --context hung.host_cxt/%n.rtc
world: zombie 1 --context good.host_cxt/%n.rtc

A process that hangs costs one line for each of its components, and one timeout; the rest is saved:

  $ kill zombie
  $ hang hung
  $ rtcryo --timeout 0.5 robot/good.host_cxt robot/hung.host_cxt -o part.xml
  ! rtcryo: /robot/hung.host_cxt/Mock0.rtc: no answer within 0.5s
  ! rtcryo: /robot/hung.host_cxt/Mock1.rtc: no answer within 0.5s
  ! rtcryo: /robot/good.host_cxt/Mock0.rtc: zombie, left out
  [5] after 0.6 s
  $ rtstodot part.xml
  digraph rtsprofile {
    rankdir=LR;
    node [shape=Mrecord];
    ConsoleIn0 [label="{{}|ConsoleIn0|{<out>out}}"];
    ConsoleOut0 [label="{{<in>in}|ConsoleOut0|{}}"];
    ConsoleIn0:out -> ConsoleOut0:in;
  }

Where nothing answers, nothing is written:

  $ rtcryo --timeout 0.3 robot/hung.host_cxt -o none.xml
  ! rtcryo: /robot/hung.host_cxt/Mock0.rtc: no answer within 0.3s
  ! rtcryo: /robot/hung.host_cxt/Mock1.rtc: no answer within 0.3s
  [4] after 0.3 s
  $ ls *.xml
  part.xml
