"""The y of boxes and lines within their layers, so that lines are straight, long ones most of all.

Each Item wants to be where its lines are level; a layer is the nearest arrangement to what its Items want
that keeps their order (isotonic regression). Then lines that pass are put on one level over as many layers
as there is room.
"""

import math

from rtshell_lite.views.layered import crossings


def settle(layers, chains):
    """Set y of all Items, from 0 down.

    chains  lists of Items: those that a line passes
    """
    for items in layers:
        crossings.stack(items)
    depths = [_depths(items) for items in layers]
    pulls = {sides: [[_pulls(item, sides) for item in items] for items in layers] for sides in _SIDES}
    for middle, right, left in _SWEEPS:
        for items, own_depths, own_pulls in zip(layers, depths, pulls[right]):
            _fit(items, own_depths, own_pulls, middle)
        for items, own_depths, own_pulls in reversed(list(zip(layers, depths, pulls[left]))):
            _fit(items, own_depths, own_pulls, middle)
    for items in layers:
        _round(items)
    neighbours = {}
    for items in layers:
        for upper, item, lower in zip([None] + items[:-1], items, items[1:] + [None]):
            neighbours[item] = upper, lower
    for _ in range(3):
        for chain in sorted(chains, key=len, reverse=True):
            _level(chain, neighbours)
        for items in layers:
            for item in items:
                if item.number is not None:
                    _nudge(item, neighbours)
    top = min([items[0].y for items in layers if items], default=0)
    for items in layers:
        for item in items:
            item.y -= top


def _gap(upper, lower):
    """Pixels between two Items."""
    return max(upper.space, lower.space)


def _depths(items):
    """The least y of each Item of a layer, from that of the first one."""
    depths = [0]
    for upper, lower in zip(items, items[1:]):
        depths.append(depths[-1] + upper.height + _gap(upper, lower))
    return depths


def _pulls(item, sides):
    """[(the other Item, how far from its y one of the lines is level, weight)] of an Item."""
    return [
        (other, there - here, weight)
        for side in sides
        for here, other, other_side, there, weight in item.ends[side]
        if other_side != side
    ]


def _median(pulls):
    """The weighted median of where pulls have an Item; the mean of two where half of the weight is on either
    side.
    """
    half = sum([weight for _, _, weight in pulls]) / 2
    passed = 0
    wants = sorted([(other.y + step, weight) for other, step, weight in pulls])
    for index, (y, weight) in enumerate(wants):
        passed += weight
        if passed > half:
            return y
        if passed == half:
            return (y + wants[index + 1][0]) / 2
    return y


def _mean(pulls):
    """The weighted mean of where pulls have an Item."""
    total = sum([weight for _, _, weight in pulls])
    return math.fsum([(other.y + step) * weight for other, step, weight in pulls]) / total


# what of its lines an Item follows, and those on which sides as layers are gone through to the right and
# back: first together, so that no group floats away
_SIDES = _LEFT, _RIGHT, _BOTH = (0,), (1,), (0, 1)
_SWEEPS = [(_mean, _LEFT, _RIGHT)] * 4 + [(_mean, _BOTH, _BOTH)] * 3 + [(_median, _BOTH, _BOTH)] * 2


def _fit(items, depths, pulls, middle):
    """Put a layer as near as possible to where lines on these sides of its Items are level, in the middle."""
    # [sum of weighted ys, sum of weights, count] of Items that touch; ys as if nothing had a height
    groups = []
    unheld = 0  # the first Items of the layer, if nothing holds them
    for item, depth, own in zip(items, depths, pulls):
        if own:
            y, weight = middle(own), sum([pull[2] for pull in own])
        elif any(item.ends):
            y, weight = item.y, 0.01
        elif groups:
            groups[-1][2] += 1  # it stays below the one above
            continue
        else:
            unheld += 1
            continue
        groups.append([(y - depth) * weight, weight, 1 + unheld])
        unheld = 0
        while len(groups) > 1 and groups[-2][0] * groups[-1][1] > groups[-1][0] * groups[-2][1]:
            group = groups.pop()
            for index in range(3):
                groups[-1][index] += group[index]
    index = 0
    for total, weight, count in groups:
        for index in range(index, index + count):
            items[index].y = total / weight + depths[index]
        index += 1


def _round(items):
    """Set each y to a whole number."""
    last = None
    for item in items:
        y = round(item.y)
        if last is not None:
            y = max(y, last.y + last.height + _gap(last, item))
        item.y = y
        last = item


# ---- level lines ----


def _room(item, neighbours):
    """(least, most) y of an Item between those above and below it."""
    upper, lower = neighbours[item]
    least, most = -float("inf"), float("inf")
    if upper is not None:
        least = upper.y + upper.height + _gap(upper, item)
    if lower is not None:
        most = lower.y - item.height - _gap(item, lower)
    return least, most


def _level(chain, neighbours):
    """Put the Items that a line passes on as few levels as there is room for."""
    start = 0
    least, most = -float("inf"), float("inf")
    for index, item in enumerate(chain):
        own_least, own_most = _room(item, neighbours)
        if max(least, own_least) > min(most, own_most):
            _put_level(chain[start:index], least, most)
            start = index
            least, most = own_least, own_most
        else:
            least, most = max(least, own_least), min(most, own_most)
    _put_level(chain[start:], least, most)


def _put_level(items, least, most):
    """Give Items one y, that of what they lead to if possible."""
    own = set(items)
    ys = [items[0].y]
    for item in (items[0], items[-1]):
        for side in (0, 1):
            ys += [other.y + there for _, other, _, there, _ in item.ends[side] if other not in own]
    y = min(ys[1:] or ys, key=lambda y: (max(least - y, y - most, 0), y))
    for item in items:
        item.y = int(min(max(y, least), most))


def _nudge(item, neighbours):
    """Move a box within its room so that its lines are as level as they can be."""
    pulls = _pulls(item, _BOTH)
    if pulls:
        least, most = _room(item, neighbours)
        item.y = int(min(max(_median(pulls), least), most))
