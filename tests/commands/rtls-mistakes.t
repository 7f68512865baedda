One line that says what was meant, for mistakes that people make.

world: two

The words of find, patterns in paths, a directory for its components:

  $ rtfind . -name 'Con*In*' -type c
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ rtls '*.rtc'
  rtls: /localhost:$PORT/test.host_cxt/*.rtc: no such path; to look for a pattern: rtfind /localhost:$PORT/test.host_cxt -n '*.rtc'
  [3]
  $ rtls "/localhost:$PORT/*/Con*"; rtact '/**/*.rtc'
  rtls: /localhost:$PORT/*/Con*: no such path; to look for a pattern: rtfind /localhost:$PORT -n 'Con*'
  rtact: /**/*.rtc: no such path; to look for a pattern: rtfind / -n '*.rtc'
  [3]
  $ rtfind /localhost:$PORT -n 'Con*' | head -n 1
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ rtls nosuchhost; rtls Console
  rtls: /localhost:$PORT/test.host_cxt/nosuchhost: no such path; a name server is written with a slash: /nosuchhost
  rtls: /localhost:$PORT/test.host_cxt/Console: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ rtcwd nosuchhost
  rtcwd: /localhost:$PORT/test.host_cxt/nosuchhost: no such path; a name server is written with a slash: /nosuchhost
  [3]
  $ rtact .
  rtact: /localhost:$PORT/test.host_cxt: not a component (it is a directory; --all takes the components in it)
  [3]

A path that begins with what a name server has, in a working directory that is the root:

  $ RTCSH_CWD=/ rtcat ConsoleIn0.rtc
  rtcat: /ConsoleIn0.rtc: no such path: it begins with no name server; RTSHELL_FIND=1 finds a component by its name alone
  [3]
  $ RTCSH_CWD=/ rtls test.host_cxt
  rtls: /test.host_cxt: no such path: it begins with no name server; RTSHELL_FIND=1 finds a component by its name alone
  [3]
  $ RTCSH_CWD=/ rtprint test.host_cxt/ConsoleIn0.rtc:out
  rtprint: /test.host_cxt/ConsoleIn0.rtc:out: no such path: it begins with no name server; RTSHELL_FIND=1 finds a component by its name alone
  [3]
  $ rtlog -q /ConsoleIn0.rtc:out; rtplot /ConsoleIn0.rtc
  rtlog: /ConsoleIn0.rtc:out: it begins with no name server; RTSHELL_FIND=1 finds a component by its name alone
  rtplot: /ConsoleIn0.rtc: no such path: it begins with no name server; RTSHELL_FIND=1 finds a component by its name alone
  [3]
  $ RTSHELL_FIND=1 RTCSH_CWD=/ rtls ConsoleIn0.rtc; RTSHELL_FIND=1 rtplot ConsoleIn0.rtc
  ConsoleIn0.rtc
  rtplot: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no port specified; it has /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out (see --help)
  [2]

A component in the place of a port:

  $ rtcon ConsoleIn0.rtc
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no source port specified; it has /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out (see --help)
  [2]
  $ rtcon ConsoleIn0.rtc ConsoleIn0.rtc:out
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no source port specified; it has /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out (see --help)
  [2]
  $ rtcon ConsoleIn0.rtc ConsoleOut0.rtc
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no source port specified; these fit: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in (see --help)
  [2]
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc
  rtcon: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no destination port specified; these fit: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in (see --help)
  [2]
  $ rtprint ConsoleIn0.rtc
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no port specified; it has /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out (see --help)
  [2]
  $ rtprint ConsoleOut0.rtc
  rtprint: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no port specified; it has no DataOutPort (see --help)
  [2]
  $ rtprint Nothing0.rtc
  rtprint: /localhost:$PORT/test.host_cxt/Nothing0.rtc: no such path
  [3]
  $ rtcat ConsoleIn0.rtc:
  rtcat: ConsoleIn0.rtc:: no port after the colon
  [2]

Options:

  $ rtact ConsoleIn0.rtc --wait soon
  rtact: argument --wait: not a number of seconds above 0: soon (see --help)
  [2]
  $ rtact --wait -1 ConsoleIn0.rtc
  rtact: argument --wait: not a number of seconds above 0: -1 (see --help)
  [2]
  $ rtcwd --find ConsoleIn0.rtc
  rtcwd: --find is everywhere, not at ConsoleIn0.rtc (see --help)
  [2]
  $ rtprint -n 0 ConsoleIn0.rtc:out
  rtprint: -n 0: no values are printed; without -n there is no end
  $ rtlog -f F -i
  rtlog: nothing to record: no port specified; rtlog show prints what is in a log (see --help)
  [2]
  $ RTCTREE_NAMESERVERS="localhost:$PORT,localhost:1" rtls /
  rtls: localhost:$PORT,localhost:1: several name servers are separated by semicolons
  [2]

Files:

  $ printf '#!/bin/sh\nrtact Motor0.rtc\n' > start.sh; : > empty
  $ rtstart start.sh
  rtstart: start.sh:1:1: a script, not an RtsProfile: #!/bin/sh
  [1]
  $ rtcheck empty
  rtcheck: empty:1:1: the file is empty
  [1]
