"""What users may call an object, and the Paths that they mean: one rule for all commands.

    paths = await lookup.paths(args.paths)

An ordinary path is taken as it is, and costs no call. These are looked up:

    localhost:2810/robot.host_cxt/Motor0.rtc   is taken from the root, where the first word is HOST:PORT or a
                                               name server of RTCTREE_NAMESERVERS, and the working directory
                                               has no such entry
    /localhost/*/Motor0.rtc                    * is any one directory, ** any number of them
    Motor0.rtc                                 with RTSHELL_FIND=1, or below the working directory /**
                                               (rtcwd --find): the one component of that name
    rtcloc://localhost:2810/example/Motor0     the component of a manager, if it is of that category
"""

import os

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb
from rtshell_lite.path import (
    ANY, REFERENCES, ROOT, Name, Path, elements, follow, has_kind, is_absolute, parse, split_address,
    working_directory,
)
from rtshell_lite.robot import tree
from rtshell_lite.text import listed, printable, shell_word

EVERYWHERE = Path("**", (), None, False)  # as a working directory


async def paths(words):
    """The Paths that a user means by `words`, in order.

    Raises BadPath, Ambiguous, NotFound where nothing fits a pattern, and what looking it up raises.
    """
    return [await _path(word) for word in words]


def with_components(result, remedy="rtfind {} -t c prints the components in it"):
    """A WrongKind that says how to name the components in a directory; anything else as it is."""
    if not isinstance(result, errors.WrongKind):
        return result
    where, expected, kind = result.args
    if kind in ("directory", "name server", "root directory"):
        kind += "; " + remedy.format(shell_word(where))
    return errors.WrongKind(where, expected, kind)


def need_ports(paths):
    """Raise Usage for a Path that names no port."""
    for path in paths:
        if path.port is None:
            raise errors.Usage(f"{path!s}: no port specified")


async def tops(words, dotted=False):
    """Like `paths`, for what a command looks at as a whole: a word without a dot (robot1), or with one if
    these are name servers in the first place (robot1.local), is a name server, too, where the working
    directory has no such entry. Raises Usage for a port.
    """
    may_be_server = _may_be_dotted if dotted else _may_be_host
    top_paths = [await _path(word, may_be_server) for word in words]
    for word, path in zip(words, top_paths):
        if path.port is not None:
            raise errors.Usage(f"{printable(word)}: name its component, not a port")
    return top_paths


async def _path(word, may_be_server=None):
    path = parse(word) if is_absolute(word) else await _relative(word, may_be_server)
    if path.server == "**" and not path.names:
        return ROOT
    is_pattern = path.server in ANY or any(_is_any(name) for name in path.names[:-1])
    if is_pattern and path.names:
        path = await _single(path)
    if word.startswith("rtcloc"):
        await _check_category(path, word)
    if path.server and _is_no_server(path.server):
        raise errors.NoServer(path)
    return path


def _is_no_server(server):
    """Whether a path begins with the name of something that a name server has."""
    return has_kind(server) and not server.startswith(REFERENCES) and server not in tree.servers()


# ---- relative paths ----


async def _relative(word, may_be_server):
    """The Path of a word that starts neither at the root nor with a reference."""
    above = working_directory()
    names = elements(word)
    first, *rest = names
    is_from_root = _is_address(first) or may_be_server is not None and may_be_server(first, rest)
    is_to_find = first not in ("", ".", "..") and _is_found_below(above)
    if above in (ROOT, EVERYWHERE):
        is_anywhere = is_to_find and not is_from_root and not (rest and above == ROOT)
        return parse(("/**/" if is_anywhere else "/") + word)
    if is_from_root and not await _is_here(word, first, rest):
        return parse("/" + word)
    if is_to_find and not rest and not await _is_here(word, first, rest):
        return parse("/**/" + word)
    return follow(above, names, word)


def is_found_by_name():
    """Whether a lone name is to be found wherever it is."""
    return _is_found_below(working_directory())


def _is_found_below(above):
    return above == EVERYWHERE or os.environ.get("RTSHELL_FIND", "") not in ("", "0")


async def _is_here(word, first, rest):
    """Whether the working directory has an entry for the first element of a relative path."""
    try:
        path = parse(first + "/x").parent() if rest else parse(word).object()
        await tree.resolve(path)
        return True
    except errors.Error:
        return False


def _is_address(word):
    """Whether the first word of a path is HOST:PORT, an IP address, or a name server of
    RTCTREE_NAMESERVERS.
    """
    if has_kind(word.partition(":")[0]):
        return False
    host, port = split_address(word)
    if host in ("", ".", ".."):
        return False
    addresses = [split_address(address) for address in tree.servers()]
    if port is None:
        return _has_bad_port(word, [host for host, _ in addresses])
    if (host, port) in addresses:
        return True
    return host != word or host.startswith("[") or _is_ipv4(host)


def _is_ipv4(host):
    parts = host.split(".")
    return len(parts) == 4 and all(part.isdecimal() for part in parts)


def _has_bad_port(word, hosts):
    """Whether this is a known host with what is not a TCP port: reported as such, not as a missing entry."""
    host, _, port = word.partition(":")
    return host in hosts or port.isdigit() and int(port) > 65535


def _may_be_host(first, rest):
    return not rest and "." not in first and _may_be_dotted(first, rest)


def _may_be_dotted(first, rest):
    host, port = split_address(first)
    is_host = port is not None and host not in ("", ".", "..")
    return is_host and "\\" not in host and not has_kind(host)


def explained(word, error):
    """The error of a path that was typed as `word`, with the name server that a lone word may mean."""
    import re

    is_missing = type(error) is errors.NotFound and error.where == str(parse(word))
    if is_missing and not has_kind(word) and re.match(r"[A-Za-z0-9][A-Za-z0-9.-]{2,}$", word):
        return errors.NoEntry(error.where, "/" + word)
    return error


def is_path(word):
    """Whether a word that may be a file is a path in the RTC Tree by its looks."""
    names = elements(word)
    if is_absolute(word) or names[-1] in (".", ".."):
        return True
    return _is_address(names[0]) or has_kind(names[-1])


# ---- patterns ----


def has_pattern(word):
    """Whether a path has * or ** in the place of a directory, were there another name after it."""
    path = parse(word or ".")
    return path.server in ANY or any(_is_any(name) for name in path.names)


async def below(path):
    """The Nodes in all directories that a Path with * or ** fits. Asks name servers only."""
    pattern = _pattern(path)
    nodes = await _walk(path.child(Name("", "")))
    return [node for node in nodes if _fits(node.path.names, pattern + node.path.names[-1:])]


def _pattern(path):
    """What the names of a Path have to fit that one with patterns means."""
    return (Name("**", ""),) + path.names if path.server == "**" else path.names


def _is_any(name):
    return not name.kind and name.id in ANY


async def _single(path):
    """The Path of the one object that a Path with * or ** before its last name fits."""
    pattern = _pattern(path)
    by_identity = {}
    failed = []
    for node in await _walk(path):
        if _fits(node.path.names, pattern):
            by_identity.setdefault(orb.identity(node.ref), node.path)
        elif node.error and (node.kind in ("server", "directory") or not node.path.names):
            failed.append(node.error)
    candidates = sorted(map(str, by_identity.values()))
    if len(candidates) > 1:
        raise errors.Ambiguous(str(path), f"is one of {len(candidates)}: {listed(candidates)}")
    if not candidates and failed:
        raise failed[0]
    if not candidates:
        raise tree.nothing_at(path, _before_patterns(path))
    for failure in failed:
        notes.note(f"not searched: {failure}")
    (only,) = by_identity.values()
    notes.detail(f"{path} is {only}")
    return only._replace(port=path.port, directory=path.directory)


async def _walk(path):
    """The Nodes below what comes before the first pattern of a Path."""
    patterns = [name.id for name in path.names if _is_any(name)]
    depth = None if path.server == "**" or "**" in patterns else len(path.names)
    if path.server in ANY:
        servers = [tree.name_server(address) for address in tree.servers()]
        return await tree.walk_servers(servers, depth or tree.DEPTH, managers=False)
    above = _before_patterns(path)
    top = await tree.resolve(above)
    nodes = await tree.walk(top, depth and depth - len(above.names), managers=False)
    if top.error is not None:
        raise top.error
    return nodes


def _before_patterns(path):
    """The Path of what comes before the first pattern of a Path."""
    if path.server in ANY:
        return ROOT
    plain = next(index for index, name in enumerate(path.names) if _is_any(name))
    return Path(path.server, path.names[:plain], None, False)


def _fits(names, pattern):
    """Whether the names of a Path fit those of one with patterns."""
    if not names:
        return False
    if len(pattern) == 1:  # of a component, the kind may be left out
        last = (pattern[0], Name(pattern[0].id, pattern[0].kind or "rtc"))
        return len(names) == 1 and names[0] in last
    if pattern[0] == ("**", ""):
        return any(_fits(names[index:], pattern[1:]) for index in range(len(names)))
    return (_is_any(pattern[0]) or names[0] == pattern[0]) and _fits(names[1:], pattern[1:])


# ---- OpenRTM's own ----


async def _check_category(path, word):
    """Raise NoSuch for rtcloc://HOST:PORT/CATEGORY/NAME if the component is of another category."""
    from rtshell_lite.robot import component, ports

    categories = word.split("/")[3:-1]
    if not categories or categories == ["*"]:
        return
    node = await tree.component(path.object())
    await ports.ports(node)  # first, see `component.profile`
    category = (await component.profile(node)).category
    if [category] != categories:
        why = f"it is of the category {printable(category)}"
        raise errors.NoSuch(str(path), "component of that category", why)
