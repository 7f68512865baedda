"""RtsProfile files in XML, as RTSystemEditor, rtcryo and people write and read them.

Elements and attributes are found by namespace and name, whatever the prefixes and the order; names in the
wrong one of the two namespaces, or in none, are accepted. The parser is expat, without entities, external
files or a DTD.
"""

import codecs
import re
import sys
from xml.parsers import expat

from rtshell_lite import errors
from rtshell_lite.text import safe
from rtshell_lite.xmlprofile import escape, fields, model, names, values, version01

MOST_BYTES = 16 << 20
# 16 MiB of <a/> would take 1 GB; a system of 1,000 components has about 50,000 elements
MOST_ELEMENTS = 250000
LONGEST_TAG = 1 << 20  # expat keeps a whole tag: 16 MiB of attributes would take 500 MB
DEEPEST = 64  # levels take 300 bytes each here, and later Python's stack
_CHUNK = 1 << 16
_NO_ATTRIBUTES = {}  # shared: it is half of the memory of an empty element

# Encodings that expat cannot decode itself. Not all codecs of Python: some take quadratic time.
_CODECS = re.compile(
    r"(shift_?jis|sjis|ms932|ms_kanji|cp932|windows_31j|euc_?(jp|kr)|ujis|iso_?2022_?jp|gbk|gb2312|gb18030"
    r"|big5|cp949|ks_c_5601_1987|(iso_?8859|windows|cp|koi8)_\w+|cp\d+|latin_?1)\Z"
)
_DECLARATION = re.compile(rb"""\s*<\?xml[^>]{0,200}?\sencoding\s*=\s*["']([A-Za-z][\w.:-]*)["']""")


# ---- reading: text to nodes ----


class XmlNode:
    """An XML element; names are as in expat. `before` and `inside` are comments, as in fields.Element."""

    __slots__ = "tag", "attributes", "content", "line", "column", "before", "inside"

    def __init__(self, tag, attributes, line, column):
        self.tag = tag
        self.attributes = attributes
        self.content = []
        self.before = self.inside = ()
        self.line = line
        self.column = column

    def children(self):
        return [item for item in self.content if not isinstance(item, str)]

    def text(self):
        return escape.unspelt("".join(item for item in self.content if isinstance(item, str)))

    @property
    def local(self):
        return self.tag.rpartition(names.SEPARATOR)[2]


class _Reader:
    """Builds nodes, within the limits."""

    def __init__(self, name):
        self.name = name
        self.open = []
        self.comments = []
        self.root = None
        self.count = self.fed = 0
        self.parser = expat.ParserCreate("utf-8", names.SEPARATOR)
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.CharacterDataHandler = self.data
        self.parser.CommentHandler = self.comment
        self.parser.StartDoctypeDeclHandler = self.doctype

    def fail(self, reason):
        raise errors.BadProfile(
            self.name, self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber + 1, reason
        )

    def doctype(self, *_):
        self.fail("a DOCTYPE is not supported here")

    def comment(self, text):
        self.one_more()
        self.comments.append(text)

    def taken(self):
        """The comments since the last tag."""
        if not self.comments:
            return ()
        taken = tuple(self.comments)
        self.comments = []
        return taken

    def one_more(self):
        self.count += 1
        if self.count > MOST_ELEMENTS:
            self.fail("more than %d elements" % MOST_ELEMENTS)

    def start(self, tag, attributes):
        self.one_more()
        if len(self.open) >= DEEPEST:
            self.fail("more than %d levels of elements" % DEEPEST)
        node = XmlNode(
            tag, attributes or _NO_ATTRIBUTES, self.parser.CurrentLineNumber,
            self.parser.CurrentColumnNumber + 1,
        )
        node.before = self.taken()
        if self.open:
            self.open[-1].content.append(node)
        else:
            self.root = node
        self.open.append(node)

    def end(self, _):
        node = self.open.pop()
        node.content = fields.tidy(node.content)
        node.inside = self.taken()

    def data(self, text):
        if self.open:
            self.open[-1].content.append(text)

    def feed(self, data, final=False):
        try:
            self.parser.Parse(data, final)
        except expat.ExpatError as e:
            raise errors.BadProfile(self.name, e.lineno, e.offset + 1, expat.ErrorString(e.code))
        except UnicodeDecodeError:  # expat is less strict about UTF-8 than Python
            self.fail("not UTF-8")
        self.fed += len(data)
        if self.fed - max(self.parser.CurrentByteIndex, 0) > LONGEST_TAG and not final:
            self.fail("a tag or comment of more than %d MiB" % (LONGEST_TAG >> 20))


def nodes(data, name):
    """The root node of an XML document. Raises BadProfile."""
    reader = _Reader(name)
    if len(data) > MOST_BYTES:
        reader.fail("more than %d MiB" % (MOST_BYTES >> 20))
    is_utf16 = data[:4] in (b"<\0?\0", b"\0<\0?")
    if is_utf16 or data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        if data[0] >= 0xFE:
            encoding = "utf-16"
        elif data[0] == 0:
            encoding = "utf-16-be"
        else:
            encoding = "utf-16-le"
        decoder = codecs.getincrementaldecoder(encoding)()
    else:
        decoder = _decoder(data, reader)
    for start in range(0, len(data), _CHUNK):
        chunk = data[start : start + _CHUNK]
        if decoder:
            chunk = _decoded(decoder, chunk, start + _CHUNK >= len(data), reader)
        reader.feed(chunk)
    reader.feed(b"", True)
    reader.root.inside += reader.taken()
    return reader.root


def _decoder(data, reader):
    """The decoder for a declared encoding that expat lacks; None for UTF-8."""
    declaration = _DECLARATION.match(data[3:] if data.startswith(codecs.BOM_UTF8) else data, 0)
    encoding = declaration.group(1).decode("ascii").lower().replace("-", "_") if declaration else "utf_8"
    if encoding in ("utf_8", "utf8", "us_ascii", "ascii"):
        return None
    try:
        if _CODECS.match(encoding):
            # that of Windows
            if encoding in ("shift_jis", "shiftjis", "sjis"):
                encoding = "cp932"
            return codecs.getincrementaldecoder(encoding)()
    except LookupError:
        pass
    reader.fail(f"encoding {values.shown(encoding)} is not supported here")


def _decoded(decoder, chunk, final, reader):
    try:
        return decoder.decode(chunk, final).encode("utf-8")
    except UnicodeError as e:
        reader.fail(f"not in the encoding that it declares ({getattr(e, 'reason', e)})")


# ---- reading: nodes to the model ----


def read(data, name):
    """The profile in `data`, the bytes of an XML file. Raises BadProfile; `name` is for messages."""
    root = nodes(data, name)

    def fail(node, reason):
        raise errors.BadProfile(name, node.line, node.column, reason)

    if root.local not in ("RtsProfile", "RTSystemProfile"):  # RTSystemProfile in version 0.1
        fail(root, f"not an RtsProfile: its root element is {values.shown(root.local)}")
    version01.upgrade(root, fail)
    return _element(root, model.RtsProfile, fail)


def _element(node, cls, fail):
    table = names.table(cls)
    values = _attributes(node, table, fail)
    for child in node.children():
        field = table.children.get(child.tag)
        if field is None or field.kind == fields.TEXT and not _is_plain_text(child):
            _keep_element(values, cls, child)
        elif field.many:
            item = child.text() if field.kind == fields.TEXT else _element(child, field.kind, fail)
            values.setdefault(field.name, []).append(item)
        elif field.name in values:
            fail(child, f"more than one {child.local} in {node.local}")
        else:
            values[field.name] = _element(child, field.kind, fail)
    node.content = []  # of a large file it is half of the memory
    element = cls(**values)
    if node.before or node.inside:
        element.comments_before = node.before
        element.comments_inside = node.inside
    fault = element.fault(values)
    if fault:
        fail(node, f"{node.local}: {fault}")
    return element


def _attributes(node, table, fail):
    """The values of a node's attributes by field name; foreign ones are in "foreign"."""
    values = {}
    others = []
    for name, text in node.attributes.items():
        field = table.attributes.get(name)
        if field:
            values[field.name] = _value(node, field, text, fail)
        elif name != names.TYPE:
            others.append(name)
    for name in others:
        field = table.loose_attributes.get(name)
        # An attribute that would not be written must not hide one in the wrong namespace: else a second
        # reading differs.
        if field and (field.name not in values or not field.always and values[field.name] == field.default):
            values[field.name] = _value(node, field, node.attributes[name], fail)
        else:
            fields.foreign(values).attributes[names.clark(name)] = escape.unspelt(node.attributes[name])
    return values


def _value(node, field, text, fail):
    text = sys.intern(escape.unspelt(text))  # most are there many times
    if field.is_text:
        return text
    try:
        return values.from_text(field, text)
    except ValueError as e:
        fail(node, f"{field.local}: {e}")


def _is_plain_text(node):
    return not node.children() and not set(node.attributes) - {names.TYPE}


def _keep_element(values, cls, node):
    """Keep an element that the schema does not have: a key of a YAML file, or something else."""
    foreign = fields.foreign(values)
    key = escape.unspelt(node.attributes.get("name", ""))
    if (
        node.tag == names.YAML_KEY
        and not node.children()
        and key not in foreign.keys
        and not names.is_own_key(cls, key)
    ):
        from rtshell_lite.xmlprofile.yaml import reader as yaml_reader, scalars  # few files need it

        try:
            foreign.keys[key] = scalars.plain(yaml_reader.parse(node.text(), "")[1])
            return
        except (errors.BadProfile, ValueError):
            pass  # keep it as an element
    foreign.elements.append(_foreign_element(node))


def _foreign_element(node):
    attributes = {names.clark(name): escape.unspelt(text) for name, text in node.attributes.items()}
    content = [
        escape.unspelt(item) if isinstance(item, str) else _foreign_element(item) for item in node.content
    ]
    return fields.ForeignElement(names.clark(node.tag), attributes, content)


# ---- writing ----


def write(profile):
    """The text of an XML file, which declares UTF-8."""
    writer = _Writer()
    writer.element("rts:RtsProfile", profile, "")
    spaces = "".join(
        f' xmlns:{prefix}="{escape.marked(uri)}"'
        for uri, prefix in writer.prefixes.items()
        if uri != names.XML
    )
    head = "<rts:RtsProfile"
    comments = _comments(profile.comments_before, "")
    writer.lines[0] = head + spaces + writer.lines[0][len(head) :]  # all namespaces are known only now
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + "\n".join(comments + writer.lines) + "\n"


def _comments(texts, indent):
    """Comments as lines. What is not printable is escaped as on a terminal: comments have no references."""
    comments = []
    for text in texts:
        text = "\n".join("\t".join(map(safe, line.split("\t"))) for line in text.split("\n"))
        comments.append(f"{indent}<!--{text}-->")
    return comments


_NOTHING = fields.Foreign()


class _Writer:
    def __init__(self):
        self.lines = []
        self.prefixes = {uri: prefix for prefix, uri in names.NAMESPACES.items()}
        self.prefixes[names.XML] = "xml"

    def element(self, tag, element, indent):
        head = [indent, "<", tag]
        if element.XSI_TYPE:
            head.append(f' xsi:type="{element.XSI_TYPE}"')
        children = []
        for field in element.FIELDS:
            value = getattr(element, field.name)
            if field.many:
                children += [(field, item) for item in value]
            elif field.child:
                if value is not None:
                    children += [(field, value)]
            elif value is not None and (field.always or value != field.default):
                if not field.is_text:
                    value = values.to_text(field, value)
                head.append(f' {field.tag}="{escape.quoted(str(value))}"')
        foreign = element.foreign or _NOTHING
        head += [self.attribute(*pair) for pair in sorted(foreign.attributes.items())]
        if not (children or foreign.elements or foreign.keys or element.comments_inside):
            self.lines.append("".join(head) + "/>")
            return
        self.lines.append("".join(head) + ">")
        for field, value in children:
            self.child(field, value, indent + "    ")
        for item in foreign.elements:
            self.lines.append(indent + "    " + self.foreign(item))
        if foreign.keys:
            from rtshell_lite.xmlprofile.yaml import writer as yaml_writer  # few files need it
        for key, data in sorted(foreign.keys.items()):
            item = fields.ForeignElement(
                names.clark(names.YAML_KEY), {"name": key}, [yaml_writer.write(data)]
            )
            self.lines.append(indent + "    " + self.foreign(item))
        self.lines += _comments(element.comments_inside, indent + "    ")
        self.lines.append(f"{indent}</{tag}>")

    def child(self, field, value, indent):
        if field.kind == fields.TEXT:
            self.lines.append(f"{indent}<{field.tag}>{escape.quoted(value)}</{field.tag}>")
        else:
            self.lines += _comments(value.comments_before, indent)
            self.element(field.tag, value, indent)

    def name(self, clark):
        space, local = names.parts(clark)
        if not space:
            return local
        if space not in self.prefixes:
            self.prefixes[space] = "ns%d" % (len(self.prefixes) - 3)
        return self.prefixes[space] + ":" + local

    def attribute(self, name, text):
        return f' {self.name(name)}="{escape.quoted(text)}"'

    def foreign(self, element):
        """On one line: blanks would become text of mixed content."""
        tag = self.name(element.tag)
        attributes = [self.attribute(*pair) for pair in sorted(element.attributes.items())]
        head = "<" + tag + "".join(attributes)
        content = "".join(
            escape.quoted(item) if isinstance(item, str) else self.foreign(item) for item in element.content
        )
        return f"{head}>{content}</{tag}>" if content else head + "/>"
