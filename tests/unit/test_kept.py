"""When rtkeep looks at a component again that does not answer as it waits for a neighbour that hangs: each
such question holds a thread of its process. If this fails, rtkeep takes all threads of healthy processes.
"""
import types
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.net import loop
from rtshell_lite.path import parse
from rtshell_lite.system import keep, kept, policy


class Waiting(unittest.TestCase):
    def setUp(self):
        self.bell_rang = []
        self.error = errors.Silent("x", "no answer")
        component = types.SimpleNamespace(property=lambda name: "")
        path = parse("/a:1/x.rtc")
        placement = types.SimpleNamespace(path=path, where=str(path), component=component, error=None)

        async def ask(component):
            """It lives."""

        self.neighbour = mock.Mock(where="/a:1/y.rtc", is_hung=True)
        self.keeper = types.SimpleNamespace(
            options=types.SimpleNamespace(policy=policy.USUAL), ask=ask, complain=lambda *_: None,
            _connections=types.SimpleNamespace(of=lambda those: [("it", {self.neighbour})]),
            bell=types.SimpleNamespace(ring=lambda: self.bell_rang.append(True)),
        )
        self.component = kept.KeptComponent(placement, self.keeper)
        self.component.shown = types.SimpleNamespace(node=types.SimpleNamespace(endpoint=("a", 2)))

    def run_in_loop(self, function):
        async def main():
            return await function()
        return loop.run(main(), session=session.Session(1.0))

    async def pauses(self):
        """For how long it is not looked at after each of some looks in vain."""
        found = []
        for _ in range(4):
            await keep.Keeper._not_shown(self.keeper, self.component, self.error)
            found.append(self.component.due - loop.now())
        return found

    def test_it_is_looked_at_ever_later(self):
        pauses = self.run_in_loop(self.pauses)
        for pause, least in zip(pauses, (4, 8, 16, 32)):
            self.assertAlmostEqual(pause, least, delta=1)

    def test_it_may_hang_for_days(self):
        async def main():
            for _ in range(5000):
                self.component.hold_up(4.0)
            return self.component.due - loop.now()
        self.assertAlmostEqual(self.run_in_loop(main), 300, delta=1)

    def test_it_is_looked_at_however_often_it_changes(self):
        dues = []
        for now in 100.0, 100.95:
            with mock.patch.object(loop, "now", lambda: now):
                self.component.change(kept.STATE)
            dues.append(self.component.due - 100)
        for due, expected in zip(dues, (kept.PAUSE, kept.WAIT)):
            self.assertAlmostEqual(due, expected)

    def test_it_is_looked_at_soon_where_nothing_hangs(self):
        self.neighbour.is_hung = False
        self.error = errors.NotAsked("x", "not asked")
        for pause in self.run_in_loop(self.pauses):
            self.assertAlmostEqual(pause, keep.WAIT, delta=0.5)

    def test_it_is_looked_at_soon_at_first_where_nothing_is_seen_to_hang(self):
        self.neighbour.is_hung = False  # but a firewall may be between it and the component
        for pause, least in zip(self.run_in_loop(self.pauses), (1, 2, 4, 8)):
            self.assertAlmostEqual(pause, least * keep.WAIT, delta=0.5)

    def test_a_question_about_its_ports_that_fails_meanwhile_changes_nothing(self):
        async def main():
            await self.pauses()
            self.component.patience.wait()
            self.component.wait_no_more()
            return self.component.due - loop.now()
        self.assertLessEqual(self.run_in_loop(main), 0)

    def test_another_object_of_that_name_is_looked_at_at_once(self):
        async def main():
            await self.pauses()
            self.component.release()
            return await self.pauses()
        self.assertAlmostEqual(self.run_in_loop(main)[0], 4, delta=1)

    def test_and_at_once_when_what_held_it_up_may_be_over(self):
        async def main():
            await self.pauses()
            self.component.wait_no_more()
            return self.component.due - loop.now()
        self.assertLessEqual(self.run_in_loop(main), 0)
        self.assertTrue(self.bell_rang)


class Connections(unittest.TestCase):
    def test_ports_are_asked_where_they_have_connections_which_either_end_may_lose(self):
        asks = kept.KeptComponent.asks_port
        connected, idle = [types.SimpleNamespace(connections=each) for each in ({"it": ()}, {})]
        component = types.SimpleNamespace(is_given_up=False)
        self.assertTrue(asks(component, connected))
        self.assertFalse(asks(component, idle))
        component.is_given_up = True
        self.assertTrue(asks(component, idle))


if __name__ == "__main__":
    unittest.main()
