"""Which layers the boxes of a page are in: the groups of each kind among each other, what is in a group among
itself, and so on inwards.
"""

import collections

from rtshell_lite.views import part
from rtshell_lite.views.layered import cycles, layers


def of_kind(picture, groups, kind):
    """For each box of a graph.Graph a tuple: the layer of its group of this kind (a number in part.KINDS),
    that of its group of a finer kind within this one …, its own layer within the last.

    groups  for each box what names its group of each kind but "none", or None
    """
    below = [[] for _ in picture.boxes]
    for source, _, target, _, service in picture.edges:
        below[source].append((target, 1 if service else 2))
    paths = [()] * len(picture.boxes)
    waiting = [(list(range(len(picture.boxes))), kind)]
    while waiting:
        numbers, level = waiting.pop()
        members = part.members_of(numbers, groups, level)
        for inner, layer in zip(members, _layers(members, below)):
            for number in inner:
                paths[number] += (layer,)
            if len(inner) > 1:
                waiting.append((inner, part.finer_kind(inner, groups, level)))
    return paths


def _layers(members, below):
    """The layer of each of these groups, lists of numbers of boxes, by the lines between them."""
    group_of = {number: index for index, numbers in enumerate(members) for number in numbers}
    weights = collections.OrderedDict()
    for number, group in group_of.items():
        for target, weight in below[number]:
            other = group_of.get(target, group)
            if other != group:
                weights[group, other] = weights.get((group, other), 0) + weight
    return layers.assign(cycles.order(weights, len(members)), weights)
