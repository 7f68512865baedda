"""What rtcheck finds, as findings: where the running system differs from an RtsProfile."""
from rtshell_lite import errors, path
from rtshell_lite.doctor import remedies
from rtshell_lite.doctor.finding import counted, fail, ok, reason, warn
from rtshell_lite.robot import snapshot
from rtshell_lite.system import capture, compare
from rtshell_lite.text import safe, shell_word

TRANSITIONS = {("Inactive", "Active"): "activate", ("Active", "Inactive"): "deactivate", ("Error", "Inactive"): "reset"}


def findings(profile, file, state):
    """Findings from the comparison of what runs with an RtsProfile, on a command line `file`; optional things are warnings."""
    result = compare.compare(profile, state)
    found = [fail("profile", e.where, reason(e),
                  remedies.words("look at component", path=shell_word(e.where))) for e in result.failures]
    for each in result.differences:
        found.append((fail if each.required else warn)("profile", each.path, safe(each.message), _remedy(each, file)))
    found += _rates(profile)
    return found or [ok("profile", str(path.ROOT), "as the profile says: %s, %s" % (
        counted(len(profile.components), "component"),
        counted(len(profile.connectors), "connection")))]


def _rates(profile):
    """Findings on execution contexts whose rates differ from those in the file; contexts that only one of both has are left out."""
    found = []
    for each, contexts in zip(profile.components, capture.look(profile, lambda node: snapshot.of(node, owned=snapshot.FULL).owned)):
        if isinstance(contexts, errors.Error):
            continue  # found before
        for one in each.execution_contexts:
            if not one.id.isdigit() or not 0 < one.rate < float("inf") or not one.kind.upper().startswith("PERIODIC"):
                continue
            for index, context in enumerate(contexts):
                if context.handle == int(one.id) and context.rate != one.rate:
                    where = capture.shown_path(each)
                    found.append((fail if each.is_required else warn)(
                        "profile", where, "its execution context has a rate of %g Hz, in the file it is %g Hz" % (
                            context.rate, one.rate),
                        remedies.command("set rate", option=remedies.option(index), path=where, rate=f"{one.rate:g}")))
    return found


def _remedy(each, file):
    """What brings the system back to what the file says: rtresurrect does all but start components and set states."""
    if each.check == "state" and (each.actual, each.expected) == ("Error", "Active"):
        return remedies.command("reset and activate", path=each.path)
    if each.check == "state":
        name = TRANSITIONS.get((each.actual, each.expected))
        if name is None:
            return remedies.words("look at state", path=shell_word(each.path))
        return remedies.command(name, option=[], path=each.path)
    if each.message.partition(": ")[0].endswith("component missing"):
        return remedies.words("start component", file=file)
    return remedies.command("restore", file=remedies.Line(file))
