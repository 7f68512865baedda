"""The worlds: which components there are, how they are connected and bound. A function each; its docstring is
its help.
"""
import os
import signal

from . import ailments, chain, components, deployment, hostile, observers, odd, orphans, wicked


def two(stage):
    """ConsoleIn0 and ConsoleOut0, not connected"""
    stage.add("ConsoleIn")
    stage.add("ConsoleOut")


def linked(stage):
    """ConsoleIn0 connected to ConsoleOut0"""
    two(stage)
    stage.connect("ConsoleIn0:out", "ConsoleOut0:in")


def console(stage):
    """ConsoleIn0, ConsoleOut0, ConsoleOut1, SequenceOutComponent0, SequenceInComponent0"""
    two(stage)
    stage.add("ConsoleOut", "ConsoleOut1")
    stage.add("SequenceOutComponent")
    stage.add("SequenceInComponent")


def services(stage):
    """MyServiceProvider0 and MyServiceConsumer0, not connected"""
    stage.add("MyServiceProvider")
    stage.add("MyServiceConsumer")


def config(stage):
    """ConfigSample0: sets default, mode0, mode1 (active), hidden __widget__ and __constraints__"""
    stage.add("ConfigSample")


def parts(stage):
    """Sensor0, Controller0, Motor0, Hokuyo_AIST0, Clusterer0, not connected"""
    for type_name in ("Sensor", "Controller", "Motor", "Hokuyo_AIST", "Clusterer"):
        stage.add(type_name)


def robot(stage):
    """the same, connected: Sensor0 > Controller0 > Motor0 > Sensor0, Hokuyo_AIST0 > Clusterer0"""
    parts(stage)
    stage.connect("Sensor0:out", "Controller0:in")
    stage.connect("Controller0:out", "Motor0:in")
    stage.connect("Motor0:out", "Sensor0:in")
    stage.connect("Hokuyo_AIST0:ranges", "Clusterer0:ranges")


def everything(stage):
    """a component of every type"""
    for type_name, spec in components.SPECS.items():
        if spec.play.initialises:
            stage.add(type_name)


def these(stage, *wanted):
    """TYPE[:NAME] …: components of your choice"""
    for one in wanted:
        type_name, _, instance_name = one.partition(":")
        stage.add(type_name, instance_name or None)


def many(stage, count=200):
    """N components Mock0, Mock1, … (default 200)"""
    for number in range(int(count)):
        stage.add("Mock", "Mock%d" % number)


def error(stage):
    """Err0 (fails once active), ErrStart0 (fails to become active), Broken0 (in Error already)"""
    stage.add("Err")
    stage.add("ErrStart")
    broken = stage.add("ConsoleIn", "Broken0")
    broken.owned[0].fail(broken.reference)


def slow(stage):
    """Slow0 (changes state after 0.8 s), Stuck0 (never), Lazy0 (context of 1 Hz)"""
    stage.add("Slow")
    stage.add("Stuck")
    stage.add("Mock", "Lazy0", rate=1.0)


def stopped(stage):
    """ConsoleIn0 with a stopped context, ConsoleOut0 with a running one"""
    stage.add("ConsoleIn", running=False)
    stage.add("ConsoleOut")


def contexts(stage):
    """Multi0 owns two contexts and takes part in that of Driver0"""
    driver = stage.add("Mock", "Driver0")
    multi = stage.add("Mock", "Multi0", contexts=2)
    driver.owned[0].add_component(multi.reference)


def composite(stage):
    """composite0 made of Sensor0, Controller0 and Motor0; it exports Sensor0.in and Motor0.out"""
    for type_name in ("Sensor", "Controller", "Motor"):
        stage.add(type_name)
    stage.add("PeriodicECSharedComposite", "composite0", arguments={
        "conf.default.members": (
            "Sensor0, Controller0, Motor0"
        ), "conf.default.exported_ports": "Sensor0.in, Motor0.out"})


def deadmember(stage):
    """composite0 made of ConsoleIn0 and of Peer0 whose process has been killed; it exports ConsoleIn0.out and
    Peer0.in
    """
    orphans.lose_member(stage, "composite0")


def fsm(stage, fate=""):
    """[FATE]: Microwave0, a state machine; it `dies` when asked for its service by id, as C++, `keeps` or
    `refuses` structures
    """
    stage.add("Microwave", fate=fate)


def observed(stage):
    """ConsoleIn0 takes OpenRTM observers, ConsoleOut0 and Microwave0 those of FSM4RTC, Motor0 loggers too,
    Mock0 none
    """
    stage.add("ConsoleIn", consumers=(observers.OBSERVER,))
    stage.add("ConsoleOut", consumers=(observers.FSM_OBSERVER,))
    stage.add("Microwave", consumers=(observers.FSM_OBSERVER,))
    stage.add("Motor", consumers=(observers.OBSERVER, observers.LOGGER))
    stage.add("Mock", consumers=())


def senders(stage, rate=1000, size=1000, *changes):
    """[RATE [SIZE [ROW=VALUE …]]]: Source0, active, sends at RATE Hz a TimedLong on `number`, SIZE octets on
    `block` (default 1000, 1000); rows of the flavours may be changed: dataflow=pull, interfaces=data_service
    """
    stage.flavour = stage.flavour.but(**dict(change.split("=") for change in changes))
    source = stage.add("Source", rate=float(rate), size=int(size))
    source.owned[0].activate_component(source.reference)


def sources(stage, count=30, rate=100, size=8):
    """[N [RATE [SIZE]]]: Source0, Source1 … (default 30), as that of `senders` (default 100, 8); they take
    OpenRTM observers
    """
    for number in range(int(count)):
        source = stage.add(
            "Source", "Source%d" % number, rate=float(rate), size=int(size), consumers=(observers.OBSERVER,)
        )
        source.owned[0].activate_component(source.reference)


def topics(stage, *interfaces):
    """[INTERFACE …]: ConsoleIn0 and ConsoleOut0 with transports that connect one port alone (default:
    fast-rtps ssm)
    """
    stage.flavour = stage.flavour.but(
        interfaces=",".join([stage.flavour.interfaces] + list(interfaces or ("fast-rtps", "ssm")))
    )
    two(stage)


def custom(stage):
    """Arm0 with ports `command` and `status`, whose type is that of mock_components/arm.py, in no standard
    IDL
    """
    stage.add(components.ARM, "Arm0")


def orphan(stage):
    """Orphan0, connected to Peer0 (`out` to `in`) whose process has been killed"""
    orphans.leave_behind(stage, "Orphan0", stage.flavour)


def fragile(stage):
    """Fragile0, the same, and get_component_profile before get_port_profile ends its process"""
    orphans.leave_behind(stage, "Fragile0", stage.flavour.but(dead_peer="die"))


def chain_of(stage, count=5, *faults):
    """[N [FAULT@NUMBER …]]: Link0, Link1, … pass values on at 50 Hz, active; one with a fault (stopped, held,
    thinned, delayed, disordered, inactive, halted, slow, cut) does not
    """
    chain.add(stage, int(count), faults)


def hung(stage, count=1):
    """N components Mock0, …, then the process stops (SIGSTOP): kill it with SIGKILL"""
    many(stage, count)
    stage.ready.append("stops")
    stage.after_ready = lambda: os.kill(os.getpid(), signal.SIGSTOP)


def zombie(stage, count=1):
    """N components Mock0, …, then the process ends and leaves the names bound"""
    many(stage, count)
    stage.ready.append("ends")
    stage.after_ready = stage.process.die


def names(stage):
    """names that are hard to print or to type, wrong objects, a loop, nested, empty and large contexts"""
    odd.bind(stage)


def cruel(stage):
    """Hostile0.rtc: every string that it reports is hostile"""
    hostile.add(stage)


def harassing(stage, only=None):
    """[NAME]: components whose every string is hostile, each in its own way, and that log, report and send it
    all the time
    """
    wicked.add(stage, only)


WORLDS = {
    world.__name__: world
    for world in (
        two,
        linked,
        console,
        services,
        config,
        parts,
        robot,
        these,
        many,
        error,
        slow,
        stopped,
        contexts,
        composite,
        deadmember,
        fsm,
        observed,
        senders,
        sources,
        topics,
        custom,
        orphan,
        fragile,
        hung,
        zombie,
        names,
    )
}
WORLDS.update(deployment.WORLDS)
WORLDS.update(ailments.WORLDS)
WORLDS.update({"all": everything, "chain": chain_of, "hostile": cruel, "wicked": harassing})
