"""Configuration sets of components (SDOPackage::Configuration):
read, set, activate, write to text and back, compare.
"""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.records import record
from rtshell_lite.robot import tree
from rtshell_lite.text import candidates, from_wire, printable, shell_word, to_wire, unescaped

# One configuration set: `values` a dict of texts in the component's order, `active` True for the one
# in use.
Set = record("Set", "id description values active")


def hidden(set_id):
    """True for sets that hold metadata (__widget__, __constraints__, …)."""
    return set_id.startswith("__") and set_id.endswith("__")


async def of(node):
    """The Configuration of a component. Raises what remote calls raise."""
    ref = await node.call("get_configuration")
    listed = await orb.call(node.path, ref, "get_configuration_sets")
    return Configuration(node, ref, listed, await _active(node, ref))


async def _active(node, ref):
    """The id of the active set, '' when no set is active, as after values were set without activating."""
    try:
        active = await orb.call(node.path, ref, "get_active_configuration_set", part=1)
        return from_wire(active.id)
    except errors.Refused as e:
        if e.name != "NotAvailable":
            raise
        return ""


class Configuration:
    """The configuration of the component `node`, read once:
    its reference, its sets as they came, the id of the active one.
    """

    def __init__(self, node, ref, listed, active):
        self.node = node
        self.where = str(node.path)
        self.ref = ref
        self.active = active
        self.raw = {from_wire(raw.id): raw for raw in listed}

    async def _call(self, operation, *args):
        return await orb.call(self.where, self.ref, operation, *args)

    def sets(self, with_hidden=False):
        """The Sets, sorted by name."""
        chosen = [set_id for set_id in sorted(self.raw) if with_hidden or not hidden(set_id)]
        return [self._set(set_id) for set_id in chosen]

    def _set(self, set_id):
        raw = self.raw[set_id]
        return Set(
            set_id, from_wire(raw.description), dict(orb.properties(raw.configuration_data)),
            set_id == self.active,
        )

    def set(self, set_id=None, with_hidden=False):
        """The Set called `set_id` (None: the active one). Raises NoSuch."""
        if set_id is None and not self.active:
            raise errors.Refused(self.where, "has no active configuration set; name one with -s")
        if set_id is None:
            set_id = self.active
        if set_id not in self.raw or hidden(set_id) and not with_hidden:
            ids = [one_set.id for one_set in self.sets(with_hidden)]
            raise errors.NoSuch(self.where, "configuration set", printable(set_id) + candidates(set_id, ids))
        return self._set(set_id)

    def check(self, names, within):
        """Raise NoSuch unless the Set `within` has every one of these parameters."""
        for name in names:
            if name not in within.values:
                words = printable(name) + candidates(name, within.values)
                raise errors.NoSuch(self.where, "configuration parameter", words)

    def check_values(self, values, within):
        """The same for values ({name: value}); raises BadValue for one that cannot be sent, too."""
        self.check(values, within)
        for name, value in values.items():
            if "\0" in value:
                raise errors.BadValue(f"{self.where}: {printable(name)}", "a string holds no NUL")

    async def store(self, values, within):
        """Set `values` (a dict) in the Set `within`. The active set is activated again: a component forgets
        it otherwise.

        Raises NoSuch and BadValue before anything is changed, Refused.
        """
        self.check_values(values, within)
        everything = dict(within.values, **values)
        raw = orb.struct("SDOPackage.ConfigurationSet")(
            to_wire(within.id), self.raw[within.id].description, orb.nvlist(everything.items())
        )
        if not await self._call("set_configuration_set_values", raw):
            why = f"does not take values for configuration set {printable(within.id)}"
            raise errors.Refused(self.where, why)
        if self.active:
            await self.activate(self.active)

    def check_active(self, set_id):
        """Raise NoSuch or Refused unless `set_id` can be made the active set."""
        if set_id not in self.raw:
            self.set(set_id)
        if hidden(set_id):
            why = f"configuration set {printable(set_id)} holds metadata and cannot be active"
            raise errors.Refused(self.where, why)

    async def activate(self, set_id):
        """Make `set_id` the active set. Raises NoSuch, Refused."""
        self.check_active(set_id)
        try:
            if await self._call("activate_configuration_set", to_wire(set_id)):
                return
            why = "the component refused"
        except errors.Refused as e:
            why = e.why
        raise errors.Refused(self.where, f"does not activate configuration set {printable(set_id)} ({why})")

    async def apply(self, values, active=""):
        """Set the `values` ({set: {name: value}}), then activate `active`; all is checked first.

        Returns the changes as commands; `steps` gives the same list and changes nothing.
        """
        steps = self.steps(values, active)
        for set_id in sorted(values):
            within = self.set(set_id, with_hidden=True)
            if _changed(within, values[set_id]):
                await self.store(values[set_id], within)
        if active and active != self.active:
            await self.activate(active)
        return steps

    def steps(self, values, active=""):
        """The rtconf commands that do what `apply` does. Raises NoSuch for an unknown set or parameter."""
        steps = []
        for set_id in sorted(values):
            within = self.set(set_id, with_hidden=True)
            self.check_values(values[set_id], within)
            changed = _changed(within, values[set_id])
            if changed:
                words = [f"{name}={value}" for name, value in changed.items()]
                steps.append(self.command(set_id, "set", *words))
        if active:
            self.check_active(active)
        if active and active != self.active:
            steps.append(self.command(active, "act"))
        return steps

    def command(self, set_id, *words):
        """An rtconf command on a set of this component, ready for a shell."""
        return command(self.where, set_id, *words)


def command(where, set_id, *words):
    """An rtconf command on a set of the component at the path `where`, ready for a shell."""
    options = ["-s", set_id]
    if hidden(set_id):
        options.insert(0, "-a")
    if any(word.startswith("-") for word in words):
        options.append("--")
    return " ".join(shell_word(word) for word in ["rtconf", where] + options + list(words))


def _changed(within, values):
    return {name: value for name, value in values.items() if within.values.get(name) != value}


# ---- as text ----


def dumped(configuration, with_hidden=False):
    """The sets of a Configuration as lines:
    `[set]`, `[set] active`, `name=value`, control characters escaped.
    """
    lines = [f"# configuration of {configuration.where}"]
    for section in configuration.sets(with_hidden):
        active = " active" if section.active else ""
        lines.append(f"[{_spelt(section.id, ']')}]{active}")
        for name, value in section.values.items():
            lines.append(f"{_spelt(name, '=#[')}={_end_seen(printable(value))}")
    return lines


def _end_seen(s):
    """`s` with a blank at its end escaped, as editors strip those."""
    return s[:-1] + "\\x20" if s.endswith(" ") else s


def _spelt(s, more):
    s = printable(s)
    for c in more:
        s = s.replace(c, "\\" + c)
    return s


_SET = r"\[((?:[^\]\\]|\\.)*)\]( +active)? *\Z"
_VALUE = r"((?:[^=\\]|\\.)*)=(.*)\Z"


def parsed(lines, file_name):
    """Read what `dumped` wrote: ({set: {name: value}}, active set or '').
    Raises errors.Failed with the line's number.
    """
    values = {}  # type: dict
    active = ""
    current = None
    for number, line in enumerate(lines, 1):
        line = line.rstrip("\r\n")
        if not line.strip() or line.startswith("#"):
            continue
        try:
            if line.startswith("["):
                set_id, is_active = _set_line(line)
                if is_active and active not in ("", set_id):
                    raise ValueError("a second active set")
                current = values.setdefault(set_id, {})
                if is_active:
                    active = set_id
            else:
                _take_value(line, current)
        except ValueError as e:
            raise errors.Failed(f"{printable(file_name)}:{number}", e)
    return values, active


def _set_line(line):
    import re

    match = re.match(_SET, line)
    if not match:
        raise ValueError("not [set] or [set] active")
    return unescaped(match.group(1)), bool(match.group(2))


def _take_value(line, values):
    import re

    match = re.match(_VALUE, line)
    if not match:
        raise ValueError("neither [set] nor name=value")
    if values is None:
        raise ValueError("name=value before any [set]")
    name = unescaped(match.group(1))
    if name in values:
        raise ValueError(f"{printable(name)} has a value already")
    values[name] = unescaped(match.group(2))


def differences(left, right, with_hidden=False):
    """Rows (set, parameter, left value, right value) where two Configurations differ; None for what is
    missing.

    The row of the active sets has None for the first two.
    """
    rows = []
    sets = [{present.id: present.values for present in side.sets(with_hidden)} for side in (left, right)]
    for set_id in sorted(set(sets[0]) | set(sets[1])):
        values = [side.get(set_id, {}) for side in sets]
        for name in sorted(set(values[0]) | set(values[1])):
            before = values[0].get(name)
            after = values[1].get(name)
            if before != after:
                rows.append((set_id, name, before, after))
    if left.active != right.active:
        rows.append((None, None, left.active or None, right.active or None))
    return rows


class Dumped:
    """What `parsed` has read from a file, to be compared by `differences`."""

    def __init__(self, values, active):
        self.values = values
        self.active = active

    def sets(self, with_hidden=False):
        """The Sets, sorted by name."""
        chosen = [set_id for set_id in sorted(self.values) if with_hidden or not hidden(set_id)]
        return [Set(set_id, "", self.values[set_id], set_id == self.active) for set_id in chosen]


async def read(paths):
    """The Configuration of the component at each path; an errors.Error in the place of what failed."""
    return await tree.on_components(paths, of)
