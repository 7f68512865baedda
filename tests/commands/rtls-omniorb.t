Settings of omniORB that are not understood are a usage error; those that RTCTREE_ORB_ARGS may change, it changes.

orb: omniorb
world: two

  $ RTCTREE_ORB_ARGS='-ORBnonsense;1' rtls
  rtls: RTCTREE_ORB_ARGS: -ORBnonsense;1: not understood by omniORB (INITIALIZE_InvalidORBInitArgs) (see --help)
  [2]
  $ RTCTREE_ORB_ARGS='-ORBmaxGIOPConnectionPerServer;2' rtls ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls --version -v
  1.* (glob)
  Python 3.*, omniORBpy * (glob)

It is used by itself where only it knows what is asked: a setting, another transport.

  $ unset RTSHELL_ORB; rtls --version -v | tail -1
  Python 3.*, builtin ORB (glob)
  $ RTCTREE_ORB_ARGS='-ORBmaxGIOPConnectionPerServer;2' rtls --version -v | tail -1
  Python 3.*, omniORBpy * (glob)
  $ RTCTREE_ORB_ARGS='-ORBendPoint;giop:tcp:127.0.0.1:' rtls --version -v | tail -1
  Python 3.*, builtin ORB (glob)
  $ rtls /ssliop:127.0.0.1:1
  rtls: /ssliop:127.0.0.1:1: these commands speak IIOP with TCP only
  [2]
