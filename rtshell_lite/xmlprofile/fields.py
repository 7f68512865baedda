"""What the classes of an RtsProfile (model.py) are made of:
fields with their names in files, elements, foreign parts.
"""

import itertools

from rtshell_lite.records import cached

TEXT = "text"
BOOLEAN = "true or false"
INTEGER = "whole number"
NUMBER = "number"
DATE = "date"


class Field:
    """A part of an element: its name here, its name in a file, what it holds, when it is written."""

    child = many = False

    def __init__(
        self, name, tag, kind=TEXT, default="", required=False, always=False, choices=None, also=(), key=None
    ):
        """A value, an attribute in XML. `always`: written even if it has its default.
        `also`: misspellings to accept.
        """
        self.name = name
        self.tag = tag
        self.prefix, self.local = tag.split(":")
        self.kind = kind
        self.default = default
        self.required = required
        self.always = always
        self.choices = choices
        self.also = also
        if key is None:
            key = self.local[0].lower() + self.local[1:]
            if self.prefix != "rts":
                key = f"{self.prefix}::{key}"
        self.key = key
        self.within = None  # the key of a mapping that YAML puts around it
        self.is_text = kind == DATE or kind == TEXT and not choices  # it is in XML as it is here


class Child(Field):
    """An element inside an element, or None."""

    child = True

    def __init__(self, name, tag, kind, required=False, within=None, also=()):
        super().__init__(name, tag, kind, None, required, also=also)
        self.within = within


class Children(Child):
    """Any number of elements inside an element, a list; those of kind TEXT are str."""

    many = True


class Foreign:
    """What the schema does not have, kept for writing.

    attributes  XML attributes, {"{namespace}name": text}
    elements    ForeignElement
    keys        YAML keys with plain data
    """

    def __init__(self):
        self.attributes = {}
        self.elements = []
        self.keys = {}

    def __bool__(self):
        return bool(self.attributes or self.elements or self.keys)

    def __eq__(self, other):
        return (
            isinstance(other, Foreign)
            and self.attributes == other.attributes
            and self.elements == other.elements
            and same(self.keys, other.keys)
        )

    __hash__ = None


def foreign(values):
    """The Foreign among the values of an element by field name, made when it is first needed."""
    if "foreign" not in values:
        values["foreign"] = Foreign()
    return values["foreign"]


class ForeignElement:
    """An XML element that the schema does not have; `content` is a list of str and ForeignElement."""

    def __init__(self, tag, attributes=None, content=None):
        self.tag = tag
        self.attributes = attributes or {}
        self.content = content or []

    def __eq__(self, other):
        return isinstance(other, ForeignElement) and self.__dict__ == other.__dict__

    __hash__ = None


def tidy(content):
    """The content of an XML element with adjacent texts joined,
    and without blanks that only indent children.
    """
    if not content or len(content) == 1 and content[0] != "":
        return content
    joined = []
    for is_text, items in itertools.groupby(content, lambda item: isinstance(item, str)):
        if is_text:
            joined += ["".join(items)]
        else:
            joined += items
    if len(joined) == 1:
        return [item for item in joined if item != ""]
    return [item for item in joined if not isinstance(item, str) or item.strip(" \t\r\n")]


@cached(64)
def _blank(cls):
    """({name: default} of the fields of a class of elements, names of those that are lists)."""
    defaults = {field.name: field.default for field in cls.FIELDS}
    defaults["foreign"] = None
    return defaults, [field.name for field in cls.FIELDS if field.many]


@cached(64)
def _required(cls):
    return [field for field in cls.FIELDS if field.required]


class Element:
    """The base of the classes of model.py: fields by name, equality."""

    FIELDS = ()
    XSI_TYPE = None  # the xsi:type in XML; rtsprofile writes it on some elements only, and so do we
    comments_before = (
        comments_inside
    ) = ()  # of XML: texts before the element, and after the last element inside; no part of its value

    def __init__(self, **values):
        own = self.__dict__
        defaults, lists = _blank(type(self))
        own.update(defaults)
        for name in lists:
            own[name] = []
        count = len(own)
        own.update(values)
        if len(own) > count:
            unknown = ", ".join(list(own)[count:])
            raise TypeError(f"{type(self).__name__} has no {unknown}")

    def __eq__(self, other):
        if type(self) is not type(other) or (self.foreign or None) != (other.foreign or None):
            return False
        return all(same(getattr(self, field.name), getattr(other, field.name)) for field in self.FIELDS)

    __hash__ = None

    def __repr__(self):
        values = [(field.name, getattr(self, field.name), field.default) for field in self.FIELDS]
        shown = ", ".join(
            f"{name}={value!r}" for name, value, default in values if value != default and value != []
        )
        return f"{type(self).__name__}({shown})"

    def fault(self, given):
        """What is wrong with this element, of which a file has the fields `given`, or None."""
        missing = [field.local for field in _required(type(self)) if field.name not in given]
        return f"{missing[0]} is missing" if missing else None

    def property(self, name, default=None):
        """The value of the extended property `name` (the first one:
        files repeat names), which may be None.
        """
        for item in getattr(self, "properties", ()):
            if item.name == name:
                return item.value
        return default


def same(a, b):
    """Whether two values are equal; NaN equals NaN."""
    if isinstance(a, dict) and isinstance(b, dict):
        return a.keys() == b.keys() and all(same(a[key], b[key]) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(same(x, y) for x, y in zip(a, b))
    return a == b or (a != a and b != b)
