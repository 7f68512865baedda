"""A log as lines: for people, as JSON, as a table."""

import csv
import io
import sys

from rtshell_lite import text
from rtshell_lite.datalog import decode
from rtshell_lite.text import printable

LONG = 8  # elements of a sequence that are shown on a terminal


def people(channels):
    """A function that makes a line for people of an entry of a log."""
    if sys.stdout.isatty():
        limit = LONG
    else:
        limit = None
    return lambda entry: decode.line(channels, entry, limit)


def json(channels):
    """A function that makes a line of JSON of an entry."""
    return lambda entry: text.json_line(decode.record(channels, entry))


def table(channels, before):
    """(first line of a table, a function that makes a row of an entry);
    `before`: all entries, to find the columns.
    """
    columns = {}
    for entry in before:
        for name, _ in _cells(channels, entry):
            columns.setdefault(name, len(columns))
    channels.unreadable = 0
    line = io.StringIO()
    rows = csv.DictWriter(line, list(columns) or ["number", "received", "port"], lineterminator="")
    rows.writeheader()

    def row(entry):
        rows.writerow(dict(_cells(channels, entry)))
        return _taken(line)

    return _taken(line), row


def _cells(channels, entry):
    """(column, scalar) of an entry; text is made printable, for tables are shown on terminals."""
    for column, scalar in decode.cells(channels, entry):
        yield printable(column), printable(scalar) if isinstance(scalar, str) else scalar


def _taken(line):
    row = line.getvalue()
    line.seek(0)
    line.truncate()
    return row
