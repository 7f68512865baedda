"""Systems as they are drawn: robots of the usual shapes, and random ones."""

import collections

from rtshell_lite.views import graph
from rtshell_lite.xmlprofile import model


def system(lines, alone=()):
    """The graph.Graph of "Source.out Target.in" lines, and of components without any."""
    return graph.of(profile(lines, alone))


def profile(lines, alone=()):
    """The RtsProfile of the same."""
    ends = [[end.split(".") for end in line.split()] for line in lines]
    names = list(collections.OrderedDict.fromkeys([name for pair in ends for name, _ in pair] + list(alone)))
    made = model.RtsProfile(components=[
        model.Component(id="RTC:" + name, path_uri="localhost/%s.rtc" % name, instance_name=name)
        for name in names
    ])
    for pair in ends:
        connector = model.DataPortConnector(connector_id="x")
        connector.ends = [
            model.TargetPort(component_id="RTC:" + name, instance_name=name, port_name=port)
            for name, port in pair
        ]
        made.data_port_connectors.append(connector)
    return made


def limb(name, joints=3):
    """Planner → controller → motors → encoders → estimator → controller."""
    yield f"{name}Planner.target {name}Controller.target"
    for joint in range(joints):
        yield f"{name}Controller.command{joint} {name}Motor{joint}.command"
        yield f"{name}Motor{joint}.shaft {name}Encoder{joint}.shaft"
        yield f"{name}Encoder{joint}.angle {name}Estimator.angle{joint}"
    yield f"{name}Estimator.pose {name}Controller.pose"


def arm():
    return system(list(limb("Arm", 6)) + [
        "Console.goal ArmPlanner.goal", "Camera.image Detector.image", "Detector.object ArmPlanner.object",
        "ArmEstimator.pose Viewer.pose", "ArmController.grip Hand.grip", "Hand.force ArmPlanner.force",
    ])


def humanoid():
    lines = []
    for name in ("LeftArm", "RightArm", "LeftLeg", "RightLeg", "Head", "Waist"):
        lines.append(f"Commander.goal {name}Planner.goal")
        lines += limb(name)
    for name in ("LeftLeg", "RightLeg", "Waist"):
        lines.append(f"{name}Estimator.pose Balancer.{name.lower()}")
    return system(lines + ["Balancer.posture Commander.posture"], ["Battery", "Clock", "Speaker"])


def mobile_base():
    return system([
        "Joystick.axes Arbiter.manual", "Planner.path Follower.path", "Follower.speed Arbiter.automatic",
        "Arbiter.speed Base.speed", "Base.odometry Localizer.odometry", "Lidar.scan Localizer.scan",
        "Lidar.scan Mapper.scan", "Lidar.scan Bumper.scan", "Bumper.stop Arbiter.stop",
        "Mapper.map Localizer.map", "Mapper.map Planner.map", "Localizer.pose Planner.pose",
        "Localizer.pose Follower.pose", "Localizer.pose Viewer.pose", "Mapper.map Viewer.map",
        "Console.goal Planner.goal", "Imu.turn Localizer.turn", "Base.battery Docker.battery",
        "Docker.goal Planner.dock",
    ])


def vision():
    lines = []
    for eye in ("Left", "Right"):
        lines += [
            f"{eye}Camera.image {eye}Rectifier.image", f"{eye}Rectifier.image {eye}Features.image",
            f"{eye}Rectifier.image Stereo.{eye.lower()}", f"{eye}Features.points Matcher.{eye.lower()}",
            f"{eye}Rectifier.image Recorder.{eye.lower()}", f"Exposure.{eye.lower()} {eye}Camera.exposure",
            f"{eye}Camera.brightness Exposure.{eye.lower()}In",
        ]
    return system(lines + [
        "Stereo.depth Segmenter.depth", "Matcher.motion Odometry.motion", "Segmenter.objects Tracker.objects",
        "Odometry.pose Tracker.pose", "Tracker.tracks Viewer.tracks", "Tracker.tracks Recorder.tracks",
        "Tracker.prediction Segmenter.prediction", "Odometry.pose Recorder.pose",
        "LeftRectifier.image Viewer.image",
    ])


def logger():
    lines = []
    for number in range(40):
        lines.append(f"Driver{number}.raw Filter{number}.raw")
        lines.append(f"Filter{number}.value Logger.value{number % 8}")
    return system(lines + ["Logger.log Disk.log"])


def ring():
    return system([f"Node{number}.out Node{(number + 1) % 24}.in" for number in range(24)])


def bus():
    lines = []
    for number in range(100):
        lines.append(f"Bus.out Device{number}.in")
        if number % 5 == 0:
            lines.append(f"Device{number}.out Bus.in")
    return system(lines)


def islands():
    lines = []
    for number in range(20):
        lines += [f"Source{number}.out Filter{number}.in", f"Filter{number}.out Sink{number}.in"]
        if number % 4 == 0:
            lines.append(f"Sink{number}.back Filter{number}.back")
    return system(lines, [f"Spare{number}" for number in range(12)])


WORLDS = [
    ("arm", arm), ("humanoid", humanoid), ("mobile base", mobile_base), ("vision", vision),
    ("logger", logger), ("ring", ring), ("bus", bus), ("islands", islands),
]


def random_system(chance, count):
    """Components mostly connected to near ones, a tenth of the connections back."""
    lines = collections.OrderedDict()
    while len(lines) < count * 1.4:
        source = chance.randrange(count)
        step = chance.choice((1, 2, 3, 4, 6, 9, 13, count // 2)) * (-1 if chance.random() < 0.1 else 1)
        target = source + step
        if 0 <= target < count:
            lines[f"C{source}.out{chance.randrange(2)} C{target}.in{chance.randrange(3)}"] = True
    return system(lines)
