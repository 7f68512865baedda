"""Which in ports the values of a recorded robot went to: those that its out ports were connected with."""

import collections

from rtshell_lite import errors, path
from rtshell_lite.datalog import flight
from rtshell_lite.robot import search
from rtshell_lite.system import capture, relocate

# From a channel, by its number, to an in port: Paths of the out port, as recorded, and of the in port, as it
# is now.
Route = collections.namedtuple("Route", "channel source target")


def routes(recorded, maps):
    """The Routes of a recording.Recording, each once: all that one of its profiles shows.

    Its profiles are changed by the relocate.Maps. Raises Usage for one that fits nothing, Failed where it is
    not clear.
    """
    numbers = {}
    for number, source in recorded.channels.items():
        numbers.setdefault(str(source), []).append(number)
    all_routes = [
        Route(number, source, target)
        for scene in recorded.scenes
        for source, target in _connections(scene.profile, maps)
        for number in numbers.get(str(source), ())
    ]
    relocate.refuse_unused(maps)
    return list(dict.fromkeys(all_routes))


def below(top, all_routes, log):
    """Those of the Routes in a log that lead to a Path, or below it. Raises Failed where none does."""
    here = [route for route in all_routes if _is_below(route.target, top)]
    if not here:
        raise errors.Failed(
            str(top), f"no connection in {log.where} leads from a recorded port to a port here"
        )
    return here


def chosen(all_routes, choice, log):
    """(channel, Path of the in port) of those Routes that a flight.Choice allows, each once. Raises Failed
    for none.
    """
    allowed = [route for route in all_routes if choice.allows(_names(route, log))]
    if all_routes and not allowed:
        count = len(set(all_routes))
        raise errors.Failed(log.where, f"--only and --not leave none of {count} connections")
    return list(dict.fromkeys((route.channel, route.target) for route in allowed))


def _connections(profile, maps):
    """(Path of the out port, Path of the in port) of the connections in a profile: the first as it was when
    recorded, the second as the Maps say.
    """
    locate = capture.locator(profile)
    connections = []
    for connector in profile.data_port_connectors:
        first, *others = connector.ends  # an out port is first
        source = capture.port_path(first, locate(first))
        if source is None:
            continue
        connections += [(source, end, locate(end)) for end in others]
    if maps:
        relocate.move(profile, maps)
    pairs = [(source, capture.port_path(end, owner)) for source, end, owner in connections]
    return [pair for pair in pairs if pair[1] is not None]


def _names(route, log):
    """What patterns may fit: both ports, and the type."""
    type_id = log.channels[route.channel].type_id
    names = flight.names_of(str(route.source), type_id)
    return names + flight.names_of(str(route.target), type_id)


def _is_below(where, top):
    """Whether a Path is another one, or below it, whose last name may be a pattern, as in recording."""
    if top.server is None:
        return True
    if path.split_address(where.server) != path.split_address(top.server):
        return False
    if not top.names:
        return True
    names = [str(name) for name in where.names]
    *above, last = [str(name) for name in top.names]
    depth = len(above)
    if len(names) <= depth or names[:depth] != above:
        return False
    (match,) = search.patterns([last], ())
    return bool(match(names[depth]))
