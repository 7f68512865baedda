"""Names of an IDL file: what they stand for, where they are seen, and the repository ids that they make."""

DEEPEST = 40  # scopes in scopes, types in types
# Words that cannot be names; those of CORBA 3 (component, home, uses, …) are names in real files, and to omniidl
KEYWORDS = frozenset("""abstract any attribute boolean case char const context custom default double enum exception factory
false fixed float in inout interface local long module native object octet oneway out private public raises readonly sequence
short string struct supports switch true truncatable typedef union unsigned valuebase valuetype void wchar wstring""".split())


class Entry:
    """What a name stands for: `sort` module, interface, type, struct (one only announced), item, constant or unknown.

    `what` is the Scope of a module or interface, the descriptor of a type, the value of a constant, the item of an enum.
    `type_id` is its repository id, None for what has none; `token` is where it was declared. `hole`, a list of one, is where
    descriptors look for a struct or union that is only announced: it holds None until that is described.
    """

    def __init__(self, name, sort, what=None, type_id=None, hole=None, token=None):
        self.name, self.sort, self.what, self.type_id, self.hole, self.token = name, sort, what, type_id, hole, token


class Scope:
    """A module, interface, struct or union, or the whole file: the names in it."""

    def __init__(self, name, parent, prefix=""):
        self.name, self.parent, self.prefix = name, parent, prefix
        self.names, self.bases = {}, []

    def own(self, name):
        """The Entry of a name declared here or in an interface that this one inherits from, None when there is none."""
        todo, seen = [self], set()
        while todo:
            scope = todo.pop(0)
            if id(scope) in seen:
                continue
            seen.add(id(scope))
            if name.lower() in scope.names:
                return scope.names[name.lower()]
            todo += scope.bases
        return None

    def seen(self, name):
        """The Entry of a name in this scope or the nearest around it, None when there is none."""
        scope = self
        while scope is not None:
            found = scope.own(name)
            if found is not None:
                return found
            scope = scope.parent
        return None
