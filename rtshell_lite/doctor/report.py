"""An examination as one file: a page with the findings, the map of the system, and what is known of all of
it.
"""

import base64

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.data import clocks
from rtshell_lite.doctor import host
from rtshell_lite.doctor.finding import LEVELS, Finding, sorted_by_level
from rtshell_lite.net import calendar
from rtshell_lite.robot import component, ports, tree
from rtshell_lite.system import capture, page_file
from rtshell_lite.views import live_graph, page
from rtshell_lite.xmlprofile import rtsprofile
from rtshell_lite.text import counted

CONFIGURATION = ("conf.", "configuration.")  # begins the names of properties with what is configured
WINDOW = 30  # seconds of a log that are shown, its last ones
MOST_PLOTS = 5  # of components with findings
MOST_EVENTS = 10  # of such a component, its last ones
# kinds of Nodes that are objects
BOUND = ("component", "manager", "zombie", "other", "unsure", *tree.DOUBTFUL)


def html(seen, findings, title, log=None, values=True, environment=True):
    """The text of the file.

    seen         the examination.Seen; None if the examination ended early
    findings     all Findings
    log          the name of a log, whose last values are shown
    values       whether values of configuration sets are in it
    environment  whether this host's network, environment and processes are
    """
    if seen is not None and not values:
        _leave_out_values(seen.snapshots)
    system, lost, states = _system(seen)
    profile = rtsprofile.dump(system.profile, rtsprofile.YAML)
    drawing = live_graph.of_system(system, lost, states)
    remarks = sorted_by_level(findings) + [page.Remark("note", "", "", line, "") for line in drawing.notes]
    fields = page.fields(drawing.picture, drawing.profile, title, "", remarks)
    fields["what"] = page.origin("rtdoctor --report")
    sections = _sections(seen, environment) + [("This report", _contents(log, values, environment))]
    if log:
        fields["plots"], events = _of_log(log, remarks)
        sections = events + sections
    fields["sections"] = [(page.shown(heading), page.shown(text)) for heading, text in sections if text]
    fields["profile"] = profile
    return page.html(fields)


def findings_in(text, name):
    """The Findings in the text of a report. Raises errors.Failed."""
    page_file.profile(text, name)  # other pages have none
    try:
        findings = [
            Finding(*[str(dict({"cause": ""}, **row)[field]) for field in Finding._fields])
            for row in page_file.read(text, name)["findings"]
        ]
    except (KeyError, TypeError):
        raise errors.Failed(name, "not a report of rtdoctor")
    return [finding for finding in findings if finding.level in LEVELS]


def _contents(log, values, environment):
    """What is in the file, for those who are to pass it on."""
    words = ["the findings", "each component with its ports, connections, contexts, states and properties"]
    if values:
        words.append("the values of configuration sets")
    words.append("what is bound in name servers, what managers have, versions")
    if environment:
        words.append(
            "this host's interfaces, routes, /etc/hosts, RT, ORB and Python variables, and processes"
        )
    if log:
        words.append("values of a log")
    return "It contains " + "; ".join(words) + "."


# ---- the map ----


def _system(seen):
    """(the capture.System that was seen; of other components {path: (host, port) of the process}, and of
    those that have reported it, {path: state}).
    """
    if seen is None:
        return capture.of_snapshots([], {}), {}, {}
    whole = [snapshot for snapshot in seen.snapshots if _is_whole(snapshot)]
    system = capture.of_snapshots(whole, seen.ends)
    rest = [snapshot for snapshot in seen.snapshots if not _is_whole(snapshot)]
    lost = [snapshot.node for snapshot in rest]
    for visit in seen.visits:
        lost += [node for node in visit.nodes if node.kind in ("zombie", *tree.DOUBTFUL)]
    states = {look.where: component.merged(look.states) for look in rest if "states" in look.known}
    return system, {str(node.path): node.endpoint for node in lost}, states


def _is_whole(snapshot):
    """Whether a component has reported all of itself."""
    return (
        snapshot.error is None
        and snapshot.profile is not None
        and all(context.handle is not None for context in snapshot.owned)
    )


def _leave_out_values(snapshots):
    """Without configuration sets; OpenRTM has their values among the properties of components, too."""
    for snapshot in snapshots:
        snapshot.configuration = None
        if snapshot.profile is not None:
            kept = [pair for pair in snapshot.profile.properties if not pair[0].startswith(CONFIGURATION)]
            snapshot.profile = snapshot.profile._replace(properties=kept)


# ---- sections ----


def _sections(seen, environment):
    """[(heading, text)]"""
    sections = []
    numbers = set()
    if seen is not None:
        sections.append(("Name servers, and what is bound", "\n".join(_bound(seen.visits))))
        sections.append(("Managers", "\n".join(_managers(seen.managers))))
        numbers = _ports(seen.visits)
        sections.append(("Clocks of others against this host's", "\n".join(_clocks(seen.snapshots))))
    sections.append(("Versions and clock", host.versions()))
    if environment:
        sections += host.surroundings(numbers)
    return sections


def _bound(visits):
    for visit in visits:
        yield f"{visit.path}  {', '.join(visit.addresses)}"
        for node in visit.nodes:
            if node.kind in BOUND:
                yield f"  {node.kind}  {node.path}  {_addresses(node)}"


def _addresses(node):
    if node.ref is None:
        return ""
    return ", ".join("%s:%s" % address for address in orb.addresses(node.ref))


def _managers(answers):
    for node, answer in answers:
        if isinstance(answer, errors.Error):
            yield f"{node.path}: {answer.why}"
            continue
        slaves, components, _ = answer
        has = f"{counted(len(slaves), 'slave')}, {counted(len(components), 'component')}"
        yield f"{node.path}: {has}"
        for child in slaves + components:
            yield f"  {child.kind}  {child.name}  {_addresses(child)}"


def _clocks(snapshots):
    """How far the clocks are apart of hosts on which a component puts the time into its values."""
    for look in snapshots:
        if look.stamp is not None:
            host, number = look.node.endpoint
            port = ports.short_name(look.written[0].name, look.node.path.instance)
            stamped = clocks.distance(*look.stamp)
            yield f"{look.where}  at {host}:{number}: a value of {port} was {stamped}"


def _ports(visits):
    """The TCP ports that references and name servers have."""
    refs = [node.ref for visit in visits for node in visit.nodes if node.ref is not None]
    return {port for ref in refs for _, port in orb.addresses(ref) if port}


# ---- a log ----


def _of_log(name, findings):
    """The last values of a log as plots, [(title, SVG in Base64)]: those of components with findings, in
    their order, then all; the last events of such components as sections. Raises errors.Error, OSError.
    """
    from rtshell_lite.data import datatypes
    from rtshell_lite.datalog import decode, logfile

    plots = []
    events = []
    with logfile.load(name) as log:
        decoder = decode.Decoder(log, datatypes.Types().load())
        channels = {}
        for channel in log.channels:
            for port in {channel.name, *channel.sources}:
                channels.setdefault(port.rpartition(":")[0], []).append(channel.name)
        for where, message in _complaints(findings):
            drawn = where in channels and len(plots) < MOST_PLOTS and _plot(decoder, channels[where])
            if drawn:
                title = f"{where}: {message}: the last {WINDOW} s of its out ports"
                plots.append((page.shown(title), drawn))
            lines = len(events) < MOST_PLOTS and _events(log, where)
            if lines:
                events.append((f"{where}: {message}: its last events in {name}", "\n".join(lines)))
        plots.append((f"The last {WINDOW} s of {page.shown(name)}", _plot(decoder, [])))
    return plots, events


def _complaints(findings):
    """{path of a component: the first message} of what is wrong, in the order of findings."""
    complaints = {}
    for finding in findings:
        if finding.level in ("fail", "warn"):
            where = finding.path.partition(".rtc:")
            complaints.setdefault(where[0] + where[1].rstrip(":"), finding.message)
    return complaints.items()


def _last(log):
    """The entries of the last seconds of a log."""
    from rtshell_lite.datalog import play

    start = (log.last or 0) / 1e9 - WINDOW
    return play.Range(start, None, False).entries(log)


def _plot(decoder, names):
    """The last values of some channels as SVG in Base64, None where there are none; of all without names."""
    from rtshell_lite.views import plot_sources, plot_svg

    picture = plot_sources.of_log(decoder, names, "", _last(decoder.log))
    if names and picture.is_empty():
        return None
    return base64.b64encode("\n".join(plot_svg.lines(picture)).encode()).decode()


def _events(log, where):
    """The last events of a component, as lines."""
    from rtshell_lite.datalog import schemas

    numbers = {number for number, channel in enumerate(log.channels) if channel.type_id == schemas.EVENT}
    lines = []
    for entry in _last(log) if numbers else ():
        value = entry.value
        if entry.channel in numbers and isinstance(value, dict) and value.get("path") == where:
            words = " ".join(str(value.get(key, "")) for key in ("kind", "subject", "event"))
            lines.append(f"{calendar.local('%H:%M:%S', entry.received // 10**9)}  {words}")
    return lines[-MOST_EVENTS:]
