"""Reports, for people and as JSON, on the steps that change a system (rtresurrect,
rtteardown) and on plans (rtstart, rtstop).
"""

import collections

from rtshell_lite import notes, text
from rtshell_lite.system.outcomes import ALREADY, DONE, REACHED


async def of_steps(args, outcomes, carry_out):
    """Carry out steps (apply.Outcomes), print what became of each, and return the exit status.

    With --dry-run, print the commands that would do them by hand instead. As in rtshell, the failure of a
    step that is not required leaves the status 0. An interruption is raised again, after the report.
    """
    try:
        if not args.dry_run:
            with notes.Work("steps", sum(outcome.pending for outcome in outcomes)) as work:
                await carry_out(outcomes, args.rollback, work.count)
    finally:
        status = _report(args, outcomes)
    return status


def _report(args, outcomes):
    tally = notes.Tally()
    counts = collections.OrderedDict((status, 0) for status in (DONE, ALREADY))
    for outcome in outcomes:
        counts[outcome.status] = counts.get(outcome.status, 0) + 1
        if args.json:
            print(text.json_line(outcome.as_dict()))
        elif args.dry_run and outcome.pending and not outcome.likely:
            print(outcome.step.command)
        if not outcome.failed:
            is_good = outcome.status in REACHED or args.dry_run and outcome.pending
            tally.done += is_good and not args.rollback
            if outcome.status != ALREADY:
                why = " because of " + outcome.error.where if outcome.error else ""
                notes.detail(f"{outcome.step.title}: {outcome.status}{why}")
        elif outcome.step.required:
            tally.add(outcome.error)
        else:
            notes.note(f"{outcome.error} (not required)")
    if any(counts.values()) and not args.dry_run:
        tell = notes.note if tally.statuses else notes.detail
        words = {ALREADY: "already done"}
        parts = ["%d %s" % (number, words.get(status, status)) for status, number in counts.items() if number]
        tell(", ".join(parts))
    return tally.status()


class Progress(notes.Tally):
    """Reports the actions of a plan (see run_plan.py) as they begin and end, in the words of rtshell."""

    def __init__(self, as_json, verb, state):
        """`verb` names the action (Activate), `state` the state that it leads to (Active)."""
        super().__init__()
        self.as_json = as_json
        self.verb = verb
        self.state = state

    def starting(self, action, line):
        """An action begins, described by `line`."""
        notes.progress("Executing {%d} %s" % (action.number, line))

    def ended(self, result):
        """An action has ended, or will not be tried;
        failures of optional components do not change the exit status.
        """
        action = result.action
        error = result.error
        self._as_json(result)
        if error is None:
            self.add(action)
            already = "already " if result.status == ALREADY else ""
            notes.detail(f"{action.path}: {already}{self.state}")
        elif action.component.is_required:
            self.add(error)
        else:
            notes.action_failed(error)

    def skipped(self, result):
        """An action will not be tried, for a reason that has been reported."""
        self._as_json(result)

    def _as_json(self, result):
        if not self.as_json:
            return
        action = result.action
        values = {
            "action": self.verb.lower(),
            "number": action.number,
            "path": action.path,
            "context": action.context,
            "required": action.component.is_required,
            "result": result.status,
            "error": None if result.error is None else str(result.error),
        }
        print(text.json_line(values))
