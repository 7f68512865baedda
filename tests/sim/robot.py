"""A simulated robot and the truth about it: which component lived when, in what state, and who removed what.
"""

import components
import world as worlds

from rtshell_lite.corba import orb, session
from rtshell_lite.net import loop
from rtshell_lite.play import nameserver

PORT = 2809
A_LIFE = 100000  # numbers that a component may send in a life
MEMBERS_TAKE = 10.0  # seconds at most, until those of a composite are Active
STARTING = 3.0  # seconds that it takes until a component is bound, or has answered what has waited


class Life:
    """One life of a component: in a Program, from `begun` until that or the component ends; its `component`
    is made a little later.
    """

    def __init__(self, begun, program, first):
        self.component = None
        self.program = program
        self.begun = begun
        self.first = first  # of the numbers that it sends

    @property
    def ended(self):
        """When, or None."""
        gone = self.component and self.component.gone
        return min([each for each in (self.program.ended, gone) if each is not None], default=None)

    def is_alive(self, when):
        return self.begun <= when and (self.ended is None or when < self.ended)

    def ended_by(self, when):
        return self.ended is not None and self.ended <= when

    def leaves_by(self, when):
        """Whether its component was asked to end by then."""
        return self.component is not None and self.component.left is not None and self.component.left <= when


class Robot:
    """The processes of a robot in a World.

    named      hosts whose processes give their names, and not addresses
    special    {name of a component that is no ordinary part: (which of components.SPECS, its members)}
    lives      {name of a component: [Life]}
    removed    [(time, name, reference)] of the names that somebody has unbound
    troubles   [(time, line)] of what has gone wrong
    """

    def __init__(self, world, name_server, special, named=()):
        self.world = world
        self.named = named
        self.special = special
        self.server = f"{name_server.address}:{PORT}"
        self.home = name_server
        self.lives = {}
        self.processes = {}  # {name: (host, flavour, [names of components])}
        self.programs = {}  # {name: Program}
        self.contexts = {}  # {address of an execution context: what is behind it}
        self.removed = []
        self.troubles = []  # (time, line) of what a fault has done
        self.seized = {}  # {name: since when it does not answer, though its process does}
        self.runs = {}  # {name of a process that an rtkeep keeps: its Programs}
        self.kept = {}  # {name of such a process that has one component: (host, flavour, its name)}
        self.families = []  # (Program, what it has started)
        self.bound = set()  # names of components that have been bound
        self.names = self.start_names()

    def path(self, name):
        return f"/{self.server}/robot.host_cxt/{name}.rtc"

    def count_bound(self):
        """How many components have been bound."""
        return len(self.bound.intersection(self.lives))

    def trouble(self, line):
        self.troubles.append((self.world.time, line))
        self.world.tell(line)

    def start_names(self):
        robot = self

        class Context(nameserver.Context):
            """A naming context that notes what is bound and removed."""

            def rebind(self, name, reference):
                super().rebind(name, reference)
                robot.bound.add(name[-1].id)

            def unbind(self, name):
                place, last = self._place(name)
                known = place.bound.get(last)
                super().unbind(name)
                robot.removed.append((robot.world.time, last[0], known[0]))

        return worlds.Program(
            self.home, "omniNames", components.serve_names(self.home.address, PORT, Context)
        )

    def start(self, name, host, flavour, members):
        """Start a process with these components."""
        parts = [(each, *self.special.get(each, ("part", ()))) for each in members]
        place = host.name if host.name in self.named else host.address
        main = components.serve(name, parts, flavour, place, self)
        program = worlds.Program(host, name, main)
        for each in members:
            self._begin(each, program)
        self.processes[name] = host, flavour, members
        self.programs[name] = program
        return program

    def _begin(self, name, program):
        """A Life of a component begins in a Program."""
        lives = self.lives.setdefault(name, [])
        lives.append(Life(self.world.time, program, 1 + len(lives) * A_LIFE))
        return lives[-1]

    def found(self, component):
        """A Part has been made, at the start of its process or by a manager."""
        name = component.instance_name
        life = self.lives.get(name, [None])[-1]
        if life is None or life.component is not None:
            life = self._begin(name, component.process.program)
        life.component = component
        return life.first

    def start_again(self, name):
        if not self.programs[name].is_over:
            return self.programs[name]
        return self.start(name, *self.processes[name])

    def start_host_again(self, home):
        """What has run on a host, whose power is back."""
        home.is_on = True
        if self.home is home:
            self.names = self.start_names()
        for name, (host, *_) in list(self.processes.items()):
            if host is home:
                self.start_again(name)

    def living(self, name):
        """The Part with that name that lives now, or None."""
        life = self.lives[name][-1]
        return life.component if life.is_alive(self.world.time) else None

    def ask(self, name, function):
        """Have its process call function(component) for the component with that name, if it lives; not where
        a fault spoils what that process answers, itself among others.
        """
        component = self.living(name)
        if component is not None and component.process.program.spoil is None:
            component.process.thread(function, component)
            component.process.program.wake()

    # ---- the truth ----

    def was_alive(self, name, begun, ended):
        """Whether it lived at a moment between two."""
        return any(
            life.begun <= ended and not life.ended_by(begun) for life in self.lives.get(name, ())
        )

    def was_gone(self, name, begun, ended):
        """Whether a life of it had ended by then."""
        return any(life.ended_by(ended) for life in self.lives.get(name, ()))

    def was_well(self, name, begun, ended):
        """Whether it lived all the time between two moments, in a process that was not stopped."""
        life = self.lives[name][-1]
        is_new = life.begun > max(0, begun - STARTING)  # the first ones have been waited for
        if is_new or not life.is_alive(ended) or life.leaves_by(ended):
            return False
        if life.program.lag or life.program.spoil is not None:
            return False
        if life.begun <= self.seized.get(name, life.begun - 1) <= ended:
            return False
        stops = life.program.stops
        last = begun - STARTING
        return not any(since < ended and (until is None or until > last) for since, until in stops)

    def states(self, name, begun, ended):
        """The states that it was in between two moments."""
        found = set()
        for life in self.lives.get(name, ()):
            if life.begun > ended or life.ended_by(begun):
                continue
            if life.component is None:
                continue
            history = life.component.states
            for number, (since, state) in enumerate(history):
                until = history[number + 1][0] if number + 1 < len(history) else ended + 1
                if since <= ended and until >= begun:
                    found.add(state)
        return found

    def connectors(self):
        """{NAME:port: ids of its connectors} of all that live."""
        found = {}
        for name in self.lives:
            component = self.living(name)
            if component is not None:
                for port in component.ports:
                    found[f"{name}:{port.short_name}"] = set(port.profiles)
        return found

    # ---- at the beginning ----

    def set_up(self, connections, active):
        """Connect [(name of the source, of the target)], and activate components."""

        async def main():
            for source, target in connections:
                ends = [self.living(source).ports[1].reference, self.living(target).ports[0].reference]
                properties = {
                    "dataport.dataflow_type": "push",
                    "dataport.interface_type": "corba_cdr",
                    "dataport.subscription_type": "new",
                    "dataport.data_type": "IDL:RTC/TimedLong:1.0",
                }
                profile = orb.struct("RTC.ConnectorProfile")(
                    f"{source}_{target}", "", ends, orb.nvlist(properties.items())
                )
                await orb.call("set up", ends[0], "connect", profile)
            driven = {member for _, members in self.special.values() for member in members}
            for name in [each for each in active if each not in driven]:
                component = self.living(name)
                context = component.owned[0].reference
                await orb.call("set up", context, "activate_component", component.reference)

        program = worlds.Program(
            self.home, "set up", lambda: loop.run(main(), session=session.Session(components.PATIENT))
        )
        self.world.run(self.world.time + 30, lambda: program.is_over)
        if program.failure:
            raise program.failure
        self.world.run(self.world.time + 0.1)
        end = self.world.time + MEMBERS_TAKE
        self.world.run(end, lambda: all(self.states(name, end, end) == {"Active"} for name in active))
