"""The seam to the ORB: the packages above pass and get plain values, and see an errors.Error for each
failure.

session    how one command asks, and what it has learnt: a silent process costs one timeout; many calls at
           once
orb        the door: references (their address, identity, endpoint), calls with a deadline, exceptions as
           errors, properties
iiop/      our own ORB behind it, in Python: client, which orb.py sees; peers, calls, connections; server
omniorb    the annex: omniORB behind it, by threads; answers looks at what peers send before omniORB makes
           objects of it, stubs makes its classes
hosts      where hosts are, by their names
failures   what the exceptions of peers mean, for both
liveness   what a refused connection proves
servants   objects of ours that components call

An ORB behind this seam has to offer: references from and to text (IOR, corbaloc), narrowing without a call,
equivalence; calls by the name of an operation with a deadline to the millisecond, for each reference;
TIMEOUT, OBJECT_NOT_EXIST, TRANSIENT, COMM_FAILURE, MARSHAL and user exceptions told apart; answers read by
our descriptors instead of its own; few connections to a process; servants by a class of the IDL, and the port
that they listen on; TypeCodes of an `any` as descriptors. Structs and enums come as objects with the
attributes of the IDL; enums have a name `_n` and a number `_v`.
"""
