"""IDL text as tokens, preprocessed, without comments."""

import os

from rtshell_lite import errors, files
from rtshell_lite.data.idl import conditions, scanner
from rtshell_lite.giop import idl
from rtshell_lite.records import record
from rtshell_lite.text import is_identifier, printable

LARGEST = 1 << 22  # bytes of a file
MOST_TOKENS = 200000
MOST_FILES = 1000
DEEPEST = conditions.DEEPEST  # files within files
MACRO = 1000  # tokens that a macro may grow to
OF_ORBS = ("orb.idl", "omg.idl", "corba.idl")  # built into every ORB
CLOSING = {'"': '"', "<": ">"}  # of the name of a file
NESTING = {"(": 1, ")": -1}
BYTE_ORDER_MARK = b"\xef\xbb\xbf"


# A #define: the names of its parameters, None for one without brackets, and its (kind, word) tokens.
Macro = record("Macro", "parameters body")


class Token:
    """kind: name, number, string, char, mark, pragma, file (an included file begins or ends), own (an include
    of one of OpenRTM's own files), end; word: as written, the name of the own file.
    """

    __slots__ = ("kind", "word", "file", "line", "column")

    def __init__(self, kind, word, file, line, column):
        self.kind = kind
        self.word = word
        self.file = file
        self.line = line
        self.column = column

    def place(self):
        """FILE:LINE, spelt for the terminal; without a line where that is unknown."""
        if not self.line:
            return printable(self.file)
        return f"{printable(self.file)}:{self.line}"


def tokens(path, include=(), find=None):
    """The tokens of an IDL file and of what it includes; the last is of kind `end`. `include` and `find` say
    where that is, as of parser.read_file.
    Raises BadIdl, errors.Failed.
    """
    source = _Source(list(include), find)
    source.file(path, 0)
    return _ended(source, path)


def _ended(source, path):
    last = source.found[-1] if source.found else Token("", "", path, 1, 1)
    column = last.column + len(last.word)
    source.found.append(Token("end", "the end of the file", last.file, last.line, column))
    return source.found


def of_text(text, name):
    """The tokens of IDL that is no file of ours; `name` is for messages. Raises BadIdl, also for #include of
    another file than OpenRTM's own.
    """
    source = _Source([], None)
    source.files = MOST_FILES
    _File(source, name, text, 0).scan()
    return _ended(source, name)


class _Source:
    def __init__(self, include, find):
        self.include = include
        self.find = find
        self.macros = {"__OMNIIDL__": Macro(None, [("number", "0x040300")])}  # real files ask for it
        self.found = []
        self.files = 0

    def file(self, path, depth):
        self.files += 1
        if depth > DEEPEST or self.files > MOST_FILES:
            raise errors.BadIdl(printable(path), 1, 1, "includes too many files")
        _File(self, path, _read(path), depth).scan()


def _read(path):
    try:
        with files.opened(path) as file:
            data = file.read(LARGEST + 1)
    except (OSError, ValueError) as e:
        raise errors.Failed(printable(path), getattr(e, "strerror", None) or str(e))
    if len(data) > LARGEST:
        raise errors.BadIdl(printable(path), 1, 1, "larger than %d bytes" % LARGEST)
    if data.startswith(BYTE_ORDER_MARK):
        data = data[len(BYTE_ORDER_MARK) :]
    return data.decode("latin-1")


def _from(words, seen):
    """(kind, word) tokens with the names of the macros that they come from."""
    return [(kind, word, seen) for kind, word in words]


class _File:
    """Turns a file into tokens."""

    def __init__(self, source, path, text, depth):
        self.source = source
        self.path = path
        self.text = text
        self.depth = depth
        self.at = 0
        self.line = 1
        self.line_start = 0
        self.conditions = []  # a conditions.Open for each #if around this place

    def fault(self, why):
        return errors.BadIdl(printable(self.path), self.line, self._column(), why)

    def _column(self):
        return self.at - self.line_start + 1

    def _add(self, kind, word):
        """Add a token of this place."""
        self.source.found.append(Token(kind, word, self.path, self.line, self._column()))

    def scan(self):
        """Add the tokens of the file to those of the source. Raises BadIdl, errors.Failed."""
        fresh = True  # only blanks on this line so far
        while self.at < len(self.text):
            active = not self.conditions or self.conditions[-1].is_taken
            if active:
                kind, end = scanner.piece(self.text, self.at)
            else:
                kind, end = scanner.skipped(self.text, self.at)
            if kind is None:
                raise self.fault(self._unreadable())
            if kind == "directive" and fresh:
                self._directive(scanner.one_line(self.text[self.at : end]), active)
            elif kind == "directive" and active:
                raise self.fault("a # within a line")
            elif kind not in ("space", "comment", "directive"):
                fresh = False
                if active:
                    end = self._token(kind, end)
            fresh = self._pass(end) or fresh
            if len(self.source.found) > MOST_TOKENS:
                raise self.fault("too long")
        if self.conditions:
            raise errors.BadIdl(printable(self.path), self.conditions[-1].line, 1, "#if without #endif")

    def _pass(self, end):
        """Go to where a piece ends; whether a new line begins in it."""
        lines = self.text.count("\n", self.at, end)
        if lines:
            self.line += lines
            self.line_start = self.text.rindex("\n", self.at, end) + 1
        self.at = end
        return lines > 0

    def _unreadable(self):
        rest = self.text[self.at : self.at + 2]
        if rest == "/*":
            return "a comment without its end"
        if rest.lstrip("L").startswith(("'", '"')):
            return "a string or character without its end"
        line, _, _ = self.text[self.at : self.at + 12].partition("\n")
        return f"cannot be read: {printable(line)}"

    def _token(self, kind, end):
        """Add the token that begins here and ends at `end`, or the expansion of the macro of its name; where
        that ends.
        """
        word = self.text[self.at : end]
        macro = None
        if kind == "name":
            macro = self.source.macros.get(word)
        if macro is None:
            self._add(kind, word)
            return end
        words = [(kind, word)]
        if macro.parameters is not None:
            arguments, end = self._arguments(end)
            words += arguments
        self._expand(_from(words, frozenset()))
        return end

    def _arguments(self, start):
        """The (kind, word) tokens from a bracket to its end, with both, and where they end; none where no
        bracket is.
        """
        tokens = []
        depth = 0
        for kind, word, end in scanner.words(self.text, start):
            if kind in (None, "directive") or len(tokens) > MACRO:
                break
            tokens.append((kind, word))
            depth += NESTING.get(word, 0)
            if tokens[0] != ("mark", "("):
                return [], start
            if not depth:
                return tokens, end
        raise self.fault("the parameters of a macro that cannot be read")

    def _expand(self, words):
        """Add the tokens of words, (kind, word, names of the macros that it comes from) each, of which the
        first is a macro.
        """
        name = words[0][1]
        count = 0
        while words:
            kind, word, seen = words.pop(0)
            if self._is_macro(kind, word, seen, words):
                words[:0] = self._body(word, words, seen | {word})
            else:
                self._add(kind, word)
                count += 1
            if count + len(words) > MACRO:
                raise self.fault(f"a macro that grows too large: {name}")

    def _is_macro(self, kind, word, seen, following):
        if kind != "name" or word in seen or word not in self.source.macros:
            return False
        if self.source.macros[word].parameters is None:
            return True
        return bool(following) and following[0][1] == "("

    def _body(self, name, words, seen):
        """The words of a macro, with its arguments, which are taken from the words that follow."""
        macro = self.source.macros[name]
        body = _from(macro.body, seen)
        if macro.parameters is None:
            return body
        given = [[]]
        depth = 0
        while words:
            part = words.pop(0)
            _, word, _ = part
            depth += NESTING.get(word, 0)
            if depth == 0:
                break
            if word == "," and depth == 1:
                given.append([])
            elif word != "(" or depth > 1:
                given[-1].append(part)
        if given == [[]] and not macro.parameters:
            given = []
        if depth or len(given) != len(macro.parameters):
            raise self.fault(f"a macro with {len(macro.parameters)} parameters: {name}")
        named = dict(zip(macro.parameters, given))
        replaced = []
        for part in body:
            _, word, _ = part
            replaced += named.get(word, [part])
        return replaced

    # ---- preprocessor lines ----

    def _directive(self, line, active):
        line = line[1:].lstrip()
        name = scanner.leading_name(line)
        rest = line[len(name) :].strip()
        if name in ("if", "ifdef", "ifndef", "elif", "else", "endif"):
            self._condition(name, rest, active)
        elif active and name in ("include", "define", "undef", "pragma", "error"):
            getattr(self, "_" + name)(rest)
        elif active and name not in ("", "line", "ident", "warning"):
            raise self.fault(f"not known: #{name}")

    def _condition(self, name, rest, active):
        if name in ("if", "ifdef", "ifndef"):
            is_taken = active and self._holds(name, rest)
            self.conditions.append(conditions.Open(is_taken, is_taken or not active, self.line))
            if len(self.conditions) > DEEPEST:
                raise self.fault("conditions within conditions too deep")
            return
        if not self.conditions:
            raise self.fault(f"#{name} without #if")
        if name == "endif":
            self.conditions.pop()
            return
        last = self.conditions[-1]
        if last.has_else:
            raise self.fault(f"#{name} without #if")
        last.is_taken = not last.is_decided and (name == "else" or self._holds("if", rest))
        last.is_decided = last.is_decided or last.is_taken
        last.has_else = name == "else"

    def _holds(self, name, rest):
        if name == "if":
            try:
                return bool(conditions.value(rest, self.source.macros))
            except ValueError as e:
                raise self.fault(str(e))
        word = scanner.leading_name(rest)
        if not word:
            raise self.fault(f"#{name} needs a name")
        return (word in self.source.macros) == (name == "ifdef")

    def _define(self, rest):
        name = scanner.leading_name(rest)
        if not name:
            raise self.fault("#define needs a name")
        body = rest[len(name) :]
        parameters = None
        if body[:1] == "(":
            listed, bracket, body = body[1:].partition(")")
            parameters = [word.strip() for word in listed.split(",") if listed.strip()]
            if not bracket or not all(map(is_identifier, parameters)):
                raise self.fault(f"a macro that cannot be read: {name}")
        self.source.macros[name] = Macro(parameters, self._body_of(name, body))

    def _body_of(self, name, body):
        """The (kind, word) tokens of the body of a macro."""
        tokens = []
        for kind, word, _ in scanner.words(body, 0):
            if kind in (None, "directive"):
                raise self.fault(f"a macro that cannot be read: {name}")
            tokens.append((kind, word))
        return tokens

    def _undef(self, rest):
        self.source.macros.pop(rest, None)

    def _error(self, rest):
        raise self.fault("#error " + printable(rest))

    def _pragma(self, rest):
        self._add("pragma", rest)

    def _include(self, rest):
        closing = CLOSING.get(rest[:1], "\n")
        name, closed, _ = rest[1:].partition(closing)
        if not closed or not name:
            raise self.fault("#include needs a file")
        own = os.path.basename(name)
        path = self._included(name, closing == '"')
        if path is None and own in idl.FILES:
            self._add("own", own)
            return
        if path is None and self.source.find:
            path = self.source.find(name)
        if path is None and own in OF_ORBS:
            return
        if path is None:
            raise self.fault(f"no such file to include: {printable(name)} (-I DIR names where to look)")
        self._add("file", "begin")
        self.source.file(path, self.depth + 1)
        self._add("file", "end")

    def _included(self, name, is_beside):
        """The path of a file to include: beside this one, or in the directories given; or None."""
        directories = list(self.source.include)
        if is_beside:
            directories.insert(0, os.path.dirname(self.path))
        paths = [os.path.join(directory, name) for directory in directories]
        return next(filter(os.path.isfile, paths), None)
