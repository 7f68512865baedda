"""Targets of fuzz.py in its own process: paths, profiles, log files, IDL files, constructor expressions, CDR
values.
"""
import glob
import json
import os
import re
import tempfile
import zlib

import random_profiles
import random_values
import simpkl_files
from fuzz import DATA, TESTS, Crash, Refused, Target, same, spoilt
from rtshell_lite import errors, path, text
from rtshell_lite.giop import descriptors, marshal
from rtshell_lite.data import call_values, datatypes, defaults, literals, type_json, values
from rtshell_lite.data.idl import parser
from rtshell_lite.datalog import decode, logfile, mcap, records, tables, writer
from rtshell_lite.xmlprofile import rtsprofile

IDL = os.path.join(os.path.dirname(TESTS), "rtshell_lite", "idl_stubs", "idl")


def content(name):
    with open(name, "rb") as file:
        return file.read()


def files(*parts):
    return sorted(
        name for name in glob.glob(os.path.join(glob.escape(parts[0]), *parts[1:])) if os.path.isfile(name)
    )


# ---- paths ----

class Paths(Target):
    name = "paths"
    words = [
        b"/",
        b":",
        b".",
        b"\\",
        b"\\e",
        b"\\x1b",
        b"\\xff",
        b"\\u202e",
        b"\\U0010ffff",
        b"\\U00110000",
        b"..",
        b"//",
        b"#",
        b"[::1]",
        b":2809",
        b"http://",
        b"corbaloc:",
        b"\xff",
        b".rtc",
        b" ",
        b"-rf",
        b"%s",
        b"{}",
    ]
    seeds = [
        b"/localhost/robot.host_cxt/ConsoleIn0.rtc:out",
        b"../a.b.c/./d:p/",
        b"/[::1]:2809/x",
        b"/https://h:1/p#NameService/x.rtc",
        b"diop:h:1/a",
        b"/h:65535/\\/\\:\\.\\\\/\\xff.\\u65e5",
        b"/",
    ]

    def check(self, data):
        typed = data.decode("utf-8", "surrogateescape")
        try:
            found = path.parse(typed, "/localhost/x")
        except errors.BadPath as e:
            raise Refused(str(e))
        spelt = str(found)
        if not spelt.isprintable():
            raise Crash("not printable: %r" % spelt)
        same(path.parse(spelt, "/"), found._replace(directory=False), "typed again")


# ---- profiles ----

class Profiles(Target):
    def prepare(self):
        real = []
        above = TESTS
        while above != os.path.dirname(above) and not real:
            above = os.path.dirname(above)
            real = files(above, "shared", "data", "profiles", "*")
        known = [
            content(name)
            for kind in ("valid", "invalid")
            for name in files(DATA, kind, "*.*")
            if not name.endswith(".error")
        ]
        made = [
            rtsprofile.dump(random_profiles.Maker(seed).profile(), self.name).encode(
                "utf-8", "surrogateescape"
            )
            for seed in range(20)
        ]
        self.seeds = [seed for seed in known + made + [content(name) for name in real]
                      if len(seed) < 40000 and rtsprofile.form_of(seed) == self.name]

    def check(self, data):
        try:
            profile = rtsprofile.load(data, "case")
        except errors.BadProfile as e:
            raise Refused(str(e))
        for form in (rtsprofile.XML, rtsprofile.YAML):
            same(rtsprofile.load(rtsprofile.dump(profile, form), "again"), profile, "written as " + form)


class Xml(Profiles):
    name = rtsprofile.XML
    words = [
        b"<",
        b">",
        b"&",
        b'"',
        b"/>",
        b"<a>",
        b"</a>",
        b"xmlns=",
        b"rts:",
        b"]]>",
        b"<![CDATA[",
        b"<!--",
        b"<?",
        b"&#0;",
        b"&lt;",
        b"<!DOCTYPE a [",
        b'encoding="utf-16"',
        b' xmlns:rts="urn:a"',
        b"_x001B_",
        b"<rts:Components ",
        b"xsi:type=",
    ]


class Yaml(Profiles):
    name = rtsprofile.YAML
    words = [
        b":",
        b": ",
        b"- ",
        b"? ",
        b"#",
        b" #",
        b"|\n",
        b">\n",
        b"|2-\n",
        b"&a ",
        b"*a",
        b"!!int ",
        b"!!binary ",
        b"{",
        b"}",
        b"[",
        b"]",
        b",",
        b"---\n",
        b"...\n",
        b"%",
        b"@",
        b"\\",
        b"\\u",
        b"~",
        b"null",
        b"1e999",
        b"\t",
        b"\n",
        b"\n  ",
        b"'",
        b'"',
        b"<<: ",
        b".nan",
        b"2010-01-02",
        b"\xef\xbb\xbf",
        b"1:59:59",
        b"\n  &b\n  !!str",
        b"0x" + b"f" * 298,
    ]


# ---- log files ----

class Logs(Target):
    name = "logs"
    words = [bytes([number]) for number in range(256)] + [
        mcap.MAGIC,
        mcap.BIG,
        mcap.LITTLE,
        b'"',
        b"[",
        b"]",
        b"{",
        b"null",
        b"cdr",
        b"json",
        b"ros2msg",
        b"omgidl",
        b"cos\nsystem\n",
        b"R.",
        b"\x8c\x05",
    ]

    def prepare(self):
        self._directory = tempfile.TemporaryDirectory()
        self.file = os.path.join(self._directory.name, "log")
        self.seeds = [simpkl_files.log(simpkl_files.values(3), protocol) for protocol in (0, 2, 4)]
        self.seeds += [
            simpkl_files.python2_log(simpkl_files.values(3)),
            self._own(4, True),
            self._own(30, False),
        ]

    def done(self):
        self._directory.cleanup()

    def _own(self, count, closed):
        long, texts = (
            datatypes.Type(_everything()["IDL:RTC/" + name + ":1.0"])
            for name in ("TimedLong", "TimedStringSeq")
        )
        channels = [
            records.Channel("a", long.id, long.to_bytes(), ("/x:a",)),
            records.Channel("b", "IDL:Own:1.0", b"", ("/x:b", "/y")),
            records.Channel("c", texts.id, texts.to_bytes(), ()),
        ]
        out = writer.LogWriter(self.file, channels, 10 ** 18)
        data = [long.encode(values.Expression("1", None, long).value(1.5)), b"own", texts.encode(
            values.Expression('["a", "\\u65e5"]', None, texts).value(1.5))]
        out.write([(i % 3, 10 ** 18 + i * 10 ** 6, True, data[i % 3]) for i in range(count)])
        if closed:
            out.close()
        else:
            out._file.close()
            out._indexes.close()
        return content(self.file)

    def make(self, rng):
        """Half of the cases of MCAP have good lengths and checksums, so that what follows them is fuzzed,
        too.
        """
        data = rng.choice(self.seeds)
        if not data.startswith(mcap.MAGIC) or rng.random() < 0.5:
            return spoilt(rng, data, self.words, self.seeds)
        octets = data[len(mcap.MAGIC):]
        return mcap.MAGIC + self._rebuilt(
            rng, octets[: -len(mcap.MAGIC)] if octets.endswith(mcap.MAGIC) else octets, data
        )

    def _rebuilt(self, rng, octets, data):
        """Records, of which one or two are spoilt; those within a chunk, too."""
        bodies = [(kind, octets[start:end]) for kind, _, start, end in mcap.walk(octets)]
        for _ in range(rng.choice((1, 1, 2))):
            chance = rng.random()
            at = rng.randrange(len(bodies))
            kind, body = bodies[at]
            if chance < 0.1:
                del bodies[at]
            elif chance < 0.2:
                bodies.insert(at, rng.choice(bodies))
            elif kind == mcap.CHUNK and chance < 0.7:
                inner = spoilt(rng, body[40:], self.words, [data])
                bodies[at] = (
                    kind,
                    mcap.CHUNK_HEAD.pack(0, 1 << 62, len(inner), zlib.crc32(inner))
                    + mcap.string("")
                    + len(inner).to_bytes(8, "little")
                    + inner,
                )
            else:
                bodies[at] = (
                    rng.choice((kind, kind, kind, rng.randrange(1, 16))),
                    spoilt(rng, body, self.words, [data]),
                )
            bodies = bodies or [(1, b"")]
        return b"".join(mcap.record(kind, body) for kind, body in bodies) + mcap.MAGIC

    def check(self, data):
        with open(self.file, "wb") as file:
            file.write(data)
        types = _Some(_everything())
        try:
            with logfile.load(self.file) as log:
                entries = list(log.entries())
                decoder = decode.Decoder(log, types)
                told = list(log.notes()) + list(decode.summary(log))
                text.json_line(decode.as_dict(log))
                for entry in entries:
                    told.append(decoder.line(entry, 20))
                    json.loads(text.json_line(decoder.record(entry)))
                told += tables.lines(decoder, entries)
        except errors.Failed as e:
            raise Refused(str(e))
        for line in told:
            if not line.isprintable():
                raise Crash("not printable: %r" % line)
        if log.form == "mcap" and all(entry.data is not None for entry in entries):
            self._again(log, entries)

    def _again(self, log, entries):
        out = writer.LogWriter(self.file, log.channels, log.started)
        out.write([(entry.channel, entry.received, entry.little, entry.data) for entry in entries])
        out.close()
        with logfile.load(self.file) as again:
            same(again.channels, log.channels, "channels")
            same(
                [entry._replace(number=0) for entry in again.entries()],
                [entry._replace(number=0) for entry in entries],
                "entries",
            )


# ---- IDL files ----

class Idl(Target):
    name = "idl"

    def prepare(self):
        self._directory = tempfile.TemporaryDirectory()
        self.file = os.path.join(self._directory.name, "case.idl")
        self.seeds = [
            content(name)[:6000] for name in files(DATA, "idl", "*", "*.idl") + files(IDL, "*", "*.idl")
        ]
        self.words = sorted(set(re.findall(rb"\w+|[^\w\s]+", b" ".join(self.seeds)))) + [
            b"#include ",
            b"#define A ",
            b"::",
            b"<<",
            b'L"',
        ]

    def done(self):
        self._directory.cleanup()

    def check(self, data):
        with open(self.file, "wb") as file:
            file.write(data)
        try:
            contents = parser.read_file(self.file, [os.path.join(DATA, "idl", "valid")])
        except (errors.BadIdl, errors.Failed) as e:
            raise Refused(str(e))
        for interface in list(contents.interfaces.values())[:20]:
            for operation in list(interface.all_operations().values())[:40]:
                self.check_operation(operation)
        for type_id, descriptor in contents.types.items():
            plain = type_json.plain(descriptor)
            try:
                again = type_json.descriptor(json.dumps(plain).encode())
            except errors.BadType as e:
                raise Crash("%s is read from IDL, and not from a log: %s" % (type_id, e))
            same(type_json.plain(again), plain, type_id)

    def check_operation(self, operation):
        """It can be printed, and its template sent, or there is a reason."""
        operation.idl()
        if operation.why_not_callable():
            return
        try:
            template = json.dumps(defaults.template(operation.inputs()))
        except errors.BadType:
            return
        arguments = call_values.of_json(operation, template, lambda name: self.fail(name))
        made = operation.schema().operation
        data = bytearray()
        for write, value in zip(made.arguments, arguments):
            write(data, value)
        maker = marshal.ValueMaker("<")
        at = 0
        for parameter in operation.inputs():
            _, at = maker.reader(parameter.type)(bytes(data), at)
        same(at, len(data), operation.idl())

    @staticmethod
    def fail(name):
        raise Crash("a template names the type %s" % name)


# ---- values ----

class _Some(datatypes.Types):
    """Only these types, so that no stubs are needed."""

    def __init__(self, known):
        datatypes.Types.__init__(self)
        self.known = known

    def _find(self, name):
        found = datatypes._best(self.known, name)
        return found and datatypes.Type(found)


_types = {}


def _everything():
    """Descriptors by their ids: of our own IDL files, and of the tests'."""
    if not _types:
        own = files(IDL, "data", "*.idl") + [
            os.path.join(DATA, "idl", "valid", name + ".idl") for name in ("unions", "recursive")
        ]
        for name in own:
            _types.update(parser.parse_file(name))
        for type_id in list(_types):
            try:
                datatypes.check(_types[type_id], type_id)
            except errors.BadType:
                del _types[type_id]
    return _types


def _through_every_form(one, value, types, speakable=True):
    """Check that a value comes back from bytes, from JSON and, if its types have valid names, from rtinject's
    form.
    """
    expected = random_values.plain(value)
    for little in (True, False):
        same(random_values.plain(one.decode(one.encode(value, little), little)), expected, "bytes")
    by_json = literals.Expression(json.dumps(values.json(value), allow_nan=False), types, one).value(0)
    same(random_values.plain(by_json), expected, "JSON")
    written = values.constructor(value)
    if speakable:
        same(random_values.plain(literals.Expression(written, types, one).value(0)), expected, written)
    if not values.text(value).isprintable():
        raise Crash("not printable: %r" % values.text(value))
    text.json_line(dict(values.flat(value)))


class Values(Target):
    """A case is the name of a type, or nothing, a line end, and a value as a user writes it."""

    name = "values"
    words = [
        b"(",
        b")",
        b"[",
        b"]",
        b"{",
        b"}",
        b",",
        b"=",
        b":",
        b"{time}",
        b"{{",
        b"}}",
        b"'",
        b'"',
        b"b'",
        b"\\x",
        b"\\ud800",
        b"NaN",
        b"-inf",
        b"None",
        b"True",
        b"0x",
        b"1e400",
        b"RTC.Time(1, 2)",
        b"RTC.TimedLong",
        b'"_d": ',
        b"data=",
        b"lambda:0",
        b"__import__('os')",
        b"\xe6\x97\xa5",
        b"::",
        b"..",
        b"-",
        b"_",
        b"GRIPPER_STATE_OPEN",
    ]
    written = [
        b"RTC.TimedLong({time}, 42)",
        b"RTC.TimedPose2D(data=RTC.Pose2D(RTC.Point2D(1, 2), heading=-inf))",
        b'{"data": [1, 2.5]}',
        b"RTC.TimedOctetSeq({time}, b'\\x00\\xff')",
        b"RTC.GripperState({time}, GRIPPER_STATE_OPEN)",
        b"[1, -2, 3.5e3]",
        b"RTC::TimedString(RTC.Time(sec=1, nsec=2), u'\\u65e5')",
        b'{"tm": {"sec": 1, "nsec": 2}, "data": "text"}',
        b"42",
        b"'x'",
    ]

    def prepare(self):
        self.types = _Some(_everything())
        self.seeds = [b"\n" + each for each in self.written]
        for type_id in sorted(_everything()):
            self.seeds += [type_id.encode() + b"\n" + each for each in self.written[:3]]

    def make(self, rng):
        name, _, written = rng.choice(self.seeds).partition(b"\n")
        if name and rng.random() < 0.7:
            value = random_values.value(rng, _everything()[name.decode()])
            form = values.constructor(value) if rng.random() < 0.5 else json.dumps(values.json(value))
            written = form.encode("utf-8", "surrogateescape")
        return name + b"\n" + spoilt(rng, written, self.words, self.written)

    def check(self, data):
        name, _, written = data.decode("utf-8", "surrogateescape").partition("\n")
        try:
            one = self.types.named(name) if name else None
            made = literals.Expression(written, self.types, one)
            data = made.type.encode(made.value(1.5))
        except (errors.BadValue, errors.NoSuch) as e:
            raise Refused(str(e))
        _through_every_form(made.type, made.type.decode(data), self.types)


class Cdr(Target):
    """A case is a type in the form of log files, on a line, and after it the bytes of a value."""

    name = "cdr"
    words = [
        b"\0",
        b"\1",
        b"\0\0\0\1",
        b"\1\0\0\0",
        b"\xfe\xff",
        b"\xff\xfe",
        b"\xd8\0",
        b"\x80",
        b"\2",
        b"\4",
    ]
    type_words = [
        b'"long"',
        b'"octet"',
        b'"any"',
        b'["see","IDL:S:1.0"]',
        b'["string",5]',
        b'["sequence","char",0]',
        b'"wchar"',
        b"[",
        b"]",
        b",",
        b'"',
        b"-1",
        b"null",
        b"{}",
        b'"fixed"',
        b"1e9",
        b'["array","double",3]',
    ]
    simple = [
        "short",
        "long",
        "unsigned short",
        "unsigned long",
        "float",
        "double",
        "boolean",
        "char",
        "octet",
        "long long",
        "unsigned long long",
        "wchar",
        ["string", 0],
        ["string", 9],
        ["wstring", 0],
        ["wstring", 3],
    ]

    def prepare(self):
        self.types = [datatypes.Type(each).to_bytes() for _, each in sorted(_everything().items())]

    def make(self, rng):
        as_json = rng.choice(self.types)
        if rng.random() < 0.6:
            self._count = 0
            as_json = json.dumps(self._random_type(rng, 5)).encode()
        try:
            one = datatypes.from_bytes(as_json)
            data = one.encode(random_values.value(rng, one.descriptor), rng.random() < 0.5)
        except (errors.Error, AssertionError, IndexError, KeyError):
            # types that have no values; `check` looks at them
            data = bytes(20)
        if rng.random() < 0.15:
            as_json = spoilt(rng, as_json, self.type_words, self.types).replace(b"\n", b"")
        return as_json + b"\n" + (spoilt(rng, data, self.words, [data]) if rng.random() < 0.8 else data)

    def _random_type(self, rng, depth, around=()):
        """A type as lists, texts and numbers (type_json.py)."""
        chance = rng.random()
        if depth == 0 or chance < 0.3:
            return rng.choice(self.simple)
        if chance < 0.5:
            return ["sequence", self._random_type(rng, depth - 1, around), rng.choice((0, 0, 1, 4))]
        if chance < 0.6:
            return ["array", self._random_type(rng, depth - 1, around), rng.randint(1, 3)]
        self._count += 1
        name = "T%d" % self._count
        type_id = "IDL:M/%s:1.0" % name
        if chance < 0.65:
            return ["alias", type_id, name, self._random_type(rng, depth - 1, around)]
        if chance < 0.75:
            return ["enum", type_id, name, ["E%d_%d" % (self._count, i) for i in range(rng.randint(1, 4))]]
        around += (type_id,)
        members = ["m%d" % i for i in range(rng.randint(1, 4))]
        if chance < 0.9:
            found = [[member, self._random_type(rng, depth - 1, around)] for member in members]
            if rng.random() < 0.2:
                found.append(["inner", ["sequence", ["see", rng.choice(around)], 0]])
            return ["struct", type_id, name, found]
        switch = rng.choice(["long", "short", "char", "unsigned long long"])
        labels = ["abcd"[i] if switch == "char" else i for i in range(len(members))]
        return [
            "union",
            type_id,
            name,
            switch,
            rng.randint(-1, len(members) - 1),
            [
                [label, member, self._random_type(rng, depth - 1, around)]
                for label, member in zip(labels, members)
            ],
        ]

    def check(self, data):
        as_json, _, data = data.partition(b"\n")
        try:
            one = datatypes.from_bytes(as_json)
            datatypes.check(one.descriptor, one.name)
        except errors.BadType as e:
            raise Refused(str(e))
        known = {}
        refused = None
        for _, inner in descriptors.walk(one.descriptor, ""):
            if descriptors.kind(inner) in (descriptors.STRUCT, descriptors.UNION, descriptors.ENUM):
                known[descriptors.type_id(inner)] = inner
        for little in (True, False):
            try:
                value = one.decode(data, little)
                one.encode(value, little)
            except errors.BadData as e:
                refused = e
                continue
            except errors.BadValue as e:
                # sloppy senders fill strings up with NULs, which is shown and not sent on
                if not str(e).endswith("holds no NUL"):
                    raise
                refused = e
                continue
            speakable = all(
                re.match(r"IDL:([A-Za-z]\w*/)*[A-Za-z]\w*:[\d.]+\Z", type_id, re.ASCII) for type_id in known
            )
            _through_every_form(one, value, _Some(known), speakable)
        if refused:
            raise Refused(str(refused))


TARGETS = [Paths, Xml, Yaml, Logs, Idl, Values, Cdr]
