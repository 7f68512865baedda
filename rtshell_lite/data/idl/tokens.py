"""IDL text as tokens, preprocessed, without comments."""

import os
import re

from rtshell_lite import errors, files
from rtshell_lite.giop import idl
from rtshell_lite.text import printable

LARGEST = 1 << 22  # bytes of a file
LONGEST_NUMBER = 100  # characters: long ones take quadratic time
MOST_TOKENS = 200000
MOST_FILES = 1000
DEEPEST = 40  # files within files, conditions within conditions
MACRO = 1000  # tokens that a macro may grow to
OF_ORBS = ("orb.idl", "omg.idl", "corba.idl")  # built into every ORB

_TOKEN = re.compile(
    r"""
    (?P<space>[ \t\r\f\v\n\x1a]+|\\\r?\n)
  | (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<directive>\#(?:\\\r?\n|/\*.*?\*/|(?!/[/*])[^\n])*)
  | (?P<string>L?"(?:[^"\\\n]|\\.)*")
  | (?P<char>L?'(?:[^'\\\n]|\\[^\n])[^'\n]{0,8}')
  | (?P<number>(?:0[xX][0-9a-fA-F]+|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[dD]?)(?![A-Za-z0-9_.]))
  | (?P<name>[A-Za-z_][A-Za-z0-9_]*)
  | (?P<mark>::|<<|>>|/(?!\*)|[][(){}<>,;:=+\-*%|&^~])""",
    re.VERBOSE | re.DOTALL,
)
# what few files need is compiled when one does
_SKIPPED = (
    r"(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<directive>\#(?:\\\r?\n|/\*.*?\*/|(?!/[/*])[^\n])*)|"
    r"(?P<string>\"(?:[^\"\\\n]|\\.)*\")|(?P<other>\s+|(?!/\*)\S)"
)
_COMMENT = r"/\*.*?\*/|\\\r?\n"
_DIRECTIVE = r"#\s*([A-Za-z]*)\s*(.*)"
_NAME = r"[A-Za-z_][A-Za-z0-9_]*"
_PARAMETERS = r"\(\s*(?:[A-Za-z_]\w*\s*(?:,\s*[A-Za-z_]\w*\s*)*)?\)"
_CONDITION = (
    r"\s*(?:(defined)\s*(?:\(\s*([A-Za-z_]\w*)\s*\)|([A-Za-z_]\w*))|([A-Za-z_]\w*)|"
    r"(0[xX][0-9a-fA-F]+|\d+)[uUlL]*|"
    r"(&&|\|\||==|!=|<=|>=|[!()<>+-]))"
)


class Macro:
    """A #define: the names of its parameters, None for one without brackets, and its (kind, word) tokens."""

    def __init__(self, parameters, body):
        self.parameters = parameters
        self.body = body


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
    if source.found:
        last = source.found[-1]
    else:
        last = Token("", "", path, 1, 1)
    return source.found + [
        Token("end", "the end of the file", last.file, last.line, last.column + len(last.word))
    ]


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
    return (data[3:] if data[:3] == b"\xef\xbb\xbf" else data).decode("latin-1")


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
        self.conditions = []  # for each open #if: [taken now, taken once, line, #else seen]

    def fault(self, why):
        return errors.BadIdl(printable(self.path), self.line, self.at - self.line_start + 1, why)

    def scan(self):
        # fresh: only blanks on this line so far
        found = self.source.found
        fresh = True
        while self.at < len(self.text):
            active = not self.conditions or all(condition[0] for condition in self.conditions)
            match = (_TOKEN if active else re.compile(_SKIPPED, re.DOTALL)).match(self.text, self.at)
            if match is None:
                raise self.fault(self._unreadable())
            kind = match.lastgroup
            if kind == "space" and "\n" not in match.group():  # every second one is
                self.at = match.end()
                continue
            word = match.group()
            if kind == "directive" and fresh:
                self._directive(re.sub(_COMMENT, " ", word, flags=re.DOTALL), active)
            elif kind == "directive" and active:
                raise self.fault("a # within a line")
            elif active and kind not in ("space", "comment"):
                end = self._token(
                    Token(kind, word, self.path, self.line, self.at - self.line_start + 1), match.end()
                )
                word = self.text[self.at : end]
                fresh = False
            if kind not in ("space", "comment", "directive") and word.strip():
                fresh = False
            lines = word.count("\n")
            if lines:
                self.line += lines
                self.line_start = self.at + word.rindex("\n") + 1
                fresh = True
            self.at += len(word)
            if len(found) > MOST_TOKENS:
                raise self.fault("too long")
        if self.conditions:
            raise errors.BadIdl(printable(self.path), self.conditions[-1][2], 1, "#if without #endif")

    def _unreadable(self):
        rest = self.text[self.at : self.at + 2]
        if rest == "/*":
            return "a comment without its end"
        if rest[0] in "\"'":
            return "a string or character without its end"
        return "cannot be read: " + printable(self.text[self.at : self.at + 12].split("\n")[0])

    def _token(self, token, end):
        """Add a token that ends at `end`, or the expansion of the macro of its name; returns where
        that ends.
        """
        macro = None
        if token.kind == "name":
            macro = self.source.macros.get(token.word)
        if macro is None:
            self.source.found.append(token)
            return end
        words = [(token.kind, token.word, frozenset())]
        if macro.parameters is not None:
            arguments, end = self._arguments(end)
            words += [part + (frozenset(),) for part in arguments]
        self.source.found.extend(self._expanded(words, token))
        return end

    def _arguments(self, at):
        """The (kind, word) tokens from a bracket to its end, with both, and where they end; none where no
        bracket is.
        """
        found = []
        depth = 0
        start = at
        while True:
            match = _TOKEN.match(self.text, at)
            if match is None or match.lastgroup == "directive" or len(found) > MACRO:
                raise self.fault("the parameters of a macro that cannot be read")
            if match.lastgroup not in ("space", "comment"):
                found.append((match.lastgroup, match.group()))
                depth += (match.group() == "(") - (match.group() == ")")
                if found[0] != ("mark", "("):
                    return [], start
                if not depth:
                    return found, match.end()
            at = match.end()

    def _expanded(self, words, token):
        """The tokens of words, (kind, word, names of the macros that it comes from) each, at the place of a
        token.
        """
        used = []
        while words:
            kind, word, seen = words.pop(0)
            macro = None
            if kind == "name" and word not in seen:
                macro = self.source.macros.get(word)
            if macro is None or macro.parameters is not None and (not words or words[0][1] != "("):
                used.append(Token(kind, word, token.file, token.line, token.column))
            else:
                words[:0] = self._body(macro, words, word, seen | {word})
            if len(used) + len(words) > MACRO:
                raise self.fault(f"a macro that grows too large: {token.word}")
        return used

    def _body(self, macro, words, name, seen):
        """The words of a macro, with its arguments, which are taken from the words that follow."""
        body = [part + (seen,) for part in macro.body]
        if macro.parameters is None:
            return body
        given = [[]]
        depth = 0
        while words:
            part = words.pop(0)
            depth += (part[1] == "(") - (part[1] == ")")
            if depth == 0:
                break
            if part[1] == "," and depth == 1:
                given.append([])
            elif part[1] != "(" or depth > 1:
                given[-1].append(part)
        if given == [[]] and not macro.parameters:
            given = []
        if depth or len(given) != len(macro.parameters):
            raise self.fault(f"a macro with {len(macro.parameters)} parameters: {name}")
        named = dict(zip(macro.parameters, given))
        return [part for each in body for part in named.get(each[1], [each])]

    # ---- preprocessor lines ------- ------------------------------------------------------------------------

    def _directive(self, line, active):
        name, rest = re.match(_DIRECTIVE, line, re.DOTALL).groups()
        rest = rest.strip()
        if name in ("if", "ifdef", "ifndef", "elif", "else", "endif"):
            self._condition(name, rest, active)
        elif active and name in ("include", "define", "undef", "pragma", "error"):
            getattr(self, "_" + name)(rest)
        elif active and name not in ("", "line", "ident", "warning"):
            raise self.fault(f"not known: #{name}")

    def _condition(self, name, rest, active):
        if name in ("if", "ifdef", "ifndef"):
            holds = active and self._holds(name, rest)
            self.conditions.append([holds, holds or not active, self.line, False])
            if len(self.conditions) > DEEPEST:
                raise self.fault("conditions within conditions too deep")
        elif not self.conditions or self.conditions[-1][3] and name != "endif":
            raise self.fault(f"#{name} without #if")
        elif name == "endif":
            self.conditions.pop()
        else:
            last = self.conditions[-1]
            last[0] = not last[1] and (name == "else" or self._holds("if", rest))
            last[1], last[3] = last[1] or last[0], name == "else"

    def _holds(self, name, rest):
        if name == "if":
            return bool(_Condition(self, rest).value())
        word = re.match(_NAME, rest)
        if word is None:
            raise self.fault(f"#{name} needs a name")
        return (word.group() in self.source.macros) == (name == "ifdef")

    def _define(self, rest):
        word = re.match(_NAME, rest)
        if word is None:
            raise self.fault("#define needs a name")
        body = rest[word.end() :]
        parameters = None
        if body[:1] == "(":
            listed = re.match(_PARAMETERS, body, re.ASCII)
            if listed is None:
                raise self.fault(f"a macro that cannot be read: {word.group()}")
            parameters = re.findall(_NAME, listed.group())
            body = body[listed.end() :]
        parts = []
        at = 0
        while at < len(body):
            match = _TOKEN.match(body, at)
            if match is None or match.lastgroup == "directive":
                raise self.fault(f"a macro that cannot be read: {word.group()}")
            if match.lastgroup not in ("space", "comment"):
                parts.append((match.lastgroup, match.group()))
            at = match.end()
        self.source.macros[word.group()] = Macro(parameters, parts)

    def _undef(self, rest):
        self.source.macros.pop(rest, None)

    def _error(self, rest):
        raise self.fault("#error " + printable(rest))

    def _pragma(self, rest):
        self.source.found.append(Token("pragma", rest, self.path, self.line, self.at - self.line_start + 1))

    def _include(self, rest):
        match = re.match(r'"([^"]+)"|<([^>]+)>', rest)
        if match is None:
            raise self.fault("#include needs a file")
        name = match.group(1) or match.group(2)
        own = os.path.basename(name)
        path = self._included(name, match.group(1) is not None)
        if path is None and own in idl.FILES:
            self.source.found.append(Token("own", own, self.path, self.line, 1))
            return
        if path is None and self.source.find:
            path = self.source.find(name)
        if path is None and own in OF_ORBS:
            return
        if path is None:
            raise self.fault(f"no such file to include: {printable(name)} (-I DIR names where to look)")
        self.source.found.append(Token("file", "begin", self.path, self.line, 1))
        self.source.file(path, self.depth + 1)
        self.source.found.append(Token("file", "end", self.path, self.line, 1))

    def _included(self, name, beside):
        """The path of a file to include: beside this one, or in the directories given; or None."""
        places = [os.path.dirname(self.path)] * beside + self.source.include
        return next(filter(os.path.isfile, (os.path.join(place, name) for place in places)), None)


class _Condition:
    """The expression of an #if: numbers, defined(NAME), ! && || comparisons and brackets."""

    def __init__(self, file, text):
        self.file = file
        self.words = []
        at = 0
        while text[at:].strip():
            match = re.compile(_CONDITION, re.ASCII).match(text, at)
            if match is None or len(self.words) > 200:
                raise file.fault(f"a condition that cannot be read: #if {printable(text[:60])}")
            self.words.append(self._meant(*match.groups()))
            at = match.end()
        self.words.reverse()

    def _meant(self, _, bracketed, bare, name, number, mark):
        """The meaning of a word of the condition: a mark, or a number."""
        macros = self.file.source.macros
        if mark:
            return mark
        if bracketed or bare:
            return int((bracketed or bare) in macros)
        try:
            if number:
                return whole(number)
            return _of_macro(macros.get(name))
        except ValueError as e:
            raise self.file.fault(f"a condition that cannot be read: {e}")

    def value(self):
        value = self._either(0)
        if self.words:
            raise self.file.fault("a condition that cannot be read")
        return value

    def _next(self, *marks):
        if self.words and self.words[-1] in marks and isinstance(self.words[-1], str):
            return self.words.pop()
        return None

    def _either(self, depth):
        value = self._both(depth)
        while self._next("||"):
            value = int(bool(self._both(depth)) or bool(value))
        return value

    def _both(self, depth):
        value = self._comparison(depth)
        while self._next("&&"):
            value = int(bool(self._comparison(depth)) and bool(value))
        return value

    def _comparison(self, depth):
        value = self._one(depth)
        mark = self._next("==", "!=", "<=", ">=", "<", ">")
        if mark is None:
            return value
        other = self._one(depth)
        return int(
            {
                "==": value == other,
                "!=": value != other,
                "<=": value <= other,
                ">=": value >= other,
                "<": value < other,
                ">": value > other,
            }[mark]
        )

    def _one(self, depth):
        if depth > DEEPEST or not self.words:
            raise self.file.fault("a condition that cannot be read")
        mark = self._next("!", "(", "-", "+")
        if mark == "(":
            found = self._either(depth + 1)
            if not self._next(")"):
                raise self.file.fault("a condition without its )")
            return found
        if mark:
            found = self._one(depth + 1)
            if mark == "!":
                return int(not found)
            if mark == "-":
                return -found
            return found
        word = self.words.pop()
        if isinstance(word, str):
            raise self.file.fault("a condition that cannot be read")
        return word


def _of_macro(macro):
    """The number that a macro means in a condition; 0, as in C, for anything else. Raises ValueError."""
    word = "0"
    if macro is not None and len(macro.body) == 1 and macro.body[0][0] == "number":
        word = macro.body[0][1]
    if is_whole(word):
        return whole(word)
    return 0


def is_whole(word):
    """Whether a word spells a whole number."""
    return word[:2] in ("0x", "0X") or word.isdigit()


def whole(word):
    """The whole number that a word spells as in C: 10, 0x0a, 012. Raises ValueError."""
    if len(word) > LONGEST_NUMBER:
        raise ValueError("too long a number")
    if word[:2] in ("0x", "0X"):
        return int(word, 16)
    return int(word, 8 if word[0] == "0" else 10)
