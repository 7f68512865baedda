"""The commands that exist only inside a session: `tools.py NAME WORD…` runs the function play_NAME.

They are called a thousand times in a run of the tests, so they import little and start with `python -I -S`,
which saves half of their time. None has the name of an applet of BusyBox: Debian's busybox-static plays those
rather than what is in PATH.
"""
import os
import signal
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
START_LIMIT = 90.0  # seconds until a peer must be in the state that was asked for
# seconds that a command may take to tidy up after Ctrl-C, on a busy machine; the timeout is 3
UNWINDING = 2.0
THREADS = 17  # of the fields of /proc/PID/stat behind the name: how many threads there are


class Failed(Exception):
    pass


# ---- peers ----

def play_mock(words):
    """mock WORLD [ARGUMENT...]: start one more world; the others know it by its first word (two, two2 …)."""
    import processes
    processes.ready(processes.start_world(words, os.environ["PORT"]))


def play_start_again(words):
    """start-again SERVER: start a name server that was killed, at its old port, with its old names."""
    import processes
    processes.start_again(words[0])


def play_ctl(words):
    """ctl [@WORLD] WORD...: talk to a world's control socket, by default the first one's."""
    sys.path.append(os.path.dirname(os.path.dirname(HERE)))
    from mock_components import asking
    where = os.environ.get("MOCK_CONTROL", "")
    if words and words[0].startswith("@"):
        where = control(words[0][1:])
        words = words[1:]
    return asking.ask(where, words)


def play_calls(words):
    """calls [@WORLD] ...: the calls that a world's components received."""
    world = words[:1] if words and words[0].startswith("@") else []
    return play_ctl(world + ["calls"] + words[len(world):])


def play_fluent(words):
    """fluent PORT MODE (LEVEL NAME MESSAGE)...: send records as OpenRTM 2 does through Fluent Bit."""
    import fluent
    records = [fluent.record(*words[at:at + 3]) for at in range(2, len(words), 3)]
    fluent.send(int(words[0]), fluent.message(words[1], [[1795247382.25, each] for each in records]))


# commands that send a signal to worlds, NAME…, and wait until each is in a state
SIGNALS = {
    "kill-mock": (signal.SIGKILL, "gone"),  # its names stay bound
    "end-mock": (signal.SIGTERM, "gone"),
    "hang": (signal.SIGSTOP, "stopped"),  # it accepts connections and never answers
    "wake": (signal.SIGCONT, "running"),
}


def send_signal(names, number, state):
    for name in names:
        try:
            with open(session_file(name + ".pid")) as file:
                process = int(file.read())
        except OSError:
            raise Failed("no world named %s" % name)
        os.kill(process, number)
        if not reaches(process, state, START_LIMIT):
            raise Failed("%s is still %s" % (name, state_of(process)))


def reaches(process, state, seconds):
    """Wait until a process is in a state; returns whether it is within that time."""
    deadline = time.monotonic() + seconds
    while state_of(process) != state:
        if time.monotonic() > deadline:
            return False
        time.sleep(0.005)
    return True


def state_of(process):
    try:
        with open("/proc/%d/stat" % process) as file:
            fields = file.read().rpartition(") ")[2].split()
    except OSError:
        return "gone"
    if fields[0] in "ZX" and int(fields[THREADS]) > 1:  # they still have its files, and listen
        return "running"
    return {"Z": "gone", "X": "gone", "T": "stopped"}.get(fields[0], "running")


def session_file(name):
    return os.path.join(os.environ["SESSION"], name)


def control(name):
    return session_file(name + ".control")


# ---- running a command ----

USUAL = 4.0  # load per processor while tests run alone


def slower():
    """How many times longer something may take, as much other work is done beside the tests."""
    return max(1.0, os.getloadavg()[0] / (USUAL * os.cpu_count()))


def play_within(words):
    """within LEAST-MOST COMMAND...: complain if the command takes less or more seconds; status is the
    command's.

    What it was ready to run and was not let, as other tests had the processors, does not count as MOST, nor
    that this process was not let see its end; its peers wait for them, too, so that MOST grows with the load
    where other work is done beside the tests.
    """
    least, most = [float(number) for number in words[0].split("-")]
    before = waited_for_processor("self")
    begun = time.monotonic()
    process = spawn(words[1:])
    os.waitid(os.P_PID, process, os.WEXITED | os.WNOWAIT)
    taken = time.monotonic() - begun
    waited = waited_for_processor(process) + waited_for_processor("self") - before
    status = shell_status(os.waitpid(process, 0)[1])
    if taken < least or taken - waited > most * slower():
        sys.stdout.write("took %.2f s (%.2f s of it for a processor), not %s\n" % (taken, waited, words[0]))
        return status or 99
    return status


def play_interrupt(words):
    """interrupt SECONDS[:SIGNAL] COMMAND...: press Ctrl-C after that long, or send SIGNAL; the command must
    be gone soon, long before the timeout. interrupt CONDITION COMMAND...: press it as soon as that command
    line succeeds.

    What it was ready to run and was not let does not count: Python would be interrupted while it starts; nor
    does it count for what the command may take to end.
    """
    begun = time.monotonic()
    process = spawn(words[1:])
    seconds, _, name = words[0].partition(":")
    is_time = seconds.replace(".", "").isdigit()
    while state_of(process) != "gone":
        if is_time:
            is_due = time.monotonic() - begun - waited_for_processor(process) >= float(seconds)
        else:
            is_due = os.waitpid(spawn(["sh", "-c", "{ %s; } >/dev/null 2>&1" % words[0]]), 0)[1] == 0
            if not is_due and time.monotonic() - begun > START_LIMIT:
                sys.stdout.write("never: %s\n" % words[0])
                is_due = True
        if is_due:
            os.kill(process, signal.Signals["SIG" + (name if is_time and name else "INT")])
            if not unwinds(process, UNWINDING * slower()):
                sys.stdout.write("still there %g s after it\n" % UNWINDING)
                os.kill(process, signal.SIGKILL)
            break
        time.sleep(0.01)
    else:
        sys.stdout.write("ended before it\n")
    return shell_status(os.waitpid(process, 0)[1])


def unwinds(process, seconds):
    """Wait until a process is gone, or has been let run for that long without; returns whether it is gone."""
    begun = time.monotonic()
    before = waited_for_processor(process)
    while not reaches(process, "gone", 0.1):
        if time.monotonic() - begun - (waited_for_processor(process) - before) > seconds:
            return reaches(process, "gone", 0)
    return True


def play_terminal(words):
    """terminal COLUMNS COMMAND...: run the command on a terminal that wide, type what comes through a pipe,
    show what is written there.
    """
    import fcntl
    import pty
    import stat
    import struct
    import termios
    child, terminal = pty.fork()
    if child == 0:
        try:  # the size is set from this side, before the command can ask for it
            fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", 24, int(words[0]), 0, 0))
            hear_ctrl_c()
            os.execvp(words[1], words[1:])
        finally:
            os._exit(127)
    if stat.S_ISFIFO(os.fstat(0).st_mode):
        os.write(terminal, sys.stdin.buffer.read())
    for data in printed_on(terminal):
        try:
            os.write(1, data.replace(b"\r\n", b"\n"))
        except BrokenPipeError:  # head has seen enough
            pass
    return shell_status(os.waitpid(child, 0)[1])


def spawn(words):
    """Start a command as a shell would; returns its process number. (subprocess takes longer to import than a
    command to run.)
    """
    hear_ctrl_c()  # before there is a child that could miss it
    process = os.fork()
    if process:
        return process
    try:
        for number in signal.SIGPIPE, signal.SIGXFSZ:  # Python ignores them
            signal.signal(number, signal.SIG_DFL)
        os.execvp(words[0], words)
    finally:
        os._exit(127)


def hear_ctrl_c():
    # a runner in the background ignores it, and that is inherited
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def shell_status(status):
    """What a shell says of the status that waitpid() gives."""
    return os.WEXITSTATUS(status) if os.WIFEXITED(status) else 128 + os.WTERMSIG(status)


def printed_on(terminal):
    """What programs print on a terminal, as bytes come, until all of them have ended."""
    while True:
        try:
            data = os.read(terminal, 65536)
        except OSError:  # how Linux says that the other side is closed
            return
        if not data:
            return
        yield data


def waited_for_processor(process):
    """Seconds that the main thread of a process, or a thread (thread-self, PID/task/TID), has waited for a
    processor; 0 where the kernel does not say.
    """
    try:
        with open("/proc/%s/schedstat" % process) as file:
            return int(file.read().split()[1]) / 1e9
    except (OSError, ValueError, IndexError):
        return 0.0


class Stopwatch:
    """Measures how long something takes, without the time for which it waits for a processor.

    `processes` are the numbers of the processes that do it, by default this one, whose threads all count:
    what they wait at the same time is subtracted for each.
    """

    def __init__(self, *processes):
        self.processes = processes
        self.before = self._waits()
        self.begun = time.monotonic()

    def seconds(self):
        """Seconds since it was made, without those waits."""
        taken = time.monotonic() - self.begun
        waits = self._waits()
        return taken - sum(max(0.0, waits[thread] - self.before.get(thread, 0.0)) for thread in waits)

    def _waits(self):
        threads = self.processes or ["self/task/" + number for number in os.listdir("/proc/self/task")]
        return {thread: waited_for_processor(thread) for thread in threads}


NAMES = [name[5:].replace("_", "-") for name in sorted(globals()) if name.startswith("play_")] + list(SIGNALS)


def main():
    sys.path.insert(0, HERE)
    name = sys.argv[1]
    words = sys.argv[2:]
    try:
        if name in SIGNALS:
            return send_signal(words, *SIGNALS[name])
        return globals()["play_" + name.replace("-", "_")](words)
    except Exception as e:  # Failed among them, by two names: `processes` imports this file, too
        sys.stderr.write("%s: %s\n" % (name, e))
        return 99


if __name__ == "__main__":
    sys.exit(main())
