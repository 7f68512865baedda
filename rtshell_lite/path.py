r"""Paths of the RTC Tree: how they are parsed and spelt.

/SERVER/CONTEXT.kind/…/NAME.kind:PORT, where SERVER is host, host:2809 or [::1]:2809. A name is split into id
and kind at its last dot, as in OpenRTM. `.`, `..` and a working directory (RTCSH_CWD) work as in a file
system. A backslash makes the next character an ordinary one (`\/ \: \. \\`), \xHH \uHHHH \UHHHHHHHH name a
character by its code, and \e is an empty name. Spelling a path (`str`) and parsing it again gives the same
path.
"""

import collections
import os
import re

from rtshell_lite import errors
from rtshell_lite.text import is_plain, printable, typed, unescaped

DEFAULT_PORT = 2809
# name servers behind HTTP: the rest of the path follows a '#'
SCHEMES = ("http://", "https://", "ws://", "wss://")
PROTOCOLS = ("iiop", "ssliop", "diop", "shmiop", "htiop")


class Name(collections.namedtuple("Name", "id kind")):
    """A name in a naming context, `id.kind` (CosNaming::NameComponent). Both are text, not wire strings."""

    __slots__ = ()

    def __str__(self):
        if not self.id and not self.kind:
            return "\\e"
        if self.kind:
            return _spelt(self.id) + "." + _spelt(self.kind, ".")
        return _spelt(self.id, ".")


class Path(collections.namedtuple("Path", "server names port directory")):
    """A place in the RTC Tree.

    server     address as typed, None at the root
    names      tuple of Name, from the root naming context down
    port       port name or None
    directory  whether the path was written with a slash at its end
    """

    __slots__ = ()

    def __str__(self):
        if self.server is None:
            return "/"
        text = "/" + _spelt_server(self.server) + "".join("/" + str(name) for name in self.names)
        if self.port is not None:
            text += ":" + _spelt(self.port)
        return text

    def child(self, name):
        """The path of `name` (a Name) in this directory."""
        return Path(self.server, self.names + (name,), None, False)

    def parent(self):
        """The directory that holds this object; the root is its own parent."""
        if not self.names:
            return ROOT
        return Path(self.server, self.names[:-1], None, False)

    def object(self):
        """The same path without its port."""
        return Path(self.server, self.names, None, False)

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
    if server.startswith(SCHEMES):
        return printable(server) + "#"
    return printable(server).replace("/", "\\/")


def parse(text, cwd=None):
    """The Path that a user typed. `cwd` is where relative paths start (default: $RTCSH_CWD). Raises BadPath.

    An empty path is the working directory, as for rtshell.
    """
    elements = _elements(typed(text) or ".")
    if not text.startswith("/"):
        elements = _elements(typed(_working_directory(cwd))) + elements
    directory = elements[-1] in ("", ".", "..")
    resolved = []  # type: list
    for element in elements:
        if element in ("", "."):
            continue
        if element == "..":
            del resolved[-1:]
        else:
            resolved.append(element)
    if not resolved:
        return ROOT
    server = _server(resolved[0], text)
    if len(resolved) == 1:
        return Path(server, (), None, directory)
    last, port = _split_port(resolved[-1], text)
    names = tuple(_name(element, text) for element in resolved[1:-1] + [last])
    if port is not None and directory:
        raise errors.BadPath(text, "a port has no directory below it")
    return Path(server, names, port, directory)


def _working_directory(cwd):
    if cwd is None:
        cwd = os.environ.get("RTCSH_CWD") or "/"
    if not cwd.startswith("/"):
        raise errors.BadPath(cwd, "a working directory (RTCSH_CWD) starts with /")
    return cwd


def _cut(text, separator):
    """Split at every unescaped `separator`; the pieces stay escaped."""
    if "\\" not in text:
        return text.split(separator)
    pieces = []
    start = 0
    for character in re.finditer(r"\\.|.", text, re.DOTALL):
        if character.group() == separator:
            pieces.append(text[start : character.start()])
            start = character.end()
    return pieces + [text[start:]]


def _elements(text):
    """The elements between the slashes, still escaped; the first one is empty for an absolute path."""
    if text.lstrip("/").startswith(SCHEMES):
        server, _, rest = text.lstrip("/").partition("#")
        return [server] + (_cut(rest, "/") if rest else [])
    return _cut(text, "/")


def _server(element, text):
    """A server address; its colons belong to it."""
    address = _unescaped(element, text)
    if address.startswith(SCHEMES) or address.partition(":")[0] in PROTOCOLS:
        return address
    host, port = split_address(address)
    if host in ("", ".", "..") or port is None:
        raise errors.BadPath(text, f"{address} is not a name server (host or host:tcpport)")
    return address


def split_address(address):
    """(host, TCP port) of `host`, `host:port`, `[v6]`, `[v6]:port`;
    the port is None where it is not a TCP port.
    """
    if address.startswith("["):
        bracket = address.find("]") + 1
    else:
        bracket = 0
    host, colon, port = address[bracket:].partition(":")
    is_number = port and len(port) <= 5 and not port.strip("0123456789")
    if bracket and host or colon and not is_number:
        return address, None
    if colon:
        number = int(port)
    else:
        number = DEFAULT_PORT
    return address[:bracket] + host, number if 0 < number < 65536 else None


def _split_port(element, text):
    name, *port = _cut(element, ":")
    if not port:
        return name, None
    if len(port) > 1 or not port[0] or not name:
        raise errors.BadPath(text, "bad path (one colon stands before a port; write \\: in a name)")
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
