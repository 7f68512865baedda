"""What every file, link and directory of a mounted RTC Tree has in common,
and how names are spelt as names of files.
"""

import collections
import posixpath
import stat
import sys
import weakref

from rtshell_lite import errors, notes
from rtshell_lite.corba import session
from rtshell_lite.mount.attempt import attempt
from rtshell_lite.mount.cache import Cache, CachedAnswer, Known
from rtshell_lite.mount.liveness import Liveness
from rtshell_lite.net import loop
from rtshell_lite.path import parse
from rtshell_lite.text import printable, safe, unescaped

NAME_MAX = 255  # bytes of a file's name
SWEEP = 1.0  # seconds between two looks for what is not needed any more
# bytes that a file of unknown size claims, as in /sys: what claims 0 is not read by some programs
SIZE = 4096
# failures that DIR/errors shows, characters of each
MOST_ERRORS = 100
LONGEST = 2000
NOTHING = Known(())


class Absent(errors.NotFound):
    message = "{}: no such path"  # a name that its directory does not have: no failure worth keeping


class Mount:
    """What all nodes of a mount share.

    directory  its absolute path; `ttl` seconds for which names and profiles are believed
    tasks      a loop.Group: whatever is done for the mount is done in it; nothing may fail there
    errors     the last failures, as lines
    contexts   directories of naming contexts by the identity of these
    """

    def __init__(self, directory, ttl, read_only=False, listener=None):
        """`listener`, like that of notes.py, is called for each failure and remark; or None."""
        self._listener = listener
        self.directory = directory
        self.ttl = ttl
        self.read_only = read_only
        self.tasks = loop.Group()
        self.cache = Cache(self.tasks)
        self.liveness = Liveness(self.tasks, ttl, self.fail)
        self._changes = {}  # {where: deque of the changes to make there}
        self.errors = collections.deque(maxlen=MOST_ERRORS)
        self.contexts = weakref.WeakValueDictionary()
        self.began = int(loop.wall())

    def hear(self, kind, what):
        """The listener of notes.py while the mount is served:
        DIR/errors keeps failures and remarks, not details.
        """
        if kind == notes.DETAIL:
            self._tell(kind, what)
        else:
            self.complain(str(what), kind)

    def fail(self, error):
        """Keep an exception as `complain` does."""
        if isinstance(error, errors.Error):
            self.complain(str(error))
        else:
            self.complain(f"internal error: {type(error).__name__}: {printable(str(error))}")

    def complain(self, sentence, kind=notes.FAILURE):
        """Keep a failure for DIR/errors; report it, too, if somebody listens."""
        sentence = safe(sentence[:LONGEST])
        self.errors.append(sentence + "\n")
        self._tell(kind, sentence)

    def _tell(self, kind, what):
        if self._listener is not None:
            self._listener(kind, what)

    def answer(self, peer, ask, seconds=None):
        """A CachedAnswer that is believed for `seconds`, by default the ttl."""
        return CachedAnswer(self.cache, peer, ask, self.ttl if seconds is None else seconds)

    def change(self, where, function):
        """Run a coroutine function after those that have been given before for the same place."""
        waiting = self._changes.get(where)
        if waiting is not None:
            waiting.append(function)
            return
        self._changes[where] = collections.deque([function])
        self.tasks.start(self._make_changes(where))

    async def _make_changes(self, where):
        waiting = self._changes[where]
        while waiting:
            _, error = await attempt(waiting.popleft()())
            if error is not None:
                self.fail(error)
        del self._changes[where]

    async def tidy(self):
        """Free what is not needed any more, again and again."""
        while True:
            await loop.sleep(SWEEP)
            self.cache.sweep()
            self.liveness.sweep()
            session.current().sweep()


# ---- names ----


def file_name(name):
    """`name`, a text or a path.Name, as the name of a file:
    escaped as in our paths, and if it is too long, shortened.
    """
    spelt = printable(name) if isinstance(name, str) else str(name).replace("\\/", "/")
    spelt = {"": "\\e", ".": "\\.", "..": "\\.\\."}.get(spelt) or spelt.replace("/", "\\x2f")
    raw = spelt.encode("utf-8")
    if len(raw) <= NAME_MAX:
        return spelt
    import zlib

    return "%s\\~%08x" % (raw[: NAME_MAX - 12].decode("utf-8", "ignore"), zlib.crc32(raw))


def unique(names):
    """File names for all these names, in their order; the second of the same name is NAME~2."""
    taken = set()
    for name in names:
        spelt = file_name(name)
        number = 1
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


# ---- nodes ----


class FileNode:
    """A file, a link or a directory. `id` is the kernel's number of it, 0 while it knows none;
    `lookups` how often it asked.
    """

    __slots__ = ("id", "above", "name", "lookups")
    mode = 0
    is_part = True  # of the tree: others may look different after it has been changed

    def __init__(self, above, name):
        self.id = 0
        self.above = above
        self.name = name
        self.lookups = 0

    def renew(self, *arguments):
        """The same name has been found again, by its directory, with these arguments."""

    @property
    def size(self):
        return 0

    @property
    def seconds(self):
        """How long the kernel may believe its name and size."""
        return self.mount.ttl

    def peer(self):
        """(endpoint, where) of the peer that its changes are asked of."""
        return self.above.peer()

    @property
    def path(self):
        """Its path below the mount."""
        return posixpath.join(self.above.path, self.name)

    @property
    def where(self):
        """What errors call it."""
        return posixpath.join(self.mount.directory, self.path)

    def own(self, named):
        """What a dict has for its name. Raises Absent."""
        if self.name not in named:
            raise Absent(self.where)
        return named[self.name]


class File(FileNode):
    """A regular file of text."""

    __slots__ = ()
    mode = stat.S_IFREG | 0o444

    @property
    def mount(self):
        return self.above.mount

    @property
    def size(self):
        return SIZE

    async def content(self):
        """Its text. Raises errors.Error."""
        raise NotImplementedError

    async def store(self, text):
        """Do what is written to it. Raises errors.Error."""
        raise errors.Refused(self.where, "cannot be written to")

    def open(self):
        """An open file of its own kind, or None for one that reads its text."""
        return None


class Text(File):
    """A file made of the value of a CachedAnswer by a function."""

    __slots__ = ("_source", "_render")

    def __init__(self, above, name, source, render=str):
        super().__init__(above, name)
        self._source = source
        self._render = render

    async def content(self):
        return self._render(await self._source.get())


class Control(Text):
    """A Text that can be written to: store(text), a coroutine function, does what that says."""

    __slots__ = ("_store",)
    mode = stat.S_IFREG | 0o644

    def __init__(self, above, name, source, render, store):
        super().__init__(above, name, source, render)
        self._store = store

    async def store(self, text):
        await self._store(text)


class Item(File):
    """A file with one of the `texts` of its directory."""

    __slots__ = ()

    async def content(self):
        return line(self.own(self.above.texts(await self.above.source.get())))


class WritableItem(Item):
    """An Item whose directory stores what is written to it."""

    __slots__ = ()
    mode = stat.S_IFREG | 0o644

    async def store(self, text):
        await self.above.store(self.name, meant(text, self.where))


class Link(FileNode):
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
        (self._target,) = arguments

    async def target(self):
        """The text. Raises errors.Error."""
        return self._target

    async def remove(self):
        """Do what rm asks for. Raises errors.Error."""
        raise errors.Refused(self.where, "cannot be removed")


class Directory(FileNode):
    """A directory, made of what `source`, a CachedAnswer, has. `known` are its nodes that the kernel knows,
    by name.
    """

    __slots__ = ("mount", "known", "source", "__weakref__")
    mode = stat.S_IFDIR | 0o555

    def __init__(self, above, name, source=NOTHING):
        super().__init__(above, name)
        self.mount = above and above.mount
        self.known = {}
        self.source = source

    def entries(self, value):
        """{file name: (class, its arguments)} of what it lists, given the value of `source`."""
        raise NotImplementedError

    def hidden(self, value):
        """What can be opened by name, but is not listed, as reading it connects, blocks,
        changes something or costs much.
        """
        return {}

    async def list(self):
        """Its nodes, in their order."""
        return [self.child(*item) for item in self.entries(await self.source.get()).items()]

    async def find(self, name):
        """The node called `name`. Raises Absent."""
        return self.pick(name, await self.source.get())

    def pick(self, name, value):
        """`find`, given the value of `source`."""
        form = self.entries(value).get(name) or self.hidden(value).get(name)
        if form is None:
            raise Absent(posixpath.join(self.where, name))
        return self.child(name, form)

    def child(self, name, form):
        """The node called `name` for (class, arguments): the one that the kernel knows, or a new one."""
        kind, *arguments = form
        node = self.known.get(name)
        if type(node) is kind:
            node.renew(*arguments)
            return node
        return kind(self, name, *arguments)

    async def make_link(self, name, target):
        """Do what ln -s asks for, and return the Link. Raises errors.Error."""
        raise errors.Refused(posixpath.join(self.where, name), "no links can be made here")


class Items(Directory):
    """A directory of texts: `texts_of(value)` gives (name, text) pairs."""

    __slots__ = ("_texts_of",)

    def __init__(self, above, name, source, texts_of):
        super().__init__(above, name, source)
        self._texts_of = texts_of

    def texts(self, value):
        """{file name: text}"""
        pairs = list(self._texts_of(value))
        return dict(zip(unique(name for name, _ in pairs), [text for _, text in pairs]))

    def entries(self, value):
        return {name: (Item,) for name in self.texts(value)}


# ---- links between objects ----


def link_text(path, above):
    """A path of our own as text, which may be `Unknown (…)`,
    as the target of a link in the directory `above`.
    """
    try:
        parsed = parse(path) if path.startswith("/") else None
    except errors.BadPath:
        parsed = None
    return relative(mounted(parsed), above) if parsed else path


def mounted(path):
    """Where a Path is below the mount."""
    names = [file_name(path.server), *map(file_name, path.names)] + (
        ["ports", file_name(path.port)] if path.port else []
    )
    return "/".join(names)


def relative(target, above):
    """A path below the mount as the target of a link in the directory `above`."""
    return posixpath.relpath("/" + target, "/" + above.path)
