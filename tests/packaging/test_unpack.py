"""--unpack, for robots without pip: if this fails, they have no commands, or others' files are
written over.
"""

import os
import subprocess
import unittest

from robots import OMNIORB_WHEEL, ROOT, Robot, files, names, run


class Unpacked(Robot):
    """--unpack, for robots without pip."""

    def test_commands_run_without_omniorb(self):
        place = self.unpack()
        programs = sorted(names("bin") + ["rtshell_lite"])
        self.assertEqual(sorted(os.listdir(os.path.join(place, "bin"))), programs)
        overall = os.path.join(place, "bin", "rtshell_lite")
        self.assertEqual(run([overall, "rtpwd"]), (0, "/\n", ""))
        self.assertIn("  rtls         List the RTC Tree", run([overall])[1])
        self.check_without_omniorb(lambda name: [os.path.join(place, "bin", name)])

    def test_they_start_without_what_is_installed_beside_python_and_find_it_when_it_is_asked_for(self):
        command = os.path.join(self.unpacked(), "bin", "rtls")
        with open(command, encoding="utf-8") as file:
            self.assertEqual(file.readline(), "#!%s -S\n" % self.python)
        beside = subprocess.check_output(
            [self.python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"],
            universal_newlines=True,
        ).strip()
        fake = os.path.join(beside, "omniORB.py")
        with open(fake, "w") as file:
            file.write("raise OSError('this is omniORB')\n")
        self.addCleanup(os.unlink, fake)
        self.check_line(
            "rtls",
            1,
            run([command, "/localhost:1/"], environment={"RTSHELL_ORB": "omniorb"}),
            "this is omniORB",
        )
        self.check_line("rtls", 4, run([command, "/localhost:1/"]), "connection refused")

    def test_can_be_moved_linked_and_unpacked_again(self):
        moved = os.path.join(self.directory, "moved")
        os.rename(self.unpacked(), moved)
        link = os.path.join(self.directory, "rtpwd")
        os.symlink(os.path.join(moved, "bin", "rtpwd"), link)
        self.assertEqual(run([link]), (0, "/\n", ""))
        kept = r"\.pyc$|\.compiled$"
        before = files(moved, kept)
        again = run(
            [self.python, "-m", "rtshell_lite", "--unpack", moved],
            environment={"PYTHONPATH": os.path.join(moved, "lib")},
        )
        self.assertEqual(again, (0, "export PATH=%s/bin:$PATH\n" % moved, ""))
        self.assertEqual(files(moved, kept), before)

    def test_checkout_and_wheel_lay_out_the_same(self):
        place = self.unpacked()
        other = os.path.join(self.directory, "other")
        self.assertEqual(
            run([self.python, "-m", "rtshell_lite", "--unpack", other], environment={"PYTHONPATH": ROOT})[0],
            0,
        )
        self.assertEqual(sorted(files(place, r"dist-info|\.pyc$")), sorted(files(other, r"\.pyc$|\.idl$")))

    def test_modules_come_from_one_compiled_file(self):
        """But for what has changed since, and where it is damaged."""
        place = self.unpacked()
        lib = os.path.join(place, "lib")
        (name,) = [name for name in os.listdir(lib) if name.endswith(".compiled")]
        program = (
            "import sys; sys.path.insert(0, %r); from rtshell_lite import compiled; compiled.find(); "
            "from rtshell_lite import path, text; "
            "print(path.__loader__.__module__, text.__loader__.__module__, path.__file__)" % lib
        )

        def loaders():
            status, out, err = run([self.python, "-c", program])
            self.assertEqual((status, err), (0, ""))
            return out.split(" ", 2)

        file = os.path.join(lib, "rtshell_lite", "path.py")
        ours, Pythons = "rtshell_lite.compiled", "_frozen_importlib_external"
        self.assertEqual(loaders(), [ours, ours, file + "\n"])
        with open(os.path.join(lib, "rtshell_lite", "text.py"), "a") as changed:
            changed.write("\n")
        self.assertEqual(loaders(), [ours, Pythons, file + "\n"])
        compiled = os.path.join(lib, name)
        with open(compiled, "rb") as whole:
            content = whole.read()
        index = 16 + int.from_bytes(content[4:8], "little")
        for size in (0, 10, 16, 100, index, len(content) // 2, len(content) - 1):
            with open(compiled, "wb") as torn:
                torn.write(content[:size])
            self.assertEqual(loaders(), [Pythons, Pythons, file + "\n"], size)
        self.assertEqual(run([os.path.join(place, "bin", "rtpwd")]), (0, "/\n", ""))
        os.unlink(compiled)
        for make, remove in ((os.mkfifo, os.unlink), (os.mkdir, os.rmdir)):
            make(compiled)
            self.assertEqual(loaders(), [Pythons, Pythons, file + "\n"], make)
            remove(compiled)

    def test_what_others_put_beside_our_modules_is_left_alone(self):
        place = self.unpack()
        package = os.path.join(place, "lib", "rtshell_lite")
        with open(os.path.join(package, "odd.py"), "w") as odd:
            odd.write("def (")
        lock = os.path.join(package, ".#lock.py")
        os.symlink("nowhere", lock)
        self.addCleanup(os.unlink, lock)
        self.assertEqual(self.unpack(), place)

    @unittest.skipUnless(
        OMNIORB_WHEEL, "no omniORBpy wheel was given: there is none for this Python, or no index"
    )
    def test_omniorbpy_with_its_shared_libraries(self):
        place = self.unpack(OMNIORB_WHEEL)
        program = (
            "import os, sys; sys.path.insert(0, sys.argv[1]); from omniORB import CORBA; CORBA.ORB_init(); "
            "print('up', flush=True); os._exit(0)"
        )  # as our commands end: the ORB's own end crashes now and then
        self.assertEqual(run([self.python, "-c", program, os.path.join(place, "lib")]), (0, "up\n", ""))
        if "rtls" in names("bin"):
            result = run([os.path.join(place, "bin", "rtls"), "--timeout", "2", "/localhost:1/"])
            self.check_line("rtls", 4, result, "connection refused")
