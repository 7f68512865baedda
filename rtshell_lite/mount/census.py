"""Which of the objects in a mounted tree live: all are asked, but no listing waits for one that hangs."""
import threading
import time

from rtshell_lite.corba import orb
from rtshell_lite.robot import tree

PATIENCE = 0.2  # seconds that a listing waits; an object that has not answered by then is taken for what its reference says
ASKED = ("component", "manager", "unsure")


class Census:
    """What objects have turned out to be, believed for `ttl` seconds."""

    def __init__(self, crew, ttl):
        self._crew, self._ttl = crew, ttl
        self._changed = threading.Condition()
        self._known = {}  # by identity: (kind, error, until)
        self._asked = {}  # by identity: since when, time.monotonic()

    def judged(self, nodes):
        """`tree.look`, for a few tenths of a second at most; what does not answer keeps its kind."""
        objects = {orb.identity(node.ref): node for node in nodes if node.kind in ASKED and node.error is None}
        with self._changed:
            self._ask(objects)
            self._changed.wait_for(lambda: not self._worth_waiting(objects), PATIENCE)
            return [self._judged(node) for node in nodes]

    def _ask(self, objects):
        now, groups = time.monotonic(), {}
        for identity, node in objects.items():
            if identity not in self._asked and (identity not in self._known or self._known[identity][2] < now):
                self._asked[identity] = now
                groups.setdefault(node.endpoint, []).append((identity, node))
        for endpoint, group in groups.items():
            self._crew.start(("census", endpoint), lambda group=group: self._look(group))

    def _worth_waiting(self, objects):
        late = time.monotonic() - PATIENCE
        return any(self._asked.get(identity, late) > late for identity in objects)

    def _look(self, group):
        answers = []
        try:
            answers = tree.look([node for _, node in group])
        finally:
            with self._changed:
                until = time.monotonic() + self._ttl
                for (identity, _), answer in zip(group, answers):
                    self._known[identity] = answer.kind, answer.error, until
                for identity, _ in group:
                    del self._asked[identity]
                self._changed.notify_all()

    def _judged(self, node):
        if node.kind not in ASKED or node.error is not None:
            return node
        kind, error, until = self._known.get(orb.identity(node.ref), (None, None, 0))
        if until < time.monotonic() or kind in (node.kind, "silent"):
            return node
        return tree.Node(node.path, kind, node.ref, error)

    def sweep(self):
        """Free what is believed no longer."""
        now = time.monotonic()
        with self._changed:
            self._known = {identity: known for identity, known in self._known.items() if known[2] >= now}
