"""Which of the objects in a mounted tree live: all are asked, but no listing waits for one that hangs."""


from rtshell_lite.corba import orb
from rtshell_lite.mount.attempt import attempt
from rtshell_lite.net import loop
from rtshell_lite.robot import tree

PATIENCE = 0.2  # seconds that a listing waits; later answers are for the next one
ASKED = ("component", "manager", "unsure")
UNKNOWN = None, None, 0  # kind, error, until when that is believed


class Liveness:
    """What objects have turned out to be, believed for `ttl` seconds; before that, what their references say.

    They are asked in the loop.Group `tasks`; fail(exception) is called at a bug.
    """

    def __init__(self, tasks, ttl, fail):
        self._tasks = tasks
        self._ttl = ttl
        self._fail = fail
        self._known = {}  # by identity: (kind, error, until)
        self._asked = {}  # by identity: since when, loop.now()
        self._bells = set()  # of the listings that wait

    async def check(self, nodes):
        """`tree.check_alive`, for a few tenths of a second at most; what does not answer keeps its kind."""
        objects = {
            orb.identity(node.ref): node for node in nodes if node.kind in ASKED and node.error is None
        }
        begun = loop.now()
        self._ask(objects, begun)
        end = begun + PATIENCE
        bell = loop.Bell()
        self._bells.add(bell)
        try:
            while self._is_worth_waiting(objects) and await bell.wait(end - loop.now()):
                pass
        finally:
            self._bells.discard(bell)
        return [self._classified(node, begun) for node in nodes]

    def _ask(self, objects, now):
        groups = {}
        for identity, node in objects.items():
            _, _, until = self._known.get(identity, UNKNOWN)
            if identity not in self._asked and until < now:
                self._asked[identity] = now
                groups.setdefault(node.endpoint, []).append((identity, node))
        for group in groups.values():
            self._tasks.start(self._ask_process(group))

    def _is_worth_waiting(self, objects):
        late = loop.now() - PATIENCE
        return any(self._asked.get(identity, late) > late for identity in objects)

    async def _ask_process(self, group):
        answers, error = await attempt(tree.check_alive([node for _, node in group]))
        until = loop.now() + self._ttl
        for (identity, _), answer in zip(group, answers or ()):
            self._known[identity] = answer.kind, answer.error, until
        for identity, _ in group:
            del self._asked[identity]
        for bell in self._bells:
            bell.ring()
        if error is not None:
            self._fail(error)

    def _classified(self, node, begun):
        """The node as it is known by an answer that was believed when its listing began, or has come since.
        """
        if node.kind not in ASKED or node.error is not None:
            return node
        kind, error, until = self._known.get(orb.identity(node.ref), UNKNOWN)
        if until < begun or kind in (node.kind, *tree.DOUBTFUL):
            return node
        return tree.Node(node.path, kind, node.ref, error)

    def sweep(self):
        """Free what is believed no longer, not even by a listing that waits."""
        last = loop.now() - PATIENCE
        self._known = {identity: belief for identity, belief in self._known.items() if belief[2] >= last}
