"""How often what fails is tried again, and Procfiles: if this fails, a robot is restarted too often, or not
at all.
"""
import os
import signal
import socket
import tempfile
import unittest
from unittest import mock

from rtshell_lite import errors
from rtshell_lite.net import loop
from rtshell_lite.system import policy, procfile, steering
from rtshell_lite.xmlprofile import model

ONCE = "arithmetic is the same on all Pythons"


class Words(unittest.TestCase):
    def test_words(self):
        self.assertEqual(policy.parse(), policy.USUAL)
        self.assertEqual(policy.parse("no", "3/10", "1-8"), policy.Policy("no", 3, 10.0, 1.0, 8.0))
        for words in ({"restart": (
            "never"
        )}, {"burst": "5"}, {"burst": "0/5"}, {"burst": "a/b"}, {"delay": "1"}, {"delay": "1-x"},
                      {"delay": "1-nan"}, {"burst": "5/1e9"}):
            with self.subTest(words), self.assertRaisesRegex(ValueError, "^%s: not" % list(words)[0]):
                policy.parse(**words)

    def test_properties_of_a_component_go_first(self):
        def component(**properties):
            return model.Component(id="", path_uri="localhost/A0.rtc", instance_name="A0", properties=[
                model.Property(name="keep." + name, value=value) for name, value in properties.items()])
        usual = policy.parse("on-error", "9/90")
        self.assertEqual(policy.of(component(), usual), usual)
        self.assertEqual(policy.of(component(restart="no"), usual), usual._replace(restart="no"))
        with self.assertRaisesRegex(errors.Failed, "A0.rtc: its property keep.burst: not NUMBER/SECONDS"):
            policy.of(component(burst="x"), usual)


class Trials(unittest.TestCase):
    def setUp(self):
        self.now = 1000.0
        patch = mock.patch.object(loop, "now", lambda: self.now)
        patch.start()
        self.addCleanup(patch.stop)

    def test_the_first_at_once_then_twice_as_long_each_time(self):
        trial = policy.Trial(policy.parse(burst="100/60", delay="0.5-4"))
        delays = []
        for _ in range(6):
            trial.fail()
            delays.append(trial.until - self.now)
            self.now = trial.until
        self.assertEqual(delays[0], 0)
        for delay, least in zip(delays[1:], (0.5, 1, 2, 4, 4)):
            self.assertTrue(least <= delay <= least * 1.25, delays)

    def test_too_many_within_the_time_are_given_up(self):
        trial = policy.Trial(policy.parse(burst="2/10"))
        for wait, is_given_up in ((0, False), (6, False), (6, False), (1, True)):
            self.now += wait
            trial.fail()
            self.assertEqual(trial.given_up, is_given_up)
        trial.begin_again()
        self.assertEqual((trial.given_up, trial.until), (False, 0))

    def test_a_minute_of_health_and_all_is_forgotten(self):
        trial = policy.Trial(policy.parse(burst="2/600"))
        trial.fail()
        trial.fail()
        self.now += policy.HEALTH + 1
        trial.fail()
        self.assertEqual((trial.given_up, trial.until), (False, self.now))


class Procfiles(unittest.TestCase):
    def read(self, text):
        with tempfile.NamedTemporaryFile("w") as file:
            file.write(text)
            file.flush()
            return procfile.read(file.name, policy.USUAL)

    def test_all_keys(self):
        with mock.patch.dict(os.environ, PLACE="/here"):
            two, one = self.read("# comment\n\none: run 'two words' $PLACE/x\none.after: two\none.ready: "
                                 "localhost/A0.rtc\none.env: A=1 'B=x y'\none.cwd: /tmp\none.stop: INT "
                                 "2.5\none.restart: no\none.burst: 1/2\none.delay: 3-4\ntwo: true\n")
        self.assertEqual(one.command, ["run", "two words", "/here/x"])
        self.assertEqual((one.after, one.env, one.cwd), (["two"], {"A": "1", "B": "x y"}, "/tmp"))
        self.assertEqual(one.stop, (signal.SIGINT, 2.5))
        self.assertEqual(one.policy, policy.Policy("no", 1, 2.0, 3.0, 4.0))
        self.assertEqual((two.name, two.after, two.ready, two.stop[0]), ("two", [], None, signal.SIGTERM))

    def test_mistakes_are_named(self):
        for text, said in (
            ("x", ":1: not NAME"),
            ("a: b\na.after: c", "a: after c"),
            ("a: b\na.after: a", "wait for each other: a"),
            ("a: 'b", "a: No closing quotation"),
            ("a: b\na.stop: NOW", "no such signal: NOW"),
            ("a: b\na.stop: INT soon", "a: stop: not SIGNAL SECONDS: INT soon"),
            ("a: b\na.restart: x", "a: restart: not one of"),
            ("a.cwd: /", "a: no command"),
            ("a: b\na.env: C", "a: "),
        ):
            with self.subTest(text), self.assertRaisesRegex(errors.Failed, said):
                self.read(text)


class Steering(unittest.TestCase):
    def test_one_that_ends_while_it_is_asked(self):
        with tempfile.TemporaryDirectory() as here, mock.patch.dict(os.environ, XDG_RUNTIME_DIR=here):
            door = os.path.join(steering.directory(), "robot.socket")
            with socket.socket(socket.AF_UNIX) as listening:
                listening.bind(door)
                listening.listen(1)
                listening.setblocking(False)
                loop.run(self._ask(door, listening))

    async def _ask(self, door, listening):
        async def end():
            await loop.ready(listening.fileno(), loop.READ)
            listening.accept()[0].close()  # the request is not read

        async with loop.background(end()):
            with self.assertRaises(errors.ConnectionRefused):
                await steering.ask(door, {"command": "status", "names": []})
        async with loop.background(end()):
            self.assertEqual(await steering.marks(), {})


if __name__ == "__main__":
    unittest.main()
