r"""Paths of the RTC Tree: how they are parsed and spelt.

/SERVER/CONTEXT.kind/…/NAME.kind:PORT, where SERVER is host, host:2809 or [::1]:2809. A name is split into id
and kind at its last dot, as in OpenRTM. `.`, `..` and a working directory (RTCSH_CWD) work as in a file
system. A backslash makes the next character an ordinary one (`\/ \: \. \\`), \xHH \uHHHH \UHHHHHHHH name a
character by its code, and \e is an empty name. Spelling a path (`str`) and parsing it again gives the same
path.

Without a name server: corbaloc:iiop:HOST:PORT/KEY/…/NAME:PORT and IOR:…, whose SERVER is that object.
OpenRTM's own rtcname://HOST/CONTEXT.kind/NAME.PORT and rtcloc://HOST:PORT/CATEGORY/NAME are read, too
(docs/protocol.md 4a). In names and in the place of a server, * is any one and ** any number of them:
robot/lookup.py finds what is meant.
"""

import os

from rtshell_lite import errors
from rtshell_lite.records import Record, cached, item
from rtshell_lite.text import is_plain, printable, typed, unescaped

DEFAULT_PORT = 2809
# name servers behind HTTP: the rest of the path follows a '#'
SCHEMES = ("http://", "https://", "ws://", "wss://")
PROTOCOLS = ("iiop", "ssliop", "diop", "shmiop", "htiop")
MANAGER_PORT = 2810  # corba.master_manager
# objects that are reached without a name server, in the place of a server
REFERENCES = ("corbaloc:", "IOR:")
KINDS = (".rtc", ".mgr", "_cxt", ".cxt")  # of the names of components, managers and naming contexts
# after its groups: the address, and the rest with the key
CORBALOC = r"corbaloc:(?:iiop)?:(?:1\.[0-9]@)?(\[[^\]]*\](?::\d+)?|[^/:]+(?::\d+)?)(?:/(.+))?\Z"
ANY = ("*", "**")
_ABSOLUTE = ("/",) + REFERENCES
_NO_HOST = REFERENCES + SCHEMES
# OpenRTM's own begin so
_OPENRTM = ("rtcname", "rtcloc")
_OPENRTM_PATH = r"(rtcname|rtcloc)(?:\.iiop)?(\.\w+)?://"


class Name(Record):
    """A name in a naming context, `id.kind` (CosNaming::NameComponent). Both are text, not wire strings."""

    __slots__ = ()
    _fields = ("id", "kind")
    id = item(0)
    kind = item(1)

    def __str__(self):
        if not self.id and not self.kind:
            return "\\e"
        if self.kind:
            return _spelt(self.id) + "." + _spelt(self.kind, ".")
        return _spelt(self.id, ".")


class Path(Record):
    """A place in the RTC Tree.

    server     address as typed, None at the root
    names      tuple of Name, from the root naming context down
    port       port name or None
    directory  whether the path was written with a slash at its end
    """

    __slots__ = ()
    _fields = ("server", "names", "port", "directory")
    server = item(0)
    names = item(1)
    port = item(2)
    directory = item(3)

    def __str__(self):
        if self.server is None:
            return "/"
        text = "/".join([_spelt_server(self.server), *map(str, self.names)])
        return text if self.port is None else f"{text}:{_spelt(self.port)}"

    def child(self, name):
        """The path of `name` (a Name) in this directory."""
        return Path(self.server, self.names + (name,), None, False)

    def parent(self):
        """The directory that holds this object; the root is its own parent."""
        return Path(self.server, self.names[:-1], None, False) if self.names else ROOT

    def object(self):
        """The same path without its port."""
        return Path(self.server, self.names, None, False)

    @property
    def is_bound(self):
        """Whether a naming context holds this name: not where a manager lists it, or after a corbaloc."""
        if not self.server or self.server.startswith(REFERENCES):
            return False
        return all(name.kind != "mgr" for name in self.names[:-1])

    @property
    def instance(self):
        """The name before the ports of a component that is bound so; "" for one without a name."""
        return self.names[-1].id if self.names else ""

    def with_port(self, port):
        """The path of the port called `port` of this component."""
        return Path(self.server, self.names, port, False)


ROOT = Path(None, (), None, False)


def _spelt(s, more=""):
    """`s` with everything escaped that has a meaning in a path."""
    if s.isalnum() and is_plain(s):  # most are
        return s
    s = printable(s)
    for c in "/:" + more:
        s = s.replace(c, "\\" + c)
    return s


def _spelt_server(server):
    if server.startswith(REFERENCES):
        return printable(server)
    if server.startswith(SCHEMES):
        return "/" + printable(server) + "#"
    return "/" + printable(server).replace("/", "\\/")


def parse(text, cwd=None):
    """The Path that a user typed. `cwd` is where relative paths start (default: $RTCSH_CWD). Raises BadPath.

    An empty path is the working directory, as for rtshell.
    """
    if is_absolute(text):
        above = ROOT
    elif cwd is None:
        above = working_directory()
    else:
        above = _directory(cwd)
    return follow(above, elements(text), text)


def follow(above, elements, text):
    """The Path that `elements` lead to from a directory, a Path; `text`: the path as typed, for errors.
    Raises BadPath.
    """
    kept = []  # type: list
    for element in elements:
        if element in ("", "."):
            continue
        if element != "..":
            kept.append(element)
        elif kept:
            kept.pop()
        else:
            above = above.parent()
    is_directory = elements[-1] in ("", ".", "..")
    if not kept:
        if above.server is None:
            return ROOT
        return Path(above.server, above.names, None, is_directory)
    server = above.server
    if server is None:
        server = _server(kept.pop(0), text)
    if not kept:
        server, port = _split_reference(server, text)
        return Path(server, (), port, is_directory)
    last, port = _split_port(kept.pop(), text)
    if port is not None and is_directory:
        raise errors.BadPath(text, "a port has no directory below it")
    names = [_name(element, text) for element in kept]
    return Path(server, (*above.names, *names, _name(last, text)), port, is_directory)


def working_directory():
    """The Path of $RTCSH_CWD, where relative paths start. Raises BadPath."""
    return _directory(os.environ.get("RTCSH_CWD") or "/")


@cached(10)
def _directory(cwd):
    """The Path of a working directory, kept: all relative paths of a command start there."""
    if not is_absolute(cwd):
        raise errors.BadPath(cwd, "a working directory (RTCSH_CWD) starts with /")
    try:
        path = follow(ROOT, elements(cwd), cwd)
        if path.port is not None:
            raise errors.BadPath(cwd, "a port has no directory below it")
    except errors.BadPath as e:
        raise errors.BadPath(cwd, f"{e.args[1]} (it is the working directory, RTCSH_CWD)")
    return path._replace(directory=False)


def is_absolute(text):
    """Whether a path as typed does not start at the working directory."""
    return text.startswith(_ABSOLUTE) or _openrtm(text) is not None


def _openrtm(text):
    """The match of a path that begins as OpenRTM's own do, or None."""
    if not text.startswith(_OPENRTM):
        return None
    import re

    return re.match(_OPENRTM_PATH, text)


def _cut(text, separator):
    """Split at every unescaped `separator`; the pieces stay escaped."""
    if "\\" not in text:
        return text.split(separator)
    import re

    pieces = []
    start = 0
    for character in re.finditer(r"\\.|.", text, re.DOTALL):
        if character.group() == separator:
            pieces.append(text[start : character.start()])
            start = character.end()
    return pieces + [text[start:]]


def elements(text):
    """The elements of a path as typed, still escaped. Raises BadPath."""
    return _elements(_standard(typed(text)) or ".")


def _elements(text):
    """The elements between the slashes, still escaped; the first one is empty for an absolute path."""
    bare = text.lstrip("/")
    if bare.startswith(SCHEMES):
        server, _, rest = bare.partition("#")
        return [server] + _cut(rest, "/") if rest else [server]
    if bare.startswith(REFERENCES):
        return _reference(bare)
    return _cut(text, "/")


# ---- without a name server ----


def _standard(text):
    """OpenRTM's rtcname:// and rtcloc:// as a path of ours; other text as it is."""
    match = _openrtm(text)
    if not match:
        return text
    form, protocol = match.groups()
    host, _, rest = text[match.end() :].partition("/")
    if protocol or not host or not rest:
        raise errors.BadPath(text, "not rtcname://HOST[:PORT]/…/NAME or rtcloc://HOST[:PORT]/CATEGORY/NAME")
    above, slash, last = rest.rpartition("/")
    if ":" not in last and not last.endswith((".rtc", ".mgr")):
        name, dot, port = last.partition(".")
        last = name + ".rtc"
        if dot:
            last += ":" + port
    if form == "rtcname":
        import re

        above = re.sub(r"\*(?=/|\Z)", "**", above)  # looked for in all directories below
        return "/" + host + "/" + above + slash + last
    if host in ANY:
        raise errors.BadPath(text, "name the host of the manager")
    return f"corbaloc:iiop:{host}/manager/{last}"


def _reference(text):
    """The elements of a path that begins with an object; the first one is not escaped."""
    import re

    first, *below = _cut(text, "/")
    if text.startswith("IOR:"):
        return [first] + below
    match = re.match(CORBALOC, text, re.DOTALL)
    if not match or split_address(match.group(1))[1] is None:
        raise errors.BadPath(printable(text), "not corbaloc:iiop:HOST[:PORT][/KEY]")
    address, rest = match.groups()
    key, *below = _cut(rest or "manager", "/")
    if key == "NameService":
        return ["", address] + below
    # keys of components may have a slash in them: CATEGORY/NAME
    while key != "manager" and below and not re.search(r"\.(rtc|mgr)(:|\Z)", below[0]):
        key += "/" + below.pop(0)
    if ":" not in address:
        address += f":{MANAGER_PORT}"
    return [f"corbaloc:iiop:{address}/{key}"] + below


def _split_reference(server, text):
    """(server, port) where the server is an object, and a port of that may follow."""
    if not server.startswith(REFERENCES):
        return server, None
    start = max(server.rfind("/"), 3) + 1
    head, colon, port = server[start:].partition(":")
    if colon and not port:
        raise errors.BadPath(text, "no port after the colon")
    if server.startswith("IOR:") and not _is_hexadecimal(head):
        raise errors.BadPath(text, "not a stringified reference (IOR:…)")
    return server[:start] + head, port or None


def _is_hexadecimal(text):
    return bool(text) and len(text) % 2 == 0 and not text.strip("0123456789abcdefABCDEF")


# ---- elements ----


def _server(element, text):
    """A server address; its colons belong to it."""
    address = _unescaped(element, text)
    if address.startswith(_NO_HOST) or address.partition(":")[0] in PROTOCOLS:
        return address
    host, port = split_address(address)
    if host in ("", ".", "..") or port is None:
        raise errors.BadPath(text, _why_no_server(address))
    return address


def has_kind(name):
    """Whether a name has one of the kinds that OpenRTM gives to components, managers and naming contexts."""
    return name.endswith(KINDS)


def _why_no_server(address):
    host, _, port = address.partition(":")
    if has_kind(host):
        return "it begins with no name server; RTSHELL_FIND=1 finds a component by its name alone"
    if host and port and ":" not in port and not address.startswith("["):
        return f"{port} is not a TCP port (1 to 65535)"
    if address.count(":") > 1 and not address.strip("0123456789abcdefABCDEF:."):
        before, _, last = address.rpartition(":")
        if len(last) > 4 and last.isdigit():  # no part of an address
            return f"an IPv6 address is written in brackets: /[{before}]:{last}"
        return f"an IPv6 address is written in brackets: /[{address}]"
    return f"{address} is not a name server (host or host:tcpport)"


@cached(100)
def split_address(address):
    """(host, TCP port) of `host`, `host:port`, `[v6]`, `[v6]:port`;
    the port is None where it is not a TCP port.
    """
    bracket = address.find("]") + 1 if address.startswith("[") else 0
    host, colon, port = address[bracket:].partition(":")
    is_number = port and len(port) <= 5 and not port.strip("0123456789")
    if bracket and host or colon and not is_number:
        return address, None
    number = int(port) if colon else DEFAULT_PORT
    return address[:bracket] + host, number if 0 < number < 65536 else None


def _split_port(element, text):
    name, *port = _cut(element, ":")
    if not port:
        return name, None
    if port == [""] and name:
        raise errors.BadPath(text, "no port after the colon")
    if len(port) > 1 or not port[0] or not name:
        raise errors.BadPath(text, "a single colon separates a component from its port; write \\: in a name")
    return name, _unescaped(port[0], text)


def _name(element, text):
    """Split at the last unescaped dot."""
    if element == "\\e":
        return Name("", "")
    *head, kind = _cut(element, ".")
    if not head:
        return Name(_unescaped(kind, text), "")
    return Name(_unescaped(".".join(head), text), _unescaped(kind, text))


def _unescaped(s, text):
    try:
        return unescaped(s)
    except ValueError as e:
        raise errors.BadPath(text, str(e))
