"""What rtcomp does: find or make a composite on a manager, then change its members and exported ports."""
from rtshell_lite import errors, manager, organisation, tree
from rtshell_lite.text import shell_word

DEFAULT_NAME = "CompositeRTC"


def compose(target, adding, removing, type_name=organisation.COMPOSITE, options="", dry_run=False):
    """Make or change the composite at `target` (a Path): lines that say what was done, see `cli.report`.

    `adding` and `removing` are Paths whose port part is a comma-separated list. Everything is checked before the first
    change. Raises WrongKind, NoSuch, Refused, and what `tree.component` raises.
    """
    members = [organisation.member(path) for path in adding]
    leaving = [organisation.member(path, must_live=False) for path in removing]
    holder = tree.resolve(target)
    if holder.kind == "component":
        composite = tree.component(target.object())
    elif holder.kind == "manager":
        composite = _of_manager(holder, target.port or DEFAULT_NAME)
    else:
        raise errors.WrongKind(str(holder.path), "component or manager", holder.what)
    if composite is not None:
        organisation.the_one(composite)
    elif leaving:
        raise errors.No(str(holder.path), "cannot remove components or ports from a new composite")
    if dry_run:
        return _commands(holder, target, composite, adding, removing, type_name, options)
    lines = []
    if composite is None:
        name = target.port or DEFAULT_NAME
        argument = "%s?instance_name=%s%s" % (type_name, name, "&" + options if options else "")
        lines.append("created composite " + manager.create(holder, argument, wait=manager.SETTLE_TIME))
        composite = _of_manager(holder, name)
    if members:
        lines += organisation.add(composite, members)
    if leaving:
        lines += organisation.remove(composite, leaving)
    return lines


def _of_manager(holder, name):
    return dict(manager.components(holder)).get(name)


def _commands(holder, target, composite, adding, removing, type_name, options):
    words = ["rtcomp"] + ["-t", type_name] * (composite is None) + ["-o", options] * bool(options)
    for option, paths in (("-a", adding), ("-r", removing)):
        for path in paths:
            words += [option, str(path)]
    return [" ".join(shell_word(word) for word in words + [str(target)])]
