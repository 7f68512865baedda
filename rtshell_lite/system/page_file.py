"""The data in a page for a browser: one block of JSON. rtdoctor's reports have an RtsProfile there, too."""

import re

from rtshell_lite import errors

_BLOCK = re.compile(r'<script type="application/json" id="system">([^<]*)</script>')


def as_json(value):
    """JSON in ASCII that can be in an HTML file, as it is: no text in it ends or begins anything there."""
    import json  # not needed to see that a file is no page

    text = json.dumps(value, separators=(",", ":"))
    return text.replace("&", "\\u0026").replace("<", "\\u003c").replace(">", "\\u003e")


def is_page(text):
    """Whether a file may be a page."""
    return text[:100].lstrip().lower().startswith("<!doctype html")


def read(text, name):
    """The data, a dict, in the text of a page; `name` is the file in messages. Raises errors.Failed."""
    import json

    match = _BLOCK.search(text)
    if match is None:
        raise errors.Failed(name, "not a page of these commands")
    try:
        fields = json.loads(match.group(1))
    except (ValueError, RecursionError):
        raise errors.Failed(name, "its data are damaged")
    if not isinstance(fields, dict):
        raise errors.Failed(name, "not a page of these commands")
    return fields


def profile(text, name):
    """The text of the RtsProfile in the text of a report. Raises errors.Failed."""
    text_of_profile = read(text, name).get("profile")
    if not isinstance(text_of_profile, str):
        raise errors.Failed(name, "a page without a profile; rtdoctor --report writes one with a profile")
    return text_of_profile
