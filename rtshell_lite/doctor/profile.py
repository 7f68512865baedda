"""Where the running system differs from an RtsProfile, as rtcheck and rtresurrect judge it."""

from rtshell_lite import errors, path
from rtshell_lite.doctor import living, remedies
from rtshell_lite.doctor.finding import fail, ok, reason, warn
from rtshell_lite.robot import contexts, snapshot
from rtshell_lite.system import capture, compare
from rtshell_lite.text import counted, safe, shell_word

TRANSITIONS = {
    ("Inactive", "Active"): "activate",
    ("Active", "Inactive"): "deactivate",
    ("Error", "Inactive"): "reset",
}


async def findings(profile, file, state):
    """Findings on the differences from an RtsProfile, which is `file` on a command line;
    those on optional things are warnings.
    """
    result = await compare.compare(profile, state)
    all_findings = [_unknown(e) for e in result.failures]
    differences = [difference for difference in result.differences if difference.check != compare.OTHER_ID]
    absent = {difference.path: difference for difference in reversed(differences) if _is_missing(difference)}
    differences = [
        difference
        for difference in differences  # each once: ends of connections are missing, too
        if not _is_missing(difference) or absent[difference.path] is difference
    ]
    missing = [component for component in profile.components if capture.shown_path(component) in absent]
    addresses, doubts = await living.find_living(profile, missing) if missing else ({}, {})
    all_findings += living.findings(profile, missing, addresses)
    idle = [difference for difference in differences if _is_idle(difference)]
    if len(idle) > 1:
        paths = ", ".join(difference.path for difference in idle)
        message = f"{len(idle)} components are Inactive, and should be Active: {paths}"
        cure = remedies.command("start system", file=remedies.Line(file))
        all_findings.append(fail("profile", str(path.ROOT), message, cure))
        differences = [difference for difference in differences if difference not in idle]
    for difference in differences:
        report = fail if difference.required else warn
        message = safe(difference.brief)
        if difference.path in addresses and _is_missing(difference):
            message += f", but it lives: {safe(addresses[difference.path])}"
            cure = remedies.words("bind again")
        elif difference.path in doubts and _is_missing(difference):
            why, port = doubts[difference.path]
            message += f", but it may live: {safe(why)}"
            cure = remedies.words("firewall", port=port)
        else:
            cure = _remedy(difference, file)
        all_findings.append(report("profile", difference.path, message, cure))
    all_findings += await _rates(profile)
    content = (
        f"{counted(len(profile.components), 'component')}, {counted(len(profile.connectors), 'connection')}"
    )
    return all_findings or [ok("profile", str(path.ROOT), "as the profile says: " + content)]


def _unknown(e):
    """The Finding on a component that could not be compared."""
    if isinstance(e, errors.NotAsked):
        return warn("profile", e.where, reason(e), remedies.not_asked(e, e.where))
    return fail("profile", e.where, reason(e), remedies.words("look at component", path=shell_word(e.where)))


def _is_idle(difference):
    """Whether a required component is only not activated: to start the whole system does that for all."""
    return (
        difference.required
        and difference.check == "state"
        and (difference.actual, difference.expected) == ("Inactive", "Active")
    )


def _is_missing(difference):
    return difference.message.partition(": ")[0].endswith("component missing")


async def _owned_contexts(node):
    return (await snapshot.of(node, owned=snapshot.FULL)).owned


async def _rates(profile):
    """Findings on execution contexts whose rates differ from those in the file, which the components have."""
    findings = []
    answers = await capture.ask_each(profile, _owned_contexts)
    for component, owned in zip(profile.components, answers):
        if isinstance(owned, errors.Error):
            continue  # reported before
        report = fail if component.is_required else warn
        where = capture.shown_path(component)
        for described in component.execution_contexts:
            if (
                not described.id.isdigit()
                or not 0 < described.rate < float("inf")
                or not described.kind.upper().startswith("PERIODIC")
            ):
                continue
            for index, context in enumerate(owned):
                if context.handle != int(described.id):
                    continue
                if not contexts.same_rate(context.rate, described.rate):
                    message = (
                        f"its execution context has a rate of {context.rate:g} Hz, in the file it is "
                        f"{described.rate:g} Hz"
                    )
                    option, rate = remedies.option(index), f"{described.rate:g}"
                    cure = remedies.command("set rate", option=option, path=where, rate=rate)
                    findings.append(report("profile", where, message, cure))
    return findings


def _remedy(difference, file):
    """What makes the system agree with the file: rtresurrect, except for missing components and states."""
    if difference.check == "state" and (difference.actual, difference.expected) == ("Error", "Active"):
        return remedies.command("reset and activate", path=difference.path)
    if difference.check == "state":
        name = TRANSITIONS.get((difference.actual, difference.expected))
        if name is None:
            return remedies.words("look at state", path=shell_word(difference.path))
        return remedies.command(name, option=[], path=difference.path)
    if _is_missing(difference):
        return remedies.words("start component", file=file)
    return remedies.command("restore", file=remedies.Line(file))
