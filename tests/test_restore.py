"""Restoring whole systems: if this fails, a saved robot does not come back as it was, or a report on it cannot be trusted."""
import os
import random
import unittest

import mocks
from mock_components import control
from rtshell_lite import apply, configuration, errors, execution, orb, organisation, path, ports, restore, rpc, system, tree, xmlprofile
from rtshell_lite.xmlprofile import model

WORDS = ["x", "two words", "日本", "a=b", "<&>\"'", "-5", "\\x20", "$(false)", "tab\there", "\udcff", "; rm"]
NOTHING = restore.Options([], False, None, False)
SECONDS = 1.0  # how long a mock may stay silent


def setUpModule():
    if mocks.omniORB is not None:
        rpc.timeout = SECONDS
        orb.start()  # with our settings: the second to ask for an ORB gets the first one's
    mocks.start_name_server()


def tearDownModule():
    mocks.Server.stop()


def where(name, port=None):
    return path.parse("/127.0.0.1:%d/test.host_cxt/%s.rtc" % (mocks.Server.port, name) + (":" + port if port else ""))


def node(name):
    return tree.component(where(name))


def connect(*ends, **more):
    return ports.connect(ports.find([where(*end.split(":", 1)) for end in ends]), **more)


def capture():
    """The profile of all that runs, with no faults in the way."""
    rpc.silent.clear()
    found = system.capture([path.parse("/127.0.0.1:%d" % mocks.Server.port)], all_components=True)
    assert not found.failures, found.failures
    return found.profile


def restored(profile, all_or_nothing=False):
    rpc.silent.clear()
    outcomes = restore.restoring(profile, NOTHING)
    apply.carry_out(outcomes, all_or_nothing)
    return outcomes


def torn_down(profile):
    rpc.silent.clear()
    outcomes, _ = restore.tearing_down(profile, NOTHING)
    apply.carry_out(outcomes)
    return outcomes


def statuses(outcomes):
    return {each.status for each in outcomes}


def told(outcomes):
    return "\n".join("%s: %s %s" % (each.step.title, each.status, each.error or "") for each in outcomes)


class Worlds(unittest.TestCase):
    def start(self, *words):
        world = mocks.World(*words)
        self.addCleanup(world.close)
        return world

    def ctl(self, world, *words):
        ok, text = control.request(world.control, words)
        self.assertTrue(ok, text)
        return text


# ---- what is saved comes back ---------------------------------------------------------------------------------

class Everything(Worlds):
    def make(self, dice):
        """A system at random: connections of all kinds, values in all sets, rates, members."""
        mock_names = ["Mock%d" % number for number in range(6)]
        for number in range(dice.randrange(3, 8)):
            ends = [dice.choice(mock_names) + ":out"] + [name + ":in" for name in dice.sample(mock_names, dice.choice([1, 1, 2, 3]))]
            properties = {dice.choice(WORDS): dice.choice(WORDS) for _ in range(dice.randrange(3))}
            try:
                connect(*ends, name=dice.choice(WORDS + [""]), given=properties,
                        connector_id=dice.choice(["", "id %d %s" % (number, dice.choice(WORDS))]))
            except errors.Refused:
                pass  # connected already
        connect("MyServiceConsumer0:MyService", "MyServiceProvider0:MyService")
        if dice.random() < 0.5:
            connect("composite0:Motor0.out", "Mock0:in")
        self.change(dice)

    def change(self, dice):
        for name in ("ConfigSample0", "ConfigSample1", "Motor0"):
            found = configuration.Configuration(node(name))
            for one in found.sets(with_hidden=True):
                values = {key: dice.choice(WORDS) for key in one.values if key.startswith("str_") and dice.random() < 0.6}
                if values:
                    found.store(values, one)
        configuration.Configuration(node("ConfigSample0")).activate(dice.choice(["default", "mode0", "mode1"]))
        for name in ("Mock0", "ConfigSample1", "composite0"):
            execution.set_rate(node(name), 0, dice.choice([1000.0, 500.0, 250.0]))

    def leave(self, name):
        composite = node("composite0")
        member = organisation.Member(name, node(name), [])
        organisation.remove(composite, organisation.the_one(composite), [member])

    def test_saved_torn_down_restored_and_saved_again_is_the_same(self):
        for seed in range(int(os.environ.get("SEEDS", 3))):
            with self.subTest(seed=seed):
                self.round(random.Random(seed), reboot=seed % 2)

    def round(self, dice, reboot):
        away = ["Mock:Mock%d" % number for number in (3, 4, 5)] + ["MyServiceConsumer", "ConfigSample:ConfigSample1"]
        here = mocks.World(*["these"] + ["Mock:Mock%d" % number for number in range(3)] + ["MyServiceProvider", "ConfigSample"])
        self.addCleanup(here.close)
        there, third = mocks.World("these", *away), mocks.World("composite")
        self.addCleanup(third.close)
        try:
            self.make(dice)
            saved = capture()
            self.assertEqual(statuses(restored(saved)), {"already so"})
            if not reboot or dice.random() < 0.5:
                self.assertLessEqual(statuses(torn_down(saved)), {"done"})
                self.assertEqual([c for c in capture().data_port_connectors + capture().service_port_connectors], [])
            if reboot:
                there.close()
                there = mocks.World("these", *away)
            self.change(dice)
            self.leave(dice.choice(["Motor0", "Sensor0"]))
            for form in (xmlprofile.XML, xmlprofile.YAML):  # through a file, as users do
                saved = xmlprofile.load(xmlprofile.dump(saved, form), "", form)
            outcomes = restored(saved)
            self.assertLessEqual(statuses(outcomes), {"already so", "done"}, told(outcomes))
            self.assertEqual(without_dates(capture()), without_dates(saved))
            self.assertEqual(statuses(restored(saved)), {"already so"})
        finally:
            for world in (here, there, third):
                world.close()


def without_dates(profile):
    return [model.RtsProfile(components=profile.components, data_port_connectors=profile.data_port_connectors,
                             service_port_connectors=profile.service_port_connectors)]


if __name__ == "__main__":
    unittest.main()
