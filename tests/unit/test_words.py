"""Words that readers stumble over: no help, message, manual page or paper has them. Which ones, and why, is
in docs/words.md.
"""
import ast
import glob
import os
import re
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ONCE = "it reads the source: one Python is enough"


def read(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def below(pattern):
    return sorted(
        os.path.relpath(path, ROOT)
        for path in glob.glob(os.path.join(ROOT, pattern), recursive=True)
        if os.path.isfile(path)
    )


def banned():
    """[(a pattern, what is written instead)]: the rows of the table in docs/words.md."""
    rows = re.findall(r"^\| `(.+?)` \| (.+?) \|$", read("docs/words.md"), re.MULTILINE)
    words = [(re.sub(" ", r"\\s+", pattern.replace("¦", "|")), better) for pattern, better in rows]
    return [(re.compile(r"\b(?:%s)\b" % pattern, re.IGNORECASE), better) for pattern, better in words]


def papers():
    """(where, text) of everything that is read by people who use it."""
    papers = [
        path
        for pattern in ("docs/*.md", "docs/*.txt", "man/man[17]/*", "mock_components/tour")
        for path in below(pattern)
    ]
    for path in ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md"] + papers:
        if path != os.path.join("docs", "words.md"):
            yield path, re.sub(r"\\fB|\\fR|\\fI|\\&", "", read(path))
    for path in below("bin/rt*") + below("rtshell_lite/**/*.py"):
        if "idl_stubs" not in path:
            yield from spoken(path)


def spoken(path):
    """What a file says to people: the help of commands and of the library, and the texts of messages, labels
    and notes.
    """
    tree = ast.parse(read(path))
    is_public = path.startswith("bin") or path.endswith(os.sep + "api.py")
    documented = [
        node
        for node in ast.walk(tree)
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef))
    ]
    docstrings = {
        id(node.body[0].value) for node in documented if node.body and isinstance(node.body[0], ast.Expr)
    }
    for node in ast.walk(tree):
        value = (
            getattr(node, "value", None) if type(node).__name__ == "Constant" else getattr(node, "s", None)
        )
        if isinstance(value, str) and (is_public or id(node) not in docstrings):
            yield "%s:%d" % (path, node.lineno), value


class Words(unittest.TestCase):
    def test_no_paper_has_them(self):
        found = []
        rules = banned()
        self.assertGreater(len(rules), 30)
        for where, text in papers():
            for pattern, better in rules:
                for match in pattern.finditer(text):
                    line = text.count("\n", 0, match.start()) + 1
                    found.append("%s (line %d): %r; better: %s" % (where, line, match.group(), better))
        self.assertEqual(found, [])

    def test_what_our_own_words_name_is_there(self):
        paths = re.findall(r"`([a-z]+/[a-z_/]*(?:\.py)?)`", read("docs/words.md"))
        self.assertGreater(len(paths), 30)
        bases = [ROOT, os.path.join(ROOT, "rtshell_lite")]
        missing = [
            path for path in paths if not any(os.path.exists(os.path.join(base, path)) for base in bases)
        ]
        self.assertEqual(missing, [])
        names = re.findall(r"`errors\.(\w+)`", read("docs/words.md"))
        source = read("rtshell_lite/errors.py")
        self.assertEqual([name for name in names if f"class {name}(" not in source], [])


if __name__ == "__main__":
    unittest.main()
