What is opened by name only: values of ports, events, logs. They connect while they are open.

needs: fuse
world: senders 200
world: these ConsoleOut ConsoleOut:Idle0 SequenceInComponent
world: custom
world: observed --context seen.host_cxt/%n.rtc
both: each ORB receives and sends values in its own way

  $ mkdir m bin; busybox --install -s bin
  $ rtmount m
  $ tools=$PATH PATH=$PWD/bin errors=$PWD/m/errors; why() { tail -n 1 $errors; }
  $ cd m/localhost:$PORT/test.host_cxt
  $ ls Source0.rtc/ports/number; ls ConsoleOut0.rtc
  connections
  data_type
  properties
  type
  category
  configuration
  contexts
  description
  instance_name
  members
  ports
  profile.json
  properties
  state
  type_name
  vendor
  version

An out port: value is its next value, values are all, one a line:

  $ cat Source0.rtc/ports/number/value
  \[\d+\.\d+\] \d+ (re)
  $ head -n 3 Source0.rtc/ports/number/values
  \[\d+\.\d+\] \d+ (re)
  \[\d+\.\d+\] \d+ (re)
  \[\d+\.\d+\] \d+ (re)
  $ read -r time number <Source0.rtc/ports/number/value; echo $((number > 0))
  1
  $ while read -r time number; do echo $number; done <Source0.rtc/ports/number/values | head -n 50 |
  > awk 'NR > 1 && $1 != last + 1 {print "gap"} {last = $1} END {print NR}'
  50
  $ head -c 5 Source0.rtc/ports/number/values
  \[\d{4} \(no-eol\) (re)

All readers of a port share a connection, which ends with the last of them:

  $ opened() { soon "ls -l /proc/$1/fd | grep values"; }
  $ cat Source0.rtc/ports/number/values >/dev/null & one=$!
  $ cat Source0.rtc/ports/number/values >/dev/null & two=$!
  $ opened $one; opened $two
  $ head -n 1 Source0.rtc/ports/number/values >/dev/null
  $ PATH=$tools ctl connectors Source0:number | wc -l
  1
  $ kill $one $two; soon '[ "$(PATH=$tools ctl connectors Source0:number | wc -l)" = 0 ]'

An in port: what is written to it has been read when the write returns, or the write fails:

  $ echo Active >ConsoleOut0.rtc/state; PATH=$tools ctl @these received ConsoleOut0:in
  0 -
  $ echo 42 >ConsoleOut0.rtc/ports/in/value; echo '{"data": 43}' >ConsoleOut0.rtc/ports/in/value
  $ echo 'RTC.TimedLong({time}, 44)' >ConsoleOut0.rtc/ports/in/value
  $ printf '45\n46\n' >ConsoleOut0.rtc/ports/in/value
  $ PATH=$tools ctl @these received ConsoleOut0:in
  5 46
  $ printf '%300s\n%212s\n' 47 48 >$TMP/lines; dd if=$TMP/lines of=ConsoleOut0.rtc/ports/in/value bs=512 2>&-
  $ PATH=$tools ctl @these received ConsoleOut0:in
  7 48
  $ (echo 1; echo 2; echo 3) >ConsoleOut0.rtc/ports/in/value
  $ soon '[ -z "$(PATH=$tools ctl @these connectors ConsoleOut0:in)" ]'
  $ echo nonsense 2>&- >ConsoleOut0.rtc/ports/in/value || why
  RTC.TimedLong: data: not a long: nonsense
  $ echo 9999999999 2>&- >ConsoleOut0.rtc/ports/in/value || why
  RTC.TimedLong: data: out of range for a long (-2147483648 to 2147483647): 9999999999
  $ echo 1 2>&- >Idle0.rtc/ports/in/value || why
  /localhost:$PORT/test.host_cxt/Idle0.rtc:in: it is Inactive and would read the values at some later connection; rtact /localhost:$PORT/test.host_cxt/Idle0.rtc first
  $ cat ConsoleOut0.rtc/ports/in/value
  cat: read error: Operation not supported
  [1]

A type that is not known:

  $ cat Arm0.rtc/ports/status/value || why
  cat: read error: Operation not supported
  /localhost:$PORT/test.host_cxt/Arm0.rtc:status: IDL:Arm/Status:1.0 is not a standard data type; rtprint and rtinject take others (--idl)
  $ echo Active >Arm0.rtc/state; echo 1 2>&- >Arm0.rtc/ports/command/value || why
  /localhost:$PORT/test.host_cxt/Arm0.rtc:command: IDL:Arm/Status:1.0 is not a standard data type; rtprint and rtinject take others (--idl)

Events and logs:

  $ cd ../seen.host_cxt; cat ConsoleIn0.rtc/events >$TMP/events & one=$!
  $ soon 'grep -qs BEAT $TMP/events'; echo Active >ConsoleIn0.rtc/state
  $ soon "grep -q ' ACTIVE\$' $TMP/events"; kill $one
  $ grep ' ACTIVE' $TMP/events
  \[\d+\.\d+\] 0 ACTIVE (re)
  $ cat ConsoleIn0.rtc/log || why
  cat: read error: Operation not permitted
  /localhost:$PORT/seen.host_cxt/ConsoleIn0.rtc: takes no loggers

Unmounting disconnects:

  $ cd ../test.host_cxt; cat Source0.rtc/ports/number/values >/dev/null & one=$!
  $ opened $one
  $ head -n 1 Source0.rtc/ports/number/values >/dev/null
  $ PATH=$tools ctl connectors Source0:number | wc -l; cd $TMP
  1
  $ PATH=$tools rtmount -u m
  rtmount: $TMP/m: unmounted; its process serves the files that are still open, or is stopped
  $ PATH=$tools ctl connectors Source0:number | wc -l
  1
  $ kill $one
  $ soon '[ "$(PATH=$tools ctl connectors Source0:number | wc -l)" = 0 ]'

So it does right after a value has been written:

  $ PATH=$tools rtmount m
  $ echo 50 >m/localhost:$PORT/test.host_cxt/ConsoleOut0.rtc/ports/in/value
  $ PATH=$tools fusermount3 -u m
  $ soon '[ -z "$(PATH=$tools ctl @these connectors ConsoleOut0:in)" ]'
