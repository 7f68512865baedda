"""How much rtlog records without loss, beside a bare omniORBpy servant; its CPU at 100 Hz; its memory after many messages.

    python3 tests/bench/rtlog.py [rate | block | cpu | memory] [MESSAGES]     TMPDIR says which disk

TimedLong: a mock component sends as fast as its port takes values (flush: each put is waited for), to rtlog and to the bare
servant. Octets, 1 MB each: also to the bare servant; to rtlog at lower and lower rates, until nothing is dropped.
"""
import os
import resource
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [ROOT, os.path.join(ROOT, "tests", "support")]
import worlds  # noqa: E402
from rtshell_lite.datalog import logfile  # noqa: E402

SECONDS, ROUNDS = 3, 3
FLUSH = ["--property", "dataport.subscription_type=flush"]
BARE = """
import os, sys, threading, time
sys.path[:0] = [%r, %r]
import worlds
from worlds import CORBA, OpenRTM
from rtshell_lite.corba import stubs
class Sink(stubs.skeleton("OpenRTM.InPortCdr")):
    count = octets = 0
    def put(self, data):
        if not self.count:
            self.begun = time.perf_counter()
        self.count += 1
        self.octets += len(data)
        if len(sys.argv) > 4:
            file.write(data)
        self.ended = time.perf_counter()
        return OpenRTM.PORT_OK
orb = CORBA.ORB_init(["bare", "-ORBgiopMaxMsgSize", "104857600"], CORBA.ORB_ID)
poa = orb.resolve_initial_references("RootPOA")
poa._get_the_POAManager().activate()
sink = Sink()
file = open(sys.argv[4], "wb", 0) if len(sys.argv) > 4 else None
ior = orb.object_to_string(sink._this())
port = orb.string_to_object(sys.argv[1])
code, profile = port.connect(worlds.connector([port], corba_cdr__inport_ior=ior, data_type=sys.argv[2]))
time.sleep(float(sys.argv[3]))
count, octets, seconds = sink.count, sink.octets, sink.ended - sink.begun
port.disconnect(profile.connector_id)
print(count / seconds, octets / seconds)
os._exit(0)
""" % (ROOT, os.path.join(ROOT, "tests", "support"))


def bare(world, port, type_id, *file):
    """Messages and octets a second of a bare servant, or of one that writes the data to a file."""
    ior = worlds.Server.orb.object_to_string(world.port("Source0", port))
    said = subprocess.run([sys.executable, "-c", BARE, ior, type_id, str(SECONDS)] + list(file), check=True,
                          stdout=subprocess.PIPE, env=worlds.ENVIRONMENT).stdout.split()
    return float(said[0]), float(said[1])


def rtlog(file, words):
    """The command that records from Source0."""
    return [sys.executable, os.path.join(ROOT, "bin", "rtlog"), "-q", "-f", file] + words


def environment():
    return dict(worlds.ENVIRONMENT, RTCTREE_NAMESERVERS="127.0.0.1:%d" % worlds.Server.port)


def path(port):
    return "/127.0.0.1:%d/test.host_cxt/Source0.rtc:%s" % (worlds.Server.port, port)


def recorded(file, port):
    """The same for rtlog; None when anything was lost."""
    if subprocess.run(rtlog(file, ["-t", str(SECONDS), path(port)] + FLUSH), env=environment()).returncode:
        return None
    with logfile.load(file) as log:
        octets = sum(len(entry.data) for entry in log.entries())
        return log.count * 1e9 / (log.last - log.first), octets * 1e9 / (log.last - log.first)


def tell(port, other, own):
    print("%s: %.0f/s %.1f MB/s, %.0f/s %.1f MB/s, ratio %.2f" % (
        port, other[0], other[1] / 1e6, own[0], own[1] / 1e6, own[0] / other[0]), flush=True)


def rate(file):
    world = worlds.World("senders", "1000000", "8")
    for _ in range(ROUNDS):
        tell("number, bare and rtlog", bare(world, "number", worlds.LONG), recorded(file, "number"))
    world.close()


def block(file):
    world = worlds.World("senders", "1000000", "1000000")
    other = bare(world, "block", "IDL:RTC/TimedOctetSeq:1.0")
    writing = bare(world, "block", "IDL:RTC/TimedOctetSeq:1.0", file)
    world.close()
    tell("block, bare and written", other, writing)
    for wanted in (800, 600, 500, 400, 300, 200, 150, 100, 50):
        world = worlds.World("senders", str(wanted), "1000000")
        own = recorded(file, "block")
        world.close()
        if own:
            return tell("block, bare and written beside rtlog", writing, own)


def cpu(file):
    """CPU of 11 s less that of 1 s, at 100 Hz."""
    world = worlds.World("senders", "100", "8")
    used = []
    for seconds in (1, 11):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(rtlog(file, ["-t", str(seconds), path("number")]), check=True, env=environment())
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        used.append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    world.close()
    print("100 Hz: %.1f %% of a CPU (start and end: %.2f s)" % ((used[1] - used[0]) * 10, used[0]))


def memory(file, messages):
    world = worlds.World("senders", "1000000", "8")
    process = subprocess.Popen(rtlog(file, ["-i", "-e", str(messages), path("number")] + FLUSH), env=environment())
    sizes = []
    while process.poll() is None:
        with open("/proc/%d/status" % process.pid) as status:
            sizes += [int(line.split()[1]) / 1024 for line in status if line.startswith("VmRSS")]
        time.sleep(0.5)
    world.close()
    tenth = max(len(sizes) // 10, 1)
    print("%d messages: %.1f MiB after a tenth, %.1f MiB at the end, %.1f MiB at most" % (
        messages, sizes[tenth], sizes[-1], max(sizes)))


def main():
    what = sys.argv[1] if len(sys.argv) > 1 else "all"
    worlds.start_name_server()
    try:
        with tempfile.TemporaryDirectory() as directory:
            file = os.path.join(directory, "log")
            if what in ("rate", "all"):
                rate(file)
            if what in ("block", "all"):
                block(file)
            if what in ("cpu", "all"):
                cpu(file)
            if what in ("memory", "all"):
                memory(file, int(sys.argv[2]) if len(sys.argv) > 2 else 1000000)
    finally:
        worlds.Server.stop()


if __name__ == "__main__":
    main()
