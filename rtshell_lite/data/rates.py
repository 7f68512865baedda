"""The rate at which a component is really executed."""
from rtshell_lite.data import reading
from rtshell_lite.robot import component, ports
from rtshell_lite.text import printable


def measured(node, seconds):
    """What can be observed of the rate at which a component is executed: (Hz, how), the former None where nothing can.

    Nobody outside sees the cycles of a context; but a component that writes to an out port in each shows them. The values
    are fetched through a connector of our own, which only queues them, and which is removed again.
    """
    if component.state(node) != "Active":
        return None, "the component is not Active"
    for port in ports.ports(node):
        if port.type == "DataOutPort":
            count, spent = reading.count_writes(port, seconds)
            if count > 1:
                return count / spent, "writes to " + printable(ports.short_name(port.name, node.path.names[-1].id))
    return None, "no out port is written to"
