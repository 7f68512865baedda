"""Which connections rtkeep mends: if these fail, it leaves one of which one end is gone as it is."""
import types
import unittest
from unittest import mock

from rtshell_lite.net import loop
from rtshell_lite.system import reconnect


class Halves(unittest.TestCase):
    def test_what_is_half_there_is_looked_at_from_both_ends_and_then_removed(self):
        looked_at = []
        kept = {
            end: types.SimpleNamespace(
                is_there=True, change=lambda part, end=end: looked_at.append((end, part))
            )
            for end in ("out", "in")
        }
        connector = types.SimpleNamespace(ends=("out", "in"))
        step = types.SimpleNamespace(kind="disconnect", connector=connector)
        outcome = types.SimpleNamespace(step=step)

        async def found(steps):
            return [outcome]

        connections = reconnect.Connections(None, None, kept.get)
        with mock.patch.object(reconnect.connect_steps, "connecting"), \
                mock.patch.object(reconnect.restore, "connections", found):
            self.assertEqual(loop.run(connections.outcomes([connector])), [])
            self.assertEqual(looked_at, [("out", "ports"), ("in", "ports")])
            self.assertEqual(loop.run(connections.outcomes([connector])), [outcome])


if __name__ == "__main__":
    unittest.main()
