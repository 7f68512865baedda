"""The layer of each box: data flows from one to a later one, over as few of them as can be."""

import collections

_ROUNDS = 10  # most times that boxes are drawn together
_MOST = 0.6  # of all boxes


def assign(ordered, weights):
    """The layer of each box, from 0 up.

    ordered  numbers of all boxes, so that little goes back
    weights  {(source, target): weight}
    """
    layer, count = _longest(ordered, weights)
    while True:
        # what comes before another in the same layer may as well go ahead: so nothing goes back without need
        index = {number: index for index, number in enumerate(ordered)}
        ordered = sorted(ordered, key=lambda number: (layer[number], -index[number]))
        before = count
        layer, count = _longest(ordered, weights)
        if count <= before:
            break
    lines = []
    for (source, target), weight in weights.items():
        if layer[source] < layer[target]:
            lines.append((source, target, weight))
        elif layer[source] > layer[target]:
            lines.append((target, source, weight))
    _tighten(layer, lines)
    used = {number: index for index, number in enumerate(sorted(set(layer)))}
    return [used[number] for number in layer]


def _longest(ordered, weights):
    """(the layer of each box by the longest way to it, the weight of what then goes ahead)."""
    rank = {number: index for index, number in enumerate(ordered)}
    below = [[] for _ in ordered]
    for source, target in weights:
        if rank[source] < rank[target]:
            below[source].append(target)
    layer = [0] * len(ordered)
    for number in ordered:
        for target in below[number]:
            layer[target] = max(layer[target], layer[number] + 1)
    ahead = [weight for (source, target), weight in weights.items() if layer[source] < layer[target]]
    return layer, sum(ahead)


# ---- shorter lines ----


def _tighten(layer, lines):
    """Move boxes, and groups of boxes that are as near to each other as can be, towards their neighbours."""
    below = [[] for _ in layer]
    above = [[] for _ in layer]
    for source, target, weight in lines:
        below[source].append((target, weight))
        above[target].append((source, weight))
    for _ in range(_ROUNDS):
        before = list(layer)
        _move_each(layer, below, above)
        for way in (1, -1):
            _move_groups(layer, lines, way)
        if layer == before:
            break


def _move_each(layer, below, above):
    """Move each box to the left or right, where more of its lines lead."""
    numbers = sorted(range(len(layer)), key=lambda number: (layer[number], number))
    pulls = [
        sum(weight for _, weight in rights) - sum(weight for _, weight in lefts)
        for rights, lefts in zip(below, above)
    ]
    for number in reversed(numbers):
        if below[number] and pulls[number] >= 0:
            layer[number] = min(layer[target] for target, _ in below[number]) - 1
    for number in numbers:
        if above[number] and pulls[number] < 0:
            layer[number] = max(layer[source] for source, _ in above[number]) + 1


def _move_groups(layer, lines, way):
    """Move groups of boxes with lines to the next layer, all to the right (`way` is 1) or all to the left
    (-1), where that makes more lines shorter than longer.
    """
    group = list(range(len(layer)))

    def group_of(number):
        while group[number] != number:
            group[number] = group[group[number]]
            number = group[number]
        return number

    for source, target, _ in lines:
        if layer[target] == layer[source] + 1:
            group[group_of(source)] = group_of(target)
    pulls = collections.Counter()
    room = {}
    for source, target, weight in lines:
        first, last = group_of(source), group_of(target)
        if first == last:
            continue
        pulls[first] += weight * way
        pulls[last] -= weight * way
        ahead = first if way > 0 else last
        room[ahead] = min(room.get(ahead, len(layer)), layer[target] - layer[source] - 1)
    for number in range(len(layer)):
        if pulls[group_of(number)] > 0:
            layer[number] += way * room.get(group_of(number), 0)


# ---- columns ----


def columns(layer, heights, height):
    """Lists of the numbers of boxes in each layer. Where most boxes are in one that is much taller than this
    height, it becomes several; where they are not, that would tear what belongs together. They take its boxes
    by turns: so each is beside the lines that pass.
    """
    lists = [[] for _ in range(max(layer) + 1)]
    for number, index in enumerate(layer):
        lists[index].append(number)
    divided = []
    for numbers in lists:
        tall = sum(heights[number] for number in numbers)
        count = 1
        if tall > 1.6 * height and len(numbers) > _MOST * len(layer):
            count = min(len(numbers), int(tall / height) + 1)
        divided += [numbers[start::count] for start in range(count)]
    return divided
