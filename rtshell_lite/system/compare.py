"""What rtcheck does: a list of checks made from an RtsProfile, and the differences that they find in the running system."""
import collections
import functools

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.robot import component, ports, tree
from rtshell_lite.system import capture
from rtshell_lite.system.capture import shown_path as _path
from rtshell_lite.text import printable

# One check. `what` completes "Checking …", `needs` are the components of the profile that have to be there for it, and
# `differences(check, found, …)` with the Found of each gives Differences.
Check = collections.namedtuple("Check", "kind required what needs differences")

# Where file and system differ: `message` as rtshell says it, `path` of the component or ports, what the file has (`expected`)
# and what there is (`actual`), None where that is nothing.
Difference = collections.namedtuple("Difference", "check required message path expected actual")


class Result:
    """What a comparison found: Differences, and errors of what could not be asked; `asked` counts what could."""

    def __init__(self):
        self.differences, self.failures, self.asked = [], [], 0


# ---- doing them -----------------------------------------------------------------------------------------------

def compare(profile, state, tell=lambda line: None, extra=False):
    """Do all checks, in order, and return the Result; `tell` gets a line for each. `extra`: what there is beyond the profile."""
    answers = capture.look(profile, functools.partial(capture.ask, brief=True))
    running = {id(each): found for each, found in zip(profile.components, answers)}
    result = Result()
    for each in profile.components:
        found = running[id(each)]
        result.asked += not isinstance(found, errors.Error) or _is_missing(found)
        if isinstance(found, errors.Error) and not _is_missing(found):
            result.failures.append(found)
    seen = set()
    for check in checks(profile, state):
        tell("Checking " + check.what)
        for difference in _do(check, [running[id(each)] for each in check.needs]):
            if difference.message not in seen:
                seen.add(difference.message)
                result.differences.append(difference)
    if extra:
        there = [(each, running[id(each)]) for each in profile.components if not isinstance(running[id(each)], errors.Error)]
        _strangers(profile, there, result)
        result.differences += _extra(profile, there)
    return result


def _strangers(profile, there, result):
    """Add to the Result the components that run in the name servers of a profile, and that it does not have."""
    servers = set()
    for each in profile.components:
        try:
            servers.add(capture.path_of(each)._replace(names=()))
        except errors.BadPath:
            pass  # reported before
    nodes, failures, _ = capture.components(sorted(servers, key=str))
    known = {orb.identity(found.node.ref) for _, found in there} | {capture.shown_path(each) for each in profile.components}
    strange = [node for node in nodes if orb.identity(node.ref) not in known and str(node.path) not in known]
    for node in tree.look(strange):
        if node.kind == "silent":
            failures.append(node.error)
        elif node.kind == "component":
            path = str(node.path)
            result.differences.append(Difference("component", True, "Component not in the file: " + path, path, None, path))
    result.failures += [failure for failure in failures if str(failure) not in map(str, result.failures)]


def _extra(profile, there):
    """Differences for what the components of a profile have beyond it: connections, configuration sets, parameters."""
    ids = {each.connector_id for each in profile.connectors}
    names = {orb.identity(port.ref): _path(each) + ":" + printable(ports.short_name(port.name, found.profile.instance_name))
             for each, found in there for port in found.ports}
    made, seen = [], set()
    for each, found in there:
        for one in [one for port in found.ports for one in port.connectors]:
            if one.id in ids or one.id in seen:
                continue
            seen.add(one.id)
            ends = [names.get(orb.identity(ref), "a port outside the file") for ref in one.ports if ref is not None]
            made.append(Difference("connection", each.is_required, "Connection not in the file: %s between %s" % (
                printable(one.id), " and ".join(ends)), " and ".join(ends), None, one.id))
        kept = {one.id: {item.name for item in one.configuration_data} for one in each.configuration_sets}
        for one in found.sets:
            if one.id not in kept:
                made.append(Difference("configuration", True, "Configuration set not in the file: %s on component %s" % (
                    printable(one.id), _path(each)), _path(each), None, one.id))
            for name in [name for name in one.values if one.id in kept and name not in kept[one.id]]:
                made.append(Difference("configuration", True, (
                    "Configuration parameter not in the file: %s in set %s on component %s" % (
                        printable(name), printable(one.id), _path(each))), _path(each), None, one.values[name]))
    return made


def _do(check, found):
    """The Differences of one check."""
    if any(isinstance(one, errors.Error) and not _is_missing(one) for one in found):
        return []  # reported once
    missing = [isinstance(one, errors.Error) for one in found]
    if check.kind == "component":
        if missing[0]:
            return [_difference(check, "%s component missing: %s" % (
                "Required" if check.required else "Optional", _path(check.needs[0])), check.needs[0], _path(check.needs[0]))]
    elif check.kind == "connection":
        lines = []
        for number, each in enumerate(check.needs):
            if missing[number]:
                message = f"{_end_word(number)} component missing: {_path(each)}"
                lines.append(_difference(check, message, each, _path(each)))
        if lines:
            return lines
    elif any(missing):
        return []  # reported with the component itself
    return list(check.differences(check, *found))


def _is_missing(failure):
    return isinstance(failure, (errors.NotFound, errors.WrongKind, errors.Gone, errors.ProcessGone, errors.Failed))


def _end_word(number):
    return "Destination" if number else "Source"


def _difference(check, message, each, expected=None, actual=None, port=None):
    path = _path(each) + (":" + printable(port) if port else "")
    return Difference(check.kind, check.required, message, path, expected, actual)


# ---- making them ----------------------------------------------------------------------------------------------

def checks(profile, state):
    """The Checks for a profile, required things first: components, connections, configuration, members, states."""
    by_need = sorted(profile.components, key=lambda each: not each.is_required)
    found = [_component_check(each) for each in by_need]
    locate = capture.locator(profile)
    connections = [_connection_check(connector, locate) for connector in profile.connectors]
    found += sorted(connections, key=lambda check: not check.required)
    for each in profile.components:
        found += _configuration_checks(each)
    found += [_members_check(each, locate) for each in profile.components if each.participants]
    for each in by_need:
        found += _state_checks(each, state)
    return found


def line(check):
    """A check that is not done but shown, as rtshell does."""
    what, each = check.what, check.needs[0] if check.needs else None
    if check.kind == "component":
        what = 'for %s component "%s", "%s" at path %s' % (
            "required" if check.required else "optional", printable(each.id), printable(each.instance_name), _path(each))
    return f"Check {what}{' (Required)' if check.required else ''}"


def _component_check(each):
    def differences(check, found):
        if found.profile.instance_name != each.instance_name:
            yield _difference(check, "Component instance names mismatched: %s != %s" % (
                printable(found.profile.instance_name), printable(each.instance_name)), each, each.instance_name,
                found.profile.instance_name)
        actual = capture.component_id(found.profile)
        if actual != each.id:
            yield _difference(check, f"Component IDs mismatched: {printable(actual)} != {printable(each.id)}", each,
                              each.id, actual)
    what = 'for %s component %s with ID "%s" and instance name "%s"' % (
        "required" if each.is_required else "optional", _path(each), printable(each.id), printable(each.instance_name))
    return Check("component", each.is_required, what, [each], differences)


def _configuration_checks(each):
    """Those of one component: the active set, then each parameter of each set."""
    path, made = _path(each), []
    active = each.active_configuration_set

    def active_differences(check, found):
        if found.active != active:
            yield _difference(check, "Wrong configuration set is active on %s (Active set: %s)" % (
                path, printable(found.active)), each, active, found.active or None)
    if active:
        made.append(Check("active set", True, f'configuration set "{printable(active)}" is active on component {path}',
                          [each], active_differences))
    for one in each.configuration_sets:
        if not one.configuration_data:
            made.append(_parameter_check(each, one.id, None, None))
        made += [_parameter_check(each, one.id, item.name, item.data or "") for item in one.configuration_data]
    return made


def _parameter_check(each, set_id, name, value):
    """That a set has a parameter with this value; with `name` None that there is the set."""
    path, shown = _path(each), printable(set_id)

    def differences(check, found):
        sets = {one.id: one.values for one in found.sets}
        if set_id not in sets:
            yield _difference(check, f"Invalid configuration set: {shown} on component {path}", each, set_id)
        elif name is not None and name not in sets[set_id]:
            yield _difference(check, "Invalid configuration parameter: %s in set %s on component %s" % (
                printable(name), shown, path), each, value)
        elif name is not None and sets[set_id][name] != value:
            actual = sets[set_id][name]
            yield _difference(check, "Configuration parameter %s in set %s on component %s is incorrect (value: %s)" % (
                printable(name), shown, path, printable(actual)), each, value, actual)
    what = f'for set "{shown}" on component "{path}"' if name is None else \
        f'parameter "{printable(name)}" in set "{shown}" on component "{path}" is "{printable(value)}"'
    return Check("configuration", True, what, [each], differences)


def _members_check(each, locate):
    """That a composite has the members that the profile gives it."""
    members = [locate(one.component) for one in each.participants]

    def differences(check, found, *rest):
        for member, other in zip(check.needs[1:], rest):
            if not any(orb.same(ref, other.node.ref) for _, ref in found.members):
                yield _difference(check, f"Component {_path(member)} is not a member of {_path(each)}", each,
                                  _path(member))
        for name, ref in found.members:
            if not any(orb.same(ref, other.node.ref) for other in rest):
                name = "one that does not answer" if isinstance(name, errors.Error) else printable(name)
                yield _difference(check, f"Wrong member of {_path(each)}: {name}", each, None, name)
    return Check("members", each.is_required, f"members of {_path(each)}", [each] + [m for m in members if m is not None],
                 differences)


def _state_checks(each, state):
    """A check for each execution context that the profile lists; over all where it lists none by number."""
    handles = [one.id for one in each.execution_contexts if one.id.isdigit()] or [None]
    return [_state_check(each, state, handle) for handle in handles]


def _state_check(each, state, handle):
    def differences(check, found):
        actual = _state_in(found, handle) or component.merged(found.states.values())
        if actual.lower() != state.lower():
            yield _difference(check, f"Component {_path(each)} is in incorrect state {actual}", each, state, actual)
    what = "state is %s for %s%s" % (state, _path(each), " in execution context %s" % handle if handle is not None else "")
    return Check("state", each.is_required, what, [each], differences)


def _state_in(found, handle):
    """The state in one execution context; None where there is none, or where it means nothing."""
    if handle is None:
        return None
    stopped = any(context.handle == int(handle) and not context.running for context in found.owned)
    if stopped and len(found.states) > len(found.owned):
        return None  # a member of a composite, whose context is the one that counts
    return found.states.get(int(handle))


# ---- connections ----------------------------------------------------------------------------------------------

def _connection_check(connector, locate):
    """That all ends of a connection have it, with the properties that the profile gives it."""
    ends = [(locate(end), capture.port_of(end)) for end in connector.ends]
    known = [each for each, _ in ends if each is not None]
    names = [(_path(each) if each is not None else f"({printable(end.instance_name)})") + ":" + printable(port)
             for (each, port), end in zip(ends, connector.ends)]
    between = names[0] + ("" if len(names) == 1 else " and " + " and ".join(names[1:]))

    def differences(check, *found):
        if len(known) < len(ends):
            yield Difference(check.kind, check.required, "The file has no component for connection %s between %s" % (
                printable(connector.connector_id), between), between, None, None)
            return
        at = [_port(each, one, name) for (each, name), one in zip(ends, found)]
        for number, port in enumerate(at):
            if port is None:
                yield _difference(check, f"{_end_word(number)} port missing: {names[number]}", ends[number][0],
                                  ends[number][1], None, ends[number][1])
        if None in at:
            return
        have = [having(port, connector, at) for port in at]
        if None in have:
            yield Difference(check.kind, check.required, "No connection between " + between, between,
                             connector.connector_id or None, _instead(at))
            return
        if len(have[0].ports) != len(ends):
            yield Difference(check.kind, check.required, "Connection between %s has %d ends, not %d" % (
                between, len(have[0].ports), len(ends)), between, len(ends), len(have[0].ports))
        for key, wanted, actual in wrong_properties(connector, have[0]):
            yield Difference(check.kind, check.required, "Property %s of connection from %s is incorrect." % (
                printable(key), " to ".join(names)), " to ".join(names), wanted, actual)
    required = bool(known) and all(each.is_required for each in known)
    return Check("connection", required, "for connection between " + between, known, differences)


def _port(each, found, name):
    """The Port of a component that a profile means by `name`."""
    instances = (found.profile.instance_name, each.instance_name)
    names = [name] + [instance + "." + name for instance in instances]
    return next((port for port in found.ports if port.name in names), None)


def having(port, connector, at):
    """The ports.Connector of a Port with the id in the profile, or, where that has none, any that joins the same ports."""
    if connector.connector_id:
        return next((one for one in port.connectors if one.id == connector.connector_id), None)
    wanted = {orb.identity(each.ref) for each in at}
    return next((one for one in port.connectors
                 if wanted <= {orb.identity(ref) for ref in one.ports if ref is not None}), None)


def _instead(at):
    """The id of another connection between these ports, or None."""
    others = ports.joining(at) if len(at) > 1 else []
    return others[0].id if others else None


def wrong_properties(connector, running):
    """(name, value in the profile, value or None) of the properties in which the ports.Connector `running` differs."""
    wanted = {item.name: item.value or "" for item in connector.properties if not capture.is_reference(item.name, item.value)}
    for name in capture.DATA_FIELDS:
        if getattr(connector, name, ""):
            wanted["dataport." + name] = getattr(connector, name)
    actual = dict(running.properties)
    return [(key, value, actual.get(key)) for key, value in sorted(wanted.items())
            if not _agree(key, value, actual.get(key))]


def _agree(key, value, actual):
    if actual is None:
        return False
    if key == "dataport.data_type":
        return ports.same_type(value, actual)
    return value.lower() == actual.lower() if key in ports.ANY_CASE else value == actual
