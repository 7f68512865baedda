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


def moment(data, little):
    """The time that octets of a value begin with, in ns since 1970; 0 where a component sets none, as many
    do.
    """
    if len(data) < 8:
        return 0
    whole, nanoseconds = struct.unpack_from("<LL" if little else ">LL", data)
    return whole * 10**9 + nanoseconds


def seconds(message):
    """The same of a reading.Message, in s since 1970; 0 also for less than a second."""
    whole, nanoseconds = divmod(moment(message.data, message.little), 10**9)
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
