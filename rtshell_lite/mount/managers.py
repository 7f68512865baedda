"""The files of a manager in a mounted RTC Tree."""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.mount.nodes import NOTHING, Control, Directory, Link, Text, line, link_text, unique
from rtshell_lite.robot import manager, places, tree

WAIT = 5.0  # seconds until what has been created must be ready, as with rtmgr --wait


class ManagerDirectory(Directory):
    """A manager."""

    __slots__ = ("node",)

    def __init__(self, above, name, node):
        super().__init__(above, name)
        self.node = node

    def renew(self, node):
        self.node = node

    def peer(self):
        return self.node.endpoint, self.node.path

    def entries(self, value):
        return {
            "components": (ManagedDirectory,),
            "loaded": self._lines("get_loaded_modules", "file_path"),
            "factories": self._lines("get_factory_profiles"),
            "create": (Control, NOTHING, lambda _: "", self._create),
        }

    def hidden(self, value):
        return {"loadable": self._lines("get_loadable_modules")}  # runs a process for each module

    def _lines(self, operation, key=None):
        return Text, self.mount.answer(self.peer, lambda: self._modules(operation, key)), "".join

    async def _modules(self, operation, key):
        await orb.is_alive(self.where, self.node.ref)  # looking for modules may take long
        return [line(label) for label in await manager.labels(self.node, operation, key)]

    async def _create(self, text):
        try:
            manager.check_argument(text)
        except errors.Usage as e:
            raise errors.BadValue(self.where + "/create", *e.args)
        await manager.create(self.node, text, WAIT)


class ManagedDirectory(Directory):
    """The components of a manager: links to where they are bound, or those that are bound nowhere."""

    __slots__ = ()

    def __init__(self, above, name):
        super().__init__(above, name)
        self.source = self.mount.answer(self.peer, self._listed)

    async def _listed(self):
        """[(Node, the Path where it is bound or None)]"""
        bound = places.Places()
        listed = []
        for node in await tree.managed(self.above.node):
            path = None
            if node.kind == "component":
                path = await bound.path(node.path.names[-1].id, node.ref, self.above.node)
            listed.append((node, path))
        return listed

    def entries(self, listed):
        names = unique(node.path.names[-1] for node, _ in listed)
        return {name: self._made(node, path) for name, (node, path) in zip(names, listed)}

    def _made(self, node, path):
        if path:
            return Link, link_text(str(path), self)
        if node.kind != "component":
            return Link, f"{node.kind}: {node.error}"
        from rtshell_lite.mount.components import ComponentDirectory

        return ComponentDirectory, node
