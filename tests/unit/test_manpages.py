"""The manual pages and the Japanese README: if one of these fails, they tell of another rtshell_lite than this one."""
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ONCE = "what is written does not depend on the Python"


def read(*path):
    with open(os.path.join(ROOT, *path), encoding="utf-8") as file:
        return file.read()


def below(top):
    """{path below a directory: text} of all files there."""
    found = {}
    for where, _, names in os.walk(os.path.join(ROOT, top)):
        for name in names:
            found[os.path.relpath(os.path.join(where, name), os.path.join(ROOT, top))] = read(where, name)
    return found


class Pages(unittest.TestCase):
    def test_up_to_date(self):
        """The pages in man/ and their list in setup.cfg are what docstrings, parsers and READMEs make."""
        environment = dict(os.environ, PYTHONPATH=ROOT, PYTHONDONTWRITEBYTECODE="1")
        program = ("import json, sys; from rtshell_lite.shell import manpages; pages = manpages.pages(); "
                   "print(json.dumps([pages, manpages.packaged(sys.stdin.read(), pages)]))")
        said = subprocess.check_output([sys.executable, "-c", program], env=environment, cwd=ROOT,
                                       input=read("setup.cfg").encode("utf-8"))
        made, config = json.loads(said.decode())
        made["setup.cfg"], there = config, dict(below("man"), **{"setup.cfg": read("setup.cfg")})
        stale = sorted(name for name in set(made) | set(there) if made.get(name) != there.get(name))
        self.assertEqual(stale, [], "to bring them up to date, run: python3 -m rtshell_lite.shell.manpages")

    def test_every_command_has_one(self):
        self.assertEqual(sorted(os.listdir(os.path.join(ROOT, "man", "man1"))),
                         sorted(name + ".1" for name in os.listdir(os.path.join(ROOT, "bin")) if name.startswith("rt")))

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_groff_has_nothing_to_say(self):
        """No warning, and no line of code that begins with a dot is lost."""
        pages = sorted(glob.glob(os.path.join(ROOT, "man", "**", "*.[17]"), recursive=True))
        for options, chosen in ([], [page for page in pages if "/ja/" not in page]), (["-K", "utf8"], pages):
            said = subprocess.run(["groff", "-man", "-ww", "-z", "-Tutf8"] + options + chosen, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT)
            self.assertEqual((said.returncode, said.stdout.decode()), (0, ""))

    def test_plain_ascii_but_for_japanese(self):
        for name, text in below("man").items():
            if not name.startswith("ja"):
                self.assertTrue(all(c < "\x80" for c in text), name)


class Japanese(unittest.TestCase):
    """README.ja.md says what README.md says, as far as can be compared."""

    def section(self, readme, title):
        found = re.search(r"^#+ %s\n((?:```(?:.*\n)*?```\n|(?!#+ ).*\n)*)" % title, read(readme), re.MULTILINE)
        self.assertTrue(found, "%s has no section %s" % (readme, title))
        return found.group(1)

    def firsts(self, readme, title):
        """What stands in the first column of a section's table, word by word."""
        rows = re.findall(r"^\| (.*?) \|", self.section(readme, title), re.MULTILINE)[1:]
        return [word for row in rows for word in row.split(", ")]

    def test_tables(self):
        for english, japanese in ("Environment", "環境変数"), ("Exit status", "終了ステータス"):
            self.assertEqual(self.firsts("README.ja.md", japanese), self.firsts("README.md", english))

    def test_commands(self):
        """Each command that README.md lists is in README.ja.md, and all that there are, are in README.md."""
        english = self.firsts("README.md", "Commands")
        self.assertEqual(sorted(set(english) - set(self.firsts("README.ja.md", "コマンド"))), [])
        self.assertEqual(sorted(english), sorted("`%s`" % name for name in os.listdir(os.path.join(ROOT, "bin"))
                                                 if name.startswith("rt")))

    def test_code(self):
        """Scripts and commands to type are the same; what is behind blanks explains them."""
        for english, japanese in (("Scripts", "スクリプト"), ("Install", "インストール"),
                                  ("When the robot does not work", "ロボットが動かないとき")):
            self.assertEqual(self.code("README.ja.md", japanese), self.code("README.md", english))

    def code(self, readme, title):
        return re.findall(r"^(?:    .*|```(?:.*\n)*?```)$", self.section(readme, title), re.MULTILINE)

    def test_options_named(self):
        """The options and files that the sections speak of."""
        for english, japanese in ("Commands", "コマンド"), ("Install", "インストール"), ("Paths", "パス"):
            words = [sorted(set(re.findall(r"`(-[^`\s]*|\\[^`]*)", self.section(*where)))) for where in
                     (("README.md", english), ("README.ja.md", japanese))]
            self.assertEqual(sorted(set(words[0]) - set(words[1])), [], japanese)


if __name__ == "__main__":
    unittest.main()
