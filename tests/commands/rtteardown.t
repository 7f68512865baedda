rtteardown removes the connections that an RtsProfile lists, from all ends that live.

server: empty
world: these ConsoleIn ConsoleOut
world: these ConsoleOut:ConsoleOut1 ConsoleOut:ConsoleOut2
world: services

  $ rtcon -i one -p x=y ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon -i 'two ends' ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  $ rtcon -i service MyServiceConsumer0.rtc:MyService MyServiceProvider0.rtc:MyService
  $ rtcryo > a.xml
  rtcryo: 1 component without connections left out; --all saves them, too
  $ rtcryo -y > a.yaml
  rtcryo: 1 component without connections left out; --all saves them, too
  $ rtcon -i more ConsoleIn0.rtc:out ConsoleOut2.rtc:in

The commands that would do it:

  $ rtteardown --dry-run a.xml | tee script
  rtdis -i one /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  rtdis -i 'two ends' /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  rtdis -i service /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService
  $ rtteardown --dry-run --force a.xml | head -1
  rtdis --force -i one /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out

Doing it; other connections stay, and a second time nothing is left to do:

  $ rtteardown -v a.xml
  rtteardown: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: done
  rtteardown: connection two ends of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: done
  rtteardown: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: done
  rtteardown: 3 done
  $ rtteardown -v a.yaml
  rtteardown: 3 already done
  $ rtteardown < a.xml; rtteardown --json -x - < a.xml
  {"command": null, "error": null, "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in", "required": true, "result": "already", "step": "disconnect"}
  {"command": null, "error": null, "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in", "required": true, "result": "already", "step": "disconnect"}
  {"command": null, "error": null, "path": "/localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService", "required": true, "result": "already", "step": "disconnect"}
  $ rtls -l
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut1.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut2.rtc
  Inactive  1/0  0/0  0/0  1/0  MyServiceConsumer0.rtc
  Inactive  1/0  0/0  0/0  1/0  MyServiceProvider0.rtc
  $ rtresurrect a.xml; rtteardown --json a.xml | head -1
  {"command": "rtdis -i one /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out", "error": null, "path": "/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in", "required": true, "result": "done", "step": "disconnect"}
  $ rtresurrect a.xml; sh -e script
  $ rtteardown --dry-run -y a.yaml

One that fails is reported, the others are removed; with --rollback these are made again:

  $ rtresurrect a.xml
  $ for n in 1 2 3 4; do
  >     ctl @services fail disconnect $n UNKNOWN
  >     ctl @services fail notify_disconnect $n UNKNOWN
  > done
  $ rtteardown --rollback -v a.xml
  rtteardown: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: undone
  rtteardown: connection two ends of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: not tried
  rtteardown: /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService: CORBA.UNKNOWN
  rtteardown: 1 undone, 1 not tried, 1 failed
  [6]
  $ rtcheck -s inactive a.xml
  $ for n in 1 2 3 4; do
  >     ctl @services fail disconnect $n UNKNOWN
  >     ctl @services fail notify_disconnect $n UNKNOWN
  > done
  $ rtteardown -v a.xml
  rtteardown: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: done
  rtteardown: connection two ends of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc:in: done
  rtteardown: /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService: CORBA.UNKNOWN
  rtteardown: 2 done, 1 failed
  [5]
  $ ctl @services reset; rtteardown -v a.xml
  rtteardown: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: done
  rtteardown: 1 done, 2 already done

Where one end is dead, the others are freed:

  $ rtresurrect a.xml; kill-mock these2
  $ rtteardown -v a.xml
  rtteardown: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: connection refused; its process is gone (zombie)
  rtteardown: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: done
  rtteardown: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: done
  rtteardown: 2 done, 1 already done
  $ rtls -l ConsoleIn0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtresurrect -q a.xml 2>/dev/null
  [5]
  $ rtdel -z ConsoleOut1.rtc; rtteardown -v a.xml
  rtteardown: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: no such path; did you mean ConsoleOut2.rtc?
  rtteardown: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: done
  rtteardown: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: done
  rtteardown: 2 done, 1 already done

A port that its component has not got any more, and components of which none is there any more, are no failure either:

  $ rtresurrect -q a.xml 2>/dev/null
  [5]
  $ sed 's/ConsoleOut0[.]in/ConsoleOut0.old/' a.xml > b.xml; rtteardown -v b.xml
  rtteardown: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: no such path; did you mean ConsoleOut2.rtc?
  rtteardown: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no such port: old (its ports: in)
  rtteardown: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:old: done
  rtteardown: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: done
  rtteardown: 2 done, 1 already done
  $ sed 's/ConsoleIn/AwayIn/g; s/ConsoleOut/AwayOut/g; s/MyService[CP][a-z]*0/&9/g' a.xml > c.xml
  $ rtteardown c.xml
  rtteardown: /localhost:$PORT/test.host_cxt/AwayIn0.rtc: no such path
  rtteardown: /localhost:$PORT/test.host_cxt/AwayOut0.rtc: no such path
  rtteardown: /localhost:$PORT/test.host_cxt/AwayOut1.rtc: no such path
  rtteardown: /localhost:$PORT/test.host_cxt/MyServiceConsumer09.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  rtteardown: /localhost:$PORT/test.host_cxt/MyServiceProvider09.rtc: no such path; did you mean MyServiceProvider0.rtc?

What is silent cannot be freed:

  $ rtresurrect -q a.xml 2>/dev/null
  [5]
  $ hang services; within 1.9-9 rtteardown --timeout 2 -v a.xml
  rtteardown: /localhost:$PORT/test.host_cxt/ConsoleOut1.rtc: no such path; did you mean ConsoleOut2.rtc?
  rtteardown: /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc: no answer within 2s
  rtteardown: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no answer within 2s
  rtteardown: connection one of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: done
  rtteardown: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: not tried because of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc
  rtteardown: 1 done, 1 already done, 2 failed, 1 not tried
  [5]
  $ wake services; rtteardown -qv a.xml
  rtteardown: connection service of /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: done
  rtteardown: 1 done, 2 already done

Where nothing is at all, the file is not of this system; nor is a map that fits nothing in it:

  $ rtteardown --map localhost:$PORT=localhost:$PORT2 a.xml
  rtteardown: /localhost:$PORT2/test.host_cxt: no such path
  rtteardown: 5 failed, 3 not tried
  [3]
  $ rtteardown --map localhost:$PORT=localhost:1 a.xml
  rtteardown: /localhost:1: connection refused; is the name server running?
  rtteardown: 5 failed, 3 not tried
  [4]
  $ rtteardown --map robot=localhost a.xml
  rtteardown: --map robot=localhost: nothing in the file is there (see --help)
  [2]
  $ rtteardown -m localhost a.xml
  rtteardown: not OLD=NEW: localhost (see --help)
  [2]
  $ rtteardown nofile
  rtteardown: nofile: No such file or directory
  [1]
  $ rtteardown --create a.xml
  rtteardown: unrecognized arguments: --create (see --help)
  [2]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: FILE
invocation: --dry-run FILE
invocation: --rollback FILE
looking: --dry-run FILE
broken component: 0 5
prepared: rtresurrect robot.rtsys && rtstart -q robot.rtsys >/dev/null
example: rtcryo | rtteardown <- rtresurrect robot.rtsys && rtstart -q robot.rtsys >/dev/null
