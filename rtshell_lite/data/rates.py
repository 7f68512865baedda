"""The rate at which a component is executed in fact."""

from rtshell_lite.data import reading
from rtshell_lite.robot import component, ports
from rtshell_lite.text import printable


async def measured(node, seconds):
    """(Hz, how it was measured) of a component's execution; (None, why) where it cannot be measured.

    The cycles of a context are not visible; but a component that writes to an out port in each cycle shows
    them. The values are fetched through a pull connector, which is removed again.
    """
    if await component.state(node) != "Active":
        return None, "the component is not Active"
    for port in await ports.ports(node):
        if port.type == "DataOutPort":
            count, spent = await reading.count_writes(port, seconds)
            if count > 1:
                return count / spent, "writes to " + printable(
                    ports.short_name(port.name, node.path.names[-1].id)
                )
    return None, "no out port is written to"
