"""Follows the advice of rtdoctor blindly: if one of these fails, the advice does harm, or does not help.

For each fault: what there is in the world is written down, each remedy that is a command is pasted into a
shell, and rtdoctor looks again. What it found must be gone, and nothing else may have changed but what the
remedy is for.
"""
import collections
import json
import os
import re
import shlex
import subprocess
import sys
import time
import unittest

from loops import wait_for
import mounts
import running
import worlds

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

from rtshell_lite import errors, path
from rtshell_lite.doctor import finding, remedies
from rtshell_lite.robot import tree
from rtshell_lite.system import capture

ONCE = "what commands do is the same for every Python"
PROGRAMS = set(os.listdir(worlds.COMMANDS)) & {
    name for name in os.listdir(worlds.COMMANDS) if name.startswith("rt")
} | {"unset"}
SETTLED = (
    "dataport.data_type",
    "dataport.dataflow_type",
    "dataport.interface_type",
    "dataport.subscription_type",
)

# A fault: `worlds` are started, {} in `before` (commands) and in `doctor` (words of rtdoctor) is the
# name server, the world's control is asked `asks`; `settings` are environment variables. `mends` maps names
# of remedies to patterns of the facts that they may change, each "KIND OBJECT".
Fault = collections.namedtuple("Fault", "worlds asks before doctor settings mends")


def fault(*worlds, asks=(), before=(), doctor=("{}",), settings=None, mends=None):
    return Fault(worlds, asks, before, doctor, settings or {}, mends or {})


FAULTS = {
    "in Error": fault("error", mends={"reset": ["state Broken0"]}),
    "nothing executes it": fault(
        "idle", mends={"start context": ["running Stopped0"], "set rate": ["rate Still0"]}
    ),
    "nothing started": fault("two", mends={"activate": ["state Console(In|Out)0"]}),
    # words: it may move
    "one has been reset": fault("linked", before=["rtact --wait {}/test.host_cxt/ConsoleIn0.rtc"]),
    "connections gone wrong": fault(
        "crossed",
        mends={
            "disconnect": ["connection (Have.|Want.|Out2|Sensor0)"],
            "reconnect": ["connection (In|Out)[01]"],
        },
    ),
    "names astray": fault(
        "astray",
        mends={
            "delete zombie": ["name (Ended0|Gone0)"],
            "delete name": ["name (Nil0|empty.cxt|emptier.cxt)"],
            "activate": ["state .*0"],
        },
    ),
    "dead": fault("zombie 3", mends={"delete zombie": ["name Mock[012]"]}),
    "aliases": fault("aliased", mends={"activate": ["state Inner0"]}),
    "dead members": fault("deadmember", mends={"delete zombie": ["name Peer0"]}),
    "dead far ends": fault(
        "orphan", "fragile", mends={"delete zombie": ["name Peer0"], "activate": ["state (Orphan|Fragile)0"]}
    ),
    "managers": fault(
        "deadslave",
        "deadchild --context other.host_cxt/%n.rtc",
        mends={"delete zombie": ["name ConsoleOut0"], "activate": ["state ConsoleIn0"]},
    ),
    "other settings": fault(
        "robot",
        settings={"ORBendPoint": ("giop:tcp:203.0.113.9:"), "OMNIORB_CONFIG": "/nowhere"},
        mends={"unset": [], "activate": ["state .*"]},
    ),
    "a rule": fault(
        settings={"ORBclientTransportRule": "198.51.100.1 none", "RTSHELL_ORB": "omniorb"},
        mends={"unset": []},
    ),
    "not as in the profile": fault(
        "robot",
        before=[
            "rtact --wait {0}/test.host_cxt/Sensor0.rtc {0}/test.host_cxt/Clusterer0.rtc",
            "rtcryo -o robot.rtsys {}",
            "rtdis {}/test.host_cxt/Sensor0.rtc:out",
            "rtconf {}/test.host_cxt/Motor0.rtc " "set motor_id 7",
            "rtec {}/test.host_cxt/Controller0.rtc rate 20",
        ],
        doctor=["{}", "--profile", "robot.rtsys", "--state", "Inactive"],
        mends={
            "restore": ["connection (Sensor|Controller)0", "set Motor0", "rate Controller0"],
            "deactivate": ["state (Sensor0|Clusterer0)"],
        },
    ),
    "another rate than in the profile": fault(
        "linked",
        before=["rtcryo -o rates.rtsys {}", "rtec {}/test.host_cxt/ConsoleIn0.rtc rate 20"],
        doctor=["{}", "--profile", "rates.rtsys", "--state", "Inactive"],
        mends={"set rate": ["rate ConsoleIn0"]},
    ),
    "another rate of a second context": fault(
        "contexts",
        before=["rtcryo --all -o two.rtsys {}", "rtec -e 1 {}/test.host_cxt/Multi0.rtc rate 20"],
        doctor=["{}", "--profile", "two.rtsys", "--state", "Inactive"],
        mends={"set rate": ["rate Multi0"]},
    ),
    "in Error in the context of another": fault(
        "contexts", asks=["error Driver0 1"], mends={"reset": ["state Multi0"]}
    ),
    "in Error, Inactive in the profile": fault(
        "linked",
        asks=["error ConsoleIn0"],
        before=["rtcryo -o linked.rtsys {}"],
        doctor=["{}", "--profile", "linked.rtsys", "--state", "Inactive"],
        mends={"reset": ["state ConsoleIn0"]},
    ),
    "one not started": fault(
        "linked",
        before=["rtcryo -o linked.rtsys {}", "rtact --wait {}/test.host_cxt/ConsoleOut0.rtc"],
        doctor=["{}", "--profile", "linked.rtsys"],
        mends={"activate": ["state ConsoleIn0"]},
    ),
    "a tiny timeout": fault(
        doctor=["--timeout", "0.4", "{}"], settings={"RTSHELL_TIMEOUT": ("0.4")}, mends={"unset": []}
    ),
    "a wrong working directory": fault(settings={"RTCSH_CWD": "nowhere"}, mends={"unset": []}),
    "a stale mount": fault(
        before=["mkdir stale; rtmount -f stale & until [ -e stale/README ]; do sleep 0.1; done; kill -9 $!"],
        mends={"unmount": []},
    ),
    "not started": fault(
        "linked",
        before=["rtcryo -o linked.rtsys {}"],
        doctor=["{}", "--profile", "linked.rtsys"],
        mends={"start system": ["state ConsoleIn0", "state ConsoleOut0"]},
    ),
    "in Error in the profile": fault(
        "linked",
        asks=["error ConsoleIn0"],
        before=["rtcryo -o linked.rtsys {}"],
        doctor=["{}", "--profile", "linked.rtsys"],
        mends={"reset and activate": ["state ConsoleIn0"], "activate": ["state ConsoleOut0"]},
    ),
}


# ---- what there is ----

TIMEOUT = 5.0  # seconds


def facts(server):
    """{"KIND PATH …": state} of everything that a name server leads to."""
    async def living():
        return await tree.check_alive(await tree.walk(await tree.resolve(server), managers=False))
    found = {}
    for node in wait_for(living(), TIMEOUT):
        where = str(node.path)
        found["name " + where] = (node.kind, str(node.alias))
        if node.kind == "component" and node.alias is None:
            found.update(_component(node, where))
    return found


def _component(node, where):
    try:
        asked = wait_for(capture.ask(node), TIMEOUT)
    except errors.Error as e:
        return {"broken " + where: type(e).__name__}
    found = {"active set " + where: asked.active}
    for one in asked.owned:
        found["rate %s %s" % (where, one.handle)] = one.rate
        found["running %s %s" % (where, one.handle)] = one.running
    for handle, state in asked.states.items():
        found["state %s %s" % (where, handle)] = state
    for one in asked.sets:
        found["set %s %s" % (where, one.id)] = sorted(one.values.items())
    for port in asked.ports:
        for one in port.connectors:
            kept = sorted(item for item in one.properties if item[0] in SETTLED)
            found["connection %s:%s %s" % (where, port.name, one.id)] = (one.name, len(one.ports), kept)
    return found


def changed(before, after):
    return sorted(key for key in set(before) | set(after) if before.get(key) != after.get(key))


# ---- which remedy it is ----

def is_command(remedy):
    return remedy.split(" ")[0] in PROGRAMS


def named(remedy):
    """The names of the commands in the table that a remedy may be made from."""
    return [
        name
        for name, template in remedies.COMMANDS.items()
        if re.match(".*".join(map(re.escape, re.split(r" ?\{\w+\}", template))) + r"\Z", remedy, re.DOTALL)
    ]


class Following(unittest.TestCase):
    followed = collections.Counter()

    @classmethod
    def setUpClass(cls):
        worlds.processes.nameserver.binary() or cls.skipTest("needs omniNames")
        cls.around = running.Surroundings()

    @classmethod
    def tearDownClass(cls):
        cls.around.close()
        print("%d remedies followed: %s" % (sum(cls.followed.values()), ", ".join(
            "%s %d" % item for item in sorted(cls.followed.items()))), file=sys.stderr)

    def shell(self, words, settings):
        """What a POSIX shell prints for some lines, in a directory of ours."""
        environment = running.environment(
            PATH=os.path.dirname(self.program()) + os.pathsep + os.environ["PATH"], **settings
        )
        done = subprocess.run(["sh"], input="\n".join(words).encode(), cwd=self.around.top, env=environment,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=running.LIMIT)
        return done.stdout.decode(), done.stderr.decode()

    def program(self):
        """A directory in which each command is run by this Python."""
        place = self.around.directory("programs")
        for name in PROGRAMS - {"unset"}:
            target = os.path.join(place, name)
            if not os.path.exists(target):
                with open(target, "w") as file:
                    file.write(
                        '#!/bin/sh\nexec "%s" "%s" "$@"\n'
                        % (sys.executable, os.path.join(worlds.COMMANDS, name))
                    )
                os.chmod(target, 0o755)
        return target

    def examined(self, words, settings, first=()):
        """Findings of rtdoctor, after `first` has been done in the same shell."""
        line = " ".join(map(shlex.quote, ["rtdoctor", "--json", "-q", "--timeout", "5"] + words))
        out, err = self.shell(list(first) + [line], settings)
        return [finding.Finding(**json.loads(each)) for each in out.splitlines() if each.startswith("{")], err

    def has(self, findings, wanted):
        """Is it still found? In other words, too: what died may leave its port to another process meanwhile.
        """
        return any(each[1:3] == wanted[1:3] and each.remedy == wanted.remedy for each in findings)

    def follow(self, name):
        if "unmount" in FAULTS[name].mends and mounts.refused():
            self.skipTest("nothing can be mounted here: " + mounts.refused())
        fault = FAULTS[name]
        rest = list(FAULTS[name].mends)
        number = list(FAULTS).index(name)
        server = self.around.name_server("names%d" % number)
        for words in fault.worlds:
            started = self.around.world(server, *words.split())
        for words in fault.asks:
            self.around.ctl(started, *words.split())
        settings = dict({"RTCTREE_NAMESERVERS": server[1:]}, **fault.settings)
        self.shell([line.format(server) for line in fault.before], settings)
        doctor = [word.format(server) for word in fault.doctor]
        seen, _ = self.examined(doctor, settings)
        # a profile knows more than states as such
        for each in sorted(seen, key=lambda each: each.check != "profile"):
            if is_command(each.remedy):
                self.assertTrue(named(each.remedy), each.remedy)
                rest = self.obey(each, fault, doctor, settings, server, rest)
        self.assertEqual(rest, [], "remedies that were to come: %s" % (seen,))

    def obey(self, each, fault, doctor, settings, server, rest):
        """Follow the remedy of one Finding; returns those remedies that are still to come."""
        now, _ = self.examined(doctor, settings)
        if not self.has(now, each):  # mended with another one
            return rest
        which = [name for name in named(each.remedy) if name in fault.mends]
        self.assertTrue(which, "not expected of this fault: %s" % (each,))
        before = facts(server)
        end = time.monotonic() + worlds.LIMIT
        left, err = self.examined(doctor, settings, [each.remedy])
        # components change their states in their next cycles
        while self.has(left, each) and time.monotonic() < end:
            left, _ = self.examined(
                doctor, settings, [each.remedy] if each.remedy.startswith("unset") else []
            )
        self.assertFalse(self.has(left, each), "left: %s\n%s" % (left, err))
        allowed = [pattern.partition(" ") for name in which for pattern in fault.mends[name]]
        for fact in changed(before, facts(server)):
            self.assertTrue(
                any(
                    fact.startswith(kind + " ") and re.search(r"/%s\b" % what, fact)
                    for kind, _, what in allowed
                ),
                "%s: %s has changed" % (each.remedy, fact),
            )
        for name in which:
            Following.followed[name] += 1
        return [name for name in rest if name not in which]


def _test(name):
    return lambda self: self.follow(name)


for _name in FAULTS:
    setattr(Following, "test_" + re.sub(r"\W", "_", _name), _test(_name))


# ---- what a message asks whether it was meant ----

MISSPELT = (
    "rtcat {}/test.host_cxt/Moto0.rtc",
    "rtcat {}/Motor0.rtc",
    "rtconf {}/test.host_cxt/Motor0.rtc get motor_i",
    "rtconf {}/test.host_cxt/Motor0.rtc lst",
    "rtcon --dry-run -p buffer.lenght=2 {0}/test.host_cxt/Sensor0.rtc:out {0}/test.host_cxt/Motor0.rtc:in",
)
MEANT = re.compile(
    r"rt\w+: (?:(\S+): no such path|(?:\S+: )?(?:no such [a-z ]+: )?(\S+?)(?:: no such property)?)"
    r"; did you mean (\S+)\?"
)


class Misspelt(unittest.TestCase):
    def test_what_is_meant_is_there(self):
        """The word is put in the place of the wrong one, and the line no longer fails by it."""
        worlds.processes.nameserver.binary() or self.skipTest("needs omniNames")
        around = running.Surroundings()
        self.addCleanup(around.close)
        server = around.name_server("misspelt")
        around.world(server, "robot")
        for line in MISSPELT:
            with self.subTest(line):
                words = line.format(server).split()
                found = MEANT.match(self.said(around, words))
                self.assertTrue(found, "nothing is meant")
                path, wrong, meant = found.groups()
                if path:
                    wrong, meant = path, path.rpartition("/")[0] + "/" + meant
                corrected = " ".join(words).replace(wrong, meant).split()
                self.assertNotIn("no such", self.said(around, corrected))

    def said(self, around, words):
        """What a command says on stderr."""
        program = [sys.executable, os.path.join(worlds.COMMANDS, words[0])]
        done = subprocess.run(program + words[1:], cwd=around.top, env=running.environment(),
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              timeout=running.LIMIT)
        return done.stderr.decode()


class Table(unittest.TestCase):
    def test_every_command_is_the_remedy_of_a_fault(self):
        self.assertEqual(
            set(remedies.COMMANDS) - {name for fault in FAULTS.values() for name in fault.mends}, set()
        )

    def test_the_first_word_tells_commands_from_words(self):
        for name, template in remedies.COMMANDS.items():
            self.assertIn(template.split(" ")[0], PROGRAMS, name)
        for name, template in remedies.WORDS.items():
            self.assertNotIn(template.split(" ")[0], PROGRAMS, name)

    def test_no_remedy_is_printed_that_is_not_in_the_table(self):
        self.assertRaises(AttributeError, finding.fail, "check", "/x", "message", "rtdel /x")
        self.assertRaises(AttributeError, finding.warn, "check", "/x", "message", "restart it")

    def test_every_remedy_is_used(self):
        directory = os.path.dirname(remedies.__file__)
        source = ""
        for name in os.listdir(directory):
            if name.endswith(".py"):
                with open(os.path.join(directory, name), encoding="utf-8") as file:
                    source += file.read()
        for name in list(remedies.COMMANDS) + list(remedies.WORDS):
            self.assertGreater(source.count('"%s"' % name), 1, name)

    def test_words_of_the_shell_are_quoted(self):
        where = path.parse("/localhost/a$(b) c.rtc")
        self.assertEqual(
            remedies.command("reset", option=["-e", "1"], path=where).text,
            "rtreset -e 1 '/localhost/a$(b) c.rtc'",
        )
        self.assertEqual(
            remedies.command("reset", option=[], path="/localhost/a.rtc").text, "rtreset /localhost/a.rtc"
        )


if __name__ == "__main__":
    unittest.main()
