"""The processes that tests talk to: name servers, worlds of mock components, peers that misbehave. All are
started here.

They keep their files in the directory $SESSION: NAME.pid, NAME.out (what they say) and NAME.control.
"""
import itertools
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time

import mounts

from tools import Failed, control, reaches, session_file

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.append(ROOT)  # behind what is installed
from mock_components import asking, nameserver  # noqa: E402
START_LIMIT = 90.0  # seconds until a peer must have said that it is ready, at load 50
# what a world says as its last word that does not go on when it is ready, and its state then
FATES = {"stops": "stopped", "ends": "gone"}


_started = {}  # processes by where they keep their files


def open_session(top=None):
    """Have all that is started from now on keep its files in the directory `top`, by default a new one, and
    end when this process does; returns the directory.
    """
    top = top or tempfile.mkdtemp(prefix="rt-")
    os.environ["SESSION"] = top
    os.mkfifo(session_file("alive"))  # what every peer has as stdin
    os.open(session_file("alive"), os.O_RDWR)  # never closed
    return top


def close_session(top):
    """End all that has its files in a directory, and remove it."""
    for place in [place for place in _started if place.startswith(top + "/")]:
        _kill(_started.pop(place))
    mounts.take_away(top)
    shutil.rmtree(top, ignore_errors=True)


def find(name):
    """The subprocess.Popen of that name."""
    return _started[session_file(name)]


def end(name):
    _kill(find(name))


def _kill(process):
    process.kill()
    process.wait()


# ---- starting ----

def start_name_server(name="names", above=nameserver.PORTS, published=None, options=()):
    """Start an omniNames of its own data directory; returns its port as text, one that sorts behind `above`.

    `published` is the port in its references, where that is another one; `options` are further words
    of omniNames.
    """
    publish = ["-ORBendPointPublish", "giop:tcp:127.0.0.1:%d" % published] if published else []
    more = list(options) + publish
    for attempt in range(nameserver.ATTEMPTS):
        port = nameserver.free_port(int(above))
        data = session_file("%s-%d" % (name, attempt))
        os.mkdir(data)
        words = nameserver.command(port, data) + more
        with open(session_file(name + ".command"), "w") as file:
            json.dump(words, file)
        start(name, words)
        if wait_until(lambda: nameserver.answers(port), name):
            return str(port)
    raise Failed("omniNames does not start: " + said(name))


def start_world(words, port):
    """Start a world of mock components; returns its name."""
    name = unused_name(words[0])
    options = ["--nameserver", "localhost:" + port, "--control", control(name)]
    start(name, [sys.executable, "-m", "mock_components"] + options + words)
    return name


def start_faulty(words):
    """Start peers that misbehave; returns the name of their process."""
    name = unused_name("faulty")
    start(name, [sys.executable, "-m", "mock_components.faulty"] + words)
    return name


def start(name, command):
    """Start a process that ends when this one does; its words go to a file, its number to another."""
    if "RTSHELL_PURE" in os.environ:
        raise Failed("a module of tests/unit/ starts no peers; those of tests/waiting/ may")
    path = os.environ.get("PYTHONPATH") or ROOT
    environment = dict(os.environ, PYTHONPATH=path, PYTHONUNBUFFERED="1", PYTHONDONTWRITEBYTECODE="1")
    with open(session_file("alive")) as alive, open(session_file(name + ".out"), "wb") as out:
        process = subprocess.Popen(command, stdin=alive, stdout=out, stderr=out, cwd=session_file(""),
                                   env=environment)
    with open(session_file(name + ".pid"), "w") as file:
        file.write(str(process.pid))
    _started[session_file(name)] = process


def start_again(name):
    """Start a name server that was killed, at its old port, with its old names."""
    with open(session_file(name + ".command")) as file:
        start(name, json.load(file))


def wait_until(condition, name):
    """The first true value of the condition; nothing if the process ended before, or took too long."""
    deadline = time.monotonic() + START_LIMIT
    while time.monotonic() < deadline:
        ended = find(name).poll() is not None
        value = condition()
        if value or ended:
            return value
        time.sleep(0.01)
    return None


def ready(name):
    """Wait until a peer says that it is ready, or where, as JSON; returns that line."""
    found = wait_until(lambda: re.search('^(ready.*|{".*)\n', said(name), re.MULTILINE), name)
    if not found:
        raise Failed("%s is not ready: %s" % (name, said(name)))
    state = FATES.get(found.group().split()[-1])
    if state and not reaches(find(name).pid, state, START_LIMIT):
        raise Failed("%s is not %s" % (name, state))
    return found.group()


def ctl(name, *words):
    """Ask a world, by the commands of mock_components/asking.py; returns its answer. Raises Failed."""
    done, text = asking.request(control(name), words)
    if not done:
        raise Failed("%s: %s: %s" % (name, " ".join(words), text.strip()))
    return text


def said(name):
    with open(session_file(name + ".out"), encoding="utf-8", errors="replace") as file:
        return file.read()


def unused_name(name):
    """A name for one more peer of that name: two, two2, two3 …, which no other thread gets, too."""
    for number in itertools.count(1):
        known = name + (str(number) if number > 1 else "")
        try:
            with open(session_file(known + ".out"), "x"):
                return known
        except FileExistsError:
            pass
