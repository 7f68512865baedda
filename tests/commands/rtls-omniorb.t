Settings of omniORB that are not understood are a usage error; those that RTCTREE_ORB_ARGS may change, it changes.

orb: omniorb
world: two

  $ RTCTREE_ORB_ARGS='-ORBnonsense;1' rtls
  rtls: RTCTREE_ORB_ARGS: -ORBnonsense;1: not understood by omniORB (INITIALIZE_InvalidORBInitArgs) (see --help)
  [2]
  $ RTCTREE_ORB_ARGS='-ORBmaxGIOPConnectionPerServer;2' rtls ConsoleIn0.rtc
  ConsoleIn0.rtc
  $ rtls --version -v
  0.* (glob)
  Python 3.*, omniORBpy * (glob)
