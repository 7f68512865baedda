With RTSHELL_ORB=builtin, commands call components without omniORBpy, by an IIOP of their own, and are called by it. What they
print is the same.

orb: builtin
world: two
world: error
world: manager --context managed.host_cxt/%n.rtc

  $ rtls
  Broken0.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Err0.rtc
  ErrStart0.rtc
  $ rtls -l
  Error     1/0  0/0  1/0  0/0  Broken0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  1/0  0/0  1/0  0/0  Err0.rtc
  Inactive  0/0  0/0  0/0  0/0  ErrStart0.rtc
  $ rtls -R ../managed.host_cxt
  .:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager.mgr/

  ./manager.mgr:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager/

  ./manager.mgr/manager:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
   (esc)
  $ rtcat ConsoleIn0.rtc
  ConsoleIn0.rtc  Inactive
    Category       example
    Description    Console input component
    Instance name  ConsoleIn0
    Type name      ConsoleIn
    Vendor         Shinji Kurihara
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
   +Extra properties
  +Execution Context 0
  +DataOutPort: out
  $ rtcat -ll ConsoleIn0.rtc:out | grep -e data_type -e dataflow
    data_type                                IDL:RTC/TimedLong:1.0
    dataport.data_type                       IDL:RTC/TimedLong:1.0
    dataport.dataflow_type                   push,pull,duplex
  $ rtcat nobody.rtc
  rtcat: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  [3]
  $ rtact --wait ConsoleIn0.rtc; rtls -l ConsoleIn0.rtc
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtdeact --wait ConsoleIn0.rtc
  $ rtact Broken0.rtc; rtreset Broken0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Broken0.rtc: cannot activate: it is in Error; reset it first
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in; rtcat -l ConsoleOut0.rtc:in | grep Connected
   +Connected to  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  $ rtdis -v ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  rtdis: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: removed connection $UUID
  $ rtconf -l ConsoleIn0.rtc
  -default*
  $ rtec ConsoleIn0.rtc
  0  0  Periodic  1000  Running  Inactive  ConsoleIn0  -
  $ rtmgr --factories ../managed.host_cxt/manager.mgr | head -3
  RTC:Shinji Kurihara, AIST:example:Controller:Python:1.0
  RTC:Shinji Kurihara, AIST:example:Motor:Python:1.0
  RTC:Shinji Kurihara, AIST:example:Sensor:Python:1.0
  $ rtmgr -c ConsoleIn ../managed.host_cxt/manager.mgr
  $ rtls ../managed.host_cxt/manager.mgr
  ConsoleIn0.rtc
  ConsoleIn1.rtc
  ConsoleOut0.rtc
  manager/
  $ rtmgr -d ConsoleIn1 ../managed.host_cxt/manager.mgr
  $ rtfind . -t c
  /localhost:$PORT/test.host_cxt/Broken0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  /localhost:$PORT/test.host_cxt/Err0.rtc
  /localhost:$PORT/test.host_cxt/ErrStart0.rtc
  $ rtcryo -o system.xml --all .; rtcheck -s inactive system.xml
  $ rtteardown system.xml; rtresurrect system.xml
  $ rtinject -c 3 ConsoleOut0.rtc:in
  rtinject: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: it is Inactive and would read the values at some later connection; rtact /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc first, or --anyway
  [1]
  $ rtact --wait ConsoleOut0.rtc; rtinject -c 3 ConsoleOut0.rtc:in
  $ ctl @two received ConsoleOut0:in 1
  1 3
  $ rtprint -q -n 1 ConsoleIn0.rtc:out & soon 'ctl @two connectors ConsoleIn0:out | grep -q .'
  $ ctl @two write ConsoleIn0:out 42; wait
  [0.000000000] 42
  $ rtvlog ConsoleIn0.rtc
  rtvlog: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: takes no loggers
  [6]
  $ printf '%s\n' 'rtls' 'rtcat ConsoleIn0.rtc:out' | rtsh
  Broken0.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Err0.rtc
  ErrStart0.rtc
  +DataOutPort: out
  $ rtls '/a..b'
  rtls: /a..b: host name not known
  [4]
  $ rtdoctor -v | grep -m 1 Python
  ok    here: Python *, builtin ORB (glob)
  $ rtls -v --version; rtls --version
  1.* (glob)
  Python 3.*, builtin ORB (glob)
  1.* (glob)
  $ kill-mock two; rtls
  Broken0.rtc
  *ConsoleIn0.rtc
  *ConsoleOut0.rtc
  Err0.rtc
  ErrStart0.rtc
  $ rtls -l
  Inactive  1/0  0/0  1/0  0/0  Broken0.rtc
  -         -    -    -    -    *ConsoleIn0.rtc
  -         -    -    -    -    *ConsoleOut0.rtc
  Inactive  1/0  0/0  1/0  0/0  Err0.rtc
  Inactive  0/0  0/0  0/0  0/0  ErrStart0.rtc
  $ rtls /localhost:1 /no.such.host
  rtls: /localhost:1: connection refused; is the name server running?
  rtls: /no.such.host: host name not known
  [4]

Our own ORB is the default. Where omniORBpy is asked for or needed, but cannot be imported, the error says so:

  $ mkdir bare; echo 'raise ImportError("none here")' > bare/omniORB.py
  $ export PYTHONPATH=$TMP/bare${PYTHONPATH:+:$PYTHONPATH}
  $ unset RTSHELL_ORB; rtls -l ConsoleIn0.rtc
  -  -  -  -  -  *ConsoleIn0.rtc
  $ rtls --version --verbose | tail -1
  Python 3.*, builtin ORB (glob)
  $ RTSHELL_ORB=omniorb rtls
  rtls: omniORBpy is not installed, but RTSHELL_ORB asks for it; unset that, or install it from the package index (jeteve-omniorb; salome-omniorb for Python 3.7) or from OpenRTM-aist's package repository
  [1]
  $ RTSHELL_ORB=omniorb rtdoctor -q | grep ORB
  fail  here: Python * has no omniORBpy, which RTSHELL_ORB asks for; try: unset RTSHELL_ORB (glob)
  $ RTCTREE_ORB_ARGS='-ORBtraceLevel;5' rtls
  rtls: RTCTREE_ORB_ARGS: -ORBtraceLevel: only omniORB knows that, and omniORBpy is not installed (package jeteve-omniorb; salome-omniorb for Python 3.7)
  [1]
  $ rtdoctor -q '/robot１' | grep robot
  fail  /robot１: host name robot１ not known here (*); try: correct the name, or write its address into /etc/hosts (glob)
  $ rtls /ssliop:127.0.0.1:1; rtls /http://127.0.0.1:1
  rtls: /ssliop:127.0.0.1:1: these commands speak IIOP with TCP only
  rtls: /http://127.0.0.1:1#: these commands speak IIOP with TCP only
  [2]
  $ RTSHELL_ORB=tao rtls
  rtls: RTSHELL_ORB: tao: neither omniorb nor builtin (see --help)
  [2]
