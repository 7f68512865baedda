"""Service ports: the interfaces that they provide, and the references of these (docs/protocol.md 7)."""


from rtshell_lite import errors
from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.records import record
from rtshell_lite.robot import ports
from rtshell_lite.text import printable, to_wire

PROFILE = "RTC.ConnectorProfile"
NAME = "rtshell_lite_call"  # of the connector by which a reference is got; see ports.is_of_tool


# One interface that a port, a ports.Port, provides: its name and its type, as the port's profile has them;
# its reference, and the id of its interface, as that says.
Service = record("Service", "port instance type_name ref repository_id")


def label(service):
    """The path of a Service as a user would type it, PATH:PORT.INSTANCE, spelt for the terminal."""
    return f"{ports.label(service.port)}.{printable(service.instance)}"


def provided(port):
    """The (instance, type name) of each interface that a Port provides."""
    return [(i.instance_name, i.type_name) for i in port.interfaces if i.polarity == "Provided"]


async def of_port(port):
    """The Services of a Port, in its order: references are in the connector of this port alone, which is made
    and removed in one turn, whatever interrupts us.

    Raises Refused, Unreachable; Garbled where a provided interface has no reference.
    """
    interfaces = provided(port)
    if not interfaces:
        return []
    given = dict(await loop.finish(_connected_once(port)))
    return [_service(port, given, instance, type_name) for instance, type_name in interfaces]


def _service(port, given, instance, type_name):
    text = given.get(f"port.{type_name}.{instance}")
    if text is None:
        why = f"its connection has no reference of interface {printable(instance)}"
        raise errors.Garbled(ports.label(port), why)
    ref = orb.from_text(f"{ports.label(port)}.{printable(instance)}", text)
    return Service(port, instance, type_name, ref, orb.address(ref).type_id)


async def _connected_once(port):
    """The properties that a connector of one port alone gets; it is removed again."""
    where = ports.label(port)
    connector_id = "rtshell_lite-" + loop.world().octets(16).hex()
    code, profile = await _connect(port, where, connector_id)
    if str(code) == "PRECONDITION_NOT_MET":  # RtORB takes no ids
        code, profile = await _connect(port, where, "")
    if str(code) != "RTC_OK":
        raise errors.Refused(where, f"the connection that gives its interfaces is refused ({code})")
    connector = ports.connector(profile, where)
    code = await orb.call(where, port.ref, "disconnect", profile.connector_id)
    if str(code) != "RTC_OK":
        from rtshell_lite.robot import connectors  # few need it

        await connectors.disconnect(port, connector)
    return connector.properties


async def _connect(port, where, connector_id):
    asked = orb.struct(PROFILE)(NAME, to_wire(connector_id), [port.ref], orb.nvlist([]))
    try:
        return await orb.call(where, port.ref, "connect", asked)
    except errors.Silent:
        if connector_id:
            await _forget(port, where, connector_id)
        raise


async def _forget(port, where, connector_id):
    """Have a connector removed whose making was not answered: a process that was stopped makes it later."""
    session.current().ask_again(orb.endpoint(port.ref))  # or it would not be asked
    await errors.or_error(orb.call(where, port.ref, "disconnect", to_wire(connector_id)))
