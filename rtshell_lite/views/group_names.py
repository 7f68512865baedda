"""What groups and components are called in drawings and on a page: without what all names begin with, and
with directories where names are equal.
"""

import collections
import os

from rtshell_lite.text import natural, printable
from rtshell_lite.views import part

_LEAST = 3  # letters of a name that is common to components


def of_groups(picture, groups, numbers):
    """What page_groups.Groups that are in one with these numbers of boxes are called, in their order."""
    common = _common_directory(picture, numbers)
    names = [_name(picture, group, len(common)) for group in groups]
    are_processes = [part.KINDS[group.kind] == "process" for group in groups]
    return _distinct(names, [group.key for group in groups], are_processes)


def of_processes(picture):
    """{host:port: what it is called} of the processes of a picture, as `part.members` has them."""
    processes = part.members(picture, "process")
    names = [_of_process([picture.boxes[number] for number in numbers]) for numbers in processes.values()]
    return dict(zip(processes, _distinct(names, processes, len(processes) * [True])))


def _distinct(names, keys, are_processes):
    """The names, with their keys where several processes have one."""
    counts = collections.Counter(names)
    return [
        f"{name} ({key})" if counts[name] > 1 and is_process else name
        for name, key, is_process in zip(names, keys, are_processes)
    ]


def _name(picture, group, depth):
    """The name of a group; of a directory without as many directories above it."""
    kind = part.KINDS[group.kind]
    if kind == "process":
        return _of_process([picture.boxes[number] for number in group.numbers])
    if kind == "directory":
        return "/".join(_common_directory(picture, group.numbers)[depth:]) or group.key
    return group.key


def common_directory(picture):
    """The directory of all components of a picture, spelt for a person; "" where they have none."""
    return "/".join(_common_directory(picture, range(len(picture.boxes))))


def _common_directory(picture, numbers):
    """The words of the directory that the boxes with these numbers have in common."""
    paths = [_words(picture.boxes[number])[:-1] for number in numbers if picture.boxes[number].path]
    return os.path.commonprefix(paths)


def _words(box):
    """The server, directories and name of a box, without their kinds."""
    return [printable(box.path.server or "")] + [printable(name.id) for name in box.path.names]


def _of_process(boxes):
    """What the names of the components of a process begin with, else one of them, and how many others."""
    names = [box.name for box in boxes]
    start = os.path.commonprefix(names)
    while start and not all(_ends_word(start, name) for name in names):
        start = start[:-1]
    start = start.rstrip("0123456789_-. ")
    if len(start) >= _LEAST:
        return printable(start)
    busiest = min(boxes, key=lambda box: (-len(box.left) - len(box.right), natural(box.name)))
    return f"{printable(busiest.name)} + {len(boxes) - 1}"


def _ends_word(start, name):
    """Whether a word of a name ends where its `start` does."""
    rest = name[len(start) :]
    return not rest or not rest[0].islower()


def of_boxes(picture):
    """{number: label} of the boxes that share a name with others: `left/Motor0`, `right/Motor0`."""
    equal = collections.defaultdict(list)
    for number, box in enumerate(picture.boxes):
        equal[box.name].append(number)
    labels = {}
    for name, numbers in equal.items():
        paths = {number: _words(picture.boxes[number]) for number in numbers if picture.boxes[number].path}
        if len(numbers) > 1 and paths:
            labels.update(_told_apart(name, paths))
    return labels


def _told_apart(name, paths):
    """{number: label} by the directory nearest to the components that differs, else by all that do."""
    for step in range(2, min(map(len, paths.values())) + 1):
        words = [path[-step] for path in paths.values()]
        if len(set(words)) == len(words):
            return {number: f"{path[-step]}/{printable(name)}" for number, path in paths.items()}
    common = len(os.path.commonprefix(list(paths.values())))
    return {number: "/".join(path[common:]) for number, path in paths.items()}
