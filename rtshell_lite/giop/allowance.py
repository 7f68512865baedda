"""How much one answer may hold: an element of a sequence may take 500 times the memory of its octets,
and a type even more.
"""

from _thread import _local as Local

from rtshell_lite.giop.fixed_size import Fault

MOST = 100000  # parts: elements of sequences, types in TypeCodes and what they consist of
CLASS = 20  # parts that a struct or a union in a TypeCode counts for: it takes a class


class _Allowance(Local):
    left = MOST


_allowance = _Allowance()


def begin():
    """Another answer is read on this thread."""
    _allowance.left = MOST


def spend(parts):
    """Count parts of the answer that is being read; returns how many are left.
    Raises Fault when it has too many.
    """
    _allowance.left -= parts
    if _allowance.left < 0:
        raise Fault(f"more than {MOST} parts")
    return _allowance.left
