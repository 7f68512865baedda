"""A world for the time of a `with` statement: for tests of robot programs, with any test runner. Importing
this needs no omniORB.

    from mock_components import world

    with world("two") as robot:
        check(robot.path("ConsoleIn0.rtc"))

docs/library.md says more, docs/example_test.py is a whole test.
"""
import contextlib
import os
import shutil
import subprocess
import sys
import tempfile

from . import asking

CONTEXT = "test.host_cxt"  # where components are bound


class World:
    """A running world: `address` of its name server, HOST:PORT; `home`, the path of its components."""

    def __init__(self, address, control):
        self.address = address
        self.home = f"/{address}/{CONTEXT}"
        self.control = control

    def path(self, name):
        """The path of what is bound by a name, ConsoleIn0.rtc, or of a port of it, ConsoleIn0.rtc:out."""
        return self.home + "/" + name

    def ctl(self, *words):
        """What it answers to a command, such as "write", "ConsoleIn0:out", 42; see `python3 -m
        mock_components ctl PATH help`.
        """
        done, text = asking.request(self.control, [str(word) for word in words])
        if not done:
            raise RuntimeError(text.strip())
        return text


@contextlib.contextmanager
def world(name, *arguments):
    """A World of that name (see --list) beside a name server of its own; both end with the `with` statement.

    `arguments` are those of the command line: "--rate", "100". Raises nameserver.Failed, RuntimeError.
    """
    # here, as `python3 -m mock_components.nameserver` imports this module before it runs that one
    from . import nameserver
    above = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    environment = dict(
        os.environ, PYTHONPATH=os.pathsep.join(filter(None, [above, os.environ.get("PYTHONPATH")]))
    )
    with contextlib.ExitStack() as stack:
        directory = tempfile.mkdtemp(prefix="mock-")
        stack.callback(shutil.rmtree, directory, ignore_errors=True)
        server, port = nameserver.start(directory)
        stack.callback(_end, server)
        control = os.path.join(directory, "control")
        process = subprocess.Popen(
            [
                sys.executable,
                "-m",
                "mock_components",
                name,
                *map(str, arguments),
                "--nameserver",
                f"127.0.0.1:{port}",
                "--context",
                CONTEXT + "/%n.rtc",
                "--control",
                control,
            ],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=environment,
            universal_newlines=True,
        )
        stack.callback(_end, process)
        if not process.stdout.readline().startswith("ready"):
            raise RuntimeError(f"the world {name} does not start")
        yield World(f"127.0.0.1:{port}", control)


def _end(process):
    process.kill()
    process.wait()
    for stream in filter(None, (process.stdin, process.stdout)):
        stream.close()
