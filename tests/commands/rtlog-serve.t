rtlog --as-components --serve needs no other name server.

world: these ConsoleIn Motor
orb: builtin

  $ play() {
  >     rm -f told
  >     rtlog -p -f a.mcap --as-components "$@" 2> told & pid=$!
  >     soon 'grep bound told'
  >     W=$(sed 's/.*bound in //' told)
  > }
  $ rtlog --events -f a.mcap . 2> nul & pid=$!
  $ soon 'rtlog -d -f a.mcap | grep components-1.json'
  $ for i in 1 2 3 4 5 6 7 8 9 10; do ctl write ConsoleIn0:out $i; done
  $ soon 'rtlog --json -f a.mcap | grep "data.: 10"'
  $ kill $pid; wait $pid
  [143]

Everything can be asked:

  $ play -r 50 --serve 127.0.0.1:0 --loop; rtls -l $W/test.host_cxt
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
  $ rtcat -l $W/test.host_cxt/Motor0.rtc | sed 's/ *$//'
  Motor0.rtc  Inactive
    Category       example
    Description    Motor component
    Instance name  Motor0
    Type name      Motor
    Vendor         Shinji Kurihara, AIST
    Version        1.0
    Parent
    Type           Monolithic
   +Extra properties
  -Execution Context 0
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  Motor0
   +Extra properties
  -DataInPort: in
    data_type                               IDL:RTC/TimedFloat:1.0
    dataport.data_type                      IDL:RTC/TimedFloat:1.0
    dataport.dataflow_type                  push,pull
    dataport.interface_option.corba_cdr
    dataport.interface_option.data_service
    dataport.interface_type                 corba_cdr,data_service
    dataport.marshaling_types               cdr
    dataport.subscription_type              Any
    port.port_type                          DataInPort
  -DataOutPort: out
    data_type                               IDL:RTC/TimedLong:1.0
    dataport.data_type                      IDL:RTC/TimedLong:1.0
    dataport.dataflow_type                  push,pull
    dataport.interface_option.corba_cdr
    dataport.interface_option.data_service
    dataport.interface_type                 corba_cdr,data_service
    dataport.io_mode                        block,flush,new,nonblock,periodic
    dataport.marshaling_types               cdr
    dataport.subscription_type              block,flush,new,nonblock,periodic
    port.port_type                          DataOutPort
  $ rtprint -n 30 $W/test.host_cxt/ConsoleIn0.rtc:out | sort -u | wc -l
  10
  $ kill -HUP $pid; wait $pid
  [129]

Only this host can ask, unless an address is given:

  $ play --serve 0 --loop
  > echo $W
  > listens ${W##*:}
  > kill $pid; wait $pid
  /127.0.0.1:* (glob)
  0100007F
  [143]
  $ play --serve 0.0.0.0:0 --loop
  > listens ${W##*:}
  > rtls 127.0.0.1:${W##*:}/test.host_cxt
  > kill $pid; wait $pid
  00000000
  ConsoleIn0.rtc
  Motor0.rtc
  [143]

What cannot be:

  $ rtlog -f a.mcap --as-components
  rtlog: --as-components is for rtlog serve, not for rtlog record (see --help)
  [2]
  $ rtlog -p -f a.mcap --serve 1
  rtlog: --serve is for rtlog serve, not for rtlog play (see --help)
  [2]
  $ rtlog -p -f a.mcap --as-components --serve x
  rtlog: argument --serve: not [HOST:]PORT: x (see --help)
  [2]
  $ rtlog -p -f a.mcap --as-components --serve 127.0.0.1:$PORT
  rtlog: 127.0.0.1:$PORT: cannot listen there; does another program?
  [1]
  $ rtlog -p -f a.mcap --as-components --nameserver localhost:$PORT --serve 1
  rtlog: --nameserver and --serve exclude each other (see --help)
  [2]
  $ RTSHELL_ORB=omniorb $MOCK_PYTHON -m rtshell_lite rtlog -p -f a.mcap --as-components
  rtlog: only the builtin ORB serves components; unset RTSHELL_ORB, and RTCTREE_ORB_ARGS (see --help)
  [2]

A log without a profile of the system has the ports that were recorded. One that is empty ends at once:

  $ rtlog -q -t 0.1 -f b.mcap Motor0.rtc:out; rtlog -p -f b.mcap --as-components --serve 127.0.0.1:0
  rtlog: 1 component is bound in /127.0.0.1:* (glob)
