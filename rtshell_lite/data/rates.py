"""The rates at which components are executed and ports are written to, in fact."""

import collections

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.data import reading
from rtshell_lite.net import loop
from rtshell_lite.robot import component, ports
from rtshell_lite.text import printable

TOGETHER = 4  # ports of a process that are measured at a time: fetching their values is work for it


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
                    ports.short_name(port.name, node.path.instance)
                )
    return None, "no out port is written to"


async def written(out_ports, seconds):
    """How many values a second (Hz) are written to each of these DataOutPorts, measured for `seconds`; an
    errors.Error in the place of one that cannot be measured.
    """
    rates = [None] * len(out_ports)  # type: list
    waiting = list(range(len(out_ports)))
    while waiting:
        batch, waiting = next_batch(waiting, lambda number: orb.endpoint(out_ports[number].ref))
        results = await loop.each(batch, lambda number: reading.count_writes(out_ports[number], seconds))
        for number, result in zip(batch, results):
            rates[number] = result if isinstance(result, errors.Error) else result[0] / result[1]
    return rates


def next_batch(waiting, process_of):
    """(what is to be measured at once, the rest), where process_of(what waits) is its (host, port)."""
    taken = collections.Counter()
    batch = []
    rest = []
    for member in waiting:
        process = process_of(member)
        if taken[process] < TOGETHER:
            batch.append(member)
        else:
            rest.append(member)
        taken[process] += 1
    return batch, rest
