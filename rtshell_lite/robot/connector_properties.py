"""The names of properties of connections, as a user writes them."""

from rtshell_lite import errors, notes
from rtshell_lite.text import closest, printable

PREFIX = "dataport."
SIDES = ("inport.", "outport.")
OWN = ("buffer.", "publisher.")  # what only OpenRTM-aist reads; others are of transports and components
NEAR = 0.8  # how alike a misspelt name and a known one are, of 1

# What OpenRTM-aist reads, after the prefix, which may be followed by a side.
KNOWN = (
    "subscription_type dataflow_type interface_type data_type io_mode marshaling_type serializer.cdr.endian "
    "push_rate publisher.push_rate publisher.push_policy publisher.skip_count buffer.type buffer.length "
    "buffer.write.full_policy buffer.write.timeout buffer.read.empty_policy buffer.read.timeout "
    "allow_dup_connection timestamp_policy fan_in fan_out fsm_event_name data_value "
    "corba_cdr.inport_ior corba_cdr.inport_ref corba_cdr.outport_ior corba_cdr.outport_ref "
    "data_service.inport_ior data_service.inport_ref data_service.outport_ior data_service.outport_ref"
).split()

VALUES = {
    "publisher.push_policy": ("all", "fifo", "skip", "new"),
    "buffer.write.full_policy": ("overwrite", "do_nothing", "block"),
    "buffer.read.empty_policy": ("readback", "do_nothing", "block"),
}


def complete(given):
    """The properties of a dict with their full names: known ones may be written without `dataport.`; unknown
    ones are the user's own. Raises BadValue for those that are a known one misspelt; notes what OpenRTM-aist
    would not understand, as a component may know more.
    """
    full = {_full(key): value for key, value in given.items()}
    for key, value in full.items():
        _doubt(key, value)
    return full


def _doubt(key, value):
    """Note a name that is only the end of known ones, or stands where OpenRTM-aist has its own, and a value
    that a known one does not have.
    """
    side, rest = _parted(key)
    if rest not in KNOWN:
        longer = [PREFIX + side + name for name in KNOWN if name.endswith("." + rest)]
        if longer:
            notes.note(f"{printable(key)}: OpenRTM-aist has no such property, but {' and '.join(longer)}")
        elif rest.startswith(OWN):
            notes.note(f"{printable(key)}: OpenRTM-aist has no such property; rtcon --help -v names some")
        return
    values = VALUES.get(rest, ())
    if value and values and value.strip().lower() not in values:
        notes.note(f"{printable(key)}: OpenRTM-aist has no {printable(value)} (it has: {', '.join(values)})")


def _full(key):
    side, rest = _parted(key)
    if rest in KNOWN:
        return PREFIX + side + rest
    meant = closest(rest.lower(), KNOWN, NEAR)
    if meant is None:
        return key
    raise errors.BadValue(printable(key), f"no such property; did you mean {PREFIX}{side}{meant}?")


def _parted(key):
    """(the side of the connection, with its dot, or "", the rest of a name without its prefix)"""
    rest = key[len(PREFIX) :] if key.startswith(PREFIX) else key
    for side in SIDES:
        if rest.startswith(side):
            return side, rest[len(side) :]
    return "", rest
