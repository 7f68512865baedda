"""Single changes to a running system: what differs from the profile, the command that mends it,
how to do that and undo it.
"""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.robot import component, composites, configuration, contexts, manager, tree
from rtshell_lite.system import capture, placements
from rtshell_lite.system.placements import Question
from rtshell_lite.text import printable, shell_word

# Where the system differs from what a step wants: `what` is a key of compare.MESSAGES; `name` that of the
# parameter, property, member …; `expected` in the profile and `actual`, None for nothing; `obstacle` the
# errors.Error that says why the step cannot mend it, None if it can.
Difference = collections.namedtuple("Difference", "what name expected actual obstacle")

# The answer that Values and Active get of a component: `sets` and `active` as in capture.ComponentState.
Configured = collections.namedtuple("Configured", "sets active configuration")


class Step:
    """One change. `placements` are those that it concerns: steps that share one are done in their order.
    `placement` is the first of them.

    title     what is done, for people
    where     the object, for errors
    command   the command that does the same, ready for a shell
    endpoint  the process that `act` asks
    part      the part of a component that shows whether it is done: configuration, contexts, ports
    setting   the value that it gives to what a person may have reasons to set otherwise; None for other steps
    joining   the Placements that it lets take part in a context, in which they are Inactive at first
    """

    kind = command = part = ""
    setting = None  # type: object
    joining = ()  # type: object
    tolerant = False  # True if it makes sense though a component is dead
    free = False  # True if others of the kind may come before or after it

    def __init__(self, concerned, where, title):
        self.placements = list(concerned)
        self.placement = self.placements[0] if self.placements else None
        self.where = where
        self.title = title
        self.required = all(placement.required for placement in self.placements)

    @property
    def endpoint(self):
        return self.placement.node.endpoint

    def placement_error(self):
        """The error of the first Placement that has one, or None."""
        return next((placement.error for placement in self.placements if placement.error is not None), None)

    def questions(self):
        """What has to be asked to know whether it is done: Questions."""
        return []

    def known_answers(self):
        """The answers to its questions, by what was found of all Placements in one look."""
        return [self.placement.found]

    def differences(self, answers):
        """Differences between what the step wants and the answers, none of which is an error."""
        return []

    async def is_done(self, answers):
        """Whether nothing differs, by the answers to its questions.
        Raises an errors.Error if that is not known, or cannot be mended.
        """
        differences = list(self.differences(errors.raise_first(answers)))
        for difference in differences:
            if difference.obstacle is not None:
                raise difference.obstacle
        return not differences

    async def act(self, answers):
        """Do it; `answers` have shown that it was not done."""

    async def tidy(self, answers):
        """After `act` has failed: remove what it has left behind."""

    async def undo(self, before, after):
        """Undo it; the answers before and after it was done."""

    def give_up(self, error):
        """Note for the steps that follow that it could not be done."""


class Present(Step):
    """That the component that is meant is there: a check and no change."""

    kind = "component"

    def __init__(self, placement):
        super().__init__([placement], placement.where, "component " + placement.where)

    def differences(self, answers):
        profile = answers[0].profile
        described = self.placement.component
        if profile.instance_name != described.instance_name:
            expected, actual = described.instance_name, profile.instance_name
            names = [f"component named {printable(name)}" for name in (expected, actual)]
            obstacle = errors.WrongKind(self.where, *names)
            yield Difference("instance name", None, expected, actual, obstacle)
        actual = capture.component_id(profile)
        if described.id and actual != described.id:  # a file that was converted has none
            obstacle = errors.WrongKind(self.where, printable(described.id), printable(actual))
            yield Difference("id", None, described.id, actual, obstacle)


# ---- making components ----


class Create(Step):
    """Let the manager `holder` (restore.Creator) create the component that it knows as `identity`,
    with the wanted name.
    """

    kind = "create"

    def __init__(self, placement, holder, identity):
        title = f"component {placement.where}, created by {holder.where}"
        super().__init__([placement, holder], placement.where, title)
        self.required = placement.required
        self.holder = holder
        self.argument = f"{identity}?instance_name={placement.instance}"
        self.command = f"rtmgr -c {shell_word(self.argument)} --wait {shell_word(holder.where)}"
        if any(c in placement.instance + identity for c in "?&="):
            raise errors.Failed(self.where, "a manager cannot create a component of this name or id")

    @property
    def endpoint(self):
        return self.holder.node.endpoint

    def questions(self):
        return [Question(self.endpoint, self.where, self._created)]

    async def _created(self):
        """The Node of the component, None if it is not there. A name that is bound to what refuses is no
        hindrance: restore.creations has found out whether that may live.
        """
        try:
            node = await tree.component(self.placement.path)
            await orb.is_alive(node.path, node.ref)
        except placements.MISSING + (errors.MaybeGone,):
            return None
        return node

    async def is_done(self, answers):
        (self.placement.node,) = errors.raise_first(answers)
        return self.placement.node is not None

    async def act(self, answers):
        name = await manager.create(self.holder.node, self.argument, wait=manager.SETTLE_TIME)
        if name != self.placement.instance:
            await manager.delete(self.holder.node, name)
            raise errors.Refused(self.where, f"its manager made {printable(name)} instead; deleted again")

        async def is_there():
            return await self._created() is not None

        if not await component.until(is_there, manager.SETTLE_TIME):
            await manager.delete(self.holder.node, name)
            why = f"{self.holder.where} made it, but it is not bound here; deleted again"
            raise errors.Refused(self.where, why)

    async def undo(self, before, after):
        await manager.delete(self.holder.node, self.placement.instance)

    def give_up(self, error):
        self.placement.error = error


class Members(Step):
    """Make components members of a composite."""

    kind = "members"
    part = "contexts"

    def __init__(self, placement, members):
        names = ", ".join(printable(member.instance) for member in members)
        super().__init__([placement] + members, placement.where, f"members {names} of {placement.where}")
        self.members = members
        self.joining = [
            member
            for member in members
            if member.node is None or placement.found is None or _is_missing(member, placement.found)
        ]
        options = [word for member in self.joining for word in ("-a", member.where)]
        self.command = " ".join(map(shell_word, ["rtcomp", *options, placement.where]))

    def questions(self):
        node = self.placement.node
        return [Question(self.endpoint, self.where, lambda: composites.first_organisation(node))]

    def differences(self, answers):
        return [
            Difference("member", member.instance, str(member.node.path), None, None)
            for member in self._missing(answers)
        ]

    async def is_done(self, answers):
        missing = self._missing(answers)
        await composites.check(self.placement.node, answers[0], missing, [])
        return not missing

    def _missing(self, answers):
        """composites.Members: those that are to be members, and are not yet, by the answers."""
        (composite,) = errors.raise_first(answers)  # a ComponentState, or an Organisation
        return [
            composites.Member(member.instance, member.node, [])
            for member in self.members
            if _is_missing(member, composite)
        ]

    async def act(self, answers):
        async for _ in composites.add(self.placement.node, answers[0], self._missing(answers)):
            pass

    async def undo(self, before, after):
        async for _ in composites.remove(self.placement.node, after[0], self._missing(before)):
            pass


def members(placement, placement_of):
    """The Placements of the members that the profile gives a composite;
    `placement_of` as placements.finder makes it.
    """
    all_members = [placement_of(participant.component) for participant in placement.component.participants]
    return [member for member in all_members if member is not None]


def _is_missing(member, composite):
    return not any(orb.same(ref, member.node.ref) for _, ref in composite.members)


# ---- configuration ----


class _Configuring(Step):
    """What steps on a configuration set share."""

    part = "configuration"

    def __init__(self, placement, set_id, title):
        super().__init__([placement], placement.where, f"{title} {printable(set_id)} of {placement.where}")
        self.set_id = set_id

    @property
    def unknown_set(self):
        """The error where the component has no such set."""
        return errors.NoSuch(self.where, "configuration set", printable(self.set_id))

    def questions(self):
        return [Question(self.endpoint, self.where, self._configured)]

    async def _configured(self):
        now = await configuration.of(self.placement.node)
        return Configured(now.sets(with_hidden=True), now.active, now)


def wanted_values(configuration_set):
    """{parameter: value} of a model.ConfigurationSet, in its order."""
    return collections.OrderedDict(
        (item.name, item.data or "") for item in configuration_set.configuration_data
    )


class Values(_Configuring):
    """Give the parameters of one configuration set their values, a dict."""

    kind = "configuration"

    def __init__(self, placement, set_id, values):
        super().__init__(placement, set_id, "configuration set")
        self.values = values
        self.setting = tuple(values.items())
        self.active_before = None  # the set that was active, and has to be again
        present = placement.found and self._present(placement.found) or {}
        changed = {name: value for name, value in values.items() if present.get(name) != value}
        self._shown = changed or values

    @property
    def command(self):  # type: ignore[override]
        words = ["%s=%s" % item for item in self._shown.items()]
        return configuration.command(self.where, self.set_id, "set", *words)

    def _present(self, answer):
        """The values that the set has now, a dict; None where there is no such set."""
        return next((one_set.values for one_set in answer.sets if one_set.id == self.set_id), None)

    def differences(self, answers):
        present = self._present(answers[0])
        if present is None:
            yield Difference("set", None, self.set_id, None, self.unknown_set)
            return
        for name, value in self.values.items():
            if name not in present:
                words = f"{printable(name)} in set {printable(self.set_id)}"
                obstacle = errors.NoSuch(self.where, "configuration parameter", words)
                yield Difference("parameter", name, value, None, obstacle)
            elif present[name] != value:
                yield Difference("value", name, value, present[name], None)
        if self.active_before is not None and answers[0].active != self.active_before:
            yield Difference("active set", None, self.active_before, answers[0].active, None)

    def unknown(self):
        """Names of parameters that a set which was found lacks."""
        if self.placement.found is None:
            return []
        differences = self.differences(self.known_answers())
        return [difference.name for difference in differences if difference.what == "parameter"]

    async def act(self, answers):
        (now,) = answers
        if not self.placement.component.active_configuration_set:  # else the next step activates that
            self.active_before = now.active
        await self._store(self.values, now)

    async def undo(self, before, after):
        previous = self._present(before[0])
        await self._store({name: previous[name] for name in self.values}, after[0])

    async def _store(self, values, now):
        await now.configuration.store(values, now.configuration.set(self.set_id, with_hidden=True))


class Active(_Configuring):
    """Make a configuration set the active one."""

    kind = "active set"

    def __init__(self, placement, set_id):
        super().__init__(placement, set_id, "active configuration set")
        self.setting = set_id

    @property
    def command(self):  # type: ignore[override]
        return configuration.command(self.where, self.set_id, "act")

    def differences(self, answers):
        (now,) = answers
        present = [one_set.id for one_set in now.sets]
        if now.active == self.set_id:
            return
        if self.set_id == "default" and all(map(configuration.hidden, present)):
            # components without configuration have no set at all, and files name this one nevertheless
            return
        obstacle = None if self.set_id in present else self.unknown_set
        yield Difference("active set", None, self.set_id, now.active or None, obstacle)

    async def act(self, answers):
        await answers[0].configuration.activate(self.set_id)

    async def undo(self, before, after):
        if not before[0].active:
            why = "had no active configuration set before, and cannot get rid of one"
            raise errors.Refused(self.where, why)
        await after[0].configuration.activate(before[0].active)


class _OfContext(Step):
    """What steps on an execution context of a component share: its handle, and its number `index` as -e
    counts.
    """

    part = "contexts"

    def __init__(self, placement, others, index, handle, title):
        super().__init__([placement] + others, placement.where, f"{title} of {placement.where}")
        self.index = index
        self.handle = handle

    def questions(self):
        return [Question(self.endpoint, self.where, self._owned)]

    async def _owned(self):
        node = self.placement.node
        return [await component.context(node, ref) for ref in await component.owned_context_refs(node)]

    def known_answers(self):
        return [self.placement.found.owned]

    def _context(self, answers):
        """(its number, the component.Context) of the context. Raises NoSuch."""
        for index, context in enumerate(answers[0]):
            if context.handle == self.handle:
                return index, context
        raise errors.NoSuch(self.where, "execution context", "%d" % self.handle)

    def _command(self, *words):
        """An rtec command for the context, ready for a shell."""
        option = ["-e", str(self.index)] if self.index else []
        return " ".join(map(shell_word, ["rtec", *option, self.where, *words]))


class Participants(_OfContext):
    """Let the components at other Placements take part in the context."""

    kind = "participants"

    def __init__(self, placement, index, handle, participants):
        names = ", ".join(printable(participant.instance) for participant in participants)
        title = f"participants {names} in execution context {handle}"
        super().__init__(placement, participants, index, handle, title)
        self.participants = participants
        self.joining = [
            participant
            for participant in participants
            if placement.found is None or self._is_missing(participant, placement.found.owned)
        ]
        self.command = self._command("attach", *[participant.where for participant in self.joining])

    def differences(self, answers):
        self._context(answers)
        return [
            Difference("participant", participant.instance, participant.where, None, None)
            for participant in self._missing(answers)
        ]

    def _missing(self, answers):
        return [participant for participant in self.participants if self._is_missing(participant, answers[0])]

    def _is_missing(self, participant, owned):
        if participant.node is None:
            return True
        refs = [ref for context in owned if context.handle == self.handle for ref in context.participants]
        return not any(orb.same(ref, participant.node.ref) for ref in refs)

    async def act(self, answers):
        for participant in self._missing(answers):
            await contexts.attach(self.placement.node, self.index, participant.node)

    async def undo(self, before, after):
        for participant in self._missing(before):
            await contexts.detach(self.placement.node, self.index, participant.node)


def own_contexts(placement):
    """(number as -e counts, handle, model.ExecutionContext) of the contexts that the file lists for a
    component and that it owns.
    """
    owned = [context.handle for context in placement.found.owned] if placement.found else None
    for index, described in enumerate(placement.component.execution_contexts):
        if described.id.isdigit() and owned is None:
            yield index, int(described.id), described
        elif described.id.isdigit() and int(described.id) in owned:
            yield owned.index(int(described.id)), int(described.id), described


def participants(placement, context, placement_of):
    """The Placements of the components that the profile lets take part in a context of another one;
    not of itself. A composite lists its members itself.
    """
    if placement.component.participants:
        return []
    others = [placement_of(target) for target in context.participants]
    return [other for other in others if other is not None and other is not placement]


class Rate(_OfContext):
    """Set the rate (Hz) of the context, one that the component owns."""

    kind = "rate"

    def __init__(self, placement, index, handle, rate):
        super().__init__(placement, [], index, handle, f"rate of execution context {handle}")
        self.rate = self.setting = rate
        self.command = self._command("rate", repr(rate))

    def differences(self, answers):
        _, context = self._context(answers)
        if not contexts.same_rate(context.rate, self.rate):
            yield Difference("rate", None, self.rate, context.rate, None)

    async def act(self, answers):
        await contexts.set_rate(self.placement.node, self._context(answers)[0], self.rate)

    async def undo(self, before, after):
        index, context = self._context(before)
        await contexts.set_rate(self.placement.node, index, context.rate)
