"""The argument of create_component: IDENT[?KEY=VALUE[&KEY=VALUE…]]."""
import re


class Wanted:
    """A component to be created, as told in one line; `valid` is False if the line makes no sense."""

    def __init__(self, line, fields):
        self.line = line
        parts = line.split("?")
        self.ident = parts[0].strip()
        self.arguments = {}
        for pair in parts[1].split("&") if len(parts) > 1 else ():
            halves = pair.split("=")
            if len(halves) == 2:
                self.arguments[halves[0].strip()] = halves[1].strip()
        self.fields = self.ident.split(":")
        self.valid = len(parts) <= 2 and bool(self.ident) and (
            len(self.fields) == 1 or self.fields[0] == "RTC" and len(self.fields) == fields)
        self.implementation_id = self.fields[3 if len(self.fields) > 3 else 0]

    def matches(self, factory):
        """Whether a factory, given as a dict of its properties, is the one meant: fields may be left empty.
        """
        if len(self.fields) == 1:
            return True
        keys = ["vendor", "category", "implementation_id", "language", "version"]
        if len(self.fields) == 5:
            keys.remove("language")
        return all(field in ("", factory[key]) for field, key in zip(self.fields[1:], keys))


def extract(line, key):
    """(the value of `key` or None, the line without it); masters find their own keys behind a stray & too."""
    found = re.search(rf"[?&]{re.escape(key)}=([^&?]*)", line)
    if not found:
        return None, line
    before = line[:found.start()]
    after = line[found.end():]
    if after and "?" not in before:
        after = "?" + after[1:]
    return found.group(1).strip(), before + after
