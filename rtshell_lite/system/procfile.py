"""Procfiles: the processes of a robot, in what order they start, and when each is ready.

nameserver: rtm-naming                      a name and a command; words are split as in sh, $NAME is replaced
nameserver.ready: localhost                 what answers when it is ready: a component, manager, name server
arm: ./Arm0Comp -f rtc.conf
arm.after: nameserver                       names: it starts when these are ready
arm.env: LANG=C                             more environment
arm.cwd: /opt/arm                           where it runs
arm.stop: INT 5                             the signal that ends it; after 5 seconds SIGKILL does
arm.restart: on-error                       these three as policy.parse takes them
arm.burst: 5/60
arm.delay: 0.5-30
"""

import collections
import os
import re

from rtshell_lite import errors, files, path
from rtshell_lite.net import real
from rtshell_lite.system import policy
from rtshell_lite.text import printable

STOP = "TERM 5"
WORDS = ("after", "ready", "env", "cwd", "stop", "restart", "burst", "delay")
LINE = re.compile(r"([\w-]+)(?:\.(%s))?:\s*(\S.*)" % "|".join(WORDS))

# One process of a Procfile: `command` a list of words, `after` names, `ready` a Path or None, `env` a dict,
# `stop` the signal that ends it and after how many seconds SIGKILL does.
Spec = collections.namedtuple("Spec", "name command after ready env cwd stop policy")


def read(name, usual):
    """The Specs of a Procfile in the order of starting; `usual` is the Policy of those without their own.
    Raises Failed, BadPath, OSError.
    """
    processes = collections.OrderedDict()
    for number, line in enumerate(files.read(name).splitlines(), 1):
        line = line.strip()
        if not line or line.startswith("#"):
            continue
        matched = LINE.match(line)
        try:
            if not matched:
                raise ValueError("not NAME: COMMAND, nor NAME.KEY: VALUE with KEY one of " + ", ".join(WORDS))
            if "\0" in line:
                raise ValueError("it contains a NUL character")
            process, key, value = matched.groups()
            words = processes.setdefault(process, {})
            if (key or "command") in words:
                raise ValueError(line.partition(":")[0] + " is there twice")
            words[key or "command"] = value
        except ValueError as e:
            raise errors.Failed("%s:%d" % (printable(name), number), e)
    if not processes:
        raise errors.Failed(printable(name), "no processes")
    specs = [_spec(name, process, words, processes, usual) for process, words in processes.items()]
    return _in_order(specs, name)


def _spec(file, name, words, processes, usual):
    try:
        command = _words(words.get("command", ""))
        if not command or not command[0]:
            raise ValueError("no command")
        after = words.get("after", "").split()
        for other in after:
            if other not in processes:
                raise ValueError(f"after {other}, which is not there")
        ready = path.parse(words["ready"]) if words.get("ready") else None
        environment = _environment(words.get("env", ""))
        cwd = words.get("cwd") and os.path.expandvars(words["cwd"])
        stop = _stop(words.get("stop", STOP))
        restarts = policy.parse(words.get("restart"), words.get("burst"), words.get("delay"), usual)
        return Spec(name, command, after, ready, environment, cwd, stop, restarts)
    except ValueError as e:
        raise errors.Failed(f"{printable(file)}: {name}", printable(str(e)))


def _words(value):
    """The words of a value, split as in sh, with what the environment has for $NAME. Raises ValueError."""
    import shlex

    return [os.path.expandvars(word) for word in shlex.split(value)]


def _environment(value):
    variables = {}
    for word in _words(value):
        name, equals, content = word.partition("=")
        if not name or not equals:
            raise ValueError("env: not KEY=VALUE: " + word)
        variables[name] = content
    return variables


def _stop(value):
    """(number of a signal, seconds) of a value such as `INT 5`. Raises ValueError."""
    word, _, seconds = value.partition(" ")
    number = real.signals().get(word if word.startswith("SIG") else "SIG" + word)
    if number is None:
        raise ValueError("stop: no such signal: " + word)
    try:
        patience = float(seconds or STOP.split()[1])
    except ValueError:
        patience = -1.0
    if not 0 <= patience <= policy.DAY:
        raise ValueError("stop: not SIGNAL SECONDS: " + value)
    return number, patience


def _in_order(specs, name):
    """Each behind those that it comes after. Raises Failed for a circle."""
    ordered = []
    while len(ordered) < len(specs):
        started = {spec.name for spec in ordered}
        due = [spec for spec in specs if spec not in ordered and started.issuperset(spec.after)]
        if not due:
            rest = ", ".join(spec.name for spec in specs if spec not in ordered)
            raise errors.Failed(printable(name), "these wait for each other: " + rest)
        ordered.append(due[0])
    return ordered
