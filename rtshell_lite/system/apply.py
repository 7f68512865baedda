"""Carries out a list of steps.

Each is looked at first, skipped if it is done already, and looked at again afterwards, so that the report is
what there is. Steps that concern one component are done one by one, in their order where that matters, others
at the same time.
"""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.net import loop
from rtshell_lite.robot import tree
from rtshell_lite.system import placements
from rtshell_lite.system.outcomes import ALREADY, DONE, FAILED, NOT_TRIED, NOT_UNDONE, UNCERTAIN, UNDONE


class Outcome:
    """What has become of a step: its `status`, one of outcomes.DONE …, and the errors.Error that says why."""

    def __init__(self, step, status=NOT_TRIED, error=None):
        self.step = step
        self.status = status
        self.error = error
        self.before = self.after = None  # the answers to its step's questions, before it was done and after
        self.running = False  # True while it is being done
        self.failure = None  # the errors.Error that doing it raised
        self.likely = False  # True if it is done now, but an earlier step may change that

    @property
    def pending(self):
        """True for a step that is still to be done."""
        return self.status == NOT_TRIED and self.error is None

    @property
    def failed(self):
        """True for a step that was not done or undone as it should, or of which that is not known."""
        return self.status in (FAILED, UNCERTAIN, NOT_UNDONE)

    def fail(self, error, status=FAILED):
        """Note why the step has failed."""
        self.status = status
        self.error = error

    def as_dict(self):
        """For JSON."""
        step = self.step
        return {
            "step": step.kind,
            "path": step.where,
            "required": step.required,
            "command": step.command or None,
            "result": self.status,
            "error": None if self.error is None else str(self.error),
        }


async def assess(step):
    """The Outcome of a step by what was found of its Placements:
    done already, to be done, not tried, or failed.
    """
    outcome = Outcome(step)
    if not step.tolerant:
        outcome.error = step.placement_error()
    are_known = all(
        placement.found is not None or placement.error is not None for placement in step.placements
    )
    if outcome.error is not None or not are_known:
        return outcome
    try:
        if await step.is_done(errors.raise_first(step.known_answers())):
            outcome.status = ALREADY
    except errors.Error as e:
        if any(e is placement.error for placement in step.placements):  # reported with the component itself
            outcome.error = e
        else:
            outcome.fail(e)
    return outcome


async def carry_out(outcomes, all_or_nothing=False, on_step=lambda: None):
    """Do the pending steps. `all_or_nothing`:
    if anything required fails, or on an interruption, undo all of them. `on_step` is called after each that
    is done, or was not to be done.
    """
    is_complete = False
    try:
        for level in _levels([outcome for outcome in outcomes if outcome.pending]):
            if all_or_nothing and _spoilt(outcomes):
                break
            await _carry_out(level, outcomes, all_or_nothing, on_step)
        is_complete = True
    finally:
        if all_or_nothing and (not is_complete or _spoilt(outcomes)):
            await _roll_back(outcomes)


def _spoilt(outcomes):
    return any(outcome.failed and outcome.step.required for outcome in outcomes)


async def _roll_back(outcomes):
    """Undo what has been done, the last first."""
    for outcome in reversed([outcome for outcome in outcomes if outcome.status in (DONE, UNCERTAIN)]):
        loop.current().allow_more()
        outcome.fail(errors.Failed(outcome.step.where, "interrupted while it was undone"), NOT_UNDONE)
        if outcome.after is None:  # it was interrupted before it was looked at again
            outcome.after = (await _answers([outcome]))[0]
        failure = await errors.or_error(outcome.step.undo(outcome.before, outcome.after))
        try:
            undone = not await outcome.step.is_done((await _answers([outcome]))[0])
        except errors.Error as e:
            undone = isinstance(e, errors.Gone)
            failure = failure or e
        if undone and not outcome.running:
            outcome.status = UNDONE
            outcome.error = None
        else:
            outcome.fail(failure or errors.Refused(outcome.step.where, "is still there"), NOT_UNDONE)


def _levels(outcomes):
    """Lists of outcomes, one after the other, so that no two of a list share a Placement.

    The order of those that share one is kept, but among steps that are `free`: connections of one component
    after another to the next would make a list each.
    """
    # by id of a Placement: the level that ends those in order, and all levels in use
    ends = {}
    taken = {}
    levels = []
    for outcome in outcomes:
        keys = [id(placement) for placement in outcome.step.placements]
        level = max([ends.get(key, 0) for key in keys] or [0])
        if outcome.step.free:
            while any(level in taken.get(key, ()) for key in keys):
                level += 1
        else:
            level = max([level] + [max(taken[key]) + 1 for key in keys if key in taken])
            ends.update((key, level + 1) for key in keys)
        for key in keys:
            taken.setdefault(key, set()).add(level)
        levels += [[] for _ in range(level + 1 - len(levels))]
        levels[level].append(outcome)
    return levels


# ---- looking ----


async def _answers(outcomes):
    """For each outcome the list of answers to its step's questions;
    an errors.Error in the place of what failed.
    """
    asked = [_questions(outcome.step) for outcome in outcomes]
    questions = [question for part in asked for question in part]  # errors stay what they are
    values = await session.each(questions, lambda question: question.ask(), lambda question: question[:2])
    coming = iter(values)
    return [[next(coming) for _ in part] for part in asked]


def _questions(step):
    """The Questions of a step, or the errors.Error that says why it has none, in a list."""
    try:
        return step.questions()
    except errors.Error as e:
        return [e]


async def _look(outcomes):
    """Ask how things are, and return those outcomes that are still to be done."""
    ready = []
    todo = []
    for outcome in outcomes:
        dead = None if outcome.step.tolerant else outcome.step.placement_error()
        if dead is not None:
            outcome.error = dead
        else:
            ready.append(outcome)
    for outcome, answers in zip(ready, await _answers(ready)):
        outcome.before = answers
        try:
            if await outcome.step.is_done(answers):
                outcome.status = ALREADY
            else:
                todo.append(outcome)
        except errors.Error as e:
            outcome.fail(e)
    return todo


async def _mark_dead(outcomes, others=()):
    """Note at the Placements which components have died or fallen silent meanwhile: those are left alone.

    `others`: outcomes of which only the Placements in the same processes are looked at.
    """
    answers = [
        answer
        for outcome in outcomes
        for answer in (outcome.before or []) + (outcome.after or []) + [outcome.error]
    ]
    if not any(isinstance(answer, errors.Unreachable) for answer in answers):
        return
    asked = _living_placements(outcomes)
    endpoints = {placement.node.endpoint for placement in asked.values()}
    asked.update(
        (key, placement)
        for key, placement in _living_placements(others).items()
        if placement.node.endpoint in endpoints
    )
    nodes = await tree.check_alive([placement.node for placement in asked.values()])
    # a connection, which may have been an old one
    unsure = [type(node.error) is errors.Unreachable for node in nodes]
    doubtful = [placement.node for placement, is_unsure in zip(asked.values(), unsure) if is_unsure]
    again = iter(await tree.check_alive(doubtful))
    for placement, node, is_unsure in zip(asked.values(), nodes, unsure):
        placement.error = next(again).error if is_unsure else node.error


def _living_placements(outcomes):
    """{id of a Placement: Placement} of those of all steps that can be asked."""
    return collections.OrderedDict(
        (id(placement), placement)
        for outcome in outcomes
        for placement in outcome.step.placements
        if placement.node is not None and placement.error is None
    )


# ---- doing ----


async def _carry_out(level, outcomes, all_or_nothing, on_step):
    """Do the steps of one level."""
    todo = await _look(level)
    for _ in range(len(level) - len(todo)):
        on_step()
    await _act_on_all(todo, all_or_nothing, on_step)
    for outcome in todo:
        if isinstance(outcome.failure, errors.Unanswered):
            # one call was lost; whether the process answers others decides what is reported
            session.current().ask_again(outcome.step.endpoint)
    for outcome, answers in zip(todo, await _answers(todo)):
        outcome.after = answers
    lost = [
        outcome
        for outcome in todo
        if not outcome.step.tolerant and _lost(outcome.after) and not _lost(outcome.after, errors.Unanswered)
    ]
    for outcome, answers in zip(lost, await _answers(lost)):  # one more look: what was done has to be known
        outcome.after = answers
    await _mark_dead(level, outcomes)
    for outcome in todo:
        await _judge(outcome, outcome.failure)
    for outcome in level:
        if outcome.error is not None:
            outcome.step.give_up(outcome.error)


async def _act_on_all(outcomes, is_to_be_known, on_step):
    """Do these steps at the same time.

    `is_to_be_known`: after Ctrl-C, what has begun goes on for as long as an answer may take; it is undone
    then.
    """
    over = loop.Bell()

    async def all_over():
        while any(outcome.running for outcome in outcomes):
            await over.wait()

    async with loop.Group() as group:
        for outcome in outcomes:
            outcome.running = True
            group.start(_act(outcome, over, on_step), outcome.step.endpoint)
        try:
            await all_over()
        except BaseException:
            if is_to_be_known:
                await loop.race(all_over(), loop.sleep(session.current().timeout))
            raise


async def _act(outcome, over, on_step):
    """Do a step, and note what is known of it in case an interruption comes before it is judged."""
    outcome.fail(errors.Failed(outcome.step.where, "interrupted while it was done"), UNCERTAIN)
    try:
        outcome.failure = await errors.or_error(outcome.step.act(outcome.before))
        if outcome.failure is None:
            outcome.status = DONE
            outcome.error = None
    finally:
        outcome.running = False
        over.ring()
        on_step()


def _lost(answers, kind=errors.Error):
    """The first failure of that kind among the answers to a look, or None."""
    return next((answer for answer in answers if isinstance(answer, kind)), None)


async def _judge(outcome, failure):
    """Decide by the look after a step what has become of it. `failure` is the error of `act`, or None."""
    try:
        if await outcome.step.is_done(outcome.after):
            outcome.status = DONE
            outcome.error = None
            return
        why = failure or errors.Refused(outcome.step.where, "reported success, but nothing changed")
    except errors.Error as e:
        e = next(
            (placement.error for placement in outcome.step.placements if placements.is_gone(placement.error)),
            e,
        )
        if isinstance(e, errors.Unreachable) and not isinstance(failure, errors.Unanswered):
            why = e
        else:
            why = failure or e
        if (_lost(outcome.after) is e or outcome.step.tolerant) and not placements.is_gone(e):
            error = errors.Unreachable(outcome.step.where, f"{e.why}; whether it was done is not known")
            outcome.fail(error, UNCERTAIN)
            return
    outcome.fail(why)
    await errors.or_error(outcome.step.tidy(outcome.after))
