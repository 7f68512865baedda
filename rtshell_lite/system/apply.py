"""Carries out a list of steps.

Each is looked at first, skipped if it is done already, and looked at again afterwards, so that the report is what there is. Steps
that concern one component are done one by one, in their order where that matters, others at the same time.
"""
import collections
import time

from rtshell_lite import errors
from rtshell_lite.corba import lanes
from rtshell_lite.robot import tree
from rtshell_lite.system import sites, steps

DONE, ALREADY, FAILED, UNTRIED = "done", "already so", "failed", "not tried"
UNSURE = "uncertain"  # a call was lost, and the look after it, too
UNDONE, STUCK = "undone", "not undone"


class Outcome:
    """What has become of a step: its `status`, one of the above, and the errors.Error that says why."""

    def __init__(self, step, status=UNTRIED, error=None):
        self.step, self.status, self.error = step, status, error
        self.before = self.after = None  # the answers to its step's jobs, before it was done and after
        self.running = False  # True while it is being done
        self.likely = False  # True for one that is done now, and that an earlier step may change

    @property
    def pending(self):
        """True for a step that is still to be done."""
        return self.status == UNTRIED and self.error is None

    @property
    def failed(self):
        """True for a step that has not brought about what it should, or perhaps not."""
        return self.status in (FAILED, UNSURE, STUCK)

    def fail(self, error, status=FAILED):
        """Note why the step has failed."""
        self.status, self.error = status, error

    def as_dict(self):
        """For JSON."""
        step = self.step
        return {"step": step.kind, "path": step.where, "required": step.required, "command": step.command or None,
                "result": "already" if self.status == ALREADY else self.status,
                "error": str(self.error) if self.error is not None else None}


def judged(step):
    """The Outcome of a step by what was found of its Sites: done already, to be done, not tried, or failed."""
    outcome = Outcome(step)
    if not step.tolerant:
        outcome.error = step.site_error()
    if outcome.error is None and all(site.found is not None or site.error is not None for site in step.sites):
        try:
            if step.is_done(steps.given(step.found())):
                outcome.status = ALREADY
        except errors.Error as e:
            if any(e is site.error for site in step.sites):  # reported with the component itself
                outcome.error = e
            else:
                outcome.fail(e)
    return outcome


def carry_out(outcomes, all_or_nothing=False):
    """Do the pending steps. `all_or_nothing`: if anything required fails, or it is interrupted, undo it all."""
    over = False
    try:
        for level in _levels([each for each in outcomes if each.pending]):
            if all_or_nothing and _spoilt(outcomes):
                break
            _carry_out(level, outcomes)
        over = True
    finally:
        if all_or_nothing and (not over or _spoilt(outcomes)):
            _roll_back(outcomes)


def _spoilt(outcomes):
    return any(each.failed and each.step.required for each in outcomes)


def _roll_back(outcomes):
    """Undo what has been done, the last first."""
    limit = time.monotonic() + lanes.session.timeout + lanes.GRACE
    while any(each.running for each in outcomes) and time.monotonic() < limit:  # what is done later could not be undone
        time.sleep(lanes.TICK)
    for each in reversed([each for each in outcomes if each.status in (DONE, UNSURE)]):
        each.fail(errors.Failed(each.step.where, "interrupted while it was undone"), STUCK)
        if each.after is None:  # it was interrupted before it was looked at again
            each.after = _answers([each])[0]
        failure = _tried(each, lambda: each.step.undo(each.before, each.after))
        try:
            undone = not each.step.is_done(_answers([each])[0])
        except errors.Error as e:
            undone, failure = isinstance(e, errors.Gone), failure or e
        if undone and not each.running:
            each.status, each.error = UNDONE, None
        else:
            each.fail(failure or errors.Refused(each.step.where, "is as it was made"), STUCK)


def _levels(outcomes):
    """Lists of outcomes, one after the other, so that no two of a list share a Site.

    The order of those that share one is kept, but among steps that are `free`: connections of one component after another
    to the next would make a list each.
    """
    ends, taken, levels = {}, {}, []  # by id of a Site: the level that ends those in order, and all levels in use
    for each in outcomes:
        keys = [id(site) for site in each.step.sites]
        level = max([ends.get(key, 0) for key in keys] or [0])
        if each.step.free:
            while any(level in taken.get(key, ()) for key in keys):
                level += 1
        else:
            level = max([level] + [max(taken[key]) + 1 for key in keys if key in taken])
            ends.update((key, level + 1) for key in keys)
        for key in keys:
            taken.setdefault(key, set()).add(level)
        levels += [[] for _ in range(level + 1 - len(levels))]
        levels[level].append(each)
    return levels


# ---- looking ----------------------------------------------------------------------------------------------------

def _answers(outcomes):
    """For each outcome the list of answers to its step's jobs; an errors.Error in the place of what failed."""
    asked = []  # type: list
    for each in outcomes:
        try:
            asked.append(each.step.jobs())
        except errors.Error as e:
            asked.append(e)
    values = iter(lanes.gather([job for jobs in asked if isinstance(jobs, list) for job in jobs]))
    return [[next(values) for _ in jobs] if isinstance(jobs, list) else [jobs] for jobs in asked]


def _look(outcomes):
    """Ask how things are, and return those outcomes that are still to be done."""
    ready, todo = [], []
    for each in outcomes:
        dead = None if each.step.tolerant else each.step.site_error()
        if dead is not None:
            each.error = dead
        else:
            ready.append(each)
    for each, answers in zip(ready, _answers(ready)):
        each.before = answers
        try:
            if each.step.is_done(answers):
                each.status = ALREADY
            else:
                todo.append(each)
        except errors.Error as e:
            each.fail(e)
    return todo


def _mark_dead(outcomes, others=()):
    """Note at the Sites which of their components have died or fallen silent meanwhile: nothing more is asked of them."""
    answers = [answer for each in outcomes for answer in (each.before or []) + (each.after or []) + [each.error]]
    if not any(isinstance(answer, errors.Unreachable) for answer in answers):
        return
    asked = _living_sites(outcomes)
    endpoints = {site.node.endpoint for site in asked.values()}
    asked.update((key, site) for key, site in _living_sites(others).items() if site.node.endpoint in endpoints)
    nodes = tree.look([site.node for site in asked.values()])
    unsure = [type(node.error) is errors.Unreachable for node in nodes]  # a connection, which may have been an old one
    again = iter(tree.look([site.node for site, is_unsure in zip(asked.values(), unsure) if is_unsure]))
    for site, node, is_unsure in zip(asked.values(), nodes, unsure):
        site.error = next(again).error if is_unsure else node.error


def _living_sites(outcomes):
    """{id of a Site: Site} of those of all steps that can be asked."""
    return collections.OrderedDict((id(site), site) for each in outcomes for site in each.step.sites
                                   if site.node is not None and site.error is None)


# ---- doing ------------------------------------------------------------------------------------------------------

def _carry_out(level, outcomes):
    """Do the steps of one level."""
    todo = _look(level)
    results = lanes.gather([_job(each, lambda each=each: _act(each)) for each in todo])
    for each, result in zip(todo, results):
        if isinstance(result, errors.Silent):
            # one call was lost; whether the process answers others decides what is reported
            lanes.session.silent.pop(each.step.endpoint, None)
    for each, answers in zip(todo, _answers(todo)):
        each.after = answers
    lost = [each for each in todo if not each.step.tolerant and _lost(each.after) and not _lost(each.after, errors.Silent)]
    for each, answers in zip(lost, _answers(lost)):  # one more look: what was done has to be known
        each.after = answers
    _mark_dead(level, outcomes)
    for each, result in zip(todo, results):
        _judge(each, result if isinstance(result, errors.Error) else None)
    for each in level:
        if each.error is not None:
            each.step.give_up(each.error)


def _act(each):
    """Do a step, and note what is known of it if we are interrupted before it is judged."""
    interrupted = errors.Failed(each.step.where, "interrupted while it was done")
    each.fail(interrupted, UNSURE)
    each.running = True
    try:
        each.step.act(each.before)
        if each.error is interrupted:  # else it was given up, and has been judged
            each.status, each.error = DONE, None
    finally:
        each.running = False


def _job(each, call):
    return lanes.Job(each.step.endpoint, each.step.where, call)


def _tried(each, call):
    """Call something of a step in the lane of its process: the errors.Error that came of it, or None."""
    try:
        value, = lanes.gather([_job(each, call)])
    except errors.Error as e:  # there is no process to ask
        return e
    return value if isinstance(value, errors.Error) else None


def _lost(answers, kind=errors.Error):
    """The first failure of that kind among the answers to a look, or None."""
    return next((answer for answer in answers if isinstance(answer, kind)), None)


def _judge(each, failure):
    """Tell by the look after a step what has become of it. `failure` is what the step itself said."""
    try:
        if each.step.is_done(each.after):
            each.status, each.error = DONE, None
            return
        why = failure or errors.Refused(each.step.where, "was said to be done, but is not so")
    except errors.Error as e:
        e = next((site.error for site in each.step.sites if sites.is_gone(site.error)), e)
        why = e if isinstance(e, errors.Unreachable) and not isinstance(failure, errors.Silent) else failure or e
        if (_lost(each.after) is e or each.step.tolerant) and not sites.is_gone(e):
            each.fail(errors.Unreachable(each.step.where, f"{e.why}; whether it was done is not known"), UNSURE)
            return
    each.fail(why)
    _tried(each, lambda: each.step.tidy(each.after))
