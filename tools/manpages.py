"""Manual pages: of commands, from their docstrings and parsers; rtshell_lite(7), from README.md and pages of
docs/; in Japanese, from README.ja.md and those of docs/ja/.
"""

import argparse
import re

from rtshell_lite import __version__, options
from rtshell_lite.shell import installation
from tools import command_line

PAPERS = ["paths.md", "scripts.md"]  # of docs/, besides the README
# Of rtshell_lite(7): the headings of NAME and DESCRIPTION, the sections taken from those, the heading of
# SEE ALSO.
SECTIONS = {
    "en": (
        "NAME",
        "DESCRIPTION",
        ["Commands", "Paths", "Options", "Environment", "Exit status", "Scripts", "Read on"],
        "SEE ALSO",
    ),
    "ja": (
        "名前",
        "説明",
        ["コマンド", "パス", "オプション", "環境変数", "終了ステータス", "スクリプト", "続きを読む"],
        "関連項目",
    ),
}
SUMMARIES = {
    "en": "shell commands for robots built from OpenRTM-aist components",
    "ja": "OpenRTM-aist のコンポーネントで作られたロボットのためのシェルコマンド",
}
WIDEST = 76


def pages(papers, date):
    """All pages, {path below man/: text}; `papers` are the texts of the READMEs and of their PAPERS by
    language, `date` that of the version.
    """
    commands = installation.commands()
    found = {f"man1/{name}.1": _command_page(name, path, date) for name, path in commands.items()}
    found["man7/rtshell_lite.7"] = _overview("en", papers["en"], commands, date)
    found["ja/man7/rtshell_lite.7"] = _overview("ja", papers["ja"], commands, date)
    return found


def sections(markdown):
    """The sections of a README: {title: text}."""
    return dict(re.findall(r"^#+ (.*)\n((?:```(?:.*\n)*?```\n|(?!#+ ).*\n)*)", markdown, re.MULTILINE))


# ---- a command ----


def _command_page(name, path, date):
    module = installation.load(path, "rtshell_lite command")
    parser = options.parser(module.arguments, module.__doc__, name)
    summary, _, rest = module.__doc__.strip().partition("\n\n")
    lines = [
        _header(name, 1, date),
        ".SH NAME",
        "%s \\- %s" % (name, _text(summary.rstrip(".").replace("\n", " "))),
        ".SH SYNOPSIS",
    ]
    for number, one in enumerate(command_line.parsers(parser)):
        lines += [".br"] * (number > 0) + _synopsis(one)
    if parser.verbs is None:
        lines += _parts(parser, rest, ".SH")
    else:
        description, _, examples = rest.partition("\nexamples:\n")
        lines += [".SH DESCRIPTION"] + _paragraphs(description.strip("\n"))
        for verb, one in parser.verbs.by_name.items():
            lines += [f".SH {name.upper()} {verb.upper()}", ".PP"]
            summary, _, rest = one.doc.strip().partition("\n\n")
            lines += [_text(summary)] + _parts(parser.verbs.parser(verb), rest, ".SS")
        lines += [".SH EXAMPLES"] + _literal(examples.rstrip().split("\n"))
    lines += [
        ".SH SEE ALSO", ".BR rtshell_lite (7):", "options of all commands, paths, exit statuses, environment"
    ]
    return _page(lines)


def _synopsis(parser):
    arguments = [_argument(action) for action in parser._actions if not action.option_strings]
    return [".B " + parser.prog, " ".join(["[\\fIoption\\fR ...]"] + arguments)]


def _parts(parser, doc, heading):
    """What the page says of a command or a verb: description, options, JSON and examples; `doc` is its help
    without the summary, `heading` is .SH or .SS.
    """
    details, _, examples = ("\n" + doc).partition("\nexamples:\n")
    details, _, fields = details.partition("\nJSON:\n")
    lines = []
    if details.strip():
        lines += [heading + " DESCRIPTION"] + _paragraphs(details.strip("\n"))
    lines += [heading + " OPTIONS"]
    shown = [action for action in parser._actions if action.help is not argparse.SUPPRESS]
    common = {(action.dest, action.help) for action in options.parser(lambda parser: None, "", "")._actions}
    for action in sorted(shown, key=lambda action: bool(action.option_strings)):
        if (action.dest, action.help) in common:
            continue  # rtshell_lite(7) has them
        lines += [".TP", _label(action), _text(parser._get_formatter()._expand_help(action))]
    if fields:
        lines += [heading + " JSON"] + _entries(fields)
    return lines + [heading + " EXAMPLES"] + _literal(examples.rstrip().split("\n"))


def _page(lines):
    """The text of a page: lines of at most 79 columns, where they may be broken,
    and no paragraph that begins a section.
    """
    page = []
    literal = False
    for line in lines:
        literal = line == ".nf" or literal and line != ".fi"
        if line == ".PP" and page[-1].startswith((".SH ", ".SS ")):
            continue
        if literal or line.startswith(".") or page[-1] == ".TP":
            page.append(line)
        else:
            for part in re.findall(r"(?! ).{1,79}(?![^ ])|[^ ]+", line):
                if part[0] in ".'":
                    part = "\\&" + part
                page.append(part)
    return "\n".join(page) + "\n"


def _header(name, section, date):
    return (
        '.\\" Written by python3 -m tools.documentation\n.TH %s %d %s "rtshell_lite %s" '
        '"rtshell_lite"\n.nh\n.ad l' % (name.upper(), section, date, __version__)
    )


def _argument(action):
    """A positional argument in the synopsis."""
    return command_line.positional(action, _value(action), "...")


def _label(action):
    """An argument or option with its value, as a heading."""
    if not action.option_strings:
        return _value(action)
    names = ", ".join(f"\\fB{_text(name)}\\fR" for name in action.option_strings)
    return command_line.option(action, names, _value(action))


def _value(action):
    return f"\\fI{_text(action.metavar or action.dest.upper())}\\fR"


def _paragraphs(text):
    """Paragraphs of a docstring; indented ones are kept as they are."""
    lines = []
    for number, paragraph in enumerate(re.split("\n{2,}", text)):
        block = paragraph.split("\n")
        if all(line.startswith("  ") for line in block):
            lines += _literal(block)
        else:
            if number:
                lines.append(".PP")
            lines.append(_prose(" ".join(block)))
    return lines


def _entries(text):
    """A paragraph for each indented line; lines that are indented more continue the one before."""
    return [
        line
        for entry in re.split("\n  (?! )", "\n" + text.rstrip())[1:]
        for line in (".PP", _text(" ".join(entry.split())))
    ][1:]


# ---- the overview ----


def _overview(language, text, commands, date):
    name, description, titles, see_also = SECTIONS[language]
    parts = sections(text)
    lines = [
        _header("rtshell_lite", 7, date),
        ".SH " + name,
        "rtshell_lite \\- " + _text(SUMMARIES[language]),
        ".SH " + description,
    ]
    lines += _markdown(parts["rtshell_lite"])
    for title in titles:
        lines += [".SH " + title.upper()] + _markdown(parts[title])
    links = [f"\\fB{command}\\fR(1)" for command in sorted(commands)]
    return _page(lines + [".SH " + see_also, ", ".join(links)])


def _markdown(text):
    """The subset of Markdown in our READMEs:
    paragraphs, code, tables whose first column names what the others describe.
    """
    lines = []
    for block in re.findall(r"```.*\n(?:.*\n)*?```|(?:(?!```).+\n?)+", text):
        rows = block.rstrip("\n").split("\n")
        if rows[0].startswith("```"):
            lines += _literal(["  " + row for row in rows[1:-1]])
        elif rows[0].startswith("    "):
            lines += _literal([row[2:] for row in rows])
        elif rows[0].startswith("!["):
            continue  # a picture
        elif rows[0].startswith("|"):
            for row in rows[2:]:
                first, *others = [cell.strip() for cell in row.strip("|").split(" | ")]
                if first.startswith("**"):
                    lines += [".PP", f"\\fI{_text(first.strip('*'))}\\fR"]
                else:
                    lines += [".TP", _prose(first), _prose(" ".join(others))]
        else:
            lines += [".PP", _prose(_joined(rows))]
    return lines


def _joined(rows):
    """The lines of a paragraph; between Japanese characters a line end is not a blank."""
    text = rows[0].strip()
    for row in rows[1:]:
        row = row.strip()
        if not _wide(text[-1]) or not _wide(row[0]):
            text += " "
        text += row
    return text


# ---- troff ----


def _text(s):
    """Plain text for troff; characters beyond ASCII are written so that every troff can show them."""
    s = s.replace("\\", "\\e").replace("-", "\\-")
    s = "".join(map(_character, s))
    # Japanese lines may break between any two characters except before 、。 and closing brackets
    s = re.sub("([\u3000-\u9fff\uff00-\uffef])(?=[\u3010-\u9fff])", r"\1\\:", s)
    if s[:1] in (".", "'"):
        return "\\&" + s
    return s


def _character(c):
    if c < "\x80" or _wide(c):
        return c
    return f"\\[u{ord(c):04X}]"


def _wide(c):
    return "\u3000" <= c <= "\uffef"


def _prose(s):
    """Text with `code` in bold and [links](elsewhere) as their text."""
    s = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", s)
    text = ""
    for number, piece in enumerate(s.split("`")):
        if number % 2:
            text += f"\\fB{_text(piece)}\\fR"
        else:
            text += _text(piece)
    return text


def _literal(lines):
    """Lines that stay as they are, each indented by two blanks or more;
    if they are too wide, remarks beside them go below.
    """
    if max(map(len, lines)) > WIDEST:
        lines = "\n".join(re.sub(r"(?<=\S) {2,}", "\n        ", line, 1) for line in lines).split("\n")
    return [".PP", ".RS 2", ".nf"] + [_text(line[2:]) or "\\&" for line in lines] + [".fi", ".RE"]
