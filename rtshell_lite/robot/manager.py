"""Managers (RTM::Manager): modules, components made and deleted, configuration, shut-down.

A manager's answer proves nothing: load_module returns RTC_OK for files that do not exist, set_configuration
for everything. So each change is checked.
"""

import itertools
import posixpath

from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.path import CORBALOC, MANAGER_PORT, parse, split_address
from rtshell_lite.robot import component, exiting, lookup, ports, tree
from rtshell_lite.text import from_wire, printable, to_wire

CREATE_TIME = 15.0  # seconds: a master may have to start a slave process first
MODULES_TIME = 60.0  # seconds: looking for modules runs a helper process a file, 0.5 s each
PAUSE = 1.0  # seconds
SETTLE_TIME = 3.0  # seconds: lists follow a deletion up to 1 s later
# seconds: a process ends 0.5 to 1.5 s after its shut-down, those of slow execution contexts later
END_TIME = 5.0


class Address(str):
    """A corbaloc in the place of a Path, for what is reached without a name server."""

    names = ()

    def child(self, name):
        """The Path of a component or slave of this manager."""
        return parse(self).child(name)


# ---- which manager ----


async def find(word):
    """The Node of the manager that `word` names: a path, or corbaloc:[iiop]:HOST[:PORT][/KEY] without a name
    server.

    Raises BadPath before anything is contacted, what `tree.resolve` raises, WrongKind, Gone, Silent.
    """
    direct = _is_direct(word)
    named = tree.Node(Address(word), "unsure", reference(word)) if direct else await _bound(word)
    (node,) = await tree.check_alive([named])
    if node.kind == "manager":
        return node
    if direct and isinstance(node.error, errors.Gone):
        raise errors.NoSuch(word, "object", _split(word)[1])
    if direct and isinstance(node.error, errors.ConnectionRefused):
        raise errors.NoManager(word)
    raise node.error or errors.WrongKind(str(node.path), "manager", node.what)


def _is_direct(word):
    """Whether it is a corbaloc of the manager itself, not of what is below another manager."""
    return word.startswith("corbaloc:") and not word.partition("/manager/")[2]


async def _bound(word):
    (path,) = await lookup.paths([word])
    if path.port is not None:
        raise errors.WrongKind(str(path), "manager", "port")
    return await tree.resolve(path)


def check(word):
    """Raise BadPath for what cannot name a manager; contacts nobody."""
    if _is_direct(word):
        _split(word)
    else:
        parse(word)


def _split(word):
    """(address, key) of a corbaloc. Raises BadPath."""
    import re

    match = re.match(CORBALOC, word)
    if not match or split_address(match.group(1))[1] is None:
        raise errors.BadPath(printable(word), "not corbaloc:iiop:HOST[:PORT][/KEY]")
    return match.group(1), match.group(2) or "manager"


def check_argument(argument):
    """Raise Usage for a wrong argument of `create`; contacts nobody.

    Managers know no escaping: they refuse a second ? and skip what is not KEY=VALUE, both silently.
    """
    module, _, pairs = argument.partition("?")
    if not module or not _are_pairs(pairs):
        raise errors.Usage(f"not MODULE[?KEY=VALUE&KEY=VALUE…]: {printable(argument)}")


def check_pairs(pairs):
    """Raise Usage for what cannot come after the ? of such an argument."""
    if not _are_pairs(pairs):
        raise errors.Usage(f"not KEY=VALUE&KEY=VALUE…: {printable(pairs)}")


def _are_pairs(text):
    return "?" not in text and all(pair.count("=") == 1 for pair in text.split("&") if pair)


def reference(word):
    """The reference that a corbaloc of a manager means; contacts nobody. Raises BadPath."""
    address, key = _split(word)
    return orb.corbaloc(word, address, key, MANAGER_PORT)


# ---- what it has ----


async def components(node):
    """(instance name, Node) of each live component; a master lists those of its slaves, too."""
    living = [child for child in await tree.managed(node) if child.kind == "component"]
    return [(child.path.names[-1].id, child) for child in living]


async def profiles(node, is_wanted=lambda child: True):
    """(Node, component.Profile) of those of its components for which is_wanted(Node) is true; an errors.Error
    for what failed.

    Those that are gone are left out, although managers may still list them.
    """

    async def profiled(child):
        await ports.ports(child)  # first, see `component.profile`
        return child, await component.profile(child)

    children = [child for child in await tree.managed(node) if child.kind != "zombie" and is_wanted(child)]
    children.sort(key=lambda child: str(child.path))
    return await session.each([child.error or child for child in children], profiled)


async def configuration(node):
    """Its configuration as a list of (key, value) texts."""
    return orb.properties(await node.call("get_configuration"))


async def profile(node):
    """Its profile (RTM::ManagerProfile) as a list of (key, value) texts."""
    return orb.properties((await node.call("get_profile")).properties)


async def modules(node, operation="get_loadable_modules"):
    """Profiles of modules as dicts, sorted, each once: get_loadable_modules, get_loaded_modules or
    get_factory_profiles.

    A master can create what its slaves have loaded: some masters report that, those of C++ 2.1 do not.
    """
    listed = await _modules(node, operation)
    if operation != "get_loadable_modules":
        for answer in await session.each(await _slaves(node), lambda slave: _modules(slave, operation)):
            if not isinstance(answer, errors.Error):
                listed += answer
    distinct = {tuple(sorted(module.items())): module for module in listed}
    return sorted(distinct.values(), key=_id_and_file)


def _id_and_file(module):
    return component_id(module), module.get("file_path", "")


async def labels(node, operation, key=None):
    """What `modules` returns as texts, by a property or by their ids; neighbours that are alike once."""
    listed = [
        module.get(key, "") if key else component_id(module) for module in await modules(node, operation)
    ]
    # a factory may have other defaults in another slave
    return [label for label, _ in itertools.groupby(listed)]


async def _modules(node, operation):
    seconds = MODULES_TIME if operation == "get_loadable_modules" else None
    return [dict(orb.properties(module.properties)) for module in await node.call(operation, seconds=seconds)]


async def _loaded(node):
    return [module.get("file_path", "") for module in await _modules(node, "get_loaded_modules")]


def component_id(properties):
    """RTC:vendor:category:implementation:language:version of a module's properties,
    as create_component takes it.
    """
    keys = ("vendor", "category", "implementation_id", "language", "version")
    return ":".join(["RTC"] + [properties.get(key, "") for key in keys])


# ---- changing ----


async def create(node, argument, wait=None):
    """Create a component and return its instance name. `argument` is MODULE[?key=value[&key=value…]].

    `wait`: the seconds until it is initialised and the manager lists it. Raises Refused with what is
    known of the reason.
    """
    before = await components(node)
    instance_name = dict(
        pair.split("=", 1) for pair in argument.partition("?")[2].split("&") if "=" in pair
    ).get("instance_name")
    if instance_name in [name for name, _ in before]:
        # managers do not refuse it: two components of one name crash their process later (C++ 1.x)
        raise errors.Refused(str(node.path), f"has a component {printable(instance_name)} already")
    slaves = [slave.ref for slave in await tree.slaves(node)]
    ref = None
    for spelling in await _spellings(node, argument):
        ref = ref or await node.call("create_component", to_wire(spelling), seconds=CREATE_TIME)
    if ref is None:
        why = await _why_not(node, argument)
        await _end_empty_slaves(node, slaves)
        raise errors.Refused(str(node.path), f"does not create {printable(argument)} ({why})")
    created = tree.Node(node.path, "component", ref)
    name = from_wire(await component.uncertain_if_refused(created.call("get_sdo_id")))
    if any(orb.same(ref, before_profile.ref) for _, before_profile in before):
        why = f"created nothing new: it returned {printable(name)}, which was there"
        raise errors.Refused(str(node.path), why)
    if name in [before_name for before_name, _ in before]:
        raise errors.Refused(str(node.path), await _same_name(node, created, printable(name)))
    if wait is not None:
        late = f"{printable(name)} is not ready"
        await _until(wait, lambda: _is_ready(node, name, created), str(node.path), late)
    return name


async def _end_empty_slaves(node, before):
    """End the slaves that a master has started for what could not be created, and that would stay (C++ 2.1):
    those that it had not `before`, references, and that have nothing, after a while in which others may have
    something made there.
    """
    new = [slave for slave in await _slaves(node) if not any(orb.same(slave.ref, ref) for ref in before)]
    if new:
        await loop.sleep(PAUSE)
    for slave in new:
        if not await slave.call("get_components"):
            await _ended(slave, END_TIME)


async def _same_name(node, created, name):
    """Why create returned an existing name: what became of it.

    A Python factory keeps the last name that it was given, makes another component of that name, and lists it
    nowhere.
    """
    if await component.uncertain_if_refused(_lists(node, created.ref)):
        return f"made a second component called {name}: only one of them is found by that name; delete one"
    return (
        f"created nothing of use: it returned the name {name}, which is taken; give another one: "
        "?instance_name=…"
    )


async def _spellings(node, argument):
    """The argument, and its other form: an identity has no language for C++ 1.1, and one for all later
    versions.

    Without a language, it is first looked up, see `whole_id`.
    """
    ident, mark, rest = argument.partition("?")
    fields = ident.split(":")
    if fields[0] != "RTC" or len(fields) not in (5, 6):
        return [argument]
    whole = await whole_id(node, ident)
    is_old = await _is_old(node)
    if not is_old:
        # it knows no id without a language, and a master of C++ 2.1 would start a slave to look there
        return [whole + mark + rest] if whole.count(":") == 5 else []
    parts = fields[:4]
    if whole.count(":") == 4:
        parts.append("")
    other = ":".join(parts + fields[-1:])
    return [whole + mark + rest, other + mark + rest]


async def _is_old(node):
    """Whether a manager is older than 1.2, or of RtORB, whose ids have no language."""
    return not dict(await configuration(node)).get("openrtm.version", "").startswith(("1.2", "2."))


async def whole_id(node, ident):
    """The id of a component (RTC:vendor:category:name:version) with its language, as a factory or a loadable
    module has it.

    `name` may be that of the implementation or of the type. Returns `ident` where it has a language, or
    nothing like it is known. A master of C++ 2.1 starts a new slave process for each creation by an id that
    no loaded factory has.
    """
    fields = ident.split(":")
    if len(fields) == 6 and fields[4]:
        return ident
    _, vendor, category, name = fields[:4]
    fields_of_id = {"vendor": vendor, "category": category, "version": fields[-1]}
    for operation in ("get_factory_profiles", "get_loadable_modules"):
        for module in await modules(node, operation):
            is_named = name in (module.get("implementation_id"), module.get("type_name"))
            # Python may not find out all
            if is_named and all(module.get(key, "") in ("", value) for key, value in fields_of_id.items()):
                return component_id(module)
    return ident


async def _why_not(node, argument):
    """What can be found out of the reason: managers give none."""
    ident = argument.partition("?")[0]
    bare_id = ident.split(":")[3] if ident.count(":") > 3 else ident
    factories = await modules(node, "get_factory_profiles")
    alike = [factory for factory in factories if factory.get("implementation_id") == bare_id]
    if not alike:
        ids = sorted({factory.get("implementation_id", "") for factory in factories})
        return f"no factory {printable(bare_id)}; there are: {printable(', '.join(ids)) or 'none'}"
    if ident != bare_id and ident not in map(component_id, alike):
        return "there is " + printable(", ".join(map(component_id, alike)))
    most = alike[0].get("max_instance", "0")
    limit = f"its max_instance of {printable(most)} is reached, " if most != "0" else ""
    return f"a wrong argument, {limit}or its own initialisation failed"


async def _is_ready(node, name, created):
    return name in [listed for listed, _ in await components(node)] and await component.state(
        created
    ) not in ("Created", "Unknown")


async def delete(node, instance):
    """Delete a component of this manager or of one of its slaves, and wait until it is listed no longer.

    Raises NoSuch, Refused, Unreachable.
    """
    matching = [child for name, child in await components(node) if name == instance]
    if not matching:
        raise errors.NoSuch(str(node.path), "component", printable(instance))
    if len(matching) > 1:
        what = "single component (its slaves have several)"
        raise errors.NoSuch(str(node.path), what, printable(instance))
    # a master returns BAD_PARAMETER for the name of a slave's component, or RTC_OK and does nothing (C++ 1.1)
    holder = node
    for slave in await _slaves(node):
        if await _lists(slave, matching[0].ref):
            holder = slave
            break
    await exiting.leave(matching[0])
    code = str(await holder.call("delete_component", to_wire(instance), seconds=CREATE_TIME))
    if code != "RTC_OK":
        raise errors.Refused(str(node.path), f"does not delete {printable(instance)} ({code})")

    async def is_forgotten():
        return not await _lists(node, matching[0].ref)

    await _until(SETTLE_TIME, is_forgotten, str(node.path), f"still lists {printable(instance)}")


async def _slaves(node):
    return [slave for slave in await tree.slaves(node) if slave.kind == "manager"]


async def _lists(node, ref):
    return any(orb.same(listed, ref) for listed in await node.call("get_components"))


async def load(node, file_path, function):
    """Load a module; `function` is its initialisation function. Raises Refused when it is not there
    afterwards.

    Returns how many factories there are that were not there before.
    """
    before = await _loaded(node)
    factories = len(await _modules(node, "get_factory_profiles"))
    code = str(await node.call("load_module", to_wire(file_path), to_wire(function), seconds=CREATE_TIME))
    after = await _loaded(node)
    is_loaded = meant(file_path, after) or len(after) > len(before)
    if code != "RTC_OK" or not is_loaded:
        raise errors.Refused(str(node.path), f"did not load {printable(file_path)} (it returned {code})")
    return len(await _modules(node, "get_factory_profiles")) - factories


def meant(word, paths):
    """Those of the loaded modules' paths that a word means: a path as it is listed, or what such a module is
    loaded by.

    That may be relative to the manager's load path, have ./ or // or a variable of its environment
    ($DIR/Camera.so) in it, and for Python lack .py.
    """
    import re

    if word in paths:
        return [word]
    tail = re.sub(r"^(\.\./)*", "", _plain(re.sub(r"^.*\$[^/]*/", "", word)))
    plain_paths = {path: _plain(path) for path in paths}

    def ends(path):
        return path == tail or path.endswith("/" + tail.lstrip("/"))

    exact = sorted(path for path, plain in plain_paths.items() if ends(plain))
    if exact:
        return exact
    return sorted(path for path, plain in plain_paths.items() if ends(posixpath.splitext(plain)[0]))


def _plain(path):
    """A path without ./, // and .., with / even where it is one of Windows."""
    plain = posixpath.normpath(path.replace("\\", "/"))
    return plain[1:] if plain.startswith("//") else plain


async def unload(node, word):
    """Unload the module that `word` means, see `meant`. Raises NoSuch, Failed while a component of it lives,
    Refused.

    A master is asked to unload its own, else the slave that has it. Returns the name of a component that the
    manager still offers to create although its code is gone, '' if none: to create it would end its process
    (C++ 2.1).
    """
    slaves = await _slaves(node)
    loaded = [(holder, await _loaded(holder)) for holder in [node] + slaves]
    paths = meant(word, [path for _, listed in loaded for path in listed])
    if not paths:
        raise errors.NoSuch(str(node.path), "loaded module", printable(word))
    if len(paths) > 1:
        raise errors.NoSuch(str(node.path), "single loaded module", printable(word))
    path = paths[0]
    code = ""
    for holder, listed in loaded:
        if path not in listed:
            continue
        await _must_be_unused(holder, path)
        try:  # a master may list its slaves' modules, but refuses to unload them
            code = str(await holder.call("unload_module", to_wire(path)))
        except errors.Refused as e:
            code = e.why
            continue
        if code != "RTC_OK":
            continue
        if (await _loaded(holder)).count(path) < listed.count(path):
            return await _still_offered(holder, path)
    raise errors.Refused(str(node.path), f"did not unload {printable(path)} (it returned {code})")


async def _must_be_unused(node, path):
    """Raise Failed if a component of a compiled module lives:
    to lose its code would end its process (C++ 2.1).
    """
    for answer in await profiles(node, lambda child: child.endpoint == node.endpoint):
        if isinstance(answer, errors.Error):
            continue
        if _is_of(path, dict(answer[1].properties)):
            user = printable(answer[1].instance_name)
            why = f"{printable(path)} is in use by {user}, whose process would end; delete it first"
            raise errors.Failed(str(node.path), why)


async def _still_offered(node, path):
    factories = await _modules(node, "get_factory_profiles")
    return next((factory["implementation_id"] for factory in factories if _is_of(path, factory)), "")


def _is_of(path, properties):
    """Whether a component or factory is of a compiled module,
    which usually has the name of its implementation.
    """
    name = posixpath.splitext(posixpath.basename(path.replace("\\", "/")))[0]
    return properties.get("implementation_id") == name and properties.get("language") != "Python"


async def set_configuration(node, key, value):
    """Set a configuration value; many are read only when a manager starts.
    Raises Refused if it was not set.
    """
    code = str(await node.call("set_configuration", to_wire(key), to_wire(value)))
    now = dict(await configuration(node)).get(key)
    if code != "RTC_OK" or now != value:
        shown = "missing" if now is None else printable(now) or "empty"
        why = f"did not set {printable(key)} (it returned {code}; the value is {shown})"
        raise errors.Refused(str(node.path), why)


async def shut_down(node, wait=None, above=()):
    """End the processes of a manager's slaves, then its own; lines and errors.Errors, see `cli.report`.

    Slaves can only be found through their master, so it is left running if one of them is. A process may take
    `wait` seconds, or END_TIME; it has ended when nobody listens there any more.
    """
    managers = [node.ref] + list(above)
    slaves = [
        slave
        for slave in await tree.slaves(node)
        if slave.kind != "zombie" and not any(orb.same(slave.ref, ref) for ref in managers)
    ]
    asked = [slave.error or slave for slave in slaves]
    parts = await session.each(asked, lambda slave: shut_down(slave, wait, managers))
    results = []
    left = []
    for slave, part in zip(slaves, parts):
        if isinstance(part, errors.Error):
            part = [part]
        results += part
        if any(isinstance(line, errors.Error) for line in part):
            left.append(slave)
    if left:
        why = f"its slave {left[0].path!s} still runs, and cannot be found without it"
        return results + [errors.NotTried(str(node.path), why)]
    return results + [await _ended(node, END_TIME if wait is None else wait)]


async def _delete_composites(node):
    """Delete the composites in a manager's own process: C++ 2.1 aborts if it ends with one, as its members
    are gone first. Those that are not deleted end with it.
    """
    for answer in await profiles(node, lambda child: child.endpoint == node.endpoint):
        if isinstance(answer, errors.Error):
            continue
        child, profile = answer
        if profile.category.startswith("composite."):
            try:
                await exiting.leave(child)
                await node.call("delete_component", to_wire(profile.instance_name), seconds=CREATE_TIME)
            except errors.Error:
                pass


async def _ended(node, seconds):
    """End the process of one manager: a line, or an errors.Error."""
    try:
        await _delete_composites(node)
        code = str(await node.call("shutdown"))
        if code != "RTC_OK":
            return errors.Refused(str(node.path), f"does not shut down ({code})")
    except (errors.Unanswered, errors.Refused) as e:
        return e
    except errors.Unreachable:
        pass  # it may have ended before it answered
    if not await component.until(lambda: _is_over(node), seconds):
        return errors.Unreachable(str(node.path), f"its process has not ended within {seconds:g}s")
    return f"shut down {node.path}"


async def _is_over(node):
    try:
        await orb.call(node.path, node.ref, "_non_existent")
    except errors.ConnectionRefused:
        return True
    except errors.Error:
        pass
    return False


async def _until(limit, reached, where, otherwise):
    if not await component.until(lambda: component.uncertain_if_refused(reached()), limit):
        raise errors.Unreachable(where, f"{otherwise} after {limit:g}s")
