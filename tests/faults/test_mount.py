"""A mounted tree among peers that hang, die and lie: it answers, frees who waits, and does not grow.

If this fails, a hung component stops every shell that looks at the robot, or a mount of a week fills its
memory.
"""
import errno
import os
import pwd
import re
import shutil
import signal
import stat
import subprocess
import threading
import time
import unittest

import jobs
import mounts
import running
import tools
import worlds
from mock_components import faulty

ONCE = "it is about the kernel and the peers"
BOTH = "each ORB waits in its own way"

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

READERS = 1000
ROUNDS = 400 if running.THOROUGH else 12  # Python takes memory by the MiB, the last time after 150
PROMPT = 0.1  # seconds within which an interrupted reader is free
PATIENCE = 8  # seconds, the timeout of what hangs; what does not wait for it must be done in half that time
# of a server that a thousand readers wait for
THREADS = 1 if os.environ.get("RTSHELL_ORB") != "omniorb" else 40
RESIDENT = 30 * 1024  # kB
# kB, when all hostile peers have been read; omniORB takes what the builtin ORB refuses
HOSTILE = (64 if os.environ.get("RTSHELL_ORB") != "omniorb" else 256) * 1024
AT_ONCE = 2  # hostile peers that are read at a time
# of what cannot be read
UNHEARD = (
    errno.EHOSTUNREACH,
    errno.EIO,
    errno.ENOENT,
    errno.ETIMEDOUT,
    errno.ECONNREFUSED,
    errno.ENXIO,
    errno.EPERM,
)
KINDS = 25  # of hostile peers that one run reads, others by another seed
LONGEST = 600  # seconds of all of them, on however busy a machine
# Seconds for a file of those that answer all that is asked.
TALK_LIMIT = {
    "many-connectors": 10.0,
    "many-members": 10.0,
    "many-organizations": 10.0,
    "many-contexts": 10.0,
    "many-ports": 200.0,
}
GROWTH = 1024  # kB in the second half of the rounds


def setUpModule():
    global around, server
    if mounts.refused():
        raise unittest.SkipTest("nothing can be mounted here: " + mounts.refused())
    around = running.Surroundings()
    server = around.name_server()
    around.world(server, "linked")
    around.world(server, "many", "20", "--context", "many.host_cxt/%n.rtc")
    around.world(server, "hostile", "--context", "bad.host_cxt/%n.rtc")
    around.world(server, "hung", "3", "--context", "hung.host_cxt/%n.rtc")
    around.world(server, "hung", "3", "--context", "hung2.host_cxt/%n.rtc")


def tearDownModule():
    around.close()


class Case(unittest.TestCase):
    """A mount of its own, at `self.root`; its rtmount is `self.process`."""

    options = ["--timeout", "2"]

    def setUp(self):
        self.top = around.directory("m%d" % id(self))
        self.process = running.start(
            ["rtmount", "-f", self.top] + self.options,
            around.top,
            {"RTCTREE_NAMESERVERS": server[1:]},
            stderr=subprocess.DEVNULL,
        )
        worlds.eventually(lambda: os.path.exists(os.path.join(self.top, "README")), "mounted")
        self.root = os.path.join(self.top, server[1:])
        self.addCleanup(self.end)

    def end(self):
        self.process.terminate()
        self.assertEqual(self.process.wait(worlds.LIMIT), 0)
        self.assertEqual(os.listdir(self.top), [])

    def resident(self):
        with open("/proc/%d/statm" % self.process.pid) as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") // 1024

    def threads(self):
        return len(os.listdir("/proc/%d/task" % self.process.pid))

    def read(self, *names):
        with open(os.path.join(self.root, *names)) as file:
            return file.read()


class Hung(Case):
    options = ["--timeout", str(PATIENCE)]

    def test_a_thousand_readers(self):
        """They wait for hung files; everything else goes on, on few threads."""
        before = threading.stack_size(1 << 18)
        errors = []
        try:
            files = [
                (context, "Mock%d.rtc" % i, name)
                for context in ("hung.host_cxt", "hung2.host_cxt")
                for i in range(3)
                for name in ("state", "version", "contexts/0/rate", "profile.json")
            ]

            def wait(number):
                try:
                    self.read(*files[number % len(files)])
                except OSError as e:
                    errors.append(e.errno)
            readers = [threading.Thread(target=wait, args=(number,)) for number in range(READERS)]
            for reader in readers:
                reader.start()
        finally:
            threading.stack_size(before)
        slowest = most = 0
        while readers[-1].is_alive() and not errors:
            watch = tools.Stopwatch(self.process.pid, "thread-self")
            self.assertEqual(len(os.listdir(os.path.join(self.root, "many.host_cxt"))), 20)
            self.assertEqual(self.read("many.host_cxt", "Mock1.rtc", "state"), "Inactive\n")
            self.assertIn("Mock0.rtc", os.listdir(os.path.join(self.root, "hung.host_cxt")))
            slowest = max(slowest, watch.seconds())
            most = max(most, self.threads())
        for reader in readers:
            reader.join(worlds.LIMIT)
        print("figures: %d readers of hung files: looks elsewhere took up to %.2f s, %d threads, %d kB" % (
            READERS, slowest, most, self.resident()))
        self.assertEqual(len(errors), READERS)
        self.assertLess(slowest, PATIENCE / 2)
        self.assertLessEqual(most, THREADS)
        self.assertLess(self.resident(), RESIDENT + 4096)

    def test_ctrl_c(self):
        for name in ("state", "ports"):
            reader = subprocess.Popen(
                ["grep", "-r", "x", os.path.join(self.root, "hung.host_cxt", "Mock0.rtc", name)],
                stderr=subprocess.DEVNULL,
                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
            )
            time.sleep(0.5)
            self.assertIsNone(reader.poll())
            watch = tools.Stopwatch(self.process.pid, reader.pid)
            reader.send_signal(signal.SIGINT)
            os.waitid(os.P_PID, reader.pid, os.WEXITED | os.WNOWAIT)
            self.assertLess(watch.seconds(), PROMPT)
            self.assertEqual(reader.wait(worlds.LIMIT), -signal.SIGINT)

    def test_an_interrupted_reader_that_goes_on(self):
        """A handled signal ends the read with EINTR, long before the timeout."""
        class Alarm(Exception):
            pass

        def ring(*_):
            raise Alarm
        old = signal.signal(signal.SIGALRM, ring)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.5)
            watch = tools.Stopwatch(self.process.pid, "thread-self")
            self.assertRaises(Alarm, self.read, "hung.host_cxt", "Mock1.rtc", "state")
            self.assertLess(watch.seconds(), PATIENCE / 2)
        finally:
            signal.signal(signal.SIGALRM, old)


class Long(Case):
    def test_it_does_not_grow(self):
        """All of it is listed and read again and again, written, connected and disconnected."""
        seen = []
        home = os.path.join(self.root, "test.host_cxt", "ConsoleIn0.rtc")
        place = os.path.join(self.root, "many.host_cxt")
        link = os.path.join(home, "ports/out/connections/again")
        for _ in range(ROUNDS):
            subprocess.run(["ls", "-lR", place], stdout=subprocess.DEVNULL, check=True)
            subprocess.run(["grep", "-r", "nothing", home], stdout=subprocess.DEVNULL)
            for state in ("Active", "Inactive", "nonsense"):
                subprocess.call(["sh", "-c", "echo %s >%s/state" % (state, home)], stderr=subprocess.DEVNULL)
            os.remove(os.path.join(os.path.dirname(link), os.listdir(os.path.dirname(link))[0]))
            os.symlink(os.path.join(self.root, "test.host_cxt/ConsoleOut0.rtc/ports/in"), link)
            self.assertEqual(os.listdir(os.path.dirname(link)), ["again"])
            subprocess.call(["timeout", "0.05", "cat", os.path.join(home, "ports/out/values")])
            seen.append((self.resident(), len(os.listdir("/proc/%d/fd" % self.process.pid))))
        half = seen[len(seen) // 2]
        print("figures: after %d rounds: %s kB and files, after %d: %s; %d threads" % (
            len(seen) // 2, half, len(seen), seen[-1], self.threads()))
        self.assertLess(seen[-1][0] - half[0], GROWTH)
        self.assertLessEqual(seen[-1][1], half[1] + 4)
        self.assertLess(seen[-1][0], RESIDENT)


class Peers(Case):
    """Peers that harm who reads them, as components and as name servers: whatever is read of them ends, in
    time.
    """

    options = ["--timeout", str(running.TIMEOUT)]

    @classmethod
    def setUpClass(cls):
        modes = running.sample(sorted(set(faulty.MODES) | set(faulty.UNREACHABLE)), KINDS)
        cls.ports = around.faulty(*modes)
        for mode in modes:
            faulty.bind("%s/peer.host_cxt" % server[1:], {mode: cls.ports[mode]})

    def end(self):
        """With status 5, as more than 20,000 names is left out."""
        self.process.terminate()
        self.assertEqual(self.process.wait(worlds.LIMIT), 5)

    def read_parts(self, place):
        """Read what people and scripts read of a component: the longest time that one file or directory took.
        """
        slowest = 0.0
        for name in (
            "",
            "state",
            "version",
            "ports",
            "ports/out/connections",
            "ports/out/connections/connector0",
            "contexts",
            "contexts/0/rate",
            "configuration/active",
            "members",
            "properties",
            "profile.json",
            "state",
        ):
            begun = time.monotonic()
            try:
                self.read_any(os.path.join(place, name))
            except OSError as e:
                self.assertIn(e.errno, UNHEARD)
            slowest = max(slowest, time.monotonic() - begun)
        return slowest

    def read_any(self, path):
        """Read a file, a link or a directory. What cannot be looked at raises OSError."""
        mode = os.lstat(path).st_mode
        if stat.S_ISLNK(mode):
            os.readlink(path)
        elif stat.S_ISDIR(mode):
            os.listdir(path)
        else:
            with open(path) as file:
                file.read()

    def test_peers(self):
        places = {
            mode + " as component": os.path.join(self.root, "peer.host_cxt", mode + ".rtc")
            for mode in self.ports
        }
        for mode, port in self.ports.items():
            places[mode + " as name server"] = os.path.join(self.top, "127.0.0.1:%d" % port, "Evil0.rtc")
        looked = {}

        def read(case):
            looked[case] = self.read_parts(places[case])
        reader = threading.Thread(target=running.together, args=(read, sorted(places), AT_ONCE), daemon=True)
        reader.start()
        reader.join(LONGEST)
        self.assertEqual(sorted(set(places) - set(looked)), [])
        slowest = sorted(looked, key=looked.get)[-5:]
        print(
            "figures: %d hostile peers: %s; %d kB, %d threads"
            % (
                len(places),
                ", ".join("%s %.1f s" % (case, looked[case]) for case in slowest),
                self.most_resident(),
                self.threads(),
            )
        )
        waited = tools.waited_for_processor(self.process.pid)
        for case in looked:
            limit = TALK_LIMIT.get(case.split()[0], 3 * running.TIMEOUT + running.SLACK)
            self.assertLess(looked[case] - waited, limit, case)
        self.assertLess(self.most_resident(), HOSTILE)
        self.assertLessEqual(self.threads(), THREADS)
        self.assert_rests()

    def assert_rests(self):
        """What peers send on and on, though nobody waits for it any more, takes no processor."""
        before = self.processor()
        time.sleep(1)
        self.assertLess(self.processor() - before, 0.3)

    def processor(self):
        """Seconds of CPU that rtmount has taken."""
        with open("/proc/%d/stat" % self.process.pid) as file:
            fields = file.read().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def most_resident(self):
        """kB that rtmount has taken at most."""
        with open("/proc/%d/status" % self.process.pid) as file:
            return int(re.search(r"VmHWM:\s*(\d+) kB", file.read()).group(1))


class Hostile(Case):
    def test_nothing_escapes(self):
        """Whatever the component says, names and contents are printable, and reading all of it ends."""
        place = os.path.join(self.root, "bad.host_cxt", "Hostile0.rtc")
        for words in (["find", place], ["grep", "-r", "", place]):
            said = subprocess.run(words, stdout=subprocess.PIPE, timeout=worlds.LIMIT).stdout.decode()
            self.assertGreater(len(said.splitlines()), 40)
            self.assertEqual(re.findall("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e]", said), [])
        for directory, _, names in os.walk(place):
            for name in names:
                self.assertTrue(os.path.lexists(os.path.join(directory, name)), name)

    def test_links_lead_where_the_connection_does(self):
        # named in full: it is bound by another name
        ports = os.path.join(self.root, "bad.host_cxt", "Hostile0.rtc", "ports")
        (place,) = [
            os.path.join(ports, name, "connections") for name in os.listdir(ports) if name.endswith(".plain")
        ]
        link, = [os.path.join(place, name) for name in os.listdir(place)]
        self.assertEqual(self.read(link, "type"), "DataInPort\n")

    def test_configuration(self):
        """What was read can be written, and is the same then."""
        place = os.path.join(self.root, "bad.host_cxt", "Hostile0.rtc", "configuration", "default")
        for name in os.listdir(place):
            path = os.path.join(place, name)
            before = self.read(path)
            if len(before) < 10000:
                with open(path, "w") as file:
                    file.write(before)
                self.assertEqual(self.read(path), before)


DEV = """
mount -t tmpfs none /dev && mknod -m 666 /dev/null c 1 3 || { echo no device can be made; exit; }
as() {
    id=$(id -u $1); shift  # who may read what only root may, such as an environment of Python
    setpriv --reuid $id --regid $id --clear-groups --inh-caps +dac_read_search --ambient-caps +dac_read_search "$@"
}
"""  # noqa: E501
FUSE = "mknod -m 666 /dev/fuse c 10 229; "


class Users(unittest.TestCase):
    """Each in a /dev of its own, so that everybody may open /dev/fuse, or nobody has it."""

    @classmethod
    def setUpClass(cls):
        for tool in ("fusermount3", "setpriv"):
            if not shutil.which(tool):
                raise unittest.SkipTest("needs " + tool)
        if os.geteuid() or not jobs.apart():
            raise unittest.SkipTest("needs a mount namespace")

    def says(self, script, expected):
        """Run a script of the users nobody, who owns m in the working directory, and daemon; $STATE is a
        component's.
        """
        top = around.directory("users%d" % id(self))
        os.chmod(around.top, 0o711)
        os.makedirs(os.path.join(top, "m"), exist_ok=True)
        nobody = pwd.getpwnam("nobody")
        os.chown(os.path.join(top, "m"), nobody.pw_uid, nobody.pw_gid)
        environment = running.environment(
            RTCTREE_NAMESERVERS=server[1:], STATE="m%s/test.host_cxt/ConsoleOut0.rtc/state" % server
        )
        done = subprocess.run(["unshare", "--mount", "sh", "-c", DEV + script], cwd=top, env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=worlds.LIMIT)
        said = done.stdout.decode().replace(top, "TOP")
        if "no device can be made" in said:
            self.skipTest("no device can be made here")
        self.assertEqual(said.splitlines(), expected)

    def test_one_who_is_not_root(self):
        self.says(
            FUSE + """
            >/dev/conf; mount --bind /dev/conf /etc/fuse.conf
            as nobody rtmount m && as nobody cat $STATE; as nobody sh -c 'echo Active >$STATE; cat $STATE; echo Inactive >$STATE'
            as daemon cat $STATE 2>&1 | sed 's/.*: //'; as nobody rtmount -u m; ls m""",  # noqa: E501
            ["Inactive", "Active", "Permission denied"],
        )

    def test_others_only_read(self):
        """Where /etc/fuse.conf lets them."""
        self.says(FUSE + """
            echo user_allow_other >/dev/conf; mount --bind /dev/conf /etc/fuse.conf; as nobody rtmount m
            as daemon cat $STATE; as daemon sh -c 'echo Active >$STATE' 2>/dev/null || echo refused
            as nobody cat $STATE; as nobody rtmount -u m
            """, ["Inactive", "refused", "Inactive"])

    def test_read_only(self):
        self.says(
            FUSE
            + """as nobody rtmount --read-only m
            as nobody sh -c 'echo Active >$STATE' 2>&1 | sed 's/.*: //'; as nobody cat $STATE; as nobody rtmount -u m""",  # noqa: E501
            ["Read-only file system", "Inactive"],
        )

    def test_without_a_helper(self):
        self.says(FUSE + 'command=$(command -v rtmount); as nobody env PATH=/nowhere "$command" m; echo $?',
                  ["rtmount: fusermount3 and fusermount: not found: without them only root can mount", "1"])

    def test_without_the_device(self):
        self.says("rtmount m; echo $?", [
            "rtmount: /dev/fuse: not there: this kernel or container has no FUSE (modprobe fuse)", "1"])

    def test_without_any_device(self):
        """In a chroot into which nobody has put a /dev."""
        self.says("rm /dev/null; rtpwd; rtls /127.0.0.1:1; echo $?; rtmount m", [
            "/", "rtls: /127.0.0.1:1: connection refused; is the name server running?", "4",
            "rtmount: /dev/fuse: not there: this kernel or container has no FUSE (modprobe fuse)"])

    def test_without_the_right_to_open_it(self):
        self.says(
            FUSE + "chmod 600 /dev/fuse; as nobody rtmount m; echo $?",
            [
                "rtmount: TOP/m: cannot mount: %s: failed to open /dev/fuse: Permission denied"
                % shutil.which("fusermount3"),
                "1",
            ],
        )


class Killed(Case):
    def end(self):
        mounts.take_away(around.top)

    def test_readers_are_freed(self):
        reader = subprocess.Popen(
            ["cat", os.path.join(self.root, "test.host_cxt/ConsoleIn0.rtc/ports/out/values")],
            stderr=subprocess.PIPE,
        )
        time.sleep(0.5)
        self.process.kill()
        self.process.wait()
        self.assertEqual(reader.wait(worlds.LIMIT), 1)
        with reader.stderr:
            self.assertRegex(reader.stderr.read().decode(), "abort|not connected")


if __name__ == "__main__":
    unittest.main()
