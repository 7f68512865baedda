"""RtsProfile files, read and written.

profile = rtsprofile.load(files.read(name), name)
for component in profile.components: ...
files.write(name, rtsprofile.dump(profile, "yaml"))
"""

import gc

from rtshell_lite import errors
from rtshell_lite.text import printable

XML = "xml"
YAML = "yaml"
EMPTY = "the file is empty"


def load(data, name, form=None):
    """The profile in a file: `data` is its bytes, or its text from files.read. Raises errors.BadProfile.

    `name` is the file in messages. Without a `form`, the content shows it.
    """
    if isinstance(data, str):
        try:
            data = data.encode("utf-8", "surrogateescape")
        except UnicodeEncodeError as e:
            raise errors.BadProfile(name, data.count("\n", 0, e.start) + 1, 1, "not text")
    if not data.strip():
        raise errors.BadProfile(name, 1, 1, EMPTY)
    if data.startswith(b"#!"):
        raise errors.BadProfile(
            name, 1, 1,
            "a script, not an RtsProfile: " + printable(data[:60].split(b"\n")[0].decode("latin-1")),
        )
    collecting = gc.isenabled()
    gc.disable()  # nothing here is garbage, and collecting took half of the time of a big file
    try:
        if (form or form_of(data)) == XML:
            from rtshell_lite.xmlprofile import xml

            return xml.read(data, name)
        from rtshell_lite.xmlprofile.yaml import form as yaml_form

        return yaml_form.read(data, name)
    finally:
        if collecting:
            gc.enable()


def form_of(data):
    """XML or YAML, by the first character of a file."""
    start = data[:1024].lstrip(b"\xef\xbb\xbf\xff\xfe\x00 \t\r\n")  # byte order marks, in UTF-16 too
    return XML if start.startswith(b"<") else YAML


def dump(profile, form):
    """The text of a file in XML or YAML, to be written as UTF-8."""
    if form == XML:
        from rtshell_lite.xmlprofile import xml

        return xml.write(profile)
    from rtshell_lite.xmlprofile.yaml import form as yaml_form

    return yaml_form.write(profile)
