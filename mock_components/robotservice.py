"""A service with operations of every kind, for who calls any: that of robot.idl.

Its descriptors are made of the IDL by the reader of rtshell_lite, which tests compare with omniidl elsewhere.
"""
import os
import threading
import time

from omniORB import PortableServer
from rtshell_lite.corba import schemas
from rtshell_lite.data.idl import parser
from rtshell_lite.giop import descriptors

FILE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "robot.idl")
REACH = 10.0            # of move_to, in each direction
CONTENTS = parser.read_file(FILE)


def _operations(name):
    """(given, returned, raised) of each operation of an interface, for omniORB, and the classes of its
    exceptions.
    """
    made = {}
    classes = {}
    for operation in CONTENTS.interfaces[f"IDL:Mock/{name}:1.0"].all_operations().values():
        schema = operation.schema()
        given, returned = [
            None if part is None else tuple(map(_plain, part)) for part in (schema.given, schema.returned)
        ]
        raised = {}
        for type_id, descriptor in schema.raised.items():
            raised[type_id] = schemas._Described().exception(descriptor)
            classes[descriptor[3]] = raised[type_id][1]
        made[operation.name] = (given, returned, raised or None)
    return made, classes


def _plain(descriptor):
    return schemas._Described().visit(descriptor)


def item(name):
    """An item of Mock::Mode."""
    return next(item for item in descriptors.items(CONTENTS.types["IDL:Mock/Mode:1.0"]) if item._n == name)


def make(name, *parts):
    """A struct of robot.idl."""
    return descriptors.factory(CONTENTS.types[f"IDL:Mock/{name}:1.0"])(*parts)


class Counter(PortableServer.Servant):
    """Mock::Counter: how often it was called."""

    _NP_RepositoryId = "IDL:Mock/Counter:1.0"
    _omni_op_d, _ = _operations("Counter")

    def __init__(self):
        self.count = 0

    def _get_calls(self):
        return self.count

    def reset(self):
        self.count = 0


class Robot(Counter):
    """Mock::Robot. What it is asked to say, and has beeped, is its `speech`."""

    _NP_RepositoryId = "IDL:Mock/Robot:1.0"
    _omni_op_d, _exceptions = _operations("Robot")

    def __init__(self):
        super().__init__()
        self.speed = 1.0
        self.speech = []
        self.joints = []
        self.busy = threading.Lock()
        self.reference = None

    def _get_speed(self):
        return self.speed

    def _set_speed(self, value):
        self.speed = value

    def _get_model(self):
        return "Mock of a robot"

    def say(self, words):
        self.count += 1
        self.speech.append(words)
        return words

    def ending(self):
        return "; ".join(self.speech)

    def move_to(self, goal, seconds):
        if abs(goal.x) > REACH or abs(goal.y) > REACH:
            nearest = make("Point", *(max(-REACH, min(REACH, part)) for part in (goal.x, goal.y)))
            raise self._exceptions["OutOfReach"](nearest, max(abs(goal.x), abs(goal.y)) - REACH)
        if not self.busy.acquire(blocking=False):
            raise self._exceptions["Busy"]()
        try:
            time.sleep(seconds)
            self.count += 1
        finally:
            self.busy.release()
        return goal, (goal.x ** 2 + goal.y ** 2) ** 0.5

    def turn(self, joints, back):
        self.joints = [-joint if back else joint for joint in joints]
        return self.joints, item("MOVING" if self.joints else "STANDING")

    def picture(self, size):
        return bytes(number % 256 for number in range(size))

    def transposed(self, given):
        return [list(row) for row in zip(*given)]

    def friend(self, other):
        return other

    aim = follow = keep = lambda self, value: value

    def itself(self):
        return self.reference

    def sum(self, *numbers):
        return sum(numbers[:-1]) + ord(numbers[-1])

    def wide(self, text, brief):
        return text + brief

    def beep(self, why):
        self.speech.append("beep: " + why)

    def rest(self, seconds):
        time.sleep(seconds)
        self.count += 1

    def fail(self):
        self.count += 1
        raise self._exceptions["Busy"]()        # which its IDL does not declare

    def lose(self):
        """The process ends in the middle of it."""
        self.count += 1
        os._exit(1)


for _servant in (Counter, Robot):
    _servant._omni_skeleton = _servant          # omniORB aborts the process without it
SERVANTS = {"Mock::Robot": Robot, "Mock::Counter": Counter}
