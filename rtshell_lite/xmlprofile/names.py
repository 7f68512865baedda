"""The names of fields in files: XML attributes, XML children, YAML keys.

XML names are as in expat: namespace, SEPARATOR, name. The model has "{namespace}name".
"""

from rtshell_lite.xmlprofile import escape

SEPARATOR = "\x01"  # cannot occur in XML

NAMESPACES = {
    "rts": "http://www.openrtp.org/namespaces/rts",
    "rtsExt": "http://www.openrtp.org/namespaces/rts_ext",
    "xsi": "http://www.w3.org/2001/XMLSchema-instance",
}
XML = "http://www.w3.org/XML/1998/namespace"
XMLNS = "http://www.w3.org/2000/xmlns/"
TYPE = NAMESPACES["xsi"] + SEPARATOR + "type"
# an XML element for a foreign key of YAML; its text is YAML
YAML_KEY = "urn:rtshell_lite:yaml" + SEPARATOR + "key"

# YAML keys for foreign attributes and elements of XML.
ATTRIBUTES = "xml::attributes"
ELEMENTS = "xml::elements"


def exact(field):
    """The right name of a fields.Field in XML, as in expat."""
    return NAMESPACES[field.prefix] + SEPARATOR + field.local


def clark(name):
    """The model's form of a name from expat."""
    space, separator, local = name.rpartition(SEPARATOR)
    return f"{{{space}}}{local}" if separator else name


def parts(clark_name):
    """(namespace or "", name) of a name in the model's form."""
    if not clark_name.startswith("{"):
        return "", clark_name
    space, _, local = clark_name[1:].rpartition("}")
    return space, local


def raw(clark_name):
    """expat's form of a name of the model."""
    space, local = parts(clark_name)
    return space + SEPARATOR + local if space else local


def _spellings(field):
    """Accepted names for a field: with the right namespace, with the other one, without."""
    return [
        space + local
        for local in (field.local,) + tuple(field.also)
        for space in (NAMESPACES["rts"] + SEPARATOR, NAMESPACES["rtsExt"] + SEPARATOR, "")
    ]


class Table:
    """The fields of a class of elements by their names in files;
    the loose tables also have wrong spellings.
    """

    def __init__(self, cls):
        values = [field for field in cls.FIELDS if not field.child]
        children = [field for field in cls.FIELDS if field.child]
        self.attributes = {exact(field): field for field in values}
        self.loose_attributes = {name: field for field in values for name in _spellings(field)}
        self.children = {name: field for field in children for name in _spellings(field)}
        self.keys = {field.key: field for field in cls.FIELDS}
        self.loose_keys = {key: field for field in cls.FIELDS for key in _key_spellings(field)}
        self.wrappers = {field.within for field in children if field.within}


def _key_spellings(field):
    bare = field.key.rpartition("::")[2]
    return [bare, "rtsExt::" + bare] + [name[0].lower() + name[1:] for name in field.also]


_TABLES = {}


def table(cls):
    """The Table of a class of elements."""
    if cls not in _TABLES:
        _TABLES[cls] = Table(cls)
    return _TABLES[cls]


def is_own_key(cls, key):
    """Whether a YAML key has a meaning in this class of elements."""
    own_table = table(cls)
    return key in own_table.loose_keys or key in own_table.wrappers or key in (ATTRIBUTES, ELEMENTS)


def is_clark(name):
    """Whether XML can hold an element or attribute called `name`, "{namespace}name" or "name"."""
    space, local = parts(name)
    if clark(raw(name)) != name or space == XMLNS or not escape.is_legal(space):
        return False
    if not local or set(local) & set(" \t\r\n<>&/=\"':!?"):
        return False
    from xml.parsers import expat  # which Debian's python3-minimal lacks, and YAML does not need

    try:
        expat.ParserCreate().Parse(f"<{local}/>", True)
    except (expat.ExpatError, UnicodeError):
        return False
    return True
