"""Manual pages, READMEs and docstrings: if one of these fails, they do not describe this version."""
import glob
import json
import os
import re
import shutil
import subprocess
import sys
import unittest

import transcripts

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


def names(directory):
    """The commands that have files in a directory, with any extension."""
    return sorted(
        {
            re.match(r"rt\w+", name).group()
            for name in os.listdir(os.path.join(ROOT, directory))
            if name.startswith("rt") and name != "rtshell_lite"
        }
    )


def documented(command):
    """What the help of a command and of its verbs says about their JSON; "" where it says nothing."""
    helps = transcripts.helps(read("bin", command))
    return "".join(text.partition("\nJSON:\n")[2].partition("\nexamples:\n")[0] for text in helps)


def printed():
    """JSON objects in transcripts, each with the commands that may have printed it."""
    for path in sorted(glob.glob(os.path.join(ROOT, "tests", "commands", "*.t"))):
        for step in transcripts.steps(transcripts.parse(read(path))):
            line = "\n".join(step.command)
            commands = (
                [name for name in re.findall(r"\brt\w+", line) if name in names("bin")]
                if "--json" in line
                else []
            )
            for expected in step.expected if commands else ():
                try:
                    value = json.loads(expected)
                except ValueError:
                    continue  # other output, or a pattern
                if isinstance(value, dict):
                    yield os.path.basename(path), commands, value


class Help(unittest.TestCase):
    def test_it_fits_into_80_columns(self):
        environment = dict(
            os.environ, PYTHONPATH=ROOT, COLUMNS="80", PYTHONDONTWRITEBYTECODE="1", PYTHONIOENCODING="utf-8"
        )
        lines = [[os.path.join(ROOT, "bin", name), "--help"] for name in names("bin")]
        verbs = re.findall(r"^(rt\w+) (\w+)$", read("docs", "command-line.txt"), re.MULTILINE)
        lines += [[os.path.join(ROOT, "bin", name), verb, "--help"] for name, verb in verbs]
        for words in lines + [
            ["-m", "rtshell_lite", "--help"],
            [os.path.join(ROOT, "bin", "rtsh"), "-c", "help"],
        ]:
            said = subprocess.check_output(
                [sys.executable] + words, stdin=subprocess.DEVNULL, env=environment
            ).decode("utf-8")
            self.assertEqual([line for line in said.splitlines() if len(line) > 80], [], words)


def generated(function, *arguments):
    """What a function of documentation.py returns, which is in the checkout only."""
    environment = dict(os.environ, PYTHONPATH=ROOT, PYTHONDONTWRITEBYTECODE="1")
    program = "import json, sys; from tools import documentation as d; " \
              f"print(json.dumps(d.{function}(*json.loads(sys.argv[1]))))"
    return json.loads(
        subprocess.check_output(
            [sys.executable, "-c", program, json.dumps(arguments)], env=environment, cwd=ROOT
        ).decode()
    )


class Generated(unittest.TestCase):
    def test_up_to_date(self):
        """The pages in man/, the whole command line in docs/ and the rows of README.ja.md agree with
        docstrings, parsers and READMEs.
        """
        made = generated("documents")
        there = {os.path.join("man", name): text for name, text in below("man").items()}
        for name in "README.ja.md", os.path.join("docs", "command-line.txt"):
            there[name] = read(name)
        stale = sorted(name for name in set(made) | set(there) if made.get(name) != there.get(name))
        self.assertEqual(stale, [], "to bring them up to date, run: python3 -m tools.documentation")

    def test_rows_of_commands(self):
        """A command without a row gets the English one, the row of a command that no longer exists goes;
        translations stay.
        """
        english = "## Commands\n\n| command | does |\n|---|---|\n| `rta` | a |\n| `rtb`, `rtc`, `rtd` | b |\n"
        japanese = "## コマンド\n\n| コマンド | 働き |\n|---|---|\n| `rtc`, `rtold` | 日本 |\n| `rtgone` | 語 |\n\n本\n"
        self.assertEqual(generated("with_rows", japanese, english), "## コマンド\n\n| コマンド | 働き |\n|---|---|\n"
                         "| `rtc` | 日本 |\n| `rta` | a |\n| `rtb`, `rtd` | b |\n\n本\n")


class Commands(unittest.TestCase):
    """The docstring of each command."""

    def test_readme(self):
        rows = re.findall(r"^\| (`rt\w+`.*?) \|", read("README.md"), re.MULTILINE)
        self.assertEqual(sorted(name.strip("`") for row in rows for name in row.split(", ")), names("bin"),
                         "each command has one row in README.md, in the table of commands")

    def test_changelog(self):
        missing = [name for name in names("bin") if "`%s`" % name not in read("CHANGELOG.md")]
        self.assertEqual(missing, [], "to be named by a line of CHANGELOG.md")

    def test_json(self):
        missing = [
            name
            for name in names("bin")
            if ("options.json_output(" in read("bin", name)) != bool(documented(name))
        ]
        self.assertEqual(missing, [], "with --json, the docstring lists the fields between a line JSON: "
                                      "and the line examples:")

    def test_fields_are_documented(self):
        """All that transcripts show, except those of parameters and modules, whose names vary."""
        seen = 0
        for path, commands, value in printed():
            if not set(commands) & {"rtconf", "rtmgr"}:
                known = set(re.findall(r"\w+", " ".join(map(documented, commands))))
                seen += 1
                with self.subTest(path):
                    self.assertEqual(
                        [name for name in value if name.replace("_connected", "") not in known],
                        [],
                        "to be listed under JSON: in the docstring of %s" % " or ".join(commands),
                    )
        self.assertGreater(seen, 50)


class Promises(unittest.TestCase):
    """What README.md says of all commands."""

    def test_what_timeout_means(self):
        """It names each command whose --timeout is another one."""
        other = [name for name in names("bin") if "options.duration(" in read("bin", name)]
        sentence = re.search(r"In ([^.]*), `--timeout`\sis how long they run", read("README.md"))
        self.assertEqual(re.findall(r"`(rt\w+)`", sentence.group(1)), other)

    def test_tls(self):
        paths = glob.glob(os.path.join(ROOT, "rtshell_lite", "**", "*.py"), recursive=True)
        sources = "".join(read(path) for path in paths)
        self.assertNotIn("sslTP", sources, "README.md says that nothing speaks TLS")
        self.assertIn("Nothing here speaks TLS", read("README.md"))
        self.assertIsNone(re.search(r"transports[^.]*TLS", read("README.md")))


class Pages(unittest.TestCase):
    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_groff_has_nothing_to_say(self):
        """No warning, and no line of code that begins with a dot is lost."""
        pages = sorted(glob.glob(os.path.join(ROOT, "man", "**", "*.[17]"), recursive=True))
        for options, chosen in ([], [page for page in pages if "/ja/" not in page]), (["-K", "utf8"], pages):
            said = subprocess.run(
                ["groff", "-man", "-ww", "-z", "-Tutf8"] + options + chosen,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
            )
            self.assertEqual((said.returncode, said.stdout.decode()), (0, ""))

    @unittest.skipUnless(shutil.which("mandoc"), "mandoc is not installed")
    def test_mandoc_has_no_warning(self):
        pages = sorted(glob.glob(os.path.join(ROOT, "man", "**", "*.[17]"), recursive=True))
        lint = subprocess.run(
            ["mandoc", "-Tlint", "-Wwarning"] + pages, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
        )
        self.assertEqual(lint.stdout.decode(), "")

    def test_plain_ascii_but_for_japanese(self):
        for name, text in below("man").items():
            if not name.startswith("ja"):
                self.assertTrue(all(c < "\x80" for c in text), name)


class Japanese(unittest.TestCase):
    """README.ja.md says what README.md says, as far as can be compared."""

    def section(self, readme, title):
        found = re.search(
            r"^#+ %s\n((?:```(?:.*\n)*?```\n|(?!#+ ).*\n)*)" % title, read(readme), re.MULTILINE
        )
        self.assertTrue(found, "%s has no section %s" % (readme, title))
        return found.group(1)

    def firsts(self, readme, title):
        """The words in the first column of a section's table."""
        rows = re.findall(r"^\| (.*?) \|", self.section(readme, title), re.MULTILINE)[1:]
        return [word for row in rows for word in row.split(", ")]

    def test_tables(self):
        titles = ("Paths", "パス"), ("Environment", "環境変数"), ("Exit status", "終了ステータス")
        for english, japanese in titles:
            self.assertEqual(self.firsts("README.ja.md", japanese), self.firsts("README.md", english))

    def test_code(self):
        """Scripts and commands are the same, apart from remarks after several blanks."""
        for english, japanese in (("Scripts", "スクリプト"), ("Install", "インストール"),
                                  ("When the robot does not work", "ロボットが動かないとき")):
            self.assertEqual(self.code("README.ja.md", japanese), self.code("README.md", english))

    def code(self, readme, title):
        return re.findall(r"^(?:    .*|```(?:.*\n)*?```)$", self.section(readme, title), re.MULTILINE)

    def test_options_named(self):
        """The options and files in the sections."""
        for english, japanese in ("Commands", "コマンド"), ("Install", "インストール"), ("Paths", "パス"):
            words = [sorted(set(re.findall(r"`(-[^`\s]*|\\[^`]*)", self.section(*where)))) for where in
                     (("README.md", english), ("README.ja.md", japanese))]
            self.assertEqual(sorted(set(words[0]) - set(words[1])), [], japanese)


if __name__ == "__main__":
    unittest.main()
