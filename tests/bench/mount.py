"""What a mounted tree costs: `python3 tests/bench/mount.py [READS [COMPONENTS]]` prints a line for each
figure.

CPU is that of all processes together except the mock components: the shell, ls, the server, the commands.
"""
import os
import resource
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [ROOT, os.path.join(ROOT, "tests", "support")]
import mounts  # noqa: E402: the path first
import worlds  # noqa: E402

LOOP = "i=0; while [ $i -lt %d ]; do read -r state <%s; i=$((i + 1)); done"


class Mounted:
    """A mount, and the CPU of its server."""

    def __init__(self, directory, environment):
        self.directory = directory
        begun = time.monotonic()
        subprocess.run([os.path.join(worlds.COMMANDS, "rtmount"), directory], check=True, env=environment)
        self.started = time.monotonic() - begun
        os.listdir(directory)
        self.first = time.monotonic() - begun
        with open("/proc/self/mountinfo") as file:
            assert directory in file.read()
        self.pid = next(int(pid) for pid in os.listdir("/proc") if pid.isdigit() and self.is_server(pid))

    def is_server(self, pid):
        try:
            with open("/proc/%s/cmdline" % pid, "rb") as file:
                return os.fsencode(self.directory) in file.read().split(b"\0")
        except OSError:
            return False

    def cpu(self):
        with open("/proc/%d/stat" % self.pid) as file:
            fields = file.read().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def resident(self):
        with open("/proc/%d/statm" % self.pid) as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def spent(words, environment, mounted=None):
    """(CPU of a command and its children, of the server; seconds)"""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begun = time.monotonic()
    served = mounted.cpu() if mounted else 0
    subprocess.run(words, env=environment, stdout=subprocess.DEVNULL, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    own = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return own, mounted.cpu() - served if mounted else 0, time.monotonic() - begun


def main(reads=1000, components=200):
    if mounts.refused():
        return print("mount: " + mounts.refused())
    worlds.start_name_server()
    world = worlds.World("many", str(components))
    place = "localhost:%d" % worlds.Server.port
    known = {name: value for name, value in worlds.ENVIRONMENT.items() if name != "PYTHONDONTWRITEBYTECODE"}
    environment = dict(
        known,
        RTCTREE_NAMESERVERS=place,
        RTCSH_CWD="/%s/test.host_cxt" % place,
        PATH=os.pathsep.join([worlds.COMMANDS, os.path.dirname(sys.executable), os.environ["PATH"]]),
    )
    directory = tempfile.mkdtemp()
    try:
        mounted = Mounted(directory, environment)
        report(
            world, mounted, os.path.join(directory, place, "test.host_cxt"), environment, reads, components
        )
    finally:
        mounts.take_away(os.path.dirname(directory))
        os.rmdir(directory)
        world.close()
        worlds.Server.stop()


def report(world, mounted, context, environment, reads, components):
    print(
        "rtmount: returned after %.3f s, first ls after %.3f s, %.1f MiB"
        % (mounted.started, mounted.first, mounted.resident())
    )
    world.ctl("reset")
    shell, server, seconds = spent(
        ["sh", "-c", LOOP % (reads, context + "/Mock7.rtc/state")], environment, mounted
    )
    calls = sum(int(line.split()[0]) for line in world.ctl("calls").splitlines())
    each = (shell + server) / reads
    print("%d reads of a state: %.2f ms of CPU each (shell %.2f, server %.2f), %.2f s, %.3f calls each" % (
        reads, each * 1000, shell / reads * 1000, server / reads * 1000, seconds, calls / reads))
    few = max(1, reads // 20)
    one, _, _ = spent(["sh", "-c", "for i in $(seq %d); do rtcat Mock7.rtc; done" % few], environment)
    print("rtcat: %.2f ms of CPU each; the mount's read: 1/%.0f" % (one / few * 1000, one / few / each))
    one, _, _ = spent(["sh", "-c", "yes 'cat Mock7.rtc' | head -n %d | rtsh" % reads], environment)
    print(
        "cat in rtsh: %.2f ms of CPU each; the mount's read: 1/%.1f"
        % (one / reads * 1000, one / reads / each)
    )
    world.ctl("reset")
    shell, server, seconds = spent(["ls", "-lR", context], environment, mounted)
    calls = sum(int(line.split()[0]) for line in world.ctl("calls").splitlines())
    own, _, _ = spent(["rtls", "-lR", "."], environment)
    print("ls -lR of %d components: %.2f s of CPU (ls %.2f, server %.2f), %.2f s, %d calls" % (
        components, shell + server, shell, server, seconds, calls))
    print("rtls -lR: %.2f s of CPU" % own)
    for _ in range(5):
        spent(["ls", "-lR", context], environment, mounted)
    print("the server after six of them: %.1f MiB" % mounted.resident())


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
