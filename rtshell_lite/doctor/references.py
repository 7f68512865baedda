"""Each name in a name server and the reference behind it: where it leads, whether it can be reached, whether it lives."""
from rtshell_lite import errors, orb
from rtshell_lite.doctor import addresses
from rtshell_lite.doctor.finding import fail, ok, published, reason, restart, warn
from rtshell_lite.text import printable, shell_word


def findings(visit):
    """Findings on all that is bound in the name server of a servers.Visit, sorted by path."""
    found = []
    for node in visit.nodes:
        if node.kind not in ("root", "server", "directory"):
            found += _unreachable(visit, node) or _not_what_it_says(node)
        elif node.alias is not None or node.foreign:
            found.append(alias(node))
    return sorted(found + _stale_contexts(visit), key=lambda each: each.path)


def _command(program, node):
    return "%s %s" % (program, shell_word(str(node.path)))


# ---- where it leads -------------------------------------------------------------------------------------------

def _unreachable(visit, node):
    """Why an object cannot be used from here, from the outside in: its address, TCP, its process, itself."""
    where = str(node.path)
    if isinstance(node.error, errors.Garbled):
        return [fail("reference", where, "the name is bound to what must not be used: %s" % reason(node.error),
                     "find out who has bound it; its component, started anew, binds it rightly")]
    if node.ref is None:
        return [fail("reference", where, "the name is bound to nothing (a nil reference)", _command("rtdel", node))]
    offered = orb.addresses(node.ref)
    if not offered:
        return []  # other transports: whether the object lives tells all
    told = published(node.ref)
    loopback = _published_loopback(visit, where, offered, told)
    if loopback:
        return loopback
    if node.kind == "zombie":
        return [_dead(node, told)]
    if node.kind == "silent" or node.kind == "unknown" and _out_of_reach(visit, offered):
        return [_silent(visit, node, offered, told)]
    return _half_reachable(visit, where, offered)


def _published_loopback(visit, where, offered, told):
    """A loopback address means somebody else on each host: it serves only those who ask a name server on their own host."""
    if not all(_is_loopback(host) for host, _ in offered) or all(addresses.is_loopback(each) for each in visit.addresses):
        return []
    cure = "give its process an address: corba.endpoints: %s: in rtc.conf" % printable(visit.addresses[0])
    if any(addresses.is_own(each) for each in visit.addresses):
        return [warn("reference", where, "publishes %s: only this host can reach it" % told, cure)]
    return [fail("reference", where, "publishes %s, which means this host, not its own" % told, cure)]


def _is_loopback(host):
    return host == "localhost" or addresses.is_loopback(host)


def _dead(node, told):
    if isinstance(node.error, errors.Gone):
        message = "dead (zombie): who listens at %s now does not have it" % told
    else:
        message = "dead (zombie): nothing listens at %s" % told
    return fail("reference", str(node.path), message, _command("rtdel -z", node))


def _silent(visit, node, offered, told):
    """An object that does not answer: because of its host, the network, its process, or itself."""
    where = str(node.path)
    if _out_of_reach(visit, offered):
        failure = visit.probes[offered[0]]
        if isinstance(failure, errors.ConnectionRefused):
            return fail("reference", where, "dead: nothing listens at " + told, _command("rtdel", node))
        return fail("reference", where, "publishes %s, out of reach (%s)" % (told, reason(failure)),
                    "ping %s; else give its process an address that others reach" % printable(offered[0][0]))
    if isinstance(node.error, errors.Silent):
        return fail("reference", where, "hung: %s accepts TCP, but %s" % (told, reason(node.error)), restart(offered[0][1]))
    return fail("reference", where, "somebody else's: %s does not speak CORBA (%s)" % (told, reason(node.error)),
                "netstat -ltnp | grep :%d there names it; then %s" % (offered[0][1], _command("rtdel", node)))


def _out_of_reach(visit, offered):
    return all(isinstance(visit.probes.get(each), errors.Error) for each in offered)


def _half_reachable(visit, where, offered):
    """Of several addresses some may be out of reach; each caller tries them in turn and waits for the bad ones."""
    bad = [each for each in offered if isinstance(visit.probes.get(each), errors.Error)]
    cure = "have its process publish only addresses that others reach: corba.endpoints in rtc.conf"
    return [warn("reference", where, "also publishes %s:%d, out of reach (%s)" % (
        printable(each[0]), each[1], reason(visit.probes[each])), cure) for each in bad]


# ---- what it is -----------------------------------------------------------------------------------------------

def _not_what_it_says(node):
    """A name of kind rtc or mgr that belongs to an object of another kind: somebody else's; and other objects."""
    kind, expected = node.path.names[-1].kind, {"rtc": "component", "mgr": "manager"}
    what = printable(orb.address(node.ref).type_id) or node.what
    if kind not in expected and node.kind == "unknown":
        return [ok("reference", str(node.path), "another CORBA object, %s, at %s" % (what, published(node.ref)))]
    if kind not in expected or node.kind == expected[kind] or node.kind in ("zombie", "silent"):
        return []
    message = "somebody else's: not a %s but %s" % (expected[kind], what)
    return [fail("reference", str(node.path), message, _command("rtdel", node))]


# ---- contexts -------------------------------------------------------------------------------------------------

def alias(node):
    """The Finding on a naming context that has another name, or belongs to another name server: nothing of it is to be deleted."""
    if node.alias is not None:
        return ok("context", str(node.path), "an alias: the same directory as " + str(node.alias))
    place = "%s:%d" % node.endpoint
    return ok("context", str(node.path), "an alias: a directory of the name server at %s, which is examined by: rtdoctor %s" % (
        printable(place), shell_word(place)))


def _stale_contexts(visit):
    """Naming contexts in which nothing is left, or only dead names; of those inside each other the outermost.

    One that has several names, or in which one with another name is bound, is somebody's.
    """
    found, told, content = [], set(), _content(visit.nodes)
    for node in visit.nodes:
        names = node.path.names
        inside_told = any(names[:i] in told for i in range(len(names)))
        if node.kind != "directory" or inside_told or not _is_forsaken(node, visit.shared):
            continue
        below = content.get(names, ())
        if all(each.kind == "zombie" or each.kind == "directory" and _is_forsaken(each, visit.shared) for each in below):
            told.add(names)
            what = "only dead names are in it" if any(each.kind == "zombie" for each in below) else "empty"
            command = _command("rtdel --recursive" if below else "rtdel", node)
            found.append(warn("context", str(node.path), "stale: " + what, command))
    return found


def _is_forsaken(node, shared):
    """True for a naming context that could be listed and has one name only; `shared` is an aliases.Known of those with more."""
    return node.error is None and not node.foreign and shared.path(node) is None


def _content(nodes):
    """All Nodes that are somewhere below each naming context, by the names of its path."""
    content = {}
    for node in nodes:
        for size in range(1, len(node.path.names)):
            content.setdefault(node.path.names[:size], []).append(node)
    return content
