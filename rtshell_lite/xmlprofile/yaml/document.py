"""A YAML document while it is read: its text, positions in it, limits, errors."""

import re

from rtshell_lite import errors
from rtshell_lite.xmlprofile.yaml.scalars import BREAK, TAB

MOST_NODES = 500000  # with aliases expanded; a system of 1,000 components and 2,000 connections has 200,000
DEEPEST = 150  # levels; 64 of XML become 128 at worst, and Python's stack holds 1,000 calls

_SPACE = re.compile(f"[ {BREAK}]*(#)?")
_COMMENT = re.compile(f"[^{BREAK}\x00]*")
_MARKER = re.compile(rf"(?:---|\.\.\.)(?=[ \0{BREAK}])")


class YamlNode:
    """A value and its position: str, list of YamlNode, or dict of str to YamlNode.
    `tag`: the type of text, None for plain text.
    """

    __slots__ = "value", "pos", "tag", "height"

    def __init__(self, value, pos, tag=None):
        self.value = value
        self.pos = pos
        self.tag = tag
        self.height = 0  # levels of nodes in it; 0: not known yet


class Document:
    """The text, the anchors so far, and the number of nodes so far."""

    def __init__(self, text, name):
        self.name = name
        self.text = text
        self.other_breaks = ""
        self.nodes = 0
        self.anchors = {}  # name: (node, number of nodes in it)
        self._texts = {}  # each text by itself: most come thousands of times

    def fail(self, pos, reason):
        start = self.text.rfind("\n", 0, pos) + 1
        line = self.text.count("\n", 0, pos) + 1
        raise errors.BadProfile(self.name, line, pos - start + 1, reason)

    def one(self, text):
        """The one object that is used for a text."""
        return self._texts.setdefault(text, text)

    def node(self, value, pos, depth, tag=None):
        """A new node, within the limits."""
        self.nodes += 1
        if self.nodes > MOST_NODES:
            self.fail(pos, f"more than {MOST_NODES} values")
        if depth > DEEPEST:
            self.fail(pos, f"more than {DEEPEST} levels")
        return YamlNode(value, pos, tag)

    def column(self, pos):
        start = self.text.rfind("\n", 0, pos) + 1
        for other in self.other_breaks:
            start = max(start, self.text.rfind(other, start, pos) + 1)
        return pos - start

    def skip(self, pos):
        """The position of the next token, after blanks, comments and line ends."""
        while True:
            match = _SPACE.match(self.text, pos)
            if not match.group(1):
                break
            pos = _COMMENT.match(self.text, match.end()).end()
        if self.text[match.end()] == "\t":
            self.fail(match.end(), TAB)
        return match.end()

    def next_token(self, pos):
        """The position of the next token, and its column; -1 at the end of the document."""
        pos = self.skip(pos)
        return pos, self.token_column(pos)

    def token_column(self, pos):
        """The column of the token at `pos`; -1 at the end of the document."""
        column = self.column(pos)
        if self.text[pos] == "\0":
            return -1
        if column == 0 and _MARKER.match(self.text, pos):
            return -1
        return column
