"""The index of a log: how many records it has, and where some of them begin."""

from rtshell_lite.datalog import blocks

STRIDE = 1 << 20  # octets between two points of the index, at first
POINTS = 2048  # points at most; then every second one is dropped


class Index:
    """What is known of the records written so far."""

    def __init__(self):
        # next: the number of the next record
        self.next = 0
        self.first = None
        self.last = None
        self.latest = None
        self.counts = {}
        self.headers = []
        self.points = []
        self._stride = STRIDE

    count = property(lambda self: sum(self.counts.values()))

    def add(self, position, number, received, name):
        """Count the next record, at `position`."""
        if not self.points or position - self.points[-1][1] >= self._stride:
            self.points.append([number, position, self.latest])
            if len(self.points) > POINTS:
                del self.points[1::2]
                self._stride *= 2
        if self.first is None:
            self.first = received
        self.last = received
        if self.latest is None:
            self.latest = received
        else:
            self.latest = max(self.latest, received)
        self.next = number + 1
        self.counts[name] = self.counts.get(name, 0) + 1

    def block(self, position):
        """The index as the block that is written at `position`."""
        return blocks.text(
            blocks.INDEX,
            {
                "next": self.next,
                "first": self.first,
                "last": self.last,
                "counts": self.counts,
                "headers": self.headers,
                "points": self.points,
            },
            position,
        )
