rtsh runs many commands in one process: from -c, a file, a pipe, or the keyboard (test_rtsh.py).

world: two
world: hung 1 --context hung.host_cxt/%n.rtc

From -c, with and without the leading rt, separated by semicolons, quoted as in sh:

  $ rtsh -c 'rtls; ls -l ConsoleOut0.rtc; pwd # and no more; ls'
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt
  $ rtsh -c 'find . -n "Console*"; ls "a b" '\''c;d'\'' e\ f "\\x1b" g#h'
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  rtls: /localhost:$PORT/test.host_cxt/a b: no such path
  rtls: /localhost:$PORT/test.host_cxt/c;d: no such path
  rtls: /localhost:$PORT/test.host_cxt/e f: no such path
  rtls: /localhost:$PORT/test.host_cxt/\x1b: no such path
  rtls: /localhost:$PORT/test.host_cxt/g#h: no such path
  [3]
  $ rtsh -c ''; rtsh -c ' ;; # nothing'
  $ rtsh -c 'check "a\$b"; check "a\\b"; check "a\"b\c"; check "it'"'"'s"; check a""b; ""'
  rtcheck: a$b: No such file or directory
  rtcheck: a\\b: No such file or directory
  rtcheck: a"b\\c: No such file or directory
  rtcheck: it's: No such file or directory
  rtcheck: ab: No such file or directory
  rtsh: '': no such command
  [2]

The working directory is its own:

  $ rtsh -c 'cd ..; pwd; ls; cd; pwd; rtcwd nowhere; pwd'; rtpwd
  /localhost:$PORT
  hung.host_cxt/
  test.host_cxt/
  /
  rtcwd: /nowhere: host name not known
  /
  /localhost:$PORT/test.host_cxt

From a pipe and from a file; a backslash at the end of a line joins it with the next:

  $ printf 'act ConsoleIn0.rtc\n\nls \\\n-l ConsoleIn0.rtc' | rtsh
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ printf 'deact ConsoleIn0.rtc\r\nls -l ConsoleIn0.rtc\r\n' > commands && rtsh commands
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtfind . -t c | sed 's/^/act /' | rtsh -v
  rtsh: act /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  rtsh: act /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ rtsh < /dev/null; rtsh <&-
  $ printf '\357\273\277pwd\nls x\000y\ncheck x\000y\n' | rtsh
  /localhost:$PORT/test.host_cxt
  rtsh: stdin:2: a NUL character: ls x\x00y
  rtsh: stdin:3: a NUL character: check x\x00y
  [2]
  $ awk 'BEGIN { printf "ls nowhere"; for (i = 0; i < 500000; i++) printf "ab"; print ""; print "pwd" }' |
  >     within 0-5 rtsh 2> out
  /localhost:$PORT/test.host_cxt
  $ grep -c nowhere out
  1
  $ rtsh nowhere
  rtsh: nowhere: No such file or directory
  [1]

A command that reads stdin itself gets what follows its line:

  $ printf 'conf ConsoleIn0.rtc load -\nConsoleIn0.rtc\n' | rtsh
  rtconf: -:1: neither [set] nor name=value
  [1]

The exit status is that of the last command; with -e that of the first that failed:

  $ rtsh -c 'ls nowhere; ls ConsoleIn0.rtc'
  rtls: /localhost:$PORT/test.host_cxt/nowhere: no such path; a name server is written with a slash: /nowhere
  ConsoleIn0.rtc
  $ rtsh -e -c 'ls nowhere; ls ConsoleIn0.rtc'
  rtls: /localhost:$PORT/test.host_cxt/nowhere: no such path; a name server is written with a slash: /nowhere
  [3]
  $ printf 'pwd -x\nls ConsoleIn0.rtc\n' | rtsh
  rtpwd: unrecognized arguments: -x (see --help)
  ConsoleIn0.rtc
  $ printf 'pwd -x\nls ConsoleIn0.rtc\n' | rtsh --stop
  rtpwd: unrecognized arguments: -x (see --help)
  [2]
  $ rtsh -c 'ls nowhere; exit; pwd'
  rtls: /localhost:$PORT/test.host_cxt/nowhere: no such path; a name server is written with a slash: /nowhere
  [3]
  $ rtsh -c 'exit 7; pwd'
  [7]
  $ rtsh -c 'exit often; pwd'
  rtsh: exit: not a status: often
  [2]
  $ rtsh -c 'exit 300'
  rtsh: exit: not a status: 300
  [2]
  $ printf 'exit 300\npwd\n' | rtsh
  rtsh: exit: not a status: 300
  [2]
  $ rtsh -c 'exit 1 2'
  rtsh: exit: not a status: 1 2
  [2]

help lists the commands, and helps with one:

  $ rtsh -c help | grep -e commands -e rtact -e cd -e exit
  commands, with or without rt; help COMMAND says more:
    rtact        Activate components.
    rtexit       Make components exit.
    rtsh         Run many commands in one process, which keeps its connections.
    cd  changes the working directory, as rtcwd does
    exit [STATUS]  ends rtsh
  $ rtsh -c 'help pwd' | head -1
  usage: rtpwd [OPTION ...]
  $ rtsh -c 'help nothing'
  rtsh: nothing: no such command
  [2]
  $ rtsh -c 'help log show' | grep '^Show'; rtsh -c 'help keep adopt' | grep '^Write'
  Show what is in a log.
  Write the present state of a system into its RtsProfile.

What it does not understand, or leaves to a real shell; in a file the line is reported, and the others are run:

  $ rtsh -c 'rtlss; pwd'
  rtsh: rtlss: no such command; did you mean rtls?
  /localhost:$PORT/test.host_cxt
  $ rtsh -c lss
  rtsh: lss: no such command; did you mean ls?
  [2]
  $ rtsh -c 'rtsh -c pwd'
  rtsh: rtsh: no such command; did you mean rtls?
  [2]
  $ rtsh -c 'ls | cat'
  rtsh: |: only a real shell has that; quote it if it belongs to a word
  [2]
  $ printf 'ls > file\nls "a\npwd && pwd\npwd\nls \\' | rtsh
  rtsh: stdin:1: >: only a real shell has that; quote it if it belongs to a word
  rtsh: stdin:2: a quote or a backslash without its other half: "a
  rtsh: stdin:3: &&: only a real shell has that; quote it if it belongs to a word
  /localhost:$PORT/test.host_cxt
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ printf 'ls > file\npwd\n' | rtsh -e
  rtsh: stdin:1: >: only a real shell has that; quote it if it belongs to a word
  [2]
  $ rtsh -c pwd commands
  rtsh: -c and a file: one of the two (see --help)
  [2]
  $ rtsh a b
  rtsh: unrecognized arguments: b (see --help)
  [2]

Each command has its own options and starts with a clean slate; --timeout of rtsh is the default for all:

  $ within 3-9 rtsh --timeout 1 -c 'ls -l ../hung.host_cxt; cat ../hung.host_cxt/Mock0.rtc; cat --timeout 1.5 ../hung.host_cxt/Mock0.rtc; pwd'
  ?  -  -  -  -  ?Mock0.rtc
  rtls: 1 of 1 did not answer (Mock0.rtc)
  rtcat: /localhost:$PORT/hung.host_cxt/Mock0.rtc: no answer within 1s
  rtcat: /localhost:$PORT/hung.host_cxt/Mock0.rtc: no answer within 1.5s
  /localhost:$PORT/test.host_cxt
  $ RTSHELL_TIMEOUT=never rtsh -c pwd
  rtsh: RTSHELL_TIMEOUT: not a number of seconds above 0: never (see --help)
  [2]

The reader goes away; Ctrl-C:

  $ yes pwd | head -5000 | (rtsh; echo $? >&2) | head -n 1
  /localhost:$PORT/test.host_cxt
  141
  $ interrupt 0.5 rtsh -c 'find . -n nobody --wait 60; pwd'
  [130]

The connections stay open, so a second command asks no more than the first:

  $ ctl reset
  $ rtsh -c 'ls ConsoleIn0.rtc; ls; ls'
  ConsoleIn0.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ calls
  5 _non_existent

Its connections may be old ones: what has ended meanwhile is reported as ever, and is no failure where it would be none:

  $ mock these ConsoleIn:Doomed0 ConsoleIn:Doomed1
  $ {
  >     echo 'ls -l Doomed0.rtc Doomed1.rtc'
  >     soon '[ -s said ]'
  >     kill-mock these
  >     echo "cryo --all -o a.xml $RTCSH_CWD; ls -l Doomed0.rtc"
  > } | rtsh > said
  rtcryo: /localhost:$PORT/test.host_cxt/Doomed0.rtc: zombie, left out
  rtcryo: /localhost:$PORT/test.host_cxt/Doomed1.rtc: zombie, left out
  $ cat said
  Inactive  1/0  0/0  1/0  0/0  Doomed0.rtc
  Inactive  1/0  0/0  1/0  0/0  Doomed1.rtc
  -  -  -  -  -  *Doomed0.rtc

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -c {ls_-l_SERVER;cat_A}
broken component: 0 5
