"""Answers of peers: shared by the requests that wait for them, and believed for a while."""


from rtshell_lite.corba import session
from rtshell_lite.mount.attempt import attempt
from rtshell_lite.net import loop


class Cache:
    """The CachedAnswers with a value, which is freed when it is believed no longer.

    tasks    the loop.Group in which peers are asked
    changes  how often something has been changed: nothing is believed that was asked before the last time
    """

    def __init__(self, tasks):
        self.tasks = tasks
        self.changes = 0
        self._kept = []

    def expire(self):
        """Note that something has been changed."""
        self.changes += 1

    def keep(self, answer):
        """Note that a CachedAnswer has a value."""
        self._kept.append(answer)

    def sweep(self):
        """Free the values that are believed no longer."""
        self._kept = [answer for answer in self._kept if not answer.drop()]


class CachedAnswer:
    """The answer to a remote question, believed for some `seconds`.

    0 seconds: each request gets an answer that was asked for after the request came.

    peer()   (endpoint, where) of the peer
    ask()    the value, a coroutine
    """

    __slots__ = ("_cache", "_peer", "_ask", "_seconds", "_value", "_until", "_asked", "_in_flight", "_next")

    def __init__(self, cache, peer, ask, seconds):
        self._cache = cache
        self._peer = peer
        self._ask = ask
        self._seconds = seconds
        self._value = None
        self._until = 0.0
        self._asked = 0  # Cache.changes when the value was asked for
        self._in_flight = None  # Waits for the question in flight, if its answer will be believed
        self._next = None  # Waits for the question after that; None if there is no question in flight

    def is_fresh(self):
        """Whether the value can be believed."""
        return self._until > loop.now() and self._asked == self._cache.changes

    def expire(self):
        """Believe nothing that was asked before now."""
        self._until = 0.0
        self._in_flight = None

    def drop(self):
        """Free a value that is believed no longer; returns whether there was nothing to free."""
        if not self.is_fresh():
            self._value = None
        return self._value is None

    async def get(self):
        """The value. Raises what `ask` raises."""
        if self.is_fresh():
            return self._value
        wait = loop.Wait()
        if self._seconds and self._in_flight is not None and self._asked == self._cache.changes:
            self._in_flight.append(wait)
        elif self._next is not None:
            self._next.append(wait)
        else:
            self._start([wait])
        return await wait

    def _start(self, waits):
        endpoint, where = self._peer()
        self._until = 0.0
        self._asked = self._cache.changes
        self._in_flight = waits
        self._next = []
        self._cache.tasks.start(self._answer(endpoint, where, waits), endpoint)

    async def _answer(self, endpoint, where, waits):
        value, error = await attempt(self._ask_process(endpoint, where))
        if self._in_flight is waits:
            self._in_flight = None
            self._keep(value)
        following = self._next
        self._next = None
        if following:
            self._start(following)
        for wait in waits:
            wait.end(value, error and loop.drop_traceback(error))

    async def _ask_process(self, endpoint, where):
        failure = session.current().why_not_asked(where, endpoint)
        if failure:
            raise failure
        return await self._ask()

    def _keep(self, value):
        if value is None or not self._seconds or self._asked != self._cache.changes:
            return
        if self._value is None:
            self._cache.keep(self)
        self._value = value
        self._until = loop.now() + self._seconds


class Known:
    """In the place of a CachedAnswer: a value that nobody has to be asked for."""

    def __init__(self, value):
        self._value = value

    async def get(self):
        return self._value
