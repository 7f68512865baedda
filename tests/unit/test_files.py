"""Files: what is written is whole, goes where it was meant to go, and is never readable by more people than
before; what is read by name has an end. If this fails, somebody else's link or FIFO decides what becomes of a
file, or of a command.
"""
import os
import socket
import stat
import subprocess
import sys
import sysconfig
import tempfile
import threading
import unittest
from unittest import mock

from rtshell_lite import errors, files, notes
from rtshell_lite.data.idl import tokens
from rtshell_lite.datalog import textlog, writer
from rtshell_lite.datalog.records import Channel
from rtshell_lite.shell import unpack
from rtshell_lite.system import happening, output

CHANNELS = [Channel("input0", "IDL:RTC/TimedLong:1.0", b"", ("/a.rtc:out",))]
STRANGER = 12345        # a user that nobody here is


def record(name, append=False):
    writer.LogWriter(name, CHANNELS, 1, append).close()


def mode(path):
    return stat.S_IMODE(os.stat(path).st_mode)


class Case(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.top = directory.name

    def path(self, name, content=None, permissions=0o644):
        path = os.path.join(self.top, name)
        if content is not None:
            with open(path, "w") as file:
                file.write(content)
            os.chmod(path, permissions)
        return path

    def text(self, name):
        with open(self.path(name), "rb") as file:
            return file.read().decode("latin-1")

    def seen_while(self, do):
        """The modes of all temporary files, and how they were opened, while do() runs."""
        found = []
        real = os.open

        def spy(path, flags, permissions=0o777, **more):
            fd = real(path, flags, permissions, **more)
            if str(path).endswith(".tmp"):
                found.append((os.path.basename(path), flags, stat.S_IMODE(os.fstat(fd).st_mode)))
            return fd
        with mock.patch("os.open", spy):
            do()
        return found


WAYS = {"write": lambda path: files.write(path, "new"), "record": record}


class Writing(Case):
    def test_a_temporary_file_is_exclusive_private_and_has_a_name_of_its_own(self):
        for name, way in WAYS.items():
            with self.subTest(name):
                path = self.path(name, "old", 0o640)
                seen = self.seen_while(lambda: way(path)) + self.seen_while(lambda: way(path))
                self.assertEqual(len({base for base, _, _ in seen}), 2, "a name that can be guessed")
                for _, flags, permissions in seen:
                    self.assertEqual(permissions, 0o600)
                    self.assertTrue(flags & os.O_EXCL and flags & os.O_NOFOLLOW and flags & os.O_CREAT)
                self.assertEqual((mode(path), sorted(os.listdir(self.top))[0][0] != "."), (0o640, True))

    def test_a_private_file_stays_private_at_every_moment(self):
        for name, way in WAYS.items():
            path = self.path(name, "old", 0o600)
            real = os.replace
            seen = []

            def spy(source, target):
                seen.append(mode(source))
                real(source, target)
            with self.subTest(name), mock.patch("os.replace", spy):
                way(path)
                self.assertEqual((seen, mode(path)), ([0o600], 0o600))

    def test_a_new_file_is_as_readable_as_any(self):
        before = os.umask(0o027)
        self.addCleanup(os.umask, before)
        for name, way in WAYS.items():
            with self.subTest(name):
                way(self.path(name))
                self.assertEqual(mode(self.path(name)), 0o640)
        self.assertEqual(files.umask(), 0o027)

    def test_a_prepared_link_is_not_written_through(self):
        """Under every name that was ever used for temporary files, and as a broken link."""
        canary = self.path("canary")
        for name, way in WAYS.items():
            for temporary in (".%s.tmp" % name, ".%s.%d.tmp" % (name, os.getpid())):
                os.symlink(canary, self.path(temporary))
            way(self.path(name))
            way(self.path(name))
            self.assertFalse(os.path.lexists(canary), name)
            self.assertFalse(os.path.islink(self.path(name)))

    def test_a_link_that_appears_at_the_last_moment_is_not_followed(self):
        canary = self.path("canary")
        real = files.destination

        def late(name):
            found = real(name)
            os.symlink(canary, found)
            return found
        for number, way in enumerate((record, lambda path: textlog.TextWriter(path, CHANNELS, [None]))):
            with self.subTest(number), mock.patch("rtshell_lite.files.destination", late):
                with self.assertRaises((OSError, errors.Failed)):
                    way(self.path("log%d" % number))
                self.assertFalse(os.path.exists(canary))

    def test_a_link_of_ours_goes_on_pointing_where_it_does(self):
        for name, way in WAYS.items():
            self.path(name, "old")
            link = self.path("link-" + name)
            os.symlink(name, link)
            way(link)
            self.assertTrue(os.path.islink(link))
            self.assertNotEqual(self.text(name), "old")

    @unittest.skipIf(os.geteuid(), "only root can make a link somebody else's")
    def test_a_link_that_somebody_else_has_put_into_a_directory_for_all_is_refused(self):
        os.chmod(self.top, 0o1777)
        target = self.path("mine", "old")
        for number, way in enumerate(
            list(WAYS.values()) + [lambda path: textlog.TextWriter(path, CHANNELS, [None])]
        ):
            link = self.path("link%d" % number)
            os.symlink(target, link)
            os.lchown(link, STRANGER, STRANGER)
            with self.subTest(number), self.assertRaisesRegex(errors.Failed, "somebody else"):
                way(link)
        self.assertEqual(self.text("mine"), "old")

    @unittest.skipIf(os.geteuid(), "only root can give a file to another group")
    def test_a_file_that_its_group_may_read_stays_with_that_group(self):
        path = self.path("group", "old", 0o640)
        os.chown(path, -1, STRANGER)
        files.write(path, "new")
        self.assertEqual((os.stat(path).st_gid, mode(path)), (STRANGER, 0o640))
        with mock.patch("os.fchown", side_effect=PermissionError):
            files.write(path, "newer")
        self.assertEqual((os.stat(path).st_gid, mode(path)), (os.getegid(), 0o600))

    def test_a_failed_write_leaves_the_old_file_and_nothing_else(self):
        path = self.path("old", "old")
        for what in ("os.fsync", "os.replace"):
            with mock.patch(what, side_effect=OSError(28, "No space left on device")):
                for way in WAYS.values():
                    with self.assertRaises(OSError):
                        way(path)
            self.assertEqual((os.listdir(self.top), self.text("old")), (["old"], "old"))
        with mock.patch("os.fsync", side_effect=OSError(28, "No space left on device")), self.assertRaises(
            OSError
        ):
            record(self.path("new"))
        self.assertEqual(os.listdir(self.top), ["old"])

    def test_a_signal_as_the_new_file_takes_its_place(self):
        """The signal ends the command, not an error about a name that is gone."""
        real = os.replace

        def struck(*names):
            real(*names)
            raise KeyboardInterrupt
        for way in WAYS.values():
            path = self.path("old", "old")
            with mock.patch("os.replace", struck), self.assertRaises(KeyboardInterrupt):
                way(path)
            self.assertEqual(os.listdir(self.top), ["old"])
            self.assertNotEqual(self.text("old"), "old")

    def test_one_log_has_one_recorder(self):
        for name in ("new", "old"):
            path = self.path(name, "x" if name == "old" else None)
            first = writer.LogWriter(path, CHANNELS, 1)
            for way in (record, lambda path: record(path, append=True)):
                with self.assertRaisesRegex(errors.Failed, "another rtlog"):
                    way(path)
            first.close()
            record(path, append=True)
            self.assertEqual(sorted(os.listdir(self.top))[0][:1] == ".", False)

    def test_a_recorder_that_comes_too_late_does_not_replace(self):
        path = self.path("log", "old")
        real = writer.lock

        def late(file, name):
            if file.mode == "rb":
                os.rename(self.path("other", "another's"), path)
            real(file, name)
        with mock.patch("rtshell_lite.datalog.writer.lock", late), self.assertRaisesRegex(
            errors.Failed, "another rtlog"
        ):
            record(path)
        self.assertEqual(self.text("log"), "another's")


class Appended(Case):
    """Logs that grow in a directory where others can write."""

    def test_a_file_grows(self):
        for word in b"a", b"b":
            with files.append(self.path("log")) as file:
                file.write(word)
        self.assertEqual(self.text("log"), "ab")
        self.assertEqual(mode(self.path("log")), 0o666 & ~files.umask())

    def planted(self):
        """Paths where somebody else has put something."""
        os.mkfifo(self.path("fifo"))
        yield self.path("fifo")
        read = os.open(self.path("fifo"), os.O_RDONLY | os.O_NONBLOCK)
        yield self.path("fifo")
        os.close(read)
        self.path("victim", "mine")
        os.symlink("victim", self.path("link"))
        yield self.path("link")
        os.symlink("nothing", self.path("dangling"))
        yield self.path("dangling")
        with socket.socket(socket.AF_UNIX) as listener:
            listener.bind(self.path("socket"))
            yield self.path("socket")

    def test_what_is_planted_is_refused_at_once(self):
        for path in self.planted():
            with self.subTest(path), self.assertRaisesRegex(OSError, "not a regular file"):
                files.append(path)
        self.assertEqual(self.text("victim"), "mine")
        self.assertFalse(os.path.lexists(self.path("nothing")))

    def test_what_processes_print(self):
        """A planted FIFO stopped rtkeep for ever."""
        for path in self.planted():
            os.rename(path, self.path("talk.log"))
            failed = []
            with mock.patch.object(notes, "fail", failed.append):
                talk = output.Output("talk", lambda name, line: None, self.top)
                talk._write_log("hello")
            self.assertIn("not a regular file", failed[0])
            os.rename(self.path("talk.log"), path)
        self.assertEqual(self.text("victim"), "mine")

    def test_events(self):
        for path in self.path("log"), os.devnull:
            happening.Log(path).add(happening.now("a", "b"))
        self.assertIn('"object": "a"', self.text("log"))
        os.symlink("log", self.path("own"))
        happening.Log(self.path("own")).add(happening.now("c", "b"))
        self.assertIn('"object": "c"', self.text("log"))
        os.mkfifo(self.path("fifo"))
        with self.assertRaises(OSError):
            happening.Log(self.path("fifo"))

    def test_what_python_has_compiled(self):
        """A FIFO there stopped --unpack for ever."""
        os.makedirs(self.path("lib/__pycache__"))
        os.mkfifo(self.path("lib/__pycache__/x.pyc"))
        laid_out = unpack.Files(self.top)
        laid_out.add("lib/x.py", b"")
        with self.assertRaisesRegex(errors.Error, "not a file"):
            laid_out.write()
        self.assertEqual(os.listdir(self.path("lib")), ["__pycache__"])


class Endless(Case):
    """Everything that takes the name of a file to read or write."""

    def fifo(self):
        os.mkfifo(self.path("fifo"))
        return self.path("fifo")

    def readers(self):
        from rtshell_lite.datalog import logfile
        return {
            "read": files.read,
            "opened": files.opened,
            "idl": lambda name: tokens.tokens(name),
            "log": logfile.load,
        }

    def test_devices_and_fifos_are_not_read(self):
        for path in (self.fifo(), "/dev/zero", "/dev/tty", "/dev/urandom"):
            for name, read in self.readers().items():
                with self.subTest("%s %s" % (name, path)), self.assertRaises(
                    (errors.Failed, FileNotFoundError)
                ):
                    read(path)

    def test_descriptors_from_a_shell_are_read(self):
        ends = os.pipe()
        os.write(ends[1], b"abc")
        os.close(ends[1])
        self.assertEqual(files.read("/dev/fd/%d" % ends[0]), "abc")
        os.close(ends[0])
        self.assertEqual(files.read(os.devnull), "")

    def test_a_large_file_is_refused_by_its_size(self):
        with open(self.path("large"), "wb") as file:
            file.truncate(1 << 40)      # it has a hole
        for name in ("read", "idl", "log"):
            with self.subTest(name), self.assertRaises((errors.Failed, errors.BadIdl)):
                self.readers()[name](self.path("large"))

    def test_a_directory_is_told_by_its_name(self):
        with self.assertRaises(IsADirectoryError) as caught:
            files.read(self.top)
        self.assertEqual(caught.exception.filename, self.top)

    def test_a_fifo_that_nobody_reads_is_not_waited_for(self):
        fifo = self.fifo()
        for number, way in enumerate(
            list(WAYS.values()) + [lambda path: textlog.TextWriter(path, CHANNELS, [None])]
        ):
            with self.subTest(number), self.assertRaisesRegex(errors.Failed, "nobody reads"):
                way(fifo)

    @unittest.skipUnless(os.path.isdir("/proc/self/fd"), "/proc is of Linux")
    def test_stdout_of_a_pipeline_can_be_named(self):
        reading, writing = os.pipe()
        self.addCleanup(os.close, reading)
        self.addCleanup(os.close, writing)
        link = self.path("link")
        os.symlink("/proc/self/fd/%d" % writing, link)
        with files.open_special(files.destination(link)) as file:
            file.write(b"x")
        self.assertEqual(os.read(reading, 9), b"x")

    def test_a_fifo_that_somebody_reads_gets_it(self):
        fifo = self.fifo()
        taken = []
        reader = os.open(fifo, os.O_RDONLY | os.O_NONBLOCK)
        self.addCleanup(os.close, reader)
        thread = threading.Thread(target=files.write, args=(fifo, "abc"))
        thread.start()
        thread.join(10)
        taken.append(os.read(reader, 10))
        self.assertEqual(taken, [b"abc"])


class Shell(Case):
    def rtsh(self, data):
        with tempfile.TemporaryFile() as lines:
            lines.write(data)
            lines.seek(0)
            ran = subprocess.run(
                [sys.executable, "-m", "rtshell_lite", "rtsh"],
                stdin=lines,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
            )
        return ran.returncode, ran.stdout, ran.stderr.decode()

    def test_a_line_without_end_ends_it(self):
        for data in (b"x" * (5 << 20), b"pwd \\\n" * (1 << 21)):
            status, _, said = self.rtsh(data)
            self.assertEqual((status, said.count("\n")), (1, 1), said[:1000])
            self.assertIn("a line of more than 4 MiB", said)


class WorkingDirectory(Case):
    """Files in the working directory are not imported."""

    def test_nothing_is_imported_from_it(self):
        import rtshell_lite
        above = os.path.dirname(os.path.dirname(os.path.abspath(rtshell_lite.__file__)))
        names = [
            "text",
            "argparse",
            "difflib",
            "shlex",
            "errno",
            "omniORB",
            "CosNaming",
            "struct",
            "socket",
            "rtls",
            "json",
            "ast",
            "readline",
            "glob",
            "zipfile",
            "unicodedata",
            "tempfile",
            "logging",
        ]
        for name in names:
            self.path(name + ".py", "open(%r, 'w').close()\n" % self.path("canary-" + name))
        for words in (
            ["rtpwd"],
            ["--help"],
            ["rtls", "--timeout", "0.1", "/127.0.0.1:1"],
            ["rtsh", "-c", "pwd"],
            ["rtpwd", "--help"],
        ):
            ran = subprocess.run(
                [sys.executable, "-m", "rtshell_lite"] + words,
                cwd=self.top,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                env=dict(os.environ, PYTHONPATH=above),
            )
            self.assertNotIn(b"Traceback", ran.stderr)
            self.assertEqual([name for name in os.listdir(self.top) if name.startswith("canary")], [], words)


class Wheels(unittest.TestCase):
    def test_which_fit(self):
        """A stable ABI of an older Python fits, one of a newer Python does not."""
        minor = sys.version_info[1]
        machine = sysconfig.get_platform().rpartition("-")[2]
        for tags, fits in (
            ("py3-none-any", True),
            ("cp3%d-cp3%d-linux_%s" % (minor, minor, machine), True),
            ("cp3%d-abi3-linux_%s" % (minor - 1, machine), True),
            ("cp32.cp3%d-abi3-any" % (minor + 1), True),
            ("cp3%d-cp3%d-linux_%s" % (minor - 1, minor - 1, machine), False),
            ("cp3%d-abi3-linux_%s" % (minor + 1, machine), False),
            ("cp3%d-cp3%d-linux_other" % (minor, minor), False),
            ("py3", False),
        ):
            with self.subTest(tags):
                if fits:
                    unpack._check_tags("own-1.0-%s.whl" % tags)
                else:
                    self.assertRaises(errors.Error, unpack._check_tags, "own-1.0-%s.whl" % tags)


if __name__ == "__main__":
    unittest.main()
