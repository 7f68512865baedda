"""The times in values against this host's clock: whatever compares times is misled where the two differ."""

import struct

from rtshell_lite.data import datatypes

# seconds
MINUTE = 60.0
DAY = 86400.0
APART = 2  # minutes by which clocks differ; less may be the way of a value


def is_stamped(port):
    """Whether the values of a ports.Port begin with a time, as far as its type is known here."""
    members = datatypes.members(port.properties.get("dataport.data_type", ""))
    return bool(members) and members[0] == ("tm", "Time")


def seconds(message):
    """The time that a reading.Message begins with, in s since 1970; 0 where a component sets none, as many
    do.
    """
    if len(message.data) < 8:
        return 0
    order = "<LL" if message.little else ">LL"
    whole, nanoseconds = struct.unpack_from(order, message.data)
    return whole + nanoseconds / 1e9 if whole else 0


def distance(received, stamp):
    """When a value came that is stamped with a time, in words. In s since 1970."""
    if received >= stamp:
        return f"stamped {received - stamp:.3f} s before it came here"
    return f"stamped {stamp - received:.3f} s after it came here"


def difference(received, stamp):
    """How far the time of a value, `stamp`, is from its arrival, in words; '' if not far. In s since 1970."""
    away = (stamp - received) / MINUTE
    if abs(away) < APART:
        return ""
    if abs(away) < DAY / MINUTE:
        shown = f"{abs(away):.0f} minutes"
    else:
        shown = f"{abs(away) * MINUTE / DAY:.1f} days"
    where = "behind" if away < 0 else "ahead of"
    return f"the times in its values are {shown} {where} this host's clock"
