"""What rtcheck finds, as findings: where the running system differs from an RtsProfile."""
from rtshell_lite import compare, path
from rtshell_lite.doctor.finding import counted, fail, ok, reason, warn
from rtshell_lite.text import safe

REMEDIES = {
    "component": "start it, or correct the file",
    "connection": "connect the ports as the file says: rtcon",
    "active set": "rtconf PATH act SET",
    "configuration": "rtconf PATH set -s SET NAME VALUE",
    "members": "rtcomp -a MEMBER PATH, or rtcomp -r MEMBER PATH",
}
TRANSITIONS = {("Inactive", "Active"): "rtact", ("Active", "Inactive"): "rtdeact", ("Error", "Active"): "rtreset",
               ("Error", "Inactive"): "rtreset"}


def findings(profile, state):
    """Findings from the comparison of an RtsProfile with what runs; what is not required is a warning."""
    result = compare.compare(profile, state)
    found = [fail("profile", str(e.args[0]), reason(e), "rtcat %s" % e.args[0]) for e in result.failures]
    for each in result.differences:
        found.append((fail if each.required else warn)("profile", each.path, safe(each.message), _remedy(each)))
    return found or [ok("profile", str(path.ROOT), "as the profile says: %s, %s" % (
        counted(len(profile.components), "component"),
        counted(len(profile.data_port_connectors + profile.service_port_connectors), "connection")))]


def _remedy(each):
    if each.check == "state":
        return "%s %s" % (TRANSITIONS.get((each.actual, each.expected), "rtls -l"), each.path)
    return REMEDIES[each.check].replace("PATH", each.path)
