"""Bytecode of what is run straight from the wheel file, which Python itself would compile at each start.

It is kept in a private directory, rtshell_lite in $XDG_CACHE_HOME or in ~/.cache where there is one. What is
read there is executed: so directory and files must belong to this user and be closed to others, no link is
followed, and a checksum shows damage. What cannot be read is compiled, and written again; what cannot be
written is not kept. This module is itself compiled at each start: it is short.
"""

import marshal
import os
import sys
import zlib
from importlib.machinery import SourceFileLoader
from importlib.util import MAGIC_NUMBER, spec_from_file_location
from zipimport import ZipImportError, zipimporter

import rtshell_lite

_store = None  # type: Store  # of the wheel file that we run from


def keep():
    """Keep the code of what is imported from now on, if we run from a wheel file."""
    global _store
    archive = getattr(rtshell_lite.__spec__.loader, "archive", None)
    if not archive or not hasattr(os, "geteuid"):
        return
    directory = _private_directory()
    if directory is not None:
        _store = Store(archive, directory)
        sys.meta_path.insert(0, Finder())


class Finder:
    """Finds the modules of rtshell_lite in the wheel file, for `import`."""

    @staticmethod
    def find_spec(name, path=None, target=None):
        """The specification of a module; None for one that is not ours."""
        if not name.startswith("rtshell_lite."):
            return None
        (above,) = path
        stem = os.path.join(above, name.rpartition(".")[2])
        try:
            is_package = zipimporter(above).is_package(name)
        except ZipImportError:
            return None
        file = os.path.join(stem, "__init__.py") if is_package else stem + ".py"
        below = [stem] if is_package else None
        loader = Loader(name, file)
        return spec_from_file_location(name, file, loader=loader, submodule_search_locations=below)


class Loader(SourceFileLoader):
    """Loads a file of ours that may be in the wheel file: a module, or a command, which has no .py."""

    def get_data(self, path):
        """The bytes of a file of ours."""
        return rtshell_lite.__spec__.loader.get_data(path)

    def path_stats(self, path):
        """Say that nothing is kept beside the file: for Python."""
        raise OSError("nothing is kept beside it")

    def get_code(self, fullname):
        """The code of the file."""
        code = _store and _store.read(self.path)
        if code:
            return code
        code = super().get_code(fullname)
        if _store:
            _store.write(self.path, code)
        return code


class Store:
    """The code of files in a wheel file, kept in the directory that is open as the descriptor `directory`."""

    def __init__(self, archive, directory):
        status = os.stat(archive)
        archive_path = os.path.abspath(archive)
        made_of = archive_path, status.st_size, status.st_mtime_ns, sys.version
        self._identity = MAGIC_NUMBER + os.fsencode(repr(made_of))
        checksum = zlib.crc32(os.fsencode(archive_path))
        self._end = f".{checksum:08x}.{sys.implementation.cache_tag}-{sys.flags.optimize}"
        self._above = len(archive) + 1
        self._directory = directory

    def read(self, path):
        """The code of a file; None if it is not kept, or not as it was written."""
        flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
        try:
            with open(os.open(self._name(path), flags, dir_fd=self._directory), "rb") as file:
                if not _is_private(os.fstat(file.fileno())):
                    return None
                data = file.read()
        except OSError:
            return None
        kept = data[len(self._identity) + 4 :]
        if data != self._identity + _checksum(kept) + kept:
            return None
        return marshal.loads(kept)

    def write(self, path, code):
        """Keep the code of a file, if that is possible."""
        if sys.dont_write_bytecode:
            return
        kept = marshal.dumps(code)
        temporary = f".{os.urandom(8).hex()}.tmp"
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW | os.O_CLOEXEC
        here = self._directory
        try:
            file = open(os.open(temporary, flags, 0o600, dir_fd=here), "wb")
        except OSError:
            return
        try:
            with file:
                file.write(self._identity + _checksum(kept) + kept)
            os.replace(temporary, self._name(path), src_dir_fd=here, dst_dir_fd=here)
        except OSError:
            self._remove(temporary)

    def _remove(self, name):
        try:
            os.unlink(name, dir_fd=self._directory)
        except OSError:  # somebody has removed the directory meanwhile
            pass

    def _name(self, path):
        return path[self._above :].replace(os.sep, ".") + self._end


def _private_directory():
    """A descriptor of the directory that nobody else can change, or None."""
    above = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    if not os.path.isabs(above):  # to be ignored, as the specification of these directories says
        return None
    path = os.path.join(above, "rtshell_lite")
    try:
        if not os.path.lexists(path):
            os.mkdir(path, 0o700)
        directory = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
    except OSError:
        return None
    if _is_private(os.fstat(directory)):
        return directory
    os.close(directory)
    return None


def _is_private(status):
    return status.st_uid == os.geteuid() and not status.st_mode & 0o077


def _checksum(data):
    return zlib.crc32(data).to_bytes(4, "little")
