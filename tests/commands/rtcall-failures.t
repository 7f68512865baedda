What can go wrong with rtcall, and calls again and again.

world: these Robot
both: each ORB reads and writes values in its own way

  $ export RTSHELL_IDL="$MOCKS"; rtact --wait Robot0.rtc

Wrong arguments are one line each, before anything is sent:

  $ ctl reset
  $ rtcall Robot0.rtc:svc sey hello
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc: no such operation: sey; did you mean say?
  [3]
  $ rtcall Robot0.rtc:svc say
  rtcall: say: words is missing: string say(in string words);
  [2]
  $ rtcall Robot0.rtc:svc say a b
  rtcall: say takes 1 argument (words), not 2 (see --help)
  [2]
  $ rtcall Robot0.rtc:svc say wort=a
  rtcall: say: no parameter wort; did you mean words?
  [2]
  $ rtcall Robot0.rtc:svc say a words=b
  rtcall: say: words is given twice (see --help)
  [2]
  $ rtcall Robot0.rtc:svc say a -d '{}'
  rtcall: arguments, or -d for all of them, not both (see --help)
  [2]
  $ rtcall Robot0.rtc:svc say -d '[]'
  rtcall: say: not a JSON object of its arguments, {…}
  [2]
  $ rtcall Robot0.rtc:svc say -d '{'
  rtcall: say: not JSON (Expecting property name enclosed in double quotes: line 1 column 2 (char 1))
  [2]
  $ rtcall Robot0.rtc:svc say -d @none.json
  rtcall: none.json: No such file or directory
  [1]
  $ rtcall Robot0.rtc:svc move_to 3 0
  rtcall: move_to: goal: not a Point: 3 (its members: x, y)
  [2]
  $ rtcall Robot0.rtc:svc move_to '{"x": 1}' 0
  rtcall: move_to: goal: y is missing
  [2]
  $ rtcall Robot0.rtc:svc move_to distance=3
  rtcall: move_to: distance is an out parameter: it is not given
  [2]
  $ rtcall Robot0.rtc:svc follow '[{"name": "a", "goal": {"x": 1, "y": 2}, "mode": "MOVIN"}]'
  rtcall: follow: steps[0].mode: no Mode: 'MOVIN' (they are STANDING, MOVING, BROKEN)
  [2]
  $ rtcall Robot0.rtc:svc sum 40000 0 0 0 0 0 a
  rtcall: sum: a: out of range for a short (-32768 to 32767): 40000
  [2]
  $ rtcall Robot0.rtc:svc wide a abcdef
  rtcall: wide: brief: longer than 5 bytes of UTF-8
  [2]
  $ rtcall Robot0.rtc:svc keep 3
  rtcall: keep: value: not an any: 3: write {"_type": "long", "_value": 42}
  [2]
  $ rtcall Robot0.rtc:svc keep '{"_type": "Pint", "_value": 3}'
  rtcall: Pint: no such data type: name its IDL file (--idl FILE) or compiled stubs (-m MODULE -p DIR), or look at the bytes (--raw)
  [3]
  $ rtcall Robot0.rtc:svc friend IOR:00
  rtcall: friend: other: not a reference (its octets make no sense)
  [2]
  $ rtcall Robot0.rtc:svc speed=fast
  rtcall: speed: not a double: fast
  [2]
  $ rtcall Robot0.rtc:svc speed 3
  rtcall: speed is an attribute: speed=VALUE sets it (see --help)
  [2]
  $ rtcall Robot0.rtc say hello
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc: no such operation: say (there are: get_component_profile, get_ports, initialize, finalize, is_alive, exit, attach_context, detach_context, get_context, get_owned_contexts, get_participating_contexts, get_context_handle, …); rtcall /localhost:$PORT/test.host_cxt/Robot0.rtc lists what its ports provide
  [3]
  $ rtcall Robot0.rtc:svc speeed=3
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc: no such operation: speeed; did you mean speed?
  [3]
  $ RTSHELL_IDL= rtcall Robot0.rtc:svc say hello
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm: no such IDL: IDL:Mock/Robot:1.0; name its file (--idl FILE), or its directory (RTSHELL_IDL)
  [3]
  $ rtcall Robot0.rtc:svc say hello --limit 0
  rtcall: argument --limit: not a number of seconds above 0: 0 (see --help)
  [2]
  $ rtcall Robot0.rtc:svc -n 2
  rtcall: no operation is named (see --help)
  [2]
  $ ctl calls Robot0 | grep -v 'connect\|get_port'
  [1]

Its IDL is not that of the provider: what that means, as far as it can be known:

  $ cat >wrong.idl <<END
  > module Mock { interface Robot { void nix(); string say(in string words, in double more); void move_to(); long ending();
  >   string model(); void rest(in double seconds, in string why); }; };
  > END
  $ rtcall Robot0.rtc:svc nix --idl wrong.idl
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm nix: it has no such operation: wrong.idl is probably not its IDL (IDL:Mock/Robot:1.0)
  [6]
  $ rtcall Robot0.rtc:svc say a 1 --idl wrong.idl
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm say: it cut the connection and lives: it probably takes other arguments, and did nothing; wrong.idl is probably not its IDL (IDL:Mock/Robot:1.0)
  [6]
  $ rtcall Robot0.rtc:svc move_to --idl wrong.idl
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm move_to: it takes other arguments: wrong.idl is probably not its IDL (IDL:Mock/Robot:1.0)
  [6]
  $ rtcall Robot0.rtc:svc.arm say 'a text that is long enough'
  a text that is long enough
  $ rtcall Robot0.rtc:svc.arm ending --idl wrong.idl
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm ending: done, but its answer is of another type: wrong.idl is probably not its IDL (IDL:Mock/Robot:1.0)
  [4]
  $ rtcall Robot0.rtc:svc.arm say 'still there'
  still there

A request that is lost may have been done; nothing is tried again:

  $ ctl fail rest 1 LOST; rtcall Robot0.rtc:svc rest 0 --limit 0.5
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: no answer within 0.5s; it may have been done, or be going on
  [4]
  $ ctl calls Robot0 | grep rest
  1 rest

Again and again, with statistics:

  $ rtcall Robot0.rtc:svc speed -r 0 -n 50
  50 calls, 0 failed, in \d+\.\d{3} s: min \d+\.\d{3} ms, median \d+\.\d{3} ms, 99 % \d+\.\d{3} ms, max \d+\.\d{3} ms (re)
  $ rtcall Robot0.rtc:svc speed -r 200 -n 3 --each
  \d+\.\d{3} ms  1\.0 (re)
  \d+\.\d{3} ms  1\.0 (re)
  \d+\.\d{3} ms  1\.0 (re)
  3 calls, 0 failed, in \d+\.\d{3} s: min \d+\.\d{3} ms, median \d+\.\d{3} ms, 99 % \d+\.\d{3} ms, max \d+\.\d{3} ms (re)
  $ rtcall Robot0.rtc:svc speed -n 2 --each --json
  {"error": null, "seconds": *, "value": {"result": 1.0}} (glob)
  {"error": null, "seconds": *, "value": {"result": 1.0}} (glob)
  {"calls": 2, "failed": 0, "max": *, "median": *, "min": *, "p99": *, "seconds": *} (glob)
  $ rtcall Robot0.rtc:svc move_to 'Point(30, 4)' 0 -n 2 --each
  \d+\.\d{3} ms  /localhost:\$PORT/test\.host_cxt/Robot0\.rtc:svc\.arm\ move_to:\ OutOfReach\(nearest=\(x=10\.0,\ y=4\.0\),\ by=20\.0\) (re)
  \d+\.\d{3} ms  /localhost:\$PORT/test\.host_cxt/Robot0\.rtc:svc\.arm\ move_to:\ OutOfReach\(nearest=\(x=10\.0,\ y=4\.0\),\ by=20\.0\) (re)
  2 calls, 2 failed, in \d+\.\d{3} s (re)
  [6]
  $ rtcall Robot0.rtc:svc move_to 'Point(30, 4)' 0 -n 2
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm move_to: OutOfReach(nearest=(x=10.0, y=4.0), by=20.0)
  2 calls, 2 failed, in \d+\.\d{3} s (re)
  [6]
  $ ctl reset; rtcall Robot0.rtc:svc rest 20 --limit 0.2 -n 3
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: no answer within 0.2s; it may have been done, or be going on
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm: ended after 1 of 3 calls
  1 call, 1 failed, in \d+\.\d{3} s (re)
  [4]
  $ interrupt 'ctl calls Robot0 | grep "[4-9] _get_speed"' rtcall Robot0.rtc:svc speed -r 20 2>/dev/null |
  >     sed 's/^[0-9]* calls, 0 failed, in .*/ok/'
  ok

A call that does not end; an operation whose provider dies of it:

  $ rtcall Robot0.rtc:svc rest 20 --limit 0.2
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: no answer within 0.2s; it may have been done, or be going on
  [4]
  $ ctl reset; interrupt 'ctl calls Robot0 | grep rest' rtcall Robot0.rtc:svc rest 60 --limit 60
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: interrupted; it may have been done, or be going on
  [130]
  $ rtcall Robot0.rtc:svc lose
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm lose: connection lost, its process has probably ended; it may have been done, or be going on
  [4]
  $ rtcall Robot0.rtc:svc speed
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc: connection refused; its process is gone (zombie)
  [4]
