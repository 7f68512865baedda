System exceptions of an operation, by our own ORB; omniORB cannot distinguish some of these from its own.

world: these Robot
orb: builtin

  $ export RTSHELL_IDL="$MOCKS"; rtact --wait Robot0.rtc

Whether it may have been done; nothing is tried again:

  $ for kind in COMM_FAILURE TRANSIENT NO_PERMISSION TIMEOUT; do
  >     ctl fail rest 1 $kind
  >     rtcall Robot0.rtc:svc rest 0
  > done
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: it raised COMM_FAILURE; it may have been done
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: it raised TRANSIENT; it may have been done
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: it raised NO_PERMISSION; it may have been done
  rtcall: /localhost:$PORT/test.host_cxt/Robot0.rtc:svc.arm rest: it raised TIMEOUT; it may have been done
  [6]
  $ ctl calls Robot0 | grep rest
  4 rest
