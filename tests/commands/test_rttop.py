"""rttop's live page in a real terminal (tmux): if one of these fails, it shows or does what it should not, or
harms a terminal.
"""
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import processes
import running
import worlds
from worlds import Server, World, eventually

ONCE = "a terminal is the same for every Python"
COMMANDS = os.path.dirname(shutil.which("rttop") or os.path.join(processes.ROOT, "bin", "rttop"))

# A page whose drawing fails, as a bug of ours would make it
BROKEN = """
from rtshell_lite import cli
from rtshell_lite.shell import installation
from rtshell_lite.top import rows
module = installation.load(installation.commands()["rttop"], "rttop")
rows.summary = None
cli.main(module.arguments, module.run, module.__doc__, [])
"""


def setUpModule():
    if not shutil.which("tmux"):
        raise unittest.SkipTest("needs tmux")
    worlds.start_name_server()
    World.robot = World("robot")
    World.error = World("error")
    World.hung = World("hung", "1", "--context", "hung.host_cxt/%n.rtc")


def tearDownModule():
    for world in World.robot, World.error, World.hung:
        world.close()
    Server.stop()


class Terminal(unittest.TestCase):
    """A shell in a tmux of its own, 80 by 24."""

    def setUp(self):
        self.home = os.path.realpath(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.home)
        self.top = "/localhost:%d/test.host_cxt" % Server.port
        environment = dict(
            worlds.ENVIRONMENT,
            PATH=COMMANDS + os.pathsep + os.environ["PATH"],
            HOME=self.home,
            LC_ALL="C.UTF-8",
            RTCTREE_NAMESERVERS="localhost:%d" % Server.port,
            RTCSH_CWD=self.top,
            RTSHELL_TIMEOUT="1",
        )
        for name in "TMUX", "ENV", "NO_COLOR", "LINES", "COLUMNS":
            environment.pop(name, None)
        self.tmux("-f", "/dev/null", "-u", "new-session", "-d", "-x", "80", "-y", "24", "sh", env=environment)
        self.addCleanup(self.tmux, "kill-server")
        self.shows("^[$#]")
        self.type("stty -g > before; echo ready")
        self.shows("^ready")

    def tmux(self, *words, **more):
        done = subprocess.run(
            ["tmux", "-S", os.path.join(self.home, "tmux")] + list(words),
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            universal_newlines=True,
            cwd=self.home,
            **more
        )
        return done.stdout

    def type(self, line):
        """Type a line, and Enter."""
        self.tmux("send-keys", "-l", line)
        self.press("Enter")

    def press(self, *keys):
        self.tmux("send-keys", *keys)

    def screen(self):
        return self.tmux("capture-pane", "-p")

    def shows(self, pattern, without=None):
        """Wait until the terminal shows a line that matches, and none that matches `without`; returns the
        whole screen.
        """
        end = time.monotonic() + worlds.LIMIT
        while True:
            screen = self.screen()
            if re.search(pattern, screen, re.MULTILINE) and not (
                without and re.search(without, screen, re.MULTILINE)
            ):
                return screen
            self.assertLess(
                time.monotonic(), end, "no %s, or still %s, here:\n%s" % (pattern, without, screen)
            )
            time.sleep(0.05)

    def start(self, words=""):
        """Start rttop, and wait for its page."""
        self.type("clear; rttop %s; echo status $?" % words)
        self.shows("^STATE +RATE .*CONN +COMPONENT")

    def pid(self):
        """The process in the foreground of the terminal."""
        shell = self.tmux("display-message", "-p", "#{pane_pid}").strip()
        with open("/proc/%s/task/%s/children" % (shell, shell)) as file:
            return int(file.read().split()[-1])

    def ended(self, status):
        """rttop has ended, with this status, and has not harmed the terminal."""
        screen = self.shows("^status")
        self.assertRegex(screen, "(?m)^status %d$" % status)
        self.unharmed()

    def unharmed(self):
        """The terminal is as it was before."""
        self.type("clear; stty -g > after; cmp before after && echo same")
        self.shows("^same")
        self.assertEqual(
            self.tmux("display-message", "-p", "#{alternate_on} #{cursor_flag} #{keypad_flag}"), "0 1 0\n"
        )

    def connectors(self, component="Sensor0:out"):
        return World.robot.ctl("connectors", component)


class Page(Terminal):
    def test_it_shows_and_sorts_and_filters(self):
        self.start()
        self.shows("^9 components: 1 Error, 1 silent, 7 Inactive$")
        screen = self.shows(r"^Inactive      1000     2  Motor0\.rtc$")
        self.assertRegex(screen, r"(?m)^\? +- +- +\?Mock0\.rtc: no answer within 1s$")
        self.assertRegex(screen, r"(?m)^\? keys  q end .*c cat$")
        names = re.findall(r"\?*(\w+)\.rtc", screen)
        self.assertEqual(
            names[:2] + sorted(names[2:]), ["Broken0", "Mock0"] + names[2:], "trouble comes first"
        )
        self.tmux("pipe-pane", "-o", "cat > sent")
        before = World.robot.count("get_component_state")
        eventually(
            lambda: World.robot.count("get_component_state") > before + 3 * len(names),
            "some looks, which find nothing new",
        )
        self.tmux("pipe-pane")
        self.assertLess(
            os.path.getsize(os.path.join(self.home, "sent")), 20, "what has not changed is not sent again"
        )
        self.press("s")
        self.shows("^sorted by name$")
        names = re.findall(r"\?*(\w+)\.rtc", self.screen())
        self.assertEqual(names, sorted(names))
        self.press("s")
        self.shows("^sorted by state$")
        self.assertEqual(
            re.findall(r"^(\S+) .*\.rtc", self.screen(), re.MULTILINE), ["Error", "?"] + 7 * ["Inactive"]
        )
        self.press("/")
        self.tmux("send-keys", "-l", "ensorx")
        self.press("BSpace")
        self.shows("^/ensor_$", without="Motor0")
        self.press("Enter")
        screen = self.shows("7 Inactive; 1 with: ensor$", without="^/")
        self.assertEqual(re.findall(r"(\w+)\.rtc", screen), ["Sensor0"])
        self.press("Escape")
        self.shows("Motor0")
        self.press("/", "a")
        self.shows("^/a_$")
        self.press("Escape")  # and wait: together with the next key it could mean a third one
        self.shows("Motor0", without="^/")
        self.press("?")
        self.shows("^a y +activate the selected component, as rtact does$", without="Motor0")
        self.press("q")
        self.shows("Motor0")
        self.press("q")
        self.ended(0)

    def test_it_acts_on_the_selected_one(self):
        self.start("-f motor")
        self.shows(r"^Inactive .*Motor0\.rtc")
        self.press("a")
        self.shows(r"^activate Motor0\.rtc\? y/N$")
        self.press("n", "a", "y")
        self.shows("^rtact: %s/Motor0.rtc: accepted$" % self.top)
        self.shows(r"^Active .*Motor0\.rtc")
        self.press("r", "y")  # what the component says to that is shown as rtreset shows it
        self.shows(r"^rtreset: .*/Motor0\.rtc: cannot reset: it is")
        self.press("i", "y")
        self.shows("^rtdeact: %s/Motor0.rtc: accepted$" % self.top)
        self.press("c")
        self.shows("^  Instance name  Motor0$", without="^Inactive")
        self.press("NPage", "End")
        self.shows(r"Connected to  .*Sensor0\.rtc:in", without="Instance name")
        self.press("Home", "Enter", "Escape")
        self.shows("Broken0")
        self.press("Home", "Down", "k", "a", "y")
        self.shows(r"^rtact: .*/Broken0\.rtc: cannot activate: it is in")
        self.addCleanup(World.error.ctl, "error", "Broken0")
        self.press("j", "j", "Up", "k", "r", "y")
        self.shows(r"^rtreset: .*/Broken0\.rtc: accepted")
        self.press("End", "k", "k", "k", "k", "PPage", "/", "h", "u", "n", "g", "Enter", "a", "y")
        self.shows(r"^rtact: .*/Mock0\.rtc: no answer within 1s")
        self.press("q")
        self.ended(0)

    def test_wide_pages_say_where_and_since_when(self):
        self.tmux("resize-window", "-x", "200", "-y", "60")
        self.start()
        self.shows(r"^STATE +RATE +MEASURED +VALUES/S +CONN +COMPONENT +DIRECTORY +SINCE +LAST EVENT")
        self.shows(r"^\? +- +- +- +- +\?Mock0\.rtc +hung\.host_cxt +- +no answer within 1s")
        self.type("/motor")
        self.shows("1 with: motor")
        self.press("a", "y")
        self.shows(r"^Active +1000 +- +- +2 +Motor0\.rtc +\S+/test\.host_cxt +\d+s +Inactive to Active")
        self.press("i", "y")
        self.shows(r"Motor0\.rtc +\S+/test\.host_cxt +\d+s +Active to Inactive")
        self.press("q")
        self.ended(0)

    def test_groups_and_neighbours(self):
        self.start()
        self.press("g")
        self.shows("^/localhost:\\d+/hung.host_cxt: 1 component: 1 silent")
        self.assertRegex(
            self.screen(),
            r"(?m)^/localhost:\d+/test.host_cxt: 8 components: 1 Error, 7 Inactive\n.*\bBroken0",
        )
        self.press("g", "g")
        self.shows("^grouped by none$", without="hung.host_cxt: ")
        self.type("/motor")
        self.shows("1 with: motor")
        self.press("n")
        self.shows("^2 connected with .*Motor0.rtc; Esc shows all$")
        screen = self.shows(r"Sensor0\.rtc", without="Clusterer0")
        self.assertEqual(
            re.findall(r"(\w+)\.rtc$", screen, re.MULTILINE), ["Controller0", "Motor0", "Sensor0"]
        )
        self.press("Escape")
        self.shows("Clusterer0")
        self.press("q")
        self.ended(0)

    def test_doctor_and_rates_of_the_selected_one(self):
        self.start("-f broken")
        self.shows(r"^Error .*Broken0\.rtc")
        self.press("d")
        self.shows(r"^fail  .*/Broken0\.rtc: .*Error", without="CONN")
        self.press("q")
        self.shows(r"^Error .*Broken0\.rtc")
        self.press("m")
        self.shows(r"^ +0\.0 Hz  .*/Broken0\.rtc:|^it has no out port$")
        self.press("q", "q")
        self.ended(0)

    def test_measured_rates_are_beside_claimed_ones(self):
        senders = World("senders", "50", "8")
        self.addCleanup(running.run, ["rtdel", self.top + "/Source0.rtc"], self.home)
        self.addCleanup(senders.close)
        self.tmux("resize-window", "-x", "200", "-y", "60")
        self.start()
        self.shows(r"^Active +50 +- +- +0 +Source0\.rtc")
        self.press("M")
        found = self.shows(r"^Active +50 +\d+\.\d +\d+\.\d +\d +Source0\.rtc")
        claimed, measured, values = re.search(r"Active +(\d+) +(\S+) +(\S+) .*Source0", found).groups()
        self.assertTrue(0 < float(measured) < float(values), found)
        self.shows(r"^Inactive +1000 +0\.0 +0\.0 +2 +Motor0\.rtc")
        eventually(
            lambda: senders.ctl("connectors", "Source0:number").count("\n") == 0, "it has disconnected"
        )
        self.press("q")
        self.ended(0)

    def test_plots_of_ports(self):
        senders = World("senders", "50", "8")
        self.addCleanup(running.run, ["rtdel", self.top + "/Source0.rtc"], self.home)
        self.addCleanup(senders.close)
        self.start("-f source")
        self.shows(r"^Active .*Source0\.rtc")
        self.press("p")
        self.shows(r"/Source0\.rtc:(number|block)$", without="CONN")
        self.shows("[\u2801-\u28ff]")
        self.assertEqual(senders.ctl("connectors", "Source0:number").count("\n") +
                         senders.ctl("connectors", "Source0:block").count("\n"), 1)
        first = re.search(r"/Source0\.rtc:(\w+)", self.screen()).group(1)
        self.press("p")
        self.shows(r"/Source0\.rtc:%s$" % {"number": "block", "block": "number"}[first], without=first)
        self.press("q")
        self.shows(r"^Active .*Source0\.rtc")
        for port in "number", "block":
            eventually(
                lambda: senders.ctl("connectors", "Source0:" + port).count("\n") == 0, "it has disconnected"
            )
        self.press("p")
        self.shows("[\u2801-\u28ff]")
        self.press("C-c")
        self.ended(130)
        for port in "number", "block":
            self.assertEqual(senders.ctl("connectors", "Source0:" + port).count("\n"), 0)

    def test_a_component_in_the_context_of_another_one(self):
        for words in (
            ["rtec", "Sensor0.rtc", "attach", "Motor0.rtc"],
            ["rtact", "-e", "1", "--wait", "Motor0.rtc"],
        ):
            self.type(" ".join(words))
        self.addCleanup(self.type, "rtec Sensor0.rtc detach Motor0.rtc")
        self.start("-f motor")
        self.shows(r"^Active .*Motor0\.rtc")
        self.press("i", "y")
        self.shows("^rtdeact: %s/Motor0.rtc: accepted$" % self.top)
        self.shows(r"^Inactive .*Motor0\.rtc")
        self.press("q")
        self.ended(0)

    def test_a_paste_is_not_taken_for_keys(self):
        self.start("-f motor")
        self.shows(r"^Inactive .*Motor0\.rtc")
        self.tmux("set-buffer", "aysq\ndyq")
        self.tmux("paste-buffer", "-p")
        self.shows("^pasted text is not read as keys$")
        self.press("a")
        self.shows(r"^activate Motor0\.rtc\? y/N$")
        self.tmux("set-buffer", "y")
        self.tmux("paste-buffer", "-p")
        self.shows(r"^\? keys", without="y/N")
        self.press("/", "BSpace")
        self.shows("^/moto_$")
        self.tmux("set-buffer", "r0\n")
        self.tmux("paste-buffer", "-p")
        self.shows("^/motor0_$")
        self.press("Enter")
        self.shows("; 1 with: motor0$")
        self.press("Escape")
        self.shows("Broken0")
        self.press("q")
        self.ended(0)
        self.assertEqual(World.robot.ctl("state", "Motor0").split()[-1:], ["INACTIVE"])

    def test_ports_are_measured_until_the_end(self):
        self.start("-p Sensor0.rtc:out -p Sensor0.rtc:in -p nobody.rtc:out")
        screen = self.shows(r"^ +0\.0 Hz +0 B/s  .*/Sensor0\.rtc:out$")
        self.assertRegex(screen, r"(?m)^ +\? Hz +\?  .*/Sensor0\.rtc:in: not a")
        self.assertRegex(screen, r"(?m)^ +\? Hz +\?  .*/nobody\.rtc: no such")
        World.robot.ctl("write", "Sensor0:out", "1")
        self.assertEqual(self.connectors().count("\n"), 2)
        self.press("q")
        self.ended(0)
        self.assertEqual(self.connectors().count("\n"), 1)

    def test_terminals_of_other_sizes(self):
        self.start()
        self.tmux("resize-window", "-x", "40", "-y", "6")
        screen = self.shows("^9 components: 1 Error, 1 silent, 7 Inact$", without="Motor0")
        self.assertLessEqual(len(screen.split("\n")), 7)
        self.press("End")
        self.shows("Sensor0", without="Broken0")
        self.press("c")
        self.shows("^Sensor0.rtc  Inactive")
        self.press("PageDown", "q")
        self.tmux("resize-window", "-x", "1", "-y", "1")
        self.tmux("resize-window", "-x", "120", "-y", "40")
        self.shows(r"^9 components: 1 Error, 1 silent, 7 Inactive; below /localhost:\d+/$")
        self.press("q")
        self.ended(0)

    def test_components_that_die_and_come_cost_their_line(self):
        self.start("-p Late0.rtc:out")
        self.shows("^9 components")
        world = World("these", "ConsoleIn:Late0")
        try:
            self.shows(r"^Inactive +1000 +0  Late0\.rtc")
        finally:
            world.close()
        self.shows(r"^- +- +- +\*Late0\.rtc: connection refused; its process is gone")
        self.shows(r"^Inactive .*Motor0\.rtc")
        self.press("q")
        self.ended(0)
        self.type("rtdel Late0.rtc; echo gone")
        self.shows("^gone")


class Large(Terminal):
    """Of more than 100 components, those that take observers report what changes, and are hardly asked."""

    def test_what_is_reported_is_not_asked(self):
        world = World("many", "110", "--context", "large.host_cxt/%n.rtc")
        place = "/localhost:%d/large.host_cxt" % Server.port
        self.addCleanup(running.run, ["rtdel", "--recursive", "-f", place], self.home)
        self.addCleanup(world.close)
        names = ["Mock%d" % number for number in range(110)]

        def observers():
            return sum(world.ctl("observers", name).count("Observer") for name in names)

        self.start(place)
        self.shows("^110 components: 110 Inactive$")
        eventually(lambda: observers() == 110, "each component has an observer")
        world.ctl("error", "Mock100")  # it is not shown, and the first that reports
        self.shows(r"^Error .*Mock100\.rtc$")
        world.ctl("reset")
        world.ctl("error", "Mock101")
        self.shows(r"^Error .*Mock101\.rtc$")
        eventually(lambda: "2 get_component_state" in world.ctl("calls", "Mock1"), "what is shown is asked")
        asked = [int(world.ctl("calls", name).partition(" ")[0] or 0) for name in names[50:100]]
        self.assertLess(sum(asked), 60, "as rarely as what is not shown, it would be asked twice")
        self.press("C-c")
        self.ended(130)
        self.assertEqual(observers(), 0)


class End(Terminal):
    """However it ends, the terminal is as it was, and no connection stays."""

    def test_signals(self):
        for number, status in (signal.SIGTERM, 143), (signal.SIGHUP, 129), (signal.SIGINT, 130):
            with self.subTest(number):
                self.start("-p Sensor0.rtc:out")
                os.kill(self.pid(), number)
                self.ended(status)
                self.assertEqual(self.connectors().count("\n"), 1)

    def test_ctrl_c(self):
        self.start()
        self.press("C-c")
        self.ended(130)

    def test_ctrl_z_and_on(self):
        self.start("-f motor")
        self.shows("Motor0")
        self.press("C-z")
        self.shows("Stopped|Suspended", without="Motor0")
        self.unharmed()
        self.type("fg; echo back $?")
        self.shows(r"^Inactive +1000 +2  Motor0\.rtc", without="same")
        self.press("q")
        self.shows("^back 0$", without="Motor0")
        self.unharmed()

    def test_a_terminal_that_is_closed(self):
        self.start("-p Sensor0.rtc:out")
        pid = self.pid()
        self.tmux("kill-session")
        eventually(lambda: not os.path.exists("/proc/%d" % pid), "rttop has ended")
        self.assertEqual(self.connectors().count("\n"), 1)

    def test_marks_of_rtkeep(self):
        """What a running rtkeep says of a component is beside what has changed."""
        world = World(
            "these", "Motor:Kept0", "ConsoleIn:Left0", "ConsoleIn:Free0", "--context", "kept.host_cxt/%n.rtc"
        )
        names = [
            "/localhost:%d/kept.host_cxt/%s.rtc" % (Server.port, name) for name in ("Kept0", "Left0", "Free0")
        ]
        self.addCleanup(running.run, ["rtdel"] + names, self.home)
        self.addCleanup(world.close)
        self.tmux("resize-window", "-x", "160", "-y", "40")
        place = "/localhost:%d/kept.host_cxt" % Server.port
        more = {"XDG_RUNTIME_DIR": self.home}
        done = running.run(
            ["rtcryo", "--all", "-o", "a.xml", place + "/Kept0.rtc", place + "/Left0.rtc"], self.home
        )
        self.assertEqual(done.status, 0, done)
        keeping = running.start(["rtkeep", "a.xml"], self.home, more, stdout=subprocess.DEVNULL)
        self.addCleanup(keeping.wait)
        self.addCleanup(keeping.kill)
        self.type("export XDG_RUNTIME_DIR=$HOME")
        self.start(place)
        self.shows(r"Kept0\.rtc .*rtkeep: kept", without=r"Free0\.rtc .*rtkeep")
        self.assertEqual(running.run(["rtkeep", "pause", "Kept0"], self.home, **more).status, 0)
        self.assertEqual(running.run(["rtdeact", place + "/Left0.rtc"], self.home).status, 0)
        self.shows(r"Kept0\.rtc .*rtkeep: paused")
        self.shows(r"Left0\.rtc .*rtkeep: left alone")
        keeping.terminate()
        self.shows(r"Kept0\.rtc", without="rtkeep")
        self.press("q")
        self.ended(0)

    def test_a_bug_of_ours(self):
        with open(os.path.join(self.home, "broken.py"), "w") as file:
            file.write(BROKEN)
        self.type("clear; python3 broken.py; echo status $?")
        self.assertRegex(self.shows("^status"), "internal error: TypeError")
        self.ended(70)

    def test_in_rtsh(self):
        self.type("rtsh; echo status $?")
        self.shows("host_cxt>$")
        for _ in range(2):
            self.type("top -f motor")
            self.shows(r"^Inactive .*Motor0\.rtc")
            self.tmux("resize-window", "-x", "60", "-y", "12")
            self.shows(r"\A9 components")
            self.tmux("resize-window", "-x", "80", "-y", "24")
            self.press("q")
            self.shows("host_cxt>$", without="Motor0")
        self.press("C-d")
        self.ended(0)


if __name__ == "__main__":
    unittest.main()
