"""Log files of rtshell, made without it: classes of the same names, and for Python 2 opcodes by hand."""
import contextlib
import pickle
import struct
import sys
import types

TEXT, CLOSING = "IDL:RTC/TimedLong:1.0", 256


def _class(module, name):
    return type(name, (object,), {"__module__": module})


PortSpec = _class("rtshell.port_types", "PortSpec")
CurPos = _class("rtshell.simpkl_log", "CurPos")
EntryTS = _class("rtshell.ilog", "EntryTS")
Time = _class("rtctree.rtc.RTC", "Time")
TimedLong = _class("rtctree.rtc.RTC", "TimedLong")
CLASSES = (PortSpec, CurPos, EntryTS, Time, TimedLong)


def make(cls, **attributes):
    """An object of a class, with these attributes."""
    made = cls()
    made.__dict__.update(attributes)
    return made


@contextlib.contextmanager
def importable(classes=CLASSES):
    """Make the classes importable, as pickle requires."""
    modules = {}
    for cls in classes:
        parts = cls.__module__.split(".")
        for end in range(1, len(parts) + 1):
            modules.setdefault(".".join(parts[:end]), types.ModuleType(parts[end - 1]))
        setattr(modules[cls.__module__], cls.__name__, cls)
    before = {name: sys.modules.get(name) for name in modules}
    sys.modules.update(modules)
    try:
        yield
    finally:
        for name, module in before.items():
            del sys.modules[name]
            if module:
                sys.modules[name] = module


def spec(name="numbers", type_name=TEXT, cls=TimedLong):
    return make(PortSpec, _formatter=None, _input=True, _name=name, _type=cls, _type_name=type_name,
                _raw_specs=["/localhost/Src0.rtc:out." + name],
                _targets=[(["/", "localhost", "Src0.rtc"], "out")])


def values(count):
    return [make(TimedLong, tm=make(Time, sec=1000 + i, nsec=5), data=i * 7) for i in range(count)]


def log(data, protocol=4, closed=True, specs=None, start=1795247464.75, classes=CLASSES):
    """The bytes of a log of `data`, one entry of the first port each, 10 ms apart."""
    specs = specs or [spec()]
    with importable(classes):
        out = pickle.dumps((start, specs), protocol)
        area = len(out)
        out += b" " * CLOSING
        before = 0
        for index, each in enumerate(data):
            stamp = make(EntryTS, _sec=1795247464, _nsec=750000000 + index * 10000000)
            here = len(out)
            out += pickle.dumps((index, stamp, (specs[0]._name, each), here, before), protocol)
            before = here
        if closed:
            end = pickle.dumps(make(CurPos, index=len(data) - 1, prev=0, cache=before, fp=len(out)), protocol)
            out = out[:area] + end.ljust(CLOSING) + out[area + CLOSING:]
    return out


# ---- Python 2 ----

def python2_log(data, old_style=False):
    """The same in the form of Python 2: protocol 2, text as strings of octets; classes may be of the old
    style.
    """
    def text(value):
        return b"U" + bytes([len(value)]) + value.encode()

    def number(value):
        return b"J" + struct.pack("<i", value)

    def made(module, name, **attributes):
        found = b"c" + module.encode() + b"\n" + name.encode() + b"\n"
        head = b"(" + found + b"o" if old_style else found + b")\x81"
        return head + b"}(" + b"".join(text(key) + value for key, value in sorted(attributes.items())) + b"ub"

    path = b"](" + text("/") + text("localhost") + text("Src0.rtc") + b"e"
    port = made("rtshell.port_types", "PortSpec", _formatter=b"N", _input=b"\x88", _name=text("numbers"),
                _raw_specs=b"]" + text("/localhost/Src0.rtc:out.numbers") + b"a",
                _targets=b"]" + path + text("out") + b"\x86a",
                _type=b"cRTC\nTimedLong\n", _type_name=text(TEXT))
    out = b"\x80\x02" + b"G" + struct.pack(">d", 1795247464.75) + b"]" + port + b"a\x86." + b" " * CLOSING
    for index, value in enumerate(data):
        time = made("RTC", "Time", sec=b"\x8a\x01" + bytes([value.tm.sec % 100]), nsec=number(value.tm.nsec))
        stamp = made(
            "rtshell.ilog", "EntryTS", _sec=number(1795247464), _nsec=number(750000000 + index * 10000000)
        )
        pair = text("numbers") + made("RTC", "TimedLong", tm=time, data=number(value.data)) + b"\x86"
        out += b"\x80\x02(" + number(index) + stamp + pair + number(len(out)) + number(0) + b"t."
    return out
