"""State machines of FSM4RTC: the SDO service RTC::ExtendedFsmService of a component."""

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.text import from_wire, printable, shell_word, to_wire

LARGEST = 1 << 20  # octets of a structure that is sent: it has to be read again, and put back
SERVICE = "IDL:omg.org/RTC/ExtendedFsmService:1.0"


async def of(node):
    """The Machine of the component `node`. Raises NoSuch where it has none.

    The service is taken from the list of all, as get_sdo_service ends components of C++ 2.1.
    """
    services = [
        profile.service
        for profile in await node.call("get_service_profiles")
        if SERVICE in (profile.interface_type, profile.id) and profile.service is not None
    ]
    if not services:
        what = "ExtendedFsmService (it is not a state machine of FSM4RTC)"
        raise errors.NoSuch(str(node.path), "SDO service", what)
    return Machine(str(node.path), orb.narrow(services[0], "RTC.ExtendedFsmService"))


class Machine:
    """The state machine of the component at the path `where`, and the reference of its service."""

    def __init__(self, where, ref):
        self.where = where
        self.ref = ref

    async def state(self):
        """The name of the current state."""
        return from_wire(await orb.call(self.where, self.ref, "get_current_state"))

    async def _raw(self):
        code, structure = await orb.call(self.where, self.ref, "get_fsm_structure")
        if str(code) != "RTC_OK":
            raise errors.Refused(self.where, f"does not report its structure ({code})")
        return structure

    async def structure(self):
        """A dict: name, structure (SCXML), event_profiles (pairs name, data type), properties (pairs)."""
        raw = await self._raw()
        return {
            "name": from_wire(raw.name),
            "structure": from_wire(raw.structure),
            "event_profiles": _pairs(raw),
            "properties": orb.properties(raw.properties),
        }

    async def set_structure(self, content, dry_run=False):
        """Replace the text of its structure; returns whether that changes, or with `dry_run` would change,
        anything.
        """

        def change(structure):
            structure.structure = to_wire(content)

        return await self._set(change, lambda structure: from_wire(structure.structure), content, dry_run)

    async def set_event_profiles(self, pairs, dry_run=False):
        """Replace its event profiles by `pairs` of name and data type; returns what `set_structure` does."""
        event_profile = orb.struct("RTC.FsmEventProfile")

        def change(structure):
            structure.event_profiles = [event_profile(to_wire(name), to_wire(kind)) for name, kind in pairs]

        return await self._set(change, _pairs, pairs, dry_run)

    async def _set(self, change, read, expected, dry_run):
        """Change one part of the structure and read it again: RTC_OK alone proves nothing."""
        structure = await self._raw()
        if read(structure) == expected:
            return False
        if dry_run:
            return True
        change(structure)
        code = str(await orb.call(self.where, self.ref, "set_fsm_structure", structure))
        if code != "RTC_OK":
            raise errors.Refused(self.where, f"does not take it ({code})")
        if read(await self._raw()) != expected:
            raise errors.Refused(self.where, "does not take it (RTC_OK but unchanged)")
        return True


def _pairs(structure):
    return [(from_wire(profile.name), from_wire(profile.data_type)) for profile in structure.event_profiles]


def event_profiles(word):
    """Pairs of name and data type from `NAME:TYPE,NAME:TYPE`. Raises Usage."""
    pairs = []
    for part in word.split(","):
        name, _, kind = part.strip().partition(":")
        if not name or not kind:
            raise errors.Usage("seteventprofiles: not NAME:TYPE: %s" % (printable(part.strip()) or "''"))
        pairs.append((name, kind))
    return pairs


def command(path, name, argument):
    """An rtfsm command, ready for a shell."""
    return " ".join(["rtfsm", shell_word(str(path)), name, shell_word(argument)])
