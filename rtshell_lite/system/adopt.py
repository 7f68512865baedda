"""Taking the present state of a system into its RtsProfile: what a person has changed becomes what
is wanted.
"""

from rtshell_lite import errors
from rtshell_lite.system import capture, restore

KINDS = ("data_port_connectors", "service_port_connectors", "one_port_connectors")


async def adopt(profile):
    """Give a profile the configuration, rates, members and connections that its components have now.

    Of configuration only what the file has changes; connections are those among its components. Raises the
    first error of a component that is absent or does not answer: half a system is not to be adopted.
    """
    listed = restore.places(profile)
    tops = sorted({placement.path._replace(names=()) for placement in listed}, key=str)
    now = await capture.capture(tops, all_components=True)
    found = {}
    for each, made in zip(now.found, now.profile.components):
        found[each.node.path] = each, made
    for placement in listed:
        if placement.path not in found:
            mine = [error for error in now.failures if error.where == placement.where]
            raise (mine + now.failures + [errors.NotFound(placement.where)])[0]
    for placement in listed:
        _take_component(placement.component, *found[placement.path])
    wanted = set()
    for path, (_, made) in found.items():
        if path in {placement.path for placement in listed}:
            wanted.add(id(made))
    locate = capture.locator(now.profile)
    for kind in KINDS:
        present = [
            connector
            for connector in getattr(now.profile, kind)
            if all(id(locate(end)) in wanted for end in connector.ends)
        ]
        setattr(profile, kind, _connectors(getattr(profile, kind), present))


def _take_component(of_file, found, made):
    """Change a model.Component to what its capture.ComponentState has; `made` is the one that rtcryo would
    write.
    """
    values = {one.id: one.values for one in found.sets}
    for one in of_file.configuration_sets:
        for item in one.configuration_data:
            item.data = values.get(one.id, {}).get(item.name, item.data)
    if of_file.active_configuration_set and found.active:
        of_file.active_configuration_set = found.active
    rates = {str(context.handle): context.rate for context in found.owned}
    for context in of_file.execution_contexts:
        context.rate = rates.get(context.id, context.rate)
    of_file.participants = made.participants


def _connectors(listed, present):
    """The connectors of the file that are still there, then those that are new."""
    ids = {connector.connector_id for connector in listed}
    there = {connector.connector_id for connector in present}
    kept = [connector for connector in listed if connector.connector_id in there]
    return kept + [connector for connector in present if connector.connector_id not in ids]
