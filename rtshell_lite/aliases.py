"""Directories that are bound by several names: naming contexts and managers that are one object, told by their references."""
import socket

from rtshell_lite import errors, orb, rpc


class Known:
    """The first Path of each naming context and manager that a walk has entered."""

    def __init__(self, nodes=()):
        self._entered = {}  # (TCP port, object key): [(host, Path)]
        for node in nodes:
            self.enter(node)

    def path(self, node):
        """The Path by which the object of a Node was entered, None when it was not."""
        host, port, key = orb.identity(node.ref)
        return next((path for other, path in self._entered.get((port, key), ()) if same_host(host, other)), None)

    def enter(self, node):
        """Remember a Node; a reference without an IIOP address has no identity, and is not remembered."""
        host, port, key = orb.identity(node.ref)
        if key:
            self._entered.setdefault((port, key), []).append((host, node.path))


def same_host(one, other):
    """True when two host names or addresses have an IP address in common."""
    return one == other or not _addresses(one).isdisjoint(_addresses(other))


def _addresses(host):
    try:
        return rpc.ask(("name of", host), host, lambda: _looked_up(host))
    except errors.Error:
        return frozenset()


def _looked_up(host):
    try:
        return frozenset(found[4][0] for found in socket.getaddrinfo(host, None, 0, socket.SOCK_STREAM))
    except (OSError, UnicodeError):
        return frozenset()
