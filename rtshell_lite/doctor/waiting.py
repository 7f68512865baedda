"""What components wait for that answer, but do not report their ports: the far end of one of their
connections, found through the connections of their process.

Their ports cannot be asked, as they wait. On this host the kernel knows the TCP connections of their process.
"""

import collections
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


# What components of a process wait for: `paths` of hung components, whether that `is_certain`, and
# `endpoint`, that of the process to blame: of the only one that is hung, or else their own.
Culprits = collections.namedtuple("Culprits", "paths is_certain endpoint")


async def culprits(snapshots, hung):
    """{endpoint: Culprits} of the processes of which a component has answered and then hung, by Snapshots,
    and the Nodes `hung` that do not answer at all.
    """
    processes = {
        snapshot.node.endpoint
        for snapshot in snapshots
        if isinstance(snapshot.error, errors.Silent) and snapshot.answered
    }
    return {endpoint: await _culprits_of(endpoint, hung) for endpoint in sorted(processes)}


def blamed(process, culprits):
    """The endpoint of the process to blame for what a process does not answer, by what `culprits` returns."""
    return culprits[process].endpoint if process in culprits else process


async def _culprits_of(process, hung):
    """The Culprits of one process: those that it calls. If its connections are hidden, it may be any; of
    several Nodes of one process the first is named. Without any, those beside it in the process that hang.
    """
    others = {}
    beside = []
    for node in hung:
        if node.endpoint == process:
            beside.append(str(node.path))
        else:
            others.setdefault(node.endpoint, str(node.path))
    # the rest may take until there is no time to ask
    numeric = {endpoint: await _numeric(endpoint) for endpoint in others}
    own = await _sockets(process) if others else set()
    called = _called_by(own)
    ends = [endpoint for endpoint in others if not own or numeric[endpoint] & called]
    if not ends:
        return Culprits(beside[:1], False, process)
    if len(ends) == 1 and own:
        process = ends[0]
    return Culprits(sorted(others[endpoint] for endpoint in ends), bool(own), process)


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
    return {end(remote) for _, remote, inode in rows(ESTABLISHED) if inode in own}


async def _sockets(endpoint):
    """Inodes of all sockets of the process that listens at an endpoint of this host;
    none if that is hidden from us.
    """
    numeric = await _numeric(endpoint)
    if not any(addresses.is_own(str(address)) for address, _ in numeric):
        return set()
    listening = {inode for local, _, inode in rows(LISTENING) if end(local)[1] == endpoint[1]}
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


def rows(state):
    """(local end, far end, inode) of each TCP socket of this host in a state, as texts; see `end`."""
    sockets = set()
    for name in TABLES * READINGS:
        try:
            with open(name) as file:
                for row in map(str.split, file):
                    if row[3] == state:  # thousands that are closed may wait
                        sockets.add((row[1], row[2], row[9]))
        except OSError:
            continue  # no Linux
    return sockets


def end(text):
    """(IP address, port) from 0100007F:1F90: words of 32 bits, each in this host's byte order."""
    host, _, port = text.partition(":")
    octets = b"".join(bytes.fromhex(host[i : i + 8])[::-1] for i in range(0, len(host), 8))
    address = ipaddress.ip_address(octets)
    return getattr(address, "ipv4_mapped", None) or address, int(port, 16)
