"""More processes of one world: each is started like the first, has a control socket of its own, and ends with
it.
"""
import os
import sys

from .idl import RTM

GRACE = 3               # seconds that a process gets for ending in good order


def command(stage, words):
    """The command line of a mock like this one, without a control socket."""
    options = stage.options
    line = [
        sys.executable,
        "-m",
        "mock_components",
        "--nameserver",
        stage.names.address,
        "--context",
        options.context,
        "--flavour",
        stage.flavour.name,
        "--rate",
        f"{options.rate:g}",
    ]
    return line + ([] if options.sync else ["--async"]) + list(words)


def environment():
    """The environment of this process, without the path of its control socket."""
    return {key: value for key, value in os.environ.items() if key != "MOCK_CONTROL"}


def start(stage, words, port=""):
    """Start another process and wait until it is ready; its control socket is PATH.1, PATH.2 …"""
    line = command(stage, words) + (["--port", port] if port else [])
    if stage.options.control:
        line += ["--control", control(stage, len(stage.controls) + 1)]
        stage.controls.append(line[-1])
    import subprocess  # here and below, as few worlds have children
    child = subprocess.Popen(line, stdout=subprocess.PIPE, env=environment())
    stage.children.append(child)
    stage.process.thread(child.wait)
    assert child.stdout.readline().startswith(b"ready"), f"did not start: {' '.join(words)}"
    return child


def control(stage, number):
    """The path of the control socket of the process with this number."""
    return "%s.%d" % (stage.options.control, number)


def end(stage):
    """End what was started here."""
    if not stage.children:
        return
    import subprocess
    for child in stage.children:
        child.terminate()
    for child in stage.children:
        try:
            child.wait(GRACE)
        except subprocess.TimeoutExpired:
            child.kill()


def manager_at(process, place):
    """The manager that listens on HOST:PORT."""
    reference = process.reference(f"corbaloc:iiop:1.2@{place}/manager")
    return reference._unchecked_narrow(RTM.Manager)
