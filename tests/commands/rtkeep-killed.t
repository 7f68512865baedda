rtkeep that is killed leaves nothing that can hang a component which then loses its connections.

world: sources 1 100 8 --flavour cpp2
world: these ConsoleOut ConsoleOut:ConsoleOut1
both: each ORB serves observers in its own way

An observer of its ports would, in C++ 2.1, see docs/protocol.md 5.4.

  $ export XDG_RUNTIME_DIR=$PWD
  $ for n in 0 1; do rtcon -i to-$n Source0.rtc:number ConsoleOut$n.rtc:in; done
  $ rtcryo --all -o a.xml localhost:$PORT
  $ rtkeep a.xml > out 2>&1 & keep=$!
  > soon 'rtkeep status | grep ";.all.is"'
  > watched Source0; ctl observers Source0
  > kill -9 $keep; wait $keep 2> nul
  IDL:OpenRTM/ComponentObserver:1.0
  [137]
  $ rtdis Source0.rtc
  $ rtkeep --once a.xml | said | sort
  Source0.rtc: restored connection to-0
  Source0.rtc: restored connection to-1
  $ rtls -l
  Active  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  Active  1/1  1/1  0/0  0/0  ConsoleOut1.rtc
  Active  2/1  0/0  2/1  0/0  Source0.rtc
