"""What rtcomp does: find or make a composite on a manager, then change its members and exported ports."""
import collections

from rtshell_lite import errors, manager, organisation, tree
from rtshell_lite.text import printable, shell_word

DEFAULT_NAME = "CompositeRTC"


def compose(target, adding, removing, type_name=organisation.COMPOSITE, options="", dry_run=False):
    """Make or change the composite at `target` (a Path): lines that say what was done, see `cli.report`.

    `adding` and `removing` are Paths whose port part is a comma-separated list. Everything is checked before the first
    change. Raises WrongKind, NoSuch, Refused, and what `tree.component` raises.
    """
    name = target.port or DEFAULT_NAME
    argument = "%s?instance_name=%s%s" % (type_name, name, "&" + options if options else "")
    if any(c in name for c in "?&="):
        raise errors.Usage("a composite cannot be called %s" % printable(name))
    manager.check_argument(argument)
    members = organisation.together([organisation.member(path) for path in adding])
    leaving = [organisation.member(path, must_live=False) for path in collections.OrderedDict.fromkeys(removing)]
    holder = tree.component(target.object(), or_manager=True)
    if holder.kind == "component" and target.port is not None:
        raise errors.WrongKind(str(target), "component or manager", "port")
    composite = holder if holder.kind == "component" else _of_manager(holder, name)
    if composite is None and leaving:
        raise errors.No(str(holder.path), "cannot remove components or ports from a new composite")
    if composite is not None:
        organisation.check(composite, organisation.the_one(composite), members, leaving)
    if dry_run:
        return _commands(target, composite, adding, removing, type_name, options)
    lines = []
    if composite is None:
        lines.append("created composite " + manager.create(holder, argument, wait=manager.SETTLE_TIME))
        composite = _new(holder, name)
    one = organisation.the_one(composite)
    return lines + organisation.add(composite, one, members) + organisation.remove(composite, one, leaving)


def _new(holder, name):
    """The composite that has been made; deleted again if its type makes it a component of another kind."""
    made = _of_manager(holder, name)
    try:
        organisation.the_one(made)
    except errors.WrongKind:
        manager.delete(holder, name)
        raise
    return made


def _of_manager(holder, name):
    return dict(manager.components(holder)).get(name)


def _commands(target, composite, adding, removing, type_name, options):
    words = ["rtcomp"] + ["-t", type_name] * (composite is None) + ["-o", options] * bool(options)
    for option, paths in (("-a", adding), ("-r", removing)):
        for path in paths:
            words += [option, str(path)]
    return [" ".join(shell_word(word) for word in words + [str(target)])]
