"""The states of a component over time, as the events of a log and the details in it say."""

from rtshell_lite import errors
from rtshell_lite.play import recording
from rtshell_lite.robot import component, ports
from rtshell_lite.views import plot

HEIGHTS = {"Inactive": 0, "Active": 1, "Error": 2}
BEGIN = "APPEARED"  # event of the begin of a recording, before which nothing is known of the state
ENDS = ("DIED", "EXITED")  # events after which it has no state


class States:
    """A component in a log, and the plot.Panel of its states; taken as a plot_sources.Source."""

    failure = None

    def __init__(self, described, where, since):
        """`described`: what recording.details gives of the log; `where`: the path of the component; `since`:
        what was described before this moment may have changed until then. A part of a log that was rotated,
        and what is kept of a ring, have copies of what is older.
        """
        self._where = where
        self.panel = plot.Panel(where)
        self._series = self.panel.named("state")
        self._series.lasts = True
        self._states = {}  # by the handles of its contexts
        # what it was at a moment, by handles, the latest first
        self._described = [
            (moment, details[where].get("states"))
            for (moment, _), details in sorted(described.items(), key=lambda item: item[0], reverse=True)
            if where in details and moment >= since
        ]

    def break_at(self, moments):
        """Nothing: that values are missing says nothing of its states."""

    def take(self, moment, value):
        """Take an event that came at a moment: `value` is a function."""
        self._look_at_details(moment)
        try:
            fields = value()
        except errors.Error:  # of another tool, which calls its channel so
            return
        if not isinstance(fields, dict) or fields.get("path") != self._where:
            return
        event = str(fields.get("event"))
        if event == BEGIN:
            self._forget()
        elif event in ENDS:
            self._show(moment)
            self._forget()
        elif fields.get("kind") == "RTC_STATUS" and event in recording.STATES:
            self._set(moment, str(fields.get("subject") or ""), recording.STATES[event])

    def advance(self, moment):
        """Nothing more comes before `moment`: what it was last, it is."""
        self._look_at_details(moment)
        self._show(moment)

    def check(self):
        """Nothing: a component that no event names has no states here."""

    def _look_at_details(self, moment):
        while self._described and self._described[-1][0] <= moment:
            then, states = self._described.pop()
            if isinstance(states, dict):
                listed = list(states.items())[: ports.MOST_PARTS]
                self._states = {handle: state for handle, state in listed if str(state) in HEIGHTS}
                self._show(then)

    def _set(self, moment, handle, state):
        """Take a state in the context of a handle, or in all, where the event names none."""
        handles = [handle] if handle or not self._states else list(self._states)
        if len(self._states) < ports.MOST_PARTS or handle in self._states:
            self._states.update(dict.fromkeys(handles, state))
            self._show(moment)

    def _show(self, moment):
        state = component.merged(self._states.values())
        if state in HEIGHTS:
            self._series.add(moment, HEIGHTS[state], state)

    def _forget(self):
        self._states = {}
        self._series.interrupt()
