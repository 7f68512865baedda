"""What a component that hangs waits for: the far end of one of its connections, found through the connections
of its process.

Its ports cannot be asked, as they wait. On this host the kernel knows the TCP connections of its process.
"""

import glob
import ipaddress
import os
import re

from rtshell_lite import errors
from rtshell_lite.doctor import addresses

ESTABLISHED = "01"
LISTENING = "0A"
TABLES = ("/proc/net/tcp", "/proc/net/tcp6")
READINGS = 3  # the kernel gives a table in pieces, and a row can slip through while sockets come and go


async def culprits(snapshot, hung):
    """(paths of those Nodes `hung` that the component of a Snapshot waits for, whether that is certain).

    It waits for one that its process calls. If its connections are hidden, it may be any; of several Nodes of
    one process the first is named.
    """
    others = {}
    for node in hung:
        if node.endpoint != snapshot.node.endpoint:
            others.setdefault(node.endpoint, str(node.path))
    # the rest may take until there is no time to ask
    numeric = {endpoint: await _numeric(endpoint) for endpoint in others}
    if others:
        own = await _sockets(snapshot.node.endpoint)
    else:
        own = set()
    called = _called_by(own)
    return sorted(path for endpoint, path in others.items() if not own or numeric[endpoint] & called), bool(
        own
    )


async def _numeric(endpoint):
    """{(IP address, port)} of an endpoint, whose host may be a name."""
    try:
        return {
            (ipaddress.ip_address(address.partition("%")[0]), endpoint[1])
            for address in await addresses.resolve(endpoint[0])
        }
    except errors.Error:
        return set()


def _called_by(own):
    """{(IP address, port)} of the far ends of the sockets whose inodes are `own`."""
    return {_end(remote) for _, remote, inode in _rows(ESTABLISHED) if inode in own}


async def _sockets(endpoint):
    """Inodes of all sockets of the process that listens at an endpoint of this host;
    none if that is hidden from us.
    """
    numeric = await _numeric(endpoint)
    if not any(addresses.is_own(str(address)) for address, _ in numeric):
        return set()
    listening = set()
    for local, _, inode in _rows(LISTENING):
        if _end(local)[1] == endpoint[1]:
            listening.add(inode)
    for process in glob.glob("/proc/[0-9]*"):
        inodes = _inodes(process)
        if inodes & listening:
            return inodes
    return set()


def _inodes(process):
    inodes = set()
    for path in glob.glob(process + "/fd/*"):
        try:
            match = re.match(r"socket:\[(\d+)\]", os.readlink(path))
        except OSError:
            continue
        if match:
            inodes.add(match.group(1))
    return inodes


def _rows(state):
    """(local end, far end, inode) of each TCP socket of this host in a state, as texts; see `_end`."""
    rows = set()
    for name in TABLES * READINGS:
        try:
            with open(name) as file:
                for row in map(str.split, file):
                    if row[3] == state:  # thousands that are closed may wait
                        rows.add((row[1], row[2], row[9]))
        except OSError:
            continue  # no Linux
    return rows


def _end(text):
    """(IP address, port) from 0100007F:1F90: words of 32 bits, each in this host's byte order."""
    host, _, port = text.partition(":")
    octets = b"".join(bytes.fromhex(host[i : i + 8])[::-1] for i in range(0, len(host), 8))
    address = ipaddress.ip_address(octets)
    return getattr(address, "ipv4_mapped", None) or address, int(port, 16)
