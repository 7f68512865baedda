"""What becomes of the steps that change a system (rtresurrect, rtteardown) and of the actions of a plan (rtstart, rtstop), in words."""
import collections

from rtshell_lite import cli, text


def of_steps(args, outcomes, carry_out):
    """Carry out steps (apply.Outcomes) and report what has become of them; returns the exit status.

    After --dry-run the commands that would do them by hand are printed instead. What is not required may fail without
    spoiling the status, as in rtshell. An interruption is passed on, after the report.
    """
    cli.unwind_when_ended()
    try:
        if not args.dry_run:
            carry_out(outcomes, args.rollback)
    finally:
        status = _told(args, outcomes)
    return status


def _told(args, outcomes):
    tally, counts = cli.Tally(), collections.OrderedDict((status, 0) for status in ("done", "already so"))
    for each in outcomes:
        counts[each.status] = counts.get(each.status, 0) + 1
        if args.json:
            print(text.json_line(each.as_dict()))
        elif args.dry_run and each.pending and not each.likely:
            print(each.step.command)
        if not each.failed:
            good = each.status in ("done", "already so") or args.dry_run and each.pending
            tally.done += good and not args.rollback
            if each.status != "already so":
                why = " because of " + each.error.where if each.error else ""
                cli.detail(f"{each.step.title}: {each.status}{why}")
        elif each.step.required:
            tally.add(each.error)
        else:
            cli.note(f"{each.error} (not required)")
    if any(counts.values()) and not args.dry_run:
        (cli.note if tally.statuses else cli.detail)(", ".join("%d %s" % (number, status) for status, number in counts.items() if number))
    return tally.status()


class Progress(cli.Tally):
    """Tells what becomes of the actions of a plan (see run_plan.py), as it happens, in the words of rtshell."""

    def __init__(self, as_json, verb, state):
        """`verb` is Activate, say, and `state` the one that it leads to."""
        super().__init__()
        self.as_json, self.verb, self.state = as_json, verb, state

    def starting(self, action, line):
        """An action begins; `line` is what it is."""
        if not cli.is_quiet():
            cli.say("Executing {%d} %s" % (action.number, line))

    def ended(self, result):
        """An action has ended, or will not be tried; failures of optional components leave the exit status as it is."""
        action, error = result.action, result.error
        self._as_json(result)
        if error is None:
            self.add(action)
            cli.detail(f"{action.path}: {'already ' if result.outcome == 'already' else ''}{self.state}")
        elif action.component.is_required:
            self.add(error)
        else:
            cli.say(f"Action failed: {error}")

    def passed_over(self, result):
        """An action will not be tried, for a reason that has been reported."""
        self._as_json(result)

    def _as_json(self, result):
        action, error = result.action, result.error
        if self.as_json:
            print(text.json_line({
                "action": self.verb.lower(), "number": action.number, "path": action.path, "context": action.context,
                "required": action.component.is_required, "result": result.outcome, "error": str(error) if error else None}))
