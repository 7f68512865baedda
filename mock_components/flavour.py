"""How implementations of OpenRTM differ on the wire: a row a difference, a column an implementation."""

NAMES = ("cpp11", "cpp12", "cpp2", "py2", "java", "rtorb")

_CPP_SERVICE = ("myservice", "SimpleService::MyService")
_PY_SERVICE = ("myservice0", "MyService")
_PUSH = "flush,new,periodic"
_MODES = "block,flush,new,nonblock,periodic"
_CDR12 = "corba_cdr,direct,shared_memory"
_CDR2 = "corba_cdr,data_service,direct,shared_memory"
_CDRPY = "corba_cdr,csp_channel,data_service,direct,shared_memory"
_OLD, _NEW, _PY = ("Noriaki Ando, AIST", "1.0"), ("AIST", "2.0.0"), ("Shinji Kurihara", "1.0")

TABLE = {
    #                     cpp11          cpp12          cpp2           py2            java           rtorb
    # what profiles say
    "language": ("C++", "C++", "C++", "Python", "Java", "C"),
    "lang_type": ("compile", "compile", "compile", "script", "compile", "compile"),
    "version": ("1.1.2", "1.2.2", "2.1.0", "2.1.0", "1.2.2", "RtORB"),
    "author": (_OLD, _OLD, _NEW, _PY, _OLD, _OLD),
    "modern": (False, False, True, True, False, False),
    "kind": (False, False, True, False, False, False),
    "endpoint_key": ("endpoint", "endpoints", "endpoints", "endpoints", "endpoints", "endpoint"),
    "port_keys": ("dataport", "dataport", "name", "dataport", "dataport", "dataport"),
    "observer": (False, False, False, True, False, False),
    # takes loggers, and never calls them
    "silent_loggers": (True, True, True, False, False, False),
    # answers the removal of an observer only when its heart would have beaten once more
    "heart_stops_late": (False, False, True, False, False, False),
    # a thread of its own removes an observer that cannot be reached: two reports of connections that fail
    # meanwhile wait for each other, and the component hangs
    "lost_observer_hangs": (False, False, True, False, False, False),
    "component_key": (None, "{}/{}", "{}.{}", "{}.{}", None, None),
    # ports
    "port_prefix": (True, True, True, True, True, False),
    "bare_types": (False, False, False, False, False, True),
    "dataflow": ("push,pull", "push,pull", "push,pull", "push,pull,duplex", "push,pull", "push"),
    "interfaces": ("corba_cdr", _CDR12, _CDR2, _CDRPY, _CDR12, "corba_cdr"),
    "subscriptions": (_PUSH, _PUSH, _MODES, _MODES, _PUSH, "flush"),
    "marshaling": (False, False, True, True, False, False),
    "data_value": (True, False, False, False, True, False),
    "service": (_PY_SERVICE, _PY_SERVICE, _CPP_SERVICE, _PY_SERVICE, _PY_SERVICE, _PY_SERVICE),
    # a provider's object exists only while its component is active
    "service_sleeps": (True, True, True, True, False, False),
    # connecting
    "uuid": ("random", "random", "random", "time", "random", "random"),
    "duplicates": ("accept", "refuse", "refuse", "refuse", "ask peers", "one"),
    "own_ids": (True, True, True, True, True, False),
    "merged_keys": (None, None, "empty", "data_type", None, None),
    # the object-reference property: always kept, turned into text or dropped when passed on to another port,
    # never sent
    "reference": ("dropped", "dropped", "kept", "text", "dropped", "never"),
    "bad_endian": ("UNSUPPORTED", "UNSUPPORTED", "UNSUPPORTED", "RTC_ERROR", "UNSUPPORTED", "UNSUPPORTED"),
    "periodic_rate": (True, True, True, False, True, True),
    "direct_far": ("BAD_PARAMETER", "RTC_ERROR", "RTC_ERROR", "RTC_ERROR", "RTC_ERROR", "BAD_PARAMETER"),
    # a connection that fails at the OutPort stays behind at the InPort
    "leaves_half": (False, False, False, True, False, False),
    # a port that is connected to itself never answers again
    "self_deadlock": (False, False, True, False, False, False),
    # what becomes of a process when a connector is removed under a get() that is still being served
    "busy_get": ("die", "die", "die", "survive", "survive", "survive"),
    # and under a put() that waits for room in the buffer
    "busy_put": ("die", "die", "die", "survive", "survive", "survive"),
    # first profile query after a peer has died: clean up silently, raise TRANSIENT once, or end the process;
    # to a composite that shows a port of a dead member, that is the end, too (all others raise)
    "dead_peer": ("clean", "clean", "die", "transient", "clean", "clean"),
    # data
    "obeys_big": (True, False, False, True, True, False),
    "empty_get": (
        "BUFFER_EMPTY",
        "BUFFER_EMPTY",
        "BUFFER_EMPTY",
        "BAD_PARAM",
        "BUFFER_EMPTY",
        "BUFFER_EMPTY",
    ),
    "short_put": ("MARSHAL", "MARSHAL", "PORT_OK", "PORT_OK", "PORT_OK", "PORT_OK"),
    # execution contexts
    "ext_trig": (True, False, False, False, False, False),
    "context_name": (False, False, True, False, False, False),
    # activate and reset: wait until the change, only queue it, or change the state within the call
    "transition": ("queue", "wait", "wait", "wait", "wait", "at once"),
    # a transition in a stopped context: done all the same, or not before the start
    "stopped": ("queued", "done", "queued", "queued", "done", "done"),
    # a component that fails to become active is Active for one period of its context first
    "late_error": (True, True, True, True, True, False),
    "nil_component": (
        "BAD_PARAMETER",
        "BAD_PARAMETER",
        "BAD_PARAMETER",
        "BAD_PARAM",
        "BAD_PARAMETER",
        "BAD_PARAMETER",
    ),
    "any_rate": (False, False, False, False, False, True),
    # configuration
    "no_set": ("Unknown exception",) * 3
    + ("No such ConfigurationSet", "Unknown exception", "Unknown exception"),
    "empty_set_id": ("InternalError",) * 3 + ("UNKNOWN", "InternalError", "InternalError"),
    "bad_activate": ("InvalidParameter",) * 3 + ("InternalError", "InvalidParameter", "InvalidParameter"),
    "scope": ("::", "::", "::", ".", ".", "::"),
    "set_creates": (True, True, True, False, False, True),
    "converts_values": (False, False, False, True, False, False),
    "keeps_active": (False, False, False, False, True, False),
    "parameter_value": ("null", "null", "null", "BAD_PARAM", "null", "null"),
    # composites: waiting for their members, their callbacks block, or make the caller give up; or they do not
    # wait
    "composite": ("blocks", "late", "async", "async", "async", "async"),
    # what a member that has died does to a composite that is to let it go: its process ends, the thread of
    # its context does, or only the call fails
    "dead_member": ("process", "process", "process", "thread", "thread", "call"),
    # managers
    "ident_fields": (5, 6, 6, 6, 6, 5),
    # a master makes components itself, not in its slaves
    "creates_here": (True, False, False, False, False, True),
    # a master lists the modules and factories of its slaves
    "tells_slaves": (True, True, False, True, True, True),
    "starts_slaves": (False, True, True, False, True, False),
    # finds and loads the module of a component that is to be made
    "search_auto": (False, True, True, True, True, False),
    "by_name": (False, True, True, True, True, False),
    "delete_unknown": ("RTC_OK",) + ("BAD_PARAMETER",) * 4 + ("RTC_OK",),
    # the instance name of one creation stays with the factory for the next
    "sticky_name": (False, False, False, True, False, False),
    # creating under a name that is taken: a second one (when both end, so may the process) or the one that is
    # there, or, if the name was the factory's, one that nobody lists
    "twins": ("crash", "crash", "survive", "same", "survive", "survive"),
    "integer_pid": (False, False, False, True, False, False),
    # of the UNKNOWN that clients see when an implementation does not catch its own exceptions
    "exception_minor": (0x4F4D0001, 0x4F4D0001, 0x4F4D0001, 0x41540062, 0x4F4D0001, 0x4F4D0001),
    "program": ("rtcd", "rtcd", "rtcd2", "rtcd2_python", "rtcd_java", "rtcd"),
    # SDO
    "no_service_profile": (
        "InternalError",
        "InvalidParameter",
        "InvalidParameter",
        "InternalError",
        "InvalidParameter",
        "InvalidParameter",
    ),
    "no_sdo_service": (
        "InternalError",
        "InvalidParameter",
        "InvalidParameter",
        "InvalidParameter",
        "InvalidParameter",
        "InvalidParameter",
    ),
}


class Flavour:
    """One column of the table, its rows as attributes."""

    def __init__(self, name):
        self.name = name
        column = NAMES.index(name)
        for row, values in TABLE.items():
            setattr(self, row, values[column])

    def but(self, **changes):
        """The same flavour with some rows changed."""
        other = Flavour(self.name)
        vars(other).update(vars(self))
        for row, value in changes.items():
            assert row in TABLE, row
            setattr(other, row, value)
        return other

    def data_type(self, name):
        """A data type name as this implementation writes it."""
        scope, _, last = name.rpartition("/")
        return last if self.bare_types else f"IDL:{scope or 'RTC'}/{last}:1.0"
