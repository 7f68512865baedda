"""A component that puts something hostile into every string it reports."""
from rtshell_lite.giop import descriptors

from . import carrier, odd, values
from .components import Spec
from .idl import RTC
from .properties import nvlist
from .rtc import Component

ESCAPES = "\x1b[2J\x1b]0;owned\x07\x9b31m\r\n"
SHELL = "$(touch owned);`id`'\"|&<>*?~ -rf"
MARKUP = "]]><script>&amp;</rts:Components>%s{}"
YAMLISH = "- : # !!python/object:os.system\n? [null, *a]"
LONG = "x" * 65536
NAME = "Hostile\x1b[31m/$(id):.\\" + odd.JAPANESE

SETS = {
    "default": {"plain": ESCAPES, SHELL: SHELL, "": "", "long": LONG, "bad\xff": "\xff\xfe", "number": "-5",
                "a=b&c": "d=e?f"},
    SHELL: {MARKUP: YAMLISH},
    ESCAPES: {"x": "1"},
    "__widget__": {"plain": ESCAPES, "number": "slider.0"},
    "__constraints__": {"plain": "x >= ", "number": "(((", SHELL: "0 <= x <= $(id)"},
}


class Hostile(Component):
    """Adds properties of every type, and ports and connectors with hostile names."""

    def identity(self):
        return {"implementation_id": SHELL, "type_name": ESCAPES, "description": MARKUP, "version": YAMLISH,
                "vendor": odd.JAPANESE + SHELL, "category": "a.b/c:" + ESCAPES}

    def properties(self):
        wide = carrier.Any(carrier.typecode((descriptors.WSTRING, 0)), "wide \u65e5\u672c")
        return super().properties() + [
            (SHELL, ESCAPES), ("", ""), (ESCAPES, MARKUP), ("long", LONG), ("integer", carrier.to_any(5)),
            ("real", carrier.to_any(1.5)), ("wide", wide), ("null", carrier.Any(carrier.NULL, None)),
            ("struct", carrier.Any(values.typecode("TimedLong"), RTC.TimedLong(RTC.Time(1, 2), 3))),
            ("object", carrier.to_any(self.reference))]


SPEC = Spec(
    ESCAPES,
    MARKUP,
    [
        ("out", SHELL, "TimedLong"),
        ("in", ESCAPES, "TimedLong"),
        ("in", "", "TimedLong"),
        ("out", "plain", "TimedLong"),
        ("service", MARKUP, "provided"),
    ],
    sets=SETS,
    play=Hostile,
    category="a.b/c:" + ESCAPES,
)


def add(stage):
    """Bind it under a name that can be typed, and connect its plain port to its hostile one."""
    component = stage.add(SPEC, NAME, names=[stage.home() + [("Hostile0", "rtc")]], flavour=stage.flavour.but(
        component_key=None))
    for port in component.ports[:3]:
        port.data_type = "IDL:" + SHELL + ":1.0"
    component.ports[4].entries = [("provided", SHELL, MARKUP), ("required", ESCAPES, YAMLISH)]
    component.ports[4].services[SHELL] = next(iter(component.ports[4].services.values()))
    ports = [component.port("plain").reference, component.port(ESCAPES).reference]
    pairs = [
        ("dataport.dataflow_type", "push"),
        ("dataport.interface_type", "corba_cdr"),
        (SHELL, ESCAPES),
        ("", MARKUP),
    ]
    code, _ = component.port("plain").connect(
        RTC.ConnectorProfile(ESCAPES + SHELL, "id/" + SHELL, ports, nvlist(pairs))
    )
    assert code == RTC.RTC_OK, code
