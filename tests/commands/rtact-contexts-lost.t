A component in execution contexts of others that have ended, that do not answer, or in which it stops late.

world: these Mock:Sensor0
world: these Mock:Motor0 Mock:Camera0
world: these Mock:Driver0
world: these Mock:Lame0 --async

  $ states() { rtec --timeout 1 $1.rtc | awk '{print $1, $5, $6, $7}'; }
  $ rtec Sensor0.rtc attach Motor0.rtc Camera0.rtc; rtec Driver0.rtc attach Lame0.rtc

All contexts are asked before one is waited for: where a component stops late, it stops elsewhere at once:

  $ rtact --wait -e 0 Lame0.rtc; rtact --wait -e 1 Lame0.rtc; rtec Lame0.rtc rate 0.001; states Lame0
  0 Running Active Lame0
  1 Running Active Driver0
  $ rtdeact --wait 60 Lame0.rtc & rtdeact=$!
  $ within 0-10 sh -c 'until [ $(ctl @these4 state Lame0 1000) = INACTIVE ]; do sleep 0.1; done'
  $ ctl @these4 state Lame0
  ACTIVE
  $ kill -KILL $rtdeact; wait $rtdeact 2>/dev/null
  [137]

Where a component may be Active in a context that does not answer, only its own one that runs is used, and -v reports that:

  $ hang these
  $ rtact --dry-run --timeout 0.5 Motor0.rtc
  rtact /localhost:$PORT/test.host_cxt/Motor0.rtc
  $ rtact -v --timeout 0.5 Motor0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Motor0.rtc: accepted; its execution context 1, of another component, does not answer: it may be Active there
  $ rtec Camera0.rtc stop
  $ rtact --timeout 0.5 Camera0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Camera0.rtc: its execution context 1, of another component, does not answer: it may be Active there
  [4]
  $ rtact --dry-run --timeout 0.5 Camera0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Camera0.rtc: its execution context 1, of another component, does not answer: it may be Active there
  [4]
  $ rtdeact --dry-run --timeout 0.5 Camera0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Camera0.rtc: its execution context 1, of another component, does not answer: it may be Active there
  [4]
  $ ctl @these2 state Camera0
  INACTIVE
  $ rtec Camera0.rtc start
  $ rtdeact --timeout 0.5 Motor0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Motor0.rtc: its execution context 1, of another component, does not answer: it may be Active there
  [4]
  $ ctl @these2 state Motor0
  INACTIVE
  $ rtact Motor0.rtc
  $ rtcryo --all -o lost.rtsys /localhost:$PORT/test.host_cxt/Motor0.rtc; rtstop -q --timeout 0.5 lost.rtsys
  rtstop: /localhost:$PORT/test.host_cxt/Motor0.rtc: its execution context 1, of another component, does not answer: it may be Active there; whether it has been done is not known
  [4]
  $ ctl @these2 state Motor0
  INACTIVE
  $ rtact Motor0.rtc

Where the process of that context is gone, the component is known not to be executed there:

  $ kill-mock these
  $ rtdeact -v --wait Motor0.rtc
  rtdeact: /localhost:$PORT/test.host_cxt/Motor0.rtc: Inactive
  $ rtact -v --wait Motor0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Motor0.rtc: Active
  $ rtstop -q lost.rtsys; states Motor0
  0 Running Inactive Motor0
  1 ? Unknown ?
