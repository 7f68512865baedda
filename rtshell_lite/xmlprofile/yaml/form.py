"""RtsProfile files in YAML: from the nodes of reader.py to the model, and from the model to plain data.

A file is a mapping with the key rtsProfile. Parts that the schema does not have are kept under keys of our
own:

    xml::attributes: {'{namespace}name': text}
    xml::elements: [{element: '{namespace}name', attributes: {...}, content: [text or element]}]
"""

import re

from rtshell_lite.xmlprofile import fields, model, names, values
from rtshell_lite.xmlprofile.yaml import document, reader, scalars, writer

ROOT = "rtsProfile"
# of the root, as in rtsprofile; tools sort the keys, so that a file that is cut off lacks its version
NEEDED = ("id", "version")
# elements below elements, as in xml.py: what is read here can be written as XML and read again
DEEPEST_XML = 64

_DATE = re.compile(r"(\d{4})-(\d\d)-(\d\d)T(\d\d):(\d\d):(\d\d)(\.\d+)?(Z|[-+]\d\d:\d\d)?\Z", re.ASCII)
_DATE_KEYS = ("year", "month", "day", "hour", "minute", "second")


def read(text, name):
    """The profile that a YAML file, str or bytes, holds. Raises BadProfile; `name` is for messages."""
    doc, root = reader.parse(text, name)
    if not isinstance(root.value, dict) or ROOT not in root.value:
        doc.fail(root.pos, f"not an RtsProfile: the key {ROOT} is missing")
    body = root.value[ROOT]
    table = names.table(model.RtsProfile)
    given = {table.loose_keys[key].name for key in body.value or () if key in table.loose_keys}
    profile = _element(doc, body, model.RtsProfile, 1)
    for needed in NEEDED:
        if needed not in given:
            doc.fail(body.pos, f"{needed} is missing; perhaps the file was cut off")
    if profile.version == "0.1":
        profile.version = "0.2"  # its spellings are understood; its other structure was only ever used in XML
    return profile


def write(profile):
    """The text of a YAML file."""
    return writer.write({ROOT: _data(profile)})


# ---- reading ----


def _element(doc, node, cls, depth):
    if _is_null(node):
        node = document.YamlNode({}, node.pos)  # `startUp:` alone
    if not isinstance(node.value, dict):
        doc.fail(node.pos, "a mapping is needed here")
    if depth > DEEPEST_XML:
        doc.fail(node.pos, "more than %d levels of elements" % DEEPEST_XML)
    table = names.table(cls)
    contents = {}
    others = []
    for key, value in _pairs(doc, node, table):
        field = table.keys.get(key)
        if field:
            _set(doc, contents, field, value, depth)
        else:
            others.append((key, value))
    for key, value in others:
        field = table.loose_keys.get(key)
        if field and field.name not in contents:
            _set(doc, contents, field, value, depth)
        elif key == names.ATTRIBUTES:
            fields.foreign(contents).attributes.update(_attributes(doc, value, table))
        elif key == names.ELEMENTS:
            fields.foreign(contents).elements += _elements(doc, value, table, depth + 1)
        elif field:
            doc.fail(value.pos, f"{values.shown(key)} was given before in another spelling")
        else:
            fields.foreign(contents).keys[key] = _plain(doc, value)
    element = cls(**contents)
    fault = element.fault(contents)
    if fault:
        doc.fail(node.pos, f"{cls.__name__}: {fault}")
    return element


def _pairs(doc, node, table):
    """Keys and values of a mapping, and of the mappings in it that only wrap some of its fields."""
    for key, value in node.value.items():
        if key not in table.wrappers:
            yield key, value
        elif isinstance(value.value, dict):
            for inner in value.value.items():
                if inner[0] in node.value:
                    doc.fail(inner[1].pos, f"{values.shown(inner[0])} is here and one level above")
                yield inner
        elif not _is_null(value):
            doc.fail(value.pos, "a mapping is needed here")


def _is_null(node):
    return node.tag in (None, "null") and node.value in scalars.NULLS


def _set(doc, contents, field, node, depth):
    """Put the value of a field into `contents`, unless it is null."""
    if field.many:
        if _is_null(node):
            return
        if not isinstance(node.value, list):
            doc.fail(node.pos, "a list is needed here")
        is_text = field.kind == fields.TEXT
        contents[field.name] = [
            _text(doc, item) if is_text else _element(doc, item, field.kind, depth + 1)
            for item in _each(doc, node)
        ]
    elif field.child:
        if not _is_null(node) or field.kind is model.MessageSending:
            contents[field.name] = _element(doc, node, field.kind, depth + 1)
    elif field.kind == fields.DATE and isinstance(node.value, dict):
        contents[field.name] = _date(doc, node)
    elif not _is_null(node):
        contents[field.name] = _value(doc, field, node)


def _each(doc, node):
    """The nodes in a list; what was read gives its memory back, unless it may be used again."""
    if doc.anchors:
        yield from node.value
        return
    node.value.reverse()
    while node.value:
        yield node.value.pop()


def _value(doc, field, node):
    """The value of a field that is not an element.
    Text stays as it is spelt: `id: 010` and `name: no` are text here.
    """
    text = _text(doc, node)
    try:
        if field.kind in (fields.BOOLEAN, fields.INTEGER, fields.NUMBER):
            value = scalars.plain(node)
            if isinstance(value, (bool, int, float)):
                return values.from_number(field, value)
        return values.from_text(field, text)
    except ValueError as e:
        doc.fail(node.pos, str(e))


def _text(doc, node):
    if not isinstance(node.value, str):
        doc.fail(node.pos, "text or a number is needed here")
    if node.tag == "binary":
        value = _plain(doc, node)
        return value.decode("utf-8", "surrogateescape")
    return node.value


def _plain(doc, node):
    try:
        return scalars.plain(node)
    except ValueError as e:
        doc.fail(node.pos, str(e))


def _date(doc, node):
    """The text of a date that is a mapping of six whole numbers, as in rtsprofile,
    and perhaps fraction and zone.
    """
    parts = {key: _plain(doc, value) for key, value in node.value.items()}
    numbers = [parts.pop(key, 0) for key in _DATE_KEYS]
    rest = "".join(str(parts.pop(key, "")) for key in ("fraction", "zone"))
    for key, value in zip(_DATE_KEYS, numbers):
        most = 9999 if key == "year" else 99
        if not isinstance(value, int) or not 0 <= value <= most:
            doc.fail(node.pos, f"not a date: {key} is {values.shown(value)}")
    text = "%04d-%02d-%02dT%02d:%02d:%02d" % tuple(numbers) + rest
    if parts or not _DATE.match(text):
        doc.fail(node.pos, "not a date of year, month, day, hour, minute, second")
    return text


# ---- reading foreign parts ----


def _attributes(doc, node, table=None):
    if not isinstance(node.value, dict):
        doc.fail(node.pos, "a mapping is needed here")
    for name, value in node.value.items():
        if (
            not names.is_clark(name)
            or table
            and (names.raw(name) in table.attributes or names.raw(name) == names.TYPE)
        ):
            doc.fail(value.pos, f"{values.shown(name)} cannot be an attribute here")
    return {name: _text(doc, value) for name, value in node.value.items()}


def _elements(doc, node, table, depth):
    """Elements that the schema does not have; `table` is that of the element around them."""
    if not isinstance(node.value, list):
        doc.fail(node.pos, "a list is needed here")
    return fields.tidy([_foreign_element(doc, item, table, depth) for item in node.value])


def _foreign_element(doc, node, table, depth):
    parts = dict(node.value) if isinstance(node.value, dict) else {}
    tag = parts.pop("element", None)
    start = tag or node
    tag = _text(doc, tag) if tag else ""
    attributes = _attributes(doc, parts.pop("attributes")) if "attributes" in parts else {}
    content = parts.pop("content", None)
    is_listed = not content or isinstance(content.value, list)
    if not names.is_clark(tag) or parts or depth > DEEPEST_XML or not is_listed:
        doc.fail(start.pos, "an element is needed here: its name, attributes and content")
    field = table and table.children.get(names.raw(tag))
    if field and field.kind != fields.TEXT:
        doc.fail(start.pos, f"{values.shown(tag)} is not a foreign element")
    listed = content.value if content else ()
    items = [
        _foreign_element(doc, item, None, depth + 1) if isinstance(item.value, dict) else _text(doc, item)
        for item in listed
    ]
    return fields.ForeignElement(tag, attributes, fields.tidy(items))


# ---- writing ----


def _data(element):
    data = {}
    for field in element.FIELDS:
        value = getattr(element, field.name)
        target = data if field.within is None else data.setdefault(field.within, {})
        if field.many:
            if value:
                if field.kind != fields.TEXT:
                    value = [_data(item) for item in value]
                target[field.key] = list(value)
        elif field.child:
            if value is not None:
                target[field.key] = _data(value)
        elif value is not None and (field.always or value != field.default):
            if field.kind == fields.DATE:
                target[field.key] = _date_data(value)
            elif field.kind == fields.NUMBER:
                target[field.key] = float(value)
            else:
                target[field.key] = value
    if element.foreign:
        data.update(element.foreign.keys)
        if element.foreign.attributes:
            data[names.ATTRIBUTES] = element.foreign.attributes
        if element.foreign.elements:
            data[names.ELEMENTS] = [_foreign_data(item) for item in element.foreign.elements]
    return data


def _date_data(text):
    """A date as a mapping, as in rtsprofile; other text as it is."""
    match = _DATE.match(text)
    if not match:
        return text
    data = {key: int(part) for key, part in zip(_DATE_KEYS, match.groups())}
    if match.group(7):
        data["fraction"] = match.group(7)
    if match.group(8):
        data["zone"] = match.group(8)
    return data


def _foreign_data(element):
    data = {"element": element.tag}
    if element.attributes:
        data["attributes"] = element.attributes
    if element.content:
        data["content"] = [
            item if isinstance(item, str) else _foreign_data(item) for item in element.content
        ]
    return data
