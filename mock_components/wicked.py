"""Components each of which knows one string only, a hostile one: their names, ports, types, values, messages
are made of it.

Those that hold shell commands make a file called canary when a shell runs them.
"""
import base64

from . import carrier, modules, observers
from .components import Spec
from .fsm import StateMachine
from .idl import RTC
from .manager import Manager
from .properties import nvlist

PERIOD = 0.05           # seconds from one message, event and value to the next


def _wire(text):
    return text.encode("utf-8").decode("latin-1")


STRINGS = {
    "escape": "\x1b[2J\x1b]0;owned\x07\x1b[31mred",
    "clipboard": "\x1b]52;c;%s\x07" % base64.b64encode(b"touch canary\n").decode(),
    "lines": "line\nfeed\rreturn\ttab\x08\x7f\ntouch canary\n",
    "c1": "\x9b31m\x90\x85" + _wire("\x9b32m\x85\u2028\u2029"),
    "bidi": _wire("\u202ecba\u202c\u2066x\u2069\u200e\u200f\u061c\u200b\ufeff"),
    "blank": _wire("\u3164\u115f\uffa0x\u2800\U000e0041\ufe0f\u034f"),
    "marks": _wire("\u0301z" + "\u0301\u0332\u20dd" * 20),
    "long": "L" * 65536,
    "empty": "",
    "above": "..",
    "here": ".",
    "option": "-rf",
    "substitution": "$(touch canary)`touch canary`${IFS}",
    "quotes": "';touch canary;'\";touch canary;\";touch canary #",
    "operators": "& touch canary | touch canary > canary\\",
    "invalid": "\xff\xfe\x80\xed\xa0\x80",
    "path": "a/b:c.d\\e\\x41//..",
    "formats": "~%s%n{}{0}%(x)s!!*?[a]#",
    "markup": "]]>&amp;</rts:Components><x y='\"'>- : # !!python/object:os.system",
}
INSTANCE = "Wicked0"    # of the component whose string is empty


class Wicked(StateMachine):
    """A state machine that answers everything with its string, and also reports it from time to time."""

    def identity(self):
        said = self.spec.type_name
        return {
            name: said
            for name in ("implementation_id", "type_name", "description", "version", "vendor", "category")
        }

    def properties(self):
        said = self.spec.type_name
        return super().properties() + [(said, said), ("os.name", said)]

    def harass(self):
        said = self.spec.type_name
        self.fsm.state = said
        self.fsm.structure = RTC.FsmStructure(
            said, said, [RTC.FsmEventProfile(said, said)], nvlist([(said, said)])
        )
        while True:
            carrier.sleep(PERIOD)
            self.observers.log("ERROR", said, said)
            self.report("RTC_STATUS", said)
            self.report("CONFIGURATION", "SET_CONFIG_SET:" + said)
            self.ports[0].write(RTC.TimedString(RTC.Time(1, 2), said))


def spec(said):
    """Ports of all kinds, all but two with a sane type; set ids and parameters."""
    near = said[:20000]     # a path with the name of the component has to fit into an argument
    sets = {
        "default": {said: said, "plain": said},
        said or "more": {said: said},
        "__widget__": {said: ("radio"), "plain": said},
        "__constraints__": {said: f"({said})", "plain": said},
        "__description__": {said: said},
        "__doc__": {said: said, "description": said, "__contact__": said},
    }
    ports = [
        ("out", "out" + near, "TimedString"),
        ("in", "in" + near, "TimedString"),
        ("out", "odd" + near, "TimedLong"),
        ("service", "service" + near, "provided"),
    ]
    return Spec(said, said, ports, sets=sets, play=Wicked, category=said, vendor=said, version=said)


def add(stage, only=None):
    """A component for each string, bound under it below the home context and connected to the next one; and a
    manager.
    """
    added = []
    for said in [STRINGS[only]] if only else STRINGS.values():
        names = [stage.home() + [(said, "rtc")]]
        if 0 < len(said) < 100:
            names.append(stage.home() + [(said, "cxt"), (said, said)])
        component = stage.add(
            spec(said),
            said or INSTANCE,
            names=names,
            flavour=stage.flavour.but(component_key=None),
            consumers=(observers.OBSERVER, observers.LOGGER),
        )
        component.ports[2].data_type = said
        component.ports[3].entries = [("provided", said, said), ("required", said, said)]
        component.ports[3].services[said] = next(iter(component.ports[3].services.values()))
        added.append(component)
    for one, other in zip(added, added[1:]):
        said = one.spec.type_name
        pairs = [("dataport.dataflow_type", "push"), ("dataport.interface_type", "corba_cdr"),
                 ("dataport.subscription_type", "flush"), (said, said)]
        profile = RTC.ConnectorProfile(
            said, "id" + said, [one.ports[0].reference, other.ports[1].reference], nvlist(pairs)
        )
        code, _ = one.ports[0].connect(profile)
        assert code == RTC.RTC_OK, code
    _manage(stage, added)
    for component in added:
        stage.process.thread(component.harass)


def _manage(stage, added):
    """A manager that offers modules of those names, too."""
    manager = Manager(stage, STRINGS["substitution"])
    for component in added:
        module = modules.Module(component.spec, stage.flavour)
        manager.modules.available.append(module)
        manager.modules.loaded.append(module.path)
        manager.modules.factories[component.spec.type_name] = component.spec
