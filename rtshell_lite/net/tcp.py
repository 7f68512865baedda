"""Connections with TCP, made and awaited on the loop."""

import _socket  # which `socket` is made of: that one takes long to import
import errno
import os

from rtshell_lite.net import loop, real


def listen(host, port):
    """A socket that listens at an address, "" for all of this host, 0 for any port; None where that cannot
    be.
    """
    world = loop.world()
    families = (_socket.AF_INET, _socket.AF_INET6) if host else (_socket.AF_INET6, _socket.AF_INET)
    for family in families:
        try:
            address = world.resolve(host or None, 0, family, _socket.AI_PASSIVE)[0][4]
            return world.listen(family, address[:1] + (port,) + address[2:], bool(host))
        except (OSError, OverflowError, UnicodeError):
            continue
    return None


async def connect(way):
    """A socket that is connected with a place as of `resolve`, and does not block. Raises OSError; how long
    it waits is limited by the caller.
    """
    family, _, protocol, _, address = way
    stream = loop.world().stream(family, protocol)
    try:
        stream.setblocking(False)
        code = stream.connect_ex(address)
        if code == errno.EINPROGRESS:
            await loop.ready(stream.fileno(), loop.WRITE)
            code = real.failure(stream)
        if code:
            raise OSError(code, os.strerror(code))
        return stream
    except BaseException:
        stream.close()
        raise


async def receive(connection, most):
    """What comes next, `most` octets at most, b"" at its end. Raises OSError."""
    while True:
        await loop.ready(connection.fileno(), loop.READ)
        try:
            return connection.recv(most)
        except BlockingIOError:
            continue
