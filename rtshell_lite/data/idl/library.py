"""IDL files in known directories: a type or an interface is found without its file being named.

The directories are those of RTSHELL_IDL (a colon between them), where OpenRTM-aist installs its own, and the
working directory itself. All files are searched for the word when something is wanted, and only files that
seem to declare it are parsed. Nothing is kept beyond this process.
"""

import glob
import os
import re
import stat

from rtshell_lite import errors, files, notes
from rtshell_lite.data.idl import parser, tokens
from rtshell_lite.text import printable

VARIABLE = "RTSHELL_IDL"
INSTALLED = ("/usr/include/openrtm-*/rtm/idl", "/usr/share/openrtm-*")
MOST_FILES = 5000
MOST_ENTRIES = 100000  # of directories
LARGEST = 64 << 20  # octets of all files
DEEPEST = 16  # directories within directories
LONGEST = 2000  # octets of a typedef
PLACES = 100  # where a name may be that is looked at
CANDIDATES = 10  # files that are parsed for one name


class Library:
    """The IDL files of some directories; they are read when something is first looked for.

    `include` are directories for #include, before those of the file and of the library.
    """

    def __init__(self, roots, include=()):
        self.roots = roots
        self.include = list(include)
        self._texts = None  # {path: octets}
        self._contents = {}  # {path: its parser.Contents, None for a file that cannot be read}
        self.faults = []  # an errors.Error for each of these

    def interface(self, type_id):
        """The Interface of a repository id; None where no file has it."""
        return self._first(type_id, "interfaces")

    def type(self, type_id):
        """The descriptor of a data type by its repository id; None where no file has it."""
        return self._first(type_id, "types")

    def types(self, name):
        """{repository id: descriptor} of the types of a name without its modules."""
        types = {}
        for path in self._candidates(name):
            for type_id, descriptor in self._types(path).items():
                if _last(type_id) == name and type_id not in types:
                    types[type_id] = descriptor
                    notes.detail(f"{printable(type_id)} is read from {printable(path)}")
        return types

    def _types(self, path):
        contents = self._parsed(path)
        return {} if contents is None else contents.types

    def _first(self, type_id, table):
        for path in self._candidates(_last(type_id), type_id):
            contents = self._parsed(path)
            if contents is not None and type_id in getattr(contents, table):
                notes.detail(f"{printable(type_id)} is read from {printable(path)}")
                return getattr(contents, table)[type_id]
        return None

    def _parsed(self, path):
        """The Contents of a file; None for one that cannot be read."""
        if path not in self._contents:
            try:
                where = self.include + [root for root in self.roots if root]
                self._contents[path] = parser.read_file(path, where, self._beneath)
            except errors.Error as e:
                notes.detail(str(e))
                self.faults.append(e)
                self._contents[path] = None
        return self._contents[path]

    def _candidates(self, name, type_id=""):
        """The files that may declare a name, the likeliest first: those that surely declare something of that
        name, and have all the words of the repository id.
        """
        named = name.encode("utf-8", "replace")
        word = re.escape(named)
        declared = re.compile(rb"\b(?:interface|struct|union|enum)\s+_?%s\b\s*[^\s;]" % word)
        pragma = type_id.encode("utf-8", "replace")
        words = re.findall(rb"\w+", pragma)[1:-2]
        ranked = []
        for path, text in self.texts().items():
            if pragma and pragma in text or named in text and declared.search(text):
                rank = 0
            elif named in text and _is_typedef(text, named):
                rank = 1
            else:
                continue
            ranked.append((rank, sum(part not in text for part in words), len(ranked), path))
        ranked.sort()
        for _, _, _, path in ranked[CANDIDATES:]:
            notes.detail(f"{printable(path)} is not read: too many files may declare {printable(name)}")
        return [path for _, _, _, path in ranked[:CANDIDATES]]

    def _beneath(self, name):
        """The file of the library that an #include may mean that is found nowhere else, by the end of its
        path.
        """
        ending = "/" + os.path.normpath(name).lstrip("./")
        return next((path for path in self.texts() if path.endswith(ending)), None)

    # ---- reading files ----

    def texts(self):
        """{path: octets} of all files, in the order of the roots, then by name."""
        if self._texts is None:
            self._texts = {}
            seen = set()
            left = LARGEST
            for path in _paths(self.roots):
                text = _text(path, left, seen)
                left -= len(text)
                if left <= 0:
                    notes.note(
                        f"{printable(path)} and what comes after it are not searched: too many IDL files"
                    )
                    break
                self._texts[path] = text
        return self._texts


def _is_typedef(text, named):
    """Whether a file seems to declare a name by a typedef. (A regular expression takes for ever on some
    files.)
    """
    start = text.find(named)
    for _ in range(PLACES):
        if start < 0:
            return False
        if b"typedef" in text[max(0, start - LONGEST) : start].rpartition(b";")[2]:
            return True
        start = text.find(named, start + len(named))
    return False


def _last(type_id):
    """MyService of IDL:SimpleService/MyService:1.0, and of any other spelling."""
    if type_id.count(":") == 2:
        type_id = type_id.split(":")[1]
    return re.split(r"[/.:]", type_id)[-1]


def roots():
    """Where IDL files are looked for that nobody names: the directories, and the files, of RTSHELL_IDL, of
    OpenRTM-aist; the working directory is not among them.
    """
    own = [part for part in os.environ.get(VARIABLE, "").split(":") if part]
    return own + [path for pattern in INSTALLED for path in sorted(glob.glob(pattern))]


def _paths(roots):
    """The paths of the IDL files in directories and all below them, without loops; "" is the working
    directory alone.
    """
    entries = 0
    count = 0
    seen = set()
    todo = [(root, 0) for root in reversed(roots)]
    while todo:
        root, depth = todo.pop()
        if os.path.isfile(root):
            yield root
            continue
        inner = []
        for entry in _listed(root, seen):
            entries += 1
            if entries > MOST_ENTRIES or count > MOST_FILES:
                notes.note(f"{printable(root)} and what comes after it are not searched: too many files")
                return
            path = os.path.join(root, entry.name)
            if entry.name.endswith(".idl"):
                count += 1
                yield path
            elif root and depth < DEEPEST and entry.name[0] != "." and _is_directory(entry):
                inner.append((path, depth + 1))
        todo += reversed(inner)


def _listed(directory, seen):
    """What is in a directory, by name; nothing for one that was listed before, by whatever path, or cannot
    be.
    """
    try:
        status = os.stat(directory or ".")
        if (status.st_dev, status.st_ino) in seen:
            return []
        seen.add((status.st_dev, status.st_ino))
        with os.scandir(directory or ".") as listed:
            return sorted(listed, key=lambda entry: entry.name)
    except OSError as e:
        notes.detail(f"{printable(directory)}: {e.strerror}")
        return []


def _is_directory(entry):
    try:
        return entry.is_dir()
    except OSError:  # a loop of links
        return False


def _text(path, most, seen):
    """The octets of a file, b"" for one that cannot be read or has been read by another path."""
    try:
        with files.opened(path) as file:
            status = os.fstat(file.fileno())
            if (status.st_dev, status.st_ino) in seen or not stat.S_ISREG(status.st_mode):
                return b""
            seen.add((status.st_dev, status.st_ino))
            return file.read(min(most, tokens.LARGEST))
    except (OSError, ValueError) as e:
        notes.detail(f"{printable(path)}: {getattr(e, 'strerror', None) or e}")
    except errors.Failed as e:
        notes.detail(str(e))
    return b""
