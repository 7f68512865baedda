"""Interfaces of OpenRTM's own IDL, from its tables (giop/idl.py): no file is read."""

from rtshell_lite.data.idl.interfaces import Interface, Operation, Parameter, scoped
from rtshell_lite.giop import idl
from rtshell_lite.records import cached

WHERE = "OpenRTM's own IDL"  # in place of the name of a file
DIRECTIONS = {"": "in", ">": "out", "<>": "inout"}  # of parameters, in the tables


@cached(256)
def interface(type_id):
    """The Interface of a repository id. Raises KeyError."""
    bases, operations = idl.INTERFACES[type_id]
    described = Interface(scoped(type_id), type_id, file=WHERE)
    described.bases = [interface(base) for base in bases]
    described.operations = [_operation(name, *row) for name, row in operations.items()]
    return described


def _operation(name, given, returned, raised, parameters):
    sent = list(map(idl.descriptor, given))
    received = list(map(idl.descriptor, returned or ()))
    operation = Operation(name, raises=map(idl.known, raised), oneway=returned is None)
    if len(received) > parameters.count(">"):
        operation.result = received.pop(0)
    for word in parameters.split():
        plain = word.lstrip("<>")
        direction = DIRECTIONS[word[: -len(plain)]]
        descriptor = received.pop(0) if direction != "in" else None
        if direction != "out":
            descriptor = sent.pop(0)
        operation.parameters.append(Parameter(direction, plain, descriptor))
    return operation
