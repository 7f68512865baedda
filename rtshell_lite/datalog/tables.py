"""A log as tables of comma-separated values: a line an entry, a column a field, all decoded once.

The columns are `number`, `time`, `port`, then the fields in the order of their appearance: `data.x`,
`joints[0]`. Times are seconds, with nine digits, or whole nanoseconds; the timestamp of a value is one
column, `tm`.
"""

import operator
import os
import re
import struct
import tempfile

from rtshell_lite import files
from rtshell_lite.data import build_value, values
from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import (
    ARRAY, CHAR, ENUM, OCTET, SEQUENCE, STRING, STRUCT, WCHAR, WSTRING, kind
)
from rtshell_lite.giop.fixed_size import Forms, fixed
from rtshell_lite.text import printable

ROWS = 1000  # that are written at a time
SPOOL = 4 << 20  # characters of lines that wait in memory for their columns; more are in a temporary file
PLAIN, TEXT, TIME, NAME, OCTETS, NUMBERS, OTHER = range(7)
HEAD = ("number", "time", "port")
_ODD = re.compile('[",\r\n]')


class Table:
    """Lines of a table: `columns` are those so far, {name: place}."""

    def __init__(self, decoder, is_ns=False):
        """`decoder`: decode.Decoder."""
        self.decoder = decoder
        self.columns = {name: index for index, name in enumerate(HEAD)}
        self._is_ns = is_ns
        # by channel: its name as a cell; _Numbers, or None; [(column, function, sort)], None where it has no
        # such form
        self._plans = {}
        # by channel and lengths of its sequences: the columns of its cells; None: as they come
        self._cell_columns = {}

    def head(self):
        """The line with the names of the columns."""
        return ",".join(map(cell, self.columns))

    def row(self, entry):
        """The cells of an entry, one for each column known so far, at most."""
        if entry.channel not in self._plans:
            self._plans[entry.channel] = self._plan(entry.channel)
        port, numbers, plan = self._plans[entry.channel]
        cells = [str(entry.number), self._time(divmod(entry.received, 10**9)), port]
        if numbers is not None and entry.data is not None:
            row = numbers.cells(entry, self._time)
            if row is not None:
                return self._place_cells(cells, numbers.names, row, (entry.channel, ()))
        formed = self.decoder.form_value(entry, lambda value: self._cells(value, plan))
        if formed is None:
            names, row = self._cells_without_type(entry)
            return self._place_cells(cells, names, row, None)
        sizes, row, names = formed
        return self._place_cells(cells, names, row, (entry.channel, sizes))

    def _time(self, parts):
        return str(parts[0] * 10**9 + parts[1]) if self._is_ns else "%d.%09d" % parts

    def _plan(self, number):
        channel = self.decoder.log.channels[number]
        type = self.decoder.type(number)
        numbers = None
        plan = None
        if type is not None and kind(descriptors.target(type.descriptor)) == STRUCT:
            plan = _parts(descriptors.target(type.descriptor), "")
            numbers = _numbers(type.descriptor, plan)
        return cell(printable(channel.name)), numbers, plan

    def _cells(self, value, plan):
        """(lengths of sequences, cells, a function for the names of their columns) of a value."""
        row = []
        if plan is None:
            pairs = self._flat(value, "")
            return None, [scalar for _, scalar in pairs], lambda: [name for name, _ in pairs]
        sizes = []
        others = {}
        for column, get, sort in plan:
            part = get(value)
            if sort == PLAIN:
                row.append(str(part))
            elif sort == NUMBERS:
                row += map(str, part)
                sizes.append(len(part))
            elif sort == TIME:
                row.append(self._time(divmod(part.sec * 10**9 + part.nsec, 10**9)))
            elif sort == NAME:
                row.append(part._n)
            elif sort == TEXT:
                row.append(cell(printable(part)))
            elif sort == OCTETS:
                row.append(part.hex())
            else:
                pairs = self._flat(part, column)
                others[column] = [name for name, _ in pairs]
                row += [scalar for _, scalar in pairs]
        sizes = None if others else tuple(sizes)
        return sizes, row, lambda: _names(plan, others, value)

    def _flat(self, value, column):
        """[(column, cell)] of any value."""
        pairs = []
        for name, scalar in values.flat(value):
            if column and name:
                name = column + ("" if name.startswith("[") else ".") + name
            pairs.append((name or column, cell(_words(scalar))))
        return pairs

    def _cells_without_type(self, entry):
        """(function for the names, cells) of an entry whose type is not known, or that does not fit it."""
        if entry.data is not None:
            return lambda: ["hex"], [entry.data.hex()]
        pairs = self._flat(entry.value, "")
        return lambda: [name for name, _ in pairs], [words for _, words in pairs]

    def _place_cells(self, head, names, scalars, key):
        """The cells in their columns; `key` names a combination of columns that may come again, or
        is None.
        """
        if key is None or key[1] is None or key not in self._cell_columns:
            columns = [self.columns.setdefault(printable(name), len(self.columns)) for name in names()]
            if columns == list(range(len(head), len(head) + len(columns))):
                columns = None
            if key is not None and key[1] is not None:
                self._cell_columns[key] = columns
        else:
            columns = self._cell_columns[key]
        if columns is None:
            return head + scalars
        row = head + [""] * (max(columns) + 1 - len(head))
        for column, scalar in zip(columns, scalars):
            row[column] = scalar
        return row


def _words(scalar):
    if scalar is None:
        return ""
    return printable(scalar) if isinstance(scalar, str) else str(scalar)


def cell(words):
    """Text as a cell."""
    return '"' + words.replace('"', '""') + '"' if _ODD.search(words) else words


def _parts(descriptor, path):
    """[(column, function that gets the part of a value, sort)] of a struct."""
    parts = []
    for member, inner in descriptors.members(descriptor):
        inner = descriptors.target(inner)
        name = path + member
        sort = _sort(inner)
        if sort == OTHER and kind(inner) == STRUCT:
            parts += _parts(inner, name + ".")
        else:
            parts.append((name, operator.attrgetter(name), sort))
    return parts


class _Numbers:
    """A struct of nothing but numbers and times: its cells are made of its octets, with no values between."""

    def __init__(self, codes, parts):
        self._layouts = {True: Forms("<", codes)[0], False: Forms(">", codes)[0]}
        self._columns = [name for name, _, _ in parts]
        self._times = []  # where there are times, from the right: two numbers become one cell
        index = 0
        for _, _, sort in parts:
            if sort == TIME:
                self._times.insert(0, index)
                index += 1
            index += 1

    def names(self):
        return self._columns

    def cells(self, entry, spell):
        """The cells of an entry; None where it ends too early.
        spell((seconds, nanoseconds)): a time in words.
        """
        try:
            numbers = self._layouts[entry.little].unpack_from(entry.data)
        except struct.error:
            return None
        row = list(map(str, numbers))
        for index in self._times:
            row[index : index + 2] = [spell(divmod(numbers[index] * 10**9 + numbers[index + 1], 10**9))]
        return row


def _numbers(descriptor, parts):
    """The _Numbers of a type with these _parts, or None."""
    form = fixed(descriptor)
    if form is None or any(sort not in (PLAIN, TIME) for _, _, sort in parts):
        return None
    return _Numbers(form.codes, parts)


def _sort(inner):
    if kind(inner) == STRUCT and build_value.is_time(inner):
        return TIME
    if kind(inner) == ENUM:
        return NAME
    if kind(inner) in (STRING, WSTRING, CHAR, WCHAR):
        return TEXT
    if kind(inner) in (SEQUENCE, ARRAY):
        element = descriptors.target(descriptors.element(inner))
        if element == OCTET:
            return OCTETS
        if element in descriptors.VALUES and element not in (CHAR, WCHAR):
            return NUMBERS
        return OTHER
    if inner in descriptors.VALUES:
        return PLAIN
    return OTHER


def _names(plan, others, value):
    names = []
    for column, get, sort in plan:
        if sort == NUMBERS:
            names += [f"{column}[{number}]" for number in range(len(get(value)))]
        elif sort == OTHER:
            names += others[column]
        else:
            names.append(column)
    return names


# ---- whole tables ----


class _Spool:
    """Rows of a Table that wait until all columns are known."""

    def __init__(self, table):
        self._table = table
        self._rows = []
        self._file = tempfile.SpooledTemporaryFile(SPOOL, "w+", encoding="utf-8", newline="\n")

    def add(self, entry):
        row = self._table.row(entry)
        self._rows.append("%d %s\n" % (len(row), ",".join(row)))
        if len(self._rows) >= ROWS:
            self._flush()

    def _flush(self):
        with files.Naming(tempfile.gettempdir()):
            self._file.write("".join(self._rows))
        self._rows.clear()

    def lines(self):
        """The head, and all rows with all columns; it is closed then."""
        total = len(self._table.columns)
        self._flush()
        with self._file:
            yield self._table.head()
            self._file.seek(0)
            for line in self._file:
                count, _, row = line[:-1].partition(" ")
                yield row + "," * (total - int(count))


def lines(decoder, entries, is_ns=False):
    """The lines of one table of all entries."""
    spool = _Spool(Table(decoder, is_ns))
    for entry in entries:
        spool.add(entry)
    return spool.lines()


def write(decoder, entries, directory, is_ns=False):
    """Write a table for each channel into a directory; returns their names. Raises OSError, errors.Failed."""
    spools = {}
    for entry in entries:
        if entry.channel not in spools:
            spools[entry.channel] = _Spool(Table(decoder, is_ns))
        spools[entry.channel].add(entry)
    os.makedirs(directory, exist_ok=True)
    names = []
    for number, spool in sorted(spools.items()):
        names.append(os.path.join(directory, _file_name(decoder.log.channels[number].name, names)))
        with files.Naming(names[-1]):
            with files.Temporary(files.destination(names[-1])) as temporary, temporary.file as file:
                file.writelines(line.encode("utf-8", "backslashreplace") + b"\n" for line in spool.lines())
                file.flush()
                temporary.take_place()
    return names


def _file_name(channel, taken):
    """The name of a file for a channel, which no other has."""
    stem = re.sub(r"[^A-Za-z0-9._-]+", "-", channel).strip("-.")[-100:] or "channel"
    name = stem + ".csv"
    number = 1
    while any(os.path.basename(other) == name for other in taken):
        number += 1
        name = f"{stem}-{number}.csv"
    return name
