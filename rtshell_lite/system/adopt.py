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
    now = await capture.capture(tops, all_components=True, shows=True)
    captured = {
        answer.node.path: (answer, described)
        for answer, described in zip(now.found, now.profile.components)
    }
    for placement in listed:
        if placement.path not in captured:
            mine = [error for error in now.failures if error.where == placement.where]
            raise (mine + now.failures + [errors.NotFound(placement.where)])[0]
    for placement in listed:
        _take_component(placement.component, *captured[placement.path])
    own_paths = {placement.path for placement in listed}
    ids = {id(described) for path, (_, described) in captured.items() if path in own_paths}
    locate = capture.locator(now.profile)
    for kind in KINDS:
        present = [
            connector
            for connector in getattr(now.profile, kind)
            if all(id(locate(end)) in ids for end in connector.ends)
        ]
        setattr(profile, kind, _connectors(getattr(profile, kind), present))


def _take_component(of_file, answer, described):
    """Change a model.Component to what its capture.ComponentState has; `described` is the one that rtcryo
    would write.
    """
    values = {one_set.id: one_set.values for one_set in answer.sets}
    for one_set in of_file.configuration_sets:
        for item in one_set.configuration_data:
            item.data = values.get(one_set.id, {}).get(item.name, item.data)
    if of_file.active_configuration_set and answer.active:
        of_file.active_configuration_set = answer.active
    rates = {str(context.handle): context.rate for context in answer.owned}
    for context in of_file.execution_contexts:
        context.rate = rates.get(context.id, context.rate)
    of_file.participants = described.participants


def _connectors(listed, present):
    """The connectors of the file that are still there, then those that are new."""
    ids = {connector.connector_id for connector in listed}
    there = {connector.connector_id for connector in present}
    kept = [connector for connector in listed if connector.connector_id in there]
    return kept + [connector for connector in present if connector.connector_id not in ids]
