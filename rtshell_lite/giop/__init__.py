"""The protocol of CORBA, octets to values and back, without sockets and clocks.

messages     GIOP 1.0 to 1.2: requests, replies, fragments; requests as a server reads and answers them
references   IORs and what they say; ior has their octets
descriptors  types as tuples, and functions that read their parts by name; idl has those of OpenRTM, from
             generated tables
cdr          values as octets, with fixed_size for types of one size and rare for those hardly ever used
marshal      the same for what calls carry: references, anys, exceptions; typecodes are types on the wire
operations   the arguments, results and exceptions of an operation
allowance    how much one answer may hold
"""
