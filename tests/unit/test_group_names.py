"""What groups and components are called on a page: if this fails, people look for a process by its TCP port,
or take one of two components for the other.
"""
import unittest

import test_part
from rtshell_lite.views import group_names, page_groups, part


def labels(picture, kind):
    """The labels of the groups of a kind, the outermost alone."""
    groups, trees = page_groups.of(picture)
    rows = groups[trees[part.KINDS.index(kind)]][3]
    children = [child for row in rows for column in row for child in column[::2]]
    return sorted(groups[-1 - child][2] for child in children if child < 0)


class Groups(unittest.TestCase):
    def of_processes(self, *processes):
        picture = test_part.picture([name for names in processes for name in names])
        numbers = iter(picture.boxes)
        for port, names in enumerate(processes, 1):
            for _ in names:
                next(numbers).process = ("h", port)
        return labels(picture, "process")

    def test_a_process_is_called_by_what_its_components_have_in_common(self):
        self.assertEqual(self.of_processes(["ArmPlanner0", "ArmController0"], ["Motor0", "Motor1"]),
                         ["Arm", "Motor"])
        self.assertEqual(self.of_processes(["LeftLegPump", "LeftLegPlanner"], ["x_y1", "x_y2"]),
                         ["LeftLeg", "x_y"])

    def test_or_by_one_of_them(self):
        self.assertEqual(self.of_processes(["Camera0", "Base0", "Arm0"], ["A0", "A1"]),
                         ["A0 + 1", "Arm0 + 2"])

    def test_equal_ones_are_told_apart(self):
        self.assertEqual(self.of_processes(["Motor0", "Motor1"], ["Motor2", "Motor3"]),
                         ["Motor (h:1)", "Motor (h:2)"])
        self.assertEqual(self.of_processes(["left/Motor0", "left/Motor1"], ["right/Motor0", "right/Motor1"]),
                         ["left/Motor", "right/Motor"])

    def test_directories_without_what_is_common_to_all(self):
        picture = test_part.picture([
            "a.host_cxt/left.cxt/X", "a.host_cxt/left.cxt/Y", "a.host_cxt/right/X", "a.host_cxt/right/Z",
        ])
        self.assertEqual(labels(picture, "directory"), ["left", "right"])
        self.assertEqual(group_names.common_directory(picture), "h/a")
        picture = test_part.picture([
            "a.host_cxt/left/X", "a.host_cxt/left/Y", "b.host_cxt/X", "b.host_cxt/Y",
        ])
        self.assertEqual(labels(picture, "directory"), ["a/left", "b"])


class Components(unittest.TestCase):
    def labels(self, *names):
        return sorted(group_names.of_boxes(test_part.picture(names)).values())

    def test_equal_names(self):
        """By the nearest directory that differs."""
        self.assertEqual(self.labels("left/Motor0", "right/Motor0", "right/Other0"),
                         ["left/Motor0", "right/Motor0"])
        self.assertEqual(self.labels("a.host_cxt/arm/M0", "b.host_cxt/arm/M0"), ["a/M0", "b/M0"])
        self.assertEqual(self.labels("a/x/M0", "a/y/M0", "b/x/M0"), ["a/x/M0", "a/y/M0", "b/x/M0"])

    def test_others_have_none(self):
        self.assertEqual(self.labels("left/Motor0", "right/Motor1"), [])


class Kinds(unittest.TestCase):
    def test_directories_come_first_where_they_divide_as_well(self):
        picture = test_part.picture(["%s/X%d" % (name, number) for name in "ab" for number in range(20)])
        for processes, kind in ((4, "directory"), (10, "process")):
            for number, box in enumerate(picture.boxes):
                box.process = ("h", number % processes)
            self.assertEqual(part.choose_kind(picture), kind)


if __name__ == "__main__":
    unittest.main()
