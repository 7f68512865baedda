"""The seam to the ORB: the packages above pass and get plain values, and see an errors.Error for each failure.

lanes      deadlines, and many calls at once, without an ORB: a silent process costs one timeout
orb        references (their address, identity, endpoint), calls with a deadline, exceptions as errors, lists of properties
answers    what peers send, checked as octets before an ORB makes objects of it; ior reads references
stubs      classes of OpenRTM's IDL by name: interfaces to narrow to, structs to send
servants   objects of ours that components call
descriptors   types as tuples, and functions that read their parts by name

An ORB behind this seam has to offer: references from and to text (IOR, corbaloc), narrowing without a call, equivalence;
calls by the name of an operation with a deadline to the millisecond, for each reference; TIMEOUT, OBJECT_NOT_EXIST, TRANSIENT,
COMM_FAILURE, MARSHAL and user exceptions told apart; answers read by our descriptors instead of the stubs'; at most
CONNECTIONS connections to a process; servants by a class of the IDL, and the port that they listen on; TypeCodes of an `any`
as descriptors. Structs and enums come as objects with the attributes of the IDL; enums have a name `_n` and a number `_v`.
"""
