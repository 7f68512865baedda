"""Where a bug in a task of a mount is caught, as in server.py:
it must not end the mount, nor leave others waiting.
"""


async def attempt(coroutine):
    """(what a coroutine returns, None), or (None, the exception that it raises)."""
    try:
        return await coroutine, None
    except Exception as e:
        return None, e
