"""Mock RT Components: real CORBA servants that answer as OpenRTM-aist does, for tests and for trying
commands.

`python3 -m mock_components --list` shows the worlds that can be started; `world("two")`, in a `with`
statement, starts one in a test of your own.
"""


def world(name, *arguments):
    """A running.World of that name, in a `with` statement: see running.world."""
    from . import running  # here, as a mock's own process needs nothing of what that imports
    return running.world(name, *arguments)
