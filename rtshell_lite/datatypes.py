"""Data types of ports by their names: what is known of them without asking anybody."""

_BASIC = ("null", "void", "short", "long", "unsigned short", "unsigned long", "float", "double", "boolean", "char", "octet",
          "any", "TypeCode", "Principal")  # by CORBA::TCKind
_MORE = {23: "long long", 24: "unsigned long long", 26: "wchar"}
_STRING, _SEQUENCE, _ARRAY, _ALIAS, _STRUCT, _ENUM, _WSTRING = 18, 19, 20, 21, 15, 17, 27


def members(type_id):
    """The members of a standard data type (`IDL:RTC/TimedLong:1.0`) as (name, type in words), None for a type not known."""
    descriptor = _descriptor(type_id)
    if descriptor is None or descriptor[0] != _STRUCT:
        return None
    return list(zip(descriptor[4::2], map(_words, descriptor[5::2])))


def _descriptor(type_id):
    name = type_id[4:].rpartition(":")[0] if type_id.startswith("IDL:") else "RTC/" + type_id
    module, _, name = name.rpartition("/")
    if module not in ("RTC", "Img"):
        return None
    if module == "RTC":
        from rtshell_lite.idl_stubs.data import RTC as types
    else:
        from rtshell_lite.idl_stubs.data import Img as types
    found = getattr(types, "_d_" + name, None)
    return found if isinstance(found, tuple) else None


def _words(descriptor):
    """The IDL spelling of an omniORB type descriptor (omniORB.tcInternal)."""
    if isinstance(descriptor, int):
        return _BASIC[descriptor] if descriptor < len(_BASIC) else _MORE.get(descriptor, "type %d" % descriptor)
    kind = descriptor[0]
    if kind in (_STRING, _WSTRING):
        return "string" if kind == _STRING else "wstring"
    if kind == _SEQUENCE:
        return "sequence<%s>" % _words(descriptor[1])
    if kind == _ARRAY:
        return "%s[%d]" % (_words(descriptor[1]), descriptor[2])
    if kind == _ALIAS:
        return descriptor[2]
    if kind == _STRUCT:
        return descriptor[3]
    return descriptor[2] if kind == _ENUM else "type %d" % kind
