"""The names of an IDL file: their meanings, scopes and repository ids."""

from rtshell_lite.giop.descriptors import TYPECODE

DEEPEST = 40  # scopes in scopes, types in types
# Words that cannot be names. Those of CORBA 3 (component, home, uses, …) can, as in omniidl: real files have
# them.
KEYWORDS = frozenset(
    """abstract any attribute boolean case char const context custom default double enum exception factory
false fixed float in inout interface local long module native object octet oneway out private public raises
readonly sequence short string struct supports switch true truncatable typedef union unsigned valuebase
valuetype void wchar wstring""".split()
)
SPELLED = KEYWORDS - {"false", "object", "true", "valuebase"} | {"FALSE", "Object", "TRUE", "ValueBase"}


class Entry:
    """The meaning of a name: `sort` is module, interface, type, exception, struct (only announced), item,
    constant or unknown: a valuetype or native.

    `what` is the Scope of a module or interface, the descriptor of a type or exception, the value of a
    constant, the item of an enum. `type_id` is its repository id or None; `token` is where it was declared.
    `hole`, a list of one element, is where descriptors look for a struct or union that has been announced: it
    holds None until that is defined. `members` is the Scope of a struct, union or exception.
    """

    def __init__(self, name, sort, what=None, type_id=None, hole=None, token=None):
        self.name = name
        self.sort = sort
        self.what = what
        self.type_id = type_id
        self.hole = hole
        self.token = token
        self.members = None

    @property
    def scope(self):
        """The Scope of the names in it; None where it holds none."""
        return self.what if isinstance(self.what, Scope) else self.members


class Scope:
    """A module, interface, struct or union, or the whole file: the names in it; `interface` is the Interface
    that has this body.
    """

    def __init__(self, name, parent, prefix=""):
        self.name = name
        self.parent = parent
        self.prefix = prefix
        self.names = {}
        self.bases = []
        self.interface = None

    def path(self):
        """Its name from the outside: RTC::PortService."""
        if self.parent is None or not self.parent.name:
            return self.name
        return f"{self.parent.path()}::{self.name}"

    def inner_prefix(self, name):
        """The prefix of the repository ids of what is declared inside a name of this scope."""
        return f"{self.prefix}/{name}" if self.prefix else name

    def own(self, name):
        """The Entry of a name declared here or in an interface that this one inherits from, or None."""
        todo = [self]
        seen = set()
        while todo:
            scope = todo.pop(0)
            if id(scope) in seen:
                continue
            seen.add(id(scope))
            if name.lower() in scope.names:
                return scope.names[name.lower()]
            todo += scope.bases
        if name == "TypeCode" and self.name == "CORBA" and self.parent and not self.parent.name:
            return Entry(name, "type", TYPECODE)  # no file declares it
        return None

    def find(self, name):
        """The Entry of a name in this scope or the nearest one around it, or None."""
        return self.own(name) or self.parent and self.parent.find(name)
