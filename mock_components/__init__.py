"""Mock RT Components: real CORBA servants that answer as OpenRTM-aist does, for tests and for trying commands.

`python3 -m mock_components --list` shows the worlds that can be started; `world("two")`, in a `with` statement, starts one in a
test of your own.
"""
from .running import World, world  # noqa: F401
