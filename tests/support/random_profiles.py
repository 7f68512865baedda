"""Random profiles: every section, every field, strings that are meant to break readers and writers."""
import random

from rtshell_lite.xmlprofile import fields, model, names

CHARACTERS = (
    "aZ0 19.:-_#'\"\\,[]{}&*!|>%@`?=~<x/+\n\t\r\x00\x07\x1b\x7f\x85\xa0\u2028\u2029\ufeff\ufffe\uffffé日\U0001f600"  # noqa: E501
    "\ud800\udc80"
)
WORDS = [
    "", " ", "\n", "0", "010", "0x1F", "1:30", "1e3", "1_0", ".inf", ".nan", "true", "no", "On", "null",
    "~", "=", "<<", "- a", "? a", "---", "...", "a: b", "a #b", "a:", "#", "  x", "x  ", "a\nb", "a\n b",
    "a \n\nb\n", "2010-01-02", "2010-01-02T03:04:05Z", "]]>", "<!--", "&amp;", "&#10;", "<a/>", "_x001B_",
    "_x005F_", "_x005F_x001B_", "_x001B_x001B_", "_x001B\x1b", "_x0041_", "IDL:RTC/TimedLong:1.0",
    "RTC:A B, C:d:e:1", "../../etc/passwd", "a" * 300, "word two " * 20, "日本 " * 40,
]
NUMBERS = [0.0, 1.0, 1000.0, 0.1, 1e20, 1e-7, 1.35e-316, -2.5, float("inf"), -float("inf"), float("nan")]
DATES = ["2024-03-05T14:07:09", "2008-12-19T19:44:06.450+09:00", "2008-12-19T19:44:06Z",
         "0001-00-99T00:00:00.10", "2010-01-02", "soon", ""]
ATTRIBUTES = ["{urn:a}b", "{http://example.org/?a=1&b=2}c", "unknown", "{%s}lang" % names.XML,
              "{%s}new" % names.NAMESPACES["rts"], "{%s}nil" % names.NAMESPACES["xsi"]]
TAGS = ["{urn:a}b", "plain", "{urn:'\"<>}e", "{%s}Future" % names.NAMESPACES["rtsExt"], "日本"]


class Maker:
    def __init__(self, seed):
        self.random = random.Random(seed)

    def text(self):
        chance = self.random.random()
        if chance < 0.3:
            return self.random.choice(WORDS)
        if chance < 0.4:
            return self.random.choice(WORDS) + self.random.choice(WORDS)
        return "".join(self.random.choice(CHARACTERS) for _ in range(self.random.randint(0, 12)))

    def number(self):
        return self.random.choice(NUMBERS + [self.random.uniform(-1e3, 1e3)])

    def date(self):
        return self.random.choice(DATES + [self.text()])

    def value(self, field):
        if field.choices:
            return self.random.choice(sorted(set(field.choices.values())) + ["OfTheFuture"])
        return {
            fields.BOOLEAN: lambda: self.random.random() < 0.5,
            fields.NUMBER: self.number,
            fields.DATE: self.date,
            fields.INTEGER: lambda: self.random.choice([0, -1, 500, self.random.randint(-(10**17), 10**17)]),
        }.get(field.kind, self.text)()

    def element(self, cls, most=2):
        values = {}
        for field in cls.FIELDS:
            if field.many:
                values[field.name] = [self.child(field) for _ in range(self.random.randint(0, most))]
            elif field.child:
                if field.required or self.random.random() < 0.5:
                    values[field.name] = self.child(field)
            elif field.required or self.random.random() < 0.7:
                values[field.name] = self.value(field)
        element = cls(**values)
        if isinstance(element, model.Connector) and not element.ends:
            element.source = self.element(model.TargetPort)
        if self.random.random() < 0.15:
            element.foreign = self.foreign(cls) or None
        return element

    def child(self, field):
        return self.text() if field.kind == fields.TEXT else self.element(field.kind)

    def profile(self):
        return self.element(model.RtsProfile, 3)

    def foreign(self, cls):
        foreign = fields.Foreign()
        table = names.table(cls)
        for _ in range(self.random.randint(0, 2)):
            name = self.random.choice(ATTRIBUTES)
            foreign.attributes[name] = self.text()
        for _ in range(self.random.randint(0, 2)):
            foreign.elements.append(self.foreign_element())
        for _ in range(self.random.randint(0, 2)):
            key = self.text()
            if key not in table.loose_keys and key not in table.wrappers:
                foreign.keys[key] = self.data()
        return foreign

    def foreign_element(self, depth=0):
        tag = self.random.choice(TAGS)
        content = [self.text() if self.random.random() < 0.5 or depth > 2 else self.foreign_element(depth + 1)
                   for _ in range(self.random.randint(0, 3))]
        return fields.ForeignElement(tag, {"{urn:a}b": self.text()} if depth else {}, fields.tidy(content))

    def data(self, depth=0):
        """Plain data for YAML."""
        chance = self.random.random()
        if depth > 3 or chance < 0.4:
            return self.text()
        if chance < 0.6:
            return self.random.choice([None, True, False, 0, -5, 10 ** 20, self.number(), b"\x00\xff"])
        if chance < 0.8:
            return [self.data(depth + 1) for _ in range(self.random.randint(0, 3))]
        return {self.text(): self.data(depth + 1) for _ in range(self.random.randint(0, 3))}
