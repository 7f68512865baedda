rtdoctor looks at settings that only omniORB obeys: RTCTREE_ORB_ARGS, and what keeps it from starting.

orb: omniorb

  $ touch none.cfg; export OMNIORB_CONFIG=$TMP/none.cfg
  $ doctor() { rtdoctor "$@" | grep -v -e "this host's name" -e failed; }
  $ RTCTREE_ORB_ARGS="-ORBclientCallTimeOutPeriod;0;-ORBthrowTransientOnTimeOut;1;-ORBclientTransportRule;198.51.100.1 none" doctor -q
  fail  /localhost:$PORT: TCP connects, omniORB does not: clientTransportRule 198.51.100.1 none of RTCTREE_ORB_ARGS forbids it; try: unset RTCTREE_ORB_ARGS
  warn  here: RTCTREE_ORB_ARGS sets throwTransientOnTimeOut to 1: hung peers look like peers out of reach to these commands; try: unset RTCTREE_ORB_ARGS
  $ RTCTREE_ORB_ARGS="-ORBtraceLevel;0" doctor | grep "here.*ORB"
  ok    here: Python *, omniORBpy * (glob)
  ok    here: settings of omniORB that break nothing: RTCTREE_ORB_ARGS

It needs threads:

  $ (ulimit -v 80000; rtdoctor -q)
  fail  here: out of threads here (can't start new thread): nothing can be judged; try: raise the limit in this shell (ulimit -u, ulimit -v), or end the programs that use most threads here
  [1]

When omniORB cannot be started, that is all that can be said:

  $ RTCTREE_ORB_ARGS="-ORBnonsense 1" doctor
  fail  here: the ORB does not start: it does not understand RTCTREE_ORB_ARGS; try: correct or remove it
  ok    here: Python *, omniORBpy * (glob)
  ok    here: RTCTREE_NAMESERVERS: localhost:$PORT
  $ echo garbage > omniORB.cfg; OMNIORB_CONFIG=$TMP/omniORB.cfg doctor -q
  fail  here: the ORB does not start: it does not understand $TMP/omniORB.cfg; try: correct or remove it
