"""What a log says of a robot: its components, what is connected, and what changed when.

Logs of `rtlog record --events` have profiles of the system (system-N.rtsys) and details of its components
(components-N.json); other logs show the out ports that were recorded, and nothing else.
"""

import collections
import json

from rtshell_lite import errors, notes, path
from rtshell_lite.robot import ports
from rtshell_lite.system import capture
from rtshell_lite.text import printable
from rtshell_lite.xmlprofile import model, rtsprofile

LARGEST = 64 << 20  # octets of a profile in a log
EVENTS = "/events"  # the channel that system/journal.py writes
STATES = {"ACTIVE": "Active", "INACTIVE": "Inactive", "ERROR": "Error"}  # by the event that reports them

# The whole robot from a moment (ns since the epoch) on: a model.RtsProfile, and details of its components by
# their paths, dicts as of system/details.py
Scene = collections.namedtuple("Scene", "moment profile details")
# What a component reported: its path, as text; the kind, the subject and the event in words of rtwatch
Report = collections.namedtuple("Report", "path kind subject event")


class Recording:
    """The robot in a Log: `scenes`, one or more Scenes in their order; `channels`: {number of a channel: Path
    of the out port that its values came from}; `events`: numbers of the channels of events.
    """

    def __init__(self, log):
        """Raises errors.Failed where it shows no component."""
        self.log = log
        self.channels = {}
        self.events = set()
        for number, channel in enumerate(log.channels):
            if channel.encoding == "json" and channel.name == EVENTS:
                self.events.add(number)
            elif channel.sources:
                self._add_source(number, channel)
        self.scenes = _scenes(log) or [Scene(log.started, model.RtsProfile(), {})]
        self._shorten_sources()
        if not self.paths() and not self.channels:
            why = "no component is in this log: record it with rtlog record --events PATH"
            raise errors.Failed(log.where, why)

    def _add_source(self, number, channel):
        try:
            source = path.parse(channel.sources[0])
        except errors.BadPath:
            return
        if source.port is None or not source.names:
            return
        self.channels[number] = source
        if len(channel.sources) > 1:
            others = len(channel.sources) - 1
            notes.note(
                f"{printable(channel.name)}: its values came from {source} and {others} more; that one "
                "sends them"
            )

    def _shorten_sources(self):
        """Have out ports called as in profiles: a component that is bound by another name than its own puts
        its own before their names (`MA.rtc:Meter0.seq`).
        """
        instances = {}
        for scene in self.scenes:
            for where, described in by_path(scene).items():
                instances.setdefault(where, described.instance_name)
        for number, source in self.channels.items():
            instance = instances.get(str(source.object()))
            self.channels[number] = source.with_port(ports.short_name(source.port, instance))

    def paths(self):
        """The Paths of all components that a scene shows."""
        return {where for scene in self.scenes for where in by_path(scene)}

    def scene_at(self, moment):
        """The number of the scene at a moment: the last that is not later, else the first."""
        earlier = [number for number, scene in enumerate(self.scenes) if scene.moment <= moment]
        return max(earlier, default=0)

    def report(self, entry):
        """The Report in an entry of a channel of events, or None where it has none."""
        fields = entry.value
        if not isinstance(fields, dict):
            return None
        words = [fields.get(key) for key in ("path", "kind", "subject", "event")]
        if not all(isinstance(word, str) for word in words):
            return None
        return Report(*words)


def by_path(scene):
    """{Path as text: the model.Component} of a Scene, without those whose path is not valid."""
    components = {}
    for component in scene.profile.components:
        try:
            where = capture.path_of(component)
        except errors.BadPath:
            continue
        if where.names and where.port is None:
            components.setdefault(str(where), component)
    return components


def _scenes(log):
    """The Scenes in a log, in their order."""
    described = details(log)
    scenes = []
    for attachment in log.attachments:
        name = attachment[1]
        if not name.startswith("system-") or attachment[4] > LARGEST:
            continue
        try:
            profile = rtsprofile.load(log.attached(attachment), log.where)
        except errors.BadProfile as e:
            notes.note(f"{log.where}: {printable(name)}: left out: {e}")
            continue
        number = name[len("system-") :].partition(".")[0]
        scenes.append(Scene(attachment[0], profile, described.get((attachment[0], number), {})))
    return sorted(scenes, key=lambda scene: scene.moment)


def details(log):
    """{(moment, number as text): {path: what is known of a component}} of a log. What is recorded later to
    the same file begins with number 1 again.
    """
    described = {}
    for attachment in log.attachments:
        moment, name = attachment[:2]
        if name.startswith("components-") and name.endswith(".json") and attachment[4] <= LARGEST:
            described[moment, name[len("components-") : -len(".json")]] = _details(log, attachment)
    return described


def _details(log, attachment):
    """{path: what is known of a component} of an attachment; nothing that is not of the form is in it."""
    try:
        listed = json.loads(log.attached(attachment).decode("utf-8"))
    except (ValueError, RecursionError):
        return {}
    if not isinstance(listed, list):
        return {}
    return {
        details["path"]: details
        for details in listed
        if isinstance(details, dict) and isinstance(details.get("path"), str)
    }


# ---- parts of details, which may have any form ----


def text_in(fields, key, default=""):
    """A text in a dict of JSON."""
    value = fields.get(key)
    return value if isinstance(value, str) else default


def dicts_in(fields, key):
    """The dicts of a list in a dict of JSON."""
    value = fields.get(key)
    if not isinstance(value, list):
        return []
    return [member for member in value if isinstance(member, dict)][: ports.MOST_PARTS]


def pairs_in(fields, key):
    """The (name, value) texts of a list in a dict of JSON."""
    return _texts_in(fields, key, 2)


def interfaces_in(fields):
    """The (instance, type, polarity) texts of the interfaces of a port in a dict of JSON."""
    interfaces = _texts_in(fields, "interfaces", 3)
    return [row for row in interfaces if row[2] in ("Provided", "Required")][: ports.MOST_PARTS]


def _texts_in(fields, key, count):
    """Of the list `fields[key]`, as JSON has it: the lists of `count` texts in it, as tuples."""
    value = fields.get(key)
    if not isinstance(value, list):
        return []
    return [
        tuple(words)
        for words in value
        if isinstance(words, list) and len(words) == count and all(isinstance(word, str) for word in words)
    ]
