"""A small name server (CosNaming 1.0.3): naming contexts, their names, and nothing that outlives
the process.
"""

import itertools
import types  # noqa: F401: in type comments

from rtshell_lite.corba import orb
from rtshell_lite.giop.requests import Thrown

KEY = b"NameService"  # by which every name server is known
MOST_NAMES = 20000  # in all contexts
MOST_CONTEXTS = 5000
MOST_OCTETS = 8 << 20  # of all names and references
LONGEST = 1024  # octets of a name, its kind included
LONGEST_TEXT = 1 << 16  # of names as one text
MOST_ITERATORS = 100
_SPECIAL = "\\/."  # in names as one text
_NOT_FOUND = "CosNaming.NamingContext.NotFound"


class Names:
    """The naming contexts of a process, at `host`; `root` is the first. `make`: the class of contexts."""

    def __init__(self, host, make=None):
        self.host = host
        self._make = make or Context
        self.count = 0  # of names
        self.octets = 0  # of names, and of what is bound to them
        self.contexts = 0
        self.iterators = []
        self.root = self._make(self)
        self.root.withdraw = orb.publish(self.root, host, KEY)

    def context(self):
        """A new Context, bound to no name."""
        if self.contexts >= MOST_CONTEXTS:
            raise Thrown("NO_RESOURCES")
        self.contexts += 1
        context = self._make(self)
        context.withdraw = orb.publish(context, self.host)
        return context

    def iterator(self, bindings):
        """A reference to an iterator over these bindings; the oldest goes if there are too many."""
        iterator = Iterator(bindings)
        iterator.withdraw = orb.publish(iterator, self.host)
        self.iterators.append(iterator)
        if len(self.iterators) > MOST_ITERATORS:
            self.iterators.pop(0).withdraw()
        return iterator.reference


class Context:
    """A naming context: `bound` is {(id, kind): (reference, whether it is a context)}, texts as on
    the wire.
    """

    interface = "CosNaming.NamingContextExt"
    reference = None
    withdraw = None  # type: types.FunctionType

    def __init__(self, names):
        self._names = names
        self.bound = {}

    # ---- operations of NamingContext ----

    def bind(self, name, reference):
        self._put(name, reference, False, again=False)

    def rebind(self, name, reference):
        self._put(name, reference, False, again=True)

    def bind_context(self, name, reference):
        self._put(name, reference, True, again=False)

    def rebind_context(self, name, reference):
        self._put(name, reference, True, again=True)

    def bind_new_context(self, name):
        context = self._names.context()
        try:
            self._put(name, context.reference, True, again=False)
        except Thrown:
            context.end()
            raise
        return context.reference

    def new_context(self):
        return self._names.context().reference

    def resolve(self, name):
        context, last = self._place(name)
        if last not in context.bound:
            raise Thrown(_NOT_FOUND, _why("missing_node"), name[-1:])
        return context.bound[last][0]

    def unbind(self, name):
        context, last = self._place(name)
        binding = context.bound.pop(last, None)
        if binding is None:
            raise Thrown(_NOT_FOUND, _why("missing_node"), name[-1:])
        self._names.count -= 1
        self._names.octets -= _octets(last, binding[0])

    def destroy(self):
        if self.bound:
            raise Thrown("CosNaming.NamingContext.NotEmpty")
        if self is not self._names.root:
            self.end()

    def end(self):
        """Answer no more."""
        if self.withdraw() is not None:
            self._names.contexts -= 1

    def list(self, how_many):
        bindings = [_binding(name, is_context) for name, (_, is_context) in self.bound.items()]
        rest = bindings[how_many:]
        if not rest:
            return bindings, None
        return bindings[:how_many], self._names.iterator(rest)

    # ---- operations of NamingContextExt ----

    def to_string(self, name):
        _check(name)
        return "/".join(_spelt(part.id, part.kind) for part in name)

    def to_name(self, text):
        return [orb.struct("CosNaming.NameComponent")(*pair) for pair in parsed(text)]

    def to_url(self, address, text):
        parsed(text)
        if not address:
            raise Thrown("CosNaming.NamingContextExt.InvalidAddress")
        return f"corbaname:{address}#{text}"

    def resolve_str(self, text):
        return self.resolve(self.to_name(text))

    # ---- names ----

    def _place(self, name):
        """(the Context that the last part of a name is in, that part)"""
        _check(name)
        context = self
        for number, part in enumerate(name[:-1]):
            reference, is_context = context.bound.get((part.id, part.kind), (None, False))
            if reference is None:
                raise Thrown(_NOT_FOUND, _why("missing_node"), name[number:])
            if not is_context:
                raise Thrown(_NOT_FOUND, _why("not_context"), name[number:])
            context = orb.own_servant(reference)
            if context is None:  # of another name server, which the caller may go on with
                raise Thrown("CosNaming.NamingContext.CannotProceed", reference, name[number + 1 :])
        return context, (name[-1].id, name[-1].kind)

    def _put(self, name, reference, is_context, again):
        context, last = self._place(name)
        if reference is None:
            raise Thrown("BAD_PARAM")
        binding = context.bound.get(last)
        if binding is not None and not again:
            raise Thrown("CosNaming.NamingContext.AlreadyBound")
        if binding is not None and binding[1] != is_context:
            raise Thrown(_NOT_FOUND, _why("not_context" if is_context else "not_object"), name[-1:])
        more = _octets(last, reference)
        if binding is not None:
            more -= _octets(last, binding[0])
        if binding is None and self._names.count >= MOST_NAMES or self._names.octets + more > MOST_OCTETS:
            raise Thrown("NO_RESOURCES")
        if binding is None:
            self._names.count += 1
        self._names.octets += more
        context.bound[last] = reference, is_context


class Iterator:
    """The rest of a long list of names."""

    interface = "CosNaming.BindingIterator"
    reference = None
    withdraw = None  # type: types.FunctionType

    def __init__(self, bindings):
        self._bindings = bindings

    def next_one(self):
        if not self._bindings:
            return False, _binding(("", ""), False)
        return True, self._bindings.pop(0)

    def next_n(self, how_many):
        if not how_many:
            raise Thrown("BAD_PARAM")
        bindings = self._bindings[:how_many]
        del self._bindings[:how_many]
        return bool(bindings), bindings

    def destroy(self):
        self.withdraw()


def _binding(name, is_context):
    item = orb.items("CosNaming.BindingType")[int(is_context)]
    component = orb.struct("CosNaming.NameComponent")(*name)
    return orb.struct("CosNaming.Binding")([component], item)


def _why(word):
    return orb.enumerator("CosNaming.NamingContext.NotFoundReason", word)


def _check(name):
    if not name or any(len(part.id) + len(part.kind) > LONGEST for part in name):
        raise Thrown("CosNaming.NamingContext.InvalidName")


def _octets(name, reference):
    """Octets of what is kept for a name; its texts have a character for each octet on the wire."""
    profiles = sum(len(profile) for _, profile in reference.profiles)
    return len(name[0]) + len(name[1]) + len(reference.type_id) + profiles


# ---- names as one text (CosNaming 2.4) ----


def _spelt(id, kind):
    def escaped(text):
        return "".join("\\" + letter if letter in _SPECIAL else letter for letter in text)

    if kind or not id:
        return escaped(id) + "." + escaped(kind)
    return escaped(id)


def parsed(text):
    """[(id, kind)] of a name as one text. Raises InvalidName."""
    invalid = Thrown("CosNaming.NamingContext.InvalidName")
    if len(text) > LONGEST_TEXT:
        raise invalid
    parts = [["", None]]
    letters = iter(text)
    for letter in letters:
        part = parts[-1]
        if letter == "/":
            parts.append(["", None])
            continue
        if letter == "." and part[1] is None:
            part[1] = ""
            continue
        if letter == ".":
            raise invalid
        if letter == "\\":
            letter = next(letters, "")
            if not letter or letter not in _SPECIAL:
                raise invalid
        if part[1] is None:
            part[0] += letter
        else:
            part[1] += letter
    pairs = [(id, kind or "") for id, kind in parts]
    is_empty = any(not id and kind is None for id, kind in parts)
    is_cut = any(id and kind == "" for id, kind in parts)
    if is_empty or is_cut:
        raise invalid
    return list(itertools.islice(pairs, MOST_NAMES))
