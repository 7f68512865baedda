What rtls looks like on a terminal: columns, and colours.

world: console
world: zombie --context test.host_cxt/Dead%n.rtc

As many columns as fit, filled row by row.

  $ NO_COLOR=1 terminal 80 rtls
  ConsoleIn0.rtc  ConsoleOut0.rtc           ConsoleOut1.rtc
  *DeadMock0.rtc  SequenceInComponent0.rtc  SequenceOutComponent0.rtc
  $ NO_COLOR=1 terminal 60 rtls
  ConsoleIn0.rtc            ConsoleOut0.rtc
  ConsoleOut1.rtc           *DeadMock0.rtc
  SequenceInComponent0.rtc  SequenceOutComponent0.rtc
  $ NO_COLOR=1 terminal 45 rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  ConsoleOut1.rtc
  *DeadMock0.rtc
  SequenceInComponent0.rtc
  SequenceOutComponent0.rtc
  $ NO_COLOR=1 terminal 24 rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  ConsoleOut1.rtc
  *DeadMock0.rtc
  SequenceInComponent0.rtc
  SequenceOutComponent0.rtc
  $ NO_COLOR=1 terminal 1 rtls ConsoleIn0.rtc ConsoleOut0.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ NO_COLOR=1 terminal 0 rtls ConsoleIn0.rtc ConsoleOut0.rtc
  ConsoleIn0.rtc  ConsoleOut0.rtc
  $ COLUMNS=20 NO_COLOR=1 terminal 0 rtls ConsoleIn0.rtc ConsoleOut0.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  $ NO_COLOR=1 terminal 80 rtls -R ..
  .:
  test.host_cxt/

  ./test.host_cxt:
  ConsoleIn0.rtc  ConsoleOut0.rtc           ConsoleOut1.rtc
  *DeadMock0.rtc  SequenceInComponent0.rtc  SequenceOutComponent0.rtc
   (esc)

One a line in a pipe, however wide.

  $ terminal 200 sh -c 'rtls | cat'
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  ConsoleOut1.rtc
  *DeadMock0.rtc
  SequenceInComponent0.rtc
  SequenceOutComponent0.rtc

Colours: directories, zombies, states.

  $ terminal 30 rtls .. DeadMock0.rtc
  *\x1b[02;37mDeadMock0.rtc\x1b[00m (esc)

  ..:
  \x1b[01;34mtest.host_cxt\x1b[00m/ (esc)
   (esc)
  $ ctl error ConsoleOut1
  $ terminal 80 rtls -l | tail -n 4
  \x1b[01;37;41mError\x1b[00m     \x1b[01m1\x1b[00m/0    \x1b[01m1\x1b[00m/0   \x1b[01m0\x1b[00m/0   \x1b[01m0\x1b[00m/0  ConsoleOut1.rtc (esc)
  -         -      -     -     -    *\x1b[02;37mDeadMock0.rtc\x1b[00m (esc)
  \x1b[01;34mInactive\x1b[00m  \x1b[01m10\x1b[00m/0   \x1b[01m10\x1b[00m/0  \x1b[01m0\x1b[00m/0   \x1b[01m0\x1b[00m/0  SequenceInComponent0.rtc (esc)
  \x1b[01;34mInactive\x1b[00m  \x1b[01m10\x1b[00m/0   \x1b[01m0\x1b[00m/0   \x1b[01m10\x1b[00m/0  \x1b[01m0\x1b[00m/0  SequenceOutComponent0.rtc (esc)
  $ terminal 80 rtls -l ..
  STATE  PORTS  IN  OUT  SVC  NAME
  -      -      -   -    -    \x1b[01;34mtest.host_cxt\x1b[00m (esc)

Not with NO_COLOR (which must not be empty), on a terminal that cannot, in a file, or for programs.

  $ NO_COLOR=1 terminal 80 rtls -l ConsoleIn0.rtc
  STATE     PORTS  IN   OUT  SVC  NAME
  Inactive  1/0    0/0  1/0  0/0  ConsoleIn0.rtc
  $ NO_COLOR= terminal 80 rtls -l ConsoleIn0.rtc
  STATE     PORTS  IN   OUT  SVC  NAME
  \x1b[01;34mInactive\x1b[00m  \x1b[01m1\x1b[00m/0    \x1b[01m0\x1b[00m/0  \x1b[01m1\x1b[00m/0  \x1b[01m0\x1b[00m/0  ConsoleIn0.rtc (esc)
  $ TERM=dumb terminal 80 rtls -l ConsoleIn0.rtc
  STATE     PORTS  IN   OUT  SVC  NAME
  Inactive  1/0    0/0  1/0  0/0  ConsoleIn0.rtc
  $ FORCE_COLOR=1 CLICOLOR_FORCE=1 rtls -l ConsoleIn0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ FORCE_COLOR=1 terminal 80 rtls --json ConsoleIn0.rtc
  {"kind": "component", "name": "ConsoleIn0.rtc", "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc"}
  $ terminal 80 rtls -0 ConsoleIn0.rtc | tr '\0' '\n'
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
