"""Ctrl-C, SIGTERM and SIGHUP may interrupt the main thread anywhere; this module protects what must not be interrupted.

    with held(): …        signals that come meanwhile are raised afterwards
    Bell, Flag, Mailbox   for a main thread that waits for other threads

threading.Event, Condition and queue.Queue are unsafe there: an exception from a signal handler may leave Condition.wait
without its lock, which is then released once too often (RuntimeError; CPython 3.6 to 3.14). A bare lock is taken, or not, in
one step.

In CPython 3.12 and 3.13 the jump back of `while condition:` is outside the `try` or `with` around the loop: an exception raised
there is not caught, nor is `finally` run. Loops of the main thread for which that matters begin with `while True:`.
"""
import _signal  # which `signal` is made of: that one takes long to import
import collections
import sys
import time
from _thread import TIMEOUT_MAX, allocate_lock

SOON = 0.001  # seconds
CHECK = 0.3  # seconds until it is checked that an interrupt has not been swallowed
BOUNCE = 0.3  # seconds within which a second Ctrl-C is taken for the same key press
UNWINDING = 5.0  # seconds to clean up in before another signal ends the process

_held = 0  # how many `held` blocks the main thread is in
_waiting = None  # the exception to raise when it leaves the outermost one
_struck = None  # the exception raised last
_raised = -BOUNCE  # when that was
_ending = -UNWINDING  # when a signal came that ends the process


def strike(exception, ends=False):
    """For signal handlers: raise the exception, or have it raised when the `held` block ends.

    `ends`: it ends the process; others like it are ignored for UNWINDING seconds.
    """
    global _waiting, _ending
    now = time.monotonic()
    if now - _ending < UNWINDING if ends else now - _raised < BOUNCE:
        return
    if ends:
        _ending = now
    if _held:
        _waiting = exception if ends else _waiting or exception
        return
    _raise(exception)


def _raise(exception):
    global _waiting, _raised, _struck
    _waiting, _raised, _struck = None, time.monotonic(), exception
    _check_in(CHECK)
    raise exception


def _check_in(seconds):
    """See later whether the interrupt that was raised last is on its way."""
    _signal.signal(_signal.SIGALRM, _again)
    _signal.setitimer(_signal.ITIMER_REAL, seconds)


def lost(unraisable):
    """A sys.unraisablehook: an interrupt that Python dropped, in a __del__ or a callback, is raised again soon."""
    if unraisable.exc_value is None or unraisable.exc_value is not _struck:
        sys.__unraisablehook__(unraisable)
        return
    _check_in(SOON)


def _again(number, frame):
    """Raise the last interrupt again where nobody handles it: Python drops some in silence, such as in close() of a dying file."""
    global _waiting
    handled = sys.exc_info()[1]
    while handled is not None and handled is not _struck:
        handled = handled.__context__
    if _struck is None or handled is not None:
        return
    if _held:
        _waiting = _waiting or _struck
    else:
        _raise(_struck)


def arrived():
    """The interrupt has reached who wants to go on after it."""
    global _struck
    _struck = None


def begin():
    """Another command begins, in rtsh: the next Ctrl-C is meant for it."""
    global _raised
    _raised = -BOUNCE
    arrived()


def ctrl_c(number, frame):
    """The handler of SIGINT."""
    strike(KeyboardInterrupt())


def _on_main_thread():
    threading = sys.modules.get("threading")  # where nobody has imported it, there is one thread
    return threading is None or threading.current_thread() is threading.main_thread()


class held:
    """No signal interrupts this `with` block; signals never interrupt threads other than the main one."""

    def __enter__(self):
        global _held
        self._main = _on_main_thread()
        if self._main:
            _held += 1

    def __exit__(self, *_):
        global _held
        if not self._main:
            return
        _held -= 1
        exception = _waiting
        if exception and not _held:
            _raise(exception)


class Bell:
    """Other threads ring it, one thread waits for it; a successful wait resets it."""

    def __init__(self):
        self._lock = allocate_lock()
        self._lock.acquire()

    def ring(self):
        try:
            self._lock.release()
        except RuntimeError:
            pass  # it rings already

    def wait(self, seconds):
        """Wait for at most so many seconds; True if it rang."""
        return self._lock.acquire(timeout=min(max(0, seconds), TIMEOUT_MAX))


class Flag:
    """Other threads set it, for good; one thread waits for it."""

    def __init__(self):
        self._is_set, self._bell = False, Bell()

    def set(self):
        self._is_set = True
        self._bell.ring()

    def is_set(self):
        return self._is_set

    def wait(self, seconds):
        """Wait for at most so many seconds; True if it is set."""
        return self._is_set or self._bell.wait(seconds) or self._is_set


class Mailbox:
    """A queue: other threads `put` items, one thread gets them. At most `most` may wait, None for any number."""

    def __init__(self, most=None):
        self._items, self._most, self._bell = collections.deque(), most, Bell()

    def put(self, item):
        """Add an item, at once; False when it does not fit."""
        if self._most is not None and len(self._items) >= self._most:
            return False
        self._items.append(item)
        self._bell.ring()
        return True

    def get(self, seconds):
        """The next item; None when there is none after so many seconds."""
        end = time.monotonic() + seconds
        while not self._items:
            if not self._bell.wait(end - time.monotonic()):
                break
        return self._items.popleft() if self._items else None
