"""All modules that --unpack laid out, in one compiled file: Python reads it faster than a file for each.

A module whose own file has changed since is imported from that.
"""

import marshal
import os
import sys
from _frozen_importlib import ModuleSpec  # importlib itself takes long
from _frozen_importlib_external import MAGIC_NUMBER, _LoaderBasics as Loader
from _imp import _fix_co_filename as fix_file_name

NAME = "rtshell_lite.%s.compiled" % sys.implementation.cache_tag
_BEGIN = 16  # octets: MAGIC_NUMBER, the length of the index (4), and that of the file (8)
_LIB = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def find():
    """Import modules from the file from now on, if there is one that this Python made, and it is whole."""
    try:
        file = os.open(os.path.join(_LIB, NAME), os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    except OSError:
        return
    try:
        begin = os.read(file, _BEGIN)
        length = int.from_bytes(begin[4:8], "little")
        size = int.from_bytes(begin[8:], "little")
        if begin[:4] != MAGIC_NUMBER or os.fstat(file).st_size != size:
            return
        index = marshal.loads(os.read(file, length))
    except (OSError, EOFError, ValueError, TypeError):  # damaged, or no file
        return
    finally:
        os.close(file)
    sys.meta_path.insert(0, _Finder(index, _BEGIN + length))


def join(modules):
    """The content of the file, of (name, its file below the directory, status of that, code)."""
    index = {}
    codes = []
    offset = 0
    for name, file_name, status, code in modules:
        codes.append(marshal.dumps(code))
        index[name] = file_name, int(status.st_mtime), status.st_size, offset, len(codes[-1])
        offset += len(codes[-1])
    head = marshal.dumps(index)
    size = _BEGIN + len(head) + offset
    begin = MAGIC_NUMBER + len(head).to_bytes(4, "little") + size.to_bytes(8, "little")
    return begin + head + b"".join(codes)


class _Finder(Loader):
    """Finds and loads the modules of the file."""

    def __init__(self, index, start):
        self._index = index
        self._start = start

    def find_spec(self, name, path=None, target=None):
        if name not in self._index:
            return None
        file_name, mtime, size, _, _ = self._index[name]
        origin = os.path.join(_LIB, file_name)
        try:
            status = os.stat(origin)
        except OSError:
            return None
        if (int(status.st_mtime), status.st_size) != (mtime, size):
            return None
        spec = ModuleSpec(name, self, origin=origin)  # type: ignore
        if file_name.endswith("__init__.py"):
            spec.submodule_search_locations = [os.path.dirname(origin)]
        return spec

    def exec_module(self, module):
        module.__file__ = module.__spec__.origin
        super().exec_module(module)

    def get_code(self, name):
        file_name, _, _, offset, length = self._index[name]
        file = os.open(os.path.join(_LIB, NAME), os.O_RDONLY | os.O_CLOEXEC)
        try:
            code = marshal.loads(os.pread(file, length, self._start + offset))
        finally:
            os.close(file)
        fix_file_name(code, os.path.join(_LIB, file_name))
        return code
