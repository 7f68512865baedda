"""Completion of what rtcall calls: operations and attributes, parameters, items of enums. Nothing
is called.
"""

from rtshell_lite import errors
from rtshell_lite.data import calling, datatypes
from rtshell_lite.giop import descriptors
from rtshell_lite.robot import lookup


async def offered(word, positional, idl):
    """(text, whether it is complete, help) of each that may be the next word after these, which begin with a
    path; `idl` are the IDL files that the line names.
    """
    (path,) = await lookup.paths(positional[:1])
    types = datatypes.Types(idl=idl)
    is_itself = path.port is None
    providers = [await calling.itself(path, types)] if is_itself else await calling.providers(path, types)
    members = [member for provider in providers for member in provider.members()]
    if len(positional) == 1:
        return [candidate for member in members for candidate in _named(member)]
    for provider in providers:
        try:
            operation = provider.operation(positional[1])
        except errors.Error:
            continue
        return _arguments(operation, word, positional[2:])
    return []


def _named(member):
    candidates = [(member.name, True, member.idl())]
    if hasattr(member, "readonly") and not member.readonly:
        candidates.append((member.name + "=", False, "set it"))
    return candidates


def _arguments(operation, word, before):
    """The values of the next parameter, and the names of those that are not given yet."""
    inputs = operation.inputs()
    named = [argument.partition("=")[0] for argument in before if "=" in argument]
    left = [parameter for parameter in inputs[len(before) - len(named) :] if parameter.name not in named]
    name, equals, _ = word.partition("=")
    if equals:
        chosen = [parameter for parameter in left if parameter.name == name]
        return [(f"{name}={value}", True, "") for parameter in chosen for value in _values(parameter.type)]
    candidates = [(f"{parameter.name}=", False, "") for parameter in left]
    if left:
        candidates += [(value, True, left[0].name) for value in _values(left[0].type)]
    return candidates


def _values(descriptor):
    """What a value of a type may be, where there are few."""
    target = descriptors.target(descriptor)
    if descriptors.kind(target) == descriptors.ENUM:
        return [item._n for item in descriptors.items(target)]
    if descriptors.kind(target) == descriptors.BOOLEAN:
        return ["true", "false"]
    return []
