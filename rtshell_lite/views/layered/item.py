"""What is in a layer: boxes, and lines that pass between them."""

# pixels
BELOW = 18  # between boxes in a layer
PASSING = 6  # between lines that pass


class Item:
    """A box, or a line that passes (`number` is None).

    x, y    its upper left corner; width: that of its layer
    layer   index of its layer in its row; rank: its place in the layer, from 0 down
    row     index of its row of layers; space: pixels that stay free below it
    ends    of each side, 0 for the left and 1 for the right one: (y on this Item, the other Item, its side,
            y on it, how much it counts that the line is level) of each line there; the other one is in the
            next layer, or in the same one, where a line turns around
    """

    __slots__ = ("number", "width", "height", "x", "y", "layer", "rank", "row", "ends", "space")

    def __init__(self, number=None, width=0, height=0):
        self.number = number
        self.width = width
        self.height = height
        self.x = self.y = self.layer = self.rank = self.row = 0
        self.ends = ([], [])
        self.space = PASSING if number is None else BELOW


# how much it counts that a line is level: between boxes, between a box and a passing line, between two such
_WEIGHTS = (1, 2, 8)


def join(start, end, weight):
    """Note a line between two Items, from (Item, side, y on it) to another one."""
    item, side, y = start
    other, other_side, other_y = end
    weight *= _WEIGHTS[(item.number is None) + (other.number is None)]
    item.ends[side].append((y, other, other_side, other_y, weight))
    other.ends[other_side].append((other_y, item, side, y, weight))
