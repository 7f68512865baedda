"""A sender of logs as Fluent Bit's output `forward` is one: MessagePack over TCP."""
import gzip
import socket
import struct

LIMIT = 60.0  # seconds until an answer must have come


def pack(value):
    """A value as MessagePack; a float is a time of fluentd."""
    if value is None or isinstance(value, bool):
        return {None: b"\xc0", False: b"\xc2", True: b"\xc3"}[value]
    if isinstance(value, int):
        return struct.pack(">B", value) if 0 <= value < 128 else b"\xd3" + struct.pack(">q", value)
    if isinstance(value, float):
        return b"\xd7\0" + struct.pack(">LL", int(value), int(value % 1 * 1e9))
    if isinstance(value, str):
        octets = value.encode("utf-8", "surrogateescape")
        if len(octets) < 32:
            return struct.pack(">B", 0xA0 + len(octets)) + octets
        return b"\xdb" + struct.pack(">L", len(octets)) + octets
    if isinstance(value, bytes):
        return b"\xc6" + struct.pack(">L", len(value)) + value
    if isinstance(value, (list, tuple)):
        return b"\xdd" + struct.pack(">L", len(value)) + b"".join(map(pack, value))
    pairs = b"".join(pack(key) + pack(each) for key, each in value.items())
    return b"\xdf" + struct.pack(">L", len(value)) + pairs


def record(level, name, message):
    """A record with the fields that OpenRTM sends."""
    return {"time": "Nov 25 14:02:11.123", "name": name, "level": level, "pid": "4711", "host": "robot1",
            "manager": "manager", "message": message}


def message(mode, pairs, options=None):
    """One message of the protocol, in one of its modes."""
    more = [options] if options else []
    if mode == "message":
        return pack(["rtclog", pairs[0][0], pairs[0][1]] + more)
    if mode == "forward":
        return pack(["rtclog", pairs] + more)
    body = b"".join(map(pack, pairs))
    if mode == "gzip":
        return pack(["rtclog", gzip.compress(body), dict(options or {}, compressed="gzip")])
    return pack(["rtclog", body] + more)


def send(port, octets, answers=False):
    """Send octets; returns what is answered, if anything is to be."""
    with socket.create_connection(("127.0.0.1", port), LIMIT) as connection:
        connection.sendall(octets)
        return connection.recv(1000) if answers else b""
