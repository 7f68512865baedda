"""Name-value lists: what profiles carry in their `properties`."""
from . import carrier
from .idl import SDOPackage


def text(value):
    """A string in an any; a value that is an any already stays itself."""
    return value if isinstance(value, carrier.Any) else carrier.Any(carrier.TEXT, value)


def nvlist(pairs):
    """(name, value) pairs as an NVList."""
    return [SDOPackage.NameValue(name, text(value)) for name, value in pairs]


def is_text(value):
    """Whether an any holds a string."""
    return carrier.is_of(value, carrier.TEXT)


def get(properties, name, default=""):
    """The string of that name, or `default`."""
    for item in properties:
        if item.name == name and is_text(item.value):
            return item.value.value()
    return default


def put(properties, name, value):
    """Set a value in place, or append it."""
    for item in properties:
        if item.name == name:
            item.value = text(value)
            return
    properties.append(SDOPackage.NameValue(name, text(value)))
