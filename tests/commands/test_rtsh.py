"""rtsh on a terminal: completion, history, Ctrl-C."""
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import tempfile
import termios
import time
import unittest

import processes
import worlds
from worlds import Server, World

COMMANDS = os.path.dirname(shutil.which("rtsh") or os.path.join(processes.ROOT, "bin", "rtsh"))
BOTH = "each ORB keeps its connections in its own way"
UP, CTRL_C, CTRL_D = "\x1b[A", "\x03", "\x04"


def setUpModule():
    worlds.start_name_server()
    World.one = World("these", "ConsoleIn:ConsoleIn0", "ConsoleOut:ConsoleOut0", "ConfigSample:ConfigSample0")


def tearDownModule():
    World.one.close()
    Server.stop()


def environment(**more):
    """What rtsh runs in."""
    usual = dict(
        worlds.ENVIRONMENT,
        PATH=COMMANDS + os.pathsep + os.environ["PATH"],
        TERM="dumb",
        LC_ALL="C.UTF-8",
        RTCTREE_NAMESERVERS="localhost:%d" % Server.port,
        RTCSH_CWD="/localhost:%d/test.host_cxt" % Server.port,
    )
    return dict(usual, **more)


class Many(unittest.TestCase):
    def test_a_hundred_commands_are_one_process_with_few_connections(self):
        """python3 -m tests.bench sessions compares their cost with that of separate processes."""
        session = subprocess.Popen(["rtsh"], env=environment(), stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   universal_newlines=True)
        self.addCleanup(session.communicate)
        session.stdin.write("ls -l\n" * 10 + "pwd\n")
        session.stdin.flush()
        self.until_pwd(session)
        before = held(session.pid)
        session.stdin.write("ls -l\n" * 90 + "pwd\n")
        session.stdin.flush()
        self.assertEqual(self.until_pwd(session), 90 * 3)
        after = held(session.pid)
        self.assertLessEqual(before, after)  # none was closed
        self.assertLess(len(after), 20)      # four calls at a time to each of two processes, and Python's own
        with open("/proc/%d/task/%d/children" % (session.pid, session.pid)) as file:
            self.assertEqual(file.read(), "")

    def until_pwd(self, session):
        """How many lines rtsh prints before the directory."""
        for count, line in enumerate(session.stdout):
            if line.endswith("/test.host_cxt\n"):
                return count
        return None


def held(pid):
    """What the open descriptors of a process lead to; each socket has its own number."""
    directory = "/proc/%d/fd" % pid
    return {os.readlink(os.path.join(directory, name)) for name in os.listdir(directory)}


class AtThePrompt(unittest.TestCase):
    def setUp(self):
        self.home = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.home)
        self.start()

    def start(self, **more):
        """Start rtsh on a terminal of its own, and wait for its prompt."""
        variables = environment(HOME=self.home, **more)
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.execvpe("rtsh", ["rtsh"], variables)
        self.screen = ""
        self.ended = False
        self.addCleanup(self.end)
        self.shows(r"test\.host_cxt> ")

    def end(self):
        if not self.ended:
            os.kill(self.pid, 9)
            os.waitpid(self.pid, 0)
        self.ended = True

    def press(self, keys):
        """Press keys, and forget what the terminal showed before."""
        self.screen = ""
        os.write(self.terminal, keys if isinstance(keys, bytes) else keys.encode())

    def shows(self, pattern, again=""):
        """Wait until the terminal shows something that matches; press keys `again` while it shows nothing."""
        end = time.monotonic() + worlds.LIMIT
        while not re.search(pattern, self.screen.replace("\r", "")):
            self.assertLess(time.monotonic(), end, "no %s here:\n%s" % (pattern, self.screen))
            self.read()
            if not self.screen:
                os.write(self.terminal, again.encode())

    def read(self):
        if select.select([self.terminal], [], [], 0.05)[0]:
            try:
                self.screen += os.read(self.terminal, 65536).decode("utf-8", "replace")
            except OSError:  # how Linux says that the other side is closed
                time.sleep(0.01)

    def status(self, signals=()):
        """The exit status of rtsh, once it has ended; sent these signals until then."""
        end = time.monotonic() + worlds.LIMIT
        while True:
            for number in signals:
                os.kill(self.pid, number)
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                self.ended = True
                return os.WEXITSTATUS(status) if os.WIFEXITED(status) else -os.WTERMSIG(status)
            self.assertLess(time.monotonic(), end, "rtsh does not end:\n%s" % self.screen)
            self.read()  # readline waits until its last output is read

    def test_commands_and_the_working_directory(self):
        self.press("ls\r")
        self.shows(r"ConsoleIn0\.rtc +ConsoleOut0\.rtc\n(.*\n)*rtsh .*> $")
        self.press("cd ..; pwd\r")
        self.shows(r"\n/localhost:\d+\nrtsh /localhost:\d+> $")
        self.press("frob\r")
        self.shows(r"rtsh: frob: no such command\nrtsh .*> $")
        self.press("exit 3\r")
        self.assertEqual(self.status(), 3)

    def test_completion(self):
        for keys, wanted in [
            ("rtc\t\t", r"rtcall .*rtcheck "),
            ("\x15l\t\t", "log +ls"),
            ("\x15cat ConsoleO\t", r"cat ConsoleOut0\.rtc$"),
            (":\t", r":in "),
            ("\x15pwd; print ConsoleI\t", r"print ConsoleIn0\.rtc:$"),
            ("\x15ls --rec\t", "--recurse "),
            ("\x15conf ConfigSample0.rtc g\t", "rtc get "),
            ("\x15rtact Conf\t", r"ConfigSample0\.rtc "),
        ]:
            with self.subTest(keys):
                self.press(keys)
                self.shows(wanted)

    def test_ctrl_c_ends_the_command_or_the_line_and_nothing_else(self):
        self.press("find . -n nobody --wait 60\r")
        self.shows("60\n")
        self.press(CTRL_C)
        self.shows(r"\nrtsh .*> $")  # "^C" is shown only once readline has given the terminal back
        self.press("rubbish")
        self.shows("rubbish")
        self.press(CTRL_C)
        # one that comes just before Python waits for keys is seen at the next
        self.shows(r"\nrtsh .*> $", again=CTRL_C)
        self.press("pwd\r")
        self.shows(r"\n/localhost:\d+/test\.host_cxt\nrtsh .*> $")
        self.press(CTRL_D)
        self.assertEqual(self.status(), 0)

    def test_ctrl_c_leaves_nothing_behind(self):
        """No connection in a component, and no reader that takes the next line for a value."""
        self.press("print ConsoleIn0.rtc:out\r")
        worlds.eventually(lambda: World.one.ctl("connectors", "ConsoleIn0:out"), "a connection")
        self.press(CTRL_C)
        self.shows(r"\nrtsh .*> $")
        self.assertEqual(World.one.ctl("connectors", "ConsoleIn0:out"), "")
        self.press("inject --anyway ConsoleOut0.rtc:in\r")
        worlds.eventually(lambda: World.one.ctl("connectors", "ConsoleOut0:in"), "a connection")
        self.press("42\r")
        worlds.eventually(lambda: World.one.count("put"), "a value")
        self.press(CTRL_C)
        self.shows(r"\nrtsh .*> $")
        self.assertEqual(World.one.ctl("connectors", "ConsoleOut0:in"), "")
        for _ in range(2):
            self.press("pwd\r")
            self.shows(r"\n/localhost:\d+/test\.host_cxt\nrtsh .*> $")

    def test_kill(self):
        """The terminal is as it was, and what was typed is in the history."""
        self.press("pwd\r")
        self.shows(r"\n/localhost:\d+/test\.host_cxt\nrtsh .*> $")
        self.press("rubbish")
        self.shows("rubbish")
        # More than one: that which comes just before Python waits for keys is seen at the next.
        self.assertEqual(self.status([signal.SIGTERM]), 128 + signal.SIGTERM)
        modes = termios.tcgetattr(self.terminal)[3]
        self.assertTrue(modes & termios.ECHO and modes & termios.ICANON)
        self.assertEqual(os.listdir(self.home), [".rtsh_history"])

    def test_bytes_that_are_no_text(self):
        self.end()
        self.start(PYTHONIOENCODING="utf-8:strict")  # as in a locale of Japan
        self.press(b"ls \xff\xfe\r")
        self.shows(r"/\\xff\\xfe: no such path\nrtsh .*> $")
        self.press(CTRL_D)
        self.assertEqual(self.status(), 3)

    def test_the_history_is_there_the_next_time(self):
        self.press("ls nowhere\r")
        self.shows(r"no such path; .*\nrtsh .*> $")
        self.press(CTRL_D)
        self.assertEqual(self.status(), 3)
        self.assertEqual(os.listdir(self.home), [".rtsh_history"])
        self.start()
        self.press(UP)
        self.shows("ls nowhere")

    def test_a_home_that_does_not_exist(self):
        shutil.rmtree(self.home)
        try:
            self.press("pwd\r")
            self.shows(r"\n/localhost.*\nrtsh .*> $")
            self.press(CTRL_D)
            self.assertEqual(self.status(), 0)
        finally:
            os.mkdir(self.home)


if __name__ == "__main__":
    unittest.main()
