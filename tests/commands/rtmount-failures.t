What rtmount cannot do, and what happens to a mounted tree when components, name servers or rtmount itself fail.

needs: fuse
world: two
world: many 1 --context hung.host_cxt/%n.rtc
world: fragile --context fragile.host_cxt/%n.rtc
both: each ORB waits in its own way

Wrong usage and what cannot be mounted; each is reported before rtmount returns, and leaves nothing:

  $ rtmount
  rtmount: the following arguments are required: DIR (see --help)
  [2]
  $ rtmount a b
  rtmount: unrecognized arguments: b (see --help)
  [2]
  $ rtmount --ttl 0 a
  rtmount: argument --ttl: not a number of seconds above 0: 0 (see --help)
  [2]
  $ rtmount a
  rtmount: $TMP/a: no such directory
  [1]
  $ touch file; rtmount file
  rtmount: $TMP/file: no such directory
  [1]
  $ mkdir none; RTCTREE_NAMESERVERS=corbaloc::localhost:1/manager rtmount none
  rtmount: corbaloc::localhost:1/manager is left out: only what name servers have is mounted
  $ ls none; rtmount -u none
  README
  errors
  $ rtmount -u a
  rtmount: $TMP/a: no RTC Tree is mounted there
  [1]
  $ mkdir full; touch full/file
  $ rtmount full
  rtmount: $TMP/full: not empty; a mount hides what is there (--over mounts all the same)
  [1]
  $ rtmount --over full; ls full/README
  full/README
  $ rtmount -u full; ls full
  file
  $ mkdir m; RTSHELL_ORB=nonsense rtmount m
  rtmount: RTSHELL_ORB: nonsense: neither omniorb nor builtin (see --help)
  [2]
  $ rtmount m; rtmount m
  rtmount: $TMP/m: an RTC Tree is mounted there already
  [1]
  $ rtmount -u m; rtmount -u m
  rtmount: $TMP/m: no RTC Tree is mounted there
  [1]

A name server that is not there, and one that goes and comes back:

  $ rtmount --ttl 0.1 --timeout 2 $PWD/m; root=$PWD/m errors=$PWD/m/errors
  $ why() { tail -n 1 $errors; }
  $ ls m/nosuchhost.invalid || why
  ls: cannot access 'm/nosuchhost.invalid': No route to host
  /nosuchhost.invalid: host name not known
  $ ls m/localhost:1 || why
  ls: cannot access 'm/localhost:1': Connection refused
  /localhost:1: connection refused; is the name server running?
  $ ls m/.git m/con*
  ls: cannot access 'm/.git': No such file or directory
  ls: cannot access 'm/con*': No such file or directory
  [2]
  $ cd m/localhost:$PORT; kill-mock names
  $ soon 'ls . 2>&1 | grep refused'  # what was asked before is lost
  $ ls . || why
  ls: reading directory '.': Connection refused
  /localhost:$PORT: connection refused; is the name server running?
  $ cat test.host_cxt/ConsoleIn0.rtc/state || why
  cat: test.host_cxt/ConsoleIn0.rtc/state: Connection refused
  /localhost:$PORT: connection refused; is the name server running?
  $ start-again names; soon 'ls . >/dev/null 2>&1'
  $ ls
  fragile.host_cxt
  hung.host_cxt
  test.host_cxt

A component that hangs delays only those who ask it; it is listed, and others answer:

  $ cd hung.host_cxt; ls
  Mock0.rtc
  $ cat Mock0.rtc/type_name
  Mock
  $ ctl @many stop
  $ cat Mock0.rtc/state || why
  cat: Mock0.rtc/state: Connection timed out
  /localhost:$PORT/hung.host_cxt/Mock0.rtc: no answer within 2s
  $ ls
  Mock0.rtc
  $ time=$(date +%s); grep -r . . >/dev/null 2>&1
  [2]
  $ test $(($(date +%s) - time)) -le 60

A component that dies is out of reach, its connection lost or refused. When it is started again, even those whose working
directory it was find it:

  $ cd ../test.host_cxt/ConsoleIn0.rtc; cat state
  Inactive
  $ kill-mock two; cat state || why
  cat: state: (Connection refused|No route to host) (re)
  /localhost:\$PORT/test.host_cxt/ConsoleIn0.rtc: connection (refused|lost).* (re)
  $ (cd /; mock two); cat state
  Inactive
  $ echo Active >state && cat state
  Active
  $ cd ..

The name of one that has died is a link that leads nowhere:

  $ kill-mock two2; soon '[ -L ConsoleIn0.rtc ]'
  $ readlink ConsoleIn0.rtc
  zombie: its object is gone
  $ rm ConsoleIn0.rtc ConsoleOut0.rtc; ls

Asking does no harm: a profile would end this one before its ports have been asked.

  $ cat ../fragile.host_cxt/Fragile0.rtc/version
  1.0
  $ ls -l ../fragile.host_cxt/Fragile0.rtc/ports/out/connections | sed 's/.*[0-9] //'
  total 0

A mount that is in use can be taken away; its files work on until they are closed, and rtmount ends then:

  $ cd $TMP; rtmount -u m
  $ ls m; while pgrep -f "$PWD/m" >/dev/null; do sleep 0.1; done

What is mounted there meanwhile is another tree, and stays when the last file of the first is closed:

  $ rtmount $PWD/m; old=$(pgrep -f "rtmount $PWD/m")
  $ sleep 1000 <m/README & one=$!
  $ soon 'readlink /proc/$one/fd/0 | grep README'
  $ rtmount -u m
  rtmount: $TMP/m: unmounted; its process serves the files that are still open, or is stopped
  $ rtmount m; kill $one
  $ while kill -0 $old 2>/dev/null; do sleep 0.1; done; ls m | head -n 1
  README
  $ rtmount -u m

Unmounting waits for the end of its process, even where another mount namespace, as of a container, keeps a copy:

  $ rtmount $PWD/m; unshare --mount sleep 1000 & one=$!
  $ soon '[ -e /proc/$one/exe ]'
  $ rtmount -u m; pgrep -f "rtmount $PWD/m"
  [1]
  $ kill $one

One whose rtmount is stopped answers nobody, but can be taken away:

  $ rtmount -f m & pid=$!
  > soon '[ -e m/README ]'
  > kill -STOP $pid; rtmount --timeout 0.5 m
  rtmount: $TMP/m: an RTC Tree is mounted there already
  [1]
  $ rtmount -u m/
  rtmount: $TMP/m: unmounted; its process serves the files that are still open, or is stopped
  $ ls m
  $ kill -CONT $pid; wait $pid

In front, SIGTERM and Ctrl-C unmount:

  $ rtmount -f m & pid=$!
  $ soon '[ -e m/README ]'
  $ kill $pid; wait $pid
  $ ls m

If rtmount is killed, its mount is stale: rtdoctor says so, and the next rtmount takes it away:

  $ rtmount -f m & pid=$!
  > soon '[ -e m/README ]'
  > kill -9 $pid; wait $pid 2>/dev/null
  > ls m
  ls: cannot open directory 'm': Transport endpoint is not connected
  [2]
  $ rtdoctor -q | grep $TMP
  warn  here: $TMP/m is a mount of an rtmount that has been killed; try: rtmount -u $TMP/m
  $ rtmount m; ls m | head -n 1
  README
  $ rtmount -u m
