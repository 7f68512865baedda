"""Short ways for tests of coroutines."""
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
