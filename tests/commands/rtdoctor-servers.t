rtdoctor goes towards each name server step by step, and reports which step fails: the name, TCP, CORBA, the naming context.
Then it looks at every name in it.

world: astray
world: these Mock:Hung0 Mock:Hung1 --context hung.host_cxt/%n.rtc
server: another, whose port is then used by others
faulty: refused dead-host silent drip reset close garbage late-silent late-reset hostile loop

  $ doctor() { rtdoctor "$@" > out; code=$?; grep -v -e "this host's name" -e ": slow (" out; return $code; }

  $ doctor -q localhost:$REFUSED
  fail  /localhost:$REFUSED: connection refused: nothing listens on port $REFUSED here; try: start the name server: rtm-naming $REFUSED
  [1]
  $ doctor -q localhost:$RESET
  fail  /localhost:$RESET: cannot tell from here: TCP connects, then connection lost; what listens there does not speak CORBA, or the network is broken; try: look at what is between here and localhost: firewall (port $RESET), route (ip route get localhost), MTU and loss (ping localhost)
  [1]
  $ doctor -q localhost:$CLOSE
  fail  /localhost:$CLOSE: cannot tell from here: TCP connects, then connection lost; what listens there does not speak CORBA, or the network is broken; try: look at what is between here and localhost: firewall (port $CLOSE), route (ip route get localhost), MTU and loss (ping localhost)
  [1]
  $ doctor -q localhost:$GARBAGE
  fail  /localhost:$GARBAGE: *what listens there does not speak CORBA* (glob)
  [1]
  $ doctor -q localhost:$LATE_RESET
  fail  /localhost:$LATE_RESET: its names cannot be listed (connection lost); try: look at what is between here and localhost: firewall (port $LATE_RESET), route (ip route get localhost), MTU and loss (ping localhost)
  [1]
  $ doctor -q /robot.invalid
  fail  /robot.invalid: host name robot.invalid not known here (*); try: correct the name, or write its address into /etc/hosts (glob)
  [1]
  $ doctor -q localhost:$(ctl port)
  fail  /localhost:*: a CORBA process, but not a name server: perhaps a component or manager; try: correct the port; netstat -ltnp | grep omniNames there shows it (glob)
  [1]
  $ within 1-4 rtdoctor -q --timeout 1 localhost:$DEAD_HOST > out; grep -v "this host's name" out
  fail  /localhost:$DEAD_HOST: no TCP connection to 127.0.0.1 port $DEAD_HOST (no answer within 1s); try: look at what is between here and localhost: firewall (port $DEAD_HOST), route (ip route get localhost), MTU and loss (ping localhost)
  $ doctor -q --timeout 1 localhost:$SILENT
  fail  /localhost:$SILENT: hung: accepts TCP, but no answer within 1s; try: restart it; netstat -ltnp | grep :$SILENT there names its process
  [1]
  $ doctor -q --timeout 2 localhost:$LATE_SILENT
  fail  /localhost:$LATE_SILENT: its names cannot be listed (no answer within 2s); try: restart the name server that has it
  [1]

All of them at once take no longer than one, and every one is reported:

  $ within 0.5-2 rtdoctor -q --timeout 0.5 localhost:$REFUSED localhost:$RESET localhost:$CLOSE \
  >     localhost:$GARBAGE \
  > localhost:$LATE_RESET localhost:$DEAD_HOST localhost:$SILENT localhost:$DRIP localhost:$LATE_SILENT > out
  [1]
  $ grep -c '^fail  /localhost:' out
  9

What a name server says is printed as any text from outside; a loop is no reason to go round:

  $ doctor -q localhost:$HOSTILE | cut -c1-64
  fail  /localhost:$HOSTILE/$(touch canary);`touch canary`.rtc: someb
  $ doctor -q localhost:$LOOP | cut -c1-40
  fail  /localhost:$LOOP/again.host_cxt/le

Names that lead nowhere, to the same, to somebody else:

  $ doctor -q .
  fail  /localhost:$PORT/test.host_cxt/Ended0.rtc: dead (zombie): what listens at 127.0.0.1:* now does not have it; try: rtdel -z /localhost:$PORT/test.host_cxt/Ended0.rtc (glob)
  fail  /localhost:$PORT/test.host_cxt/Nil0.rtc: the name is bound to nothing (a nil reference); try: rtdel /localhost:$PORT/test.host_cxt/Nil0.rtc
  fail  /localhost:$PORT/test.host_cxt/Stranger0.rtc: somebody else's: not a component but IDL:SimpleService/MyService:1.0; try: see who uses this name; if nobody does: rtdel /localhost:$PORT/test.host_cxt/Stranger0.rtc
  fail  /localhost:$PORT/test.host_cxt/dead.cxt/Gone0.rtc: dead (zombie): what listens at 127.0.0.1:* now does not have it; try: rtdel -z /localhost:$PORT/test.host_cxt/dead.cxt/Gone0.rtc (glob)
  warn  /localhost:$PORT/test.host_cxt/dead.cxt: stale: only dead names are in it; try: when the dead names in it are deleted it is empty; then: rtdel /localhost:$PORT/test.host_cxt/dead.cxt
  warn  /localhost:$PORT/test.host_cxt/empty.cxt: stale: empty; try: rtdel /localhost:$PORT/test.host_cxt/empty.cxt/emptier.cxt /localhost:$PORT/test.host_cxt/empty.cxt
  warn  /localhost:$PORT/test.host_cxt/Other0.rtc: somebody else's name: this component calls itself test.host_cxt/Moved0.rtc; try: restart it, so that it binds its own name; do not delete this one: no other leads to it
  warn  /localhost:$PORT/test.host_cxt/Wrong0.rtc: the same component as /localhost:$PORT/test.host_cxt/Right0.rtc; the same with /localhost:$PORT/test.host_cxt/Wrong1.rtc and /localhost:$PORT/test.host_cxt/Wrong2.rtc; try: see who uses this name; if nobody does: rtdel /localhost:$PORT/test.host_cxt/Wrong0.rtc
  warn  /localhost:$PORT/test.host_cxt/Wrong3.rtc: and 2 names like it; try: see who uses this name; if nobody does: rtdel /localhost:$PORT/test.host_cxt/Wrong3.rtc
  warn  /: all components examined are Inactive: none has been started; try: rtact /localhost:$PORT/test.host_cxt/Other0.rtc /localhost:$PORT/test.host_cxt/Right0.rtc
  [1]

  $ rtdoctor Thing0.obj | grep Thing0
  ok    /localhost:$PORT/test.host_cxt/Thing0.obj: another CORBA object, IDL:SimpleService/MyService:1.0, at 127.0.0.1:* (glob)

A process that has ended, one that hangs, and one that took over the port of another:

  $ hang these; kill-mock names2
  $ mock these Mock:Dead0 --port $PORT2 --context dead.host_cxt/%n.rtc
  $ kill-mock these2
  $ within 4-12 rtdoctor -q --timeout 4 ../hung.host_cxt > out
  [1]
  $ grep fail out
  fail  /localhost:$PORT/hung.host_cxt/Hung0.rtc: hung: 127.0.0.1:* accepts TCP, but no answer within 4s; try: restart it; netstat -ltnp | grep :* there names its process (glob)
  fail  /localhost:$PORT/hung.host_cxt/Hung1.rtc: hung: 127.0.0.1:* accepts TCP, but no answer within 4s; try: restart it; netstat -ltnp | grep :* there names its process (glob)
  $ doctor -q ../dead.host_cxt
  fail  /localhost:$PORT/dead.host_cxt/Dead0.rtc: dead (zombie): nothing listens at 127.0.0.1:*; try: rtdel -z /localhost:$PORT/dead.host_cxt/Dead0.rtc (glob)
  warn  /localhost:$PORT/dead.host_cxt: stale: only dead names are in it; try: when the dead names in it are deleted it is empty; then: rtdel /localhost:$PORT/dead.host_cxt
  [1]
  $ mock these Mock:Other0 --port $PORT2 --context other.host_cxt/%n.rtc
  $ doctor -q ../dead.host_cxt ../other.host_cxt
  fail  /localhost:$PORT/dead.host_cxt/Dead0.rtc: dead (zombie): what listens at 127.0.0.1:* now does not have it; try: rtdel -z /localhost:$PORT/dead.host_cxt/Dead0.rtc (glob)
  warn  /localhost:$PORT/dead.host_cxt: stale: only dead names are in it; try: when the dead names in it are deleted it is empty; then: rtdel /localhost:$PORT/dead.host_cxt
  warn  /: all components examined are Inactive: none has been started; try: rtact /localhost:$PORT/other.host_cxt/Other0.rtc
  [1]

A reference may publish several addresses, some of them out of reach:

  $ ORBendPointPublish=giop:tcp:127.0.0.1:,giop:tcp:127.0.0.1:1 mock these ConsoleIn:Two0 \
  >     --context two.host_cxt/%n.rtc
  $ rtact ../two.host_cxt/Two0.rtc; doctor -q ../two.host_cxt/Two0.rtc
  warn  /localhost:$PORT/two.host_cxt/Two0.rtc: also publishes 127.0.0.1:1, out of reach (connection refused); try: have its process publish only addresses that others reach: corba.endpoints in rtc.conf
