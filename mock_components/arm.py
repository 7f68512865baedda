"""A user's own data type, as compiled by omniidl from:

    module Arm
    {
      enum Mode { IDLE, MOVING };
      struct Joint { string name; double angle; };
      struct Status { RTC::Time tm; Mode doing; sequence<Joint> joints; };
    };
"""
from rtshell_lite.giop import descriptors, idl

from . import carrier

NAME = "Arm/Status"
_MODE = descriptors.enum("IDL:Arm/Mode:1.0", "Mode", ("IDLE", "MOVING"))
_JOINT = descriptors.struct(
    "IDL:Arm/Joint:1.0", "Joint", [("name", (descriptors.STRING, 0)), ("angle", descriptors.DOUBLE)]
)
_STATUS = descriptors.struct(
    "IDL:Arm/Status:1.0",
    "Status",
    [
        ("tm", idl.known("IDL:RTC/Time:1.0")),
        ("doing", _MODE),
        ("joints", (descriptors.SEQUENCE, _JOINT, 0)),
    ],
)
TYPE_CODE = carrier.typecode(_STATUS)
Joint = descriptors.factory(_JOINT)
Status = descriptors.factory(_STATUS)
Status.data = property(lambda self: (str(self.doing), [(joint.name, joint.angle) for joint in self.joints]))


def make(tm, number):
    """The value for a number."""
    mode = descriptors.items(_MODE)[int(number) % 2]
    return Status(tm, mode, [Joint("shoulder", float(number)), Joint("elbow", number / 2.0)])
