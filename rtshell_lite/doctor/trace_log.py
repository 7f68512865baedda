"""rttrace on a recording: the connections are those of the last profile in the log, the values those that
were recorded.
"""

from rtshell_lite import errors, notes
from rtshell_lite.data import reading
from rtshell_lite.doctor import trace
from rtshell_lite.robot import ports, tree
from rtshell_lite.system import capture
from rtshell_lite.xmlprofile import rtsprofile


def recorded(log, start, to=None, against=False, seconds=None):
    """The trace.Trace from a Path with a port on, `to` another one if given; of the last `seconds` of a log,
    None for all of it. Raises errors.Failed, NoSuch.
    """
    traced = trace.Trace(against)
    profile = _profile(log)
    channels = _channels(log)
    links = _links(profile)
    _follow(traced, start, links, channels)
    for stage in traced.stages.values():
        stage.error = None
    if to is not None:
        back = trace.Trace(against=True)
        _follow(back, to, links, {})
        traced.limit(str(to.object()), back)
    _measure(traced, log, channels, seconds)
    traced.note_delays()
    return traced


def _profile(log):
    """The last RtsProfile that is attached to a log."""
    for attachment in reversed(log.attachments):
        try:
            return rtsprofile.load(log.attached(attachment), log.where)
        except errors.BadProfile:
            continue
    raise errors.Failed(
        log.where, "no profile of the system is in this log: record it with rtlog record --events PATH"
    )


def _channels(log):
    """{path of a port, as text: (number of its channel, id of its data type)}."""
    return {
        source: (number, channel.type_id)
        for number, channel in enumerate(log.channels)
        for source in channel.sources
    }


def _links(profile):
    """[(Path of an out port, Path of an in port)] of the data connections of a profile."""
    locate = capture.locator(profile)
    links = []
    for connector in profile.data_port_connectors:
        ends = [capture.port_path(end, locate(end)) for end in connector.ends]
        if len(ends) > 1 and None not in ends:
            links += [(ends[0], end) for end in ends[1:]]
    return links


def _follow(traced, start, links, channels):
    """Find the Stages and Links from a port on."""
    recorded_components = {end.object() for link in links for end in link}
    if start.object() not in recorded_components:
        raise errors.NoSuch(
            str(start), "component with connections in the profile of this log", str(start.object())
        )
    waiting = [(start.object(), 0)]
    while waiting:
        where, depth = waiting.pop(0)
        _stage(traced, where, depth)
        for out, into in links:
            is_start = not depth
            near, far = (into, out) if traced.against else (out, into)
            if near.object() != where or is_start and near.port != start.port:
                continue
            far = far.object()
            if str(far) not in traced.stages:
                waiting.append((far, depth + 1))
            _stage(traced, far, depth + 1)
            _join(traced, out, into, channels)
    begin = traced.stages[str(start.object())]
    if not traced.against and begin.watches == []:
        _watch(traced, start, channels)


def _stage(traced, where, depth):
    """The trace.Stage of a component's Path."""
    return traced.stages.setdefault(str(where), trace.Stage(tree.Node(where, "component"), depth))


def _join(traced, out, into, channels):
    """Add the Link between ports whose components have Stages, if it is new."""
    watch = _watch(traced, out, channels)
    if not any(link.watch is watch and link.port == into for link in traced.links):
        traced.links.append(trace.Link(watch, traced.stages[str(into.object())], into, True))


def _watch(traced, out, channels):
    """The trace.Watch of an out port's Path, whose component has a Stage."""
    stage = traced.stages[str(out.object())]
    for watch in stage.watches:
        if watch.port.name == out.port:
            return watch
    channel = channels.get(str(out))
    properties = {}
    if channel is not None:
        properties["dataport.data_type"] = channel[1]
    watch = trace.Watch(ports.Port(stage.node, out.port, "DataOutPort", properties, [], [], None, None))
    if channel is None:
        watch.failure = errors.Failed(watch.name, "was not recorded")
    stage.watches.append(watch)
    return watch


def _measure(traced, log, channels, seconds):
    """Give the values of a log to the Watches."""
    watches = {watch.name: watch for stage in traced.stages.values() for watch in stage.watches}
    by_channel = {number: watches[name] for name, (number, _) in channels.items() if name in watches}
    first = 0
    if seconds is not None and log.last is not None:
        first = log.since(log.last - int(seconds * 1e9)) or 0
    spent = ((log.last or 0) - (log.first or 0)) / 1e9
    with notes.Work("octets", log.size, even=seconds is None) as log.work:
        for entry in log.entries(first):
            watch = by_channel.get(entry.channel)
            if watch is not None and entry.data is not None:
                watch.take(reading.Message(entry.received, entry.data, entry.little))
    for watch in watches.values():
        watch.seconds = min(spent, seconds or spent)
        watch.until = log.last or 0
        watch.begun = watch.until - int(watch.seconds * 1e9)
