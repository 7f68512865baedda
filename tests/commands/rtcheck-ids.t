Connections that somebody has made again, under other ids than those of the file.

world: linked
world: topics --context plain.host_cxt/%n.rtc

  $ rtdis ConsoleIn0.rtc; rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo -q -o robot.rtsys .; rtcheck -s Inactive robot.rtsys

An equal connection is as good. That is reported, with both ids, and the status is 0; rtresurrect has nothing to do:

  $ rtdis ConsoleIn0.rtc; rtcon -i mine ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcheck -s Inactive robot.rtsys; rtcheck --json -s Inactive robot.rtsys
  Connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in has another id: mine, not one
  {"actual": "mine", "check": "connection id", "expected": "one", "message": "Connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in has another id: mine, not one", "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in", "required": false}
  $ rtcheck -q -s Inactive robot.rtsys
  $ rtcheck --extra -s Inactive robot.rtsys 2>&1 | grep Connection
  Connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in has another id: mine, not one
  $ rtresurrect robot.rtsys; ctl connectors ConsoleIn0:out
  mine outin
  $ rtdoctor -q -s Inactive --profile robot.rtsys . | grep connection
  [1]

So rtteardown removes it:

  $ rtteardown robot.rtsys; ctl connectors ConsoleIn0:out
  $ rtcheck -s Inactive robot.rtsys
  No connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  [1]

One with other properties is another connection:

  $ rtcon -i flushing -p dataport.subscription_type=flush ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcheck -s Inactive robot.rtsys
  Connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in is another one: flushing, not one
  [1]
  $ rtresurrect robot.rtsys
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: already connected with another id (flushing); rtdis removes that
  rtresurrect: 6 already done, 1 failed
  [5]
  $ rtteardown robot.rtsys; ctl connectors ConsoleIn0:out
  flushing outin

A port that is connected alone, at the start of its component, gets a new id each time:

  $ export RTCSH_CWD=/localhost:$PORT/plain.host_cxt
  $ rtcon -i a -n chatter -p dataport.interface_type=fast-rtps ConsoleIn0.rtc:out
  $ rtcryo -q -o topic.rtsys .
  $ rtdis ConsoleIn0.rtc; rtcon -i b -n chatter -p dataport.interface_type=fast-rtps ConsoleIn0.rtc:out
  $ rtcheck -s Inactive topic.rtsys
  Connection of /localhost:$PORT/plain.host_cxt/ConsoleIn0.rtc:out has another id: b, not a
  $ rtresurrect topic.rtsys; ctl @topics connectors ConsoleIn0:out
  b chatter
  $ rtcon -i c -p dataport.interface_type=ssm ConsoleIn0.rtc:out; rtteardown topic.rtsys
  $ ctl @topics connectors ConsoleIn0:out
  c out
