What rtresurrect makes of hostile systems. (Those that break while they are restored: tests/sim/stories/rtresurrect-faults.t.)

world: hostile --context hostile.host_cxt/%n.rtc

Hostile names and values are restored, or told, and do nothing to the terminal:

  $ rtcryo -q localhost:$PORT/hostile.host_cxt -o h.xml
  $ rtcryo -q -y localhost:$PORT/hostile.host_cxt -o h.yaml
  $ rtresurrect -v h.xml 2>&1 | tail -1
  rtresurrect: 9 already done
  $ rtteardown -v h.yaml 2>&1 | tail -1
  rtteardown: 1 done
  $ rtresurrect -v h.yaml 2>&1 | LC_ALL=C grep -c '[[:cntrl:]]'
  0
  [1]
