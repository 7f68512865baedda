"""Managers (RTM::Manager): modules, components made and deleted, configuration, shut-down.

A manager's word is not enough: load_module answers RTC_OK for files that do not exist, set_configuration for everything. So
each change is followed by a look at what has really happened.
"""
import re

from rtshell_lite import component, errors, orb, ports, tree
from rtshell_lite.path import Path, parse, split_address
from rtshell_lite.text import from_wire, printable, to_wire

DEFAULT_PORT = 2810  # corba.master_manager
CREATE_TIME = 15.0  # seconds: a master may have to start a slave process first
MODULES_TIME = 60.0  # seconds: looking for modules runs a helper process a file, 0.5 s each
SETTLE_TIME = 3.0  # seconds: lists follow a deletion up to 1 s later, a process its shut-down 0.5 to 1 s

_CORBALOC = re.compile(r"corbaloc:(?:iiop)?:(?:1\.[0-9]@)?(?P<address>\[[^\]]*\](?::\d+)?|[^/:]+(?::\d+)?)(?:/(?P<key>.+))?\Z")


class Address(str):
    """A corbaloc in the place of a Path, for what is reached without a name server."""

    names = ()

    def child(self, name):
        """What a manager's component or slave is called."""
        return Path(str(self), (name,), None, False)


# ---- which manager --------------------------------------------------------------------------------------------

def find(word):
    """The Node of the manager that `word` names: a path, or corbaloc:[iiop]:HOST[:PORT][/KEY] without a name server.

    Raises BadPath before anything is contacted, what `tree.resolve` raises, WrongKind, Gone, Silent.
    """
    direct = word.startswith("corbaloc:")
    node, = tree.look([tree.Node(Address(word), "unsure", reference(word)) if direct else _bound(parse(word))])
    if node.kind == "manager":
        return node
    if direct and isinstance(node.error, errors.Gone):
        raise errors.NoSuch(word, "object", _key(word))
    if direct and isinstance(node.error, errors.ConnectionRefused):
        raise errors.NoManager(word)
    raise node.error or errors.WrongKind(str(node.path), "manager", node.what)


def _bound(path):
    if path.port is not None:
        raise errors.WrongKind(str(path), "manager", "port")
    return tree.resolve(path)


def check(word):
    """Raise BadPath for what cannot name a manager; contacts nobody."""
    if not word.startswith("corbaloc:"):
        parse(word)
    elif not _CORBALOC.match(word) or split_address(_CORBALOC.match(word).group("address"))[1] is None:
        raise errors.BadPath("%s: not corbaloc:iiop:HOST[:PORT][/KEY]" % printable(word))


def check_argument(argument):
    """Raise Usage for a wrong argument of `create`; contacts nobody.

    Managers know no escaping: they refuse a second ? and leave out what is not KEY=VALUE, both without a word.
    """
    module, mark, pairs = argument.partition("?")
    if not module or "?" in pairs or any(pair and pair.count("=") != 1 for pair in pairs.split("&")):
        raise errors.Usage("not MODULE[?KEY=VALUE&KEY=VALUE…]: %s" % printable(argument))


def reference(word):
    """The reference that a corbaloc of a manager stands for; contacts nobody. Raises BadPath."""
    check(word)
    return orb.corbaloc(word, _CORBALOC.match(word).group("address"), _key(word), DEFAULT_PORT)


def _key(word):
    return _CORBALOC.match(word).group("key") or "manager"


# ---- what it has ----------------------------------------------------------------------------------------------

def components(node):
    """(instance name, Node) of each component that lives; a master tells those of its slaves, too."""
    return [(each.path.names[-1].id, each) for each in tree.managed(node) if each.kind == "component"]


def profiles(node):
    """(Node, component.Profile) of its components, each asked in the order that harms none; an errors.Error for what failed.

    Those that are gone are left out, although managers may go on listing them.
    """
    def one(each):
        ports.ports(each)
        return each, component.profile(each)
    found = sorted((each for each in tree.managed(node) if each.kind != "zombie"), key=lambda each: str(each.path))
    return tree.on_nodes([each.error or each for each in found], one)


def configuration(node):
    """Its configuration as a list of (key, value) texts."""
    return orb.properties(node.call("get_configuration"))


def profile(node):
    """Its profile (RTM::ManagerProfile) as a list of (key, value) texts."""
    return orb.properties(node.call("get_profile").properties)


def modules(node, operation="get_loadable_modules"):
    """Profiles of modules as dicts: get_loadable_modules, get_loaded_modules or get_factory_profiles.

    Sorted, and each once: a master repeats what its slaves have as well.
    """
    distinct = {tuple(sorted(each.items())): each for each in _modules(node, operation)}
    return sorted(distinct.values(), key=lambda each: (component_id(each), each.get("file_path", "")))


def _modules(node, operation):
    seconds = MODULES_TIME if operation == "get_loadable_modules" else None
    return [dict(orb.properties(each.properties)) for each in node.call(operation, seconds=seconds)]


def _loaded(node):
    return [each.get("file_path", "") for each in _modules(node, "get_loaded_modules")]


def component_id(properties):
    """RTC:vendor:category:implementation:language:version of a module's properties, as create_component takes it."""
    return ":".join(["RTC"] + [properties.get(key, "") for key in (
        "vendor", "category", "implementation_id", "language", "version")])


# ---- changing -------------------------------------------------------------------------------------------------

def create(node, argument, wait=None):
    """Create a component and return its instance name. `argument` is MODULE[?key=value[&key=value…]].

    `wait` (seconds): until it is initialised and the manager lists it. Raises Refused with what can be told of the reason.
    """
    before = components(node)
    wanted = dict(pair.split("=", 1) for pair in argument.partition("?")[2].split("&") if "=" in pair).get("instance_name")
    if wanted in [name for name, _ in before]:
        # not refused by managers: two components of one name crash their process later (C++ 1.x)
        raise errors.Refused(str(node.path), "has a component %s already" % printable(wanted))
    refs = (node.call("create_component", to_wire(spelt), seconds=CREATE_TIME) for spelt in _spellings(argument))
    ref = next((ref for ref in refs if ref is not None), None)
    if ref is None:
        raise errors.Refused(str(node.path), "does not create %s (%s)" % (printable(argument), _why_not(node, argument)))
    made = tree.Node(node.path, "component", ref)
    name = from_wire(component.seen(lambda: made.call("get_sdo_id")))
    if any(orb.same(ref, other.ref) for _, other in before):
        raise errors.Refused(str(node.path), "made nothing new: it gave back %s, which was there" % printable(name))
    if wait is not None:
        _until(wait, lambda: _is_ready(node, name, made), str(node.path), "%s is not ready" % printable(name))
    return name


def _spellings(argument):
    """The argument, and its other form: an identity has no language in it with C++ 1.1, one with all later versions."""
    ident, mark, rest = argument.partition("?")
    fields = ident.split(":")
    yield argument
    if fields[0] == "RTC" and len(fields) == 6:
        yield ":".join(fields[:4] + fields[5:]) + mark + rest
    elif fields[0] == "RTC" and len(fields) == 5:
        yield ":".join(fields[:4] + [""] + fields[4:]) + mark + rest


def _why_not(node, argument):
    """What can be told of the reason: managers give none."""
    ident = argument.partition("?")[0]
    wanted = ident.split(":")[3] if ident.count(":") > 3 else ident
    there = modules(node, "get_factory_profiles")
    alike = [each for each in there if each.get("implementation_id") == wanted]
    if not alike:
        known = sorted({each.get("implementation_id", "") for each in there})
        return "no factory %s; there are: %s" % (printable(wanted), printable(", ".join(known)) or "none")
    if ident != wanted and ident not in map(component_id, alike):
        return "there is " + printable(", ".join(map(component_id, alike)))
    most = alike[0].get("max_instance", "0")
    return "a wrong argument" + (", or its max_instance of %s is reached" % printable(most) if most != "0" else "")


def _is_ready(node, name, made):
    return name in [each for each, _ in components(node)] and component.state(made) not in ("Created", "Unknown")


def delete(node, instance):
    """Delete a component of this manager or of one of its slaves, and wait until it is listed no longer.

    Raises NoSuch, Refused, Unreachable.
    """
    found = [each for name, each in components(node) if name == instance]
    if len(found) != 1:
        raise errors.NoSuch(str(node.path), "component" if not found else "single component (its slaves have several)",
                            printable(instance))
    # a master says BAD_PARAMETER to the name of a slave's component, or RTC_OK and does nothing (C++ 1.1)
    holder = next((slave for slave in _slaves(node) if _lists(slave, found[0].ref)), node)
    code = str(holder.call("delete_component", to_wire(instance), seconds=CREATE_TIME))
    if code != "RTC_OK":
        raise errors.Refused(str(node.path), "does not delete %s (%s)" % (printable(instance), code))
    _until(SETTLE_TIME, lambda: not _lists(node, found[0].ref), str(node.path), "still lists %s" % printable(instance))


def _slaves(node):
    return [slave for slave in tree.slaves(node) if slave.kind == "manager"]


def _lists(node, ref):
    return any(orb.same(each, ref) for each in node.call("get_components"))


def load(node, file_path, function):
    """Load a module; `function` is its initialisation function. Raises Refused when it is not there afterwards.

    Returns how many factories there are that were not there before.
    """
    before, known = _loaded(node), len(_modules(node, "get_factory_profiles"))
    code = str(node.call("load_module", to_wire(file_path), to_wire(function), seconds=CREATE_TIME))
    after = _loaded(node)
    there = [path for path in after if path == file_path or path.endswith("/" + file_path.lstrip("./"))]
    if code != "RTC_OK" or not there and len(after) <= len(before):
        raise errors.Refused(str(node.path), "did not load %s (it says %s)" % (printable(file_path), code))
    return len(_modules(node, "get_factory_profiles")) - known


def unload(node, file_path):
    """Unload a module: its path as listed, or an end of it that is not shared. Raises NoSuch, Refused.

    A master is asked to unload its own, else the slave that has it.
    """
    before = _loaded(node)
    paths = set(before)
    meant = [path for path in paths if path == file_path] or [path for path in paths if path.endswith("/" + file_path)]
    if len(meant) != 1:
        raise errors.NoSuch(str(node.path), "loaded module" if not meant else "single loaded module", printable(file_path))
    holders = [slave for slave in _slaves(node) if meant[0] in _loaded(slave)]
    if holders and len(holders) == before.count(meant[0]):
        unload(holders[0], meant[0])
        return
    code = str(node.call("unload_module", to_wire(meant[0])))
    if code != "RTC_OK" or _loaded(node).count(meant[0]) >= before.count(meant[0]):
        raise errors.Refused(str(node.path), "did not unload %s (it says %s)" % (printable(meant[0]), code))


def set_configuration(node, key, value):
    """Set a configuration value; many are read only when a manager starts. Raises Refused when it did not take."""
    code = str(node.call("set_configuration", to_wire(key), to_wire(value)))
    now = dict(configuration(node)).get(key)
    if code != "RTC_OK" or now != value:
        raise errors.Refused(str(node.path), "did not set %s (it says %s; the value is %s)" % (
            printable(key), code, "missing" if now is None else printable(now) or "empty"))


def shut_down(node):
    """End the manager's process. Slaves of a master live on. Raises Refused, Unreachable when it does not end."""
    code = str(node.call("shutdown"))
    if code != "RTC_OK":
        raise errors.Refused(str(node.path), "does not shut down (%s)" % code)
    _until(SETTLE_TIME, lambda: tree.look([node])[0].kind == "zombie", str(node.path), "is still running")


def _until(limit, reached, where, otherwise):
    if not component.until(lambda: component.seen(reached), limit):
        raise errors.Unreachable(where, "%s after %gs" % (otherwise, limit))
