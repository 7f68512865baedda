"""Binding names in a name server as OpenRTM components do. A name is a list of (id, kind) pairs."""
from . import carrier
from .carrier import CosNaming


def _name(pairs):
    return [CosNaming.NameComponent(*pair) for pair in pairs]


def root(process, address):
    """The root context of the name server at HOST:PORT, which is not contacted; its reference has no type id.
    """
    host, _, port = address.partition(":")
    uri = f"corbaloc:iiop:1.2@{host}:{port or '2809'}/NameService"
    return process.reference(uri)._unchecked_narrow(CosNaming.NamingContext)


class Naming:
    """One name server, and the names bound in it."""

    def __init__(self, process, address):
        self.address = address
        self.root = root(process, address)
        self.bound = []

    def bind(self, name, reference):
        """Bind a name, replacing what was there and making missing contexts."""
        try:
            self.root.rebind(_name(name), reference)
        except CosNaming.NamingContext.NotFound:
            self.contexts(name[:-1])
            self.root.rebind(_name(name), reference)
        self.bound.append(name)

    def contexts(self, name):
        """The naming context of that name, made with those above it where missing."""
        for end in range(1, len(name) + 1):
            try:
                self.root.bind_new_context(_name(name[:end]))
            except CosNaming.NamingContext.AlreadyBound:
                pass
        return self.resolve(name)._narrow(CosNaming.NamingContext) if name else self.root

    def bind_context(self, name, context):
        """Bind a context under a second name."""
        self.root.rebind_context(_name(name), context)
        self.bound.append(name)

    def resolve(self, name):
        return self.root.resolve(_name(name))

    def adopt(self, name):
        """Unbind, in the end, a name that someone else has bound."""
        self.bound.append(name)

    def unbind(self, name):
        """Remove a name, if it and the server still exist."""
        try:
            self.root.unbind(_name(name))
        except carrier.Raised:
            pass

    def unbind_all(self):
        for name in self.bound:
            self.unbind(name)


def parse(path):
    """A path split as OpenRTM does: at every slash, and each element at its last dot."""
    parts = []
    for element in path.split("/"):
        before, dot, kind = element.rpartition(".")
        parts.append((before, kind) if dot else (element, ""))
    return parts


def expand(formats, instance_name, profile):
    """The names that a `naming.formats` value gives a component."""
    values = {
        "n": instance_name,
        "t": profile["type_name"],
        "m": profile["type_name"],
        "v": profile["version"],
        "V": profile["vendor"],
        "c": profile["category"],
        "i": profile["implementation_id"],
        "h": ("test"),
        "M": "manager",
        "p": "1",
        "%": "%",
    }
    names = []
    for one in formats.split(","):
        out = ""
        chars = iter(one.strip())
        for char in chars:
            out += values.get(next(chars, "%"), "") if char == "%" else char
        names.append(out)
    return names
