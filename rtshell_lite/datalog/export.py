"""A log as lines: for people, as JSON, as a table."""
import csv
import io
import sys

from rtshell_lite import text
from rtshell_lite.datalog import meaning
from rtshell_lite.text import printable

LONG = 8  # elements of a sequence that are shown on a terminal


def lines(channels, entries):
    """The entries of a log as lines for people."""
    limit = LONG if sys.stdout.isatty() else None
    return (meaning.line(channels, entry, limit) for entry in entries)


def json_lines(channels, entries):
    """The same entries as JSON, one object a line."""
    return (text.json_line(meaning.record(channels, entry)) for entry in entries)


def csv_lines(channels, before, entries):
    """The same entries as rows of a table; `before` iterates over the same entries, to find all columns first."""
    columns = {}
    for entry in before:
        for name, _ in _cells(channels, entry):
            columns.setdefault(name, len(columns))
    channels.unreadable = 0
    line = io.StringIO()
    table = csv.DictWriter(line, list(columns) or ["number", "received", "port"], lineterminator="")
    table.writeheader()
    yield _taken(line)
    for entry in entries:
        table.writerow(dict(_cells(channels, entry)))
        yield _taken(line)


def _cells(channels, entry):
    """(column, scalar) of an entry; text is made printable, for tables are shown on terminals."""
    for column, scalar in meaning.cells(channels, entry):
        yield printable(column), printable(scalar) if isinstance(scalar, str) else scalar


def _taken(line):
    row = line.getvalue()
    line.seek(0)
    line.truncate()
    return row
