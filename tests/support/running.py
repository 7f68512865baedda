"""Running commands and measuring them: seconds, memory, output; and the surroundings to run them in."""
import collections
import concurrent.futures
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import zlib

import processes
import tools
import worlds

TIMEOUT = 0.8           # --timeout of the commands
SLACK = 0.5             # seconds more than that may pass; waiting for a processor is not counted
RESIDENT = 64 * 1024    # kB
LIMIT = 90.0  # seconds after which a command is killed
# commands run in other directories than ours
MODULES = os.path.abspath(os.environ.get("PYTHONPATH") or processes.ROOT)
THOROUGH = bool(os.environ.get("RTSHELL_FAULTS"))  # all cases instead of a sample
PARALLEL = 6


class Ran(collections.namedtuple("Ran", "words status out err seconds waited resident said")):
    """What a command did: its words, status (128 + N for a signal N), out and err (bytes), seconds, kB
    resident at most, and how many octets it said, of which out and err may be a part.

    `seconds` do not count what its main thread stood waiting for a processor, as this machine has other
    things to do.
    """

    def __str__(self):
        return "%s: status %d, %.2f s (%.2f s for a processor), %d kB\n%s%s" % (
            " ".join(self.words), self.status, self.seconds, self.waited, self.resident,
            self.out[-2000:].decode("utf-8", "replace"), self.err[-2000:].decode("utf-8", "replace"))


def environment(**more):
    """Of a command."""
    found = dict(os.environ, PYTHONPATH=MODULES, LC_ALL="C", TERM="xterm",
                 PYTHONDONTWRITEBYTECODE="1")
    found.update(more)
    return found


def start(words, where, more, inside=(), **streams):
    """Start a command that hears Ctrl-C: a runner in the background ignores it, and that is inherited.

    `inside` are words to put before it, such as those that enter a network namespace.
    """
    command = list(inside) + [sys.executable, os.path.join(worlds.COMMANDS, words[0])] + words[1:]
    return subprocess.Popen(command, env=environment(**more), cwd=where,
                            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL), **streams)


def run(words, where, inside=(), most=sys.maxsize, **more):
    """Run a command in the directory `where`, with more in its environment, and wait for it; `inside`: see
    `start`.

    Of more than `most` octets of out, or of err, the first and the last are kept: what this process holds
    while others run counts as memory of those that it starts.
    """
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        begun = time.monotonic()
        process = start(words, where, more, inside, stdin=subprocess.DEVNULL, stdout=out, stderr=err)
        killer = threading.Timer(LIMIT, process.kill)
        killer.start()
        # it stays as a zombie whose figures can be read
        os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
        seconds = time.monotonic() - begun
        killer.cancel()
        waited = tools.waited_for_processor(process.pid)
        status, usage = os.wait4(process.pid, 0)[1:]
        process.returncode = tools.shell_status(status)
        said = os.fstat(out.fileno()).st_size + os.fstat(err.fileno()).st_size
        return Ran(words, process.returncode, kept(out, most), kept(err, most), seconds - waited, waited,
                   usage.ru_maxrss, said)


def kept(file, most):
    """The octets of a file; of more than `most`, the first and the last of them."""
    size = file.seek(0, os.SEEK_END)
    file.seek(0)
    if size <= most:
        return file.read()
    first = file.read(most // 2)
    file.seek(size - most // 2)
    return first + b"\n...\n" + file.read()


def together(function, cases, parallel=PARALLEL):
    """[function(case)] for all cases, several at a time."""
    with concurrent.futures.ThreadPoolExecutor(parallel) as pool:
        return list(pool.map(function, cases))


def sample(cases, count, seed=1):
    """Some of the cases, the same ones even when others come or go; all of them when RTSHELL_FAULTS is set.

    Another RTSHELL_SEED, which is tests/run --seed, chooses others.
    """
    cases = list(cases)
    seed = "%s%d" % (os.environ.get("RTSHELL_SEED", "1"), seed)
    if THOROUGH or len(cases) <= count:
        return cases
    ranks = [zlib.crc32(("%s %s" % (seed, case)).encode()) for case in cases]
    limit = sorted(ranks)[count - 1]
    return [case for case, rank in zip(cases, ranks) if rank <= limit]


class Surroundings:
    """A directory, and in it the name servers, worlds and faulty peers that are started; all end with
    close().
    """

    def __init__(self):
        self.top = processes.open_session()

    def name_server(self, name="names", **more):
        """Start a name server; returns its address. For more see processes.start_name_server."""
        return "/127.0.0.1:" + processes.start_name_server(name, **more)

    def world(self, server, *words):
        """Start a world on a name server; its name, for `ctl`."""
        name = processes.start_world(list(words), server.rpartition(":")[2])
        processes.ready(name)
        return name

    def ctl(self, name, *words):
        """Ask a world; its answer in lines."""
        return processes.ctl(name, *words).splitlines()

    def faulty(self, *modes):
        """Start faulty peers; their ports by name."""
        return json.loads(processes.ready(processes.start_faulty(list(modes))))

    def files(self, server):
        """What a profile and a log look like: the text of one that connects ConsoleIn0 to ConsoleOut0 of the
        world `linked` at `server`, and the path of a log with one value of it.
        """
        text = self.done(["rtcryo", "-y", server])
        log = os.path.join(self.top, "recorded.rtlog")
        recorder = start(
            ["rtlog", "-f", log, "-i", "-e", "1", server + "/test.host_cxt/ConsoleIn0.rtc:out"], self.top, {}
        )
        while recorder.poll() is None:
            self.ctl("linked", "write", "ConsoleIn0:out", "42")
            time.sleep(0.02)
        assert recorder.returncode == 0, "rtlog: status %d" % recorder.returncode
        return text, log

    def done(self, words):
        """The output of a command, which has to succeed."""
        ran = run(words, self.top)
        assert ran.status == 0, ran
        return ran.out.decode()

    def profile(self, text, name, server, a, b):
        """Write such a profile for other components, given by their paths; returns the file."""
        home = server[1:] + "/test.host_cxt/"
        path = os.path.join(self.top, name)
        with open(path, "w") as file:
            file.write(text.replace(home + "ConsoleIn0.rtc", a[1:]).replace(home + "ConsoleOut0.rtc", b[1:]))
        return path

    def directory(self, name):
        """An empty directory for a command to run in."""
        path = os.path.join(self.top, name)
        os.makedirs(path, exist_ok=True)
        return path

    def close(self):
        processes.close_session(self.top)
