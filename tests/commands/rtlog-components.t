rtlog plays a recording as components, which others list, ask, and connect with. (One that exits:
tests/sim/stories/rtlog-components.t.)

world: these ConsoleIn ConsoleOut Motor
server: other
orb: builtin

  $ rtcon -q -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in; rtact ConsoleOut0.rtc
  $ rtlog --events -f a.mcap . 2> nul & pid=$!
  $ soon 'rtlog -d -f a.mcap | grep components-1.json'
  $ soon 'ctl observers ConsoleOut0 | grep Observer'
  $ for i in 1 2 3 4 5 6 7 8 9; do ctl write ConsoleIn0:out $i; done
  $ rtdeact ConsoleOut0.rtc
  $ soon 'rtlog --json -f a.mcap | grep INACTIVE'
  $ ctl write ConsoleIn0:out 10
  $ soon 'rtlog --json -f a.mcap | grep "data.: 10"'
  $ kill $pid; wait $pid
  [143]

In another name server. What is recorded comes to who is connected, all of it, in its order; then nothing is left:

  $ N=/localhost:$PORT2/test.host_cxt
  $ play() {
  >     rm -f told
  >     rtlog -p -f a.mcap --as-components "$@" 2> told & pid=$!
  >     soon 'grep bound told'
  > }
  $ play --nameserver localhost:$PORT2 --when-connected; rtls -l $N
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Active    1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
  $ same() {
  >     sed "s/localhost:$PORT2/localhost:$PORT/g; s/RTSystem:[^\"]*//; s/ionDate=\"[^\"]*\"//g; s/ateDate=\"[^\"]*\"//g; /REFERENCE/d"
  > }
  $ rtcryo -q --all localhost:$PORT2 | sed "s/RT System created by rtcryo.//" | same > a
  $ rtlog --attachment system-1.rtsys -f a.mcap | same > b; diff a b && echo same
  same
  $ rtprint $N/ConsoleIn0.rtc:out 2> nul & printing=$!
  > rtprint -q $N/Motor0.rtc:out 2> nul
  > wait $printing
  > wait $pid
  > cat told
  > rtls -R /localhost:$PORT2
  [0.000000000] 1
  [0.000000000] 2
  [0.000000000] 3
  [0.000000000] 4
  [0.000000000] 5
  [0.000000000] 6
  [0.000000000] 7
  [0.000000000] 8
  [0.000000000] 9
  [0.000000000] 10
  rtlog: 3 components are bound in /localhost:$PORT2
  .:
   (esc)

Beside the living, below another name. Components connect with the recording, both ways; it refuses to change:

  $ rtlog -p -f a.mcap --as-components
  rtlog: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: is bound already, to what may live; --as-components PREFIX binds below another name
  [6]
  $ R=replay.host_cxt/test.host_cxt; export RTCSH_CWD=/localhost:$PORT
  $ play -r 50 --loop replay.host_cxt
  $ connect() {
  >     rtcon -q -i two $R/ConsoleIn0.rtc:out test.host_cxt/ConsoleOut0.rtc:in
  >     rtcon -q -i three test.host_cxt/ConsoleIn0.rtc:out $R/ConsoleOut0.rtc:in
  > }
  $ for i in 1 2 3; do
  >     connect
  >     rtdis -i two test.host_cxt/ConsoleOut0.rtc
  >     rtdis -i three $R/ConsoleOut0.rtc
  > done
  $ connect; rtact test.host_cxt/ConsoleOut0.rtc
  $ ctl received ConsoleOut0:in 60 > nul
  $ RTSHELL_ORB=omniorb $MOCK_PYTHON -m rtshell_lite rtls -l $R | grep -v ConsoleOut0
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
  $ rtact --timeout 2 $R/ConsoleIn0.rtc
  rtact: /localhost:$PORT/replay.host_cxt/test.host_cxt/ConsoleIn0.rtc: not Active within 2s, still Inactive
  [4]
  $ rtconf $R/Motor0.rtc set motor_id 3; rtexit $R/Motor0.rtc
  rtconf: /localhost:$PORT/replay.host_cxt/test.host_cxt/Motor0.rtc: does not take values for configuration set default
  rtexit: /localhost:$PORT/replay.host_cxt/test.host_cxt/Motor0.rtc: does not exit (RTC_ERROR)
  [6]
  $ kill $pid; wait $pid
  [143]
  $ cat told
  rtlog: 3 components are bound in /localhost:$PORT
  $ rtls -R
  .:
  test.host_cxt/

  ./test.host_cxt:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Motor0.rtc
   (esc)
  $ rtls -l test.host_cxt
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Active    1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
