"""A picture of what is running: states, processes, the rates of ports."""

import collections

from rtshell_lite import errors, path
from rtshell_lite.data import rates
from rtshell_lite.robot import component, ports, tree
from rtshell_lite.system import capture
from rtshell_lite.views import graph
from rtshell_lite.xmlprofile import model

# What is known of a component that runs: its state, (host, port) of its process, a snapshot.Snapshot or None.
Look = collections.namedtuple("Look", "state process snapshot")
NOT_KNOWN = "not known"  # in place of the name of a port that does not answer
SILENT = Look("Unknown", None, None)


async def of_robot(tops, everything, with_snapshots=False):
    """The Drawing of what is below the Paths `tops` (none: all name servers).

    Components that do not answer are boxes. `everything`: also what is not connected.
    Where a connection leads to one, that is drawn: it may be gone.
    `with_snapshots`: all that rtcat shows. `results` are capture.ComponentState and errors.Error.
    """
    system = await capture.capture(
        tops, everything, with_states=True, with_snapshots=with_snapshots, shows=True
    )
    lost = {failure.where: None for failure in system.failures}
    return of_system(system, dict(lost, **system.lost))


def of_system(system, lost, states=()):
    """The Drawing of a capture.System, and of components that have not reported everything, `lost`: {path, as
    text: (host, port) of the process or None}; `states`: {path: state} of these, where it is known.
    """
    states = dict(states)
    profile = system.profile
    looks = [Look(capture.state(answer), answer.node.endpoint, answer.snapshot) for answer in system.found]
    for where, process in lost.items():
        silent = _silent(where)
        if silent is not None:
            profile.components.append(silent)
            looks.append(SILENT._replace(process=process, state=states.get(where, SILENT.state)))
    for loose in system.loose:
        _tie(loose, profile, lost)
    tied = {loose.note for loose in system.loose}
    notes = [line for line in system.notes if line not in tied]
    picture = _of(profile, looks)
    for box in picture.boxes[len(looks) :]:  # of ends that do not answer
        if box.missing:
            box.missing = False
            box.state = SILENT.state
    return graph.Drawing(picture, profile, system.found + system.failures, notes)


def _tie(loose, profile, lost):
    """Add a capture.Loose to a profile, with an end whose port is not known: of the one component that was
    lost of its process, else of the process.
    """
    ends = loose.connector.ends
    where = [path for path, process in lost.items() if process == loose.endpoint]
    there = [component for component in profile.components if capture.shown_path(component) in where]
    if len(there) == 1:
        path_id = model.Property(name=capture.PATH_ID, value=there[0].path_uri)
        other = model.TargetPort(
            instance_name=there[0].instance_name, port_name=NOT_KNOWN, properties=[path_id]
        )
    else:
        host, port = loose.endpoint
        other = model.TargetPort(instance_name=f"{host}:{port}", port_name=NOT_KNOWN)
    loose.connector.ends = [other] + ends if loose.connector.source is None else ends + [other]
    profile.add_connector(loose.connector)


def _silent(text):
    """A model.Component for the one at a path; None if that is no component."""
    try:
        where = path.parse(text)
    except errors.BadPath:
        return None
    if not where.names or where.names[-1].kind != "rtc":
        return None
    return model.Component(instance_name=where.names[-1].id, path_uri=str(where).lstrip("/"))


async def of_profile(profile):
    """The Drawing of an RtsProfile with what is known of its components now; `results` are Looks and
    errors.Error.
    """
    results = await capture.ask_each(profile, _look)
    looks = [SILENT if isinstance(result, errors.Error) else result for result in results]
    return graph.Drawing(_of(profile, looks), profile, results, [])


async def _look(node):
    return Look(await component.state(node), node.endpoint, None)


def _of(profile, looks):
    states = {component.path_uri: look.state for component, look in zip(profile.components, looks)}
    picture = graph.of(profile, states)
    for box, look in zip(picture.boxes, looks):
        box.process = look.process
        box.snapshot = look.snapshot
    return picture


async def measure(picture, seconds):
    """Label the out ports of a picture with how many values a second are written to them, measured for
    `seconds`.

    Returns the errors.Error of those that could not be measured.
    """
    boxes = [box for box in picture.boxes if box.path and box.right and box.state == "Active"]
    answers = await tree.on_components([box.path for box in boxes], ports.ports)
    failures = [answer for answer in answers if isinstance(answer, errors.Error)]
    measured = []
    for box, answer in zip(boxes, answers):
        if not isinstance(answer, errors.Error):
            measured += [(box, name, port) for name, port in _out_ports(box, answer)]
    results = await rates.written([port for _, _, port in measured], seconds)
    for (box, name, _), result in zip(measured, results):
        if isinstance(result, errors.Error):
            failures.append(result)
        else:
            box.labels[name] = f"{result:.3g} Hz"
    return failures


def _out_ports(box, drawn):
    """(name, port) of the DataOutPorts of a box that are drawn."""
    for port in drawn:
        name = ports.short_name(port.name, box.name)
        if port.type == "DataOutPort" and name in box.right:
            yield name, port
