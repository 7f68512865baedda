"""Answers of peers, checked while omniORB reads them: nothing in them may end our process, or overflow its
stack.

Every operation that can return a reference, or a value of any type, is invoked with a descriptor that shows
us all (ior.guarded). A bad reference or a value nested too deep fails that one call.

The TypeCodes in an `any`, and the values that they describe, cannot be checked before omniORB reads them.
Names in them that are not UTF-8, a union whose default index is 0, 100,000 levels, and fixed<65535> end the
process; a struct that claims 0x0fffffff members takes 6 GB.
"""

import functools
import threading

from rtshell_lite import errors
from rtshell_lite.corba import stubs
from rtshell_lite.giop import ior
from rtshell_lite.text import from_wire, printable

DEEPEST = 64  # values inside values


def invoke(where, ref, operation, args):
    """The result of an operation, checked by `_taker` and `_holder`.
    Raises CORBA exceptions, and Garbled for a bad answer.
    """
    guarded = _guarded(type(ref), operation)  # type: ignore  # a class is hashable
    if guarded is None:
        return getattr(ref, operation)(*args)
    begin()
    result = ref._obj.invoke(operation, guarded, args)
    check(where)
    return result


def begin():
    """Another answer is read on this thread."""
    _seen.fault = None


def fault(why):
    """What is read must not be used."""
    _seen.fault = why


def check(where):
    """Raise Garbled if what has been read must not be used."""
    if _seen.fault:
        raise errors.Garbled(str(where), _seen.fault)


@functools.lru_cache(maxsize=None)
def _guarded(objref, operation):
    """The guarded descriptors of an operation of a class of references;
    None where nothing in them needs to be guarded.
    """
    try:
        given, returned, raised = stubs.operation(objref._NP_RepositoryId, operation)
    except KeyError:
        return None  # _non_existent, _is_a
    safe = tuple(ior.guarded(descriptor, _taker, _holder) for descriptor in returned or ())
    failures = {name: ior.guarded(descriptor, _taker, _holder) for name, descriptor in (raised or {}).items()}
    same = all(new is old for new, old in zip(safe, returned or ())) and failures == (raised or {})
    return None if same else (given, safe, failures or None)


# fault: why the answer that this thread is reading must not be used. Functions called meanwhile must not
# raise: omniORB does not expect it.
_seen = threading.local()


@functools.lru_cache(maxsize=None)
def _taker(type_id):
    """A function that makes references of an interface from their octets (see ior.py),
    nil in place of a bad one.
    """
    import omniORB
    from omniORB import CORBA, tcInternal

    typecode = tcInternal.createTypeCode((tcInternal.tv_objref, type_id, ""))

    @functools.lru_cache(maxsize=1024)  # a component is named as the owner of each of its ports
    def made(type_id, *profiles):
        data = ior.octets(type_id, profiles)
        return omniORB.cdrUnmarshal(typecode, data, 1) if data else None

    def take(type_id, profiles):
        try:
            return made(type_id, *profiles)
        except ValueError as e:
            fault(str(e))
        except CORBA.SystemException:
            fault("an unusable reference")
        return None

    return take


@functools.lru_cache(maxsize=None)
def _holder(make):
    """A function that makes a struct of its members, one of them an `any`, and checks how deep that is."""

    def hold(name, value):
        if type(value._v) is not str and not _is_shallow(value):  # almost all are texts
            fault("%s: values inside values, deeper than %d" % (printable(from_wire(name)), DEEPEST))
            value = None
        return make(name, value)

    return hold


def _is_shallow(value):
    """True for a value that is not nested too deep to be written. Does not recurse itself."""
    from omniORB import CORBA

    level = [value]
    for _ in range(DEEPEST):
        below = []  # type: list
        for part in level:
            if isinstance(part, CORBA.Any):
                below.append(part.value())
            elif isinstance(part, (list, tuple)):
                below += part
            elif hasattr(part, "__dict__") and not isinstance(part, CORBA.Object):
                below += vars(part).values()
        level = below
        if not level:
            return True
    return False
