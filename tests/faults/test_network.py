"""Two robots and a laptop, each in a network of its own, firewalls, and addresses that lead nowhere, or
mislead. (Cables that are pulled, packets that are lost: tests/sim/stories/network.t.)

If one of these fails, the tool works on the desk and not at the robot. Needs `ip netns`, and the right to use
it.
"""
import os
import signal
import sys
import time
import unittest

import hosts
import running
import tools

ONCE = "what a network does is the same for every Python"
BOTH = "each ORB connects in its own way"
ALONE = "it measures times"

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

HOSTS = {"laptop": "10.77.0.1", "robot1": "10.77.0.2", "robot2": "10.77.0.3"}
NOWHERE = "10.77.0.99"  # nobody has it: questions who does are not answered
ELSEWHERE = "203.0.113.9"  # in a network to which there is no route (RFC 5737)
PORT = 2809


def setUpModule():
    global around
    hosts.build(HOSTS)
    around = running.Surroundings()
    for name, words in (("robot1", ["these", "ConsoleIn"]), ("robot2", ["these", "ConsoleOut"])):
        populate(name, words)


def populate(name, words):
    """A name server on a host, and components."""
    data = around.directory("names-" + name)
    start("names-" + name, name, running.processes.nameserver.command(PORT, data, HOSTS[name]))
    end = time.monotonic() + running.LIMIT
    while laptop("rtls", "/" + HOSTS[name]).status:
        assert time.monotonic() < end, "omniNames on %s does not answer" % name
    world(name, name, words)


def start(label, host, command):
    running.processes.start(label, hosts.inside(host) + command)
    return running.processes.find(label)


def world(label, host, words, *options):
    process = start(
        label,
        host,
        [
            sys.executable,
            "-m",
            "mock_components",
            "--host",
            HOSTS[host],
            "--control",
            tools.control(label),
            "--nameserver",
            "%s:%d" % (HOSTS[host], PORT),
        ]
        + list(options)
        + words,
    )
    running.processes.ready(label)
    return process


def kill(process):
    process.kill()
    process.wait()


PROFILE = """<rts:RtsProfile xmlns:rts="http://www.openrtp.org/namespaces/rts" rts:id="RTSystem:Me:Named:0" rts:version="0.2">
  <rts:Components rts:id="RTC:Mock:test:ConsoleIn:1.0" rts:pathUri="{path}" rts:instanceName="ConsoleIn0" rts:isRequired="true"/>
</rts:RtsProfile>"""  # noqa: E501


def tearDownModule():
    around.close()
    hosts.unbuild(HOSTS)


def laptop(*words, timeout=running.TIMEOUT):
    return running.run(list(words), around.top, hosts.inside("laptop"), **surroundings(timeout))


def on(host, *words):
    """A command on a host."""
    return running.run(list(words), around.top, hosts.inside(host), **surroundings(2))


def doctor(host, *words):
    """What rtdoctor -q says on a host."""
    return on(host, "rtdoctor", "-q", *words).out.decode()


def surroundings(timeout):
    return {"RTCTREE_NAMESERVERS": "%(robot1)s;%(robot2)s" % HOSTS, "RTSHELL_TIMEOUT": str(timeout)}


def firewall(name, how):
    """A host refuses connections from outside with all ports but that of its name server."""
    begun = "tcp dport != %d tcp flags & (syn | ack) == syn" % PORT
    return hosts.rules(name, "input", "%s reject with %s" % (begun, how))


B = "/%s/test.host_cxt/ConsoleOut0.rtc" % HOSTS["robot2"]
BOUND = running.TIMEOUT + running.SLACK


class Network(unittest.TestCase):
    def ends(self, ran, status, seconds=BOUND):
        self.assertIn(ran.status, status, ran)
        self.assertLess(ran.seconds, seconds + self.start_up, ran)
        self.assertNotIn(b"Traceback", ran.err)

    def test_an_address_that_leads_nowhere(self):
        """It lives, but from here it cannot be reached: rtdoctor says so, and does not take its name for that
        of a dead one.
        """
        self.start_up = laptop("rtls", "/" + HOSTS["robot1"], timeout=10).seconds
        world("lost", "robot1", ["these", "Mock:Lost0"], "--publish", NOWHERE, "--port", "2999")
        lost = "/%s/test.host_cxt/Lost0.rtc" % HOSTS["robot1"]
        ran = laptop("rtcat", lost)
        self.ends(ran, (4,))
        for words in (
            ["rtls", "-l", lost],
            ["rtdel", "-z"],
            ["rtdel", "-z", lost],
            ["rtact", lost],
            ["rtls", "-R", "/"],
        ):
            with self.subTest(" ".join(words)):
                self.ends(laptop(*words), (0, 1, 3, 4, 5))
        time.sleep(3.2)  # by now the kernel knows that nobody has the address, and refuses at once
        for words in (["rtls", "-l", lost], ["rtdel", "-z"], ["rtdel", "-z", lost]):
            with self.subTest(" ".join(words)):
                self.ends(laptop(*words), (0, 1, 3, 4, 5))
        self.assertIn(b"Lost0.rtc", laptop("rtls", "/%s/test.host_cxt" % HOSTS["robot1"]).out)
        world("far", "robot1", ["these", "Mock:Far0"], "--publish", ELSEWHERE, "--port", "2998")
        far = "/%s/test.host_cxt/Far0.rtc" % HOSTS["robot1"]
        for words in (["rtact", far], ["rtdel", "-z", far]):  # at once: there is no way to that network
            with self.subTest(" ".join(words)):
                ran = laptop(*words)
                self.ends(ran, (4,))
                self.assertIn(("%s: %s: cannot be reached" % (words[0], far)).encode(), ran.err)
        self.ends(laptop("rtdel", "-z"), (0, 1))  # 1: of another test, what refuses is left
        self.assertIn(b"?Far0.rtc", laptop("rtls", "/%s/test.host_cxt" % HOSTS["robot1"]).out)
        self.assertIn(NOWHERE.encode(), laptop("rtdoctor", lost).out)
        for where, address in ((lost, NOWHERE), (far, ELSEWHERE)):
            said = laptop("rtdoctor", "-q", where, timeout=2).out.decode()
            self.assertIn("cannot tell from here whether it lives: publishes %s" % address, said)
            self.blames_the_network(said)

    def blames_the_network(self, said):
        """Nothing advises to restart or delete anything."""
        self.assertIn("try: look at what is between here and ", said)
        self.assertNotRegex(said, "restart|try: rtdel|rtdis")

    def test_a_firewall_that_refuses(self):
        """Only the name server is let through: all components live, none is called dead, and no name is
        deleted, whatever we advise.
        """
        self.start_up = laptop("rtls", "/" + HOSTS["robot1"], timeout=10).seconds
        doomed_process = world("doomed", "robot2", ["these", "Mock:Doomed0"])
        doomed, home = (
            "/%s/test.host_cxt/Doomed0.rtc" % HOSTS["robot2"],
            "/%s/test.host_cxt" % HOSTS["robot2"],
        )
        for how in ("tcp reset", "icmp type port-unreachable"):
            with self.subTest(how), firewall("robot2", how):
                said = laptop("rtdoctor", "-q", "/" + HOSTS["robot2"]).out.decode()
                self.assertRegex(said, "ConsoleOut0.rtc: .* refuses: dead, or a firewall closes this port")
                self.assertNotRegex(said, "zombie|try: rtdel")
                self.assertIn(b"?ConsoleOut0.rtc", laptop("rtls", "-l", home).out)
                self.assertEqual(laptop("rtfind", "/" + HOSTS["robot2"], "-t", "z").out, b"")
                for words in (["rtdel", "-z"], ["rtdel", "-z", B]):
                    ran = laptop(*words)
                    self.assertEqual(ran.status, 1, ran)
                    self.assertIn(b"ConsoleOut0.rtc: left: refuses: dead, or a firewall closes", ran.err)
                self.assertIn(b"dead, or a firewall closes", laptop("rtact", B).err)
        self.assertIn(b"ConsoleOut0.rtc", laptop("rtls", home).out)
        kill(doomed_process)
        # the others of its host answer, which proves nothing: a firewall may close one port
        self.assertIn(b"?Doomed0.rtc", laptop("rtls", home).out)
        self.assertNotIn("zombie", laptop("rtdoctor", "-q", home).out.decode())
        self.assertEqual(laptop("rtdel", "-z", doomed).status, 1)
        # on its own host it is certain
        self.assertIn("dead (zombie): nothing listens at", doctor("robot2", home))
        self.assertEqual(on("robot2", "rtdel", "-z", doomed).status, 0)
        kill(world("doomed-again", "robot2", ["these", "Mock:Doomed0"]))
        with firewall("robot2", "tcp reset"):
            self.assertEqual(laptop("rtdel", "-z", "-f", doomed).status, 0)
        self.assertNotIn(b"Doomed0.rtc", laptop("rtls", home).out)

    def test_addresses_that_mislead(self):
        """Seen from the laptop and from the robot: who publishes 127.0.0.1, or an address of another network,
        is named.
        """
        robot1 = hosts.namespace("robot1")
        hosts.ip("-n", robot1, "link", "add", "inner", "type", "veth", "peer", "name", "outer")
        hosts.ip("-n", robot1, "address", "add", "192.168.78.2/24", "dev", "inner")
        hosts.ip("-n", robot1, "link", "set", "inner", "up")
        looped = world(
            "looped",
            "robot1",
            ["these", "Mock:Looped0"],
            "--host",
            "",
            "--publish",
            "127.0.0.1",
            "--port",
            "2997",
        )
        world(
            "inner",
            "robot1",
            ["these", "Mock:Inner0"],
            "--host",
            "",
            "--publish",
            "192.168.78.2",
            "--port",
            "2996",
        )
        home = "/" + HOSTS["robot1"]
        for name, message in (("laptop", "Looped0.rtc: publishes 127.0.0.1:2997, which means this host, "
                                         "not its own"),
                              ("robot1", "Looped0.rtc: publishes 127.0.0.1:2997: only this host can "
                                         "reach it"),
                              ("laptop", "Inner0.rtc: cannot tell from here whether it lives: publishes "
                                         "192.168.78.2:2996, of another network than its name server, out "
                                         "of reach"),
                              ):
            with self.subTest(name + " " + message):
                said = doctor(name, home)
                self.assertIn(message, said)
                self.assertNotIn("rtdel", said)
        # another interface of the same host
        self.assertNotIn("Inner0.rtc: publishes", doctor("robot1", home))
        looped.send_signal(signal.SIGSTOP)
        try:
            said = doctor("robot1", home)
        finally:
            looped.send_signal(signal.SIGCONT)
        self.assertRegex(said, "fail  [^ ]*Looped0.rtc: hung: ")
        self.assertIn("Looped0.rtc: publishes 127.0.0.1:2997: only this host can reach it", said)
        kill(looped)
        said = doctor("robot1", home)
        self.assertRegex(said, "fail  [^ ]*Looped0.rtc: dead .*rtdel -z")
        self.assertNotIn("dead", doctor("laptop", home))

    def test_names_of_hosts(self):
        """A name in a reference that nobody knows, or that means this host here; one of a name server that
        means two hosts.
        """
        hosts.call_hosts("laptop", arm=[HOSTS["robot1"], HOSTS["robot2"]], desk=[HOSTS["laptop"]])
        for number, (name, host) in enumerate((("Far0", "robot.invalid"), ("Desk0", "desk"))):
            world(
                name,
                "robot1",
                ["these", "Mock:" + name, "--context", "named.host_cxt/%n.rtc"],
                "--publish",
                host,
                "--port",
                str(2990 + number),
            )
        said = doctor("laptop", "/%(robot1)s/named.host_cxt" % HOSTS)
        self.assertIn("Far0.rtc: cannot tell from here whether it lives: publishes robot.invalid:2990, a "
                      "host name that is not known here",
                      said)
        self.assertIn("/etc/hosts here, or have its process publish an address: corba.endpoints", said)
        self.assertIn("Desk0.rtc: cannot tell from here whether it lives: desk:2991 (10.77.0.1, "
                      "this host) may mean another host", said)
        self.assertNotIn("rtdel", said)
        said = laptop("rtdoctor", "/arm").out.decode()
        self.assertRegex(said, r"ok    /arm: answers \(.*\) at 10.77.0.2; arm also means 10.77.0.3")
        self.assertIn(
            "something does on port 2809 of that host", doctor("laptop", "/arm:2808", "/" + HOSTS["robot2"])
        )

    def test_a_name_server_without_names(self):
        """It has been started again, empty, while components of its host live."""
        start(
            "names-empty",
            "robot1",
            running.processes.nameserver.command(2812, around.directory("names-empty"), HOSTS["robot1"]),
        )
        where = "/%(robot1)s:2812" % HOSTS
        end = time.monotonic() + running.LIMIT
        while laptop("rtls", where).status:
            self.assertLess(time.monotonic(), end)
        self.assertNotIn("has no names", doctor("laptop", where))
        world("master", "robot1", ["manager11"], "--port", "2810")
        self.assertIn("%s: has no names, though a manager at port 2810 of its host has 2 "
                      "components (ConsoleIn0 and ConsoleOut0)" % where,
                      doctor("laptop", where))
        hosts.call_hosts("laptop", robot1=[HOSTS["robot1"]])
        profile = os.path.join(around.top, "named.rtsys")
        with open(profile, "w") as file:
            file.write(PROFILE.format(path=where[1:] + "/robot1.host_cxt/ConsoleIn0.rtc"))
        self.assertIn(
            "/robot1.host_cxt/ConsoleIn0.rtc: Required component missing, but it lives: the manager "
            "corbaloc::robot1:2810/manager has it",
            doctor("laptop", "--profile", profile, where),
        )


if __name__ == "__main__":
    unittest.main()
