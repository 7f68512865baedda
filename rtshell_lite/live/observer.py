"""Observers of both kinds and loggers: SDO services that we attach to a component, which reports to them.

Sources: OpenRTM-aist's ComponentObserver.idl, Logger.idl, and that of FSM4RTC; the hints are those that C++
and Python send.
"""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb, servants
from rtshell_lite.live import times
from rtshell_lite.net import loop
from rtshell_lite.robot import snapshot
from rtshell_lite.text import from_wire, printable

OBSERVER = "IDL:OpenRTM/ComponentObserver:1.0"
FSM_OBSERVER = "IDL:omg.org/RTC/ComponentObserver:1.0"
LOGGER = "IDL:OpenRTM/Logger:1.0"
# named as in giop/idl.py
INTERFACES = {
    OBSERVER: "OpenRTM.ComponentObserver",
    FSM_OBSERVER: "RTC.ComponentObserver",
    LOGGER: "OpenRTM.Logger",
}
NEVER = "86400"  # seconds between reports of single values that are sent and received
# properties of an observer that is not to hear of single values
NO_VALUES = tuple((f"port_profile.{word}_event.min_interval", NEVER) for word in ("send", "receive"))

# What has happened, and when (seconds since 1970) it was reported. `kind` is one of KINDS; `subject` is a
# context handle, a port, a configuration set or parameter, or what an event of a state machine is about;
# `event` what happened to it.
Event = collections.namedtuple("Event", "time kind subject event")
# A record of a component's log: `time` is the component's own, `level` one of LEVELS.
Record = collections.namedtuple("Record", "time logger level message")

LEVELS = ("SILENT", "ERROR", "WARN", "INFO", "NORMAL", "DEBUG", "TRACE", "VERBOSE", "PARANOID")  # by number
ALL_LEVELS = LEVELS[:1] + ("FATAL",) + LEVELS[1:]  # those that people may name, too
# Kinds of events: their names in rtwatch, and the kinds of status in components.
KINDS = collections.OrderedDict(
    [
        ("RTC_STATUS", ("RTC_STATUS",)),
        ("COMPONENT_PROFILE", ("COMPONENT_PROFILE",)),
        ("EC_EVENT", ("EC_STATUS",)),
        ("PORT_EVENT", ("PORT_PROFILE",)),
        ("CONFIG_EVENT", ("CONFIGURATION",)),
        ("FSM_EVENT", ("FSM_PROFILE", "FSM_STATUS", "FSM_STRUCTURE", "USER_DEFINED")),
        ("HEARTBEAT", ("HEARTBEAT", "RTC_HEARTBEAT", "EC_HEARTBEAT")),
    ]
)
_KIND_OF = {status: kind for kind, all_of_it in KINDS.items() for status in all_of_it}
# Names of events that are not the prefix of their kind and the word in the hint.
_WORDS = {
    "UPDATE_CONFIG_SET": "CFG_UPDATE_SET",
    "UPDATE_CONFIG_PARAM": "CFG_UPDATE_PARAM",
    "SET_CONFIG_SET": "CFG_SET_SET",
    "ADD_CONFIG_SET": "CFG_ADD_SET",
    "REMOVE_CONFIG_SET": "CFG_REMOVE_SET",
    "ACTIVATE_CONFIG_SET": "CFG_ACTIVATE_SET",
}
_PREFIXES = {"EC_EVENT": "EC_", "PORT_EVENT": "PORT_"}


def event_line(event, name=""):
    """An Event as rtwatch prints it; `name` is its component's, where several are watched."""
    words = [printable(word) for word in (event.subject, event.event) if word]
    return "[%s%.6f] %s" % (name and name + " ", event.time, " ".join(words))


def record_line(record, name):
    """A Record of the component called `name` as rtvlog prints it."""
    return "[%s %.6f] %s <%s> %s" % (
        name,
        record.time,
        record.level,
        printable(record.logger),
        printable(record.message),
    )


# ---- subscriptions of a component ----


async def properties(node):
    """The properties of a component, a dict."""
    return dict((await snapshot.of(node, ports=snapshot.BRIEF, profile=snapshot.FULL)).profile.properties)


def taken(properties):
    """The interface types of the SDO services that a component with these properties takes, a list; [] before
    OpenRTM 1.1.

    It is never offered others: the wrong kind of observer has ended components of C++ 2.1.
    """
    listed = properties.get("sdo.service.consumer.available_services", "")
    return [interface.strip() for interface in listed.split(",") if interface.strip()]


def _new_id():
    """A random UUID (RFC 4122, version 4) as text.
    (uuid takes long to import; Debian's python3-minimal has none.)
    """
    digits = loop.world().octets(16).hex()
    return f"{digits[:8]}-{digits[8:12]}-4{digits[13:16]}-a{digits[17:20]}-{digits[20:]}"


class Subscription:
    """A service of ours that a component calls, from `attach` until `detach`."""

    remark = ""  # what the user has to know about it
    is_led = False  # whether another component of its process sends heartbeats in its place

    def __init__(self, node, interface, properties, heard, beats=()):
        """`heard` is called with an Event or a Record; `beats`: the properties that ask for heartbeats."""
        self.node = node
        self.where = str(node.path)
        self.interface = interface
        self.properties = properties
        self.beats = list(beats)
        self.id = _new_id()
        self.reference = None  # by which the component calls us; None while it cannot have it
        self._served = servants.Served(_Listener(interface, heard))
        self._configuration = None

    async def attach(self):
        """Give it to the component, again with the same id if that may have lost it.
        Raises Refused, Unreachable.
        """
        if self._configuration is None:
            self._configuration = await self.node.call("get_configuration")
        text = await self._served.ior(self.node.endpoint)
        self.reference = orb.narrow(orb.from_text(self.where, text), "SDOPackage.SDOService")
        properties = self.properties if self.is_led else self.properties + self.beats
        profile = orb.struct("SDOPackage.ServiceProfile")(
            self.id, self.interface, orb.nvlist(properties), self.reference
        )
        if not await orb.call(self.where, self._configuration, "add_service_profile", profile):
            raise errors.Refused(self.where, f"does not take {self.interface}")

    async def detach(self):
        """Make the component forget it, even if `attach` failed. Raises Unreachable."""
        if self.reference is not None:
            await orb.call(self.where, self._configuration, "remove_service_profile", self.id)
        self.forget()

    def forget(self):
        """The component does not have it any more, or is gone: nothing is to be detached."""
        self.reference = None
        if self._served is not None:
            self._served.withdraw()
            self._served = None

    @property
    def endpoint(self):
        """(host, port) of its component's process."""
        return self.node.endpoint

    @property
    def address(self):
        """Where the component calls us, HOST:PORT; only while it is attached."""
        return orb.at_address(self.reference)


def preferred(properties):
    """The interface type of the observer for a component with these properties, None if it takes none."""
    offered = taken(properties)
    return next((kind for kind in (OBSERVER, FSM_OBSERVER) if kind in offered), None)


def observer(node, interface, kinds, heard, beat=times.BEAT_SHOWN, more=()):
    """A Subscription of an observer of the kind `interface` to events of these `kinds` (of KINDS),
    and to the component's end; it beats every `beat` seconds. `more` are further (property, value).
    """
    statuses = "ALL" if len(kinds) == len(KINDS) else ",".join(_statuses(interface, kinds))
    beats = {
        OBSERVER: ["heartbeat"],
        FSM_OBSERVER: ["rtc_heartbeat"] + ["ec_heartbeat"] * ("HEARTBEAT" in kinds),
    }[interface]
    intervals = []
    for name in beats:
        intervals += [(name + ".enable", "YES"), (name + ".interval", f"{beat:g}")]
    return Subscription(node, interface, [("observed_status", statuses), *more], heard, intervals)


def _statuses(interface, kinds):
    """The kinds of status that an observer of these kinds of events asks for."""
    asked = []
    for kind, statuses in KINDS.items():
        if kind == "HEARTBEAT" or kind == "FSM_EVENT" and interface != FSM_OBSERVER:
            continue
        if kind in kinds or kind == "RTC_STATUS":
            asked += statuses
    return asked


def logger(node, level, names, heard):
    """A Subscription of a logger to records up to `level`, from the sources `names` (none: from all)."""
    return Subscription(
        node, LOGGER, [("logger.log_level", level), ("logger.filter", ",".join(names) or "ALL")], heard
    )


class _Listener:
    """The servant of a Subscription, of any of the three interfaces."""

    def __init__(self, interface, heard):
        self.interface = INTERFACES[interface]
        self.heard = heard

    def update_status(self, kind, hint):
        self.heard(event(loop.wall(), kind._n, from_wire(hint)))

    def publish(self, record):
        self.heard(
            Record(
                record.time.sec + record.time.nsec / 1e9, from_wire(record.loggername),
                LEVELS[record.level._v], from_wire(record.message),
            )
        )

    def close(self):
        """Nothing: the end of a component is noticed otherwise."""


# ---- hints ----


def event(now, status, hint):
    """The Event for the arguments of update_status: the name of a StatusKind and its hint."""
    kind = _KIND_OF.get(status, status)
    if kind == "HEARTBEAT":
        return Event(now, kind, "", status)
    if kind == "FSM_EVENT":
        return Event(now, kind, status, hint)
    word, colon, rest = hint.partition(":")
    rest = rest.strip()  # hints about the configuration have a blank there
    if kind == "COMPONENT_PROFILE" or not colon:
        return Event(now, kind, "", hint)
    if kind == "PORT_EVENT" and word in ("SEND", "RECEIVE"):  # SEND:OutPort:ConsoleIn0.out
        rest = rest.partition(":")[2]
    return Event(now, kind, rest, _WORDS.get(word) or _PREFIXES.get(kind, "") + word)
