"""Reads a subset of YAML 1.1: what PyYAML writes for a profile, and what people write by hand.

Supported: block and flow collections; plain, quoted, literal and folded text; comments; anchors and aliases;
tags of plain types; one document. Everything else is refused with line and column, also what is legal but a
trap: duplicate keys and anchors, merge keys, several documents. Nothing is ever evaluated.

Most functions take a document and a position and return where they ended and a node: (doc, pos) -> (pos,
YamlNode). Functions for block style end at the next token, those for flow style at the end of the node.
"""

import re

from rtshell_lite.xmlprofile.yaml import scalars
from rtshell_lite.xmlprofile.yaml.document import Document, YamlNode
from rtshell_lite.xmlprofile.yaml.scalars import BREAK

MOST_CHARACTERS = 16 << 20
MOST_LINES = 1000000  # two for each node

_BLANKS = re.compile(" *")
_END_OF_LINE = re.compile(f" *(?:#|[{BREAK}\x00])")
_DASH = re.compile(f"-(?=[ \x00{BREAK}])")
_COLON = re.compile(f" *:(?=[ \x00{BREAK}])")
_ANCHOR = re.compile(r"([&*])([\w-]+)", re.ASCII)
_TAG = re.compile(rf"!(?:<tag:yaml\.org,2002:(\w+)>|!(\w+)|(?=[ \0{BREAK}]))", re.ASCII)
_FORBIDDEN = re.compile("[^\t\n\r -~\x85\xa0-\ud7ff\ue000-\ufefe\uff00-\ufffd\U00010000-\U0010ffff]")
# Most lines of a profile: `key: value`, or `key:` alone. Reading them at once saves two thirds of the time.
_SIMPLE = re.compile(
    r"([A-Za-z][\w:]*):( (?:([\w/.+][!\"$-~]*(?<!:))|'([^'%s\t]*)'))?\n( *)(?=[!-\"$-~])" % BREAK, re.ASCII
)


def parse(text, name):
    """A YAML document, str or bytes: (Document, its root node). Raises BadProfile; `name` is for messages."""
    doc = Document("", name)
    if len(text) > MOST_CHARACTERS:
        doc.fail(0, "more than %d MiB" % (MOST_CHARACTERS >> 20))
    if isinstance(text, bytes):
        text = _decoded(doc, text)
    if text.startswith("\ufeff"):
        text = text[1:]
    doc.text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\x85", "\n")
    if doc.text.count("\n") > MOST_LINES:
        doc.fail(0, "more than %d lines" % MOST_LINES)
    bad = _FORBIDDEN.search(doc.text)
    if bad:
        doc.fail(bad.start(), f"a character that YAML does not allow (U+{ord(bad.group()):04X})")
    doc.other_breaks = [c for c in BREAK[1:] if c in doc.text]
    doc.text += "\0"  # so that there is always a next character
    return doc, _document(doc)


def _decoded(doc, data):
    encoding = "utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8"
    try:
        return data.decode(encoding)
    except UnicodeDecodeError as e:
        doc.text = data[: e.start].decode(encoding, "replace")
        doc.fail(len(doc.text), f"not {encoding.upper()} ({e.reason})")


def _document(doc):
    pos, column = doc.next_token(0)
    if doc.text[pos] == "%":
        doc.fail(pos, "directives are not supported here")
    begins = column < 0 and doc.text.startswith("---", pos)
    if column < 0 and doc.text[pos] == ".":
        doc.fail(pos, "the end of a document that has not begun")
    pos, node = _value(doc, pos + 3, -1, 0, False) if begins else _value(doc, pos, -1, 0, True)
    while doc.text.startswith("...", pos) and doc.token_column(pos) < 0:
        pos = _line_end(doc, pos + 3)
    if doc.text[pos] != "\0":
        if doc.token_column(pos) < 0:
            doc.fail(pos, "a second document")
        doc.fail(pos, "this does not belong to what is above")
    return node


def _line_end(doc, pos):
    """Check that nothing follows on this line; the position of the next token."""
    if not _END_OF_LINE.match(doc.text, pos):
        pos = _BLANKS.match(doc.text, pos).end()
        doc.fail(
            pos,
            {
                ":": "a colon and a blank inside text: put quotes around it, or mend the indentation",
                "\t": scalars.TAB,
            }.get(doc.text[pos], "this does not belong to the value before it"),
        )
    return doc.next_token(pos)[0]


# ---- block style ----


def _value(doc, pos, indent, depth, compact, dashes=False):
    """The value after `key:` or `- ` at column `indent`, and the next token.

    compact: another collection may begin on the same line. dashes: a list may be at the column of its key.
    """
    start = pos
    pos, anchor, tag = _properties(doc, pos)
    if not _END_OF_LINE.match(doc.text, pos):
        if compact and not (anchor or tag):
            return _block(doc, _BLANKS.match(doc.text, pos).end(), indent, depth)
        if compact and _is_key(doc, pos):  # the anchor belongs to the key
            return _block(doc, _BLANKS.match(doc.text, start).end(), indent, depth)
        return _anchored(doc, anchor, doc.nodes, _inline(doc, pos, indent, depth, tag))
    pos, column = doc.next_token(pos)
    _check_below(doc, pos, column, indent, anchor, tag)
    count = doc.nodes
    pos, node = _below(doc, pos, column, indent, depth, dashes)
    return _anchored(doc, anchor, count, (pos, _tagged(doc, start, node, tag)))


def _check_below(doc, pos, column, indent, anchor, tag):
    """Refuse a second anchor or tag on lines below the first;
    an anchor may follow a tag there, and the other way round.
    """
    while (anchor or tag) and column > indent and not _is_key(doc, pos):
        end, second_anchor, second_tag = _properties(doc, pos)
        if anchor and second_anchor or tag and second_tag:
            doc.fail(pos, "a second anchor or tag")
        if not (second_anchor or second_tag) or not _END_OF_LINE.match(doc.text, end):
            return
        anchor = anchor or second_anchor
        tag = tag or second_tag
        pos, column = doc.next_token(end)


def _below(doc, pos, column, indent, depth, dashes=True):
    """The value whose first token is below its key or dash at column `indent`: at `pos`, in `column`."""
    if column > indent:
        return _block(doc, pos, indent, depth)
    if dashes and column == indent and _DASH.match(doc.text, pos):
        return _sequence(doc, pos, column, depth)
    return pos, doc.node("", pos, depth)


def _block(doc, pos, indent, depth):
    """The collection or value that begins with the token at `pos`."""
    if doc.text[pos] == "-" and _DASH.match(doc.text, pos):
        return _sequence(doc, pos, doc.column(pos), depth)
    if _is_key(doc, pos):
        return _mapping(doc, pos, doc.column(pos), depth)
    return _value(doc, pos, indent, depth, False)


def _sequence(doc, pos, column, depth):
    items = []
    node = doc.node(items, pos, depth)
    here = column
    while here == column and _DASH.match(doc.text, pos):
        if _SIMPLE.match(doc.text, pos + 2):
            pos, item = _mapping(doc, pos + 2, column + 2, depth + 1)
        else:
            pos, item = _value(doc, pos + 1, column, depth + 1, True)
        items.append(item)
        here = doc.token_column(pos)
    _check_column(doc, pos, column)
    return pos, node


def _mapping(doc, pos, column, depth):
    items = {}
    node = doc.node(items, pos, depth)
    here = column
    while here == column and not _DASH.match(doc.text, pos):
        simple = _SIMPLE.match(doc.text, pos)
        if simple and simple.group(1) not in items:
            key, line, value, quoted, blanks = simple.groups()
            key = doc.one(key)
            if not line:
                pos, items[key] = _below(doc, simple.end(), len(blanks), column, depth + 1)
                here = doc.token_column(pos)
                continue
            if len(blanks) <= column:
                tag = None
                if value is None:
                    value = quoted or ""
                    tag = "str"
                items[key] = doc.node(doc.one(value), simple.start(2) + 1, depth + 1, tag)
                pos = simple.end()
                here = len(blanks) or doc.token_column(pos)
                continue
        start = pos
        pos, key = _key(doc, pos, depth)
        if key in items:
            doc.fail(start, "this key was given before")
        pos = _COLON.match(doc.text, pos).end()
        pos, items[key] = _value(doc, pos, column, depth + 1, False, True)
        here = doc.token_column(pos)
    _check_column(doc, pos, column)
    return pos, node


def _check_column(doc, pos, column):
    if doc.token_column(pos) > column:
        doc.fail(pos, "indented by more than what it belongs to")


def _is_key(doc, pos):
    """Whether a key of a mapping begins here: text with a colon on the same line."""
    end = scalars.key_end(doc, _BLANKS.match(doc.text, _properties(doc, pos)[0]).end())
    return bool(end and _COLON.match(doc.text, end))


def _key(doc, pos, depth):
    """(where the colon of a key is, the key)"""
    if not _is_key(doc, pos):
        end = scalars.key_end(doc, pos) or pos
        if doc.text.startswith(":\t", end):
            doc.fail(end + 1, scalars.TAB)
        doc.fail(pos, "a key and a colon are needed here")
    start = pos
    pos, anchor, tag = _properties(doc, pos)
    if doc.text.startswith("<<", pos) and _COLON.match(doc.text, pos + 2):
        doc.fail(pos, "merge keys are not supported here")
    count = doc.nodes
    pos, node = _anchored(doc, anchor, count, _scalar(doc, pos, depth, tag, key=True))
    if not isinstance(node.value, str):
        doc.fail(start, "a key that is a list or a mapping")
    return pos, node.value


def _inline(doc, pos, indent, depth, tag):
    """A value that begins on this line, and the next token."""
    pos = _BLANKS.match(doc.text, pos).end()
    c = doc.text[pos]
    if c in "|>":
        end, text = scalars.block(doc, pos, indent)
        return doc.next_token(end)[0], doc.node(text, pos, depth, tag or "str")
    if c in "[{":
        end, node = _flow(doc, pos, depth, tag)
    else:
        if _DASH.match(doc.text, pos):
            doc.fail(pos, "a list may not begin here")
        end, node = _scalar(doc, pos, depth, tag, indent=indent)
    return _line_end(doc, end), node


# ---- both styles ----


def _properties(doc, pos):
    """The anchor and the tag in front of a node: (pos, anchor, tag).
    The tag is a name such as str, or "!".
    """
    anchor = tag = None
    while True:
        start = _BLANKS.match(doc.text, pos).end()
        c = doc.text[start]
        if c == "&" and not anchor:
            match = _ANCHOR.match(doc.text, start)
        elif c == "!" and not tag:
            match = _TAG.match(doc.text, start)
        else:
            match = None
        if not match:
            if c in "&!":
                if c == "!":
                    doc.fail(start, "a tag that is not supported here")
                doc.fail(start, "an anchor without a name, or a second one")
            return pos, anchor, tag
        if c == "&":
            anchor = match.group(2)
        else:
            tag = match.group(1) or match.group(2) or "!"
            if tag not in scalars.TAGS:
                doc.fail(start, "a tag that is not supported here")
        pos = match.end()


def _anchored(doc, anchor, count, result):
    """Remember `result`, (pos, node), by its anchor; there were `count` nodes before it."""
    if anchor:
        if anchor in doc.anchors:
            doc.fail(result[1].pos, f"the anchor &{anchor} was given before")
        _measure(result[1])
        doc.anchors[anchor] = (result[1], doc.nodes - count)
    return result


def _measure(node):
    """Set and return the height of a node; a node is visited once, however often it is used."""
    if not node.height:
        children = node.value.values() if isinstance(node.value, dict) else node.value
        node.height = 1
        if not isinstance(children, str):
            node.height += max([_measure(child) for child in children] or [0])
    return node.height


def _alias(doc, pos, depth):
    match = _ANCHOR.match(doc.text, pos)
    name = match.group(2) if match else ""
    if name not in doc.anchors:
        doc.fail(pos, "an alias of nothing that was anchored before")
    node, count = doc.anchors[name]
    doc.nodes += count  # as often as it is used: ten lines of aliases can mean 10 ** 9 nodes
    doc.node("", pos, depth + node.height)
    return match.end(), node


def _tagged(doc, pos, node, tag):
    if isinstance(node.value, dict):
        expected = "map"
    elif isinstance(node.value, list):
        expected = "seq"
    else:
        expected = None
    if not tag or tag in (expected, "!"):
        return node
    if expected or tag in ("map", "seq"):
        doc.fail(pos, f"the tag !!{tag} does not fit")
    return YamlNode(node.value, node.pos, tag)


def _scalar(doc, pos, depth, tag, indent=-1, key=False, flow=False):
    """Text, quoted or plain, or an alias: (pos after it, node)."""
    pos = _BLANKS.match(doc.text, pos).end()
    c = doc.text[pos]
    if c == "*":
        if tag:
            doc.fail(pos, "an alias with a tag")
        return _alias(doc, pos, depth)
    quotes = c in "'\""
    end, text = scalars.quoted(doc, pos) if quotes else scalars.bare(doc, pos, indent, flow, key)
    if tag in ("map", "seq"):
        doc.fail(pos, f"the tag !!{tag} does not fit")
    if tag == "!":
        # PyYAML's reading of a tag without a name
        tag = None
        quotes = False
    return end, doc.node(text, pos, depth, tag or ("str" if quotes else None))


# ---- flow style ----


def _flow(doc, pos, depth, tag):
    """[...] or {...}: (pos after it, node)."""
    mapping = doc.text[pos] == "{"
    items = {} if mapping else []
    node = doc.node(items, pos, depth)
    _tagged(doc, pos, node, tag)
    start = pos
    pos = doc.skip(pos + 1)
    while doc.text[pos] != ("}" if mapping else "]"):
        if doc.text[pos] == "\0":
            doc.fail(start, "this bracket is never closed")
        if doc.text[pos] == ",":
            doc.fail(pos, "a value is needed here")
        if mapping:
            pos = _flow_pair(doc, pos, depth, items)
        else:
            pos, item = _flow_node(doc, pos, depth + 1)
            items.append(item)
        pos = doc.skip(pos)
        if doc.text[pos] == ",":
            pos = doc.skip(pos + 1)
        elif doc.text[pos] not in "]}\0":
            doc.fail(pos, "a comma or a closing bracket is needed here")
        elif doc.text[pos] == ("]" if mapping else "}"):
            doc.fail(pos, "the wrong closing bracket")
    return pos + 1, node


def _flow_pair(doc, pos, depth, items):
    start = pos
    pos, key = _flow_node(doc, pos, depth + 1)
    if not isinstance(key.value, str):
        doc.fail(start, "a key that is a list or a mapping")
    if key.value == "<<" and key.tag is None:
        doc.fail(start, "merge keys are not supported here")
    if key.value in items:
        doc.fail(start, "this key was given before")
    pos = doc.skip(pos)
    if doc.text[pos] == ":":
        pos, items[key.value] = _flow_node(doc, doc.skip(pos + 1), depth + 1)
    else:
        items[key.value] = doc.node("", pos, depth + 1)
    return pos


def _flow_node(doc, pos, depth):
    count = doc.nodes
    pos, anchor, tag = _properties(doc, pos)
    pos = doc.skip(pos)
    if doc.text[pos] in "[{":
        result = _flow(doc, pos, depth, tag)
    elif doc.text[pos] in ",]}":
        result = pos, doc.node("", pos, depth, tag)
    else:
        result = _scalar(doc, pos, depth, tag, flow=True)
    return _anchored(doc, anchor, count, result)
