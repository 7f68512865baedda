"""Interfaces of IDL: their operations and attributes, as IDL spells them and as an ORB calls them.

Types are descriptors (giop/descriptors.py), those of exceptions, too.
"""

from rtshell_lite import errors
from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import ARRAY, FIXED, SEQUENCE, VALUE, kind
from rtshell_lite.records import record


class Interface:
    """An interface of an IDL file.

    name           as IDL spells it: SimpleService::MyService
    repository_id  IDL:SimpleService/MyService:1.0
    kind           "", or "abstract" or "local", of which no object can be called
    file           where it is declared
    bases          the Interfaces that it inherits
    operations     its own Operations, in the order of the file
    attributes     its own Attributes, in the same order
    """

    def __init__(self, name, repository_id, kind="", file=""):
        self.name = name
        self.repository_id = repository_id
        self.kind = kind
        self.file = file
        self.bases = []
        self.operations = []
        self.attributes = []

    def ancestry(self):
        """This Interface and all that it inherits, each once, the nearest first."""
        interfaces = []
        seen = set()
        todo = [self]
        while todo:
            interface = todo.pop(0)
            if id(interface) not in seen:
                seen.add(id(interface))
                interfaces.append(interface)
                todo += interface.bases
        return interfaces

    def all_attributes(self):
        """Its Attributes, and the inherited ones."""
        return [attribute for interface in self.ancestry() for attribute in interface.attributes]

    def all_operations(self):
        """{name: Operation} of all that can be called: its own operations and the inherited ones,
        then `_get_x` and `_set_x` of each attribute x.
        """
        operations_by_name = {}
        for interface in self.ancestry():
            for operation in interface.operations:
                operations_by_name.setdefault(operation.name, operation)
        for attribute in self.all_attributes():
            for operation in attribute.operations():
                operations_by_name.setdefault(operation.name, operation)
        return operations_by_name


# A parameter of an operation: `direction` is in, out or inout.
Parameter = record("Parameter", "direction name type")


class Operation:
    """An operation: `result` is its type or None for void, `raises` are types of exceptions, `contexts` the
    names of its context clause. `fault` is what is wrong with its declaration, '' for one that could be read.
    """

    def __init__(self, name, result=None, parameters=(), raises=(), oneway=False):
        self.name = name
        self.result = result
        self.parameters = list(parameters)
        self.raises = list(raises)
        self.oneway = oneway
        self.contexts = []
        self.fault = ""

    @property
    def shown(self):
        """Its name for people: of an attribute's, the attribute's."""
        if self.name.startswith(("_get_", "_set_")):
            return self.name[len("_get_") :]
        return self.name

    def inputs(self):
        """The Parameters that a caller sends: in and inout."""
        return [parameter for parameter in self.parameters if parameter.direction != "out"]

    def outputs(self):
        """The Parameters that come back after the result: out and inout."""
        return [parameter for parameter in self.parameters if parameter.direction != "in"]

    def idl(self):
        """It as one line of IDL, with its semicolon."""
        words = spelled(self.result) if self.result is not None else "void"
        if self.oneway:
            words = f"oneway {words}"
        listed = [
            f"{parameter.direction} {spelled(parameter.type)} {parameter.name}"
            for parameter in self.parameters
        ]
        line = f"{words} {self.name}({', '.join(listed)})" + _raising("raises", self.raises)
        if self.contexts:
            line += " context (%s)" % ", ".join(f'"{name}"' for name in self.contexts)
        return line + ";"

    def why_not_callable(self):
        """Why it cannot be called, or ''."""
        if self.fault:
            return f"its declaration cannot be read: {self.fault}"
        if self.contexts:
            return "it has a context clause"
        parts = [("its result", self.result)]
        parts += [(parameter.name, parameter.type) for parameter in self.parameters]
        parts += [(descriptors.words(descriptor), descriptor) for descriptor in self.raises]
        for where, descriptor in parts:
            for part, inner in descriptors.walk(descriptor, where):
                if kind(inner) == VALUE:
                    return f"{part} is {spelled(inner)}, which cannot be sent"
        return ""

    def schema(self):
        """It as an ORB calls it, a giop.operations.Schema. Raises BadType for what cannot be called."""
        from rtshell_lite.giop import operations

        why = self.why_not_callable()
        if why:
            raise errors.BadType(self.name, why)
        sent = [parameter.type for parameter in self.inputs()]
        returned = [parameter.type for parameter in self.outputs()]
        if self.result is not None:
            returned.insert(0, self.result)
        if self.oneway:
            returned = None
        raised = {descriptors.type_id(descriptor): descriptor for descriptor in self.raises}
        return operations.Schema(self.name, sent, returned, raised)


class Attribute:
    """An attribute; `raises` and `set_raises` are the types of exceptions that reading and writing
    it raise.
    """

    def __init__(self, name, type, readonly=False, raises=(), set_raises=()):
        self.name = name
        self.type = type
        self.readonly = readonly
        self.raises = list(raises)
        self.set_raises = list(set_raises)
        self.fault = ""

    def operations(self):
        """The Operations that read and write it: _get_NAME, and _set_NAME unless it is readonly."""
        operations = [Operation("_get_" + self.name, self.type, (), self.raises)]
        if not self.readonly:
            value = Parameter("in", self.name, self.type)
            operations.append(Operation("_set_" + self.name, None, [value], self.set_raises))
        for operation in operations:
            operation.fault = self.fault
        return operations

    def idl(self):
        """It as one line of IDL, with its semicolon."""
        line = f"attribute {spelled(self.type)} {self.name}"
        if self.readonly:
            return f"readonly {line}{_raising('raises', self.raises)};"
        return f"{line}{_raising('getraises', self.raises)}{_raising('setraises', self.set_raises)};"


def _raising(word, exceptions):
    return f" {word} ({', '.join(map(spelled, exceptions))})" if exceptions else ""


def spelled(descriptor):
    """A type as IDL spells it outside its module: RTC::TimedLong, sequence<RTC::Time, 3>."""
    type_id = descriptors.type_id(descriptor)
    if type_id:
        return scoped(type_id)
    sort = kind(descriptor)
    if sort == SEQUENCE and descriptors.length(descriptor):
        return "sequence<%s, %d>" % (spelled(descriptors.element(descriptor)), descriptors.length(descriptor))
    if sort == SEQUENCE:
        return f"sequence<{spelled(descriptors.element(descriptor))}>"
    if sort == ARRAY:
        lengths = ""
        while kind(descriptor) == ARRAY:
            lengths += "[%d]" % descriptors.length(descriptor)
            descriptor = descriptors.element(descriptor)
        return spelled(descriptor) + lengths
    if sort == FIXED:
        return "fixed<%d, %d>" % descriptor[1:]
    return descriptors.words(descriptor)


def scoped(type_id):
    """RTC::TimedLong of IDL:RTC/TimedLong:1.0, RTC::PortService of IDL:omg.org/RTC/PortService:1.0:
    a part with a dot comes from #pragma prefix.
    """
    parts = type_id.split(":")
    if len(parts) < 3 or parts[0] != "IDL":
        return type_id
    names = parts[1].split("/")
    while len(names) > 1 and "." in names[0]:
        del names[0]
    return "::".join(names)
