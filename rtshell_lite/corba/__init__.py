"""The seam to the ORB: the packages above pass and get plain values, and see an errors.Error for each
failure.

session    how one command asks, and what it has learnt: a silent process costs one timeout; many calls at
           once
orb        the door: references (their address, identity, endpoint), calls with a deadline, exceptions as
           errors, properties
iiop/      our own ORB behind it, in Python: client, which orb.py sees; peers, calls, connections; server
omniorb    the annex: omniORB behind it, by threads; answers looks at what peers send before omniORB makes
           objects of it, stubs makes its classes
failures   what the exceptions of peers mean, for both
refusals   what a refused connection proves
servants   objects of ours that components call
"""
