"""A robot of six components in three processes on two hosts, and what goes wrong on the way between them: a
table of faults, each with what is true while it lasts.

Whatever is seen: nothing that lives is called dead, no name of it is deleted, it is not created again, and
the fault is named, or it is said that it cannot be told from here. If one of these fails, somebody deletes
the name of a component that runs, or starts a driver twice. A run takes a third of the faults, chosen by
RTSHELL_SEED, with --long all. Needs `ip netns` and `nft`, and the right to use them.
"""
import collections
import contextlib
import os
import re
import signal
import socket
import subprocess
import sys
import time
import unittest

import hosts
import running
import tools

ONCE = "what a network does is the same for every Python"

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

TIMEOUT = 1.5  # of the commands
PATIENT = 30  # of commands that ask a robot that is well
PARALLEL = 5
NEAR, FAR, OTHER = "10.78.0.2", "10.78.0.3", "10.78.0.4"  # the name server is near
PORTS = {"a": 2991, "b": 2992, "c": 2993}
HOMES = {"a": "near", "b": "far", "c": "near"}  # c is a manager, which can create all of them
PARTS = ("A0", "A1", "B0", "B1", "C0", "C1")
HOME = "/%s/test.host_cxt" % NEAR

# What is true while a fault lasts, seen from the host `seat`: `dead` are the components of which that can be
# known, `doubtful` those of which nothing can, `hung` those whose process hangs; all others live and answer.
# `says` is a pattern of what rtdoctor says, `is_named` whether that is the fault itself, `keeps_names` if the
# name server still has them, `creates` whether what is dead is created again.
Fault = collections.namedtuple(
    "Fault", "name happen seat says is_named dead doubtful hung keeps_names creates"
)
FAULTS = []
A, B, C = PARTS[:2], PARTS[2:4], PARTS[4:]


def named(seat, says, dead=(), doubtful=(), hung=(), keeps_names=True, creates=True):
    """Enter a fault that rtdoctor names."""
    return _enter(seat, says, True, dead, doubtful, hung, keeps_names, creates)


def untold(seat, says, doubtful=(), dead=(), hung=(), keeps_names=True, creates=True):
    """Enter a fault of which rtdoctor says that it cannot be told."""
    return _enter(seat, says, False, dead, doubtful, hung, keeps_names, creates)


def _enter(seat, *truth):
    def enter(happen):
        FAULTS.append(Fault(happen.__name__, contextlib.contextmanager(happen), seat, *truth))
        return happen
    return enter


# ---- firewalls ----

REFUSES = r"/%s0.rtc: .* refuses: dead, or a firewall closes this port"
NO_WAY = r"/%s0.rtc: cannot tell from here whether it lives: publishes .* out of reach"
BEGUN = "tcp flags & (syn | ack) == syn"


@untold("near", REFUSES % "B", doubtful=B)
def one_port_is_reset(robot):
    with robot.rules("far", "input", "tcp dport 2992 %s reject with tcp reset" % BEGUN):
        yield


@untold("far", REFUSES % "A", doubtful=A)
def one_port_is_unreachable(robot):
    with robot.rules("near", "input", "tcp dport 2991 %s reject with icmp type port-unreachable" % BEGUN):
        yield


@untold("near", NO_WAY % "B", doubtful=B)
def one_port_is_dropped(robot):
    with robot.rules("far", "input", "tcp dport 2992 drop"):
        yield


@untold("far", REFUSES % "A", doubtful=A + C)
def all_ports_but_that_of_names_are_reset(robot):
    with robot.rules("near", "input", "tcp dport != 2809 %s reject with tcp reset" % BEGUN):
        yield


@untold("near", NO_WAY % "B", doubtful=B)
def all_is_prohibited(robot):
    with robot.rules("far", "input", "%s reject with icmp type admin-prohibited" % BEGUN):
        yield


@untold("far", r"no TCP connection to %s port 2809 .*firewall" % re.escape(NEAR), doubtful=PARTS)
def names_are_dropped(robot):
    with robot.rules("near", "input", "tcp dport 2809 drop"):
        yield


@untold("near", r"/B0.rtc: cannot tell from here whether it lives: .* is sent is not received", doubtful=B)
def what_is_larger_than_a_handshake_is_dropped(robot):
    with robot.rules("far", "input", "tcp dport 2992 meta length > 80 drop"):
        yield


@untold("near", r"/B0.rtc: cannot tell from here whether it lives", doubtful=B)
def connections_are_reset_at_the_first_question(robot):
    with robot.rules("far", "input", "tcp dport 2992 meta length > 80 reject with tcp reset"):
        yield


# ---- the way ----

@untold("near", NO_WAY % "B", doubtful=B)
def a_host_is_off(robot):
    with robot.pulled("far"):
        yield


@named("near", r"/B0.rtc: answers small questions, but not when asked for", doubtful=B)
def large_packets_are_lost(robot):
    with robot.rules("far", "output", "meta length > 500 drop"):
        yield


@untold("near", r"/B0.rtc: cannot tell from here whether it lives", doubtful=B)
def one_way_is_lost(robot):
    with robot.rules("far", "output", "drop"):
        yield


@untold("near", REFUSES % "B", doubtful=B)
def another_host_has_the_address(robot):
    robot.add_host("third", OTHER)
    with robot.pulled("far"):
        robot.ip("third", "address", "add", FAR + "/24", "dev", "eth0")
        robot.ip("near", "neigh", "flush", "all")
        yield
        robot.ip("third", "address", "del", FAR + "/24", "dev", "eth0")
        robot.ip("near", "neigh", "flush", "all")


@untold("near", NO_WAY % "B", doubtful=B)
def a_host_has_a_new_address(robot):
    robot.ip("far", "address", "add", OTHER + "/24", "dev", "eth0")
    robot.ip("far", "address", "del", FAR + "/24", "dev", "eth0")
    yield
    robot.ip("far", "address", "add", FAR + "/24", "dev", "eth0")


@untold("far", r"/N0.rtc: cannot tell from here whether it lives: publishes 192.168.78.2:2990, of another "
               "network than its name server", doubtful=("N0",))
def an_address_is_translated(robot):
    """As in a container: what it publishes is known on its own host only."""
    robot.ip("near", "link", "add", "inner", "type", "veth", "peer", "name", "outer")
    robot.ip("near", "address", "add", "192.168.78.2/24", "dev", "inner")
    robot.ip("near", "link", "set", "inner", "up")
    robot.world("n", "near", "these", "Mock:N0", listen="", publish="192.168.78.2", port=2990)
    yield


# ---- names of hosts, other transports ----

@named("far", "/N0.rtc: publishes 127.0.0.1:2990, which means this host, not its own", doubtful=("N0",))
def an_address_means_the_host_that_uses_it(robot):
    robot.world("n", "near", "these", "Mock:N0", listen="", publish="127.0.0.1", port=2990)
    yield


@named("near", "/N0.rtc: cannot tell from here .* robot.invalid:2990, a host name that is not known",
       doubtful=("N0",))
def a_host_name_is_unknown(robot):
    robot.world("n", "far", "these", "Mock:N0", publish="robot.invalid", port=2990)
    yield


@untold("near", "/N0.rtc: cannot tell from here whether it lives: desk:2990 .* may mean another host",
        doubtful=("N0",))
def a_host_name_means_this_host_here(robot):
    robot.call_hosts("near", desk=[NEAR])
    robot.world("n", "far", "these", "Mock:N0", publish="desk", port=2990)
    yield


@named("near", "/Tls0.rtc: listens with TLS only(.|\n)*/Unix0.rtc: listens with UNIX sockets only",
       doubtful=("Tls0", "Unix0", "Other0"))
def other_transports_only(robot):
    robot.world("n", "far", "secured", port=2990)
    yield


# ---- processes ----

@untold("near", REFUSES % "B", doubtful=B)
def a_process_elsewhere_is_killed(robot):
    robot.kill("b")
    yield


@named("far", "/B0.rtc: dead .zombie.: nothing listens", dead=B)
def a_process_of_this_host_is_killed(robot):
    robot.kill("b")
    yield


@named("near", "/A0.rtc: dead .zombie.: nothing listens", dead=A)
def a_process_beside_the_name_server_is_killed(robot):
    robot.kill("a")
    yield


@named("near", "/C0.rtc: dead .zombie.: nothing listens", dead=C, creates=False)
def the_manager_is_killed(robot):
    robot.kill("c")
    yield


@named("near", "/B0.rtc: hung: .* accepts TCP", hung=B)
def a_process_hangs(robot):
    with robot.stopped("b"):
        yield


@named("far", "/A0.rtc: hung: .* accepts TCP", hung=A)
def another_process_hangs(robot):
    with robot.stopped("a"):
        yield


@named("near", "what listens at .*2992.* does not speak CORBA", doubtful=B)
def http_has_taken_the_port(robot):
    robot.kill("b")
    robot.start("http", "far", [sys.executable, "-m", "http.server", "--bind", FAR, "2992"])
    robot.wait("far", "exec 3<>/dev/tcp/%s/2992" % FAR)
    yield


@named("near", "/B0.rtc: dead .zombie.: what listens .* now does not have it", dead=B)
def another_component_has_taken_the_port(robot):
    robot.kill("b")
    robot.world("x", "far", "these", "Mock:X0", port=2992)
    yield


@named("near", "/B0.rtc: hung: .* accepts TCP", hung=B)
def something_silent_has_taken_the_port(robot):
    robot.kill("b")
    listen = "import socket, time; s = socket.create_server(('%s', 2992)); time.sleep(600)" % FAR
    robot.start("silent", "far", [sys.executable, "-c", listen])
    robot.wait("far", "exec 3<>/dev/tcp/%s/2992" % FAR)
    yield


@named("far", "/manager.mgr: lists a component that is gone", dead=("C0",))
def a_component_has_ended_in_its_process(robot):
    robot.ctl("c", "forsake", "C0")
    yield


@named("far", "/A0.rtc:out: the far end .*, B0.in at .*, lives, but is bound in no name server")
def a_name_is_taken(robot):
    """B0 lives, and its name leads to another component."""
    robot.world("thief", "near", "these", "Mock:B0", port=2990)
    yield


# ---- name servers ----

SLOW_RELAY = """
import socket, sys, threading, time
def talk(one):
    other = socket.create_connection((sys.argv[1], 2809))
    while True:
        question = one.recv(65536)
        other.sendall(question)
        answer = other.recv(65536)
        time.sleep(float(sys.argv[2]))
        one.sendall(answer)
with socket.create_server((sys.argv[1], 2808)) as server:
    while True:
        threading.Thread(target=talk, args=(server.accept()[0],), daemon=True).start()
"""

EMPTY = "%s: (has none of its|has no names|nothing is bound in it)" % re.escape(NEAR)


@named("near", EMPTY, keeps_names=False)
def names_are_lost(robot):
    robot.restart_names()
    yield


@named("far", EMPTY, keeps_names=False)
def names_elsewhere_are_lost(robot):
    robot.restart_names()
    yield


@named("far", EMPTY, dead=B, keeps_names=False)
def names_are_lost_and_a_process_of_this_host_is_killed(robot):
    robot.kill("b")
    robot.restart_names()
    yield


@untold("near", "/B0.rtc: .*refuses: dead, or a firewall", doubtful=B, keeps_names=False)
def names_are_lost_and_a_process_elsewhere_is_killed(robot):
    robot.kill("b")
    robot.restart_names()
    yield


@untold("near", "/B0.rtc: .* but it may live: .* out of reach", doubtful=B, keeps_names=False)
def names_are_lost_and_a_host_is_off(robot):
    robot.restart_names()
    with robot.pulled("far"):
        yield


@untold("near", "/B0.rtc: .* but it may live: .* out of reach", doubtful=B, keeps_names=False)
def names_are_lost_and_all_is_prohibited(robot):
    robot.restart_names()
    with robot.rules("far", "input", "%s reject with icmp type admin-prohibited" % BEGUN):
        yield


@named("near", "has none of its", keeps_names=False)
def another_name_server_has_the_port(robot):
    robot.restart_names()
    robot.world("x", "far", "these", "Mock:X0", "Mock:X1", port=2990)
    yield


@named("far", r"%s: slow \(" % re.escape(NEAR), doubtful=PARTS)
def names_are_slow(robot):
    """Each answer takes more than a second."""
    robot.start("relay", "near", [sys.executable, "-c", SLOW_RELAY, NEAR, "1.1"])
    robot.wait("near", "exec 3<>/dev/tcp/%s/2808" % NEAR)
    chain = "chain slow { type nat hook prerouting priority -100; tcp dport 2809 redirect to :2808; } ;"
    subprocess.run(robot.inside("near") + ["nft", "table ip slow { %s }" % chain], check=True)
    yield
    subprocess.run(robot.inside("near") + ["nft", "delete table ip slow"], check=True)


@named("near", r"%s: hung: accepts TCP" % re.escape(NEAR), doubtful=PARTS)
def names_hang(robot):
    with robot.stopped("names"):
        yield


@untold("far", r"connection refused: .* nothing listens on port 2809, or a firewall refuses", doubtful=PARTS)
def names_elsewhere_are_not_there(robot):
    robot.kill("names")
    yield
    robot.start_names()


@named("near", r"connection refused: nothing listens on port 2809 here", doubtful=PARTS)
def names_are_not_there(robot):
    robot.kill("names")
    yield
    robot.start_names()


# ---- the robot ----

class Robot:
    """Two hosts, a name server and three processes; one of many, each with hosts of its own."""

    def __init__(self, number):
        self.number = number
        self.hosts = {}
        self.profile = os.path.join(around.top, "robot%d.rtsys" % number)
        try:
            self.build()
        except BaseException:
            self.close()
            raise

    def build(self):
        hosts.build({}, self.label("switch"))
        self.add_host("near", NEAR)
        self.add_host("far", FAR)
        self.start_names()
        for part, where in HOMES.items():
            self.begin(part, where, *self.words(part), port=PORTS[part])
        for part in HOMES:
            running.processes.ready(self.label(part))
        for one, other in (("A0", "B0"), ("B1", "C0"), ("A1", "A0")):
            self.well("near", "rtcon", self.path(one) + ":out", self.path(other) + ":in")
        self.well("near", "rtact", "--wait=%d" % PATIENT, *map(self.path, PARTS))
        self.well("near", "rtcryo", "--all", "-o", self.profile)

    @staticmethod
    def words(part):
        names = [name for name in PARTS if name.startswith(part.upper())]
        if part == "c":
            return ["manager"] + ["Mock?instance_name=" + name for name in names]
        return ["these"] + ["Mock:" + name for name in names]

    @staticmethod
    def path(name):
        return "%s/%s.rtc" % (HOME, name)

    def label(self, name):
        return "%s%d" % (name, self.number)

    def add_host(self, name, address):
        hosts.plug_in(self.label(name), address, self.label("switch"))
        self.hosts[name] = address
        self.call_hosts(name)

    def inside(self, host):
        return hosts.inside(self.label(host))

    def ip(self, host, *words):
        hosts.ip("-n", hosts.namespace(self.label(host)), *words)

    def rules(self, host, chain, rule):
        return hosts.rules(self.label(host), chain, rule)

    def call_hosts(self, host, **names):
        """Give names to addresses, as a host sees them; its own means its address."""
        hosts.call_hosts(self.label(host), **dict(names, **{socket.gethostname(): [self.hosts[host]]}))

    @contextlib.contextmanager
    def pulled(self, host):
        """The cable of a host is pulled."""
        hosts.cable(self.label(host), "down", self.label("switch"))
        try:
            yield
        finally:
            hosts.cable(self.label(host), "up", self.label("switch"))

    # ---- its processes ----

    def start(self, name, host, command):
        running.processes.start(self.label(name), self.inside(host) + command)

    def begin(self, name, host, *words, port, publish="", listen=None):
        command = [sys.executable, "-m", "mock_components", "--control", tools.control(self.label(name))]
        command += ["--flavour", "cpp11"]  # its managers create components in their own process
        command += ["--nameserver", NEAR + ":2809", "--port", str(port)]
        command += ["--host", self.hosts[host] if listen is None else listen]
        if publish:
            command += ["--publish", publish]
        self.start(name, host, command + list(words))

    def world(self, name, host, *words, **options):
        """Start one more process of mocks."""
        self.begin(name, host, *words, **options)
        running.processes.ready(self.label(name))

    def start_names(self):
        data = around.directory(self.label("data"))
        self.start("names", "near", running.processes.nameserver.command(2809, data, NEAR))
        end = time.monotonic() + running.LIMIT
        while self.run("near", PATIENT, "rtls", "/" + NEAR).status:
            assert time.monotonic() < end, "omniNames does not answer"

    def restart_names(self):
        """Start it again, empty."""
        self.kill("names")
        data = around.directory(self.label("data"))
        for file in os.listdir(data):
            os.remove(os.path.join(data, file))
        self.start_names()

    def kill(self, name):
        running.processes.end(self.label(name))

    @contextlib.contextmanager
    def stopped(self, name):
        process = running.processes.find(self.label(name))
        process.send_signal(signal.SIGSTOP)
        assert tools.reaches(process.pid, "stopped", tools.START_LIMIT)
        try:
            yield
        finally:
            process.send_signal(signal.SIGCONT)

    def ctl(self, name, *words):
        return running.processes.ctl(self.label(name), *words).split()

    def wait(self, host, condition):
        """Wait until a line of shell succeeds on a host."""
        end = time.monotonic() + running.LIMIT
        while subprocess.call(self.inside(host) + ["bash", "-c", condition], stderr=subprocess.DEVNULL):
            assert time.monotonic() < end, condition
            time.sleep(0.02)

    # ---- commands ----

    def run(self, host, timeout, *words):
        more = {"RTCTREE_NAMESERVERS": NEAR, "RTSHELL_TIMEOUT": str(timeout)}
        return running.run(list(words), around.top, self.inside(host), **more)

    def well(self, host, *words):
        """The output of a command, which has to succeed."""
        ran = self.run(host, PATIENT, *words)
        assert ran.status == 0, ran
        return ran.out.decode()

    def close(self):
        for name in ("names", "n", "x", "thief", "http", "silent", "relay", *HOMES):
            with contextlib.suppress(KeyError):
                self.kill(name)
        hosts.unbuild(map(self.label, self.hosts), self.label("switch"))


# ---- what is said and done, and whether that is true ----

MANAGER = "corbaloc::%s:%d/manager" % (NEAR, PORTS["c"])
# what may be said of something that lives, or may live
TRUE = re.compile(
    "dead, or a firewall closes this port|is gone, or elsewhere|on that host: rtdoctor, rtdel -z|"
    "restart its process, so that it binds its name|restart those that do not"
)
DEATH = re.compile(r"\b(dead|zombie|gone|ended)\b|(^|\s)\*\w+\.rtc")
HARM = re.compile(r"try: .*(rtdel|--create)")
LOST = re.compile("component missing(?!, but it (lives|may live))")


def play(number, fault):
    """What is wrong while a fault lasts, and after it: a list of texts; and what was said."""
    robot = Robot(number)
    try:
        before = robot.ctl("c", "components")
        with fault.happen(robot):
            ran = [robot.run(fault.seat, TIMEOUT, *words) for words in (
                ["rtls", "-l", HOME],
                ["rtdoctor", "-q"],
                ["rtdoctor", "-qv", "--profile", robot.profile],
                ["rtdel", "-z"],
                ["rtdel", "-z", HOME],
                ["rtresurrect", "--create", "--manager", MANAGER, robot.profile],
            )]
        said = [line for each in ran for line in (each.out + each.err).decode().splitlines()]
        wrong = untrue(fault, said)
        wrong += [str(each) for each in ran if each.status not in (0, 1, 3, 4, 5) or b"Traceback" in each.err]
        if not re.search(fault.says, "\n".join(said)):
            wrong.append("is not said: " + fault.says)
        wrong += done(robot, fault, before)
        return wrong, "\n".join(map(str, ran))
    finally:
        robot.close()


def untrue(fault, said):
    """The lines that are not true of a component that is named in them, or whose advice does harm."""
    wrong = []
    for line in said:
        words = TRUE.sub("", line)
        components = re.findall(r"(\w+)\.rtc", line)
        alive = [name for name in components if name not in fault.dead]
        hale = [name for name in alive if name not in fault.hung]
        if alive and (DEATH.search(words) or HARM.search(words) or LOST.search(line)):
            wrong.append("not true of %s: %s" % (alive, line))
        elif hale and re.search("try: .*restart", words):
            wrong.append("nothing to restart: " + line)
        elif HARM.search(words) and not components and not fault.dead:
            wrong.append("does harm: " + line)
    return wrong


def done(robot, fault, before):
    """What has happened that must not: names deleted, components created; or must, and has not."""
    wrong = []
    names = [] if not fault.keeps_names else robot.run("near", PATIENT, "rtls", HOME).out.decode().split()
    for name in PARTS + tuple(fault.doubtful):
        bound = any(each.endswith(name + ".rtc") for each in names)
        if fault.keeps_names and name not in fault.dead and not bound:
            wrong.append("the name of %s is deleted" % name)
    if fault.creates:
        after = robot.ctl("c", "components")
        expected = sorted(set(before) | set(fault.dead))
        if sorted(after) != expected:
            wrong.append("the manager has %s, not %s" % (sorted(after), expected))
    elif any(name in fault.dead for name in names):
        wrong.append("bound: %s" % names)
    return wrong


def setUpModule():
    global around
    around = running.Surroundings()
    try:
        hosts.build({}, "trial")
    except unittest.SkipTest:
        around.close()
        raise
    hosts.unbuild({}, "trial")


def tearDownModule():
    around.close()


class TwoHosts(unittest.TestCase):
    def test_faults(self):
        numbers = {fault.name: number for number, fault in enumerate(FAULTS)}
        chosen = running.sample(numbers, len(FAULTS) // 3)

        def judged(name):
            return name, play(numbers[name], FAULTS[numbers[name]])

        counts = collections.Counter()
        for name, (wrong, said) in running.together(judged, chosen, PARALLEL):
            counts[FAULTS[numbers[name]].is_named] += not wrong
            with self.subTest(name):
                self.assertFalse(wrong, "\n".join(wrong) + "\n" + said)
        told = (len(chosen), counts[True], counts[False])
        print("figures: %d faults: %d named, %d cannot be told from here" % told)

    def test_a_robot_that_is_well(self):
        """Nothing is found, wherever one sits, whatever is asked for."""
        robot = Robot(len(FAULTS))
        self.addCleanup(robot.close)
        objects = ([], [NEAR], ["/" + NEAR], [HOME], [NEAR + ":2809"])
        variants = [
            (seat, ["rtdoctor", "-q"] + more + words)
            for seat in ("near", "far")
            for more in ([], ["--profile", robot.profile])
            for words in objects
        ]
        found = running.together(lambda variant: robot.run(variant[0], PATIENT, *variant[1]), variants, 2)
        false = [str(each) for each in found if each.out or each.err or each.status]
        print("figures: %d false alarms of %d" % (len(false), len(variants)))
        self.assertFalse(false, "\n".join(false))


if __name__ == "__main__":
    unittest.main()
