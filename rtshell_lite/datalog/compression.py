"""Chunks that somebody else has compressed: read where Python can do it, from 3.14 on."""

import importlib

from rtshell_lite.text import printable


def _zstd():
    """The module of Python 3.14 and later, or None."""
    try:
        return importlib.import_module("compression.zstd")
    except ImportError:
        return None


def refusal(name):
    """Why chunks compressed by `name` are not read, and what to do, in one line."""
    if name == "zstd":
        why = "zstd, which is read by Python 3.14 and later"
    else:
        why = f"{printable(name)}, which is not read"
    return f"compressed with {why}; `mcap decompress FILE -o OUT` makes a copy that can be read"


def is_read(name):
    return name == "zstd" and _zstd() is not None


def expand(octets, most):
    """At most `most` octets that zstd has compressed; None where they are damaged."""
    module = _zstd()
    try:
        return module.ZstdDecompressor().decompress(bytes(octets), most)
    except module.ZstdError:
        return None
