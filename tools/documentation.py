"""Writes the documents that are generated: `python3 -m tools.documentation`, in a checkout.

They are the manual pages below man/, docs/command-line.txt, docs/json-fields.txt, the table of commands in
README.md, and in README.ja.md a row for each command that its table lacks, in English until somebody
translates it. tests/unit/test_documentation.py fails when one of them is out of date.
"""

import os
import re

from rtshell_lite import __version__, files
from rtshell_lite.shell import installation
from tools import command_line, json_fields, manpages

ROOT = os.path.dirname(installation.PACKAGE)
ROW = re.compile(r"^\| (`rt.*?) \| .*\n", re.MULTILINE)


def documents():
    """All generated documents, {path below the checkout: text}."""
    english = with_commands(read("README.md"))
    japanese = with_rows(read("README.ja.md"), english)
    papers = {
        "en": "\n".join([english] + [read(f"docs/{name}") for name in manpages.PAPERS]),
        "ja": "\n".join([japanese] + [read(f"docs/ja/{name}") for name in manpages.PAPERS]),
    }
    found = {"man/" + name: text for name, text in manpages.pages(papers, released()).items()}
    found.update({"README.md": english, "README.ja.md": japanese})
    found["docs/command-line.txt"] = command_line.text()
    found["docs/json-fields.txt"] = json_fields.text()
    return found


def read(name):
    """The text of a file of the checkout."""
    return files.read(os.path.join(ROOT, name))


def with_commands(english):
    """README.md with the commands and the first lines of their helps in its table."""
    source = manpages.sections(english)["Commands"]
    rows = ["| command | does |", "|---|---|"]
    for subject, firsts in installation.by_subject().items():
        rows += [f"| **{subject}** | |"] + [f"| `{name}` | {first} |" for name, first in firsts.items()]
    return english.replace(source, re.sub(r"(^\|.*\n)+", "\n".join(rows) + "\n", source, 1, re.MULTILINE))


def released():
    """The date of this version, in the first heading of CHANGELOG.md: `## 1.0.0 (2026-11-25)`."""
    changelog = read("CHANGELOG.md")
    heading = r"^## %s \((\d{4}-\d\d-\d\d)\)$" % re.escape(__version__)
    return re.search(heading, changelog, re.MULTILINE).group(1)


def with_rows(japanese, english):
    """The Japanese README with rows for the commands of the English one."""
    source = manpages.sections(english)["Commands"]
    target = manpages.sections(japanese)["コマンド"]
    wanted = [name for row in ROW.finditer(source) for name in _names(row)]
    present = [name for row in ROW.finditer(target) for name in _names(row)]
    rows = [_only(row, wanted) for row in ROW.finditer(target)]
    absent = set(wanted) - set(present)
    rows += [_only(row, absent) for row in ROW.finditer(source)]
    begin, end = re.search(ROW.pattern + "(?:.+\n)*", target, re.MULTILINE).span()
    return japanese.replace(target, target[:begin] + "".join(rows) + target[end:])


def _names(row):
    """The commands in a row of a table."""
    return row.group(1).split(", ")


def _only(row, wanted):
    """The row with only the wanted commands; "" without any."""
    names = [name for name in _names(row) if name in wanted]
    if names:
        return "| " + ", ".join(names) + row.group()[row.end(1) - row.start() :]
    return ""


def main():
    """Write the generated documents, and remove the pages of commands that no longer exist."""
    wanted = documents()
    for directory, _, names in list(os.walk(os.path.join(ROOT, "man"))):
        for path in [os.path.join(directory, name) for name in names]:
            if os.path.relpath(path, ROOT) not in wanted:
                os.remove(path)
    for name, text in wanted.items():
        path = os.path.join(ROOT, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        files.write(path, text)


if __name__ == "__main__":
    main()
