"""What the behaviour of mocks takes from an ORB and from a machine: here omniORB, real clocks and threads.

tests/sim/carrier.py has the same names for simulated programs and our own ORB, and takes the place of this
module there, before any behaviour is imported. A behaviour imports no ORB, clock or thread of its own:
tests/unit/test_layers.py has the list of the modules that may.
"""
import os
import threading
import time
import uuid

import CosNaming  # noqa: F401
import omniORB
from omniORB import CORBA, PortableServer, any as omniany, tcInternal
from rtshell_lite.corba import stubs
from rtshell_lite.giop import descriptors

# ---- the machine ----

now = time.monotonic
wall = time.time
sleep = time.sleep
Condition = threading.Condition
Event = threading.Event
Local = threading.local
Lock = threading.Lock
PID = os.getpid()


def die():
    """End the process at once, as a crash does."""
    os._exit(1)


def unique_id(by_time):
    """A UUID as text, random or made of the time."""
    return str(uuid.uuid1() if by_time else uuid.uuid4())


# ---- exceptions ----

Raised = CORBA.Exception  # whatever a call raises
SystemException = CORBA.SystemException
Garbled = CORBA.MARSHAL  # raised by `unmarshal`


def failure(name, minor=0, may_be_done=True):
    """The system exception of that name. Raises AttributeError if there is none."""
    return getattr(CORBA, name)(minor, CORBA.COMPLETED_MAYBE if may_be_done else CORBA.COMPLETED_NO)


# ---- types and values ----

Any = CORBA.Any
to_any = omniany.to_any
typecode = tcInternal.createTypeCode  # of a descriptor, see giop/descriptors.py
TEXT = typecode((descriptors.STRING, 0))
REFERENCE = typecode((descriptors.OBJECT, "IDL:omg.org/CORBA/Object:1.0", "Object"))
NULL = CORBA.TC_null
marshal = omniORB.cdrMarshal  # (typecode, value, whether little endian)
unmarshal = omniORB.cdrUnmarshal
contents = stubs.contents
stubs.register()


def is_of(value, kind):
    """Whether an any holds a value of the kind of a typecode."""
    return value.typecode().kind() == kind.kind()


# ---- servants and references ----

skeleton = stubs.skeleton
set_timeout = omniORB.setClientCallTimeout  # (reference, milliseconds)


def servant(type_id, operations):
    """A class to derive servants of another interface from: {operation: (descriptors of what is given, of
    what is returned)}.
    """
    described = {name: (given, returned, None) for name, (given, returned) in operations.items()}
    made = type("Servant", (PortableServer.Servant,), {"_NP_RepositoryId": type_id, "_omni_op_d": described})
    setattr(made, "_omni_skeleton", made)  # omniORB aborts the process without it
    return made
