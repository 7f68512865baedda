"""A user's own data type, as compiled by omniidl from:

    module Arm
    {
      enum Mode { IDLE, MOVING };
      struct Joint { string name; double angle; };
      struct Status { RTC::Time tm; Mode doing; sequence<Joint> joints; };
    };
"""
import omniORB
from omniORB import tcInternal

from .idl import RTC

NAME = "Arm/Status"
MODES = omniORB.EnumItem("IDLE", 0), omniORB.EnumItem("MOVING", 1)
Mode = omniORB.Enum("IDL:Arm/Mode:1.0", MODES)


class Joint(omniORB.StructBase):
    _NP_RepositoryId = "IDL:Arm/Joint:1.0"

    def __init__(self, name, angle):
        self.name = name
        self.angle = angle


class Status(omniORB.StructBase):
    _NP_RepositoryId = "IDL:Arm/Status:1.0"

    def __init__(self, tm, doing, joints):
        self.tm = tm
        self.doing = doing
        self.joints = joints

    data = property(lambda self: (str(self.doing), [(joint.name, joint.angle) for joint in self.joints]))


def make(tm, number):
    """The value for a number."""
    return Status(
        tm, MODES[int(number) % 2], [Joint("shoulder", float(number)), Joint("elbow", number / 2.0)]
    )


_JOINT = (tcInternal.tv_struct, Joint, Joint._NP_RepositoryId, "Joint",
          "name", (tcInternal.tv_string, 0), "angle", tcInternal.tv_double)
_STATUS = (tcInternal.tv_struct, Status, Status._NP_RepositoryId, "Status", "tm", RTC._d_Time,
           "doing", (tcInternal.tv_enum, Mode._NP_RepositoryId, "Mode", Mode._items),
           "joints", (tcInternal.tv_sequence, _JOINT, 0))
TYPE_CODE = tcInternal.createTypeCode(_STATUS)
