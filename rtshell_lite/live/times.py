"""How often components are asked, or asked to report, by all that follow them; in seconds."""

from rtshell_lite.net import loop

# ---- observers ----

BEAT = 20.0  # between heartbeats that nobody sees; each costs the component a call
BEAT_SHOWN = 1.0  # the same for rtwatch, which shows what is late
BEATS_LATE = 1.5  # beats without a heartbeat, after which a component is asked whether it lives
BEATS_LOST = 3.0  # beats after which the missing heartbeat is reported
LATE = BEATS_LATE * BEAT
# How long components have to answer when observers are taken back. C++ 2.1 forgets an observer at once, but
# answers at its next heartbeat.
FAREWELL = 3.0  # those without heartbeats
HURRY = 0.3  # those with heartbeats
HURRY_SHOWN = 0.1  # for rtwatch, after Ctrl-C

# ---- questions ----

SEEK = 0.3  # between looks for the names of absent components; more where there are many
REST = 5.0  # until what is dead or silent is asked again: by rttop; a context of another process, by all
WHOLE = 12  # walks of which one looks up all names; the others leave out those of components that answer
AGAIN = 2.0  # between questions to a dead object whose name is still bound
LOST_ANSWER = 0.15  # until a question is repeated whose connection is lost: to a process that ends, as a rule
LOST_ANSWERS = 5  # how often it is repeated

# Until a component is asked again that did not answer, as it or a neighbour hangs; doubled each time. Each
# such question may hold a thread of the component.
FIRST_PAUSE = 4.0
LONGEST_PAUSE = 300.0


class Patience:
    """When a component may be asked again that does not answer: ever later."""

    __slots__ = ("until", "_count")

    def __init__(self):
        self.until = 0.0  # by loop.now()
        self._count = 0  # of questions in vain

    @property
    def is_on(self):
        """Whether its last question was in vain."""
        return self._count > 0

    def wait(self, first=FIRST_PAUSE):
        """It has not answered; `first`: the seconds until it may be asked again, the first time."""
        doublings = min(self._count, 20)  # it may hang for days
        self.until = loop.now() + min(first * 2**doublings, LONGEST_PAUSE)
        self._count += 1

    def end(self):
        """It has answered, or what held it up may be over."""
        self.until = 0.0
        self._count = 0
