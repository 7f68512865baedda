"""What is known of one thing that an RtsProfile sets of a component: its state, a value, a connection …

    who keeps it has …              and of the component's state
    AGREES   seen or made it so     it is Active
    DIFFERS  not changed it: a      it went from Active to Inactive without an Error
             person has
    LOST     no right to blame      it was in Error, what executes it has ended, …
             a person

                    ┌──────────── LOST ────────────┐
                    ▼                              │
        ──────▶ UNKNOWN ───────── AGREES ──────▶ AGREED ──┐ AGREES
                 │   ▲                             │ ▲ ▲──┘
                 └───┘ LOST              DIFFERS   │ │ AGREES
                                                   ▼ │
                                                 BY_HAND ──┐ DIFFERS, LOST
                                                    ▲──────┘
UNKNOWN is brought to what the file says. So is AGREED, where the file has come to say something else;
otherwise it is a person who has changed it, and it is left alone as long as it is BY_HAND.
"""

UNKNOWN, AGREED, BY_HAND = "unknown", "agreed", "by hand"
AGREES, DIFFERS, LOST = "agrees", "differs", "lost"

NEXT = {
    UNKNOWN: {AGREES: AGREED, LOST: UNKNOWN},
    AGREED: {AGREES: AGREED, DIFFERS: BY_HAND, LOST: UNKNOWN},
    BY_HAND: {AGREES: AGREED, DIFFERS: BY_HAND, LOST: BY_HAND},
}


class Matter:
    """One such thing.

    knowledge  UNKNOWN, AGREED or BY_HAND
    setting    what the file said of it when it last agreed
    words      what a person has done, where it is BY_HAND
    complaint  the errors.Error that was last reported about it, and is not over, or None
    """

    __slots__ = ("knowledge", "setting", "words", "complaint")

    def __init__(self):
        self.knowledge = UNKNOWN
        self.setting = self.complaint = None
        self.words = ""

    def agree(self, setting=None):
        """It is as the file says, which is `setting`; returns what was known of it before."""
        before = self.knowledge
        self.setting = setting
        self.complaint = None
        self._move(AGREES)
        return before

    def differ(self, words):
        """A person has changed it; returns whether that is news."""
        if self.knowledge == BY_HAND:
            return False
        self.words = words
        self._move(DIFFERS)
        return True

    def lose(self):
        """Whatever it is next, nobody has done that."""
        self._move(LOST)

    def is_agreed(self, setting):
        """Whether it was as the file says when last looked at, and the file says the same now."""
        return self.knowledge != UNKNOWN and self.setting == setting

    def _move(self, event):
        self.knowledge = NEXT[self.knowledge][event]
