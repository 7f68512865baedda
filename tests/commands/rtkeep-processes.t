rtkeep --processes starts the processes of a robot, each when what it needs is ready, keeps them, and ends them in reverse. (What
hangs, is never ready, or is started by others: tests/sim/stories/rtkeep-processes.t.)

world: these ConsoleIn

  $ export XDG_RUNTIME_DIR=$PWD
  $ mocks() {
  >     echo "sh -c 'exec 0<>fifo; unset MOCK_CONTROL; PYTHONPATH=$MOCK_PATH exec $MOCK_PYTHON -m mock_components these $* --nameserver 127.0.0.1:$PORT --control $PWD/$1.control'"
  > }
  $ mkfifo fifo; cat > Procfile <<EOF
  > # processes of a robot
  > motor: $(mocks Motor)
  > motor.ready: /localhost:$PORT/test.host_cxt/Motor0.rtc
  > motor.delay: 0.1-1
  > out: $(mocks ConsoleOut)
  > out.after: motor
  > out.ready: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  > talk: sh -c 'echo \$WORD from \$PWD; echo more >&2; exec sleep 1000'
  > talk.env: WORD=hello
  > talk.after: motor out
  > talk.stop: INT 5
  > brief: true
  > brief.restart: no
  > missing: /nowhere/at/all
  > missing.burst: 1/60
  > EOF

Each is started when those before it are ready; what they print is kept, and shown with -v.

  $ mkdir logs; rtkeep -v --log logs --processes Procfile > out 2> err & keep=$!
  $ soon 'grep more logs/talk.log'; soon 'grep missing.*given out'
  $ soon 'grep brief.*not.started out'
  $ said out | grep -v -e brief -e missing -e 'ready 1'
  motor: started, pid N
  motor: Motor0.rtc answers: ready
  out: started, pid N
  out: ConsoleOut0.rtc answers: ready
  talk: started, pid N
  talk: hello from $TMP
  talk: more
  $ grep -e brief -e missing out | said | sort
  brief: ended with status 0: not started again
  brief: started, pid N
  missing: cannot be started: No such file or directory
  missing: cannot be started: No such file or directory: given up after more than 1 failure in 60s
  $ cat err; sed 's/^[-0-9T:]* //' logs/talk.log | sed "s,$PWD,HERE,"
  hello from HERE
  more
  $ rtkeep status | said
  Procfile: pid N, since T; not all is as the file says
    motor    running  ready               T               pid N
    out      running  ready               T               pid N
    talk     running  ready               T               pid N
    brief    stopped  stopped             T
    missing  stopped  stopped (given up)  T  restarts: 1

One that is killed comes back; the system is kept, too, where there is a file.

  $ rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in; rtcryo -o a.xml localhost:$PORT
  rtcryo: 1 component without connections left out; --all saves them, too
  $ kill $keep; wait $keep
  $ ls | grep control; rtls
  ConsoleIn0.rtc
  $ rtkeep --processes Procfile a.xml > out 2>&1 & keep=$!
  $ soon 'rtcheck a.xml'; soon 'rtkeep status | grep out.*ready'
  $ soon 'grep ConsoleOut0.rtc:.Active out'
  $ kill -9 $(rtkeep status --json | sed -n 's/.*"object": "out", "pid": \([0-9]*\),.*/\1/p')
  $ soon 'grep out:.ended.by.SIGKILL out'; soon 'rtcheck a.xml'
  $ soon 'test $(grep -c ConsoleOut0.rtc:.Active out) = 2'
  $ said out | grep -e out: -e Out | sort | uniq -c | sed 's/^ *//'
  2 ConsoleOut0.rtc: Active
  1 ConsoleOut0.rtc: its process is gone
  2 out: ConsoleOut0.rtc answers: ready
  1 out: ended by SIGKILL
  2 out: started, pid N

A second one for a file is refused, and named.

  $ rtkeep a.xml 2>&1 | sed "s/process $keep/process N/"
  rtkeep: a.xml: is kept already, by process N
  $ rtkeep --processes Procfile 2>&1 | sed "s/process $keep/process N/"
  rtkeep: Procfile: is kept already, by process N

At the end the components of these processes are deactivated, then the processes end, the last first; others stay as they are. Nothing survives kill -9, either.

  $ kill $keep; wait $keep
  $ said out | grep -v Inactive | tail -3
  talk: ended by SIGINT: as it was told
  out: ended with status 0: as it was told
  motor: ended with status 0: as it was told
  $ ls | grep control
  [1]
  $ ctl @these state ConsoleIn0
  ACTIVE
  $ rtkeep --processes Procfile a.xml > out 2>&1 & keep=$!
  $ soon 'rtcheck a.xml'; soon 'rtkeep status | grep talk.*ready'
  $ soon 'grep brief.*not.started out'
  $ pids=$(rtkeep status --json | grep process | sed -n 's/.*"pid": \([0-9]*\),.*/\1/p')
  $ echo $pids | wc -w
  3
  $ kill -9 $keep; wait $keep 2> nul
  [137]
  $ for pid in $pids; do soon "! kill -0 $pid"; done

What is wrong with a Procfile is said before anything is started:

  $ try() { printf "$1\n" > p; rtkeep --processes p; }
  $ try ''
  rtkeep: p: no processes
  [1]
  $ try 'a: b\na: c'
  rtkeep: p:2: a is there twice
  [1]
  $ try 'a: ""'
  rtkeep: p: a: no command
  [1]
  $ try 'a: b\0c'
  rtkeep: p:1: it contains a NUL character
  [1]
  $ try 'a: b\na.env: FOO'
  rtkeep: p: a: env: not KEY=VALUE: FOO
  [1]
  $ try 'a: b\na.stop: INT -5'
  rtkeep: p: a: stop: not SIGNAL SECONDS: INT -5
  [1]
  $ try 'a: b\na.stop: SIGINT nan'
  rtkeep: p: a: stop: not SIGNAL SECONDS: SIGINT nan
  [1]
  $ try 'a b c'
  rtkeep: p:1: not NAME: COMMAND, nor NAME.KEY: VALUE with KEY one of after, ready, env, cwd, stop, restart, burst, delay
  [1]
  $ try 'a: b\na.after: c'
  rtkeep: p: a: after c, which is not there
  [1]
  $ try 'a: b\na.after: c\nc: d\nc.after: a'
  rtkeep: p: these wait for each other: a, c
  [1]
  $ try 'a: "b'
  rtkeep: p: a: No closing quotation
  [1]
  $ try 'a: b\na.stop: NOW 5'
  rtkeep: p: a: stop: no such signal: NOW
  [1]
  $ try 'a.cwd: /'
  rtkeep: p: a: no command
  [1]
  $ rtkeep --log nowhere --processes Procfile
  rtkeep: nowhere: not a directory
  [1]
  $ rtkeep --log x a.xml
  rtkeep: --log is for --processes (see --help)
  [2]
  $ rtkeep --processes '' --once a.xml
  rtkeep: argument --processes: the name is empty (see --help)
  [2]
  $ rtkeep --once --processes p a.xml
  rtkeep: --processes ends with rtkeep: not with --once, nor with --dry-run (see --help)
  [2]
