Operations of service ports, which are called by writing to their files. They are not listed: looking around calls nothing.

needs: fuse
world: these Robot

  $ mkdir m bin
  $ busybox --install -s bin
  $ RTSHELL_IDL=$MOCKS rtmount m
  $ tools=$PATH PATH=$PWD/bin errors=$PWD/m/errors; why() { tail -n 1 $errors; }
  $ cd m/localhost:$PORT/test.host_cxt/Robot0.rtc; echo Active >state
  $ PATH=$tools ctl reset
  $ ls ports/svc/interfaces ports/svc/interfaces/arm; cat ports/svc/interfaces/*/type
  ports/svc/interfaces:
  arm
  tally

  ports/svc/interfaces/arm:
  type
  Provided Mock::Robot
  Provided Mock::Counter
  $ ls -lR . >$TMP/listed
  $ grep -r Robot . >$TMP/found
  $ grep -c . $TMP/found
  9
  $ find . -type f | xargs cat >$TMP/all
  $ PATH=$tools ctl calls Robot0 | grep -v 'get_\|_non_existent\|is_'
  [1]

A line of JSON calls; the same open file has what it returns:

  $ cd ports/svc/interfaces/arm
  $ exec 3<>say
  $ echo '"hello"' >&3
  $ read -r said <&3
  $ echo "$said"
  hello
  $ echo '"again"' >&3
  $ read -r said <&3
  $ echo "$said"
  again
  $ exec 3>&-
  $ exec 3<>move_to
  $ echo '{"goal": {"x": 3, "y": 4}, "seconds": 0}' >&3
  $ cat <&3
  {"distance": 5.0, "result": {"x": 3.0, "y": 4.0}}
  $ echo '[{"x": 0, "y": 4}, 0]' >&3
  $ cat <&3
  {"distance": 4.0, "result": {"x": 0.0, "y": 4.0}}
  $ exec 3>&-
  $ echo 2.5 >_set_speed
  $ exec 3<>_get_speed
  $ echo >&3
  $ cat <&3
  2.5
  $ exec 3>&-
  $ echo '{"words": "by name"}' >say
  $ echo '"alone"' >say
  $ exec 3<>ending
  $ echo >&3
  $ cat <&3
  hello; again; by name; alone
  $ exec 3>&-
  $ cat say ending

What fails is the write's failure:

  $ echo 3 2>/dev/null >move_to; why
  move_to: not a JSON object of its arguments, {…}
  $ echo '{"goal": {"x": 30, "y": 4}, "seconds": 0}' 2>/dev/null >move_to; why
  /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm move_to: OutOfReach(nearest=(x=10.0, y=4.0), by=20.0)
  $ test -e sey
  [1]
  $ echo Inactive >../../../../state
  $ echo '"late"' 2>/dev/null >say
  [1]
  $ why
  /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm say: the component is Inactive, and serves only while it is Active: rtact /localhost:$PORT/test.host_cxt/Robot0.rtc first
  $ PATH=$tools rtcat -ll ../../../../../Robot0.rtc:svc 2>&1 | grep -i connect
  [1]
