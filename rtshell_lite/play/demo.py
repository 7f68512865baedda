"""The robot of `rtshell_lite demo`: a mobile arm, in this process and in memory alone.

All commands work on its components as on those of a robot: they are listed, activated, configured and
connected, and what is done to them changes the values that they send.
"""

import math

from rtshell_lite.corba import orb
from rtshell_lite.data import datatypes
from rtshell_lite.net import loop
from rtshell_lite.play import live, robot

NUMBER, NUMBERS, PLACE = "RTC.TimedDouble", "RTC.TimedDoubleSeq", "RTC.TimedPose2D"

# ---- what its components do ----


class Battery(live.Worker):
    """Is emptied in five minutes, and then full again."""

    category, description = "Sensor", "state of charge, percent"
    outs = {"charge": NUMBER}
    settings = {"default": {"minutes": "5"}}
    rate = 1.0
    charge = 100.0

    def step(self, seconds):
        self.charge -= seconds * 100 / (60 * max(0.1, self.setting("minutes")))
        if self.charge < 0:
            self.charge = 100.0
        self.port("charge").send(round(self.charge, 1))


class Odometry(live.Worker):
    """Drives in a circle, at the speed that comes in."""

    category, description = "Sensor", "place of the base by its wheels, metres and radians"
    ins = {"speed": NUMBER}
    outs = {"pose": PLACE}
    angle = 0.0
    RADIUS = 2.0  # metres

    def step(self, seconds):
        self.angle = live.finite(self.angle + self.value("speed") / self.RADIUS * seconds)
        x, y = self.RADIUS * math.cos(self.angle), self.RADIUS * math.sin(self.angle)
        heading = math.atan2(x, -y)
        self.port("pose").send({"data": {"position": {"x": x, "y": y}, "heading": heading}})


class Laser(live.Worker):
    """Sees a round room from where the base is."""

    category, description = "Sensor", "distances to the walls all around, metres"
    ins = {"pose": PLACE}
    outs = {"ranges": NUMBERS}
    settings = {"default": {"beams": "8", "room": "5.0"}}
    rate = 5.0

    def step(self, seconds):
        pose = self.value("pose", None)
        if pose is None:
            return
        room = self.setting("room")
        off = math.hypot(pose.position.x, pose.position.y)
        beams = max(1, min(360, int(self.setting("beams"))))
        ranges = []
        for number in range(beams):
            bearing = 2 * math.pi * number / beams
            along = off * math.cos(bearing)
            ranges.append(round(math.sqrt(max(0.0, room**2 - off**2 + along**2)) - along, 3))
        self.port("ranges").send(ranges)


class Capture:
    """The service by which others have a camera send pictures."""

    interface = "Img.CameraCaptureService"
    reference = withdraw = None

    def __init__(self, camera):
        self._camera = camera

    def take_one_frame(self):
        self._camera.left = 1

    def take_multi_frames(self, num):
        self._camera.left = num

    def start_continuous(self):
        self._camera.left = math.inf

    def stop_continuous(self):
        self._camera.left = 0

    def getProfile(self):  # noqa: N802: its name in the IDL
        intrinsic = orb.struct("Img.CameraIntrinsicParameter")([1.0, 0.0, 1.0, 0.0, 0.0], [])
        return orb.struct("Img.CameraDeviceProfile")("", "", 0, "rtshell_lite", "demo", intrinsic, [])


class Camera(live.Worker):
    """Sends pictures when its service is asked to: a bright spot that wanders."""

    category, description = "Sensor", "pictures of 16 by 12 grey points, on demand"
    outs = {"picture": "RTC.CameraImage"}
    services = {"capture": {"camera": Capture}}
    rate = 5.0
    WIDTH, HEIGHT = 16, 12
    left = 0  # pictures that it is to send
    count = 0

    def step(self, seconds):
        if not self.left > 0:
            return
        self.left -= 1
        self.count += 1
        pixels = bytearray(self.WIDTH * self.HEIGHT)
        pixels[self.count % len(pixels)] = 255
        self.port("picture").send(
            {"width": self.WIDTH, "height": self.HEIGHT, "bpp": 8, "format": "gray", "fDiv": 1.0,
             "pixels": bytes(pixels)}
        )


class Guard(live.Worker):
    """Makes the base slower near a wall, and where the battery is low."""

    category, description = "Controller", "speed of the base, metres a second"
    ins = {"ranges": NUMBERS, "charge": NUMBER}
    outs = {"speed": NUMBER}
    settings = {"default": {"cruise": "0.5"}, "careful": {"cruise": "0.1"}}
    rate = 5.0

    def step(self, seconds):
        speed = self.setting("cruise")
        if self.value("charge", 100.0) < 20 or min(self.value("ranges", []) or [9.0]) < 1.0:
            speed /= 2
        self.port("speed").send(speed)


class Planner(live.Worker):
    """Has the arm wave."""

    category, description = "Controller", "where the joints are to be, radians"
    outs = {"shoulder": NUMBER, "elbow": NUMBER, "wrist": NUMBER, "grip": NUMBER}
    settings = {"default": {"reach": "1.0", "period": "6.0"}, "small": {"reach": "0.2", "period": "6.0"}}
    time = 0.0

    def step(self, seconds):
        self.time += seconds
        phase = 2 * math.pi * self.time / max(0.1, self.setting("period"))
        for late, name in enumerate(("shoulder", "elbow", "wrist")):
            self.port(name).send(self.setting("reach") * math.sin(phase - late * math.pi / 4))
        self.port("grip").send(max(0.0, math.sin(phase)))


class Joint(live.Worker):
    """Follows its target, as fast as it may."""

    category, description = "Actuator", "a joint of the arm, radians"
    ins = {"target": NUMBER}
    outs = {"angle": NUMBER}
    settings = {"default": {"gain": "8.0"}, "gentle": {"gain": "1.0"}}
    angle = 0.0

    def step(self, seconds):
        share = min(1.0, self.setting("gain") * seconds)
        self.angle = live.finite(self.angle + (self.value("target") - self.angle) * share)
        self.port("angle").send(round(self.angle, 4))


class Gripper(live.Worker):
    """Warms up by its work: goes to Error when it is hot, and is reset when it has cooled down."""

    category, description = "Actuator", "the hand; goes to Error when it is hot"
    ins = {"target": NUMBER}
    outs = {"force": NUMBER, "temperature": NUMBER}
    settings = {"default": {"limit": "60"}}
    COOL, HOTTER, COOLER = 25.0, 0.7, 2.0  # degrees Celsius, and each second while it works and rests
    temperature = COOL

    def step(self, seconds):
        self.temperature += self.HOTTER * seconds
        if self.temperature > self.setting("limit"):
            raise live.Fault
        self.port("force").send(10 * self.value("target"))
        self.port("temperature").send(round(self.temperature, 1))

    def rest(self, seconds):
        self.temperature = max(self.COOL, self.temperature - self.COOLER * seconds)
        if self.temperature > self.COOL or self.COOL >= self.setting("limit"):
            return  # still hot, or never cool enough
        context = self.contexts[0]
        if context.state_of(self) == "Error":
            context.set_state(self, "Active")


class Tip(live.Worker):
    """Adds up where the tip of the arm is."""

    category, description = "Estimator", "place of the tip of the arm, metres"
    ins = {"shoulder": NUMBER, "elbow": NUMBER, "wrist": NUMBER}
    outs = {"tip": NUMBERS}
    LENGTHS = {"shoulder": 0.4, "elbow": 0.3, "wrist": 0.1}  # metres

    def step(self, seconds):
        bend = x = y = 0.0
        for name, length in self.LENGTHS.items():
            bend += self.value(name)
            x += length * math.cos(bend)
            y += length * math.sin(bend)
        self.port("tip").send([round(x, 4), round(y, 4)])


class Arm(live.Worker):
    """The joints as one."""

    category, description = "Composite", "the three joints"
    settings = {"default": {"members": "Shoulder0,Elbow0,Wrist0", "exported_ports": ""}}


# by what they are bound as; those of a composite are its members
COMPONENTS = {
    "base.host_cxt/Battery0.rtc": Battery, "base.host_cxt/Odometry0.rtc": Odometry,
    "base.host_cxt/Laser0.rtc": Laser, "base.host_cxt/Camera0.rtc": Camera,
    "base.host_cxt/Guard0.rtc": Guard,
    "arm.host_cxt/Planner0.rtc": Planner, "arm.host_cxt/Shoulder0.rtc": Joint,
    "arm.host_cxt/Elbow0.rtc": Joint, "arm.host_cxt/Wrist0.rtc": Joint, "arm.host_cxt/Arm0.rtc": Arm,
    "arm.host_cxt/Gripper0.rtc": Gripper, "arm.host_cxt/Tip0.rtc": Tip,
}
MEMBERS = {"Arm0": ("Shoulder0", "Elbow0", "Wrist0")}
CONNECTIONS = """
Odometry0:pose Laser0:pose
Laser0:ranges Guard0:ranges
Battery0:charge Guard0:charge
Guard0:speed Odometry0:speed
Planner0:shoulder Shoulder0:target
Planner0:elbow Elbow0:target
Planner0:wrist Wrist0:target
Planner0:grip Gripper0:target
Shoulder0:angle Tip0:shoulder
Elbow0:angle Tip0:elbow
Wrist0:angle Tip0:wrist
"""
TRY = """\
A mobile arm of {count} components works here until Ctrl-C. In another terminal:

  export RTCTREE_NAMESERVERS={address} RTCSH_CWD=/{address}

  rtls -lR                                          what there is, and in which state
  rtprint arm.host_cxt/Shoulder0.rtc:angle          what a joint sends, until Ctrl-C
  rtconf arm.host_cxt/Planner0.rtc act small        the arm waves less: look at the joint again
  rttop                                             all of it, live; q ends it
  rtdoctor                                          what is wrong: nothing, until the hand is too hot
  rtstodot --html robot.html .                      a page with the whole robot, for a browser
"""

# ---- playing it ----


async def play(port, say):
    """Play it at a TCP port, 0 for a free one, until that is cancelled; say(text) is awaited when others can
    ask. Raises Failed where the port is taken.
    """
    async with loop.Group() as tasks:
        parts = make(tasks)
        try:
            address = await parts.listen(port)
            await parts.begin()
            await say(TRY.format(count=len(parts.by_name), address=address))
            await loop.Bell().wait()
        finally:
            await loop.finish(parts.end())
            tasks.cancel()


def make(tasks):
    """The demo's robot.Robot, which works in these tasks."""
    connections = [line.split() for line in CONNECTIONS.split("\n") if line]
    return robot.Robot(tasks, datatypes.Types(), COMPONENTS, connections, MEMBERS)
