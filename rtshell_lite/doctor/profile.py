"""What rtcheck finds, as findings: where the running system differs from an RtsProfile."""
from rtshell_lite import compare, path
from rtshell_lite.doctor.finding import counted, fail, ok, reason, warn
from rtshell_lite.text import safe, shell_word

TRANSITIONS = {("Inactive", "Active"): "rtact", ("Active", "Inactive"): "rtdeact", ("Error", "Active"): "rtreset",
               ("Error", "Inactive"): "rtreset"}


def findings(profile, file, state):
    """Findings from the comparison of what runs with an RtsProfile, on a command line `file`; optional things are warnings."""
    result = compare.compare(profile, state)
    found = [fail("profile", str(e.args[0]), reason(e), "rtcat %s" % e.args[0]) for e in result.failures]
    for each in result.differences:
        found.append((fail if each.required else warn)("profile", each.path, safe(each.message), _remedy(each, file)))
    return found or [ok("profile", str(path.ROOT), "as the profile says: %s, %s" % (
        counted(len(profile.components), "component"),
        counted(len(profile.connectors), "connection")))]


def _remedy(each, file):
    """What brings the system back to what the file says: rtresurrect does all but start components and set states."""
    if each.check == "state":
        return "%s %s" % (TRANSITIONS.get((each.actual, each.expected), "rtls -l"), shell_word(each.path))
    if each.message.partition(": ")[0].endswith("component missing"):
        return "start it, or have its manager make it: rtresurrect --create " + file
    return "rtresurrect " + file
