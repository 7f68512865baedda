"""Where hosts are, by their names, and the networks of this one."""

from rtshell_lite import errors
from rtshell_lite.net import loop, real

MOST = 32  # names that are looked up at a time, with a thread each


class LookUp:
    """The places of a host: `found` is a list as of getaddrinfo, an OSError, or None while pending.

    Names that others resolve may take long, and nothing can interrupt that: once `begin` is called, a thread
    asks, unless too many are asking already. All who want the same name share it.
    """

    def __init__(self, host):
        self.found = None if host else OSError(0, "no address of IIOP in its reference")
        self._world = loop.world()
        self._host = host
        self._asking = None  # the LookUp whose thread asks
        if self.found:
            return
        self._ask(0 if host == "localhost" else real.NUMERIC)
        if isinstance(self.found, OSError) and host != "localhost":
            self.found = None

    def begin(self):
        """Ask others, unless that has been done; to be called until there is an answer."""
        if self._asking is None:
            self._asking = self._world.looking_up.get(self._host) or self._started()
        if self._asking is not None:
            self.found = self._asking.found

    def _started(self):
        """This LookUp, whose thread asks now; None where too many are asking."""
        looking_up = self._world.looking_up
        if len(looking_up) >= MOST:
            return None
        looking_up[self._host] = self
        try:
            self._world.start_thread(self._ask_others)
        except errors.Shortage as e:
            self.found = OSError(0, str(e))
            looking_up.pop(self._host, None)
        return self

    def _ask_others(self):
        try:
            self._ask()
        finally:
            self._world.looking_up.pop(self._host, None)

    def _ask(self, flags=0):
        try:
            self.found = _resolve(self._world, self._host, flags)
        except (OSError, ValueError) as e:  # ValueError: a NUL in it
            self.found = e if isinstance(e, OSError) else real.NoSuchHost(0, str(e))


def resolve(host):
    """The places of a host as of getaddrinfo, [] for one that is not known;
    the look-up of a name may take long.
    """
    try:
        return _resolve(loop.world(), host)
    except (OSError, ValueError):
        return []


def _resolve(world, host, flags=0):
    try:
        name = host.encode("ascii")
    except UnicodeError:
        name = host.encode("utf-8", "surrogateescape")
    return world.resolve(name, flags=flags)


# ---- networks ----


def together(first, other):
    """Whether two IP addresses are in the same network; None if the networks of this host do not show it."""
    if first == other:
        return True
    import ipaddress  # takes long, and few need it

    numbers = [ipaddress.ip_address(address.partition("%")[0]) for address in (first, other)]
    if all(number.is_loopback for number in numbers):
        return True
    is_known = False
    for network in [interface.network for _, interface in interfaces()]:
        inside = [number in network for number in numbers]
        if all(inside):
            return True
        is_known = is_known or any(inside)
    return False if is_known else None


def interfaces():
    """[(name, ipaddress.IPv4Interface)] of this host."""
    import ipaddress

    listed = loop.world().interfaces()
    return [(name, ipaddress.ip_interface(f"{address}/{mask}")) for name, address, mask in listed]
