"""The grammar of IDL (CORBA 3.0, 3.4), from tokens to descriptors and interfaces."""

from rtshell_lite import errors
from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import ALIAS
from rtshell_lite.data.idl import constants, exports, included, tokens, types
from rtshell_lite.data.idl.interfaces import Interface
from rtshell_lite.data.idl.scopes import DEEPEST, KEYWORDS, SPELLED, Entry, Scope
from rtshell_lite.records import record
from rtshell_lite.text import printable

BRACKETS = {"{": "}", "(": ")", "[": "]"}
# beside operations and attributes
WITHIN_INTERFACES = (
    "typedef", "const", "exception", "struct", "union", "enum", "native", "typeid", "typeprefix"
)


def parse_file(path, include=()):
    """The types that an IDL file and its includes define: {repository id: descriptor}, typedefs as aliases.

    `include` are directories for #include; OpenRTM's own IDL files need none. Raises BadIdl with file, line
    and column, and errors.Failed for a file that cannot be read.
    """
    return read_file(path, include).types


def parse_text(text, name):
    """The types of IDL that is no file of ours, and may not include files; `name` is for messages."""
    return Parser(tokens.of_text(text, name)).contents().types


def read_file(path, include=(), find=None):
    """The Contents of an IDL file and its includes; find(name) gives the path of one that is in no place that
    `include` names, or None. Raises what `parse_file` raises.
    """
    return Parser(tokens.tokens(path, include, find)).contents()


# What an IDL file and its includes define, each {repository id: …}: `types` are descriptors, typedefs as
# aliases; `interfaces` are Interfaces.
Contents = record("Contents", "types interfaces")


class Parser:
    """Reads tokens and collects the types and interfaces that they define."""

    def __init__(self, tokens):
        self.tokens = tokens
        self.at = 0
        self.file_scope = self.scope = Scope("", None)
        self.made = {}  # identity of an Entry → (repository id, descriptor)
        self.announced = []  # Entries of structs and unions
        self.interfaces = {}  # identity of the Entry of each interface that is defined → that Entry
        self.included = set()  # names of OpenRTM's own files
        self.prefixes = []  # prefixes of the files around this place
        self.weights = {}  # identity of a descriptor → (types in it, depth)
        self.kept = []  # the objects of these identities, which must live as long
        self._go()

    def contents(self):
        """The Contents of everything that the tokens define. Raises BadIdl."""
        while self.token.kind != "end":
            self.definition(0)
        for entry in self.announced:
            if entry.hole[0] is None:
                raise self.fault(f"{entry.name} is declared, but not defined", entry.token)
        for entry in self.interfaces.values():
            entry.what.interface.repository_id = entry.type_id  # a pragma may have come after it
        interfaces = {entry.type_id: entry.what.interface for entry in self.interfaces.values()}
        return Contents(dict(self.made.values()), interfaces)

    # ---- tokens ----

    def _go(self):
        """Go to the next token of the grammar, past pragmas, ends of files and files of OpenRTM's own."""
        while True:
            self.token = self.tokens[self.at]
            if self.token.kind == "pragma":
                self._pragma(self.token)
            elif self.token.kind == "file":
                self._file(self.token.word)
            elif self.token.kind == "own":
                included.declare(self, self.token.word, self.token)
            else:
                return
            self.at += 1

    def advance(self):
        """The current token, which is skipped."""
        token = self.token
        if token.kind != "end":
            self.at += 1
            self._go()
        return token

    def state(self):
        """Where the parser is, for go_back."""
        return self.at, list(self.prefixes), self.scope.prefix

    def go_back(self, state):
        self.at, self.prefixes, self.scope.prefix = state
        self._go()

    def fault(self, why, token=None):
        """The BadIdl for a token (default: the current one)."""
        token = token or self.token
        return errors.BadIdl(printable(token.file), token.line, token.column, why)

    def unexpected(self, expected, token=None):
        """The BadIdl for something other than what is wanted here."""
        return self.fault(f"expected {expected}, not {printable(self.token.word)}", token)

    def is_mark(self, *marks):
        return self.token.kind == "mark" and self.token.word in marks

    def is_word(self, *words):
        return self.token.kind == "name" and self.token.word in words

    def accept(self, word):
        """Skip this word or mark if it comes next; returns whether it does."""
        is_next = self.token.kind in ("mark", "name") and self.token.word == word
        if is_next:
            self.advance()
        return is_next

    def take(self, word):
        """Skip this word or mark. Raises BadIdl when something else is there."""
        if not self.accept(word):
            raise self.unexpected(word)

    def _file(self, word):
        """A prefix ends with the file that sets it (CORBA 3.0, 10.7.5)."""
        if word == "begin":
            self.prefixes.append(self.scope.prefix)
            if self.scope is self.file_scope:
                self.scope.prefix = ""
        else:
            self.scope.prefix = self.prefixes.pop()

    def _pragma(self, token):
        words = token.word.split(None, 1)
        if len(words) < 2 or words[0] not in ("prefix", "ID", "version"):
            return  # keylist and others, for other tools
        name, rest = words
        if name == "prefix":
            prefix = _unquoted(rest)
            if prefix is None:
                raise self.fault("#pragma prefix needs a text in quotes", token)
            self.scope.prefix = prefix
            return
        word, _, value = rest.partition(" ")
        self._of_type(name, word, value.strip(), token)

    def _of_type(self, name, word, value, token):
        """The pragma ID or version of a type that is declared."""
        repository_id = _unquoted(value)
        if name == "ID" and repository_id is None or name == "version" and not _is_version(value):
            raise self.fault(f"#pragma {name} cannot be read", token)
        entry = self._of_pragma(word)
        if entry is None:
            raise self.fault(f"#pragma {name}: not declared: {printable(word)}", token)
        if name == "ID":
            self._rename(entry, repository_id)
        elif entry.type_id:
            self._rename(entry, entry.type_id.rpartition(":")[0] + ":" + value)

    def _of_pragma(self, name):
        first, *others = name.lstrip(":").split("::")
        entry = self.scope.find(first)
        for part in others:
            if entry is None or entry.scope is None:
                return None
            entry = entry.scope.own(part)
        return entry

    def _rename(self, entry, type_id):
        """Give a declared type another repository id."""
        entry.type_id = type_id
        if entry.sort == "exception":
            entry.what = descriptors.renamed(entry.what, type_id)
        if entry.sort == "type" and id(entry) in self.made:
            old = entry.what
            entry.what = descriptors.renamed(old, type_id)
            self.weigh(entry.what, *self.weights[id(old)])
            if entry.hole:
                entry.hole[0] = entry.what
            self.made[id(entry)] = (type_id, entry.what)

    # ---- names ----

    def name(self, what):
        """An identifier that is declared, without an escaping _. Raises BadIdl for a keyword."""
        token = self.token
        if token.kind != "name":
            raise self.unexpected(f"the name of {what}")
        self.advance()
        if token.word.startswith("_"):
            if not token.word[1:2].isalpha():
                raise self.fault(f"not a name: {token.word}", token)
            return token.word[1:]
        if token.word.lower() in KEYWORDS:
            raise self.fault(f"a word of IDL cannot be a name: {token.word}", token)
        return token.word

    def declare(self, entry, token):
        """Add a name to this scope. Raises BadIdl when it is there already, in whatever case."""
        name = entry.name.lower()
        old = self.scope.names.get(name)
        if old is not None:
            raise self.twice(entry.name, old, token)
        if name == self.scope.name.lower():
            raise self.fault(f"{entry.name} is the name of what is around it", token)
        self.scope.names[name] = entry
        entry.token = entry.token or token
        return entry

    def twice(self, name, old, token):
        """The BadIdl for a name whose Entry is there already."""
        why = f"{name} is declared already"
        if old.name != name:
            why += f" as {old.name}"
        if old.token and old.token.file != token.file:
            why += f", in {old.token.place()}; leave one of the two out"
        return self.fault(why, token)

    def look_up(self):
        """The Entry of the scoped name that comes next. Raises BadIdl."""
        start = self.token
        entry = self.file_scope.own(self.plain()) if self.accept("::") else self.scope.find(self.plain())
        written = self._last
        self._same_case(entry, written, start)
        while self.accept("::"):
            if entry.scope is None:
                raise self.fault(f"{written} holds no names", start)
            entry = entry.scope.own(self.plain())
            written += "::" + self._last
            self._same_case(entry, written, start)
        return entry

    def names_corba(self):
        """Whether CORBA or ::CORBA comes next, and is not declared."""
        token = self.token
        if token.kind == "mark" and token.word == "::":
            token = self.tokens[self.at + 1]
        return token.kind == "name" and token.word == "CORBA" and self.scope.find("CORBA") is None

    def plain(self):
        """The name that comes next, without scopes. Raises BadIdl for anything else, keywords included."""
        token = self.token
        if token.kind != "name":
            raise self.unexpected("a name")
        if token.word in SPELLED:  # in another case, _Factory may be declared
            raise self.unexpected("a name")
        self._last = self.advance().word.lstrip("_")
        return self._last

    def _same_case(self, entry, written, token):
        if entry is None:
            raise self.fault(f"not declared: {written}", token)
        if entry.name != self._last:
            raise self.fault(f"{written} is declared as {entry.name}", token)

    def new_id(self, name):
        """The repository id of what is declared here under a name (CORBA 3.0, 10.7.1)."""
        return f"IDL:{self.scope.inner_prefix(name)}:1.0"

    # ---- definitions ----

    def definition(self, depth):
        """One definition with its semicolon."""
        if depth > DEEPEST:
            raise self.fault("nested too deep")
        if self.accept(";"):  # one too many, as people write
            return
        word = self.token.word if self.token.kind == "name" else ""
        if word == "module":
            self._module(depth)
        elif word in ("interface", "local", "abstract"):
            self._interface(depth)
        elif word in ("typedef", "const", "native", "exception"):
            getattr(self, "_" + word)(depth)
        elif word in ("struct", "union", "enum"):
            types.constructed(self, depth)
        elif word in ("valuetype", "custom", "component", "home", "eventtype"):
            self._unread()
        elif word in ("typeprefix", "typeid"):
            self._typed_pragma(word)
        elif word == "import":
            self.skip()
        else:
            raise self.unexpected("a definition")
        self.take(";")

    def _module(self, depth):
        first = self.advance()
        token = self.token
        name = self.name("a module")
        entry = self._known("module", name) or self._new_scope("module", name, first, token)
        self._body(entry, token, lambda: self.definition(depth + 1))

    def _interface(self, depth):
        first = self.advance()
        kind = ""
        if first.word != "interface":  # local or abstract
            kind = first.word
            if self.is_word("valuetype", "eventtype"):
                return self._unread()
            self.take("interface")
        token = self.token
        name = self.name("an interface")
        is_announced = self.is_mark(";")  # before its definition, or again after it
        entry = self._known("interface", name)
        if entry is None or id(entry) in self.interfaces and not is_announced:
            entry = self._new_scope("interface", name, first, token)
        if entry.what.interface is None:
            entry.what.interface = Interface(entry.what.path(), entry.type_id, kind, first.file)
        if is_announced:
            return
        self.interfaces[id(entry)] = entry
        if self.is_mark(":"):
            self._bases(entry)
        self._body(entry, token, lambda: self._member(entry.what.interface, depth + 1))

    def _known(self, sort, name):
        """The Entry of this sort and name in this scope, or None."""
        entry = self.scope.names.get(name.lower())
        if entry is None or entry.sort != sort or entry.name != name:
            return None
        return entry

    def _new_scope(self, sort, name, first, token):
        """A declared Entry with a Scope; `first` is the token that it begins with, `token` is its name."""
        entry = Entry(name, sort, Scope(name, self.scope), self.new_id(name), token=first)
        return self.declare(entry, token)

    def _body(self, entry, token, read):
        """What is between the brackets of a module or an interface; read() reads a part of it."""
        entry.what.prefix = self.scope.inner_prefix(entry.name)
        self.take("{")
        outer = self.scope
        self.scope = entry.what
        while not self.is_mark("}"):
            if self.token.kind == "end":
                raise self.fault(f"{entry.sort} {entry.name} has no end", token)
            read()
        self.scope = outer
        self.take("}")

    def _member(self, interface, depth):
        if self.is_word(*WITHIN_INTERFACES) or self.is_mark(";"):
            self.definition(depth)
            return
        exports.export(self, interface, depth)
        self.take(";")

    def _bases(self, entry):
        while self.is_mark(":", ","):
            self.advance()
            base = self._interface_of(self.look_up())
            if base is not None:
                entry.what.bases.append(base.what)
                entry.what.interface.bases.append(base.what.interface)

    def _interface_of(self, entry):
        """The Entry of the interface that an Entry is, or is a typedef of; None for another."""
        if entry.sort == "interface":
            return entry
        type_id = ""
        if entry.sort == "type":
            type_id = descriptors.type_id(descriptors.target(entry.what))
        return next((entry for entry in self.interfaces.values() if entry.type_id == type_id), None)

    def skip(self):
        """Skip everything up to the next semicolon outside all brackets; returns these tokens, with it."""
        start = self.token
        closing = []  # the brackets that are still to come
        skipped = []
        while closing or not self.is_mark(";"):
            token = self.token
            expected = closing[-1] if closing else ";"
            if token.kind == "end":
                raise self.unexpected(expected, start)
            if self.is_mark(*BRACKETS):
                closing.append(BRACKETS[token.word])
            elif self.is_mark(*BRACKETS.values()):
                if token.word != expected:
                    raise self.unexpected(expected)
                closing.pop()
            skipped.append(self.advance())
        return skipped + [self.token]

    def _unread(self):
        """A valuetype, component or home: only its name is read."""
        while self.is_word("custom", "abstract", "valuetype", "component", "home", "eventtype"):
            self.advance()
        token = self.token
        name = self.name("a type")
        if name.lower() not in self.scope.names:  # it may have been announced
            self.declare(Entry(name, "unknown", type_id=self.new_id(name)), token)
        self.skip()

    def _typed_pragma(self, word):
        self.advance()
        entry = self.look_up()
        token = self.token
        if token.kind != "string":
            raise self.fault("expected a text in quotes")
        text = constants.text(self, self.advance())
        if word == "typeid":
            self._rename(entry, text)
        elif isinstance(entry.what, Scope):
            entry.what.prefix = text
            entry.what.prefix = entry.what.inner_prefix(entry.name)
        else:
            raise self.fault(f"{entry.name} holds no names", token)

    def _native(self, depth):
        self.advance()
        token = self.token
        name = self.name("a type")
        self.declare(Entry(name, "unknown", type_id=self.new_id(name)), token)

    def _exception(self, depth):
        """An exception is read like a struct, but is not a data type."""
        self.advance()
        token = self.token
        name = self.name("an exception")
        entry = self.declare(Entry(name, "exception", type_id=self.new_id(name)), token)
        self.take("{")
        members = types.within(self, entry, lambda: types.members(self, depth + 1))
        entry.what = descriptors.exception(entry.type_id, name, members)
        self.take("}")

    def _const(self, depth):
        self.advance()
        token = self.token
        descriptor = types.type_spec(self, depth)
        name_token = self.token
        name = self.name("a constant")
        self.take("=")
        value = constants.check(self, descriptor, constants.expression(self), token)
        self.declare(Entry(name, "constant", value, self.new_id(name)), name_token)

    def _typedef(self, depth):
        self.advance()
        descriptor = types.type_spec(self, depth + 1)
        while True:
            token, name, whole = types.declarator(self, descriptor, "a type")
            alias = self.weigh((ALIAS, self.new_id(name), name, whole), *self.weight(whole))
            self.define(alias, name, token)
            if not self.accept(","):
                return

    def define(self, descriptor, name, token):
        """Declare a type that has a descriptor."""
        type_id = descriptors.type_id(descriptor)
        entry = self.declare(Entry(name, "type", descriptor, type_id), token)
        self.made[id(entry)] = (type_id, descriptor)
        self.kept.append(entry)

    # ---- bounds ----

    def weight(self, descriptor):
        """(types in it, depth) of a descriptor."""
        if isinstance(descriptor, tuple):
            return self.weights.get(id(descriptor), (1, 1))
        return (1, 1)

    def weigh(self, descriptor, weight, depth):
        """The descriptor; `weight` and `depth` are those of its parts.
        Raises BadIdl when they are too large.
        """
        if weight > descriptors.LARGEST or depth > descriptors.DEEPEST:
            raise self.fault("a type too large or nested too deep")
        self.weights[id(descriptor)] = (weight + 1, depth + 1)
        self.kept.append(descriptor)
        return descriptor

    def weighed(self, descriptor, inner):
        """The descriptor, weighed by its `inner` parts."""
        types = 0
        deepest = 0
        for part in inner:
            weight, depth = self.weight(part)
            types += weight
            deepest = max(deepest, depth)
        return self.weigh(descriptor, types, deepest)


def _unquoted(word):
    """What is between the quotes of a word, None where it has none."""
    parts = word.split('"')
    if len(parts) != 3 or parts[0] or parts[2]:
        return None
    return parts[1]


def _is_version(word):
    """Whether a word is a version of a type, as 1.0."""
    major, _, minor = word.partition(".")
    return major.isdigit() and minor.isdigit()
