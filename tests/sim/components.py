"""Programs of a simulated robot: its name server, and processes with mocks as components."""

import carrier
import world as worlds

from mock_components import components, flavour, manager, naming, stage
from mock_components.__main__ import Options

from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.play import nameserver

PATIENT = 1e9  # seconds that a component waits for others, as it knows no deadline
RATE = 20.0  # Hz
FOR_EVER = 1e9
BINDING = 0.5  # seconds until it tries to bind its name again
# implementations of OpenRTM, as far as our own ORB carries them: it writes texts only into properties
FLAVOURS = {
    name: flavour.Flavour(name).but(reference="never", data_value=False, integer_pid=False)
    for name in ("cpp11", "cpp12", "cpp2", "py2", "java")
}
OPTIONS = Options(
    context="robot.host_cxt/%n.rtc",
    rate=RATE,
    sync=True,
    contexts=1,
    running=True,
    arguments={},
    control=None,
    consumers=None,
    size=0,
    fate="",
)


class Part(components.Sender):
    """A component with an in port and an out port, which sends numbers from its `first` on while it is Active
    and a tool is connected with it; `numbers` are those that it has sent, each with its time. When it was
    asked to end, it `left`, and then was `gone`.
    """

    left = gone = None  # type: float

    def __init__(self, *given):
        super().__init__(*given)
        self.numbers = {}
        self.first = self.options.found(self)

    @property
    def busy(self):
        """Whether there is something to do in a cycle: nobody else would notice."""
        into, out = self.ports
        return bool(into.buffer.values and into.transports or self._listeners(out))

    @staticmethod
    def _listeners(out):
        return [each for each, profile in out.profiles.items() if len(profile.ports) == 1]

    def activated(self, handle):
        return self._fine(handle)

    def on_execute(self, handle):
        into, out = self.ports
        if self._listeners(out):
            number = self.first + len(self.numbers)
            self.numbers[number] = carrier.now() - worlds.FIRST
            out.write(components.values.make(out.type_name, number, True))
        self.read_ports(handle)
        return self._fine(handle)

    def exit(self):
        self.left = carrier.now() - worlds.FIRST
        code = super().exit()
        self.gone = carrier.now() - worlds.FIRST
        return code

    def report(self, kind, hint):
        super().report(kind, hint)
        self.awake()

    def read_between(self):
        super().read_between()
        self.awake()

    def awake(self):
        """Have its contexts look whether there is something to do."""
        for each in self.owned:
            each.changed.notify_all()

    @property
    def states(self):
        """[(time, state in its own context)], what was true and when."""
        history = self.owned[0].members[0].history
        return [(when - worlds.FIRST, state._n[: -len("_STATE")].capitalize()) for when, state in history]


SPEC = components.Spec(
    "C",
    "Part of a simulated robot",
    [("in", "in", "TimedLong"), ("out", "out", "TimedLong")],
    sets={"default": {"gain": "1"}, "other": {"gain": "2"}},
    play=Part,
    vendor="sim",
    category="test",
    max_instance=1000,
)


class Naming(naming.Naming):
    """A name server that may not be there yet, or have a name in another way."""

    def bind(self, name, reference):
        while True:
            try:
                return super().bind(name, reference)
            except carrier.Raised:
                carrier.sleep(BINDING)


def serve_names(address, port, made):
    """main() of a name server, whose naming contexts are of this class."""

    async def serve():
        orb.listen(address, port)
        nameserver.Names(address, made)
        await loop.sleep(FOR_EVER)

    return lambda: loop.run(serve(), session=session.Session(PATIENT))


def serve(name, parts, kind, host, server, found):
    """main() of a process of this name at a host, of a flavour, which binds components with the names `parts`
    in the name server at `server`, HOST:PORT, and a manager where it can make components itself.
    found(Part) is called for each, and returns the first number that it is to send.
    """

    def set_up(process):
        options = OPTIONS.but(found=found)
        here = stage.Stage(process, Naming(process, server), FLAVOURS[kind], options)
        if here.flavour.creates_here:
            made = manager.Manager(here, name)
            made.modules.factories[SPEC.implementation_id] = SPEC
        for part in parts:
            here.add(SPEC, part)

    async def live(process):
        process.start(host)
        process.thread(set_up, process)
        await loop.sleep(FOR_EVER)

    def main():
        process = carrier.Process(loop.world())
        try:
            loop.run(live(process), session=session.Session(PATIENT))
        finally:
            process.end()

    return main
