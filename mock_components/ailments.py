"""Worlds for a doctor: connections gone wrong, names that lead astray, components that nothing executes."""

from rtshell_lite.giop import ior

from . import giop, naming
from .idl import RTC, OpenRTM
from .properties import nvlist, put
from .serviceport import MyService
from .stage import PUSH


def crossed(stage):
    """connections gone wrong: In0 > Out0 one-sided, In1 > Out1 told differently, Sensor0 > Out2 types, In3 a
    tool's; Want0 > Want1 and Have0 > Have1 want, have the same service; Want2 > Have0 fit, Want3 > Have1 are
    mapped wrongly
    """
    for number in range(3):
        stage.add("ConsoleOut", "Out%d" % number)
    for number in (0, 1, 3):
        stage.add("ConsoleIn", "In%d" % number)
    stage.add("Sensor")
    for name in ("Want0", "Want1", "Want2", "Want3"):
        stage.add("MyServiceConsumer", name)
    for name in ("Have0", "Have1"):
        stage.add("MyServiceProvider", name)
    stage.connect("In0:out", "Out0:in")
    # of the last port: the others do not hear of it
    stage.port("Out0:in").notify_disconnect(only_id(stage.port("In0:out")))
    stage.connect("In1:out", "Out1:in")
    there = stage.port("Out1:in")
    there.profiles = {only_id(there): retold(only(there), "dataport.subscription_type", "new")}
    stage.connect("Sensor0:out", "Out2:in")
    gone = stage.process.text(stage.process.ghost(OpenRTM.InPortCdr._NP_RepositoryId))
    port = stage.port("In3:out")
    code, _ = port.connect(RTC.ConnectorProfile("print", "", [port.reference], nvlist(
        PUSH + [("dataport.corba_cdr.inport_ior", gone)])))
    assert code == RTC.RTC_OK, code
    serve(stage, "Want0", "Want1")
    serve(stage, "Have0", "Have1")
    serve(stage, "Want2", "Have0")
    serve(stage, "Want3", "Have1", [("Want3.port.MyService.required.MyService.myservice0", "nowhere")])


def serve(stage, one, other, properties=()):
    """Connect two service ports, as tools do that look at nothing."""
    found = [stage.port(name + ":MyService") for name in (one, other)]
    profile = RTC.ConnectorProfile("service", "", [port.reference for port in found], nvlist(properties))
    code, _ = found[0].connect(profile)
    assert code == RTC.RTC_OK, code


def only(port):
    """The one connector profile of a port."""
    profile, = port.profiles.values()
    return profile


def only_id(port):
    """Its id."""
    return only(port).connector_id


def retold(profile, key, value):
    """A copy of a connector profile with another value of a property."""
    properties = [item for item in profile.properties if item.name != key]
    put(properties, key, value)
    return RTC.ConnectorProfile(profile.name, profile.connector_id, profile.ports, properties)


def astray(stage):
    """Right0, bound again as Wrong0; names bound to a stranger, to nothing and to what has ended; empty and
    dead contexts
    """
    home = stage.home()
    right = stage.add("Mock", "Right0")
    for number in range(5):
        stage.names.bind(home + [("Wrong%d" % number, "rtc")], right.reference)
    stage.add("Mock", "Moved0", names=[home + [("Other0", "rtc")]])
    stranger = stage.process.serve(MyService(), "stranger")
    stage.names.bind(home + [("Stranger0", "rtc")], stranger)
    stage.names.bind(home + [("Thing0", "obj")], stranger)
    stage.names.bind(home + [("Nil0", "rtc")], None)
    stage.names.bind(home + [("Ended0", "rtc")], stage.process.ghost(right._NP_RepositoryId))
    stage.names.contexts(home + [("empty", "cxt"), ("emptier", "cxt")])
    stage.names.bind(home + [("dead", "cxt"), ("Gone0", "rtc")], stage.process.ghost(right._NP_RepositoryId))


def aliased(stage, *others):
    """[HOST:PORT …]: real.cxt with Inner0, bound again as again.cxt and inside itself as loop.cxt; top.cxt is
    the root of its name server, far0.cxt, … those of others, bound by federation: their references have no
    type id
    """
    home = stage.home()
    real = stage.names.contexts(home + [("real", "cxt")])
    stage.add("Mock", "Inner0", names=[home + [("real", "cxt"), ("Inner0", "rtc")]])
    for name in ([("again", "cxt")], [("real", "cxt"), ("loop", "cxt")]):
        stage.names.bind_context(home + name, real)
    stage.names.bind_context(home + [("top", "cxt")], stage.names.root)
    for number, other in enumerate(others):
        stage.names.bind_context(home + [("far%d" % number, "cxt")], naming.root(stage.process, other))


def idle(stage):
    """Stopped0 with a stopped context, Still0 with a rate of 0, Bare0 without a context: nothing executes
    them
    """
    stage.add("Mock", "Stopped0", running=False)
    stage.add("Mock", "Still0", rate=0.0, flavour=stage.flavour.but(any_rate=True))
    stage.add("Mock", "Bare0", contexts=0)


def secured(stage):
    """Tls0 and Unix0, which listen with TLS and with a UNIX socket only, and Other0 with a transport that
    nobody knows; they live, but their references name no TCP port. That of Alternate0 names one as an
    alternative only
    """
    host, port = stage.process.endpoint.split(":")
    port = int(port)
    # as omniORB 4.2 writes them: TAG_SSL_SEC_TRANS (no options, TLS port 47537), TAG_OMNIORB_UNIX_TRANS
    for name, components in (
        ("Tls0", [(20, b"\1\0\x66\0\x66\0\xb1\xb9")]),
        ("Unix0", [(0x41545402, b"\1\0\0\0" + giop.cdr(b"robot1", b"/tmp/unix0.sock"))]),
        ("Other0", []),
        ("Alternate0", [(3, b"\1\0\0\0" + giop.cdr(host.encode()) + port.to_bytes(2, "little"))]),
    ):
        mock = stage.add("Mock", name, names=[])
        key = ior.address(stage.process.text(mock.reference)).key
        text = giop.stringified(0, key=key, components=components)
        stage.names.bind(stage.home() + [(name, "rtc")], stage.process.reference(text))


WORLDS = {world.__name__: world for world in (crossed, astray, aliased, idle, secured)}
