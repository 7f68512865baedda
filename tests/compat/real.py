"""Built examples of OpenRTM-aist, found in directories and started on loopback. Nothing of OpenRTM is kept
here.

A directory with built examples of C++ holds programs such as SeqOutComp; one of Python holds OpenRTM_aist,
with its stubs made.
"""
import glob
import os
import signal
import subprocess
import sys
import tempfile
import time

from loops import wait_for
from rtshell_lite import errors
from rtshell_lite.robot import component, ports, tree

START_LIMIT = 60.0  # seconds
# The parts of a robot: the program (C++), the script (Python), and the instance name, where it is not that of
# the program.
PARTS = {
    "SeqOut": ("SeqOut", "SeqIO/SeqOut.py", "SequenceOutComponent"),
    "SeqIn": ("SeqIn", "SeqIO/SeqIn.py", "SequenceInComponent"),
    "ConsoleOut": ("ConsoleOut", "SimpleIO/ConsoleOut.py", "ConsoleOut"),
    "Sensor": ("Sensor", "Composite/Sensor.py", "Sensor"),
    "Controller": ("Controller", "Composite/Controller.py", "Controller"),
    "Motor": ("Motor", "Composite/Motor.py", "Motor"),
    "ConfigSample": ("ConfigSample", "ConfigSample/ConfigSample.py", "ConfigSample"),
    "MyServiceProvider": ("MyServiceProvider", "SimpleService/MyServiceProvider.py", "MyServiceProvider"),
    "MyServiceConsumer": ("MyServiceConsumer", "SimpleService/MyServiceConsumer.py", "MyServiceConsumer"),
}
HERE = os.path.dirname(os.path.abspath(__file__))
CONFIGURATION = """\
corba.nameservers: 127.0.0.1:%(port)d
corba.endpoints: 127.0.0.1:
naming.formats: %(context)s/%%n.rtc
logger.enable: YES
logger.file_name: stdout
logger.log_level: ERROR
exec_cxt.periodic.rate: %(rate)g
%(more)s
"""


async def _answer(path):
    """The Node of a component, which has to answer with its ports and its state."""
    node = await tree.component(path)
    await ports.ports(node)
    await component.state(node)
    return node


class Cplusplus:
    """The examples of a directory with programs."""

    name = "C++"
    more = ""

    def __init__(self, directory):
        found = glob.glob(os.path.join(glob.escape(directory), "**", "*Comp"), recursive=True)
        self.programs = {
            os.path.basename(path)[: -len("Comp")]: path for path in found if os.access(path, os.X_OK)
        }
        libraries = glob.glob(os.path.join(glob.escape(directory), "**", "lib*.so"), recursive=True)
        self.environment = {
            "LD_LIBRARY_PATH": os.pathsep.join(sorted({os.path.dirname(path) for path in libraries}))
        }

    def command(self, part):
        return [self.programs[PARTS[part][0]]] if PARTS[part][0] in self.programs else None

    def instance(self, part):
        return PARTS[part][0] + "0"


class Python:
    """The examples of a directory with the package OpenRTM_aist."""

    name = "Python"
    # A transport that connects one port alone, see one_port.py
    more = "manager.modules.load_path: %s\nmanager.modules.preload: one_port.py" % HERE

    def __init__(self, package):
        self.examples = os.path.join(package, "examples")
        idl = os.path.join(package, "RTM_IDL")
        self.environment = {"PYTHONPATH": os.pathsep.join(
            [os.path.dirname(package), package, idl, os.path.join(idl, "device_interfaces")])}

    def command(self, part):
        script = os.path.join(self.examples, PARTS[part][1])
        return [sys.executable, script] if os.path.exists(script) else None

    def instance(self, part):
        return PARTS[part][2] + "0"


def implementations(directories):
    """What is found in the directories: Cplusplus and Python objects."""
    found = []
    for directory in directories:
        if glob.glob(os.path.join(glob.escape(directory), "**", "SeqOutComp"), recursive=True):
            found.append(Cplusplus(directory))
        packages = glob.glob(
            os.path.join(glob.escape(directory), "**", "OpenRTM_aist", "RTM_IDL"), recursive=True
        )
        found += [Python(os.path.dirname(package)) for package in packages[:1]]
    return found


class Robot:
    """Components of one implementation, each in a process of its own, bound below a context of their own."""

    def __init__(self, implementation, label, rate, name_server, parts=tuple(PARTS)):
        self.implementation = implementation
        self.label = label
        self.rate = rate
        self.home = "/127.0.0.1:%d/%s.host_cxt" % (name_server, label)
        self.directory = tempfile.TemporaryDirectory(prefix="rt-real-")
        self.processes = {}
        self.nodes = {}
        self.harm = None  # what was wrong first: reported once, and the rest is not tried
        try:
            for part in parts:
                if implementation.command(part):
                    self.processes[part] = self._start(part, name_server)
            self.nodes.update((part, self._node(part)) for part in self.processes)
            self.connected = self.connectors()
        except BaseException:
            self.close()
            raise
        self.active = ()  # the parts that are to stay Active
        self.feeder = None  # the process that sends values through it

    def _start(self, part, name_server):
        where = os.path.join(self.directory.name, part)
        os.mkdir(where)
        with open(os.path.join(where, "rtc.conf"), "w") as file:
            file.write(CONFIGURATION % {"port": name_server, "context": self.label + ".host_cxt",
                                        "rate": self.rate, "more": self.implementation.more})
        with open(os.path.join(where, "out"), "wb") as out:
            command = self.implementation.command(part) + ["-f", "rtc.conf"]
            environment = dict(os.environ, **self.implementation.environment)
            return subprocess.Popen(
                command, cwd=where, stdin=subprocess.PIPE, stdout=out, stderr=out, env=environment
            )

    def _node(self, part):
        """The part, once it answers with its ports and its state: its name is bound before."""
        end = time.monotonic() + START_LIMIT
        while True:
            try:
                return wait_for(_answer(self.path(part)))
            except errors.Error as e:
                if self.processes[part].poll() is not None:
                    raise AssertionError(self.ending(part)) from None
                if time.monotonic() > end:
                    words = self.path(part), e, self.last_words(part)
                    raise AssertionError("%s did not start: %s\n%s" % words) from None
                time.sleep(0.1)

    def path(self, part):
        return "%s/%s.rtc" % (self.home, self.implementation.instance(part))

    def said(self, part):
        """What a component has printed so far."""
        with open(os.path.join(self.directory.name, part, "out"), encoding="utf-8", errors="replace") as file:
            return file.read()

    def reads(self):
        """How many values ConsoleOut has read: it says so once for each, in Python twice. (Its listeners say
        other words.)
        """
        times = 2 if self.implementation.name == "Python" else 1
        return self.said("ConsoleOut").count("Received:") // times

    def last_words(self, part):
        """The end of what a component has printed, or of its last traceback (Python)."""
        said = self.said(part)
        return said[max(0, said.rfind("Traceback")):][-600:].strip()

    def dead(self):
        """Which processes have ended, and how."""
        return [self.ending(part) for part, process in self.processes.items() if process.poll() is not None]

    def ending(self, part):
        """How the process of a part has ended: its command line, its signal or status, the end of its log."""
        process = self.processes[part]
        how = "status %d" % process.returncode
        if process.returncode < 0:
            how = "signal %s" % signal.Signals(-process.returncode).name
        command = " ".join(process.args)
        return "%s %s ended: %s: %s\n%s" % (self.label, part, command, how, self.last_words(part))

    def near_misses(self):
        """How often a publisher has used a reference that had been released: of some hundred, one ends the
        process.
        """
        return sum(self.said(part).count("nil reference") for part in self.processes)

    def connectors(self):
        """The ids of the connectors of each port."""
        return {"%s:%s" % (part, port.name): sorted(connector.id for connector in port.connectors)
                for part, node in self.nodes.items() for port in wait_for(ports.ports(node))}

    def wrong(self):
        """What has changed: processes that have ended, ports with other connectors."""
        dead = self.dead()
        if dead:
            return dead
        now = self.connectors()
        changed = [name for name, before in self.connected.items() if now.get(name) != before]
        return ["%s %s: %s, not %s" % (self.label, name, now.get(name), self.connected[name])
                for name in changed]

    def fallen(self):
        """The parts that are to be Active and are not, and what they said last."""
        states = {part: self.state(part) for part in self.active}
        fallen = [part for part in self.active if states[part] != "Active"]
        return ["%s %s: %s: %s" % (self.label, part, states[part], self.last_words(part)) for part in fallen]

    def state(self, part):
        return wait_for(component.state(self.nodes[part]))

    def close(self):
        for process in self.processes.values():
            process.kill()
            process.wait()
            process.stdin.close()
        self.directory.cleanup()
