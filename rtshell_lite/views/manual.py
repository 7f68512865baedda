"""The manual of a component, made from what it says of itself: what rtdoc prints."""
import collections

from rtshell_lite.data import datatypes
from rtshell_lite.robot import component, configuration, ports
from rtshell_lite.text import printable

# `fields` are (name, value) texts; `sections` are Sections; `notes` are lines for stderr.
Manual = collections.namedtuple("Manual", "title description fields sections notes")
# `parts` are texts (reStructuredText of the component's author), Tables and Graphs.
Section = collections.namedtuple("Section", "key title parts")
Table = collections.namedtuple("Table", "title header widths rows")
Graph = collections.namedtuple("Graph", "lines")

TITLES = collections.OrderedDict([
    ("intro", "Introduction"), ("reqs", "Pre-requisites"), ("install", "Installation"), ("usage", "Usage"), ("ports", "Ports"),
    ("config", "Configuration parameters"), ("misc", "Miscellaneous"), ("changelog", "Changelog")])
_AUTHORS_FIELDS = (("__license__", "License"), ("__contact__", "Contact"), ("__url__", "URL"))


def collect(node, graph=False):
    """The Manual of the component `node`. Its ports are asked first: see `component.profile`."""
    found, sets = ports.ports(node), configuration.Configuration(node)
    profile = component.profile(node)
    said = _values(sets, "__doc__")
    fields = [("Vendor", profile.vendor), ("Version", profile.version), ("Category", profile.category)]
    fields += [(label, said[key]) for key, label in _AUTHORS_FIELDS if key in said]
    made = {"ports": lambda: _ports_section(profile, found, graph), "config": lambda: _configuration_section(sets)}
    sections, notes = [], []
    for key in _order(said):
        parts = made[key]() if key in made else [said[key]] if key in said else []
        if parts:
            sections.append(Section(key, TITLES.get(key, key), parts))
        elif "__order__" in said:
            notes.append(f"unknown section in order: {printable(key)}")
    return Manual(profile.type_name, profile.description, fields, sections, notes)


def _values(sets, set_id):
    return sets.set(set_id, with_hidden=True).values if set_id in sets.raw else {}


def _order(said):
    """The keys of sections: as the author orders them, then what else there is."""
    ordered = [key.strip() for key in said["__order__"].split(",")] if "__order__" in said else list(TITLES)
    return ordered + [key for key in said if not key.startswith("__") and key not in ordered]


# ---- tables ---------------------------------------------------------------------------------------------------

def _ports_section(profile, found, graph):
    if not found:
        return []
    rows = [(ports.short_name(each.name, profile.instance_name), each.type, each.properties.get("dataport.data_type", ""),
             each.properties.get("description", "")) for each in found]
    parts = [Table("Ports", ("Name", "Type", "DataType", "Description"), (8, 8, 8, 26), rows)]
    interfaces = [(row[0], i.instance_name, i.type_name, i.polarity) for row, each in zip(rows, found) for i in each.interfaces]
    if interfaces:
        parts.append(Table("Service interfaces", ("Port", "Instance", "Type", "Polarity"), (8, 14, 18, 10), interfaces))
    types = [(type_id, members) for type_id, members in
             [(type_id, datatypes.members(type_id)) for type_id in sorted({row[2] for row in rows})] if members]
    if types:
        parts.append(Table("Data types", ("DataType", "Members"), (15, 35),
                           [(type_id, ", ".join("%s: %s" % member for member in members)) for type_id, members in types]))
    return parts + ([_graph(profile.type_name, rows)] if graph else [])


def _configuration_section(sets):
    values = _values(sets, "default")
    if not values:
        return []
    said = [(title, _values(sets, set_id)) for title, set_id in (
        ("Type", "__type__"), ("Constraint", "__constraints__"), ("Constraint", "__constraint__"), ("Widget", "__widget__"))]
    said = [(title, known) for title, known in said if any(known.get(name) for name in values)]
    described = _values(sets, "__description__")
    if not said:
        return [Table("Configuration parameters", ("Name", "Description"), (12, 38),
                      [(name, described.get(name, "")) for name in values])]
    header = ("Name", "Default") + tuple(title for title, _ in said) + ("Description",)
    rows = [(name, value) + tuple(known.get(name, "") for _, known in said) + (described.get(name, ""),)
            for name, value in values.items()]
    return [Table("Configuration parameters", header, (8, 8) + (8,) * len(said) + (18,), rows)]


def _graph(title, rows):
    """The component with its data ports in the language of Graphviz."""
    name = _node_id(title)
    lines = ["rankdir=LR;", f'{name} [shape=Mrecord, label="{_quoted(title)}"];']
    for port, kind, _, _ in rows:
        if kind not in ports.DATA:
            continue
        lines.append(f'{_node_id(port)} [shape=plaintext, label="{_quoted(port)}"];')
        lines.append("%s -> %s;" % ((_node_id(port), name) if kind == "DataInPort" else (name, _node_id(port))))
    return Graph(lines)


def _node_id(name):
    for character, word in ((".", "_dot_"), ("/", "_slash_"), ("(", "_lpar_"), (")", "_rpar_")):
        name = name.replace(character, word)
    return name if name.isidentifier() else f'"{_quoted(name)}"'


def _quoted(name):
    return printable(name).replace("\\", "\\\\").replace('"', '\\"')


def as_dict(manual):
    """The JSON object of a Manual."""
    def part(each):
        if isinstance(each, Table):
            return {"table": each.title, "header": each.header, "rows": each.rows}
        return {"graph": each.lines} if isinstance(each, Graph) else {"text": each}
    return {"title": manual.title, "description": manual.description, "fields": dict(manual.fields),
            "sections": [{"key": s.key, "title": s.title, "parts": [part(p) for p in s.parts]} for s in manual.sections]}
