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
    depth = len(_common_directory(picture, numbers))
    processes = {group.key: group.numbers for group in groups if part.KINDS[group.kind] == "process"}
    names = _of_processes(picture, processes, depth)
    return [names.get(group.key) or _name(picture, group, depth) for group in groups]


def of_processes(picture):
    """{host:port: what it is called} of the processes of a picture, as `part.members` has them."""
    depth = len(_common_directory(picture, range(len(picture.boxes))))
    return _of_processes(picture, part.members(picture, "process"), depth)


def _of_processes(picture, processes, depth):
    """{host:port: what it is called} of processes, {host:port: numbers of its boxes}."""
    alike = collections.defaultdict(list)
    for key, numbers in processes.items():
        alike[_of_process([picture.boxes[number] for number in numbers])].append(key)
    names = {}
    for name, keys in alike.items():
        directories = ["/".join(_common_directory(picture, processes[key])[depth:]) for key in keys]
        if len(keys) == 1:
            names[keys[0]] = name
        elif all(directories) and len(set(directories)) == len(keys):
            names.update({key: f"{directory}/{name}" for key, directory in zip(keys, directories)})
        else:
            names.update({key: f"{name} ({key})" for key in keys})
    return names


def _name(picture, group, depth):
    """The name of a group that is no process; of a directory without as many directories above it."""
    kind = part.KINDS[group.kind]
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
