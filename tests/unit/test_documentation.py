"""Manual pages, READMEs, docs/ and docstrings: if one of these fails, they do not describe this version."""
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
    def said(self, words, columns="80"):
        environment = dict(os.environ, PYTHONPATH=ROOT, COLUMNS=columns, PYTHONIOENCODING="utf-8",
                           PYTHONDONTWRITEBYTECODE="1")
        words = [sys.executable] + words
        return subprocess.check_output(words, stdin=subprocess.DEVNULL, env=environment).decode("utf-8")

    def test_the_short_one_fits_on_a_screen(self):
        """It has all options, the summary and an example."""
        options = re.findall(r"^(rt\w+)\n((?:  .*\n)*)", read("docs", "command-line.txt"), re.MULTILINE)
        self.assertGreater(len(options), 30)
        for name, declared in options:
            with self.subTest(name):
                said = self.said([os.path.join(ROOT, "bin", name), "--help"])
                self.assertLessEqual(said.count("\n"), 24, said)
                for option in re.findall(r"(?:^  |, )(-[^ ,:]+)", declared, re.MULTILINE):
                    self.assertRegex(said, r"(?m)(?:^  |, )%s[ ,\n]" % re.escape(option))
                self.assertIn("\n%s\n" % transcripts.helps(read("bin", name))[0].strip().split("\n")[0], said)
                self.assertIn("\nexamples:\n  ", said)

    def test_a_terminal_of_any_width(self):
        for columns in "1", "20", "200":
            said = self.said([os.path.join(ROOT, "bin", "rtdoctor"), "--help"], columns)
            self.assertIn("\nexamples:\n", said)

    def test_it_fits_into_80_columns(self):
        lines = [[os.path.join(ROOT, "bin", name), "--help"] for name in names("bin")]
        verbs = re.findall(r"^(rt\w+) (\w+)$", read("docs", "command-line.txt"), re.MULTILINE)
        lines += [[os.path.join(ROOT, "bin", name), verb, "--help"] for name, verb in verbs]
        for words in lines + [
            ["-m", "rtshell_lite", "--help"],
            [os.path.join(ROOT, "bin", "rtsh"), "-c", "help"],
        ]:
            for more in [], ["--verbose"] if words[-1] == "--help" else []:
                said = self.said(words + more)
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
        """The pages in man/, the whole command line in docs/ and the tables of commands in the READMEs agree
        with docstrings, parsers and papers.
        """
        made = generated("documents")
        there = {os.path.join("man", name): text for name, text in below("man").items()}
        texts = [os.path.join("docs", name) for name in ("command-line.txt", "json-fields.txt")]
        for name in ["README.md", "README.ja.md"] + texts:
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

    def test_readmes(self):
        for readme in "README.md", "README.ja.md":
            rows = re.findall(r"^\| (`rt\w+`.*?) \|", read(readme), re.MULTILINE)
            listed = sorted(name.strip("`") for row in rows for name in row.split(", "))
            self.assertEqual(listed, names("bin"), "each command has one row in the table of %s" % readme)

    def test_summaries(self):
        """The first line of a command's help, in all lists of commands, fits into theirs on a terminal."""
        for name in names("bin"):
            first, _, rest = read("bin", name).partition('"""')[2].partition("\n")
            self.assertRegex(first, r"^.{,63}\.$", name)
            self.assertEqual(rest[:1], "\n", name)

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
    """What papers say of all commands."""

    def test_what_timeout_means(self):
        """It names each command whose --timeout is another one."""
        other = [name for name in names("bin") if "options.duration(" in read("bin", name)]
        page = read("docs", "paths.md")
        sentence = re.search(r"In ([^.]*), `--timeout`\sis how long they run", page)
        self.assertEqual(re.findall(r"`(rt\w+)`", sentence.group(1)), other)

    def test_tls(self):
        paths = glob.glob(os.path.join(ROOT, "rtshell_lite", "**", "*.py"), recursive=True)
        sources = "".join(read(path) for path in paths)
        page = read("docs", "install.md")
        self.assertNotIn("sslTP", sources, "docs/install.md says that nothing speaks TLS")
        self.assertIn("Nothing here speaks TLS", page)
        self.assertIsNone(re.search(r"transports[^.]*TLS", page))


def anchors(text):
    """The anchors of a paper, as GitHub makes them of its headings."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"```(?:.*\n)*?```", "", text), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


class Links(unittest.TestCase):
    PAPERS = ["README.md", "README.ja.md", "CONTRIBUTING.md", "SECURITY.md"]

    def papers(self):
        found = [name for name in below("docs") if name.endswith(".md")]
        return self.PAPERS + sorted(os.path.join("docs", name) for name in found)

    def links(self, paper):
        """[(the file, the anchor or "")] that a paper leads to."""
        found = re.findall(r"\]\(([^)\s]*)\)", re.sub(r"```(?:.*\n)*?```", "", read(paper)))
        for link in found:
            path, _, anchor = link.partition("#")
            yield os.path.normpath(os.path.join(os.path.dirname(paper), path)) if path else paper, anchor

    def test_all_lead_somewhere(self):
        dead = []
        for paper in self.papers():
            for path, anchor in self.links(paper):
                there = os.path.isfile(os.path.join(ROOT, path))
                if not there or anchor and anchor not in anchors(read(path)):
                    dead.append("%s: %s#%s" % (paper, path, anchor))
        self.assertEqual(dead, [])

    def test_all_pages_are_found(self):
        """From README.md, Japanese ones from README.ja.md, those about the code from CONTRIBUTING.md."""
        found = {path for paper in self.PAPERS for path, _ in self.links(paper)}
        self.assertEqual(sorted(set(self.papers()) - found), [])

    def test_pages_named_by_rtshell_lite(self):
        environment = dict(os.environ, PYTHONDONTWRITEBYTECODE="1")
        words = [sys.executable, "-m", "rtshell_lite"]
        said = subprocess.check_output(words, cwd=ROOT, stdin=subprocess.DEVNULL, env=environment).decode()
        named = said.partition("docs/ of the repository: ")[2].split()
        pages = [re.match(r"docs/(\w+)\.md$", path) for path, _ in self.links("README.md")]
        self.assertEqual(sorted(named), sorted({page.group(1) for page in pages if page}))

    def test_readme_is_short_and_markdown_alone(self):
        for readme in "README.md", "README.ja.md":
            self.assertLessEqual(read(readme).count("\n"), 250)
            self.assertIsNone(re.search(r"^ {,3}<\w", read(readme), re.MULTILINE))


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
    """README.ja.md and the pages of docs/ja/ say what the English ones say, as far as can be compared."""

    SHORTER = ["docs/ja/keeping.md"]  # refers to the English one

    def pairs(self):
        """[(the Japanese paper, the English one)]"""
        pages = sorted(below(os.path.join("docs", "ja")))
        self.assertGreater(len(pages), 5)
        return [("README.ja.md", "README.md")] + [("docs/ja/" + name, "docs/" + name) for name in pages]

    def firsts(self, paper):
        """The words in the first columns of its tables, without their heads."""
        rows = re.findall(r"^\| (.*?) \|.*(?!\n\|---)\n", read(paper), re.MULTILINE)
        return [word for row in rows for word in row.split(", ")]

    def test_tables(self):
        """All paths, variables and statuses."""
        self.assertEqual(self.firsts("docs/ja/paths.md"), self.firsts("docs/paths.md"))
        self.assertGreater(len(self.firsts("docs/paths.md")), 25)

    def test_code(self):
        """Blocks and commands are the same, apart from remarks after several blanks."""
        for japanese, english in self.pairs():
            with self.subTest(japanese):
                self.assertEqual([line for line in self.code(japanese) if line not in self.code(english)], [])
                if japanese not in self.SHORTER:
                    self.assertEqual(len(self.code(japanese)), len(self.code(english)))

    def code(self, paper):
        """Its lines of code."""
        found = re.findall(r"^(?:    .*|```(?:.*\n)*?```)$", read(paper), re.MULTILINE)
        lines = [line for block in found for line in block.split("\n")]
        lines = [re.split(r"(?<=\S) {2,}(?=[^ ])", line)[0] for line in lines if line.strip(" `")]
        return [line for line in lines if "+--" not in line]  # what explains a path

    def test_options_named(self):
        """The options and escapes."""
        for name in "install.md", "paths.md":
            pages = read("docs", name), read("docs", "ja", name)
            english, japanese = [set(re.findall(r"`(-[^`\s]*|\\[^`]*)", page)) for page in pages]
            self.assertEqual(sorted(english - japanese), [], name)


if __name__ == "__main__":
    unittest.main()
