"""The upper part of a mounted RTC Tree: its root, name servers, naming contexts, and what is bound
in them.
"""

import posixpath
import re
import stat

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.mount.nodes import NOTHING, Absent, Directory, File, Link, Text, file_name, relative
from rtshell_lite.path import parse
from rtshell_lite.robot import naming, tree
from rtshell_lite.robot.node import bound

HOST = re.compile(r"[\w[][\w.:\]-]*\Z")  # not .git, .hidden …, for which programs look everywhere
MOST_SERVERS = 64  # that the root lists because somebody has named them
README = """This is the RTC Tree, the tree of OpenRTM-aist components, as files. One value a file.

  HOST[:PORT]/CONTEXTS/NAME.rtc/            a component; name servers not in RTCTREE_NAMESERVERS
                                            appear when they are named
    state                                   Inactive, Active, Error ...; write Active, Inactive or reset
    instance_name, type_name, category, vendor, version, description
    profile.json                            all of it, as rtcat --json prints it
    properties/KEY
    ports/PORT/type, data_type, properties/KEY, interfaces/NAME/type
    ports/PORT/connections/NAME             a link to the far port; ln -s connects, rm disconnects
    configuration/active                    the active set; write a name
    configuration/SET/PARAM                 read, write
    contexts/N/state, rate, kind, owner     Running or Stopped, Hz; state and rate can be written
    members/NAME                            of a composite: links
  HOST[:PORT]/CONTEXTS/NAME.mgr/            a manager
    components/NAME                         links to where they are bound, or the component itself
    loaded, factories                       modules and what they make, one a line
    create                                  write MODULE?instance_name=NAME
  HOST[:PORT]/CONTEXTS/DEAD.rtc             a zombie: a link that leads nowhere; rm deletes its name
  errors                                    the last hundred failures, in words

Not listed, as they wait, connect, change something or cost much; they can be opened by name:

  ports/PORT/value                          of an in port: write a value, and the write returns when it has
                                            been read; of an out port: the next value
  ports/PORT/values                         of an out port: one value a line, for ever
  ports/PORT/interfaces/NAME/OPERATION      of a provided interface whose IDL is known (RTSHELL_IDL): write a
                                            line of JSON, the argument or an object of all, and read what
                                            it returns from the same open file
  events, log                               of a component, as rtwatch and rtvlog print them
  loadable                                  of a manager: modules to load; it runs a process for each

A write returns when the change has happened, or fails. Control characters, slashes and backslashes in names
and values are escaped as in the paths of rtls, and read back: \\n is \\x0a, / in a name \\x2f, an empty name
\\e.
More: man rtmount.
"""


class Local(File):
    """A file whose text is known here."""

    __slots__ = ("_text",)

    def __init__(self, above, name, text):
        super().__init__(above, name)
        self._text = text

    @property
    def size(self):
        return len(self._text().encode())

    @property
    def seconds(self):
        return 0

    async def content(self):
        return self._text()


class Root(Directory):
    """The root: name servers, README and errors."""

    __slots__ = ()
    path = ""

    def __init__(self, mount):
        super().__init__(None, "")
        self.mount = mount

    @property
    def where(self):
        return self.mount.directory

    def entries(self, value):
        named = [name for name, node in self.known.items() if type(node) is ServerDirectory]
        servers = {
            file_name(address): address for address in tree.servers() if _server_path(file_name(address))
        }
        servers.update((name, self.known[name].address) for name in named[:MOST_SERVERS])
        entries = {name: (ServerDirectory, servers[name]) for name in sorted(servers)}
        entries["README"] = (Local, lambda: README)
        entries["errors"] = (Local, lambda: "".join(self.mount.errors))
        return entries

    async def find(self, name):
        if name in self.entries(()):
            return self.pick(name, ())
        path = _server_path(name)
        if path is None or not HOST.match(name):
            raise Absent(self.where + "/" + name)
        await bound(tree.name_server(path.server))
        return self.child(name, (ServerDirectory, path.server))


def _server_path(name):
    """The Path of the name server that a file's name means, or None."""
    try:
        path = parse("/" + name)
    except errors.BadPath:
        return None
    if path.server is not None and not path.names and file_name(path.server) == name:
        return path
    return None


class ContextDirectory(Directory):
    """A naming context."""

    __slots__ = ("node", "_bindings")
    mode = stat.S_IFDIR | 0o755

    def __init__(self, above, name, node):
        super().__init__(above, name)
        self.node = node
        self._bindings = {}
        self.source = self.mount.answer(self.peer, self._listed)
        self.mount.contexts.setdefault(orb.identity(node.ref), self)

    def renew(self, node):
        if not orb.same(self.node.ref, node.ref):
            self.expire()
            self.mount.contexts[orb.identity(node.ref)] = self
        self.node = node

    def peer(self):
        return self.node.endpoint, self.node.path

    async def _listed(self):
        return await self.mount.liveness.check(await tree.children(self.node))

    def entries(self, nodes):
        return {file_name(node.path.names[-1]): self._made(node) for node in nodes}

    async def find(self, name):
        path = self._path_of(name)
        is_shortened = path is None and "\\~" in name
        if self.source.is_fresh() or is_shortened:
            return await super().find(name)
        if path is None:
            raise Absent(self.where + "/" + name)
        answer = self._bindings.get(name)
        if answer is None:
            self._bindings = {name: answer for name, answer in self._bindings.items() if answer.is_fresh()}
            answer = self._bindings[name] = self.mount.answer(self.peer, lambda: self._ask_for(path))
        return self.child(name, self._made(await answer.get()))

    async def _ask_for(self, path):
        try:
            node = await tree.resolve(path)
        except errors.NotFound as e:
            raise Absent(e.where)
        (node,) = await self.mount.liveness.check([node])
        return node

    def expire(self):
        """Believe nothing of what is bound here."""
        self.source.expire()
        self._bindings = {}

    def _path_of(self, name):
        """The Path that a file's name means, or None."""
        try:
            names = parse("/server/" + name).names
        except errors.BadPath:
            return None
        if len(names) == 1 and file_name(names[0]) == name:
            return self.node.path.child(names[0])
        return None

    def _made(self, node):
        """(class, arguments) for what is bound here."""
        if node.kind == "directory":
            directory = self._entered(node)
            if directory is not None:
                return Link, relative(directory.path, self)
            if len(node.path.names) > tree.DEPTH:
                return Link, f"more than {tree.DEPTH} directories deep"
            return ContextDirectory, node
        if node.kind == "zombie":
            return Zombie, node
        from rtshell_lite.mount.components import ComponentDirectory  # much, which the first ls does not need
        from rtshell_lite.mount.managers import ManagerDirectory

        if node.kind == "manager" or node.kind == "unsure" and node.path.names[-1].kind == "mgr":
            return ManagerDirectory, node
        if node.kind == "unknown":
            return Text, NOTHING, lambda _: node.what + "\n"
        return ComponentDirectory, node

    def _entered(self, node):
        """The directory by which the kernel knows the context `node` already, or None: a tree must end."""
        directory = self.mount.contexts.get(orb.identity(node.ref))
        if directory is None or directory.path == posixpath.join(self.path, file_name(node.path.names[-1])):
            return None
        return directory


class ServerDirectory(ContextDirectory):
    """The root of a name server."""

    __slots__ = ("address",)

    def __init__(self, above, name, address):
        self.address = address
        super().__init__(above, name, tree.name_server(address))

    def renew(self, address):
        pass


class Zombie(Link):
    """The name of a component that is gone."""

    __slots__ = ()

    async def target(self):
        return "zombie: its object is gone"

    async def remove(self):
        await naming.delete_zombie(self._target.path)
