"""TAB in the user's shell: if one of these fails, an operator gets wrong names, none, or a shell that hangs.
"""
import os
import pty
import re
import select
import shutil
import socket
import subprocess
import tempfile
import time
import unittest

import worlds
from worlds import Server, World

from rtshell_lite import path
from rtshell_lite.corba import orb

HOSTILE = [
    "$(touch canary)",
    "`touch canary`",
    ";touch canary;",
    "q\"uo'te !",
    "a&&touch canary",
    "w*?~[a]",
    "日本 語",
    "=ls",
    "~root",
    "#no",
    "{a,b}",
    "-e",
    "b\\$x",
    "co:lon",
    "new\nline",
    "sl/ash",
    "e\x1b[31m",
    "two words\\",
]
ONCE = "three shells are tried: one Python is enough"

# How each shell starts, without the user's own files; the key Ctrl-G writes down the line as it is then.
SHELLS = {
    "bash": (["bash", "--norc", "--noprofile", "-i"],
             "eval \"$(rtcwd --shell bash)\"; bind -x '\"\\C-g\": printf %s \"$READLINE_LINE\" >line; "
             "mv line shown'"),
    "zsh": (["zsh", "-f", "-i"],
            "eval \"$(rtcwd --shell zsh)\"; show() { print -rn -- \"$BUFFER\" >line; mv line shown }; zle "
            "-N show; bindkey '^G' show; bindkey -e '^U' kill-whole-line; bindkey '^G' show"),
    "fish": (["fish", "--no-config", "-i"],
             "rtcwd --shell fish | source; function show; commandline >line; mv line shown; end; bind "
             "\\cg show; bind \\cu 'commandline \"\"'"),
}


def setUpModule():
    worlds.start_name_server()
    World.one = World(
        "these",
        "ConsoleIn:ConsoleIn0",
        "ConsoleOut:ConsoleOut0",
        "Sensor:Sensor0",
        "ConfigSample:ConfigSample0",
        "MyServiceProvider:MyServiceProvider0",
    )
    World.manager = World("manager", "ConsoleIn")
    World.one.resolve().bind(orb.naming_name([("odd", "thing")]), World.one.resolve("ConsoleIn0.rtc"))
    hostile = World.one.resolve().bind_new_context(orb.naming_name([("hostile", "cxt")]))
    for name in HOSTILE:
        hostile.bind_new_context(orb.naming_name([(name, "x")]))


def tearDownModule():
    World.one.close()
    World.manager.close()
    Server.stop()


def environment(home):
    """What a user has: commands on PATH, a name server, a working directory."""
    return dict(
        worlds.ENVIRONMENT,
        PATH=worlds.COMMANDS + os.pathsep + os.environ["PATH"],
        HOME=home,
        TERM="dumb",
        LC_ALL="C.UTF-8",
        RTCTREE_NAMESERVERS="localhost:%d" % Server.port,
        RTCSH_CWD="/localhost:%d/test.host_cxt" % Server.port,
        PYTHONDONTWRITEBYTECODE="1",
        HISTFILE=os.path.join(home, "history"),
    )


class Terminal:
    """An interactive shell on a terminal of its own."""

    def __init__(self, name, home):
        words, setup = SHELLS[name]
        self.home = home
        self.said = b""
        self.process = None
        self.master = None
        pid, self.master = pty.fork()
        if pid == 0:
            os.chdir(home)
            os.execvpe(words[0], words, environment(home))
        self.pid = pid
        self.press(" " + setup + "; touch ready\r")
        self.wait_for("ready")

    def press(self, keys):
        os.write(self.master, keys.encode())

    def wait_for(self, name):
        """Wait until the shell has made a file; returns what is in it."""
        path = os.path.join(self.home, name)
        end = time.monotonic() + worlds.LIMIT
        while not os.path.exists(path):
            self.drain(0.01)
            if time.monotonic() > end:
                raise AssertionError(
                    "no %s; the terminal shows:\n%s" % (name, self.said.decode("utf-8", "replace"))
                )
        with open(path, encoding="utf-8") as file:
            found = file.read()
        os.unlink(path)
        return found

    def drain(self, seconds):
        """Read what the shell prints, or it would block."""
        if select.select([self.master], [], [], seconds)[0]:
            try:
                self.said += os.read(self.master, 65536)
            except OSError:
                pass

    def line(self, keys):
        """The line after these keys are pressed on an empty one."""
        self.press("\x15" + keys + "\x07")
        return self.wait_for("shown").rstrip("\n")

    def close(self):
        os.kill(self.pid, 9)
        os.waitpid(self.pid, 0)
        os.close(self.master)


class InShell:
    """What a user types, and the line after TAB."""

    name = None
    special = "$`"  # within double quotes

    @classmethod
    def setUpClass(cls):
        if not shutil.which(cls.name):
            raise unittest.SkipTest("%s is not installed" % cls.name)
        cls.directory = tempfile.mkdtemp()
        cls.terminal = Terminal(cls.name, cls.directory)

    @classmethod
    def tearDownClass(cls):
        cls.terminal.close()
        shutil.rmtree(cls.directory)

    def check(self, typed, wanted):
        typed, wanted = (text.replace("PORT", str(Server.port)) for text in (typed, wanted))
        with self.subTest(typed):
            self.assertEqual(self.terminal.line(typed + "\t"), wanted)

    def test_words_completed_after_tab(self):
        with open(os.path.join(self.directory, "robot one.rtsys"), "w"):
            pass
        for typed, wanted in [
            ("rtls --rec", "rtls --recurse "),
            ("rtpwd --", "rtpwd --"),
            ("rtprint ConsoleOut0.rtc:", "rtprint ConsoleOut0.rtc:"),
            ("rtprint ConsoleIn0.rtc:", "rtprint ConsoleIn0.rtc:out "),
            ("rtinject ConsoleOut0.rtc:", "rtinject ConsoleOut0.rtc:in "),
            ("rtfsm ConsoleIn0.rtc gets", "rtfsm ConsoleIn0.rtc getst"),
            ("rtdoc -f h", "rtdoc -f html "),
            ("rtdoc --format=h", "rtdoc --format=html "),
            ("rtls /", "rtls /localhost:PORT/"),
            ("rtls /localhost:%s" % str(Server.port)[:2], "rtls /localhost:PORT/"),
            ("rtls /localhost:PORT/te", "rtls /localhost:PORT/test.host_cxt/"),
            ("rtact ConsoleIn", "rtact ConsoleIn0.rtc "),
            ("rtact ConsoleIn0.rtc Sens", "rtact ConsoleIn0.rtc Sensor0.rtc "),
            ("rtcat ConsoleIn0.rtc:", "rtcat ConsoleIn0.rtc:out "),
            (
                "rtcat /localhost:PORT/test.host_cxt/ConsoleOut0.rtc:i",
                "rtcat " "/localhost:PORT/test.host_cxt/ConsoleOut0.rtc:in " "",
            ),
            ("rtcon ConsoleOut", "rtcon ConsoleOut0.rtc:"),
            ("rtconf ConfigSample0.rtc d", "rtconf ConfigSample0.rtc d"),
            ("rtconf ConfigSample0.rtc get str_param1", "rtconf ConfigSample0.rtc get str_param1 "),
            ("rtconf ConfigSample0.rtc act def", "rtconf ConfigSample0.rtc act default "),
            ("rtmgr -r ma", "rtmgr -r manager.mgr "),
            ("rtcat odd", "rtcat odd.thing "),
            ("rtcon odd", "rtcon odd"),
            ("rtfind --state err", "rtfind --state error "),
            ("rtfind --state=err", "rtfind --state=error "),
            ("rtcheck -s act", "rtcheck -s active "),
            ("rtls ma", "rtls manager.mgr/"),
            ("rtls manager.mgr/C", "rtls manager.mgr/ConsoleIn0.rtc "),
            ("rtls -- Sens", "rtls -- Sensor0.rtc "),
            ("true; rtls Sens", "true; rtls Sensor0.rtc "),
            ("rtcheck --state Active rob", "rtcheck --state Active robot\\ one.rtsys "),
            ("rtls nothing", "rtls nothing"),
            ("rtls nothing/", "rtls nothing/"),
            ("rtls --nonsense Sens", "rtls --nonsense Sens"),
            ("rtls $HOME/", "rtls $HOME/"),
        ]:
            self.check(typed, wanted)

    def test_properties(self):
        """What follows a complete name, before its value, is each shell's own."""
        said = self.terminal.line("rtcon -p dataport.data_t\t")
        self.assertTrue(re.match(r"rtcon -p dataport\.data_type(\\?= ?)?$", said), said)

    def test_names_that_begin_alike(self):
        self.check("rtls Con", "rtls Con")
        self.check("rtls Conso", "rtls Console")

    def test_names_that_shells_trip_over(self):
        """Completed from their first letters and inside quotes, they stay the same for the shell, and nothing
        is executed.
        """
        before = {name: None for name in os.listdir(self.directory)}
        for name in HOSTILE:
            spelt = str(path.Name(name, "x"))
            for quote, typed in (
                ("", self.typed(spelt)),
                ("'", spelt[0]),
                ('"', "\\" * (spelt[0] in self.special) + spelt[0]),
            ):
                with self.subTest(name, quote=quote):
                    line = self.terminal.line("rtls %shostile.cxt/%s\t" % (quote, typed))
                    line += quote * (not line.endswith(quote))  # bash closes it
                    said = subprocess.run(
                        [self.name, "-c", "printf '%s\\n' " + line[4:].strip()],
                        cwd=self.directory,
                        stdout=subprocess.PIPE,
                        env=environment(self.directory),
                    ).stdout.decode()
                    self.assertEqual(said, "hostile.cxt/%s/\n" % spelt, line)
        self.assertEqual({name: None for name in os.listdir(self.directory)}, before)

    @staticmethod
    def typed(spelt):
        """The first character, quoted as a user would."""
        return spelt[0] if spelt[0].isalnum() or spelt[0] == "-" else "\\" + spelt[0]

    def test_a_name_server_that_hangs(self):
        """The line is there again, unchanged, and no message comes; how soon, rtcwd.t measures."""
        with SilentPort() as port:
            self.terminal.said = b""
            self.check("rtls /localhost:%d/a" % port, "rtls /localhost:%d/a" % port)
            self.assertNotIn(b"answer", self.terminal.said)


class SilentPort:
    """A port that accepts connections and never answers."""

    def __enter__(self):
        self.listener = socket.socket()
        self.listener.bind(("127.0.0.1", 0))
        self.listener.listen(8)
        return self.listener.getsockname()[1]

    def __exit__(self, *_):
        self.listener.close()


class Bash(InShell, unittest.TestCase):
    name = "bash"


class Zsh(InShell, unittest.TestCase):
    name = "zsh"


class Fish(InShell, unittest.TestCase):
    name = "fish"
    special = "$"


if __name__ == "__main__":
    unittest.main()
