"""What is kept of the wheel file: if this fails, somebody else's code may run, or a command is slow."""

import os
import resource
import shutil
import zlib

from robots import WHEEL, Robot, files, run


class KeptBytecode(Robot):
    """What is run from the wheel file is compiled once, where that is safe."""

    def setUp(self):
        super().setUp()
        self.cache = os.path.join(self.directory, "cache")
        os.mkdir(self.cache)
        self.kept = os.path.join(self.cache, "rtshell_lite")

    def rtpwd(self, *words, **environment):
        known = dict({"PYTHONPATH": WHEEL, "XDG_CACHE_HOME": self.cache}, **environment)
        return run([self.python, "-m", "rtshell_lite", "rtpwd"] + list(words), environment=known)

    def check_rtpwd(self, **environment):
        self.assertEqual(self.rtpwd(**environment), (0, "/\n", ""))

    def file(self, part):
        """The kept file that has this in its name."""
        (name,) = [name for name in os.listdir(self.kept) if part in name]
        return os.path.join(self.kept, name)

    def forge(self):
        """Change the kept code of rtpwd so that it differs from that in the wheel,
        as only its owner can.
        """
        path = self.file("commands.rtpwd")
        with open(path, "rb") as file:
            data = file.read()
        start = next(
            at
            for at in range(len(data))
            if zlib.crc32(data[at + 4 :]).to_bytes(4, "little") == data[at : at + 4]
        )
        code = data[start + 4 :].replace(b"working directory", b"WORKING DIRECTORY")
        with open(path, "wb") as file:
            file.write(data[:start] + zlib.crc32(code).to_bytes(4, "little") + code)
        return path

    def check_used(self, is_used, **environment):
        status, out, err = self.rtpwd("--help", **environment)
        self.assertEqual((status, err, "WORKING DIRECTORY" in out), (0, "", is_used))

    def test_it_is_private_used_and_written_once(self):
        self.check_rtpwd()
        self.assertEqual(os.stat(self.kept).st_mode & 0o777, 0o700)
        paths = [os.path.join(self.kept, name) for name in os.listdir(self.kept)]
        self.assertEqual({os.stat(path).st_mode & 0o777 for path in paths}, {0o600})
        self.assertFalse([path for path in paths if path.endswith(".tmp")])
        self.forge()
        before = files(self.kept)
        self.check_used(True)
        self.assertEqual({name: found for name, found in files(self.kept).items() if name in before}, before)

    def test_in_the_home_directory(self):
        os.rename(self.cache, os.path.join(self.directory, ".cache"))
        self.check_rtpwd(XDG_CACHE_HOME="", HOME=self.directory)
        self.assertIn("rtshell_lite", os.listdir(os.path.join(self.directory, ".cache")))

    def test_of_others_or_for_others_it_is_not_used(self):
        self.check_rtpwd()
        self.forge()
        self.check_used(True)
        os.chmod(self.kept, 0o770)
        self.check_used(False)
        os.chmod(self.kept, 0o700)
        moved = os.path.join(self.directory, "moved")
        os.rename(self.kept, moved)
        os.symlink(moved, self.kept)
        self.check_used(False)
        os.unlink(self.kept)
        os.rename(moved, self.kept)
        self.check_used(True)
        if os.geteuid() == 0:
            os.chown(self.kept, 1, 1)
            self.check_used(False)

    def test_a_file_of_others_or_for_others_is_written_again(self):
        self.check_rtpwd()
        path = self.forge()
        os.chmod(path, 0o622)
        self.check_used(False)
        self.assertEqual(os.stat(path).st_mode & 0o777, 0o600)
        outside = os.path.join(self.directory, "outside")
        os.rename(self.forge(), outside)
        os.symlink(outside, path)
        self.check_used(False)
        self.assertFalse(os.path.islink(path))
        os.unlink(path)
        os.mkfifo(path, 0o600)
        self.check_used(False)

    def test_a_damaged_file_is_written_again(self):
        self.check_rtpwd()
        path = self.file("rtshell_lite.path")
        with open(path, "rb") as file:
            whole = file.read()
        for damaged in (
            whole[:-1],
            whole[:10],
            b"",
            whole[:-9] + b"\xff" + whole[-8:],
            whole.replace(b"rtshell", b"rtsHell"),
        ):
            with open(path, "wb") as file:
                file.write(damaged)
            self.check_rtpwd()
            with open(path, "rb") as file:
                self.assertEqual(file.read(), whole)

    def test_another_wheel_at_the_same_place(self):
        wheel = os.path.join(self.directory, os.path.basename(WHEEL))
        shutil.copy(WHEEL, wheel)
        self.check_rtpwd(PYTHONPATH=wheel)
        self.forge()
        self.check_used(True, PYTHONPATH=wheel)
        os.utime(wheel, (1, 1))
        self.check_used(False, PYTHONPATH=wheel)

    def test_where_nothing_can_be_kept(self):
        for place in "/nonexistent", "/dev/null", "cache":
            self.check_rtpwd(XDG_CACHE_HOME=place)
        self.check_rtpwd(PYTHONDONTWRITEBYTECODE="1")
        self.assertEqual(files(self.kept), {})

    def test_a_full_disk(self):
        def small_files_only():
            resource.setrlimit(resource.RLIMIT_FSIZE, (600, 600))

        result = run(
            [self.python, "-m", "rtshell_lite", "rtpwd"],
            preexec_fn=small_files_only,
            environment={"PYTHONPATH": WHEEL, "XDG_CACHE_HOME": self.cache},
        )
        self.assertEqual(result, (0, "/\n", ""))
        self.assertTrue(all(len(content) <= 600 for content in files(self.kept).values()))
