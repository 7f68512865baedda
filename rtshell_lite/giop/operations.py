"""Operations of the interfaces of the IDL: how their arguments and results are written and read."""

import functools

from rtshell_lite.giop import descriptors, idl
from rtshell_lite.giop.descriptors import BOOLEAN, OCTET, SEQUENCE, STRING, plain
from rtshell_lite.giop import marshal

_MAKERS = [marshal.Maker(">"), marshal.Maker("<")]
# every object has these
_COMMON = {"_non_existent": ((), (BOOLEAN,), ()), "_is_a": ((STRING,), (BOOLEAN,), ())}


def reader(descriptor, little):
    """read(data, at) of a type in a byte order."""
    return _MAKERS[little].reader(descriptor)


def writer(descriptor):
    """write(out, value) of a type, in little endian."""
    return _MAKERS[1].writer(descriptor)


class Operation:
    """How an operation is called: writers of its arguments, readers of its results by byte order, its
    exceptions by their ids.

    carries_data: among its results are octets, of any number; all others are made of small parts, which take
    long to read.
    """

    def __init__(self, given, returned, raised):
        self.arguments = [_MAKERS[1].writer(idl.descriptor(word)) for word in given]
        self.results = [[maker.reader(idl.descriptor(word)) for word in returned or ()] for maker in _MAKERS]
        self.raised = raised
        self.carries_data = any(
            plain(idl.descriptor(word))[:2] == (SEQUENCE, OCTET)
            for word in returned or ()
            if isinstance(plain(idl.descriptor(word)), tuple)
        )


@functools.lru_cache(maxsize=None)
def operation(interface, name):
    """The Operation of an interface or one of those that it inherits. Raises KeyError."""
    return Operation(*_COMMON.get(name) or idl.operation(interface, name))


@functools.lru_cache(maxsize=None)
def served(interface, name):
    """(readers of the arguments by byte order, writers of the results, whether all arguments are octets) of
    an operation of ours.

    Octets may be read from a memoryview, which copies them once. Raises KeyError.
    """
    given, returned, _ = _COMMON.get(name) or idl.operation(interface, name)
    given = [idl.descriptor(word) for word in given]
    return (
        [[maker.reader(each) for each in given] for maker in _MAKERS],
        [_MAKERS[1].writer(idl.descriptor(word)) for word in returned or ()],
        all(descriptors.plain(each) == (descriptors.SEQUENCE, descriptors.OCTET, 0) for each in given),
    )
