"""How much rtlog records without loss, beside a bare omniORBpy servant; its CPU at 100 Hz; its memory after
many messages.

    python3 tests/bench/rtlog.py [rate | block | cpu | memory | robot | triggers | kills] [MESSAGES | SECONDS | FAILURES | KILLS]     TMPDIR says which disk

TimedLong: a mock component sends as fast as its port takes values (flush: each put is waited for), to rtlog
and to the bare servant. Octets, 1 MB each: also to the bare servant; to rtlog at lower and lower rates, until
nothing is dropped. A robot of 60 ports at 100 Hz and 4 of images of 1 MB at 10 Hz, recorded whole with
--events, beside a bare servant that writes the same: CPU of both, by turns; values lost; memory. Triggers:
five recorders keep 10 s before and 5 s after failures at random moments (50). All that their rings have ever
held is read again, and each file has to have exactly what came in its 15 s. Kills: rtlog is ended by kill -9
at random moments (100): each file is read and mended, and what it lacks at its end is measured.
"""  # noqa: E501

import collections
import glob
import os
import random
import resource
import subprocess
import sys
import tempfile
import threading
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [ROOT, os.path.join(ROOT, "tests", "support")]
import worlds  # noqa: E402
from rtshell_lite.datalog import logfile, mend  # noqa: E402

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
file = open(sys.argv[4], "wb", 1 << 20) if len(sys.argv) > 4 else None
ior = orb.object_to_string(sink._this())
connected = []
for pair in sys.argv[1].split(","):
    reference, _, type_id = pair.partition(" ")
    port = orb.string_to_object(reference)
    code, profile = port.connect(worlds.connector([port], corba_cdr__inport_ior=ior, data_type=type_id or sys.argv[2]))
    connected.append((port, profile.connector_id))
used = time.process_time()
count = sink.count
time.sleep(float(sys.argv[3]))
used = time.process_time() - used
count, octets, seconds = sink.count, sink.octets, sink.ended - sink.begun
for port, connector_id in connected:
    port.disconnect(connector_id)
print(count / seconds, octets / seconds, used / float(sys.argv[3]))
os._exit(0)
""" % (ROOT, os.path.join(ROOT, "tests", "support"))  # noqa: E501


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
    process = subprocess.Popen(
        rtlog(file, ["-i", "-e", str(messages), path("number")] + FLUSH), env=environment()
    )
    sizes = []
    while process.poll() is None:
        with open("/proc/%d/status" % process.pid) as status:
            sizes += [int(line.split()[1]) / 1024 for line in status if line.startswith("VmRSS")]
        time.sleep(0.5)
    world.close()
    tenth = max(len(sizes) // 10, 1)
    print("%d messages: %.1f MiB after a tenth, %.1f MiB at the end, %.1f MiB at most" % (
        messages, sizes[tenth], sizes[-1], max(sizes)))


def robot(directory, seconds):
    """Record a whole robot for so long, and a fifth of that with the bare servant before and after."""
    small = worlds.World("sources", "30", "100", "8", "--context", "small.host_cxt/%n.rtc")
    images = worlds.World("sources", "4", "10", "1000000", "--context", "images.host_cxt/%n.rtc")
    pairs = []
    for context, count in (("small", 30), ("images", 4)):
        for number in range(count):
            steps = [
                worlds.CosNaming.NameComponent(context, "host_cxt"),
                worlds.CosNaming.NameComponent("Source%d" % number, "rtc"),
            ]
            for port in (
                worlds.Server.root.resolve(steps)._narrow(worlds.OpenRTM.DataFlowComponent).get_ports()
            ):
                type_id = worlds.LONG
                if port.get_port_profile().name.endswith("block"):
                    type_id = "IDL:RTC/TimedOctetSeq:1.0"
                pairs.append(worlds.Server.orb.object_to_string(port) + " " + type_id)
    for turn in ("before", "recorded", "after"):
        if turn == "recorded":
            whole(os.path.join(directory, "robot.mcap"), seconds)
            continue
        said = subprocess.run(
            [
                sys.executable,
                "-c",
                BARE,
                ",".join(pairs),
                "",
                str(seconds / 5),
                os.path.join(directory, "bare"),
            ],
            check=True,
            stdout=subprocess.PIPE,
            env=worlds.ENVIRONMENT,
        ).stdout.split()
        os.remove(os.path.join(directory, "bare"))
        count, octets, used = map(float, said)
        print(
            "bare, %s: %.0f/s, %.1f MB/s, %.1f %% of a CPU" % (turn, count, octets / 1e6, used * 100),
            flush=True,
        )
    small.close()
    images.close()


def whole(file, seconds):
    words = ["--events", "-t", str(seconds), "/127.0.0.1:%d" % worlds.Server.port]
    process = subprocess.Popen(rtlog(file, words), env=environment())
    peak = used = 0.0
    while process.poll() is None:
        with open("/proc/%d/status" % process.pid) as status, open("/proc/%d/stat" % process.pid) as stat:
            peak = max([peak] + [int(line.split()[1]) / 1024 for line in status if line.startswith("VmHWM")])
            used = max(
                used, sum(map(int, stat.read().rpartition(")")[2].split()[11:13])) / os.sysconf("SC_CLK_TCK")
            )
        time.sleep(0.2)
    last = {}
    lost = 0
    octets = 0
    with logfile.load(file) as log:
        names = [channel.name for channel in log.channels]
        for entry in log.entries():
            if not names[entry.channel].startswith("/events") and entry.data is not None:
                at = 8 + 4 * names[entry.channel].endswith("block")
                number = int.from_bytes(entry.data[at:at + 4], "little")
                lost += number - last.get(entry.channel, number - 1) - 1
                last[entry.channel] = number
                octets += len(entry.data)
        print(
            "rtlog, %d s: status %s, %d channels, %.0f/s, %.1f MB/s, %.1f %% of a CPU, %d lost, %d "
            "damaged, peak %.1f MiB"
            % (
                seconds,
                process.returncode,
                len(last),
                log.count / seconds,
                octets / 1e6 / seconds,
                used / seconds * 100,
                lost,
                log.damaged,
                peak,
            )
        )


class Flight:
    """A component that fails, two that send, and an rtlog that keeps a ring of them. The parts of the ring
    get other names, too, under which they stay.
    """

    def __init__(self, directory, number):
        self.random = random.Random(number)
        self.name = os.path.join(directory, "flight%d" % number)
        os.mkdir(self.name)
        top = "/127.0.0.1:%d/f%d.host_cxt" % (worlds.Server.port, number)
        self.component = top + "/ConsoleIn0.rtc"
        context = "f%d.host_cxt/%%n.rtc" % number
        self.worlds = [
            worlds.World("observed", "--context", context),
            worlds.World("sources", "2", "100", "8", "--context", context),
        ]
        words = ["--ring", "10", "--after", "5", "--trigger", "error", top]
        self.process = subprocess.Popen(rtlog(self.name + ".mcap", words), env=environment())
        self.failures = []

    def command(self, name):
        subprocess.run(
            [sys.executable, os.path.join(ROOT, "bin", name), "-q", self.component],
            check=True,
            env=environment(),
        )

    def fly(self, failures):
        threading.Thread(target=self.link).start()
        time.sleep(15)
        for _ in range(failures):
            time.sleep(self.random.uniform(6.5, 12))
            self.command("rtact")
            self.worlds[0].ctl("error", "ConsoleIn0")
            self.failures.append(time.time())
            time.sleep(1)
            self.command("rtreset")
        time.sleep(9)
        self.process.terminate()

    def link(self):
        while self.process.poll() is None:
            for part in glob.glob(self.name + "-0*.mcap"):
                other = os.path.join(self.name, os.path.basename(part))
                if not os.path.exists(other):
                    os.link(part, other)
            time.sleep(0.2)

    @staticmethod
    def values(name, first, last):
        """How often each value (channel, arrival, octets) of a time is in a log."""
        with logfile.load(name) as log:
            names = [channel.name for channel in log.channels]
            return collections.Counter(
                (names[entry.channel], entry.received, entry.data)
                for entry in log.entries()
                if entry.data is not None and first <= entry.received <= last
            )

    def judge(self):
        """(files, complete ones, seconds from a failure until it was known)"""
        self.process.wait()
        good = 0
        late = []
        files = sorted(glob.glob(self.name + "-2*.mcap"))
        for file, failed in zip(files, self.failures):
            with logfile.load(file) as log:
                first = log.started
                is_closed = log.closed
            last = first + 15 * 10 ** 9
            late.append(first / 1e9 + 10 - failed)
            wanted = collections.Counter()
            for part in glob.glob(os.path.join(self.name, "*")):
                wanted.update(self.values(part, first, last))
            found = self.values(file, 0, 1 << 63)
            is_whole = is_closed and found and found == wanted
            good += is_whole
            if not is_whole:
                print(
                    "%s: %d of %d values, %d others"
                    % (
                        file,
                        sum((found & wanted).values()),
                        sum(wanted.values()),
                        sum((found - wanted).values()),
                    ),
                    flush=True,
                )
        return len(files), good, late


def triggers(directory, failures):
    flights = [Flight(directory, number) for number in range(5)]
    threads = [threading.Thread(target=flight.fly, args=(failures // 5,)) for flight in flights]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    judged = [flight.judge() for flight in flights]
    for flight in flights:
        for world in flight.worlds:
            world.close()
    late = [each for _, _, found in judged for each in found]
    print(
        "%d failures, %d files, %d complete; known after %.2f s, at most %.2f s"
        % (
            sum(len(flight.failures) for flight in flights),
            sum(files for files, _, _ in judged),
            sum(good for _, good, _ in judged),
            sum(late) / len(late),
            max(late),
        )
    )


def kills(directory, count):
    world = worlds.World("sources", "10", "100", "8")
    top = "/127.0.0.1:%d" % worlds.Server.port
    chance = random.Random(1)
    lost = []
    for number in range(count):
        file = os.path.join(directory, "killed%d.mcap" % number)
        process = subprocess.Popen(rtlog(file, ["--events", top]), env=environment())
        while not (os.path.exists(file) and os.path.getsize(file) > 20000):
            time.sleep(0.01)
        time.sleep(chance.random())
        killed = time.time()
        process.kill()
        process.wait()
        with logfile.load(file) as log:
            if log.closed or log.damaged or len(list(log.entries())) != log.count:
                print("%s: not as a killed recorder leaves it" % file, flush=True)
            lost.append(killed - log.last / 1e9)
        mend.mend(file, file + "-mended")
        os.remove(file)
        os.remove(file + "-mended")
    world.close()
    print("%d kills, all read and mended; lost: %.3f s at a median, at most %.3f s" % (
        count, sorted(lost)[count // 2], max(lost)))


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
            if what == "robot":
                robot(directory, float(sys.argv[2]) if len(sys.argv) > 2 else 300.0)
            if what == "triggers":
                triggers(directory, int(sys.argv[2]) if len(sys.argv) > 2 else 50)
            if what == "kills":
                kills(directory, int(sys.argv[2]) if len(sys.argv) > 2 else 100)
            if what in ("memory", "all"):
                memory(file, int(sys.argv[2]) if len(sys.argv) > 2 else 1000000)
    finally:
        worlds.Server.stop()


if __name__ == "__main__":
    main()
