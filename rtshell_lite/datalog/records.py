"""What a log holds: channels, and entries in them."""

import collections
import re

# A stream in a log: its name for playing, its data type's id, that type as bytes (b"": unknown), the ports it
# came from; the encoding of its messages (cdr, json, …), and what the file says of their type, where somebody
# else wrote it: (name, encoding, data), or None; what else is known of it, texts by name.
Channel = collections.namedtuple("Channel", "name type_id typecode sources encoding schema about")
Channel.__new__.__defaults__ = ("cdr", None, ())

# One message: its number, when it arrived (ns since the epoch), its channel's number, and either its CDR and
# whether that is little-endian, or (simpkl, JSON) its `value` of dicts, lists, text and numbers.
Entry = collections.namedtuple("Entry", "number received channel little data value")


def is_moment(value):
    """Whether a value can be a time: nanoseconds since the epoch, in 64 bits."""
    return type(value) is int and -1 << 63 <= value < 1 << 63


def is_called(word, names):
    """Whether a channel may be called so on a command line. `names`: that in the log, the paths of its ports;
    the end of one will do: Arm0.rtc:joints, joints.
    """
    end = word.lstrip("./")
    return any(name == word or name.endswith(("/" + end, ":" + end)) for name in names)


def cuts(word):
    """Where the name of a channel or a port may end in NAME[.FIELD], from the end on."""
    return [len(word)] + [match.start() for match in reversed(list(re.finditer(r"[.\[]", word)))]
