"""The manual of a component, from its profile, ports and configuration: what rtdoc prints."""

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

TITLES = collections.OrderedDict(
    [
        ("intro", "Introduction"),
        ("reqs", "Pre-requisites"),
        ("install", "Installation"),
        ("usage", "Usage"),
        ("ports", "Ports"),
        ("config", "Configuration parameters"),
        ("misc", "Miscellaneous"),
        ("changelog", "Changelog"),
    ]
)
_AUTHORS_FIELDS = (("__license__", "License"), ("__contact__", "Contact"), ("__url__", "URL"))


async def collect(node, graph=False):
    """The Manual of the component `node`. Its ports are asked first: see `component.profile`."""
    listed = await ports.ports(node)
    sets = await configuration.of(node)
    profile = await component.profile(node)
    texts = _values(sets, "__doc__")
    fields = [(component.FACTS[name], getattr(profile, name)) for name in ("vendor", "version", "category")]
    fields += [(label, texts[key]) for key, label in _AUTHORS_FIELDS if key in texts]
    generated = {
        "ports": lambda: _ports_section(profile, listed, graph),
        "config": lambda: _configuration_section(sets),
    }
    sections = []
    notes = []
    for key in _order(texts):
        if key in generated:
            parts = generated[key]()
        elif key in texts:
            parts = [texts[key]]
        else:
            parts = []
        if parts:
            sections.append(Section(key, TITLES.get(key, key), parts))
        elif key in _authors_order(texts):
            notes.append(f"unknown section in order: {printable(key)}")
    return Manual(profile.type_name, profile.description, fields, sections, notes)


def _values(sets, set_id):
    return sets.set(set_id, with_hidden=True).values if set_id in sets.raw else {}


def _order(texts):
    """The keys of sections: as the author orders them, then those about ports and configuration,
    then all others.
    """
    ordered = _authors_order(texts) or list(TITLES)
    others = ["ports", "config"] + [key for key in texts if not key.startswith("__")]
    return list(collections.OrderedDict.fromkeys(ordered + others))


def _authors_order(texts):
    return [key.strip() for key in texts.get("__order__", "").split(",") if key.strip()]


# ---- tables ----


def _ports_section(profile, listed, graph):
    if not listed:
        return []
    rows = [
        (
            ports.short_name(port.name, profile.instance_name),
            port.type,
            port.properties.get("dataport.data_type", ""),
            port.properties.get("description", ""),
        )
        for port in listed
    ]
    parts = [Table("Ports", ("Name", "Type", "DataType", "Description"), (8, 8, 8, 26), rows)]
    interfaces = [
        (row[0], i.instance_name, i.type_name, i.polarity)
        for row, port in zip(rows, listed)
        for i in port.interfaces
    ]
    if interfaces:
        parts.append(
            Table("Service interfaces", ("Port", "Instance", "Type", "Polarity"), (8, 14, 18, 10), interfaces)
        )
    types = [
        (type_id, members)
        for type_id, members in [
            (type_id, datatypes.members(type_id)) for type_id in sorted({row[2] for row in rows})
        ]
        if members
    ]
    if types:
        parts.append(
            Table(
                "Data types", ("DataType", "Members"), (15, 35),
                [(type_id, ", ".join(map(": ".join, members))) for type_id, members in types],
            )
        )
    if graph:
        parts.append(_graph(profile.type_name, rows))
    return parts


def _configuration_section(sets):
    values = _values(sets, "default")
    if not values:
        return []
    metadata = [
        (title, _values(sets, set_id))
        for title, set_id in (
            ("Type", "__type__"),
            ("Constraint", "__constraints__"),
            ("Constraint", "__constraint__"),
            ("Widget", "__widget__"),
        )
    ]
    metadata = [(title, texts) for title, texts in metadata if any(texts.get(name) for name in values)]
    described = _values(sets, "__description__")
    if not metadata:
        return [
            Table(
                "Configuration parameters", ("Name", "Description"), (12, 38),
                [(name, described.get(name, "")) for name in values],
            )
        ]
    header = ("Name", "Default") + tuple(title for title, _ in metadata) + ("Description",)
    rows = [
        (name, value) + tuple(texts.get(name, "") for _, texts in metadata) + (described.get(name, ""),)
        for name, value in values.items()
    ]
    return [Table("Configuration parameters", header, (8, 8) + (8,) * len(metadata) + (18,), rows)]


def _graph(title, rows):
    """The component with its data ports in the language of Graphviz."""
    from rtshell_lite.views.graph_dot import node_id  # loads much that tables do not need

    name = node_id(title)
    lines = ["rankdir=LR;", f'{name} [shape=Mrecord, label="{_quoted(title)}"];']
    for port, kind, _, _ in rows:
        if kind not in ports.DATA:
            continue
        lines.append(f'{node_id(port)} [shape=plaintext, label="{_quoted(port)}"];')
        if kind == "DataInPort":
            lines.append(f"{node_id(port)} -> {name};")
        else:
            lines.append(f"{name} -> {node_id(port)};")
    return Graph(lines)


def _quoted(name):
    return printable(name).replace("\\", "\\\\").replace('"', '\\"')


def as_dict(manual):
    """The JSON object of a Manual."""

    def part(content):
        if isinstance(content, Table):
            return {"table": content.title, "header": content.header, "rows": content.rows}
        if isinstance(content, Graph):
            return {"graph": content.lines}
        return {"text": content}

    return {
        "title": manual.title,
        "description": manual.description,
        "fields": dict(manual.fields),
        "sections": [
            {"key": s.key, "title": s.title, "parts": [part(p) for p in s.parts]} for s in manual.sections
        ],
    }
