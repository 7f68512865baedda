"""The order of boxes in which few lines go back.

Circles are broken as Eades, Lin and Smyth (1993) do it, in each strongly connected part alone: first comes
what gives more than it takes, of equal ones what is fed from outside, as a controller is. Then boxes move
to where the least of their lines goes back. A walk along the data is taken where it breaks loops that meet
where they do.
"""

import heapq

_ROUNDS = 20  # most times that all boxes are moved


def order(weights, count):
    """The numbers of `count` boxes, so that little goes back of `weights`: {(source, target): weight}, where
    no source is its target.
    """
    below = [{} for _ in range(count)]
    above = [{} for _ in range(count)]
    for (source, target), weight in weights.items():
        below[source][target] = weight
        above[target][source] = weight
    ordered = []
    for circle in _circles(below, above):
        if len(circle) > 1:
            inner_below = _inside(circle, below)
            inner_above = _inside(circle, above)
            fed = {number: sum(above[number].values()) for number in circle}
            circle = _improve(_break(inner_below, inner_above, fed), inner_below, inner_above)
            walk = _improve(_walk(inner_below, inner_above), inner_below, inner_above)
            back, ends = _cost(circle, inner_below)
            walk_back, walk_ends = _cost(walk, inner_below)
            if walk_back == back and walk_ends < ends:  # not if less goes back: walks make many layers
                circle = walk
        ordered += circle
    return ordered


def _circles(below, above):
    """The strongly connected parts, sources first (Kosaraju and Sharir 1981)."""
    finished = []
    seen = [False] * len(below)
    for root in range(len(below)):
        _visit(root, below, seen, finished)
    seen = [False] * len(below)
    for root in reversed(finished):
        circle = []
        _visit(root, above, seen, circle)
        if circle:
            yield sorted(circle)


def _visit(root, neighbours, seen, finished):
    """Append to `finished` all that is reached from a box, the box last."""
    if seen[root]:
        return
    seen[root] = True
    waiting = [(root, iter(neighbours[root]))]
    while waiting:
        number, others = waiting[-1]
        other = next((other for other in others if not seen[other]), None)
        if other is None:
            finished.append(number)
            waiting.pop()
        else:
            seen[other] = True
            waiting.append((other, iter(neighbours[other])))


def _inside(circle, neighbours):
    """{number: {other: weight}} of these boxes alone."""
    numbers = set(circle)
    return {
        number: {other: weight for other, weight in neighbours[number].items() if other in numbers}
        for number in circle
    }


def _break(below, above, fed):
    """The numbers of a circle: sources from the left, sinks from the right, then what gives most."""
    gives = {number: sum(below[number].values()) for number in below}
    takes = {number: sum(above[number].values()) for number in above}
    fed = {number: fed[number] - takes[number] for number in fed}  # from outside

    def urgency(number):
        if not gives[number] or not takes[number]:
            return 0, 0, 0, number
        return 1, takes[number] - gives[number], -fed[number], number

    queue = [urgency(number) for number in below]
    heapq.heapify(queue)
    waiting = set(below)
    first, last = [], []
    while queue:
        entry = heapq.heappop(queue)
        number = entry[-1]
        if number not in waiting or entry != urgency(number):
            continue
        waiting.remove(number)
        if takes[number] and not gives[number]:
            last.append(number)
        else:
            first.append(number)
        for neighbours, rest in ((below, takes), (above, gives)):
            for other, weight in neighbours[number].items():
                if other in waiting:
                    rest[other] -= weight
                    heapq.heappush(queue, urgency(other))
    return first + last[::-1]


def _walk(below, above):
    """The numbers of a circle as data flows from the box that takes most."""
    root = max(above, key=lambda number: (sum(above[number].values()), -number))
    finished = []
    _visit(root, below, {number: False for number in below}, finished)
    return finished[::-1]


def _cost(ordered, below):
    """(how much goes back, how many boxes it goes from and to): loops that meet are broken where they do."""
    rank = {number: index for index, number in enumerate(ordered)}
    back = 0
    sources, targets = set(), set()
    for number in ordered:
        for target, weight in below[number].items():
            if rank[target] < rank[number]:
                back += weight
                sources.add(number)
                targets.add(target)
    return back, len(sources) + len(targets)


def _improve(ordered, below, above):
    """The same boxes, each where the least of its lines goes back while the others stay."""
    for _ in range(_ROUNDS):
        rank = {number: float(index) for index, number in enumerate(ordered)}
        is_better = False
        for number in ordered:
            better = _best_rank(rank, below[number], above[number], rank[number])
            if better is not None:
                rank[number] = better
                is_better = True
        if not is_better:
            break
        ordered = sorted(ordered, key=lambda number: (rank[number], number))
    return ordered


def _best_rank(rank, below, above, now):
    """The rank where less of a box's lines goes back than now; None if no rank is better."""
    changes = dict(below)  # by what more goes back if the box comes after one of these
    for source, weight in above.items():
        changes[source] = changes.get(source, 0) - weight
    steps = sorted((rank[other], weight) for other, weight in changes.items())
    back = least = current = 0  # compared with a box that comes before all of them
    best = 0
    for index, (other, weight) in enumerate(steps, 1):
        back += weight
        if other < now:
            current = back
        if back < least:
            least = back
            best = index
    if least >= current:
        return None
    if best == 0:
        return steps[0][0] - 1
    if best == len(steps):
        return steps[-1][0] + 1
    return (steps[best - 1][0] + steps[best][0]) / 2
