"""Each manager: whether it answers, and whether what it lists is there."""
from rtshell_lite import component, errors, rpc, tree
from rtshell_lite.doctor.finding import counted, fail, ok, published, reason, restart
from rtshell_lite.text import shell_word


def findings(nodes):
    """Findings on the managers among the Nodes, sorted by path."""
    managers = sorted((node for node in nodes if node.kind == "manager"), key=lambda node: str(node.path))
    found = []
    for node, answer in zip(managers, tree.on_nodes(managers, _ask)):
        found += _troubles(node, answer)
    return found


def _ask(node):
    """(slaves, components, whether it had to be asked twice): a master whose slave has died fails once."""
    failed_once = []
    slaves = component.once_more(lambda: tree.slaves(node), failed_once)
    managed = component.once_more(lambda: tree.managed(node), failed_once)
    return slaves, managed, bool(failed_once)


def _troubles(node, answer):
    where, word = str(node.path), shell_word(str(node.path))
    if isinstance(answer, errors.Error) and answer.args[1:] == (rpc.NO_TIME,):
        return [fail("manager", where, "slow: " + rpc.NO_TIME, "rtdoctor --timeout 30 " + word)]
    if isinstance(answer, errors.Error):
        whom = "it, or a slave that it waits for" if isinstance(answer, errors.Silent) else "it"
        return [fail("manager", where, "does not tell what it has (%s)" % reason(answer), restart(node.endpoint[1], whom))]
    slaves, components, twice = answer
    found = []
    if twice:
        found = [fail("manager", where, "one of its slaves has died, and its components with it", "restart that slave")]
    for each in slaves + components:
        what = "lists a slave that " if each in slaves else "lists a component that "
        if each.kind == "zombie":
            found.append(fail("manager", where, what + "is gone", "restart it; rtls %s marks what is gone" % word))
        elif each.kind == "silent":
            found.append(fail("manager", where, what + "hangs (%s)" % reason(each.error), "rtls -l " + word))
    return found or [ok("manager", where, "manager of %s, %s" % (
        counted(len(components), "component"), counted(len(slaves), "slave") + ", at " + published(node.ref)))]
