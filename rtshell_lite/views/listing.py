"""What rtls and rtfind show of nodes: their kind at a glance, a row of figures, or JSON."""

from rtshell_lite import errors, text
from rtshell_lite.corba import session
from rtshell_lite.robot import tree

MARKS = {"zombie": "*", "silent": "?", "unasked": "~"}

# The figures of a component: its state, and a list of (number of ports, number of connected ones) of each
# kind, None where `error` of its Node says why they are not known.
COUNTED = (
    ("ports", None),
    ("in_ports", "DataInPort"),
    ("out_ports", "DataOutPort"),
    ("service_ports", "CorbaPort"),
)

# Above the columns of `row`.
HEAD = ["STATE", "PORTS", "IN", "OUT", "SVC", "NAME"]


async def all_blocks(paths, recurse, typed):
    """`blocks` for each path, in parallel by name server; an errors.Error for what failed.
    `typed` is for the headers.
    """
    return await session.each(
        list(zip(paths, typed)), lambda item: blocks(item[0], recurse, text.safe(item[1])),
        lambda item: (tree.server_endpoint(item[0]), str(item[0])),
    )


async def blocks(path, recurse=False, shown="."):
    """What to list at `path`: [(header, [Node, …])]; the header is None for a single object.

    With `recurse`, a block for every directory below, its header relative to `shown` as in ls -R; a directory
    bound by several names has one for the first. One that cannot be listed is in its parent's block with its
    `error` set. Raises what `tree.resolve` raises, and WrongKind.
    """
    top = await _resolved(path)
    if top.kind not in tree.DIRECTORIES:
        if path.directory:
            raise errors.WrongKind(str(path), "directory", top.what)
        return [(None, [top])]
    if not recurse:
        return [(shown + ":", await tree.children(top))]
    listed = {}
    for node in await tree.walk(top):
        if node.kind in tree.DIRECTORIES and node.alias is None:
            below = str(node.path).lstrip("/")[len(str(top.path).lstrip("/")) :].strip("/")
            header = shown.rstrip("/")
            if below:
                header += "/" + below
            listed[node.path] = (header + ":", [])
        if node is not top:
            listed[node.path.parent()][1].append(node)
    if top.error is not None:
        raise top.error
    return list(listed.values())


async def _resolved(path):
    if path.port is None:
        return await tree.resolve(path)
    await tree.resolve(path)
    raise errors.WrongKind(str(path), "directory or component", "port; rtcat shows it")


async def figures(nodes, long=False):
    """(Node, figures or None) of each node: one liveness call a component, with `long` its figures instead.

    The figures of a component take 4 calls (its contexts, state, ports) and one a port. Its state does not
    depend on other components; its ports may wait for those that they are connected with.
    """
    if not long:
        return [(node, None) for node in await tree.check_alive(nodes)]
    sure = []
    for node in nodes:
        if node.kind == "unsure":
            (node,) = await tree.check_alive([node])
        sure.append(node)
    nodes = sure
    asked = [node for node in nodes if node.kind == "component"]
    answers = dict(zip(asked, await session.each(asked, _figures)))
    rest = [node for node in nodes if node not in answers]
    others = dict(zip(rest, await tree.check_alive(rest)))
    rows = []
    for node in nodes:
        answer = answers.get(node)
        if isinstance(answer, errors.Error):
            node = await tree.classify_answer(node, answer)
            answer = None
        rows.append((others.get(node, node), answer))
    return rows


async def _figures(node):
    """The figures of a component, whose reference is dropped. Raises what its states raise."""
    from rtshell_lite.robot import component, snapshot  # not needed, and not loaded, for names alone

    shown = snapshot.Snapshot(node)
    contexts = {"owned": snapshot.REFERENCES, "participating": snapshot.REFERENCES}
    try:
        await shown.ask(states=snapshot.FULL, **contexts)
        counts = await _ports(shown)
    except (errors.Gone, errors.ConnectionRefused) as e:
        if not shown.answered:
            raise
        raise _passed_on(node, e)
    finally:
        node.ref = None  # 20,000 of them take 16 MB
    return component.merged(shown.states), counts


async def _ports(shown):
    """The numbers of ports of a component; None where they do not come, for the reason in its Node."""
    from rtshell_lite.robot import snapshot

    try:
        await shown.ask(ports=snapshot.BRIEF)
    except errors.Error as e:
        shown.node.error = _passed_on(shown.node, e)
        return None
    return [_counted(shown.ports, kind) for _, kind in COUNTED]


def _counted(ports, kind):
    of_kind = [port for port in ports if kind in (None, port.type)]
    return len(of_kind), sum(bool(port.connectors) for port in of_kind)


def _passed_on(node, e):
    """The error of a component that has answered, though not to all: a port or context may have passed on
    that another component is gone.
    """
    if isinstance(e, errors.Gone):
        return errors.Unreachable(str(node.path), "does not report its ports or states (one of them is gone)")
    if isinstance(e, errors.ConnectionRefused):
        why = "does not report its ports or states (connection refused)"
        return errors.Unreachable(str(node.path), why)
    return e


def short(node, paint, name=None):
    """(a node's name without -l, the same without colour):
    directories end in a slash, zombies and silent ones are marked.
    """
    name = name or node.name
    if node.kind in tree.DIRECTORIES:
        return paint(name, "directory") + "/" + first_name(node), name + "/" + first_name(node)
    role = {"zombie": "zombie", "unknown": "zombie", "silent": "?", "unasked": "?"}.get(node.kind)
    return MARKS.get(node.kind, "") + paint(name, role), MARKS.get(node.kind, "") + name


def first_name(node):
    """` -> PATH` for a directory that a walk has entered by another name, else ''."""
    return " -> " + str(node.alias) if node.alias else ""


def row(node, figures, paint, name=None):
    """The columns of a node with -l: state, connected ports of four kinds, name; `-` for other objects, and
    for what was not asked.
    """
    name = name or node.name
    if figures is None:
        cells = ["-"] * (1 + len(COUNTED))
        if node.kind == "silent":
            cells[0] = paint("?")
        if node.kind in tree.DIRECTORIES:
            role = "directory"
        elif node.kind in ("zombie", "unknown"):
            role = "zombie"
        else:
            role = None
        return cells + [MARKS.get(node.kind, "") + paint(name, role) + first_name(node)]
    state, counts = figures
    cells = [paint(state)]
    if counts is None:
        cells += ["-" if isinstance(node.error, errors.NotAsked) else paint("?")] * len(COUNTED)
    for count, linked in counts or ():
        cells.append(f"{paint(str(count), 'bold')}/{linked}")
    cells.append(name)
    return cells


def path_fields(node):
    """The path and kind of a node for its JSON object;
    `alias` is the first path of a directory bound by several names.
    """
    fields = {"path": str(node.path), "kind": node.kind}
    if node.alias is not None:
        fields["alias"] = str(node.alias)
    return fields


def as_dict(node, figures):
    """The JSON object for a node."""
    fields = dict(path_fields(node), name=node.name)
    if node.error is not None:
        fields["error"] = str(node.error)
    if figures is not None:
        fields["state"], counts = figures
        for (label, _), (count, connected) in zip(COUNTED, counts or ()):
            fields[label], fields[label + "_connected"] = count, connected
    return fields


def silent_ones(nodes):
    """A line on how many of `nodes` did not answer, or were not asked; '' when all answered everything."""
    objects = [node for node in nodes if node.kind in ("component", "manager", "zombie", *tree.DOUBTFUL)]
    times = {}
    for node in objects:
        times[node.name] = times.get(node.name, 0) + 1
    groups = {}
    for node in objects:
        words = _lacking(node)
        if words:
            name = node.name if times[node.name] == 1 else str(node.path)
            groups.setdefault(words, []).append(name)
    parts = []
    for words, names in groups.items():
        shown = ", ".join(names[:5] + ["…"] * (len(names) > 5))
        parts.append(f"{len(names)} {words} ({shown})")
    if parts:
        parts[0] = parts[0].replace(" ", f" of {len(objects)} ", 1)
    return "; ".join(parts)


def _lacking(node):
    """What has not come from a component or manager, in words; '' where nothing is missing."""
    if node.kind == "silent":
        return "did not answer"
    if isinstance(node.error, errors.Unspoken):
        return "cannot be asked from here"
    if node.kind == "unasked":
        return "not asked, as the process did not answer others"
    if node.kind != "component" or node.error is None:
        return ""
    if isinstance(node.error, errors.NotAsked):
        return "not asked for the ports, as others of the process hang when asked"
    return "did not report the ports"
