"""Sockets that listen."""

import socket


def socket_at(host, port):
    """A socket that listens at an address, "" for all of this host, 0 for any port; None where that cannot
    be.
    """
    if host:
        families = (socket.AF_INET, socket.AF_INET6)
    else:
        families = (socket.AF_INET6, socket.AF_INET)
    for family in families:
        try:
            place = socket.getaddrinfo(host or None, 0, family, socket.SOCK_STREAM, 0, socket.AI_PASSIVE)[0][
                4
            ]
            made = socket.socket(family, socket.SOCK_STREAM)
        except (OSError, UnicodeError):
            continue
        try:
            if family == socket.AF_INET6:
                made.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, bool(host))
            made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            made.bind(place[:1] + (port,) + place[2:])
            made.listen(128)
            made.setblocking(False)
            return made
        except (OSError, OverflowError):
            made.close()
    return None
