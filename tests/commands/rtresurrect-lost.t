Names that are lost, and names that are left: rtresurrect --create makes what is gone, and nothing that may live. (What hangs:
tests/sim/stories/rtresurrect-lost.t.)

server: another
world: manager Sensor Motor --flavour cpp2
world: these ConsoleOut

The file has the address of each component, when it was saved:

  $ rtcryo --all > a.xml; grep -o '"REFERENCE".*' a.xml | sed 's/\(iiop:127.0.0.1:\)[^"]*/\1…/'
  "REFERENCE" rtsExt:value="corbaloc:iiop:127.0.0.1:…"/>
  "REFERENCE" rtsExt:value="corbaloc:iiop:127.0.0.1:…"/>
  "REFERENCE" rtsExt:value="corbaloc:iiop:127.0.0.1:…"/>
  $ rtcheck -s inactive a.xml; rtresurrect --create a.xml

A slave is killed: the names of its components are still bound, which does not matter. The manager makes them again:

  $ kill -9 $(ctl slave 1 pid); soon '[ $(rtls | grep -c "^[*]") = 2 ]'
  $ rtls
  ConsoleOut0.rtc
  *Motor0.rtc
  *Sensor0.rtc
  manager.mgr/
  $ rtresurrect --create a.xml
  $ rtls
  ConsoleOut0.rtc
  Motor0.rtc
  Sensor0.rtc
  manager.mgr/
  $ rtcheck -s inactive a.xml

So does rtkeep:

  $ export XDG_RUNTIME_DIR=$PWD; rtcryo --all > a.xml
  $ rtkeep --create --look 0.2 a.xml > out 2>&1 & keep=$!
  $ soon 'rtcheck a.xml'; kill -9 $(ctl slave 2 pid)
  $ soon 'grep Motor0.*created out'; soon 'grep Sensor0.*created out'
  $ soon 'rtcheck a.xml'
  $ kill $keep; wait $keep

The name server is started again, empty (here: the names are deleted): what lives is not made again, as its manager has it, or its address answers:

  $ rtcryo --all > a.xml
  $ rtdel -f Sensor0.rtc Motor0.rtc ConsoleOut0.rtc
  $ rtls
  manager.mgr/
  $ rtresurrect --create a.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: is not there, and nothing names a manager to create it (see --manager)
  rtresurrect: /localhost:$PORT/test.host_cxt/Motor0.rtc: not created: /localhost:$PORT/test.host_cxt/manager.mgr has it, though its name is not bound: restart it, or delete it there
  rtresurrect: /localhost:$PORT/test.host_cxt/Sensor0.rtc: not created: /localhost:$PORT/test.host_cxt/manager.mgr has it, though its name is not bound: restart it, or delete it there
  rtresurrect: 3 failed, 9 not tried
  [1]
  $ rtresurrect --create --manager manager.mgr a.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not created: it lives at 127.0.0.1:*, though its name is not bound: restart it, or end its process; if that is another robot, take REFERENCE out of the file (glob)
  rtresurrect: /localhost:$PORT/test.host_cxt/Motor0.rtc: not created: /localhost:$PORT/test.host_cxt/manager.mgr has it, though its name is not bound: restart it, or delete it there
  rtresurrect: /localhost:$PORT/test.host_cxt/Sensor0.rtc: not created: /localhost:$PORT/test.host_cxt/manager.mgr has it, though its name is not bound: restart it, or delete it there
  rtresurrect: 3 failed, 9 not tried
  [1]
  $ rtdoctor -q --profile a.xml . | grep -e Sensor -e ConsoleOut
  fail  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Required component missing, but it lives: it answers at 127.0.0.1:*; try: look again in some time, as many bind their names again by themselves (naming.update.enable); restart those that do not (glob)
  fail  /localhost:$PORT/test.host_cxt/Sensor0.rtc: Required component missing, but it lives: it answers at 127.0.0.1:*; try: look again in some time, as many bind their names again by themselves (naming.update.enable); restart those that do not (glob)
  warn  /localhost:$PORT: has none of its 3 components in the file, though /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc, /localhost:$PORT/test.host_cxt/Motor0.rtc and /localhost:$PORT/test.host_cxt/Sensor0.rtc live: perhaps it was started again, and they were not, or it is another name server; try: look again in some time, as many bind their names again by themselves (naming.update.enable); restart those that do not

What cannot be reached may live, too:

  $ sed 's/iiop:127.0.0.1/iiop:robot.invalid/' a.xml > b.xml
  $ rtresurrect --create --manager manager.mgr b.xml 2>&1 | grep ConsoleOut0.rtc:
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: not created: robot.invalid:*, where it was, is out of reach (host name not known) (REFERENCE in the file) (glob)
  $ rtdoctor -q --profile b.xml . | grep ConsoleOut
  fail  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Required component missing, but it may live: robot.invalid:*, where it was, is out of reach (host name not known); try: on that host: rtdoctor, rtdel -z; netstat -ltnp | grep :* there shows whether its process runs: if so, let this host through its firewall; if not, start it again (glob)

A name server that has nothing at all:

  $ rtdoctor -q localhost:$PORT2 | grep $PORT2
  warn  /localhost:$PORT2: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
