"""The order within layers, so that few lines cross: by the means of neighbours (Sugiyama et al. 1981), and by
turns of those that are next to each other (Gansner et al. 1993).
"""

import bisect
import math

_EFFORT = 40000  # items that are looked at, about
_PATIENCE = 4  # sweeps that gain nothing
_SMALL = 400  # items; with more it would take long to try another order when nothing is gained
_EXCHANGES = 6  # most times that a layer is gone through
_FAR = 1 << 20  # more than any height, pixels


def sort(layers):
    """Order each layer, a list of item.Items, in place."""
    size = sum(map(len, layers))
    sweeps = max(3, min(24, _EFFORT // max(size, 1)))
    best, fewest = [], math.inf
    is_small = size <= _SMALL
    for way in (1, -1)[: 1 + is_small]:
        _begin(layers[::way], way)
        idle = 0
        for sweep in range(sweeps + 1):
            if sweep:
                _sweep(layers, is_small and sweep % 2 == 0)
            count = crossings(layers)
            idle += 1
            if count < fewest:
                fewest = count
                best = [list(items) for items in layers]
                idle = 0
            if not fewest or idle == _PATIENCE:
                break
    for index, items in enumerate(best):
        layers[index][:] = items
        stack(items)


def _sweep(layers, is_restless):
    """Order all layers once more, to the right and back."""
    for items in layers[1:]:
        _reorder(items, 0)
    for items in reversed(layers[:-1]):
        _reorder(items, 1)
    _transpose(layers, is_restless)


def stack(items):
    """Put the Items of a layer below each other, around y = 0, and number them."""
    y = -sum(item.height + item.space for item in items) / 2
    for rank, item in enumerate(items):
        item.rank = rank
        item.y = y
        y += item.height + item.space


def _begin(layers, way):
    """The order in which a walk along the lines comes to the Items, from the left or from the right (`way` is
    1 or -1).
    """
    for items in layers:
        stack(items)
    met = {}
    for items in layers:
        for root in items:
            waiting = [root]
            while waiting:
                item = waiting.pop()
                if item in met:
                    continue
                met[item] = len(met)
                for side in (0, 1)[::way]:
                    ends = sorted(item.ends[side], key=_height)
                    waiting += [end[1] for end in reversed(ends)]
    for items in layers:
        items.sort(key=met.get)
        stack(items)


def _height(end):
    return end[0]


# ---- means ----


def _reorder(items, side):
    """Order a layer by where its neighbours on a side are."""
    if len(items) == 1:
        return
    keys = {}
    turning = {}  # {Item: Items whose lines on this side lead to it, above or below it}
    for item in items:
        ys = []
        beside = None
        for here, other, other_side, there, _ in item.ends[side]:
            if other_side != side:
                ys.append(other.y + there - here)
            elif other is not item and other.number is not None:
                beside = other
        if ys:
            keys[item] = math.fsum(ys) / len(ys)  # sum() of floats differs from Python 3.12 on
        elif beside is not None and item.number is None:
            turning.setdefault(beside, ([], []))[beside.rank < item.rank].append(item)
        else:
            keys[item] = item.y
    ordered = []
    for item in sorted(keys, key=lambda item: (keys[item], item.rank)):
        above, below = turning.get(item, ((), ()))
        ordered += above
        ordered.append(item)
        ordered += below
    items[:] = ordered
    stack(items)


# ---- turns ----


def _transpose(layers, is_restless):
    """Exchange Items that are next to each other while fewer lines cross; where as many do, too, if
    `is_restless`, as that may open a way to fewer (Gansner et al. 1993).
    """
    active = set(range(len(layers)))
    for turn in range(_EXCHANGES):
        least = 0 if is_restless and turn == 0 else 1
        changed = [index for index in sorted(active) if _exchange(layers[index], least)]
        active = {index + step for index in changed for step in (-1, 0, 1)} & set(range(len(layers)))
    for items in layers:
        stack(items)


def _exchange(items, least):
    """Exchange Items of a layer with the next one where that gains as much; returns whether any gain."""
    if len(items) == 1:
        return False
    levels = {item: (_opposite(item, 0), _opposite(item, 1)) for item in items}
    is_better = False
    for rank in range(len(items) - 1):
        upper, lower = items[rank], items[rank + 1]
        gain = _gain(upper, lower, levels)
        if gain >= least:
            items[rank], items[rank + 1] = lower, upper
            upper.rank, lower.rank = rank + 1, rank
            is_better = is_better or gain > 0
    return is_better


def _opposite(item, side):
    """Where its lines end in the next layer on this side, upwards; None if a line turns around."""
    ends = []
    for _, other, other_side, there, _ in item.ends[side]:
        if other_side == side:
            return None
        ends.append(-other.rank * _FAR - there)
    ends.sort()
    return ends


def _gain(upper, lower, levels):
    """How many fewer lines cross when these two are exchanged."""
    gain = 0
    for side in (0, 1):
        ups, lows = levels[upper][side], levels[lower][side]
        if ups is None or lows is None:
            ups = _around(upper, lower, side)
            lows = _around(lower, upper, side)
            gain += _gain_between(upper, lower, side)
        for low in lows:
            # walking down from the two: that of the lower one would have to come first
            gain += bisect.bisect_right(ups, low) + bisect.bisect_left(ups, low) - len(ups)
    return gain


def _gain_between(upper, lower, side):
    """The same of lines that join the two: what they cross on the one and on the other."""
    joints = [(end[0], end[3]) for end in upper.ends[side] if end[1] is lower]
    if not joints:
        return 0
    ups = [end[0] for end in upper.ends[side] if end[1] not in (upper, lower)]
    lows = [end[0] for end in lower.ends[side] if end[1] not in (upper, lower)]
    gain = 0
    for here, there in joints:
        gain += sum((y > here) - (y < here) for y in ups)
        gain += sum((y < there) - (y > there) for y in lows)
    return gain


def _around(item, beside, side):
    """Where the lines of an Item end, in the order of a walk around the gap on this side: down the layer, up
    the other one, and down again from the top of this one.
    """
    ends = []
    for _, other, other_side, there, _ in item.ends[side]:
        if other is item or other is beside:
            continue
        where = other.rank * _FAR + there
        if other_side != side:
            ends.append(-where)
        elif other.rank > item.rank:
            ends.append(where - _FAR * _FAR)
        else:
            ends.append(where + 1)
    ends.sort()
    return ends


# ---- counting ----


def crossings(layers):
    """How many pairs of lines cross, between layers and beside them."""
    return sum(_between(left, right) for left, right in zip([[]] + layers, layers + [[]]))


def _between(left, right):
    """The crossings in the gap between two layers: lines are chords of a circle, down the left side and up
    the right one.
    """
    chords = []
    for items, side in ((left, 1), (right, 0)):
        for item in items:
            for here, other, other_side, there, _ in item.ends[side]:
                start = _on_circle(item.rank, here, side)
                end = _on_circle(other.rank, there, other_side)
                if start < end:
                    chords.append((start, end))
    chords.sort()
    count = 0
    open_ends = []
    new_ends = []  # of chords that begin where the present one does
    last = None
    for start, end in chords:
        if start != last:
            for new_end in new_ends:
                bisect.insort(open_ends, new_end)
            new_ends = []
            del open_ends[: bisect.bisect_right(open_ends, start)]
            last = start
        count += bisect.bisect_left(open_ends, end)
        new_ends.append(end)
    return count


def _on_circle(rank, y, side):
    where = rank * _FAR + y
    return where - _FAR * _FAR if side else -where
