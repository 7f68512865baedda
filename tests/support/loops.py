"""Short ways for tests of coroutines."""
import concurrent.futures
import threading

from rtshell_lite.corba import session
from rtshell_lite.net import loop


def wait_for(coroutine, timeout=3.0, end=None):
    """The result of a coroutine, or what it raises, in a session with this timeout (seconds) and end."""
    now = session.Session(timeout)
    now.end = end
    return loop.run(coroutine, session=now)


def asynchronous(function):
    """A coroutine function that returns what a plain one does."""
    async def called(*args, **more):
        return function(*args, **more)
    return called


class Serving:
    """A loop on a thread, which serves what is begun in it, with this timeout (seconds), until close()."""

    def __init__(self, timeout):
        self.over = loop.Bell()
        began = concurrent.futures.Future()
        self._thread = threading.Thread(daemon=True, target=lambda: loop.run(
            self._run(began), session=session.Session(timeout)))
        self._thread.start()
        self.loop = began.result()

    async def _run(self, began):
        here = loop.current()
        here.make_bell()
        began.set_result(here)
        await self.serve()

    async def serve(self):
        await self.over.wait()

    def call(self, function, *args):
        """What function(*args) returns, or raises, on that thread."""
        result = concurrent.futures.Future()

        def work():
            try:
                result.set_result(function(*args))
            except Exception as e:
                result.set_exception(e)
        self.loop.post(work)
        return result.result()

    def close(self):
        self.loop.post(self.over.ring)
        self._thread.join()
