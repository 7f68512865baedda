"""Operations of the interfaces of the IDL: how their arguments are written, their results read."""
import functools

from rtshell_lite.corba import idl
from rtshell_lite.corba.descriptors import BOOLEAN, STRING
from rtshell_lite.corba.iiop import marshal

_MAKERS = [marshal.Maker(">"), marshal.Maker("<")]
_COMMON = {"_non_existent": ((), (BOOLEAN,), ()), "_is_a": ((STRING,), (BOOLEAN,), ())}  # every object has these


def reader(descriptor, little):
    """read(data, at) of a type in a byte order."""
    return _MAKERS[little].reader(descriptor)


class Operation:
    """How an operation is called: writers of its arguments, readers of its results by byte order, its exceptions by their ids."""

    def __init__(self, given, returned, raised):
        self.arguments = [_MAKERS[1].writer(idl.descriptor(word)) for word in given]
        self.results = [[maker.reader(idl.descriptor(word)) for word in returned or ()] for maker in _MAKERS]
        self.raised = raised


@functools.lru_cache(maxsize=None)
def operation(interface, name):
    """The Operation of an interface or one of those that it inherits. Raises KeyError."""
    if name in _COMMON:
        return Operation(*_COMMON[name])
    _, bases, own = idl.INTERFACES[interface]
    if name in own:
        return Operation(*own[name])
    for base in bases:
        try:
            return operation(base, name)
        except KeyError:
            pass
    raise KeyError(name)
