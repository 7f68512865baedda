"""What every file, link and directory of a mounted RTC Tree has in common, and how names are spelt as names of files.

What needs remote answers is given as (Source, function): the function makes a file's text, a directory's entries and so on of
the Source's value, on any thread, without asking anybody.
"""
import collections
import posixpath
import stat
import sys
import threading
import time
import weakref

from rtshell_lite import errors
from rtshell_lite.mount.asking import Crew, Given, Kept, Source
from rtshell_lite.mount.census import Census
from rtshell_lite.path import parse
from rtshell_lite.text import printable, safe, unescaped

NAME_MAX = 255  # bytes of a file's name
SIZE = 4096  # bytes that a file of unknown size claims, as in /sys: what claims 0 is not read by some programs
MOST_ERRORS, LONGEST = 100, 2000  # failures that DIR/errors shows, characters of each
NOTHING = Given(())


class Absent(errors.NotFound):
    """{}: no such path"""  # a name that its directory does not have: no failure worth keeping


class Mount:
    """What all nodes of a mount share.

    directory  its absolute path; `ttl` seconds for which names and profiles are believed
    errors     the last failures, as lines
    lock       held by whoever looks at or changes the nodes that the kernel knows
    """

    def __init__(self, directory, ttl, read_only=False, report=lambda sentence: None):
        """`report` is called with each failure."""
        self.report = report
        self.directory, self.ttl, self.read_only = directory, ttl, read_only
        self.crew = Crew(self.fail)  # its threads are lanes, see `lanes.become_lane`
        self.changes = Crew(self.fail)  # its threads are none
        self.kept, self.lock = Kept(), threading.RLock()
        self.census = Census(self.changes, ttl)
        self.errors = collections.deque(maxlen=MOST_ERRORS)
        self.streams = set()  # that are connected
        self.contexts = weakref.WeakValueDictionary()  # directories of naming contexts by the identity of these
        self.began = int(time.time())

    def fail(self, error):
        """Keep an exception as `complain` does."""
        known = isinstance(error, errors.Error)
        self.complain(str(error) if known else f"internal error: {type(error).__name__}: {printable(str(error))}")

    def complain(self, sentence):
        """Keep a failure for DIR/errors; print it, too, if somebody listens."""
        sentence = safe(sentence[:LONGEST])
        self.errors.append(sentence + "\n")
        self.report(sentence)

    def source(self, place, ask, seconds=None):
        """A Source that is believed for `seconds`, by default the ttl."""
        return Source(self.crew, self.kept, place, ask, self.ttl if seconds is None else seconds)


# ---- names ----------------------------------------------------------------------------------------------------

def file_name(name):
    """`name`, a text or a path.Name, as the name of a file: escaped as in our paths, and if it is too long, shortened."""
    spelt = printable(name) if isinstance(name, str) else str(name).replace("\\/", "/")
    spelt = {"": "\\e", ".": "\\.", "..": "\\.\\."}.get(spelt) or spelt.replace("/", "\\x2f")
    raw = spelt.encode("utf-8")
    if len(raw) <= NAME_MAX:
        return spelt
    import zlib
    return "%s\\~%08x" % (raw[:NAME_MAX - 12].decode("utf-8", "ignore"), zlib.crc32(raw))


def unique(names):
    """File names for all these names, in their order; the second of the same name is NAME~2."""
    taken = set()
    for name in names:
        spelt, number = file_name(name), 1
        while spelt in taken:
            number += 1
            spelt = file_name(f"{name}~{number}")
        taken.add(spelt)
        yield sys.intern(spelt)  # components have the same ones


def line(text):
    """A text of a peer as the content of a file."""
    return printable(text) + "\n"


def meant(text, where):
    """The text that was written, with its escapes read as in our paths. Raises BadValue."""
    try:
        return unescaped(text)
    except ValueError as e:
        raise errors.BadValue(where, str(e))


# ---- nodes ----------------------------------------------------------------------------------------------------

class Node:
    """A file, a link or a directory. `id` is the kernel's number of it, 0 while it knows none; `lookups` how often it asked."""

    __slots__ = ("id", "above", "name", "lookups")
    mode = 0
    is_part = True  # of the tree: others may look different after it has been changed

    def __init__(self, above, name):
        self.id, self.above, self.name, self.lookups = 0, above, name, 0

    def renew(self, *arguments):
        """The same name has been found again, by its directory, with these arguments."""

    @property
    def size(self):
        return 0

    @property
    def seconds(self):
        """How long the kernel may believe its name and size."""
        return self.mount.ttl

    def place(self):
        """(endpoint, where) of the peer that its changes are asked of."""
        return self.above.place()

    @property
    def path(self):
        """Its path below the mount."""
        return posixpath.join(self.above.path, self.name)

    @property
    def where(self):
        """What errors call it."""
        return posixpath.join(self.mount.directory, self.path)


class File(Node):
    """A regular file of text. `content()`: its (Source, function)."""

    __slots__ = ()
    mode = stat.S_IFREG | 0o444

    @property
    def mount(self):
        return self.above.mount

    @property
    def size(self):
        return SIZE

    def content(self):
        raise NotImplementedError

    def store(self, text):
        """Do what is written to it, on a thread that may ask. Raises errors.Error."""
        raise errors.Refused(self.where, "cannot be written to")

    def open(self):
        """A Handle of its own kind, or None for one that reads its text."""
        return None


class Text(File):
    """A file made of the value of a Source by a function."""

    __slots__ = ("_source", "_render")

    def __init__(self, above, name, source, render=str):
        super().__init__(above, name)
        self._source, self._render = source, render

    def content(self):
        return self._source, self._render


class Control(Text):
    """A Text that can be written to: store(text) does what that says."""

    __slots__ = ("_store",)
    mode = stat.S_IFREG | 0o644

    def __init__(self, above, name, source, render, store):
        super().__init__(above, name, source, render)
        self._store = store

    def store(self, text):
        self._store(text)


class Item(File):
    """A file with one of the `texts` of its directory."""

    __slots__ = ()

    def content(self):
        return self.above.source, self._text

    def _text(self, value):
        try:
            return line(self.above.texts(value)[self.name])
        except LookupError:
            raise Absent(self.where)


class WritableItem(Item):
    """An Item whose directory stores what is written to it."""

    __slots__ = ()
    mode = stat.S_IFREG | 0o644

    def store(self, text):
        self.above.store(self.name, meant(text, self.where))


class Link(Node):
    """A symbolic link; `target` is the text that it leads to."""

    __slots__ = ("_target",)
    mode = stat.S_IFLNK | 0o777

    @property
    def mount(self):
        return self.above.mount

    def __init__(self, above, name, target):
        super().__init__(above, name)
        self._target = target

    def renew(self, *arguments):
        self._target, = arguments

    def target(self):
        """(Source, function) of the text."""
        return NOTHING, lambda _: self._target

    def remove(self):
        """Do what rm asks for. Raises errors.Error."""
        raise errors.Refused(self.where, "cannot be removed")


class Directory(Node):
    """A directory. `known` are its nodes that the kernel knows, by name."""

    __slots__ = ("mount", "known", "__weakref__")
    mode = stat.S_IFDIR | 0o555
    source = NOTHING  # what it is made of

    def __init__(self, above, name):
        super().__init__(above, name)
        self.mount = above and above.mount
        self.known = {}

    def entries(self, value):
        """{file name: (class, its arguments)} of what it lists, given the value of `source`."""
        raise NotImplementedError

    def hidden(self, value):
        """What can be opened by name, but is not listed, as reading it connects, blocks, changes something or costs much."""
        return {}

    def list(self):
        """(Source, function) of its nodes, in their order."""
        return self.source, lambda value: [self.child(*item) for item in self.entries(value).items()]

    def find(self, name):
        """(Source, function) of the node called `name`. The function raises Absent."""
        return self.source, lambda value: self._found(name, value)

    def _found(self, name, value):
        made = self.entries(value).get(name) or self.hidden(value).get(name)
        if made is None:
            raise Absent(posixpath.join(self.where, name))
        return self.child(name, made)

    def child(self, name, made):
        """The node called `name` for (class, arguments): the one that the kernel knows, or a new one."""
        kind, *arguments = made
        node = self.known.get(name)
        if type(node) is kind:
            node.renew(*arguments)
            return node
        return kind(self, name, *arguments)

    def make_link(self, name, target):
        """Do what ln -s asks for, and return the Link. Raises errors.Error."""
        raise errors.Refused(posixpath.join(self.where, name), "no links can be made here")


class Items(Directory):
    """A directory of texts: `texts_of(value)` gives (name, text) pairs."""

    __slots__ = ("source", "_texts_of")

    def __init__(self, above, name, source, texts_of):
        super().__init__(above, name)
        self.source, self._texts_of = source, texts_of

    def texts(self, value):
        """{file name: text}"""
        pairs = list(self._texts_of(value))
        return dict(zip(unique(name for name, _ in pairs), (text for _, text in pairs)))

    def entries(self, value):
        return {name: (Item,) for name in self.texts(value)}


# ---- links between objects ------------------------------------------------------------------------------------

def link_text(path, above):
    """A path of our own as text, which may be `Unknown (…)`, as the target of a link in the directory `above`."""
    try:
        parsed = parse(path) if path.startswith("/") else None
    except errors.BadPath:
        parsed = None
    return relative(mounted(parsed), above) if parsed else path


def mounted(path):
    """Where a Path is below the mount."""
    names = [file_name(path.server), *map(file_name, path.names)] + (["ports", file_name(path.port)] if path.port else [])
    return "/".join(names)


def relative(target, above):
    """A path below the mount as the target of a link in the directory `above`."""
    return posixpath.relpath("/" + target, "/" + above.path)
