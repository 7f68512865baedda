"""The states of a component over time, as the events of a log and the profiles in it say."""

from rtshell_lite.play import recording
from rtshell_lite.robot import component
from rtshell_lite.views import plot

HEIGHTS = {"Inactive": 0, "Active": 1, "Error": 2}
ENDS = ("DIED", "EXITED")  # events after which it has no state


class States:
    """A component in a log, and the plot.Panel of its states; taken as a plot_sources.Source."""

    failure = None

    def __init__(self, robot, where):
        """`robot`: the recording.Recording of the log; `where`: the path of the component."""
        self._where = where
        self._first = robot.log.first or 0
        self.panel = plot.Panel(where)
        self._series = self.panel.named("state")
        self._series.lasts = True
        self._states = {}  # by the handles of its contexts
        # what it was at a moment, by handles, the latest first
        self._scenes = [
            (scene.moment, scene.details[where].get("states"))
            for scene in reversed(robot.scenes)
            if where in scene.details
        ]

    def break_at(self, moments):
        """Nothing: that values are missing says nothing of its states."""

    def take(self, moment, value):
        """Take an event that came at a moment: `value` is a function."""
        self._look_at_scenes(moment)
        fields = value()
        if not isinstance(fields, dict) or fields.get("path") != self._where:
            return
        event = str(fields.get("event"))
        if event in ENDS:
            self._end(moment)
        elif fields.get("kind") == "RTC_STATUS" and event in recording.STATES:
            handle = str(fields.get("subject"))
            handles = [handle] if handle in self._states or not self._states else list(self._states)
            self._states.update(dict.fromkeys(handles, recording.STATES[event]))
            self._show(moment)

    def advance(self, moment):
        """Nothing more comes before `moment`: what it was last, it is."""
        self._look_at_scenes(moment)
        self._show(moment)

    def check(self):
        """Nothing: a component that no event names has no states here."""

    def _look_at_scenes(self, moment):
        while self._scenes and self._scenes[-1][0] <= moment:
            then, states = self._scenes.pop()
            if isinstance(states, dict):
                self._states = {handle: state for handle, state in states.items() if str(state) in HEIGHTS}
                self._show(max(then, self._first))

    def _show(self, moment):
        state = component.merged(list(self._states.values()))
        if state in HEIGHTS:
            self._series.add(moment, HEIGHTS[state], state)

    def _end(self, moment):
        self._show(moment)
        self._states = {}
        self._series.interrupt()
