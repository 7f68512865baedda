"""Our own ORB, for where there is no omniORBpy."""
