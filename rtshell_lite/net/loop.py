"""The one loop on which everything waits: tasks, timers, sockets, threads and signals.

    loop.run(main())                     runs a coroutine to its end on this thread
    await loop.sleep(seconds)
    await loop.each(items, look)         look(item) for all items in parallel; the results in order
    async for x in loop.each(items, look):  the same, one after the other, as soon as they have come
    await loop.race(one(), other())      the result of the first that ends; the others are cancelled
    await loop.finish(change())          its result; it is not cut off when the task that awaits it is
                                         cancelled
    async with loop.background(poll()):  poll() runs beside the block, and is cancelled at its end

A task runs until it awaits what has not come yet, and nothing else runs meanwhile: plain code needs no locks.
No task outlives the block that began it. Signals arrive at an `await` of the main task, so that `finally` and
`async with` work; elsewhere only where none comes. The names are those of asyncio and trio; it is ours
because importing asyncio takes three times as long as a whole command.
"""

import _signal  # which `signal` is made of: that one takes long to import
import os
import select
import sys
from _collections import deque  # which `collections` is made of, as here of others
from _heapq import heapify, heappop, heappush
from _thread import _local as Local, allocate_lock  # which `threading` is made of

from rtshell_lite import errors, notes
from rtshell_lite.net import real

READ = select.POLLIN  # events for which `ready` and `Loop.watch` look
WRITE = select.POLLOUT
URGENT = select.POLLPRI
MOST = 64  # tasks of one `each` at a time with one key
AWAY = 0.3  # seconds; a loop that was busy or stopped for longer was away
BOUNCE = 0.3  # seconds in which a second Ctrl-C is taken for the same key press
UNWINDING = 5.0  # seconds to clean up in after a signal
_COROUTINE = 0x280  # flag of the code of coroutines and asynchronous generators
PATIENCE = 0.2  # seconds until a signal strikes a task that awaits nothing
SPARE = 0.1  # seconds that a thread waits for more work
FOREVER = 3600.0  # seconds of one poll, which has a limit
FEW_TIMERS = 100
SHOWN = 0.5  # seconds between two looks how far a pause is
ROUNDS = 4  # that tasks go on, as they wake each other, until a look at what has come

_here = Local()  # its `loop` is the one that runs on this thread


class Cancelled(BaseException):
    """Thrown into a task that is not to go on, at what it awaits."""


def now():
    """Seconds by a clock that is never set; on any thread."""
    here = getattr(_here, "loop", None)
    return world().now() if here is None else here.now()


def wall():
    """Seconds since 1970, by the clock of this computer; on any thread."""
    return world().wall()


def world():
    """The world in which this thread runs: net/real.py, or what `inhabit` has said."""
    return getattr(_here, "world", real)


def inhabit(other):
    """From now on this thread, and what runs on it, is in another world: that of a test."""
    _here.world = other


def run(coroutine, signals=None, session=None, as_guest=False):
    """Run a coroutine to its end on this thread: its result, or what it raises.

    signals   {number: function without arguments that makes an exception, or None for none}: what the signals
              raise, on the main thread
    session   what the tasks find as current().session
    as_guest  in a program that uses SIGALRM itself: signals arrive at an `await` only
    """
    loop = Loop(world())
    loop.session = session
    loop.is_guest = as_guest
    try:
        return loop.complete(coroutine, signals or {})
    finally:
        loop.close()


def current():
    """The Loop that runs on this thread, or None."""
    return getattr(_here, "loop", None)


class Wait:
    """What one task awaits: `done(value)` or `failed(error)` lets it go on."""

    __slots__ = ("task", "is_over", "value", "error")

    def __init__(self):
        self.task = None
        self.is_over = False
        self.value = None
        self.error = None

    def __await__(self):
        if not self.is_over:
            yield self
        if self.error is not None:
            raise self.error
        return self.value

    def done(self, value=None):
        """Let the task go on with a value, unless it has one."""
        self.end(value, None)

    def failed(self, error):
        """Let the task go on with an exception, unless it has an outcome."""
        self.end(None, error)

    def end(self, value, error):
        """`done`, or `failed` where there is an error."""
        if self.is_over:
            return
        self.is_over = True
        self.value = value
        self.error = error
        if self.task is not None:
            self.task.wake()


class Task:
    """A coroutine that runs on a loop, in a Group; the main task has none.

    place   what `each` grouped it by, inherited by the tasks that it begins
    result  what it returned, once `is_over`
    error   what it raised, or None
    """

    __slots__ = ("coroutine", "loop", "group", "place", "awaited", "thrown", "is_over", "result", "error")

    def __init__(self, loop, coroutine, group, place):
        self.loop = loop
        self.coroutine = coroutine
        self.group = group
        self.place = place
        self.awaited = None  # type: Wait
        self.thrown = self.result = self.error = None
        self.is_over = False
        loop.ready.append(self)

    def wake(self):
        """Have the loop let it go on: what it awaits is there."""
        self.awaited.task = self.awaited = None
        self.loop.ready.append(self)

    def throw(self, exception):
        """Have an exception raised at what it awaits."""
        if self.is_over:
            return
        if self.thrown is None or isinstance(self.thrown, Cancelled):
            self.thrown = exception
        if self.awaited is not None:
            self.wake()

    def cancel(self):
        """Raise Cancelled in it; a task that has not begun never will."""
        self.throw(Cancelled())

    def close(self):
        """End it where it is, without the loop."""
        if not self.is_over:
            self.coroutine.close()

    def go_on(self):
        """Run it until it awaits what has not come yet, or ends."""
        exception = self.thrown
        self.thrown = None
        try:
            awaited = self.coroutine.send(None) if exception is None else self.coroutine.throw(exception)
        except StopIteration as end:
            self._end(end.value, None)
        except BaseException as e:
            self._end(None, e)
        else:
            awaited.task = self
            self.awaited = awaited

    def _end(self, result, error):
        self.is_over = True
        self.result = result
        self.error = error
        self.coroutine = None
        if self.group is not None:
            self.group.ended(self)


class Group:
    """Tasks that end with a block: `async with Group() as group: group.start(coroutine)`.

    The block waits for them all. When one fails, or the block does, the others are cancelled, and the failure
    is raised.
    """

    def __init__(self):
        self.loop = current()
        self.parent = self.loop.running
        self.tasks = {}  # type: dict  # of them alone: a set has no order
        self.failure = None
        self._all_over = None  # a Wait of the parent at the end of the block

    def start(self, coroutine, place=None):
        """Begin a Task."""
        task = Task(self.loop, coroutine, self, self.parent.place if place is None else place)
        self.tasks[task] = True
        return task

    def cancel(self):
        """Cancel all tasks."""
        for task in self.tasks:
            task.cancel()

    def ended(self, task):
        """A task has ended; called by it."""
        self.tasks.pop(task, None)
        if task.error is not None and not isinstance(task.error, Cancelled):
            self._fail(task.error)
        if not self.tasks and self._all_over is not None:
            self._all_over.done()

    def _fail(self, error):
        if self.failure is not None:
            return
        self.failure = error
        self.cancel()
        if self._all_over is None:  # the block is not at its end
            self.parent.cancel()

    async def __aenter__(self):
        return self

    async def __aexit__(self, kind, error, traceback):
        if error is not None:
            self.cancel()
        while self.tasks:
            self._all_over = Wait()
            try:
                await self._all_over
            except BaseException as e:  # a signal, or the group around this one: its tasks may still clean up
                if error is None or isinstance(error, Cancelled):
                    error = e
                self.cancel()
        if self.failure is not None and (error is None or isinstance(error, Cancelled)):
            raise self.failure
        if error is not None:
            raise error


class background:
    """`async with background(coroutine) as task:` runs it beside the block,
    and cancels it at the end of the block.
    """

    def __init__(self, coroutine):
        self._coroutine = coroutine
        self._group = None  # type: Group

    async def __aenter__(self):
        self._group = Group()
        return self._group.start(self._coroutine)

    async def __aexit__(self, kind, error, traceback):
        self._group.cancel()
        return await self._group.__aexit__(kind, error, traceback)


def each(items, function, key=None):
    """The results of function(item), a coroutine function, for all items in parallel, in order; an
    errors.Error for what failed. `await` it for a list of all; or `async for` each as soon as those before it
    have come: then none is kept, as thousands take much memory.

    key(item) groups them: at most MOST of one key run at a time, so that thousands do not take memory while
    they wait.
    """
    return _Each(items, function, key)


_TO_COME = object()  # in place of a result


class _Each:
    """Items, and the results of a function for them."""

    def __init__(self, items, function, key):
        self.items = list(items)
        self.function = function
        self.key = key
        self.results = [_TO_COME] * len(self.items)
        self.failure = None  # type: BaseException
        # the number of the result that `_in_order` waits for, and its Wait
        self._wanted = None
        self._came = None  # type: Wait

    def __await__(self):
        return self._all().__await__()

    def __aiter__(self):
        return self._in_order()

    async def _all(self):
        async with Group() as group:
            for place, work in self.workers():
                group.start(work, place)
        return self.results

    async def _in_order(self):
        here = current()
        tasks = [
            Task(here, work, self, here.running.place if place is None else place)
            for place, work in self.workers()
        ]
        try:
            for number in range(len(self.items)):
                if self.results[number] is _TO_COME:
                    await self.wait_for(number)
                result = self.results[number]
                self.results[number] = None
                yield result
        finally:
            for task in tasks:
                task.cancel()

    def workers(self):
        """(key, coroutine) pairs, which share the work."""
        queues = {}  # type: dict
        for number, item in enumerate(self.items):
            queues.setdefault(self.key(item) if self.key else None, deque()).append(number)
        for place, queue in queues.items():
            for _ in range(min(MOST, len(queue))):
                yield place, self._work(queue)

    async def _work(self, queue):
        while queue:
            number = queue.popleft()
            try:
                self.results[number] = await self.function(self.items[number])
            except errors.Error as e:
                self.results[number] = drop_traceback(e)
            if number == self._wanted:
                self._came.done()

    async def wait_for(self, number):
        """Wait until a result has come. Raises what a function has raised that is no errors.Error:
        a bug of ours.
        """
        if self.failure is None:
            self._wanted = number
            self._came = Wait()
            await self._came
        if self.results[number] is _TO_COME:
            raise self.failure

    def ended(self, task):
        """A worker has ended; called by it."""
        if task.error is None or isinstance(task.error, Cancelled):
            return
        self.failure = self.failure or task.error
        if self._came is not None:
            self._came.done()


def drop_traceback(e):
    """A failure without its traceback: the frames of 20,000 failures took 140 MB."""
    e.__traceback__ = e.__context__ = None
    return e


async def race(*coroutines):
    """The result of the coroutine that ends first, or what it raises; the others are cancelled."""
    first = Wait()

    async def run_one(coroutine):
        try:
            first.done(await coroutine)
        except Exception as e:
            first.failed(e)

    async with Group() as group:
        for coroutine in coroutines:
            group.start(run_one(coroutine))
        try:
            return await first
        finally:
            group.cancel()


async def within(seconds, coroutine, late):
    """The result of a coroutine; raises the exception `late` if that takes longer than `seconds`."""
    return await race(coroutine, _raise_later(seconds, late))


async def _raise_later(seconds, exception):
    await sleep(seconds)
    raise exception


async def finish(coroutine):
    """The result of a coroutine that runs to its end though its caller is cancelled, or struck by a signal;
    that is raised afterwards.
    """
    here = current()
    end = _End()
    struck = None
    task = Task(here, coroutine, end, here.running.place)
    while not task.is_over:
        end.wait = Wait()
        try:
            await end.wait
        except GeneratorExit:  # the loop has ended
            raise
        except BaseException as e:
            struck = e
    if struck is not None:
        raise struck
    if task.error is not None:
        raise task.error
    return task.result


class _End:
    """In place of a Group: what is to be called when a task has ended."""

    wait = None  # type: Wait

    def ended(self, task):
        self.wait.done()


async def sleep(seconds):
    """Let other tasks go on for `seconds`."""
    wait = Wait()
    timer = current().call_later(seconds, wait.done)
    try:
        await wait
    finally:
        timer.cancel()


class Bell:
    """Others ring it, one task waits for it.
    It rings until that has heard it; rung again meanwhile, it rings once.
    """

    def __init__(self):
        self._rings = False
        self._wait = None

    def ring(self):
        """Let the task go on; other threads have the loop do it: loop.post(bell.ring)."""
        self._rings = True
        if self._wait is not None:
            self._wait.done()

    async def wait(self, seconds=None):
        """Wait until it rings, for at most `seconds`: whether it has."""
        if not self._rings and (seconds is None or seconds > 0):
            self._wait = Wait()
            timer = None if seconds is None else current().call_later(seconds, self._wait.done)
            try:
                await self._wait
            finally:
                self._wait = None
                if timer is not None:
                    timer.cancel()
        rang = self._rings
        self._rings = False
        return rang


async def pass_by(seconds):
    """Let some seconds pass, and say how far that is."""
    with notes.Work("s", round(seconds), even=False) as work:
        begun = now()
        while now() < begun + seconds:
            await sleep(min(SHOWN, begun + seconds - now()))
            work.reach(int(now() - begun))


async def ready(fd, events):
    """Wait until a poll finds one of the events, select.POLLIN or POLLOUT, or the end,
    at a file descriptor.
    """
    loop = current()
    wait = Wait()
    loop.watch(fd, events, wait.done)
    try:
        return await wait
    finally:
        loop.unwatch(fd)


async def on_thread(function, *args):
    """The result of a function that blocks, run on a thread; raises Shortage if no thread can be started.

    A cancelled task does not wait for it; the thread goes on, as nothing can end it.
    """
    return await begun_on_thread(function, *args)


def begun_on_thread(function, *args):
    """The Wait for the result of a function that a thread runs. Raises Shortage."""
    here = current()
    wait = Wait()
    if here.world is not real:  # which runs one thing at a time
        here.world.start_thread(_end_with, wait, function, args)
        return wait
    here.make_bell()
    try:
        thread = _Thread.idle.pop()
    except IndexError:
        thread = _Thread()
    thread.give((here, wait, function, args))
    return wait


def _outcome(function, args):
    """(what function(*args) returns, what it raises), one of them None."""
    try:
        return function(*args), None
    except BaseException as e:
        return None, e


def _end_with(wait, function, args):
    wait.end(*_outcome(function, args))


class _Thread:
    """Runs functions for `on_thread`, until none has come for SPARE seconds:
    to begin a thread takes 0.1 ms.
    """

    idle = []  # type: list

    def __init__(self):
        self._job = None  # type: tuple
        self._begin = allocate_lock()
        self._begin.acquire()
        real.start_thread(self._run)

    def give(self, job):
        """Let it run a function: (Loop, Wait for the result, function, its arguments)."""
        self._job = job
        self._begin.release()

    def _run(self):
        while self._has_job():
            here, wait, function, args = self._job
            self._job = None
            value, error = _outcome(function, args)
            self.idle.append(self)
            here.post(wait.end, value, error)
            del here, wait, function, args, value, error  # which take memory

    def _has_job(self):
        if self._begin.acquire(timeout=SPARE):
            return True
        try:
            self.idle.remove(self)
        except ValueError:  # somebody has taken it, and is about to give it a function
            return self._begin.acquire()
        return False


class Timer:
    """A function that is to be called at a time, see Loop.call_later."""

    __slots__ = ("when", "number", "function")

    def __init__(self, when, number, function):
        self.when = when
        self.number = number
        self.function = function

    def __lt__(self, other):
        return (self.when, self.number) < (other.when, other.number)

    def cancel(self):
        """Do not call it."""
        self.function = None


class Loop:
    """What runs on one thread; see `run`.

    ready     Tasks that can go on
    running   the Task that runs now
    before_waiting, at_end  functions that are called before the loop waits, to send at once what has
                            gathered, and at its end
    alone     function that waits a moment for the one busy descriptor, which saves a poll, or None. It is
              called while at most one timer runs
    idle      number of the watched descriptors at which nothing is expected then
    on_return  function(seconds), called when the loop was away for so long: that is no silence of a peer
    session   what `run` was given
    world     its clocks, network and threads, as in real.py
    now       its clock
    """

    def __init__(self, world):
        self.world = world
        self.now = world.now
        self.ready = deque()  # type: deque
        self.running = None
        self.before_waiting = []
        self.at_end = []
        self.on_return = None
        self.alone = None
        self.idle = 0
        self.session = None
        # what an ORB keeps: of the processes that it asks, and of its own objects
        self.peers = None
        self.server = None
        self._main = None  # type: Task
        self.is_closed = False
        self._timers = []
        self._timer_count = 0
        self._most_timers = FEW_TIMERS  # at which it is looked whether some are cancelled
        self._poll = world.poll()
        self._watched = {}
        self._posted = deque()  # type: deque  # functions from other threads
        self._bell = None  # the pipe that wakes the poll
        self._may_be_rung = world is not real  # other threads, or a simulation, may wake it
        self._back = world.now()  # when the last poll ended
        self._signals = {}
        self._heard = {}
        self._struck = deque()  # type: deque
        # (signal, exception) of the last _overrun, until it is known to be seen; else None
        self._raised = None  # type: tuple
        self._outer_bell = -1  # where Python rang at signals before
        self.is_guest = False
        self._last_strike = -BOUNCE
        self._is_ending = False  # whether the last signal was one that ends the process
        self._overdue = None  # what a signal raised that was not cleaned up after
        self._deadline = None  # the Timer for that

    # ---- for tasks ----

    def call_later(self, seconds, function):
        """Call function() in `seconds`; returns its Timer."""
        self._timer_count += 1
        timer = Timer(self.now() + seconds, self._timer_count, function)
        if len(self._timers) >= self._most_timers:
            self._drop_cancelled()
        heappush(self._timers, timer)
        return timer

    def _drop_cancelled(self):
        """Forget timers that are cancelled: what is awaited for hours, or for ever, may come often."""
        self._timers = [timer for timer in self._timers if timer.function is not None]
        heapify(self._timers)
        self._most_timers = 2 * len(self._timers) + FEW_TIMERS

    def watch(self, fd, events, function):
        """Call function() each time that a poll finds one of the events at a file descriptor."""
        self._poll.register(fd, events)
        self._watched[fd] = function

    def unwatch(self, fd):
        """Do not look at a file descriptor any more."""
        if self._watched.pop(fd, None) is not None and not self.is_closed:
            self._poll.unregister(fd)

    def post(self, function, *args):
        """Have the loop call function(*args); the one method that other threads may call."""
        self._posted.append((function, args))
        bell = self._bell
        if bell is not None:
            _ring(bell)

    def hear(self, number, function):
        """Call function() at a signal, on the main thread; None ends that.
        The handler of before comes back at the end.
        """
        if self.world is not real:
            self._heard[number] = function, None
            return
        if not _is_main_thread():
            return
        if number not in self._heard:
            self._take_wakeups()
            self._heard[number] = None, _signal.getsignal(number)
        _, before = self._heard[number]
        self._heard[number] = function, before
        _signal.signal(number, self._note if function is not None else before)

    # ---- running ----

    def complete(self, coroutine, signals):
        """Run the main task to its end."""
        main = self._main = Task(self, coroutine, None, None)
        handlers = self._take_signals(signals)
        try:
            self.run_until(lambda: main.is_over or self._overdue is not None)
        finally:
            self._return_signals(handlers)
        if self._overdue is not None:
            raise self._overdue
        if main.error is not None:
            raise main.error
        if self.is_guest:
            self._raise_struck()
        return main.result

    def run_until(self, is_over):
        """Let the tasks go on, and wait for what they await, until is_over()."""
        outer = current()
        _here.loop = self
        ready = self.ready
        try:
            while True:
                for _ in range(ROUNDS):
                    for _ in range(len(ready)):
                        task = self.running = ready.popleft()
                        task.go_on()
                    if not ready or is_over():
                        break
                self.running = None
                if is_over():
                    return
                for function in self.before_waiting:
                    function()
                self._wait()
        finally:
            self.running = None
            _here.loop = outer

    def _wait(self):
        begun = self.now()
        away = begun - self._back
        seconds = self._patience(begun)
        if seconds and self.alone is not None and self.is_one_awaited():
            events = []
            self.alone()
        else:
            events = self._poll.poll(seconds * 1000)
        self._back = self.now()
        away = max(away, self._back - begun - seconds)  # the process was busy, or stopped
        if away > AWAY and self.on_return is not None:
            self.on_return(away)
        for fd, _ in events:
            if fd in self._watched:  # else unwatched a moment ago
                self._watched[fd]()
        while self._posted:
            function, args = self._posted.popleft()
            function(*args)
        self._call_due(self._back)
        if self._raised is not None:
            self._strike_again()
        if self._struck:
            self._strike(self._struck.popleft())

    def is_one_awaited(self):
        """Whether nothing can come but at the one busy descriptor, or signals, which may wait for a
        moment.
        """
        count = len(self._watched)
        if self._bell is not None:
            count -= 1
        return count == self.idle + 1 and len(self._timers) < 2 and not self._may_be_rung

    def has_nothing_else(self):
        """Whether nothing is to be done but what the running task does."""
        if self.ready or self._posted or self._struck:
            return False
        return not self._timers or self._timers[0].when > self.now()

    def _patience(self, now):
        """Seconds that a poll may take."""
        if self.ready or self._posted or self._struck:
            return 0
        if not self._timers:
            return FOREVER
        return min(FOREVER, max(0, self._timers[0].when - now))

    def _call_due(self, now):
        while self._timers and self._timers[0].when <= now:
            function = heappop(self._timers).function
            if function is not None:
                function()

    def make_bell(self):
        """Have `post` wake the loop."""
        self._may_be_rung = True
        self._make_pipe()

    def strike(self, number):
        """A signal has come, in a world that is simulated."""
        self._struck.append(number)

    def _make_pipe(self):
        if self._bell is not None or self.world is not real:
            return
        self._readable, self._bell = os.pipe()
        for end in (self._readable, self._bell):
            os.set_blocking(end, False)
        self.watch(self._readable, READ, lambda: os.read(self._readable, 4096))

    def close(self):
        """Free what it holds."""
        self.is_closed = True
        for function in self.at_end:
            function()
        if self._bell is not None:
            bell = self._bell
            self._bell = None
            os.close(bell)
            os.close(self._readable)
        if isinstance(self._poll, real.Epoll):
            self._poll.close()

    # ---- signals ----

    def _take_signals(self, signals):
        """Have signals noted instead of raised; returns the handlers from before."""
        self._signals = signals
        if not signals or self.world is not real or not _is_main_thread():
            return {}
        self._take_wakeups()
        before = {number: _signal.getsignal(number) for number in signals}
        for number in signals:
            if before[number] != _signal.SIG_IGN:  # nohup ignores SIGHUP
                _signal.signal(number, self._note)
        return before

    def _take_wakeups(self):
        """Have signals end a poll: Python begins it again otherwise."""
        self._make_pipe()
        outer = _signal.set_wakeup_fd(self._bell)
        if outer != self._bell:
            self._outer_bell = outer

    def _return_signals(self, before):
        if self.world is not real:
            return
        for number, (_, handler) in self._heard.items():
            _signal.signal(number, handler)
        if not before and not self._heard:
            return
        if not self.is_guest:
            _signal.setitimer(_signal.ITIMER_REAL, 0)
        _signal.set_wakeup_fd(self._outer_bell)
        for number, handler in before.items():
            _signal.signal(number, handler)

    def _note(self, number, frame):
        self._struck.append(number)
        if self._outer_bell >= 0:
            _ring(self._outer_bell, bytes([number]))
        if self.running is not None and not self.is_guest:
            _signal.signal(_signal.SIGALRM, self._overrun)
            _signal.setitimer(_signal.ITIMER_REAL, PATIENCE)

    def _overrun(self, number, frame):
        """Raise what a signal raises here and now:
        the task that runs computes for long, or waits for who reads its output.
        """
        struck = [number for number in self._struck if number not in self._heard]
        if struck and self.running is not None:
            self._struck.clear()
            self._raised = struck[0], self._signals[struck[0]]()
            raise self._raised[1]

    def _strike_again(self):
        """Have a signal strike again if no task has seen what was raised for it: code in C drops that where
        it calls Python, in callbacks for example, and here and there during an import.
        """
        number, exception = self._raised
        self._raised = None
        traceback = exception.__traceback__  # None where no code in Python saw it, before 3.12
        if traceback is not None:
            outermost = traceback.tb_frame.f_code
            if outermost.co_flags & _COROUTINE or outermost is Task.go_on.__code__:
                return
        self._struck.append(number)

    def _strike(self, number):
        """Raise what a signal raises in the main task, unless it repeats the last one;
        the task has UNWINDING to clean up.
        """
        if number in self._heard:
            function, _ = self._heard[number]
            if function is not None:
                function()
            return
        exception = self._signals[number]()
        now = self.now()
        pause = UNWINDING if self._is_ending else BOUNCE
        if exception is None or now - self._last_strike < pause:
            return
        self._last_strike = now
        self._is_ending = not isinstance(exception, KeyboardInterrupt)
        self._main.throw(exception)
        if self._deadline is not None:
            self._deadline.cancel()
        self._deadline = self.call_later(UNWINDING, lambda: self._end_with(exception))

    def _raise_struck(self):
        """Raise what signals raise that have come at the very end."""
        for number in self._struck:
            exception = self._signals[number]()
            if exception is not None:
                raise exception

    def allow_more(self):
        """What cleans up after a signal goes on: it has UNWINDING again."""
        if self._deadline is not None and self._deadline.function is not None:
            function = self._deadline.function
            self._deadline.cancel()
            self._deadline = self.call_later(UNWINDING, function)

    def _end_with(self, exception):
        self._overdue = exception


def _ring(bell, octet=b"\0"):
    try:
        os.write(bell, octet)
    except OSError:  # full: it rings already; or closed
        pass


def _is_main_thread():
    threading = sys.modules.get("threading")  # where nobody has imported it, there is one thread
    return threading is None or threading.current_thread() is threading.main_thread()
