"""Functions that make several remote calls, in a form that lets one thread have many of them under way.

    @tasks.task
    async def states(node):
        return [await state.task(node, ref) for ref in await refs.task(node)]

`states(node)` runs it and waits for each answer on this thread; `await states.task(node)` is for use inside another. What they await
in the end, an orb.Call or a Sleep, has a method `wait()`, which a thread calls. An ORB that needs no threads knows other ways.
"""
import functools
import time

from rtshell_lite import interrupts


def task(function):
    """Decorates an `async def` function: called, it blocks and returns its value; its attribute `task` makes the coroutine."""
    @functools.wraps(function)
    def blocking(*args, **more):
        return run(function(*args, **more))
    blocking.task = function
    return blocking


def of(function):
    """The function that makes coroutines for a decorated one, or a functools.partial of one; None for others."""
    if isinstance(function, functools.partial):
        made = of(function.func)
        return made and functools.partial(made, *function.args, **function.keywords)
    return getattr(function, "task", None)


def run(coroutine):
    """Run a coroutine to its end on this thread: its value, or what it raises."""
    value = error = None
    try:
        while True:
            awaited = coroutine.send(value) if error is None else coroutine.throw(error)
            value = error = None
            try:
                value = awaited.wait()
            except BaseException as e:  # Ctrl-C, too: its `finally` clauses are to see it
                error = e
                interrupts.arrived()  # what the coroutine does with it may take long
    except StopIteration as end:
        return end.value


class Sleep:
    """`await Sleep(seconds)` lets others go on meanwhile."""

    def __init__(self, seconds):
        self.seconds = seconds

    def __await__(self):
        yield self

    def wait(self):
        """Sleep on this thread."""
        time.sleep(self.seconds)


async def plain(function, *args):
    """A function that blocks, for what awaits a task."""
    return function(*args)
