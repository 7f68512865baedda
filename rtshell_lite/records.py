"""Tuples whose items have names, as of collections.namedtuple, and functions that keep their results, as of
functools.lru_cache.

Those take 2 ms to import at each start of a command, and 0.2 ms for each class.
"""

from _operator import itemgetter  # which `operator` is made of: that one takes longer to import


class Record(tuple):
    """A tuple with a name for each item; its values are given in order, or by name after those."""

    __slots__ = ()
    _fields = ()  # type: tuple

    def __new__(cls, *values, **named):
        if named:
            values += tuple(named.pop(field) for field in cls._fields[len(values) :] if field in named)
        if named or len(values) != len(cls._fields):
            raise TypeError(f"a {cls.__name__} has {len(cls._fields)} items: {', '.join(cls._fields)}")
        return tuple.__new__(cls, values)

    def __repr__(self):
        shown = ", ".join(f"{field}={value!r}" for field, value in zip(self._fields, self))
        return f"{type(self).__name__}({shown})"

    def __getnewargs__(self):
        return tuple(self)

    def _replace(self, **changes):
        """The same with some items changed."""
        values = [changes.pop(field, value) for field, value in zip(self._fields, self)]
        return type(self)(*values, **changes)

    def _asdict(self):
        """{name: item}, in their order."""
        return dict(zip(self._fields, self))


def record(name, fields):
    """The class of a Record with these fields, a text of words."""
    names = tuple(fields.split())
    parts = {field: item(index) for index, field in enumerate(names)}
    return type(name, (Record,), dict(parts, __slots__=(), _fields=names))


def item(index):
    """The property of a class of tuples for the item at a place."""
    return property(itemgetter(index))


def cached(most):
    """A decorator of functions of hashable positional arguments: they keep up to `most` results."""

    def decorate(function):
        results = {}  # type: dict

        def remember(*args):
            try:
                return results[args]
            except KeyError:
                pass
            if len(results) >= most:
                results.clear()
            result = results[args] = function(*args)
            return result

        remember.__doc__ = function.__doc__
        return remember

    return decorate
