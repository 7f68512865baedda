"""Components for tests of robot programs: they need what is on the robot, Python and this package, and no
omniORBpy.

    from rtshell_lite import api, mocks

    class Motor(mocks.Component):
        ins = {"target": "RTC.TimedDouble"}
        outs = {"angle": "RTC.TimedDouble"}

        def step(self, seconds):
            self.port("angle").send(self.value("target"))

    with mocks.robot({"Motor0.rtc": Motor}) as robot:
        api.component(robot.path("Motor0.rtc")).activate(wait=5)

They work on a thread of their own, with a name server of their own at 127.0.0.1, until the `with` statement
ends. All commands can be used on them meanwhile. docs/library.md says more.
"""

import contextlib
from _thread import allocate_lock

from rtshell_lite import errors
from rtshell_lite.corba.session import Session
from rtshell_lite.data import datatypes
from rtshell_lite.net import loop
from rtshell_lite.play import live, robot as play
from rtshell_lite.text import printable

__all__ = ["Component", "Fault", "Robot", "robot"]

Component = live.Worker  # the class to derive components from
Fault = live.Fault  # what their step() raises to go to Error
LOOK = 0.2  # seconds between two looks whether the components' thread has ended


class Robot:
    """A robot of mocks: `address` of its name server, HOST:PORT; `home`, the path of that."""

    def __init__(self):
        self.address = self.home = None
        self._parts = self._loop = self._task = self._failure = None
        self._received = {}  # by name of a port: what has come
        self._begun = _acquired()
        self._is_over = False
        self._ended = _acquired()

    def path(self, name):
        """The path of what is bound by a name, Motor0.rtc, or of a port of it, Motor0.rtc:target."""
        return self.home + "/" + name

    def component(self, name):
        """The object of the component with this instance name, Motor0. Raises NoSuch."""
        if name not in self._parts.by_name:
            raise errors.NoSuch("the robot", "component", printable(name))
        return self._parts.by_name[name]

    def fail(self, name):
        """Have a component that is Active go to Error."""
        part = self.component(name)

        def to_error():
            for context in part.contexts + part.participating:
                if context.state_of(part) == "Active":
                    context.set_state(part, "Error")

        self._run_there(to_error)

    def kill(self, name):
        """End a component as if its process had died: its name stays."""
        self._run_there(self.component(name).close)

    def send(self, port, value):
        """Send a value from an out port, Motor0:angle, as api.send has it. Connections of `robot` are "new",
        as most are: of values that are sent faster than they are carried, the last one comes.
        """
        self._run_there(self._parts.port(port).send, value)

    def received(self, port, count=1, timeout=5.0):
        """The values that have come to an in port, Motor0:target, since this was last called, once there are
        `count`. Raises errors.Unreachable where they do not come within `timeout` seconds.
        """
        self._parts.port(port)  # raises what is wrong with the name
        there = self._received[port]
        end = loop.now() + timeout
        while len(there.values) < count:
            if self._is_over:
                raise self._failure or RuntimeError("the robot has ended")
            if loop.now() > end:
                why = f"{len(there.values)} of {count} values within {timeout:g}s"
                raise errors.Unreachable(self.path(port), why)
            there.came.acquire(timeout=min(LOOK, max(0.0, end - loop.now())))
        values = there.values[:]
        del there.values[: len(values)]
        return values

    # ---- its thread ----

    def begin(self, *words):
        """Start it. Raises what that raises."""
        loop.world().start_thread(self._run, *words)
        self._begun.acquire()
        if self._failure is not None:
            raise self._failure

    def end(self):
        """End it, and wait for that. Raises what a component has raised that is no Fault."""
        if not self._is_over:
            self._loop.post(self._task.cancel)
        self._ended.acquire()
        if self._failure is not None:
            raise self._failure

    def _run(self, *words):
        try:
            loop.run(self._play(*words), session=Session())
        except loop.Cancelled:
            pass
        except BaseException as e:
            self._failure = e
        self._is_over = True
        if self._begun.locked():
            self._begun.release()
        self._ended.release()

    async def _play(self, components, connections, members, idl, is_active):
        here = loop.current()
        here.make_bell()
        async with loop.Group() as tasks:
            self._parts = play.Robot(tasks, datatypes.Types(idl=idl), components, connections, members)
            self._listen_to_ports()
            try:
                self.address = await self._parts.listen()
                self.home = "/" + self.address
                await self._parts.begin(is_active)
                self._task = here.running
                self._loop = here
                self._begun.release()
                await loop.Bell().wait()
            finally:
                await loop.finish(self._parts.end())
                tasks.cancel()

    def _listen_to_ports(self):
        for name, part in self._parts.by_name.items():
            for port in part.ins:
                self._received[f"{name}:{port}"] = received = _Received()
                part.port(port).on_value = received.take

    def _run_there(self, function, *args):
        """Call a function on the thread of the components, and wait for that: what it returns or raises."""
        done = _acquired()
        outcome = []

        def call():
            try:
                outcome[:] = function(*args), None
            except BaseException as e:
                outcome[:] = None, e
            done.release()

        self._loop.post(call)
        while not done.acquire(timeout=LOOK):
            if self._is_over:
                raise self._failure or RuntimeError("the robot has ended")
        result, failure = outcome
        if failure is not None:
            raise failure
        return result


class _Received:
    """What has come to an in port; `came` is released when there is more."""

    def __init__(self):
        self.values = []
        self.came = _acquired()

    def take(self, value):
        self.values.append(value)
        if self.came.locked():
            self.came.release()


def _acquired():
    lock = allocate_lock()
    lock.acquire()
    return lock


@contextlib.contextmanager
def robot(components, connections=(), members=None, idl=(), active=False):
    """A Robot, for the time of a `with` statement.

    components   {what it is bound as, Motor0.rtc or arm.host_cxt/Motor0.rtc: its class, a Component}
    connections  pairs of ports that are connected at the start: ("Sensor0:out", "Motor0:target")
    members      {instance name of a composite: those of its members}
    idl          IDL files with data types that are not OpenRTM's own
    active       whether all are Active at the start

    Raises errors.Error, and at the end what a component has raised that is no Fault.
    """
    mocked = Robot()
    mocked.begin(components, connections, members, idl, active)
    try:
        yield mocked
    finally:
        mocked.end()
