"""Where lines are: level through layers, in curves from one layer to the next, and on tracks of their own
where they turn.

A way is a list of points (x, y). Between two of them with neither x nor y in common the line is a curve.
"""

import bisect
import math

from rtshell_lite.views.layered import item

# pixels
BESIDE = 40  # between layers, for curves
LANE = 10  # between tracks
LOOP = 6  # how far a line goes down from a port to itself
BETWEEN = 20  # above and below the lanes between rows
_TRIED = 30  # tracks that are looked at for room; more would cost the square of the lines


class Turn:
    """A part of a line that goes up or down beside a layer.

    end         (Item, side, y on it) where the line comes from
    low, high   its ys, those on Items before the Items have their places; infinite where it leaves the row
    x           of its track
    """

    def __init__(self, end, low, high):
        self.end = end
        self.low = low
        self.high = high
        self.x = 0

    @property
    def urgency(self):
        """What sorts turns, the nearest to the layer first, so that few cross."""
        if self.high == math.inf:
            return math.inf, -self.low
        if self.low == -math.inf:
            return math.inf, self.high
        return self.high - self.low, self.low


class Chain:
    """A line within a row of layers.

    stops  (Item, side, y on it): its source, twice each Item that it passes, its target
    """

    def __init__(self, source, target, row, weight):
        self.stops = [source]
        first = source[0].layer + source[1]
        last = target[0].layer + target[1]
        step = 1 if first < last else -1
        passed = range(first, last) if first < last else range(first - 1, last - 1, -1)
        for layer in passed:
            passing = item.Item()
            passing.layer = layer
            passing.row = source[0].row
            row[layer].append(passing)
            self.stops += [(passing, step < 0, 0), (passing, step > 0, 0)]
        self.stops.append(target)
        for start, end in self.hops():
            item.join(start, end, weight)
        self.turns = []

    @property
    def passed(self):
        return [stop[0] for stop in self.stops[1:-1:2]]

    def hops(self):
        """Pairs of stops in one gap between layers."""
        return zip(self.stops[::2], self.stops[1::2])

    def turn(self):
        """The Turns of the line, where it leads back to the layer that it comes from."""
        for start, end in self.hops():
            if start[1] == end[1]:
                low, high = sorted(stop[0].y + stop[2] for stop in (start, end))
                self.turns.append(Turn(start, low, max(high, low + LOOP)))
        return self.turns

    def way(self, rows):
        points = []
        turns = iter(self.turns)
        for start, end in self.hops():
            y, end_y = start[0].y + start[2], end[0].y + end[2]
            if start[1] != end[1]:
                gap = rows[start[0].row].gap(start)
                corners = [(gap[1 - start[1]], y), (gap[1 - end[1]], end_y)]
            else:
                x = next(turns).x
                corners = [(x, y), (x, end_y)]
                if y == end_y:  # from a port to itself
                    beside = x + LANE // 2 * (1 if start[1] else -1)
                    corners = [(x, y), (x, y + LOOP), (beside, y + LOOP), (beside, y)]
            points += [(_x(start), y), *corners, (_x(end), end_y)]
        return _without_stops(points)


class Detour:
    """A line that passes between rows.

    lanes    the rows above which it passes (the number of rows: below all): one, or that near its source and
             that near its target
    ys       of these lanes; x: where it goes from the one to the other
    """

    def __init__(self, source, target):
        self.source = source
        self.target = target
        first, last = source[0].row, target[0].row
        if abs(first - last) > 1:
            self.lanes = [first + 1, last]
        else:
            self.lanes = [min(first, last) + 1]
        self.ys = [0] * len(self.lanes)
        self.x = 0
        self.turns = []

    passed = ()

    def turn(self):
        """The Turns of the line: from its source to a lane, from a lane to its target."""
        for end, lane in ((self.source, self.lanes[0]), (self.target, self.lanes[-1])):
            y = end[0].y + end[2]
            if lane <= end[0].row:
                self.turns.append(Turn(end, -math.inf, y))
            else:
                self.turns.append(Turn(end, y, math.inf))
        return self.turns

    def spans(self):
        """(least, most) x in each of its lanes."""
        xs = [self.turns[0].x] + [self.x] * (len(self.lanes) - 1) + [self.turns[1].x]
        return [tuple(sorted(pair)) for pair in zip(xs, xs[1:])]

    def way(self, rows):
        first, last = [turn.x for turn in self.turns]
        points = [(_x(self.source), _y(self.source)), (first, _y(self.source)), (first, self.ys[0])]
        if len(self.lanes) > 1:
            points += [(self.x, self.ys[0]), (self.x, self.ys[1])]
        return points + [(last, self.ys[-1]), (last, _y(self.target)), (_x(self.target), _y(self.target))]


def _without_stops(points):
    """Points without those where a line goes straight on."""
    corners = points[:1]
    for point in points[1:]:
        if len(corners) > 1 and corners[-2][1] == corners[-1][1] == point[1]:
            del corners[-1]
        if point != corners[-1]:
            corners.append(point)
    return corners


def _x(end):
    return end[0].x + end[0].width * end[1]


def _y(end):
    return end[0].y + end[2]


class Row:
    """Layers beside each other: lists of Items. gaps: [(x, x)] where curves begin and end before each layer,
    and after the last.
    """

    def __init__(self, layers):
        self.layers = layers
        self.gaps = []

    def gap(self, end):
        """(left, right) x of the curves in the gap on a side of an Item."""
        return self.gaps[end[0].layer + end[1]]

    def put_beside(self, x, turns):
        """Set x of all Items and of these Turns; returns where all this ends."""
        tracks = {}
        for turn in turns:
            tracks.setdefault((turn.end[0].layer + turn.end[1], turn.end[1]), []).append(turn)
        for layer in range(len(self.layers) + 1):
            left = x + LANE * _put_turns(tracks.get((layer, 1), ()), x, 1)
            right = left
            if 0 < layer < len(self.layers):
                right += BESIDE
            self.gaps.append((left, right))
            before = tracks.get((layer, 0), ())
            x = right + LANE * _put_turns(before, 0, 1)  # how many they are; where they are comes next
            _put_turns(before, x, -1)
            if layer < len(self.layers):
                width = max(item.width for item in self.layers[layer])
                width = -(-width // LANE) * LANE
                for box in self.layers[layer]:
                    box.x = x
                    box.width = width
                x += width
        return x


def _put_turns(turns, x, way):
    """Set x of Turns on one side of a layer that ends at x; returns how many tracks they need."""
    turns = sorted(turns, key=lambda turn: turn.urgency)
    numbers = pack([(turn.low, turn.high) for turn in turns])
    for turn, number in zip(turns, numbers):
        turn.x = x + way * LANE * (number + 1)
    return max(numbers, default=-1) + 1


def pack(spans):
    """The number of the track of each (low, high): the first with no other one there."""
    tracks = []
    numbers = []
    for span in spans:
        number = max(0, len(tracks) - _TRIED)
        while number < len(tracks) and not _is_free(tracks[number], span):
            number += 1
        if number == len(tracks):
            tracks.append([])
        bisect.insort(tracks[number], span)
        numbers.append(number)
    return numbers


def _is_free(track, span):
    index = bisect.bisect(track, span)
    if index and track[index - 1][1] >= span[0]:
        return False
    return index == len(track) or span[1] < track[index][0]
