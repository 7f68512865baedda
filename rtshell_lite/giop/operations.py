"""Operations of interfaces: how their arguments and results are written and read."""

from rtshell_lite.giop import idl
from rtshell_lite.giop.descriptors import BOOLEAN, OCTET, SEQUENCE, STRING, plain
from rtshell_lite.giop import marshal
from rtshell_lite.records import cached

_MAKERS = [marshal.Maker(">"), marshal.Maker("<")]
_OF_SCHEMAS = [marshal.ValueMaker(">"), marshal.ValueMaker("<")]
# every object has these
_COMMON = {"_non_existent": ((), (BOOLEAN,), ()), "_is_a": ((STRING,), (BOOLEAN,), ())}


def reader(descriptor, little):
    """read(data, at) of a type in a byte order."""
    return _MAKERS[little].reader(descriptor)


def writer(descriptor):
    """write(out, value) of a type, in little endian."""
    return _MAKERS[1].writer(descriptor)


class Operation:
    """How an operation is called: writers of its arguments, read(data, at) of its results, and the ids of
    its exceptions.

    carries_data: among its results are octets, of any number; all others are made of small parts, which take
    long to read. takes_values: it is one of a user's IDL, whose results may be large.
    """

    def __init__(self, given, returned, raised, makers=_MAKERS):
        self.arguments = [makers[1].writer(idl.descriptor(word)) for word in given]
        returned_types = [idl.descriptor(word) for word in returned or ()]
        self.results = [maker.results_reader(returned_types) for maker in makers]
        self.raised = raised
        self._returned = returned
        self._of_parts = {}  # type: dict
        self._makers = makers
        self.takes_values = makers is _OF_SCHEMAS
        structures = [plain(sort) for sort in returned_types if isinstance(plain(sort), tuple)]
        self.carries_data = any(structure[:2] == (SEQUENCE, OCTET) for structure in structures)

    def of_part(self, part):
        """read(data, at) of a part of its one result, a structure, by byte order; `part` as in orb.call."""
        if part not in self._of_parts:
            (word,) = self._returned
            structure = idl.descriptor(word)
            self._of_parts[part] = [maker.read_part(structure, part) for maker in self._makers]
        return self._of_parts[part]

    def exception_reader(self, type_id, little):
        """read(data, at) of one of its exceptions, without the id that comes before it."""
        return self._makers[little].reader(idl.descriptor(self.raised[type_id]))


class Schema:
    """An operation that IDL of a user describes, for orb.call in place of a name.

    name      as requests have it; of an attribute `speed`: _get_speed, _set_speed
    given     descriptors of what is sent: in and inout parameters in their order
    returned  descriptors of what comes back: the result unless it is void, then out and inout parameters in
              their order; None for oneway
    raised    {repository id: descriptor} of its exceptions

    Texts are sent and come as UTF-8, a reference is a references.Reference, an `any` a marshal.Any,
    with both ORBs. A request by a Schema is sent at most once, and oneway waits for no answer.
    """

    __slots__ = ("name", "given", "returned", "raised", "_operation")

    def __init__(self, name, given, returned, raised):
        self.name = name
        self.given = tuple(given)
        self.returned = returned
        self.raised = raised
        self._operation = None

    def __str__(self):
        return self.name

    @property
    def is_oneway(self):
        return self.returned is None

    @property
    def operation(self):
        """Its Operation, for our own ORB."""
        if self._operation is None:
            self._operation = Operation(self.given, self.returned, self.raised, _OF_SCHEMAS)
        return self._operation


@cached(1024)
def operation(interface, name):
    """The Operation of an interface or one of those that it inherits. Raises KeyError."""
    given, returned, raised = _COMMON.get(name) or idl.operation(interface, name)
    return Operation(given, returned, {type_id: type_id for type_id in raised})


@cached(1024)
def served(interface, name):
    """(readers of the arguments by byte order, writers of the results, whether all arguments are octets) of
    an operation of ours.

    Octets may be read from a memoryview, which copies them once. Raises KeyError.
    """
    given, returned, _ = _COMMON.get(name) or idl.operation(interface, name)
    given = [idl.descriptor(word) for word in given]
    readers = [[maker.reader(descriptor) for descriptor in given] for maker in _MAKERS]
    writers = [_MAKERS[1].writer(idl.descriptor(word)) for word in returned or ()]
    return readers, writers, all(plain(descriptor) == (SEQUENCE, OCTET, 0) for descriptor in given)
