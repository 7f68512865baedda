"""A log as lines: for people, as JSON. (tables.py: as a table.)"""

import sys

from rtshell_lite import text
from rtshell_lite.datalog import decode

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
