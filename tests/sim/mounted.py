"""People at a tree that rtmount has mounted: what they type, and the programs that read and write its files.
"""

import os
import stat

import fuse
import world as worlds

from rtshell_lite.mount import wire

TREE = "tree"  # where it is mounted; what follows in a path is below the naming context of the robot
KEPT = 8.0  # seconds, and up to half as much more, that rtmount runs
VALUE = "ports/out/value"
STREAMS = (VALUE, "events", "log")  # which wait for what comes
FILES = ("version", "profile.json", "configuration/active", "configuration/default/gain")
FILES += ("contexts/0/state", "contexts/0/rate", "contexts/0/owner", "ports/in/data_type")
INTERRUPTED = 0.2  # of the readers give up
LOOKS = 5  # how often some look at a file, one time after another
PAUSE = 0.4  # seconds between two of these
ANSWERED = 0.5  # of the faults are looked for in the tree
LEFT = 2.0  # seconds after which nothing is left of a reader
TOOLS = ("cat", "ls", "echo")


def draw_server(draw):
    """The words of an rtmount."""
    return f"rtmount -f {TREE}" + draw.choice(("", "", " --ttl 0.1", " --ttl 4"))


def draw(draw, names, special, only_reads):
    """(the words of somebody who uses the tree, seconds until Ctrl-C or None, how often it is typed)"""
    one = draw.choice(names + list(special))
    lines = [f"cat {TREE}/{one}.rtc/state"] * 4
    lines += [f"ls -l {TREE}", f"ls -l {TREE}", f"ls {TREE}"]
    lines += [f"ls -lR {TREE}/{one}.rtc", f"cat {TREE}/*.rtc/state"]
    one = draw.choice(names)
    lines += [f"cat {TREE}/{one}.rtc/{draw.choice(FILES)}" for _ in range(3)]
    lines += [f"cat {TREE}/{one}.rtc/{draw.choice(STREAMS)}", f"cat {TREE}/{one}.rtc/{VALUE}"]
    if not only_reads:
        lines += [f"echo {word} > {TREE}/{one}.rtc/state" for word in ("Active", "Inactive", "reset")]
        lines.append(f"echo 5 > {TREE}/{one}.rtc/configuration/default/gain")
    line = draw.choice(lines)
    if line.endswith(STREAMS) or draw.random() < INTERRUPTED:
        return line, round(draw.random() * 2, 3), 1
    return line, None, draw.choice((1, LOOKS)) if line.endswith(".rtc/state") and "cat" in line else 1


def draw_answer(draw, members):
    """The words of somebody who looks for a fault, which concerns these components."""
    if members:
        return draw.choice((f"ls -l {TREE}", f"cat {TREE}/{draw.choice(members)}.rtc/state"))
    return draw.choice((f"ls -l {TREE}", f"ls {TREE}"))


class Tool(worlds.Program):
    """A program of the system that reads or writes files of a mount: `requests` that were made for it.

    seen  [(names of a path, what was found, begun, ended)]: octets; {name: its mode}; an OSError
    """

    struck = None  # the number of a signal
    path = None  # of what it reads or writes now

    def __init__(self, host, name, words, environment, below):
        """`below`: the names that lead from the root to what people call the tree."""
        self.requests = []
        self.seen = []
        self._used = []
        self._words = words
        self._below = below
        self._mount = None
        super().__init__(host, name, self._live, words, environment)

    def strike(self, number):
        self.struck = number
        self.wake()

    def use(self, inode):
        """Keep an Inode from being forgotten while it runs."""
        inode.used += 1
        self._used.append(inode)
        return inode

    def _live(self):
        self._mount = self.host.mounts.get(os.path.abspath(TREE))
        if self._mount is None:  # an empty directory
            return 0
        while not self._mount.is_ready():
            self.wait(fuse.LONG)
        try:
            return getattr(self, "_" + self.name)(*self._words)
        except fuse.Struck:
            return 128 + self.struck
        finally:
            for inode in self._used:
                inode.used -= 1
            if self.world.random.random() < 0.5:
                self._mount.forget_all()

    def _names(self, path):
        return self._below + path.split("/")[1:]

    def _try(self, path, function, *args):
        """What function(Inode of a path) returns, noted; None, and a word about it, where that fails."""
        begun = self.world.time
        self.path = path
        names = self._names(path)
        try:
            found = function(self, self._mount.walk(self, names), *args)
        except OSError as e:
            print(f"{self.name}: {path}: {e.strerror}", file=self.error)
            found = e
        modes = {each: inode.mode for each, inode in found} if isinstance(found, list) else found
        self.seen.append((names[len(self._below) :], modes, begun, self.world.time))
        return None if isinstance(found, OSError) else found

    # ---- the programs ----

    def _cat(self, pattern):
        paths = [pattern]
        if "*" in pattern:
            names = self._try(TREE, self._mount.list) or ()
            end = pattern.partition("*")[2]
            paths = [f"{TREE}/{name}{end[4:]}" for name, _ in names if name.endswith(end[:4])]
        status = 0
        for path in paths:
            data = self._try(path, self._mount.read)
            if data is None:
                status = 1
            else:
                print(data.decode(), end="", file=self.out)
        return status

    def _ls(self, *words):
        *flags, path = words
        return self._list(path, bool(flags), "-lR" in flags)

    def _list(self, path, is_long, is_deep):
        found = self._try(path, self._mount.list)
        if found is None:
            return 1
        status = 0
        for name, inode in found:
            print(name, file=self.out)
            if is_long and not self._look(inode):
                status = 1
        for name, inode in found:
            if is_deep and stat.S_ISDIR(inode.mode):
                status = max(status, self._list(f"{path}/{name}", is_long, is_deep))
        return status

    def _look(self, inode):
        """What ls -l asks of each file."""
        try:
            if stat.S_ISLNK(self._mount.attributes(self, inode)):
                self._mount.ask(self, wire.READLINK, inode.number)
            return True
        except OSError as e:
            print(f"ls: {e.strerror}", file=self.error)
            return False

    def _echo(self, word, _, path):
        done = self._try(path, self._mount.write, f"{word}\n".encode())
        return 0 if done is not None else 1
