"""The same files make the same wheel, octet for octet: what .ci/release relies on."""
import glob
import os
import re
import shutil
import subprocess
import tarfile
import tempfile
import unittest
import zipfile

import environments
import rtshell_lite

ROOT = environments.ROOT
ONCE = "one Python builds the wheel"
BUILDERS = glob.glob(os.path.join(environments.STORE, "build-*", "bin", "python"))


class Reproducible(unittest.TestCase):
    def copied(self, name, mask):
        """A directory of this name with the sources; their files have the modes that a umask leaves."""
        source = os.path.join(self.top, name)
        os.mkdir(source)
        for each in environments.SOURCES:
            environments.copy(os.path.join(ROOT, each), os.path.join(source, each))
        for where, _, files in os.walk(source):
            for path in [os.path.join(where, each) for each in files]:
                os.chmod(path, (0o777 if os.access(path, os.X_OK) else 0o666) & ~mask)
                os.utime(path, (mask, mask))
        return source

    def built(self, name, mask, **environment):
        """A wheel of the checkout, built in a directory of this name from `copied` files."""
        source = self.copied(name, mask)
        builder = BUILDERS[0]
        environment = dict(os.environ, SOURCE_DATE_EPOCH="1764072000", **environment)
        subprocess.check_call(
            [
                builder,
                "-m",
                "pip",
                "wheel",
                "-q",
                "--no-build-isolation",
                "--no-deps",
                "--no-index",
                "-w",
                source + "-wheel",
                source,
            ],
            env=environment,
            preexec_fn=lambda: os.umask(mask),
        )
        path, = glob.glob(os.path.join(source + "-wheel", "*.whl"))
        return path

    @unittest.skipUnless(BUILDERS, "tests/run has built no wheel")
    def test_octet_for_octet(self):
        self.top = tempfile.mkdtemp(prefix="rt-")
        self.addCleanup(shutil.rmtree, self.top)
        paths = [self.built("here", 0o022, TZ="UTC", PYTHONHASHSEED="1", LC_ALL="C"),
                 self.built("in another place", 0o002, TZ="Asia/Tokyo", PYTHONHASHSEED="2", LC_ALL="C.UTF-8")]
        with zipfile.ZipFile(paths[0]) as one, zipfile.ZipFile(paths[1]) as other:
            for first, second in zip(one.infolist(), other.infolist()):
                self.assertEqual(
                    (first.filename, first.date_time, oct(first.external_attr), one.read(first)),
                    (second.filename, second.date_time, oct(second.external_attr), other.read(second)),
                )
                self.assertEqual(first.date_time, (2025, 11, 25, 12, 0, 0))
        with open(paths[0], "rb") as one, open(paths[1], "rb") as other:
            self.assertEqual(one.read(), other.read())

    @unittest.skipUnless(BUILDERS, "tests/run has built no wheel")
    def test_sources_octet_for_octet(self):
        """An sdist depends neither on modes and times of files, nor on who has built it, and where."""
        self.top = tempfile.mkdtemp(prefix="rt-")
        self.addCleanup(shutil.rmtree, self.top)
        build = "import setuptools.build_meta as b, sys; b.build_sdist(sys.argv[1])"
        archives = []
        for name, mask in ("here", 0o022), ("in another place", 0o002):
            source = self.copied(name, mask)
            subprocess.check_call(
                [BUILDERS[0], "-c", build, source + "-sdist"],
                cwd=source,
                env=dict(os.environ, SOURCE_DATE_EPOCH="1764072000"),
                stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL,
            )
            (path,) = glob.glob(os.path.join(source + "-sdist", "*.tar.gz"))
            with open(path, "rb") as file:
                archives.append(file.read())
        self.assertTrue(archives[0] == archives[1])

    @unittest.skipUnless(BUILDERS, "tests/run has built no wheel")
    def test_whoever_has_the_sources_can_test_them(self):
        """An sdist has all that git has, but what is about git."""
        self.top = tempfile.mkdtemp(prefix="rt-")
        self.addCleanup(shutil.rmtree, self.top)
        source = os.path.join(self.top, "source")
        words = ["git", "ls-files", "-co", "--exclude-standard"]
        git = subprocess.run(words, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        listed = git.stdout.decode()
        if not listed:
            self.skipTest("needs git, and a clone")
        files = [name for name in listed.split("\n") if os.path.isfile(os.path.join(ROOT, name))]
        for name in files:
            os.makedirs(os.path.dirname(os.path.join(source, name)), exist_ok=True)
            shutil.copy2(os.path.join(ROOT, name), os.path.join(source, name))
        builder = BUILDERS[0]
        build = "import setuptools.build_meta as b, sys; b.build_sdist(sys.argv[1])"
        subprocess.check_call(
            [builder, "-c", build, self.top], cwd=source, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        path, = glob.glob(os.path.join(self.top, "*.tar.gz"))
        with tarfile.open(path) as archive:
            packed = {name.partition("/")[2] for name in archive.getnames()}
        self.assertEqual(sorted(set(files) - packed - {".gitignore"}), [])
        self.assertEqual([name for name in packed if "__pycache__" in name or "venv" in name], [])

    def test_the_changelog_begins_with_this_version(self):
        with open(os.path.join(ROOT, "CHANGELOG.md"), encoding="utf-8") as file:
            first = re.search("^## (?!Unreleased$)(.*)$", file.read(), re.MULTILINE).group(1)
        self.assertRegex(
            first, "^%s [(]2[0-9]{3}-[0-9]{2}-[0-9]{2}[)]$" % re.escape(rtshell_lite.__version__)
        )


if __name__ == "__main__":
    unittest.main()
