What can be changed through rtmount, and what is refused. A write returns when what it asks for is so, or fails.

needs: fuse
world: console
world: config
world: error
world: slow
world: services --context parts.host_cxt/%n.rtc
world: manager --context plant.host_cxt/%n.rtc
world: zombie

  $ mkdir m bin; busybox --install -s bin
  $ rtmount m
  $ tools=$PATH PATH=$PWD/bin errors=$PWD/m/errors; why() { tail -n 1 $errors; }
  $ cd m/localhost:$PORT/test.host_cxt

States:

  $ echo Active >ConsoleIn0.rtc/state && cat ConsoleIn0.rtc/state; PATH=$tools ctl state ConsoleIn0
  Active
  ACTIVE
  $ echo Active >ConsoleIn0.rtc/state; echo Inactive >>ConsoleIn0.rtc/state
  $ printf Active >ConsoleOut0.rtc/state
  $ cat ConsoleIn0.rtc/state ConsoleOut0.rtc/state
  Inactive
  Active
  $ echo active | tee ConsoleIn0.rtc/state; why
  active
  tee: ConsoleIn0.rtc/state: I/O error
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc/state: not Active, Inactive, reset
  $ cat Broken0.rtc/state; echo Active 2>&- >Broken0.rtc/state || why
  Error
  /localhost:$PORT/test.host_cxt/Broken0.rtc: cannot activate: it is in Error; reset it first
  $ echo reset >Broken0.rtc/state; cat Broken0.rtc/state
  Inactive

One that fails soon after its activation, and one that never is:

  $ echo Active 2>&- >ErrStart0.rtc/state || why
  /localhost:$PORT/test.host_cxt/ErrStart0.rtc: cannot activate: it went to Error
  $ echo Active 2>&- >Stuck0.rtc/state || why
  /localhost:$PORT/test.host_cxt/Stuck0.rtc: not Active within 5s, still Inactive

Configuration. Names and values are written as they are read, with escapes:

  $ cd ConfigSample0.rtc/configuration; echo 7 >mode0/int_param0
  $ cat mode0/int_param0 active
  7
  mode1
  $ printf '%s\n' 'a\x0ab\\c' >mode0/str_param0; cat mode0/str_param0
  a\x0ab\\c
  $ PATH=$tools rtconf ConfigSample0.rtc -s mode0 get str_param0
  a
  b\c
  $ cat mode0/str_param0 >mode0/str_param1; cmp mode0/str_param0 mode0/str_param1
  $ head -c 200000 /dev/zero | tr '\0' a >$TMP/long
  $ dd if=$TMP/long of=mode0/str_param0 bs=512 2>&-; wc -c <mode0/str_param0
  200001
  $ truncate -s 131072 $TMP/long; cp $TMP/long mode0/str_param1
  $ wc -c <mode0/str_param1
  131073
  $ x=$(cat $TMP/long $TMP/long); echo "$x" >mode0/str_param0
  $ wc -c <mode0/str_param0
  262145
  $ cat $TMP/long $TMP/long >$TMP/longer; truncate -s 4200000 $TMP/longer
  $ cat $TMP/longer 2>&- >mode0/str_param0 || why
  $TMP/m/localhost:$PORT/test.host_cxt/ConfigSample0.rtc/configuration/mode0/str_param0: more than 4194304 bytes in one line
  $ wc -c <mode0/str_param0
  262145
  $ echo 'a\q' 2>&- >mode0/str_param0 || why
  $TMP/m/localhost:$PORT/test.host_cxt/ConfigSample0.rtc/configuration/mode0/str_param0: bad escape \q
  $ printf 'a\0b' 2>&- >mode0/str_param0 || why; printf '%s' 'a\x00b' 2>&- >mode0/str_param0 || why
  /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0: a string holds no NUL
  /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: str_param0: a string holds no NUL
  $ echo mode0 >active; cat active
  mode0
  $ PATH=$tools rtconf ConfigSample0.rtc | grep '*'
  +mode0*
  $ echo nonsense 2>&- >active || why
  /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: no such configuration set: nonsense (there are: default, mode0, mode1)
  $ echo __widget__ 2>&- >active || why
  /localhost:$PORT/test.host_cxt/ConfigSample0.rtc: configuration set __widget__ holds metadata and cannot be active
  $ echo 1 2>&- >mode0/new || why; cd ../..
  $TMP/m/localhost:$PORT/test.host_cxt/ConfigSample0.rtc/configuration/mode0/new: nothing can be made, moved or removed here but connections and zombies

Execution contexts:

  $ cd ConsoleIn0.rtc/contexts/0; echo 500 >rate
  $ cat rate
  500
  $ echo Stopped >state; cat state
  Stopped
  $ PATH=$tools rtec ConsoleIn0.rtc
  0  0  Periodic  500  Stopped  Inactive  ConsoleIn0  -
  $ echo Running >state; cat state
  Running
  $ echo 0 2>&- >rate || why
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc/contexts/0/rate: not a number of Hz above 0: 0
  $ echo running 2>&- >state || why
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc/contexts/0/state: not Running or Stopped
  $ cd ../../..

Connections are links: ln -s makes one, rm removes it. A relative target starts where the link is, as usual:

  $ ln -s ../../../../ConsoleOut0.rtc/ports/in ConsoleIn0.rtc/ports/out/connections/mine
  $ readlink ConsoleIn0.rtc/ports/out/connections/mine
  ../../../../ConsoleOut0.rtc/ports/in
  $ ls ConsoleOut0.rtc/ports/in/connections
  mine
  $ readlink ConsoleOut0.rtc/ports/in/connections/mine
  ../../../../ConsoleIn0.rtc/ports/out

  $ PATH=$tools rtcat -ll ConsoleIn0.rtc:out | grep -A 1 Conn
   -Connected to  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
      Name                            mine
  $ rm ConsoleIn0.rtc/ports/out/connections/mine; ls ConsoleOut0.rtc/ports/in/connections
  $ ln -s $PWD/ConsoleIn0.rtc/ports/out ConsoleOut0.rtc/ports/in/connections/c
  $ ls ConsoleIn0.rtc/ports/out/connections
  c
  $ rm ConsoleIn0.rtc/ports/out/connections/c
  $ cd ../parts.host_cxt
  $ ln -s $PWD/MyServiceProvider0.rtc/ports/MyService MyServiceConsumer0.rtc/ports/MyService/connections/s
  $ readlink MyServiceConsumer0.rtc/ports/MyService/connections/*
  ../../../../MyServiceProvider0.rtc/ports/MyService
  $ rm MyServiceConsumer0.rtc/ports/MyService/connections/s

A connection with several ends has a link to each of the others; what cannot be connected is refused:

  $ cd ../test.host_cxt; PATH=$tools rtcon -n three ConsoleIn0.rtc:out ConsoleOut0.rtc:in ConsoleOut1.rtc:in
  $ cd ConsoleIn0.rtc/ports/out/connections; ls -l | sed 's/.*[0-9] //'
  total 0
  three -> ../../../../ConsoleOut0.rtc/ports/in
  -> ../../../../ConsoleOut1.rtc/ports/in
  $ rm three~2; ls
  $ cd ../../../..

  $ link() { ln -s $1 ConsoleIn0.rtc/ports/out/connections/x || why; }
  $ link ../../../../ConsoleOut0.rtc/ports/nonsense
  ln: ConsoleIn0.rtc/ports/out/connections/x: No such file or directory
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleOut0.rtc/ports/nonsense: no such path
  $ link ../../../../ConsoleOut0.rtc
  ln: ConsoleIn0.rtc/ports/out/connections/x: Invalid argument
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc/ports/out/connections/x: ../../../../ConsoleOut0.rtc is not a port of this mount; a link's target starts at the link
  $ link /etc/passwd
  ln: ConsoleIn0.rtc/ports/out/connections/x: Invalid argument
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc/ports/out/connections/x: /etc/passwd leads out of the mount at $TMP/m
  $ link $PWD/ConsoleIn0.rtc/ports/out
  ln: ConsoleIn0.rtc/ports/out/connections/x: Operation not permitted
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: a port is named twice
  $ link $PWD/../parts.host_cxt/MyServiceConsumer0.rtc/ports/MyService
  ln: ConsoleIn0.rtc/ports/out/connections/x: Operation not permitted
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/parts.host_cxt/MyServiceConsumer0.rtc:MyService: a data port and a service port do not go together
  $ ln -s x ConsoleIn0.rtc/ports/y || why
  ln: ConsoleIn0.rtc/ports/y: Operation not permitted
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc/ports/y: no links can be made here

Managers make components:

  $ cd ../plant.host_cxt; echo 'ConsoleIn?instance_name=New0' >manager.mgr/create
  $ cat New0.rtc/state
  Inactive
  $ ls -l manager.mgr/components | grep -c New
  1
  $ echo 'ConsoleIn?instance_name=New0' 2>&- >manager.mgr/create || why
  /localhost:$PORT/plant.host_cxt/manager.mgr: has a component New0 already
  $ echo 'a?b?c' 2>&- >manager.mgr/create || why
  $TMP/m/localhost:$PORT/plant.host_cxt/manager.mgr/create: not MODULE[?KEY=VALUE&KEY=VALUE…]: a?b?c
  $ echo Nonsense 2>&- >manager.mgr/create || why; cd ../test.host_cxt
  /localhost:$PORT/plant.host_cxt/manager.mgr: does not create Nonsense (no factory Nonsense; there are: ConsoleIn, ConsoleOut, Controller, Motor, PeriodicECSharedComposite, Sensor)

A zombie's name can be taken away, that of what lives cannot:

  $ soon '[ -L Mock0.rtc ]'
  $ rm Mock0.rtc; ls Mock0.rtc
  ls: Mock0.rtc: No such file or directory
  [1]
  $ PATH=$tools rtls | grep Mock
  [1]
  $ rm -r ConsoleIn0.rtc/ports 2>&1 | head -n 1; ls ConsoleIn0.rtc/ports
  rm: can't remove 'ConsoleIn0.rtc/ports/out/type': Operation not permitted
  out
  $ rm ConsoleIn0.rtc/state || why
  rm: can't remove 'ConsoleIn0.rtc/state': Operation not permitted
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc/state: nothing can be made, moved or removed here but connections and zombies
  $ rmdir ConsoleIn0.rtc || why
  rmdir: 'ConsoleIn0.rtc': Operation not permitted
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: nothing can be made, moved or removed here but connections and zombies

Nothing else can be made, moved or changed:

  $ mkdir new || why
  mkdir: can't create directory 'new': Operation not permitted
  $TMP/m/localhost:$PORT/test.host_cxt/new: nothing can be made, moved or removed here but connections and zombies
  $ touch new
  touch: new: Operation not permitted
  [1]
  $ mv ConsoleIn0.rtc new
  mv: can't rename 'ConsoleIn0.rtc': Operation not permitted
  [1]
  $ ln ConsoleIn0.rtc/state new
  ln: new: Operation not permitted
  [1]
  $ cp $TMP/bin/ls new
  cp: can't create 'new': Operation not permitted
  [1]
  $ mkfifo new
  mkfifo: new: Operation not permitted
  [1]
  $ chmod 777 ConsoleIn0.rtc/state; chown 1 ConsoleIn0.rtc/state
  chmod: ConsoleIn0.rtc/state: Operation not permitted
  chown: ConsoleIn0.rtc/state: Operation not permitted
  [1]
  $ dd if=/dev/null of=ConsoleIn0.rtc/version 2>&1 | head -n 1
  dd: can't open 'ConsoleIn0.rtc/version': Permission denied
  $ touch ConsoleIn0.rtc/state

The last hundred failures are kept:

  $ i=0
  $ while [ $i -lt 200 ]; do echo nonsense >ConsoleIn0.rtc/state; i=$((i + 1)); done 2>/dev/null
  $ wc -l <$errors
  100

With --read-only nothing can be changed at all:

  $ cd $TMP; PATH=$tools rtmount -u m
  $ PATH=$tools rtmount --read-only m; cd m/localhost:$PORT/test.host_cxt
  $ echo Active | tee ConsoleIn0.rtc/state; echo 1 | tee ConsoleOut0.rtc/ports/in/value
  tee: ConsoleIn0.rtc/state: Read-only file system
  Active
  tee: ConsoleOut0.rtc/ports/in/value: Read-only file system
  1
  [1]
  $ ln -s ../../../../ConsoleOut0.rtc/ports/in ConsoleIn0.rtc/ports/out/connections/mine
  ln: ConsoleIn0.rtc/ports/out/connections/mine: Read-only file system
  [1]
  $ ls -l ConsoleIn0.rtc/state | cut -c 1-10; cat ConsoleIn0.rtc/state
  -r--r--r--
  Inactive
  $ cd $TMP; PATH=$tools rtmount -u m
