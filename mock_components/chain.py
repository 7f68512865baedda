"""A chain of components that pass values on, one of which may do so badly."""
import collections
import functools

from . import carrier, dataport, values
from .components import Spec
from .idl import RTC
from .rtc import Component

LATE = 0.8              # seconds that values wait at a stage that delays them
SLOW = 10               # a stage that thins passes one in this many

RATE = 50               # Hz


class Link(Component):
    """Passes the values of `in` on to `out` with their times; the first of the chain makes them."""

    busy = True
    fault = ""

    def activated(self, handle):
        self.number = 0
        self.waiting = collections.deque()
        if self.has_in():
            self.port("in").take = functools.partial(self.receive, self.port("in"))
        return RTC.RTC_OK

    def receive(self, port, value):
        dataport.InPort.take(port, value)
        self.waiting.append((carrier.now(), value))

    def on_execute(self, handle):
        if self.has_in():
            self.read_ports(handle)
        else:
            value = values.make("TimedLong", int(carrier.wall() * 1e3) % 10**9, True)
            self.waiting.append((carrier.now(), value))
        while self.waiting and self.is_due():
            self.pass_on(self.waiting.popleft()[1])
        return RTC.RTC_OK

    def has_in(self):
        return any(port.port_type == "DataInPort" for port in self.ports)

    def is_due(self):
        return self.fault != "delayed" or carrier.now() - self.waiting[0][0] > LATE

    def pass_on(self, value):
        self.number += 1
        if self.fault == "stopped" or self.fault == "thinned" and self.number % SLOW:
            return
        if self.fault == "held":
            value = RTC.TimedLong(value.tm, 7)
        if self.fault == "disordered" and self.number % SLOW == 0:
            value = RTC.TimedLong(RTC.Time(value.tm.sec - 1, value.tm.nsec), value.data)
        if any(port.port_type == "DataOutPort" for port in self.ports):
            self.port("out").write(value)


FIRST = Spec(
    "Link", "Begins a chain", [("out", "out", "TimedLong")], play=Link, category="test", max_instance=1000
)
MIDDLE = Spec(
    "Link",
    "Passes values on",
    [("in", "in", "TimedLong"), ("out", "out", "TimedLong")],
    play=Link,
    category="test",
    max_instance=1000,
)
LAST = Spec(
    "Link", "Ends a chain", [("in", "in", "TimedLong")], play=Link, category="test", max_instance=1000
)


def add(stage, count, faults):
    """Link0, Link1, …, connected and active; `faults` are words such as held@3."""
    known = dict(reversed(fault.split("@")) for fault in faults)
    for number in range(count):
        if number == 0:
            spec = FIRST
        elif number == count - 1:
            spec = LAST
        else:
            spec = MIDDLE
        fault = known.get(str(number), "")
        link = stage.add(
            spec, f"Link{number}", rate=5.0 if fault == "slow" else RATE, running=fault != "halted"
        )
        link.fault = fault
    for number in range(1, count):
        if known.get(str(number)) != "cut":
            stage.connect(
                f"Link{number - 1}:out",
                f"Link{number}:in",
                *[("dataport.buffer.write.full_policy", "do_nothing")] * (known.get(str(number)) == "slow"),
            )
    for number in range(count):
        if known.get(str(number)) not in ("inactive", "halted"):
            link = stage.components[f"Link{number}"]
            link.owned[0].activate_component(link.reference)
