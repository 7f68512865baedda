rtkeep leaves a system as it is when its terminal is closed. (What signals and people do: tests/sim/stories/rtkeep-ends.t, what
becomes of processes that it has started: rtkeep-processes.t there.)

world: these ConsoleIn ConsoleOut Motor --flavour cpp2
world: sources 1 100 8

  $ states() { rtls -l | awk '{print $1, $2, $6}'; }
  $ export XDG_RUNTIME_DIR=$PWD; rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o a.xml localhost:$PORT

A closed terminal ends rtkeep; the shell and the kernel may both say that it is closed.

  $ cat > terminal.py <<'EOF'
  > import os, pty, signal, sys, time
  > child, terminal = pty.fork()
  > if child == 0:
  >     if sys.argv[1] == "nohup":
  >         signal.signal(signal.SIGHUP, signal.SIG_IGN)
  >     os.execvp("rtkeep", ["rtkeep", "a.xml"])
  > while os.system("rtkeep status 2> nul | grep -q ';.all.is'"):
  >     time.sleep(0.05)
  > if sys.argv[1] == "twice":
  >     os.kill(child, signal.SIGHUP)
  > os.close(terminal)
  > if sys.argv[1] == "nohup":
  >     time.sleep(0.5)
  >     os.kill(child, signal.SIGTERM)
  > print(os.waitpid(child, 0)[1])
  > EOF
  $ for how in once twice nohup; do python3 terminal.py $how; rtkeep status; states; done
  0
  rtkeep: no rtkeep runs
  Active 1/1 ConsoleIn0.rtc
  Active 1/1 ConsoleOut0.rtc
  Active 2/0 Motor0.rtc
  Active 2/0 Source0.rtc
  0
  rtkeep: no rtkeep runs
  Active 1/1 ConsoleIn0.rtc
  Active 1/1 ConsoleOut0.rtc
  Active 2/0 Motor0.rtc
  Active 2/0 Source0.rtc
  0
  rtkeep: no rtkeep runs
  Active 1/1 ConsoleIn0.rtc
  Active 1/1 ConsoleOut0.rtc
  Active 2/0 Motor0.rtc
  Active 2/0 Source0.rtc
