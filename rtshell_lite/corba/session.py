"""How one command asks, and what it has learnt of the processes that it asked."""

import errno
import os

from rtshell_lite import errors
from rtshell_lite.net import loop

GRACE = 0.2  # s after the deadline of omniORB, which knows more; ours is for what that does not bound
TICK = 0.1  # s between two looks at what has waited too long
AT_LEAST = 0.2  # s for a look-up, though the time of the command is over: it takes a thread some time
MOST_ANSWERED = 1000  # processes of which a session knows that they have answered
NO_TIME = "there was no time left to ask it"

_SCARCE = {
    errno.EMFILE: "files",
    errno.ENFILE: "files",
    errno.EADDRNOTAVAIL: "ports",
    errno.ENOBUFS: "memory",
    errno.ENOMEM: "memory",
}


class Memory:
    """What the commands of one process know of the processes that they have asked.

    answered      {endpoint: when it last answered}, by loop.now()
    idle          {endpoint: connections for the next calls}, see iiop/connections.py
    swept         when the idle ones were looked through, by loop.now()
    spoken        {endpoint: the x of GIOP 1.x}, for peers that did not understand a later one
    of_one_reply  endpoints of peers that close the connection after each reply, as far as is known
    """

    def __init__(self):
        self.answered = {}
        self.idle = {}
        self.swept = loop.now()
        self.spoken = {}
        self.of_one_reply = set()


class Session:
    """What the tasks of one command share.

    timeout      seconds that a peer may stay silent, from --timeout
    end          loop.now() after which no call is begun, or None: set by a command that promises to end
                 in time
    slots        each call is made within it, `async with slots:`; None where their number is not limited
    shortage     the errors.Shortage that made a connection fail on this host, or None: the peer is not to
                 blame
    silent       {endpoint: (when it was found silent, the words for it)}: it is not asked again for the
                 length of a timeout, so that the next step of a command, or a question about another
                 component, does not cost one more
    stalled      the same for processes that answer, but not what needs the answers of others: only calls of
                 that kind (failures.asks_others) are not made
    slow         {what, such as the name of a host: when it was found to be looked up slowly}; as `silent`.
                 None where it had less time than a timeout
    turned_away  how many connections to this command were turned away
    endless      paths, as text, below which a walk did not end
    looked_for   how many missing names were looked for in other directories
    checks       {(what, endpoint): answer} of what rtdoctor has tried of endpoints, for one examination
    on_end       functions(endpoint), called when a connection with a process has ended
    on_late      functions(endpoint), called when an object there that was asked no more, as it owed answers,
                 gives one: what it waited for is over
    memory       the Memory, for several commands where they run in one process
    """

    def __init__(self, timeout=3.0, memory=None):
        self.timeout = timeout
        self.memory = memory or Memory()
        self.end = None
        self.slots = None
        self.shortage = None
        self.turned_away = 0
        self.silent = {}
        self.stalled = {}
        self.slow = {}
        self.endless = set()  # type: set
        self.looked_for = 0
        self.checks = {}
        self.on_end = []
        self.on_late = []

    def is_over(self):
        """True when its `end` has passed."""
        return self.end is not None and loop.now() > self.end

    def silence(self, endpoint):
        """Why the process at `endpoint` is not to be asked anything now, or None."""
        return self._why_not(self.silent.get(endpoint), "its process gave %s")

    def stall(self, endpoint):
        """Why the process at `endpoint` is not to be asked now what it answers only when others have
        answered, or None.
        """
        return self._why_not(self.stalled.get(endpoint), "questions like it got %s from its process")

    def _why_not(self, silence, words):
        if silence is None:
            return None
        since, why = silence
        return words % why if loop.now() - since < self.timeout else None

    def why_not_asked(self, where, endpoint, asks_others=False, insists=False):
        """The errors.NotAsked for a call to the process at `endpoint` that is not to be made now, or None.
        A caller that `insists` knows that it was silent.
        """
        if self.is_over():
            return errors.NoTime(str(where), NO_TIME)
        why = not insists and self.silence(endpoint) or asks_others and self.stall(endpoint)
        return errors.NotAsked(str(where), why) if why else None

    def fall_silent(self, endpoint, why, since, asks_others=False):
        """A call made at `since` got no answer. What else the process is asked fails, unless it has answered
        others since: one object may hang though its process does not. A call that waits for others
        (`asks_others`) shows nothing but that.
        """
        if asks_others:
            self.stalled[endpoint] = loop.now(), why
        elif self.memory.answered.get(endpoint, 0) <= since:
            self.silent[endpoint] = loop.now(), why

    def is_slow(self, where):
        """Whether something has been looked up for too long a moment ago."""
        since = self.slow.get(where)
        return since is not None and loop.now() - since < self.timeout

    def ask_again(self, endpoint):
        """Have a process asked, though it was silent a moment ago."""
        self.silent.pop(endpoint, None)
        self.stalled.pop(endpoint, None)

    def has_answered(self, endpoint, when):
        """Note that a process has answered a call, so that it is not silent; `when` by loop.now()."""
        self.memory.answered[endpoint] = when
        if self.silent:
            self.silent.pop(endpoint, None)

    def sweep(self):
        """Forget what is too old to matter, in a session that lasts."""
        now = loop.now()
        answered = self.memory.answered
        for silences in (self.silent, self.stalled):
            past = [where for where, silence in silences.items() if now - silence[0] >= self.timeout]
            for endpoint in past:
                del silences[endpoint]
        for where in [where for where in self.slow if not self.is_slow(where)]:
            del self.slow[where]
        for endpoint in sorted(answered, key=answered.__getitem__, reverse=True)[MOST_ANSWERED:]:
            del answered[endpoint]

    def note_shortage(self, e, host):
        """Note an OSError of a connection to `host` that means that this host, not the other,
        lacks something.
        """
        what = _SCARCE.get(e.errno)
        # a host without IPv6 has no address for it, either
        if what and not (what == "ports" and ":" in host):
            self.shortage = errors.Shortage(what, os.strerror(e.errno))


def current():
    """The Session of the loop that runs on this thread; outside of one, a new one."""
    here = loop.current()
    if here is None:
        return Session()
    here.session = here.session or Session()
    return here.session


def no_answer(seconds):
    """The reason given for silence."""
    return f"no answer within {seconds:g}s"


def at_process(item):
    """Whom an item asks, for `each`."""
    return item.endpoint, item.where


def each(items, function, peer=at_process):
    """What function(item) returns for each item, in parallel by the process that answers, as loop.each: in
    order, an errors.Error for what failed, and for an item that is one.

    `peer(item)` gives (endpoint of that process, or anything hashable; the path of the object, or a text,
    for errors). After the first silence of a process, what it has not been asked yet fails as NotAsked.
    """
    items = list(items)
    peers = [(None, "") if isinstance(item, errors.Error) else peer(item) for item in items]
    here = current()

    async def attempt(number):
        item = items[number]
        if isinstance(item, errors.Error):
            raise item
        endpoint, where = peers[number]
        failure = here.why_not_asked(where, endpoint)
        if failure:
            raise failure
        return await function(item)

    return loop.each(range(len(items)), attempt, lambda number: peers[number][0])


async def on_thread(where, function):
    """What a function returns that blocks and asks no peer by CORBA, such as the look-up of a name.

    Raises Silent where that takes too long, and for the length of a timeout after it did; NoTime where the
    command's time ends before it does, or had ended, and another one took too long.
    """
    here = current()
    seconds = here.timeout
    late = errors.Silent(where, no_answer(seconds))
    if here.is_slow(where):
        raise late
    if here.slow and here.is_over():
        raise errors.NoTime(where, NO_TIME)
    if here.end is not None and here.end - loop.now() < seconds:
        seconds = max(AT_LEAST, here.end - loop.now())
        late = errors.NoTime(where, NO_TIME)
    try:
        return await loop.within(seconds, loop.on_thread(function), late)
    except (errors.Silent, errors.NoTime) as e:
        here.slow[where] = loop.now() if isinstance(e, errors.Silent) else None
        raise
