"""What rtcheck does: looks whether the steps that rtresurrect would take are done, and what state each
component is in.

What differs is found by the steps themselves (steps.py); the order of checks, and the words, are those of
rtshell.
"""

import collections
import functools
import re

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.robot import ports, search, tree
from rtshell_lite.system import capture, connect_steps, placements, steps
from rtshell_lite.text import printable

# Where file and system differ: `message` as rtshell says it, `path` of the component or ports, what the file
# has (`expected`) and what there is (`actual`), None where that is nothing. `check` is the kind of the check
# that found it, `brief` the message for those who say the path, too.
Difference = collections.namedtuple("Difference", "check required message path expected actual brief")

OTHER_ID = "connection id"  # the check that finds connections which only have another id: they are as good

# What rtshell says, by `what` of a steps.Difference. What is in brackets is left out of a brief message.
MESSAGES = {
    "instance name": "Component instance names mismatched: {actual} != {expected}",
    "id": "Component IDs mismatched: {actual} != {expected}",
    "active set": "Wrong configuration set is active[ on {path}] (Active set: {actual})",
    "set": "Invalid configuration set: {set}[ on component {path}]",
    "parameter": "Invalid configuration parameter: {name} in set {set}[ on component {path}]",
    "value": (
        "Configuration parameter {name} in set {set}[ on component {path}] is incorrect (value: {actual})"
    ),
    "member": "Component {member} is not a member[ of {path}]",
    "wrong member": "Wrong member[ of {path}]: {name}",
    "participant": "Component {member} does not take part in an execution context[ of {path}]",
    "state": "[Component {path} is in ]incorrect state {actual}, not {expected}",
    "unplaced": "The file has no component for connection {name}[ between {path}]",
    "connection": "No connection[ between {path}]",
    "other connection": "Connection[ between {path}] is another one: {actual}, not {expected}",
    "other id": "Connection[ {between} {path}] has another id: {actual}, not {expected}",
    "one-port connection": "No connection[ of {path}] by {name}",
    "ends": "Connection[ between {path}] has {actual} ends, not {expected}",
    "property": "Property {name} of connection[ from {path}] is incorrect.",
}


class Result:
    """What a comparison found: Differences, and errors of what could not be asked;
    `asked` counts what could.
    """

    def __init__(self):
        self.differences = []
        self.failures = []
        self.asked = 0


async def compare(profile, state, tell=None, extra=False):
    """Do all checks, in order, and return the Result; `tell`, if given, is called with a line for each.

    `extra`: report, too, what the system has beyond the profile.
    """
    listed = placements.of(profile)
    await placements.find(listed, functools.partial(capture.ask, brief=True))
    result = Result()
    result.failures = [placement.error for placement in listed if _is_silent(placement)]
    result.asked = len(listed) - len(result.failures)
    seen = set()
    for step in checks(profile, state, listed):
        if tell is not None:
            for line in _lines(step):
                tell("Checking " + line)
        for difference in _differences(step) + _remarks(step):
            if difference.message not in seen:
                seen.add(difference.message)
                result.differences.append(difference)
    if extra:
        await _strangers(listed, result)
        ids = {connector.connector_id for connector in profile.connectors}
        ids |= {difference.actual for difference in result.differences if difference.check == OTHER_ID}
        result.differences += _extra(ids, [placement for placement in listed if placement.found is not None])
    return result


def _is_silent(placement):
    """True if it is not known whether a component is there: a failure, not a difference."""
    return placement.error is not None and not (
        placements.is_gone(placement.error) or isinstance(placement.error, (errors.WrongKind, errors.Failed))
    )


# ---- what is checked ----


def checks(profile, state, listed):
    """The steps that are looked at, required ones first: components, connections, configuration, members,
    states.

    `state` is that in which the components are to be, `listed` is placements.of the profile.
    """
    by_need = sorted(listed, key=lambda placement: not placement.required)
    placement_of = placements.finder(capture.locator(profile), listed)
    connecting = connect_steps.connecting(profile, placement_of)
    checked = [steps.Present(placement) for placement in by_need]  # type: list
    checked += sorted(connecting, key=lambda step: not _is_required(step))
    for placement in listed:
        active = placement.component.active_configuration_set
        if active:
            checked += [steps.Active(placement, active)]
        checked += [
            steps.Values(placement, one_set.id, steps.wanted_values(one_set))
            for one_set in placement.component.configuration_sets
        ]
    checked += [
        _Members(placement, steps.members(placement, placement_of))
        for placement in listed
        if placement.component.participants
    ]
    for placement in listed:
        for index, handle, described in steps.own_contexts(placement):
            others = steps.participants(placement, described, placement_of)
            if others:
                checked += [steps.Participants(placement, index, handle, others)]
    for placement in by_need:  # a state for each context; one over all where the file lists none by number
        ids = [context.id for context in placement.component.execution_contexts]
        handles = list(filter(str.isdigit, ids)) or [None]
        checked += [_State(placement, state, handle) for handle in handles]
    return checked


def _is_required(step):
    """Whether rtshell calls it an error when a step is not done."""
    if step.kind == "connect":
        concerned = [placement for placement, _ in step.ends if placement is not None]
    else:
        concerned = step.placements[:1]
    return (
        step.kind in ("configuration", "active set")
        or bool(concerned)
        and all(placement.required for placement in concerned)
    )


class _Members(steps.Members):
    """That a composite has its members, and no others."""

    def differences(self, answers):
        yield from super().differences(answers)
        for name, ref in answers[0].members:
            if not any(orb.same(ref, member.node.ref) for member in self.members):
                if isinstance(name, errors.Error):
                    name = "one that does not answer"
                yield steps.Difference("wrong member", name, None, printable(name), None)


class _State(steps.Step):
    """That a component is in a state, in the execution context with the id `handle`,
    or over all contexts (None).
    """

    kind = "state"

    def __init__(self, placement, state, handle):
        super().__init__([placement], placement.where, "")
        self.state = state
        self.handle = handle

    def differences(self, answers):
        actual = self._in_context(answers[0]) or capture.state(answers[0])
        if actual.lower() != self.state.lower():
            yield steps.Difference("state", None, self.state, actual, None)

    def _in_context(self, answer):
        """The state in that context; None where that context does not exist, or where another one counts.

        That of a member of a composite is stopped; a component that is Active in the context of another
        component is not to be Active in its own, too.
        """
        if self.handle is None:
            return None
        handle = int(self.handle)
        own = {context.handle: context for context in answer.owned}
        others = [state for other, state in answer.states.items() if (other in own) != (handle in own)]
        is_stopped = handle in own and not own[handle].running
        if "Active" in others or is_stopped and others:
            return None
        return answer.states.get(handle)


# ---- in rtshell's words ----


def plan(profile, state):
    """The checks that would be done, as lines."""
    lines = []
    for step in checks(profile, state, placements.of(profile)):
        end = " (Required)" if _is_required(step) else ""
        for line in _lines(step, 'for {0} component "{1}", "{2}" at path {3}'):
            lines.append(f"Check {line}{end}")
    return lines


def _lines(step, component='for {0} component {3} with ID "{1}" and instance name "{2}"'):
    """What a step checks, in words that complete "Checking …"."""
    where = step.where
    if step.kind == "component":
        instance = printable(step.placement.instance)
        return [component.format(_need(step), printable(step.placement.component.id), instance, where)]
    if step.kind == "connect":
        ends = " and ".join(_end_names(step))
        if len(step.ends) == 1:
            return [f"for connection of {ends}"]
        return [f"for connection between {ends}"]
    if step.kind == "active set":
        return [f'configuration set "{printable(step.set_id)}" is active on component {where}']
    if step.kind == "configuration":
        shown = printable(step.set_id)
        return [
            f'parameter "{printable(name)}" in set "{shown}" on component "{where}" is "{printable(value)}"'
            for name, value in step.values.items()
        ] or [f'for set "{shown}" on component "{where}"']
    if step.kind == "members":
        return [f"members of {where}"]
    if step.kind == "participants":
        return [f"participants in execution context {step.handle} of {where}"]
    if step.handle is None:
        return [f"state is {step.state} for {where}"]
    return [f"state is {step.state} for {where} in execution context {step.handle}"]


def _need(step):
    return "required" if step.required else "optional"


def _end_names(step):
    """What the ends of a connection are called, also where the file has no component for one."""
    names = []
    for (placement, port), end in zip(step.ends, step.connector.ends):
        component = f"({printable(end.instance_name)})" if placement is None else placement.where
        names.append(f"{component}:{printable(port)}")
    return names


def _differences(step):
    """The Differences that a step finds; what is missing is reported once, with the component itself."""
    if any(_is_silent(placement) for placement in step.placements):
        return []
    missing = _missing(step)
    if missing or step.placement_error() is not None:
        return missing
    return [_in_words(step, difference) for difference in step.differences(step.known_answers())]


def _remarks(step):
    """A Difference that does not count, for a connection that is like that of the file in all but its id."""
    if not isinstance(step, connect_steps.Connect):
        return []
    if any(placement.found is None for placement in step.placements):
        return []
    answers = step.known_answers()
    actual = None if errors.split(answers)[1] else step.other_id(answers)
    if actual is None:
        return []
    remark = _in_words(step, steps.Difference("other id", None, step.connector.connector_id, actual, None))
    return [remark._replace(check=OTHER_ID, required=False)]


def _missing(step):
    """Differences for a component that is missing, and for the ports that are missing of a connection, all
    components of which are there.
    """
    where = step.where
    if isinstance(step, steps.Present) and step.placement.error is not None:
        return [_difference(step, f"{_need(step).capitalize()} component missing[: {{path}}]", where, where)]
    if not isinstance(step, connect_steps.Connect) or step.placement_error() is not None:
        return []
    differences = []
    role = "Source"
    for placement, port in step.ends:
        if isinstance(placement.port(port), errors.Error):
            where = f"{placement.where}:{printable(port)}"
            differences.append(_difference(step, f"{role} port missing[: {{path}}]", where, port))
        role = "Destination"
    return differences


def _in_words(step, difference):
    words = {
        "set": printable(getattr(step, "set_id", "")),
        "name": printable(str(difference.name)),
        "member": difference.expected,
        "between": "of" if len(step.placements) == 1 else "between",
    }
    path = step.where
    if step.kind == "connect":
        path = (" to " if difference.what == "property" else " and ").join(_end_names(step))
    return _difference(step, MESSAGES[difference.what], path, difference.expected, difference.actual, words)


def _difference(step, template, path, expected=None, actual=None, words=()):
    """The Difference with a message as in MESSAGES; `words` are more that the template may name."""
    check = "connection" if step.kind == "connect" else step.kind
    named = dict(words, path=path, expected=_shown(expected), actual=_shown(actual))
    message = re.sub(r"[][]", "", template).format(**named)
    brief = re.sub(r"\[.*?\]", "", template).format(**named)
    return Difference(check, _is_required(step), message, path, expected, actual, brief)


def _shown(value):
    return "" if value is None else printable(str(value))


# ---- what there is beyond the profile ----


def _beyond(check, required, message, path, actual):
    return Difference(check, required, message, path, None, actual, message)


async def _strangers(listed, result):
    """Add to the Result the components in the name servers of the Placements `listed` that are not listed."""
    servers = set()
    listed_keys = set()  # paths and identities
    for placement in listed:
        listed_keys.add(placement.where)
        if placement.found is not None:
            listed_keys.add(orb.identity(placement.node.ref))
        if placement.path.server is not None:
            servers.add(placement.path._replace(names=()))
    nodes, _, failures, _ = await search.components(sorted(servers, key=str))
    strange = [node for node in nodes if listed_keys.isdisjoint((orb.identity(node.ref), str(node.path)))]
    for node in await tree.check_alive(strange):
        if node.kind in tree.DOUBTFUL:
            failures.append(node.error)
        elif node.kind == "component":
            path = str(node.path)
            message = "Component not in the file: " + path
            result.differences.append(_beyond("component", True, message, path, path))
    result.failures += [failure for failure in failures if str(failure) not in map(str, result.failures)]


def _extra(listed, there):
    """Differences for what the components at the Placements `there` have beyond the profile: connections,
    configuration.

    `listed` are the ids of the connections that the profile has.
    """
    names = {}
    for placement in there:
        instance = placement.found.profile.instance_name
        for port in placement.found.ports:
            name = printable(ports.short_name(port.name, instance))
            names[orb.identity(port.ref)] = f"{placement.where}:{name}"
    differences = []
    for placement in there:
        for connector in [connector for port in placement.found.ports for connector in port.connectors]:
            if connector.id not in listed:
                listed.add(connector.id)
                keys = [orb.identity(ref) for ref in connector.ports if ref is not None]
                ends = " and ".join(names.get(key, "a port outside the file") for key in keys)
                message = f"Connection not in the file: {printable(connector.id)} between {ends}"
                differences += [_beyond("connection", placement.required, message, ends, connector.id)]
        differences += _extra_configuration(placement)
    return differences


def _extra_configuration(placement):
    """Differences for the configuration sets and parameters of one component."""
    listed = {one_set.id: steps.wanted_values(one_set) for one_set in placement.component.configuration_sets}
    where = placement.where
    for one_set in placement.found.sets:
        described = f"{printable(one_set.id)} on component {where}"
        if one_set.id not in listed:
            message = f"Configuration set not in the file: {described}"
            yield _beyond("configuration", True, message, where, one_set.id)
            continue
        for name in [name for name in one_set.values if name not in listed[one_set.id]]:
            message = f"Configuration parameter not in the file: {printable(name)} in set {described}"
            yield _beyond("configuration", True, message, where, one_set.values[name])
