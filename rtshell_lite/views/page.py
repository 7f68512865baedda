"""A system as one page for a browser: a file that needs no network, and nothing but a browser.

The page is rtshell_lite/views/web/page.html with the style, the scripts and the data in it. What a system
says is data: JSON without any character that HTML knows, and the scripts put it into text nodes only. The
page's Content-Security-Policy lets a browser run this script and no other, and load nothing; the page of
rttop --serve may hear what its server sends.
"""

import base64
import collections
import hashlib
import os
import re

import rtshell_lite
from rtshell_lite import errors
from rtshell_lite.net import calendar
from rtshell_lite.system import capture, page_file
from rtshell_lite.text import printable, safe
from rtshell_lite.views import group_names, page_details, page_groups, part
from rtshell_lite.views.page_details import Rows, shown
from rtshell_lite.xmlprofile import model

# The data of a page, in JSON:
#   title what        the heading, and a line below it
#   kinds kind most   kinds of groups; the one to begin with, null: one that leaves `most` boxes
#   open              names of groups that are not folded
#   order common      numbers of kinds as they are tried for `most` boxes; the directory of all components
#   groups trees      groups of all kinds, and for each kind the number of that of all boxes (page_groups.py)
#   rows pairs        lists of numbers of pairs, by their own numbers below; [name, value]
#   boxes             name label (where names are equal) path state missing composite process
#                     parts [heading, rows] ports [name, type, rows]
#   connections       name id service rows ends [box, port]: the source first
#   findings          level check path message remedy box
#   sections plots    [heading, text], [heading, SVG in Base64]
#   profile           of a report: an RtsProfile in YAML
#   version now       of rttop --serve: of all else; {number of a box: [state, words]}

# What is to be looked at, as rtdoctor's findings have it: level (fail, warn, note or ok); kind of check; path
# of a component or port, or what else it is about; message; remedy, perhaps a command.
Remark = collections.namedtuple("Remark", "level check path message remedy")

_SCRIPTS = ("layout.js", "list.js", "paper.js", "page.js")
_LIVE = _SCRIPTS + ("live.js",)  # the scripts of a live page


def html(fields):
    """The text of a page that shows these fields of its data."""
    return _html(fields["title"], page_file.as_json(fields), _SCRIPTS, "'none'")


def live_html(title, system):
    """The text of a page that is kept live by who serves it; `system` are its fields in JSON."""
    return _html(title, system, _LIVE, "'self'")


def live_policy():
    """The Content-Security-Policy of a live page, for its header."""
    script = "".join(map(_file, _LIVE))
    return _policy(script, _file("page.css"), "'self'") + "; frame-ancestors 'none'"


def _policy(script, style, connect):
    return (
        f"default-src 'none'; script-src '{_hash(script)}'; style-src '{_hash(style)}'; img-src data:; "
        f"connect-src {connect}; base-uri 'none'; form-action 'none'"
    )


def _html(title, system, scripts, connect):
    script = "".join(map(_file, scripts))
    style = _file("page.css")
    contents = {
        "title": printable(title).replace("&", "&amp;").replace("<", "&lt;"),
        "script": script,
        "style": style,
        "policy": _policy(script, style, connect),
        "system": system,
    }
    return re.sub(r"\$(\w+)", lambda match: contents[match.group(1)], _file("page.html"))


def _file(name):
    """The text of a file beside this one, which may be in a wheel."""
    path = os.path.join(os.path.dirname(__file__), "web", name)
    return rtshell_lite.__spec__.loader.get_data(path).decode()


def _hash(text):
    """A script or style as a Content-Security-Policy names it."""
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


# ---- the data ----


def fields(picture, profile, title, what, findings=(), kind=None, opened=(), last=None):
    """The data of a page that shows a graph.Graph of an RtsProfile, or of a part of it.

    findings  doctor.finding.Findings, or what has such attributes
    last      the data of an earlier page, whose groups are kept if components and connections are the same
    kind      of the groups that are folded (None: one that leaves few boxes); `opened` are names of those not
              folded
    """
    rows = Rows()
    labels = group_names.of_boxes(picture)
    data = {
        "title": shown(title),
        "what": shown(what),
        "kinds": part.KINDS,
        "kind": kind,
        "most": part.MOST,
        "order": [part.KINDS.index(name) for name in part.preference(picture)],
        "common": shown(group_names.common_directory(picture)),
        "open": [shown(name) for name in opened],
        "boxes": [_box(box, labels.get(number), rows) for number, box in enumerate(picture.boxes)],
        "connections": _connections(picture, profile, rows),
        "sections": [],
        "plots": [],
        "rows": rows.lists.values,
        "pairs": rows.pairs.values,
    }
    data["findings"] = _findings(findings, data["boxes"])
    if last and all(last[name] == data[name] for name in ("boxes", "connections")):
        data["groups"], data["trees"] = last["groups"], last["trees"]
    else:
        data["groups"], data["trees"] = page_groups.of(picture)
    return data


def _box(box, label, rows):
    fields = {
        "name": shown(box.name),
        "label": label and shown(label),
        "path": box.path and str(box.path),
        "state": box.state,
        "missing": box.missing,
        "composite": box.composite,
        "process": box.process and "%s:%d" % (shown(box.process[0]), box.process[1]),
        "parts": [],
        "ports": [],
    }
    if isinstance(box.origin, model.Component):
        fields["parts"] = [(heading, rows.number(pairs)) for heading, pairs in page_details.parts(box)]
        fields["ports"] = [
            (shown(name), kind, rows.number(pairs)) for name, kind, pairs in page_details.port_parts(box)
        ]
    return _without_defaults(fields)


def _without_defaults(fields):
    """A dict without what is empty, which the script adds again; 0 is the number of a box."""
    kept = {}
    for name, value in fields.items():
        if value is not None and value is not False and value != []:
            kept[name] = value
    return kept


def _connections(picture, profile, rows):
    """Those between boxes of the picture; the source first."""
    numbers = {_origin(box): number for number, box in enumerate(picture.boxes)}
    locate = capture.locator(profile)
    connections = []
    for connector in profile.connectors:
        ends = [_end(end, locate, numbers) for end in connector.ends]
        if len(ends) == 1:
            ends.append([numbers.get(connector.interface_type), ""])
            if connector.source is None:
                ends.reverse()
        if any(number is None for number, _ in ends):
            continue
        fields = {
            "name": shown(connector.name),
            "id": shown(connector.connector_id),
            "service": isinstance(connector, model.ServicePortConnector),
            "rows": rows.number(page_details.connection_rows(connector)),
            "ends": ends,
        }
        connections.append(_without_defaults(fields))
    return connections


def _origin(box):
    """The key of a box: components of a profile cannot be hashed."""
    return id(box.origin) if isinstance(box.origin, model.Component) else box.origin


def _end(end, locate, numbers):
    """[number of a box or None, port] of an end of a connection."""
    component = locate(end)
    key = (end.component_id, end.instance_name) if component is None else id(component)
    return [numbers.get(key), shown(capture.port_of(end))]


def origin(command):
    """The line of a page that says when and by what it was made."""
    moment = calendar.local("%Y-%m-%d %H:%M:%S %z")
    return f"Made at {moment} by {command} of rtshell_lite {rtshell_lite.__version__}"


def remarks(drawing, picture):
    """Remarks on what of a graph.Drawing failed, or is left out."""
    failures = [result for result in drawing.results if isinstance(result, errors.Error)]
    paths = {str(box.path) for box in picture.boxes if box.path}
    listed = [Remark("fail", "", failure.where, failure.why, "") for failure in failures]
    return listed + [Remark("warn", "", _subject(line, paths), line, "") for line in drawing.notes]


def _subject(line, paths):
    """The first of these paths that a line names."""
    for word in line.split():
        word = word.rstrip(":,")
        for name in (word, word.rpartition(":")[0]):
            if name in paths:
                return name
    return ""


def _findings(findings, boxes):
    """Those that are to be looked at, with the number of the box that each is about."""
    numbers = {box["path"]: number for number, box in enumerate(boxes) if "path" in box}
    return [
        {
            "level": finding.level,
            "check": finding.check,
            "path": safe(finding.path),
            "message": safe(finding.message),
            "remedy": safe(finding.remedy),
            "box": numbers.get(finding.path, numbers.get(finding.path.rpartition(":")[0])),  # of a port
        }
        for finding in findings
    ]
