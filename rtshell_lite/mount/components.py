"""The files of a component in a mounted RTC Tree."""

import functools
import math

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.mount.nodes import (
    Control, Directory, Items, Link, Text, WritableItem, line, link_text, meant, unique
)
from rtshell_lite.mount.ports import PortsDirectory
from rtshell_lite.robot import component, composites, contexts, places, transitions, tree
from rtshell_lite.robot import configuration as configurations
from rtshell_lite.robot.snapshot import EACH, FULL, Snapshot
from rtshell_lite.text import json_line, printable

TRANSITIONS = {"Active": transitions.ACTIVATE, "Inactive": transitions.DEACTIVATE, "reset": transitions.RESET}
WAIT = 5.0  # seconds that a state may take to be reached, as with rtact --wait


class ComponentDirectory(Directory):
    """A component. What it has been asked for is shared by all that is below it."""

    __slots__ = (
        "node", "contexts", "state", "ports", "profile", "configuration", "organisations", "everything"
    )

    def __init__(self, above, name, node):
        super().__init__(above, name)
        self.node = node
        source = self._source
        self.contexts = source(lambda: component.context_refs(self.node))
        self.state = source(self._state, 0)
        self.ports = source(lambda: Snapshot(self.node).ask(ports=EACH))
        self.profile = source(self._profile)
        self.configuration = source(lambda: configurations.of(self.node))
        self.organisations = source(self._members)
        self.everything = source(self._everything)

    def _source(self, ask, seconds=None):
        async def checked():
            if self.node.ref is None:
                raise self.node.error or errors.WrongKind(str(self.node.path), "component", self.node.what)
            try:
                return await ask()
            except (errors.Gone, errors.ConnectionRefused):
                if not await self._has_come_back():
                    raise
                return await ask()

        return self.mount.answer(self.peer, checked, seconds)

    async def _has_come_back(self):
        """Whether another object has its name now:
        the kernel does not look up again what is a working directory.
        """
        try:
            node = await tree.resolve(self.node.path)
        except errors.Error:
            return False
        is_another = node.ref is not None and not orb.same(node.ref, self.node.ref)
        if is_another:
            self.renew(node)
        return is_another

    def renew(self, node):
        if not orb.same(self.node.ref, node.ref):
            for source in (
                self.contexts, self.ports, self.profile, self.configuration, self.organisations,
                self.everything,
            ):
                source.expire()
        self.node = node

    def peer(self):
        return self.node.endpoint if self.node.ref is not None else None, self.node.path

    async def _profile(self):
        snapshot = await self.ports.get()  # before the profile: see `component.profile`
        if snapshot.refusing:
            raise snapshot.refusing[0][1]
        return (await snapshot.ask(profile=FULL)).profile

    async def _state(self):
        owned, participating = await self.contexts.get()
        return component.merged(await component.states(self.node, owned + participating))

    async def _everything(self):
        from rtshell_lite.views import describe

        details = await describe.collect(self.node, 2)
        return describe.as_dict(details, await places.far_names(details.ports))

    async def _members(self):
        """[(instance name, text of its path)]"""
        members = []
        for organisation in await composites.owned(self.node):
            paths = await composites.member_paths(self.node, organisation)
            members += [(name, path) for (name, _), path in zip(organisation.members, paths)]
        return members

    def entries(self, value):
        entries = {"state": (Control, self.state, lambda state: state + "\n", self._change)}
        for field in component.FACTS:
            entries[field] = Text, self.profile, functools.partial(_field, field)
        entries["profile.json"] = Text, self.everything, lambda fields: json_line(fields) + "\n"
        entries["properties"] = Items, self.profile, lambda profile: profile.properties
        entries["ports"] = (PortsDirectory, self.ports)
        entries["configuration"] = (ConfigurationDirectory, self.configuration)
        entries["contexts"] = (ContextsDirectory, self.contexts)
        entries["members"] = (MembersDirectory, self.organisations)
        return entries

    def hidden(self, value):
        from rtshell_lite.live import observer, watch
        from rtshell_lite.mount.streams import WatchStream

        return {
            "events": (WatchStream, lambda: watch.Watch(watch.Events(watch.KINDS)), observer.event_line),
            "log": (
                WatchStream, lambda: watch.Watch(watch.Records("NORMAL", [])),
                lambda record: observer.record_line(record, self.name),
            ),
        }

    async def _change(self, text):
        if text not in TRANSITIONS:
            raise errors.BadValue(self.where + "/state", f"not {', '.join(TRANSITIONS)}")
        await transitions.change(self.node, TRANSITIONS[text], wait=WAIT)


def _field(name, profile):
    return line(getattr(profile, name))


class MembersDirectory(Directory):
    """Links to the members of a composite."""

    __slots__ = ()

    def entries(self, members):
        names = unique(name if isinstance(name, str) else "unknown" for name, _ in members)
        return {name: (Link, link_text(path, self)) for name, (_, path) in zip(names, members)}


# ---- configuration ----


class ConfigurationDirectory(Directory):
    """The configuration sets, and which is active."""

    __slots__ = ()

    def entries(self, configuration):
        return self._sets(configuration, with_hidden=False)

    def hidden(self, configuration):
        return self._sets(configuration, with_hidden=True)

    def _sets(self, configuration, with_hidden):
        if configuration is None:
            return {}
        sets = {one_set.id: one_set for one_set in configuration.sets(with_hidden=True)}
        entries = {"active": (Control, self.source, lambda now: line(now.active), self._activate)}
        for name, set_id in zip(unique(["active", *sets]), [None, *sets]):
            if set_id is not None and (with_hidden or not configurations.hidden(set_id)):
                entries[name] = SetDirectory, self.source, set_id
        return entries

    async def _activate(self, text):
        configuration = await self.fresh()
        await configuration.activate(meant(text, self.where))

    async def fresh(self):
        """The Configuration, read anew."""
        self.source.expire()
        return await self.source.get()


class SetDirectory(Directory):
    """The parameters of a configuration set."""

    __slots__ = ("_id",)

    def __init__(self, above, name, source, set_id):
        super().__init__(above, name, source)
        self._id = set_id

    def _named(self, configuration):
        values = configuration.set(self._id, with_hidden=True).values
        return dict(zip(unique(values), values.items()))

    def texts(self, configuration):
        """{file name: value}"""
        return {name: value for name, (_, value) in self._named(configuration).items()}

    def entries(self, configuration):
        return {name: (WritableItem,) for name in self._named(configuration)}

    async def store(self, name, text):
        """Set the parameter of this file name."""
        configuration = await self.above.fresh()
        parameter, _ = self._named(configuration)[name]
        await configuration.store({parameter: text}, configuration.set(self._id, with_hidden=True))


# ---- execution contexts ----


class ContextsDirectory(Directory):
    """The execution contexts, by their numbers as rtact -e counts them."""

    __slots__ = ()

    def entries(self, refs):
        owned, participating = refs
        return {
            str(index): (ExecutionDirectory, index, ref) for index, ref in enumerate(owned + participating)
        }


class ExecutionDirectory(Directory):
    """One execution context."""

    __slots__ = ("_index", "_ref", "_profile")

    def __init__(self, above, name, index, ref):
        super().__init__(above, name)
        self._index = index
        self._ref = ref
        self._profile = self.mount.answer(self.peer, lambda: component.context(self._node(), self._ref))

    def renew(self, index, ref):
        if not orb.same(ref, self._ref):
            self._profile.expire()
        self._ref = ref

    def _node(self):
        return self.above.above.node

    def _asked(self, operation):
        """A CachedAnswer that is what the context itself answers now."""
        return self.mount.answer(self.peer, lambda: orb.call(self.where, self._ref, operation), 0)

    def entries(self, value):
        def shown(runs):
            return "Running\n" if runs else "Stopped\n"

        return {
            "state": (Control, self._asked("is_running"), shown, self._run),
            "rate": (Control, self._asked("get_rate"), "{:g}\n".format, self._set_rate),
            "kind": (Text, self._profile, lambda context: context.kind + "\n"),
            "owner": (Text, self.mount.answer(self.peer, self._owner), line),
        }

    async def _owner(self):
        return await component.instance_name(self._node(), (await self._profile.get()).owner)

    async def _run(self, text):
        changes = {"Running": contexts.start, "Stopped": contexts.stop}
        if text not in changes:
            raise errors.BadValue(self.where + "/state", f"not {' or '.join(changes)}")
        await changes[text](self._node(), self._index)

    async def _set_rate(self, text):
        try:
            rate = float(text)
        except ValueError:
            rate = 0.0
        if not 0 < rate < math.inf:
            raise errors.BadValue(self.where + "/rate", f"not a number of Hz above 0: {printable(text)}")
        await contexts.set_rate(self._node(), self._index, rate)
