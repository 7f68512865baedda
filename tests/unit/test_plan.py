"""Plans of starting and stopping, without components: if this fails, systems start in another order than
their files say.
"""
import heapq
import os
import random
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))

from rtshell_lite import errors  # noqa: E402
from rtshell_lite.system import capture, plan  # noqa: E402
from rtshell_lite.system.outcomes import ALREADY, DONE, FAILED, GONE, UNCERTAIN  # noqa: E402
from rtshell_lite.xmlprofile import model  # noqa: E402


def component(name, required=True, contexts=("0",), members=(), type_name="T"):
    return model.Component(
        id="RTC:A:b:%s:1" % type_name,
        path_uri="h/%s.rtc" % name,
        instance_name=name,
        is_required=required,
        execution_contexts=[model.ExecutionContext(id=context) for context in contexts],
        participants=[
            model.Participant(
                component=model.TargetComponent(component_id="RTC:A:b:T:1", instance_name=member)
            )
            for member in members
        ],
    )


def target(name, context="0", **more):
    return model.TargetExecutionContext(component_id="RTC:A:b:T:1", instance_name=name, id=context, **more)


def order(name, sequence=1, context="0", **more):
    return model.Condition(sequence=sequence, target=target(name, context), **more)


def wait(name, milliseconds, sequence=1):
    return order(name, sequence, wait_time=model.WaitTime(wait_time=milliseconds))


def after(name, *others, sequence=1, sync=False, timeout=0, **more):
    preceding = model.Preceding(timeout=timeout, sending_timing="SYNC" if sync else "",
                                preceding_components=[target(other) for other in others])
    return order(name, sequence, preceding=preceding, **more)


def profile(components, *conditions):
    components = [each if isinstance(each, model.Component) else component(each) for each in components]
    return model.RtsProfile(components=components, activation=model.MessageSending(targets=list(conditions)),
                            deactivation=model.MessageSending(targets=list(conditions)))


def make(components, *conditions, start=True):
    return plan.make(profile(components, *conditions), "activation", "a.xml", start)


class Making(unittest.TestCase):
    def lines(self, *args, **more):
        return plan.lines(make(*args, **more).actions, "Activate")

    def refused(self, message, *args):
        with self.assertRaises(errors.Failed) as caught:
            make(*args)
        self.assertEqual(str(caught.exception), "a.xml: Activation: " + message)

    def test_without_conditions(self):
        self.assertEqual(
            plan.lines(plan.make(model.RtsProfile(), "activation", "a.xml").actions, "Activate"), [""]
        )
        two = [component("A", False), component("B", contexts=("0", "1")), component("C", contexts=())]
        bare = model.RtsProfile(components=two)
        self.assertEqual(plan.lines(plan.make(bare, "activation", "a.xml").actions, "Activate"), [
            "{1} Activate /h/B.rtc in execution context 0 (Required)",
            "{2} Activate /h/B.rtc in execution context 1 (Required)",
            "{3} Activate /h/C.rtc in execution context 0 (Required)",
            "{4} Activate /h/A.rtc in execution context 0"])
        self.assertEqual(plan.lines(plan.make(bare, "deactivation", "a.xml", False).actions, "Deactivate"), [
            "{1} Deactivate /h/A.rtc in execution context 0",
            "{2} Deactivate /h/B.rtc in execution context 0",
            "{3} Deactivate /h/B.rtc in execution context 1",
            "{4} Deactivate /h/C.rtc in execution context 0"])
        self.assertEqual(
            plan.checks(bare),
            [
                'Check for required component "RTC:A:b:T:1", "%s" at path /h/%s.rtc (Required)' % (name, name)
                for name in "BC"
            ],
        )

    def test_form_of_conditions(self):
        self.assertEqual(
            self.lines(
                "ABCDE",
                after("A", "B", sequence=3, sync=True),
                after("A", "C", sequence=3),
                wait("B", 500, 2),
                order("D", 7),
                after("E", sequence=8),
            ),
            [
                "{3} Activate /h/C.rtc in execution context 0 (Required)",
                "{4} [Order 7] Activate /h/D.rtc in execution context 0 (Required)",
                "{5} [Order 8] Activate /h/E.rtc in execution context 0 (Required)",
                "{2} [Order 2/Wait 500ms] Activate /h/B.rtc in execution context 0 (Required)",
                "{1} [Order 3/Sync to B, Order 3/After C's action] Activate /h/A.rtc in execution context 0 "
                "(Required)",
            ],
        )

    def test_a_composite_before_its_members(self):
        lines = self.lines([component("A"), component("C", members=["A"]), component("B")])
        self.assertEqual([line[:3] for line in lines], ["{2}", "{3}", "{1}"])

    def test_a_target_without_context_is_all_contexts(self):
        lines = self.lines([component("A", contexts=("0", "1")), "B"], order("A", 4, context=""))
        self.assertEqual([line[:3] for line in lines if "Order 4" in line], ["{1}", "{2}"])

    def test_names_of_contexts_and_targets(self):
        lines = self.lines(
            [component("A", contexts=("Ec1", ""))], order("A", 4, context="Ec1"), order("A", 5, context="1")
        )
        self.assertEqual([line.split(" Activate")[0] for line in lines], ["{1} [Order 4]", "{2} [Order 5]"])

    def test_the_property_tells_which(self):
        twins = [component("A"), component("A")]
        twins[1].path_uri = "other/A.rtc"
        self.refused("A (RTC:A:b:T:1) may be /h/A.rtc or /other/A.rtc (the property COMPONENT_PATH_ID "
                     "decides)",
                     twins, order("A"))
        condition = order("A")
        condition.target.properties = [model.Property(name=capture.PATH_ID, value="other/A.rtc")]
        self.assertEqual([bool(action.texts) for action in make(twins, condition).actions], [False, True])

    def test_absent_components_and_contexts_are_refused(self):
        self.refused("Ghost (RTC:A:b:T:1) is not in the file; /h/A.rtc has no execution context 7 in the "
                     "file",
                     "AB", after("A", "Ghost"), order("Ghost"), order("A", context="7"))

    def test_contradictions(self):
        self.refused(
            "/h/A.rtc in execution context 0: Order 1 contradicts Order 2", "A", order("A", 2), order("A", 1)
        )
        self.refused(
            "/h/A.rtc in execution context 0: Wait 1ms contradicts Wait 2ms", "A", wait("A", 2), wait("A", 1)
        )
        self.refused("/h/A.rtc in execution context 0: After B's action within 0ms contradicts "
                     "Sync to B within 5ms", "AB",
                     after("A", "B"), after("A", "B", sync=True, timeout=5))
        self.refused("/h/A.rtc in execution context 0: -2ms is not a time; /h/B.rtc in execution context 0: "
                     "-1ms is not a time",
                     "AB", wait("A", -2), after("B", "A", timeout=-1))

    def test_said_twice(self):
        made = make("AB", order("A", 2), order("A", 2), after("B", "A"), after("B", "A"))
        self.assertEqual(made.notes, ["/h/A.rtc in execution context 0 has a condition twice: Order 2",
                                      "/h/B.rtc in execution context 0 has a condition twice: Order "
                                      "1/After A's action"])
        self.assertEqual(
            [action.texts for action in made.actions], [("Order 2",), ("Order 1/After A's action",)]
        )

    def test_required_after_optional(self):
        made = make(["A", component("B", False)], after("A", "B"))
        self.assertEqual(made.notes, ['action {1} depends on an optional action: "After B\'s action"'])
        self.assertEqual(make(["A", component("B", False)], after("A", "B"), start=False).notes, [])

    def test_circles(self):
        self.refused("these wait for each other: /h/A.rtc for /h/A.rtc", "A", after("A", "A"))
        self.refused(
            "these wait for each other: /h/A.rtc for /h/B.rtc for /h/A.rtc; "
            "these wait for each other: /h/D.rtc for /h/E.rtc for /h/D.rtc",
            "ABCDEF",
            after("A", "B"),
            after("B", "A"),
            after("C", "A"),
            after("D", "E"),
            after("E", "D", sync=True),
            after("A", "F"),
        )

    def test_a_long_chain(self):
        names = ["C%d" % number for number in range(3000)]
        made = make(names, *[after(name, other) for name, other in zip(names[1:], names)])
        self.assertEqual(len(made.actions), 3000)
        with self.assertRaises(errors.Failed):
            make(
                names,
                after(names[0], names[-1]),
                *[after(name, other) for name, other in zip(names[1:], names)]
            )

    def test_random_circles(self):
        for seed in range(300):
            rng = random.Random(seed)
            names = ["C%d" % number for number in range(rng.randint(1, 8))]
            edges = {(rng.choice(names), rng.choice(names)) for _ in range(rng.randint(0, 9))}
            conditions = [after(name, other, sync=rng.random() < 0.5) for name, other in sorted(edges)]
            reached = set(edges)
            for middle in names:
                reached |= {
                    (a, b) for a in names for b in names if (a, middle) in reached and (middle, b) in reached
                }
            if not any((name, name) in reached for name in names):
                make(names, *conditions)
                continue
            with self.assertRaises(errors.Failed, msg=str(seed)) as caught:
                make(names, *conditions)
            for part in str(caught.exception).split("these wait for each other: ")[1:]:
                way = [word[3:-4] for word in part.rstrip("; ").split(" for ")]
                self.assertEqual(way[0], way[-1])
                self.assertLessEqual(set(zip(way, way[1:])), edges, seed)


class World:
    """Simulated components for a Schedule; `fate` is {name: (seconds until the result, result)}."""

    def __init__(self, actions, fate):
        self.schedule = plan.Schedule(actions, "Active")
        self.fate = fate
        self.now = 0.0
        # times by name, and reasons of what did not happen
        self.accepted = {}
        self.ended = {}
        self.started = {}
        self.reasons = {}

    def run(self):
        happening = []
        while not self.schedule.is_over():
            for action, reason in self.schedule.due(self.now):
                name = action.component.instance_name
                if reason is not None:
                    self.reasons[name] = reason
                    self.ended[name] = self.now
                    continue
                assert name not in self.started
                self.started[name] = self.now
                seconds, outcome = self.fate.get(name, (0.1, DONE))
                if outcome in (DONE, UNCERTAIN):
                    heapq.heappush(happening, (self.now + seconds / 2, 0, action.number, None))
                heapq.heappush(happening, (self.now + seconds, 1, action.number, outcome))
            if self.schedule.is_over():
                break
            times = [self.schedule.next_time(self.now)] + [event[0] for event in happening[:1]]
            times = [time for time in times if time is not None]
            assert times, "nothing will ever happen"
            assert min(times) >= self.now
            self.now = min(times)
            while happening and happening[0][0] <= self.now:
                _, _, number, outcome = heapq.heappop(happening)
                name = self.schedule.actions[number].component.instance_name
                if outcome is None:
                    self.accepted[name] = self.now
                    self.schedule.accepted(number)
                else:
                    self.ended[name] = self.now
                    self.schedule.end(number, outcome)
        return self


def play(components, *conditions, start=True, **fate):
    return World(make(components, *conditions, start=start).actions, fate).run()


class Playing(unittest.TestCase):
    def test_all_at_once(self):
        self.assertEqual(play("ABC").started, {"A": 0, "B": 0, "C": 0})

    def test_in_order(self):
        world = play(
            "ABCD", order("A", 5), order("B", 2), order("C", 2), B=(1, DONE), C=(2, ALREADY)
        )
        self.assertEqual(world.started, {"D": 0, "B": 0.1, "C": 0.1, "A": 2.1})

    def test_the_clock_starts_for_those_that_wait(self):
        world = play(
            "ABCDE",
            order("A", 9),
            wait("B", 500),
            after("C", "A"),
            after("D", "B", sync=True),
            after("E", "B"),
            B=(1, DONE),
        )
        self.assertEqual(world.started, {"A": 0, "C": 0.1, "B": 0.6, "E": 1.1, "D": 1.6})

    def test_both_conditions(self):
        world = play(
            "ABC", wait("A", 300), after("A", "B", sync=True), wait("C", 300), after("C", "B", sync=True)
        )
        self.assertEqual(world.started, {"B": 0, "A": 0.4, "C": 0.4})

    def test_timeouts(self):
        world = play(
            "ABCDE",
            wait("B", 1000),
            after("A", "B", sync=True, timeout=1500),
            after("C", "B", timeout=999),
            after("D", "C"),
            after("E", "B", timeout=1600),
            B=(1, DONE),
        )
        self.assertEqual(world.reasons, {"A": "Sync to B: not Active within 1500ms",
                                         "C": "After B's action: not accepted within 999ms",
                                         "D": "it waits for /h/C.rtc, which was not tried"})
        self.assertEqual(world.ended["D"], 0.999)
        world = play(
            "ABC", wait("A", 1599), wait("C", 1), after("B", "C", sync=True, timeout=1600), C=(2, DONE)
        )
        self.assertEqual(world.ended["B"], 1.6)  # and not when A is due, shortly before

    def test_a_failure_stops_what_depends_on_it(self):
        failed = (0.1, FAILED)
        world = play(
            "ABCDEF",
            order("A", 1),
            order("B", 2),
            after("C", "B"),
            wait("D", 10, 1),
            wait("E", 10, 2),
            A=failed,
        )
        self.assertEqual(world.reasons, {"B": "it comes after /h/A.rtc, which failed",
                                         "C": "it waits for /h/B.rtc, which was not tried",
                                         "E": "it comes after /h/A.rtc, which failed"})
        self.assertEqual(sorted(world.started), ["A", "D", "F"])
        world = play("ABCD", order("B"), after("C", "A"), after("D", "A", sync=True), A=failed)
        self.assertEqual(sorted(world.reasons), ["C", "D"])

    def test_a_failure_of_an_optional_one_stops_what_is_in_sync(self):
        failed = (0.1, FAILED)
        components = [component("A", False), "B", "C", "D"]
        conditions = order("A", 1), order("B", 2), after("C", "A", sequence=3), after("D", "A", sync=True)
        world = play(components, *conditions, A=failed)
        self.assertEqual(world.reasons, {"D": "it waits for /h/A.rtc, which failed"})

    def test_stopping_goes_on(self):
        conditions = order("A", 1), order("B", 2), after("C", "A", sequence=3), after("D", "A", sync=True)
        world = play("ABCD", *conditions, start=False, A=(0.1, FAILED))
        self.assertEqual(world.reasons, {"D": "it waits for /h/A.rtc, which failed"})
        self.assertEqual(play("ABCD", *conditions, start=False, A=(0.1, GONE)).reasons, {})

    def test_random_plans(self):
        for seed in range(600):
            Random(self, seed).check()


class Random:
    """A random plan without circles, and what must hold when it is carried out."""

    def __init__(self, case, seed):
        self.case = case
        rng = random.Random(seed)
        names = ["C%d" % number for number in range(rng.randint(1, 10))]
        self.required = {name: rng.random() < 0.7 for name in names}
        self.order = {}
        self.wait = {}
        self.after = {}
        conditions = []
        for number, name in enumerate(names):
            kind = rng.choice(["", "order", "wait", "after", "both"])
            if kind:
                self.order[name] = rng.randint(0, 3)
            if kind == "order":
                conditions.append(order(name, self.order[name]))
            if kind in ("wait", "both"):
                self.wait[name] = rng.choice([0, 100, 700])
                conditions.append(wait(name, self.wait[name], self.order[name]))
            others = names[:number] if kind in ("after", "both") else []
            for other in rng.sample(others, min(len(others), 2)):
                # never just when something ends
                sync = rng.random() < 0.5
                timeout = rng.choice([0, 0, 313, 1009])
                self.after.setdefault(name, []).append((other, sync, timeout))
                conditions.append(after(name, other, sync=sync, timeout=timeout, sequence=self.order[name]))
            if kind == "after" and not others:
                conditions.append(after(name, sequence=self.order[name]))
        rng.shuffle(conditions)
        self.delayed = set(self.wait) | set(self.after)
        outcomes = [DONE] * 6 + [ALREADY, FAILED, UNCERTAIN]
        self.fate = {name: (rng.choice([0.0, 0.05, 0.3, 1.0]), rng.choice(outcomes)) for name in names}
        shuffled = rng.sample(names, len(names))
        self.world = play(
            [component(name, self.required[name]) for name in shuffled], *conditions, **self.fate
        )
        self.names = names
        self.message = "seed %d" % seed

    def check(self):
        self.case.assertEqual(
            set(self.world.started) | set(self.world.reasons), set(self.names), self.message
        )
        self.case.assertFalse(set(self.world.started) & set(self.world.reasons), self.message)
        steps = [name for name in self.names if name not in self.delayed]
        armed = max([self.world.ended[name] for name in steps] or [0])
        for name in self.names:
            reasons = list(self.reasons_against(name, steps, armed))
            self.case.assertEqual(
                name in self.world.reasons, bool(reasons), "%s: %s: %s" % (self.message, name, reasons)
            )
            if name in self.world.started:
                self.case.assertAlmostEqual(
                    self.world.started[name], self.earliest(name, steps, armed), msg=self.message
                )

    def failed(self, name):
        return name in self.world.reasons or self.fate[name][1] not in plan.REACHED

    def reasons_against(self, name, steps, armed):
        for other in steps:
            comes_before = other in self.order and self.order[other] < self.order.get(name, -1)
            if comes_before and self.required[other] and self.failed(other):
                yield other
        for other, sync, timeout in self.after.get(name, []):
            stops = sync or self.required[other] or other in self.world.reasons
            begun = self.world.started.get(name)
            if self.failed(other) and stops and not (begun is not None and begun < self.world.ended[other]):
                yield other
            elif timeout and self.holds_from(other, sync) > armed + timeout / 1000 + 1e-9:
                yield timeout

    def holds_from(self, other, sync):
        return self.world.ended[other] if sync else self.world.accepted.get(other, self.world.ended[other])

    def earliest(self, name, steps, armed):
        """The earliest time for an action that was started."""
        if name not in self.delayed:
            rank = self.order.get(name, -1)
            return max(
                [self.world.ended[other] for other in steps if self.order.get(other, -1) < rank] or [0]
            )
        held = [self.holds_from(other, sync) for other, sync, _ in self.after.get(name, [])]
        return max([armed, armed + self.wait.get(name, 0) / 1000] + held)


if __name__ == "__main__":
    unittest.main()
