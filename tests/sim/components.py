"""Programs of a simulated robot: its name server, and processes with mocks as components."""

import carrier
import slaves  # noqa: F401: before what starts some
import world as worlds

from mock_components import components, composite, flavour, fsm, manager, naming, rtc as component, stage
from mock_components.__main__ import Options

from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.play import nameserver

PATIENT = 1e9  # seconds that a component waits for others, as it knows no deadline
RATE = 20.0  # Hz
FOR_EVER = 1e9
BINDING = 0.5  # seconds until it tries to bind its name again


def of_bottle(name):
    """An implementation of OpenRTM, as far as our own ORB carries it, which writes only texts into
    properties.
    """
    return flavour.Flavour(name).but(reference="never", data_value=False, integer_pid=False)


FLAVOURS = {name: of_bottle(name) for name in ("cpp11", "cpp12", "cpp2", "py2", "java")}
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


class Part(component.Component):
    """A component of which the truth is known. When it was asked to end, it `left`, and then was `gone`."""

    left = gone = None  # type: float

    def __init__(self, *given):
        super().__init__(*given)
        self.numbers = {}  # that it has sent, each with its time
        self.shared = []  # contexts of other components that have executed it
        self.first = self.options.robot.found(self)

    def own_context(self):
        super().own_context()
        self.options.robot.contexts[self.owned[-1].reference.address[1:]] = self.owned[-1]

    def attach_context(self, cxt):
        self.shared.append(self.options.robot.contexts[cxt.address[1:]])
        return super().attach_context(cxt)

    def exit(self):
        self.left = carrier.now() - worlds.FIRST
        code = super().exit()
        self.gone = carrier.now() - worlds.FIRST
        return code

    def fail(self):
        """Go to Error, where it is executed."""
        for each in self.shared:
            is_here = each.process is self.process and any(self.is_me(member) for member in each.members)
            if is_here:
                return each.fail(self.reference)
        self.owned[0].fail(self.reference)

    def is_me(self, member):
        return member.reference.address[1:] == self.reference.address[1:]

    @property
    def states(self):
        """[(time, state over all contexts)], what was true and when."""
        own = self.owned[0].everyone[0]
        if not self.shared:
            return [(when - worlds.FIRST, WORDS[state._n]) for when, state in own.history]
        spans = [(own.history, FOR_EVER)]
        for each in self.shared:
            ended = each.process.program.ended
            end = FOR_EVER if ended is None else ended + worlds.FIRST
            for member in filter(self.is_me, each.everyone):
                spans.append((member.history, min(end, FOR_EVER if member.left is None else member.left)))
        times = sorted({when for history, end in spans for when in [end] + [when for when, _ in history]})
        return [(when - worlds.FIRST, _merged(spans, when)) for when in times if when < FOR_EVER]


WORDS = {f"{word.upper()}_STATE": word for word in ("Error", "Active", "Inactive", "Created")}


def _merged(spans, when):
    """The state at a time, of [(history in a context, when that ends)]."""
    found = set()
    for history, end in spans:
        if history[0][0] <= when < end:
            found.add([WORDS[state._n] for since, state in history if since <= when][-1])
    return next(word for word in WORDS.values() if word in found)


class Sender(Part, components.Sender):
    """A component with an in port and an out port, which sends numbers from its `first` on while it is Active
    and a tool is connected with it.
    """

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

    def report(self, kind, hint):
        super().report(kind, hint)
        self.awake()

    def read_between(self):
        super().read_between()
        self.awake()

    def awake(self):
        """Have its contexts look whether there is something to do."""
        for each in self.owned + self.shared:
            each.changed.notify_all()


class Composite(Part, composite.Composite):
    """Executes others."""


class Provider(Part):
    """Provides a service."""


class Machine(Part, fsm.StateMachine):
    """Has a state machine."""


def _spec(implementation_id, ports, play, **more):
    sets = {"default": dict({"gain": "1"}, **more), "other": {"gain": "2"}}
    return components.Spec(
        implementation_id,
        "Part of a simulated robot",
        ports,
        sets=sets,
        play=play,
        vendor="sim",
        category="test",
        max_instance=1000,
    )


SPECS = {
    "part": _spec("C", [("in", "in", "TimedLong"), ("out", "out", "TimedLong")], Sender),
    "composite": _spec("Composite", [], Composite, members="", exported_ports=""),
    "provider": _spec("Provider", [("service", "svc", "provided")], Provider),
    "machine": _spec("Machine", [("event", "event", "TimedLong")], Machine),
}


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


def serve(name, parts, kind, host, robot):
    """main() of a process of this name at a host, of a flavour, which binds the components `parts`, (name,
    which of SPECS, members of a composite), in the name server of a Robot, and a manager where it can make
    components itself.
    """

    def set_up(process):
        options = OPTIONS.but(robot=robot)
        here = stage.Stage(process, Naming(process, robot.server), FLAVOURS[kind], options)
        if here.flavour.creates_here:
            made = manager.Manager(here, name)
            made.modules.factories["C"] = SPECS["part"]
        for part, spec, members in parts:
            arguments = {"conf.default.members": ",".join(members)} if members else {}
            here.add(SPECS[spec], part, arguments=arguments)

    return living(host, set_up)


def living(host, set_up):
    """main() of a process at a host that lives until it is killed, of which set_up(process) makes the
    objects.
    """

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
