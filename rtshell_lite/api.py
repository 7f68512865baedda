"""rtshell_lite for programs: launch scripts, test suites, analysers of data. docs/library.md compares it with rtctree and rtsprofile.

    from rtshell_lite import api

    motor = api.component("/localhost/robot.host_cxt/Motor0.rtc", wait=30)
    with api.connected("/localhost/robot.host_cxt/Sensor0.rtc:out", motor.path + ":in", subscription_type="flush"):
        motor.activate(wait=5)
        print(api.next_value(motor.path + ":out", timeout=2).data)

What is defined here keeps its names, arguments and meanings; more may be added. All other modules may change with any version.

Paths are those of the commands; relative ones start at RTCSH_CWD. Failures are errors.Error, with `where` (the object) and
`why`; every remote call has a deadline (`set_timeout`). Functions may be called from any thread, beside other users of omniORB
in the process: signals, deadlines and the threads of others are left alone. A program that is a component itself starts its
own ORB first. Rare remarks go to stderr, such as that a peer's answer was too long.
"""
import collections
import contextlib
import math
import time

from rtshell_lite import errors, path as paths
from rtshell_lite.corba import lanes, omni
from rtshell_lite.errors import Error

__all__ = ["Component", "Error", "Port", "capture", "check", "component", "components", "connect", "connected", "disconnect",
           "dump_profile", "load_profile", "next_value", "restore", "send", "set_timeout", "values"]

POLL = 0.2  # seconds between two looks

# A port: its path, its type (DataInPort, DataOutPort, CorbaPort, Port), a dict, and the ids of its connections.
Port = collections.namedtuple("Port", "path type properties connections")

omni.shared = True


def set_timeout(seconds):
    """Let a peer stay silent for so many seconds (default: 3). Raises ValueError."""
    if not 0 < seconds < math.inf:
        raise ValueError(f"not a number of seconds above 0: {seconds!r}")
    lanes.session.timeout = float(seconds)


# ---- components -----------------------------------------------------------------------------------------------

class Component:
    """The component at a path. Each use looks it up, so that it may be restarted meanwhile."""

    def __init__(self, path):
        self.path = str(paths.parse(path))

    def __repr__(self):
        return f"Component({self.path!r})"

    def _node(self):
        from rtshell_lite.robot import tree
        return tree.component(self.path)

    @property
    def state(self):
        """Created, Inactive, Active, Error or Unknown."""
        from rtshell_lite.robot import component
        return component.state(self._node())

    def activate(self, wait=None, context=None):
        """Activate it, as rtact does; `wait`: how many seconds to wait at most until it is Active; `context`: as -e of rtact."""
        self._change("ACTIVATE", wait, context)

    def deactivate(self, wait=None, context=None):
        """Deactivate it, as rtdeact does: in all its execution contexts, or in the one with the number `context`."""
        self._change("DEACTIVATE", wait, context)

    def reset(self, wait=None, context=None):
        """Take it from Error to Inactive."""
        self._change("RESET", wait, context)

    def _change(self, name, wait, context):
        from rtshell_lite.robot import transitions
        transitions.change(self._node(), getattr(transitions, name), context, wait)

    def configuration(self, set_id=None):
        """The values of a configuration set (default: the active one), a dict of texts."""
        return dict(self._configuration().set(set_id, with_hidden=True).values)

    def configure(self, values, set_id=None):
        """Set values (a dict of texts) in a configuration set (default: the active one)."""
        found = self._configuration()
        found.store({name: str(value) for name, value in values.items()}, found.set(set_id, with_hidden=True))

    def activate_set(self, set_id):
        """Make a configuration set the active one."""
        self._configuration().activate(set_id)

    def _configuration(self):
        from rtshell_lite.robot import configuration
        return configuration.of(self._node())

    def ports(self):
        """Its Ports, a list."""
        from rtshell_lite.robot import ports
        return [Port(ports.label(port), port.type, dict(port.properties), [connector.id for connector in port.connectors])
                for port in ports.ports(self._node())]


def component(path, wait=0.0):
    """The Component at a path, once it is there and alive, for which it has `wait` seconds."""
    from rtshell_lite.robot import tree
    found, end = Component(path), time.monotonic() + wait
    while True:
        node, = tree.at_each([paths.parse(found.path)], tree.component)
        if not isinstance(node, Error):
            node, = tree.look([node])
            node = node.error or node
        if not isinstance(node, Error):
            return found
        if time.monotonic() >= end or not isinstance(node, (errors.NotFound, errors.Unreachable)):
            raise node
        time.sleep(POLL)


def components(top="/"):
    """The Components at and below a path, a list. What does not answer is left out; if that leaves none, the first failure is raised."""
    from rtshell_lite.system import capture
    nodes, _, failures, _ = capture.components([paths.parse(top)])
    if failures and not nodes:
        raise failures[0]
    return [Component(str(node.path)) for node in nodes]


# ---- connections ----------------------------------------------------------------------------------------------

def _found(*words):
    from rtshell_lite.robot import ports
    wanted = [paths.parse(word) for word in words]
    for path in wanted:
        if path.port is None:
            raise errors.BadPath(path, "no port specified")
    found, failures = errors.parted(ports.find(wanted))
    if failures:
        raise failures[0]
    return found


def _properties(given):
    return {name if "." in name else "dataport." + name: str(value) for name, value in given.items()}


def connect(one, other, **properties):
    """Connect two ports and return the id of the connection. Properties without a dot belong to `dataport`: data_type="…"."""
    from rtshell_lite.robot import connectors
    return connectors.connect(_found(one, other), given=_properties(properties)).id


def disconnect(one, other=None):
    """Remove the connections of two ports, or all of one; returns how many there were."""
    from rtshell_lite.robot import connectors, ports
    found = _found(*[path for path in (one, other) if path is not None])
    removed = ports.joining(found) if other is not None else found[0].connectors
    for connector in removed:
        connectors.disconnect(found[0], connector)
    return len(removed)


@contextlib.contextmanager
def connected(one, other, **properties):
    """Two ports connected for the time of a `with` statement, which gets the id of the connection."""
    from rtshell_lite.robot import connectors
    port, far = _found(one, other)
    connector = connectors.connect([port, far], given=_properties(properties))
    try:
        yield connector.id
    finally:
        connectors.disconnect(port, connector)


# ---- data -----------------------------------------------------------------------------------------------------

def _type(port, idl):
    from rtshell_lite.data import datatypes
    return datatypes.Types(idl=idl).load().of_port(port)


def values(port, timeout=None, idl=(), **properties):
    """Yield the values that an out port sends, from its connection at the first one on; the end of the generator removes that.

    A value has its IDL members as attributes: value.tm.sec, value.data. Raises errors.Unreachable when none comes for `timeout`
    seconds. `idl` are files with types that are not standard ones.
    """
    from rtshell_lite.data import inbox, reading
    found, = _found(port)
    box, type = inbox.Inbox(), _type(found, idl)
    with reading.Reader(found, box.taker(0), properties=_properties(properties)) as reader:
        last = time.monotonic()
        while True:
            for _, message in box.get(POLL):
                last = time.monotonic()
                yield type.decode(message.data, message.little)
                last = time.monotonic()
            if reader.failure:
                raise reader.failure
            if timeout is not None and time.monotonic() - last > timeout:
                raise errors.Unreachable(reader.where, f"no value within {timeout:g}s")


def next_value(port, timeout=5.0, idl=(), **properties):
    """The next value that an out port sends; see `values`."""
    with contextlib.closing(values(port, timeout, idl, **properties)) as coming:
        return next(coming)


def send(port, value, idl=(), anyway=False):
    """Send a value to an in port and wait until the component can have read it. A member `tm` that is left out is the present.

    The value is one of its type, a dict of its members, or what its member `data` is to be: 42. Raises errors.Failed for a
    component that does not read now (unless `anyway`), errors.Unread when it stops doing so, BadValue.
    """
    from rtshell_lite.data import values as data_values, writing
    found, = _found(port)
    type, now = _type(found, idl), divmod(int(time.time() * 1e9), 10 ** 9)
    built = data_values.build(type.descriptor, value, type.name, now=now)
    with writing.Writer(found, {}, "rtshell_lite", anyway) as writer:
        writer.put(type.encode(built, writer.little), writer.little)
        writing.linger([writer], None, lambda: None)
    if writer.failure:
        raise writer.failure


# ---- systems --------------------------------------------------------------------------------------------------

def capture(*tops):
    """The RtsProfile of all that runs below these paths (default: all name servers). Raises the first failure."""
    from rtshell_lite.system import capture as capturing
    found = capturing.capture([paths.parse(top) for top in tops], all_components=True)
    if found.failures:
        raise found.failures[0]
    return found.profile


def restore(profile, create=False, manager=None, rollback=False):
    """Bring the running system to a profile, as rtresurrect does; raises the first failure of what the profile requires.

    `create`: let managers create what is missing, that at the path `manager` where the profile names none.
    """
    from rtshell_lite.system import apply, restore as restoring
    outcomes = restoring.restoring(profile, restoring.Options(create, manager, False))
    apply.carry_out(outcomes, rollback)
    for outcome in outcomes:
        if outcome.failed and outcome.step.required:
            raise outcome.error


def check(profile, state="Active", extra=False):
    """How the running system differs from a profile, as lines of text; [] where it does not. See rtcheck. Raises ValueError."""
    from rtshell_lite.robot import component
    from rtshell_lite.system import compare
    if state not in component.STATES:
        raise ValueError(f"not one of {', '.join(component.STATES)}: {state!r}")
    result = compare.compare(profile, state, extra=extra)
    if result.failures:
        raise result.failures[0]
    return [difference.message for difference in result.differences if difference.required]


def load_profile(name):
    """The RtsProfile (xmlprofile.model.RtsProfile) in a file, XML or YAML. Raises errors.BadProfile, OSError."""
    from rtshell_lite.system import capture as capturing
    return capturing.read(name)


def dump_profile(profile, name, form="xml"):
    """Write a profile to a file, as xml or yaml, whole or not at all. Raises OSError, ValueError."""
    from rtshell_lite import files
    from rtshell_lite.xmlprofile import rtsprofile
    if form not in (rtsprofile.XML, rtsprofile.YAML):
        raise ValueError(f"not xml or yaml: {form!r}")
    files.write(name, rtsprofile.dump(profile, form))
