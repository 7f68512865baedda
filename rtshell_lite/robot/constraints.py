"""Constraints of configuration parameters, as components have them in their set __constraints__ (protocol.md
11.2).

    0<=x<=150   x<100   x >= 0   one side or both, strict or not
    (red,green)                  one of these, or a list of them
    x>0,x<10                     of an array: one for each element
    {key0: x>0, key1: }          of a map: one for each key
    5                            no other value; nothing: any

Components do not enforce them; RTSystemEditor does.
"""

import operator
import re

_NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?\Z")
_RANGE = re.compile(r"(?:([^<>=\s]+)\s*(<=?)\s*)?x(?:\s*(<=?|>=?)\s*([^<>=\s]+))?\Z")
_COMPARE = {"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
_SETS = ("__constraints__", "__constraint__")  # some files have the second


def doubts(present, values, sets):
    """Why the component may not accept some of the new `values` (a dict): a list of (name, reason).

    present  the values of the same parameters now
    sets     all configuration sets of the component, {id: {name: value}}
    """
    reasons = []
    for name, value in values.items():
        constraint = _constraint(sets, name)
        if _are_numbers(present.get(name, "")) and not _are_numbers(value):
            why = f"is not a number, unlike the old value ({present[name]})"
        elif not fits(constraint, value):
            why = f"does not fit the component's constraint {constraint}"
        else:
            continue
        reasons.append((name, f"{value or repr('')} {why}"))
    return reasons


def _constraint(sets, name):
    """The constraint of a parameter; '' for none."""
    constraints = [sets.get(set_id, {}).get(name) for set_id in _SETS]
    return next(filter(None, constraints), "")


def _are_numbers(value):
    """True for a number, and for several with commas between them."""
    return all(_NUMBER.match(number.strip()) for number in value.split(","))


def fits(constraint, value):
    """True unless a value violates a constraint; a constraint of unknown form allows any."""
    constraint = constraint.strip()
    value = value.strip()
    if not constraint:
        return True
    if constraint.startswith("(") and constraint.endswith(")"):
        choices = [element.strip() for element in constraint[1:-1].split(",")]
        if value in choices:
            return True
        return all(element.strip() in choices for element in value.split(","))
    if constraint.startswith("{") and constraint.endswith("}"):
        return _map_fits(constraint[1:-1], value)
    parts = constraint.split(",")
    elements = value.split(",")
    if len(parts) == 1:
        parts *= len(elements)
    return all(_fits_one(part.strip(), element.strip()) for part, element in zip(parts, elements))


def _map_fits(constraints, value):
    constraint_of = dict(_pair(pair) for pair in constraints.split(","))
    return all(
        _fits_one(constraint_of.get(key, ""), pair) for key, pair in map(_pair, value.strip("{}").split(","))
    )


def _pair(text):
    key, _, value = text.partition(":")
    return key.strip(), value.strip()


def _fits_one(constraint, value):
    """`fits` for one value and a range, or the only value allowed."""
    if "x" not in constraint or "<" not in constraint and ">" not in constraint:
        return (
            not _NUMBER.match(constraint) or bool(_NUMBER.match(value)) and float(value) == float(constraint)
        )
    match = _RANGE.match(constraint)
    if not match:
        return True
    bounds = [bound for bound in match.group(1, 4) if bound is not None]
    if not bounds or not all(_NUMBER.match(bound) for bound in bounds):
        return True
    if not _NUMBER.match(value):
        return False
    low, below, above, high = match.groups()
    return (low is None or _COMPARE[below](float(low), float(value))) and (
        high is None or _COMPARE[above](float(value), float(high))
    )
