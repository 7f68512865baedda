rtpwd prints the working directory in the RTC Tree. It contacts nothing: in this transcript no name
server runs, and omniORBpy is not needed.

python: pure

  $ rtpwd
  /localhost:$PORT/test.host_cxt

Without a working directory, and with an empty one, it is the root:

  $ RTCSH_CWD= rtpwd
  /

  $ unset RTCSH_CWD; rtpwd
  /

The directory is spelt in one way, and cannot harm a terminal:

  $ RTCSH_CWD=/robot//a.cxt/./b.cxt/.. rtpwd
  /robot/a.cxt

  $ RTCSH_CWD=$(printf '/robot/\033[1mA\\.b.cxt') rtpwd
  /robot/\x1b[1mA.b.cxt

  $ RTCSH_CWD=robot rtpwd
  rtpwd: robot: a working directory (RTCSH_CWD) starts with /
  [2]

Without docstrings a command lacks the words of its help, and nothing else; failures are reported as ever:

  $ PYTHONOPTIMIZE=2 rtpwd
  /
  $ RTCSH_CWD=robot PYTHONOPTIMIZE=2 rtpwd
  rtpwd: robot: a working directory (RTCSH_CWD) starts with /
  [2]
  $ PYTHONOPTIMIZE=2 rtpwd --help -v | head -n 1
  usage: rtpwd [--json] [-v] [-q] [--timeout SECONDS] [--version] [-h]

JSON:

  $ RTCSH_CWD='/robot/"a.cxt' rtpwd --json
  {"path": "/robot/\"a.cxt"}

Variables by the names that manuals of rtshell give them:

  $ RTCSH_NAMESERVERS=robot rtpwd; RTSH_CWD=/robot rtpwd -q
  rtpwd: RTCSH_NAMESERVERS is not read; the variable is RTCTREE_NAMESERVERS
  /
  /
  $ RTCSH_NAMESERVERS=robot rtsh -c 'pwd; pwd'
  rtsh: RTCSH_NAMESERVERS is not read; the variable is RTCTREE_NAMESERVERS
  /
  /

Nothing else is taken:

  $ rtpwd /robot
  rtpwd: unrecognized arguments: /robot (see --help)
  [2]
  $ rtpwd --lang
  rtpwd: unrecognized arguments: --lang (see --help)
  [2]
  $ rtpwd --version
  1.0.0

Help holds what the command is for, and examples (the words around them differ between Pythons):

  $ rtpwd --help | grep '^Print'
  Print the working directory in the RTC Tree.
  $ rtpwd --help | grep -A 1 '^examples'
  examples:
    rtpwd

Its output can be refused:

  $ rtpwd >/dev/full
  rtpwd: No space left on device
  [1]
  $ rtpwd >&-
  rtpwd: cannot write the output: Bad file descriptor
  [1]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

local: it contacts nobody
examples: asking
