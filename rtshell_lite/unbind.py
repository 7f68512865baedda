"""Taking names out of name servers (CosNaming::NamingContext): unbind and destroy, and what must never go by mistake."""
from rtshell_lite import errors, orb, tree
from rtshell_lite.path import Path
from rtshell_lite.text import shell_word


def delete(path, zombie_only=False, recursive=False, dry_run=False):
    """Unbind what `path` names; yields a line (see `cli.report`) for each name, deepest first.

    zombie_only  refuse all but zombies, each verified twice
    recursive    a naming context with all that is below; without it only an empty one goes
    Raises what `tree.resolve` raises, WrongKind, Refused.
    """
    if path.port is not None or not path.names:
        raise errors.WrongKind(str(path), "name that can be deleted", "port" if path.port is not None
                               else "name server" if path.server else "root directory")
    node = tree.resolve(path)
    if tree.resolve(path.parent()).kind == "manager":
        raise errors.WrongKind(str(path.parent()), "directory with names in it", "manager; rtmgr deletes its components")
    if zombie_only:
        yield _delete_zombie(_dead(node), dry_run)
    elif node.kind == "directory":
        for line in _delete_context(node, recursive, dry_run, _contexts_above(path)):
            yield line
    else:
        yield _unbind(node.path, dry_run)


def zombies(top):
    """The zombies at and below the Node `top`: (zombies, Nodes whose listing failed)."""
    nodes = list(tree.walk(top, managers=False))
    return [node for node in tree.look(nodes) if node.kind == "zombie"], [node for node in nodes if node.error is not None]


def delete_zombies(found, dry_run=False):
    """`_delete_zombie` for each: lines, an errors.Error in the place of what failed. What lives after all just stays."""
    results = []
    for node in found:
        try:
            results.append(_delete_zombie(node, dry_run))
        except errors.WrongKind:
            results.append("")
        except errors.Error as e:
            results.append(e)
    return results


def _delete_zombie(node, dry_run):
    """Look a second time: the component may have been started again under its name since."""
    try:
        again = tree.resolve(node.path)
    except errors.NotFound:
        return ""
    return _unbind(_dead(again).path, dry_run, zombie=True)


def _dead(node):
    """Look at a node and return the zombie that it is. Raises WrongKind, or Silent for one that does not tell."""
    node, = tree.look([node])
    if node.kind == "silent":
        raise node.error
    if node.kind != "zombie":
        raise errors.WrongKind(str(node.path), "zombie", node.what)
    return node


def _unbind(path, dry_run, zombie=False):
    if dry_run:
        return "rtdel %s%s" % ("-z " if zombie else "", shell_word(str(path)))
    server = tree.resolve(Path(path.server, (), None, False))
    try:
        server.call("unbind", orb.naming_name(path.names))
    except errors.Refused as e:
        if e.name == "NotFound":
            raise errors.NotFound(str(path))
        raise
    return str(path) + ": deleted"


def _contexts_above(path):
    """The identities of the naming contexts that a path leads through."""
    return tuple(orb.identity(tree.resolve(path._replace(names=path.names[:i])).ref) for i in range(len(path.names)))


def _delete_context(node, recursive, dry_run, above):
    """Delete a naming context, what is below it first. One that is bound inside itself loses only that name."""
    if len(node.path.names) > tree.DEPTH:
        raise errors.Refused(str(node.path), "more than %d directories deep" % tree.DEPTH)
    identity = orb.identity(node.ref)
    below = [] if identity in above else tree.children(node)
    if below and not recursive:
        raise errors.Refused(str(node.path), "not empty (%d name%s); delete it with --recursive"
                             % (len(below), "s" if len(below) > 1 else ""))
    for child in below:
        if child.kind == "directory":
            for line in _delete_context(child, recursive, dry_run, above + (identity,)):
                yield line
        else:
            yield _unbind(child.path, dry_run)
    if identity not in above and not dry_run:
        _destroy(node)
    yield _unbind(node.path, dry_run)


def _destroy(node):
    """Let the server forget an empty context. It refuses when a name has come into it since, which stops the deletion."""
    try:
        node.call("destroy")
    except errors.Refused as e:
        if e.name == "NotEmpty":
            raise errors.Refused(str(node.path), "not empty any more")
        raise
