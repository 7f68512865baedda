"""Ctrl-C while a peer hangs: every command ends, with status 130 and without output. How soon, the story
interrupt.t shows.
"""
import os
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import unittest

import processes
from rtshell_lite.shell import installation

BOTH = "each ORB is interrupted in its own way"

START_LIMIT = 60.0  # seconds until a command is killed
TIMEOUT = "600"  # seconds for which it would wait for its peer

# What each command is asked; SERVER is a name server that accepts connections and never answers.
COMMANDS = {
    "rtls": ["-lR", "SERVER"],
    "rtcat": ["-ll", "SERVER/a.rtc", "SERVER/b.rtc:in"],
    "rtcwd": ["SERVER/a.cxt"],
    "rtfind": ["SERVER", "--wait", "60", "-n", "a.rtc"],
    "rtact": ["--wait=60", "SERVER/a.rtc"],
    "rtdeact": ["SERVER/a.rtc", "SERVER/b.rtc"],
    "rtreset": ["SERVER/a.rtc"],
    "rtconf": ["SERVER/a.rtc", "set", "a", "1"],
    "rtcon": ["SERVER/a.rtc:out", "SERVER/b.rtc:in"],
    "rtdis": ["SERVER/a.rtc:out", "SERVER/b.rtc:in"],
    "rtdel": ["-z"],
    "rtexit": ["SERVER/a.rtc"],
}


class SilentPeer:
    """Accepts connections and notes when the first request has come; answers nothing."""

    def __enter__(self):
        self.listener = socket.socket()
        self.listener.bind(("127.0.0.1", 0))
        self.listener.listen(16)
        self.listener.settimeout(START_LIMIT)
        self.connection = self.listener  # until there is one
        self.address = "/127.0.0.1:%d" % self.listener.getsockname()[1]
        return self

    def wait_for_request(self):
        self.connection = self.listener.accept()[0]
        self.connection.settimeout(START_LIMIT)
        return self.connection.recv(1)

    def __exit__(self, *_):
        self.listener.close()
        self.connection.close()


class CtrlC(unittest.TestCase):
    """If one of these fails, an operator cannot stop a command that waits for a dead robot."""

    def test_ends_every_command_that_waits_for_a_peer(self):
        for command in sorted(COMMANDS):
            with self.subTest(command), SilentPeer() as peer:
                self.interrupt(
                    [command] + [word.replace("SERVER", peer.address) for word in COMMANDS[command]], peer
                )

    def interrupt(self, words, peer):
        environment = dict(os.environ, PYTHONPATH=os.environ.get("PYTHONPATH") or processes.ROOT,
                           RTCTREE_NAMESERVERS=peer.address[1:])
        process = subprocess.Popen(
            [sys.executable, "-m", "rtshell_lite"] + words + ["--timeout", TIMEOUT],
            env=environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            preexec_fn=hear_ctrl_c,
        )
        killer = threading.Timer(START_LIMIT, process.kill)
        try:
            self.assertTrue(peer.wait_for_request())
            self.assertIsNone(process.poll(), "it did not wait for its peer")
            killer.start()
            process.send_signal(signal.SIGINT)
            out, err = process.communicate()
        finally:
            killer.cancel()
            process.kill()
            process.wait()
            process.stdout.close()
            process.stderr.close()
        self.assertEqual((process.returncode, out, err), (130, b"", b""))

    def test_ends_a_command_amid_its_imports_without_a_traceback(self):
        with tempfile.TemporaryDirectory() as directory:
            with open(os.path.join(directory, "argparse.py"), "w") as file:
                file.write("import os, signal\nos.kill(os.getpid(), signal.SIGINT)\n")
            path = os.pathsep.join([directory, os.environ.get("PYTHONPATH") or processes.ROOT])
            ran = subprocess.run(
                [sys.executable, "-m", "rtshell_lite", "rtpwd"],
                env=dict(os.environ, PYTHONPATH=path),
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                preexec_fn=hear_ctrl_c,
                timeout=START_LIMIT,
            )
        self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (-signal.SIGINT, b"", b""))

    def test_ends_an_installed_command_before_it_imports_anything_of_ours(self):
        """What Python does before that cannot be helped."""
        with tempfile.TemporaryDirectory() as directory:
            os.mkdir(os.path.join(directory, "rtshell_lite"))
            with open(os.path.join(directory, "rtshell_lite", "__init__.py"), "w") as file:
                file.write("import os, signal\nos.kill(os.getpid(), signal.SIGINT)\n")
            for starter in installation.STARTER.format(name="rtpwd"), installation.OVERALL_STARTER:
                path = os.path.join(directory, "rtpwd")
                with open(path, "w") as file:
                    file.write(installation.BEGINNING + starter)
                ran = subprocess.run(
                    [sys.executable, path],
                    stdout=subprocess.PIPE,
                    stderr=subprocess.PIPE,
                    preexec_fn=hear_ctrl_c,
                    timeout=START_LIMIT,
                )
                self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (-signal.SIGINT, b"", b""))

    def test_rtpwd_waits_for_nobody(self):
        ran = subprocess.run(
            [sys.executable, "-m", "rtshell_lite", "rtpwd"],
            stdout=subprocess.PIPE,
            timeout=START_LIMIT,
            env=dict(
                os.environ,
                PYTHONPATH=os.environ.get("PYTHONPATH") or processes.ROOT,
                RTCSH_CWD="/192.0.2.1/a.cxt",
            ),
        )
        self.assertEqual((ran.returncode, ran.stdout), (0, b"/192.0.2.1/a.cxt\n"))


def hear_ctrl_c():
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # a runner in the background ignores it, which is inherited


if __name__ == "__main__":
    unittest.main()
