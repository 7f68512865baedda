"""What --unpack refuses, and what is left then: nothing, or what was there."""

import os
import resource
import zipfile

from robots import Robot, files, run

ONCE = "what a wheel holds is the same for every Python"


class Refused(Robot):
    def test_wheels_that_are_refused(self):
        for number, member in enumerate(
            [
                "../evil",
                "/evil",
                "a/../../evil",
                "a\\..\\evil",
                "x-1.data/purelib/../../evil",
                "C:evil",
                "./evil",
                "rtshell_lite/cli.py",
            ]
        ):
            wheel = self.wheel("hostile%d-1-py3-none-any.whl" % number, member)
            self.check_refused(wheel, "comes twice" if "cli" in member else "refused: it holds a file named")
        self.check_refused(os.path.join(self.directory, "none-1-py3-none-any.whl"), "No such file")
        self.check_refused(self.wheel("other-1-cp32-cp32m-any.whl", "x"), "made for cp32")
        self.check_refused(self.wheel("other-1-py3-none-linux_pdp11.whl", "x"), "made for linux_pdp11")
        self.check_refused(self.wheel("other.zip", "x"), "not the name of a wheel")
        torn = self.wheel("torn-1-py3-none-any.whl", "x")
        with open(torn, "r+b") as file:
            file.truncate(30)
        self.check_refused(torn, "not a wheel")

    def test_a_wheel_that_grows_without_measure(self):
        self.check_refused(
            self.wheel("bomb-1-py3-none-any.whl", "x", bytes(65 << 20)),
            "refused: it unpacks to more than 64 MB",
        )

    def test_links_in_the_place(self):
        """They may lead anywhere."""
        place = os.path.join(self.directory, "place")
        outside = os.path.join(self.directory, "outside")
        os.mkdir(place)
        os.mkdir(outside)
        os.symlink(outside, os.path.join(place, "lib"))
        self.check_line("rtshell_lite", 1, self.from_wheel("--unpack", place), "refused: it is a link")
        self.assertEqual((os.listdir(place), os.listdir(outside)), (["lib"], []))
        os.unlink(os.path.join(place, "lib"))
        package = os.path.join(place, "lib", "rtshell_lite")
        os.makedirs(package)
        compiled = os.path.join(package, "__pycache__")
        os.symlink(outside, compiled)
        self.check_line("rtshell_lite", 1, self.from_wheel("--unpack", place), "refused: it is a link")
        self.assertEqual((os.listdir(package), os.listdir(outside)), (["__pycache__"], []))
        os.unlink(compiled)
        os.mkdir(compiled)
        os.symlink(outside, os.path.join(compiled, "text.pyc"))
        self.check_line("rtshell_lite", 1, self.from_wheel("--unpack", place), "refused: it is not a file")
        self.assertEqual(os.listdir(package), ["__pycache__"])

    def wheel(self, name, member, content="evil"):
        path = os.path.join(self.directory, name)
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as wheel:
            wheel.writestr(member, content)
        return path

    def check_refused(self, wheel, part):
        """One line of output, and no files."""
        place = os.path.join(self.directory, "place")
        before = files(self.top, "bare")
        self.check_line("rtshell_lite", 1, self.from_wheel("--unpack", place, wheel), part)
        self.assertEqual(files(self.top, "bare"), before)

    def test_full_disk_leaves_the_old_commands_whole(self):
        place = self.unpack()
        before = files(place)

        def small_files_only():
            resource.setrlimit(resource.RLIMIT_FSIZE, (600, 600))

        result = self.from_wheel("--unpack", place, preexec_fn=small_files_only)
        self.check_line("rtshell_lite", 1, result, place)
        self.assertEqual(files(place), before)
        self.assertEqual(run([os.path.join(place, "bin", "rtpwd")]), (0, "/\n", ""))

    def test_places_that_cannot_be_written(self):
        for place in "/proc/nowhere", "/dev/null":
            self.check_line("rtshell_lite", 1, self.from_wheel("--unpack", place), place)
