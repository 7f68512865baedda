"""The alphabet of faults. Each is a function of a Robot and the word that it concerns; a line in FAULTS says
what kind of word.
"""

import world as worlds

from mock_components.port import RTC

LONG = 5.0  # seconds that something lasts which ends by itself
SLOW = 0.3
MTU = 300  # octets, of a packet that still comes through
LATE = 1.7
WAVES = 50
FOR_EVER = 1e9
BY_HAND = " by hand"  # after the name of a process that an rtkeep keeps, of one that a person has started
RARE = 0.1  # Hz of a context whose period is longer than people wait


def kill(robot, process):
    """A process is killed; its names stay."""
    robot.programs[process].kill()


def hang(robot, process):
    """A process is stopped: its kernel accepts, nobody answers."""
    robot.programs[process].stop()


def pause(robot, process):
    """A process is stopped for a while."""
    program = robot.programs[process]
    program.stop()
    robot.world.at(LONG, program.go_on)


def lag(robot, process):
    """All answers of a process come late, after others have given up."""
    robot.programs[process].lag = LATE


def garble(robot, process):
    """A process answers with what is no GIOP."""
    robot.programs[process].spoil = lambda data: bytes(len(data))


def tear(robot, process):
    """A process answers with half a message, and then not at all."""
    robot.programs[process].spoil = lambda data: data[: len(data) // 2]


def break_off(robot, process):
    """A process closes each connection instead of answering."""
    robot.programs[process].spoil = lambda data: b""


def restart(robot, process):
    """A process is killed, and started again under the same names."""
    robot.programs[process].kill()
    robot.world.at(0.5, robot.start_again, process)


def error(robot, component):
    """A component goes to Error."""
    robot.ask(component, lambda found: found.fail())


def halt(robot, component):
    """A context is stopped."""
    robot.ask(component, lambda found: found.owned[0].stop())


def slow_down(robot, component):
    """A context runs a cycle in ten seconds from now on."""
    robot.ask(component, lambda found: found.owned[0].set_rate(RARE))


def forget(robot, component):
    """The in port of a component forgets its connectors: those that are joined with it do not hear of it."""

    def lose(found):
        for port in found.ports[:1]:
            for connector_id in list(port.profiles):
                del port.profiles[connector_id]
                port.release(connector_id)

    robot.ask(component, lose)


def leave(robot, component):
    """A component leaves the composites that it is a member of."""
    robot.ask(component, lambda found: found._leave_organizations())


def take(robot, component):
    """Somebody has a component executed by the context of another one of its process, too."""

    def add(found):
        others = [each for each in found.process.components.values() if each is not found]
        if others:
            others[0].owned[0].add_component(found.reference)

    robot.ask(component, add)


def waver(robot, component):
    """A component changes to and fro while it is asked."""
    for number in range(WAVES):
        set_id = ("other", "default")[number % 2]
        robot.world.at(
            number * LONG / WAVES,
            robot.ask,
            component,
            lambda found, set_id=set_id: found.configuration.activate_configuration_set(set_id),
        )


def refuse(robot, component):
    """The ports of a component refuse whoever wants to connect or disconnect something."""

    def close(found):
        for port in found.ports:
            port.refusal = "RTC_ERROR"
            port.disconnect = port.notify_disconnect = lambda connector_id: RTC.RTC_ERROR
            port.disconnect_all = lambda: None
            port._dead_connections = list  # it looks for none, which it could not remove

    robot.ask(component, close)


def seize(robot, component):
    """A component does not answer any more, while others of its process do."""
    robot.seized[component] = robot.world.time
    robot.ask(component, lambda found: found.process.ledger.hang(component, FOR_EVER))


def tire(robot, process):
    """A process closes connections that have been used, as ORBs do to have few: what is asked by one of them
    at that moment is not begun, and it says so.
    """
    robot.programs[process].closes_often = True


def doubt_names(robot, host):
    """One of two servers that a host asks for the addresses of names does not answer: every other look-up
    takes long.
    """
    robot.world.hosts[host].has_doubts = True


def cut(robot, host):
    """Nothing reaches a host any more, or leaves it."""
    robot.world.rules.append(lambda one, other, *_: _is_cut(one, other, host))


def _is_cut(one, other, host):
    if one is not other and host in (one.name, other.name):
        return worlds.DROP
    return None


def unplug(robot, host):
    """A host is cut off for a while."""

    def rule(one, other, *_):
        return _is_cut(one, other, host)

    robot.world.rules.append(rule)
    robot.world.at(LONG, robot.world.rules.remove, rule)


def close_port(robot, process):
    """A firewall rejects connections from elsewhere to the port of a process."""
    _filter(robot, process, worlds.REJECT)


def shut_port(robot, process):
    """A firewall drops what comes from elsewhere to the port of a process."""
    _filter(robot, process, worlds.DROP)


def _filter(robot, process, verdict):
    home = robot.programs[process].host
    wanted = {port for port, each in home.listeners.items() if each.program is robot.programs[process]}

    def rule(one, other, port, size):
        return verdict if other is home and one is not home and port in wanted else None

    robot.world.rules.append(rule)


def lose_one_way(robot, host):
    """Nothing that a host sends reaches others any more; what they send reaches it."""

    def rule(one, other, *_):
        return worlds.DROP if one.name == host and other is not one else None

    robot.world.rules.append(rule)


def shrink_packets(robot, host):
    """Long packets of a host get lost, as in a tunnel whose MTU nobody is told."""

    def rule(one, other, port, size):
        return worlds.DROP if one.name == host and other is not one and size > MTU else None

    robot.world.rules.append(rule)


def hide(robot, host):
    """A host is behind a NAT: it can reach others, which cannot connect with it."""

    def rule(one, other, port, size):
        is_from_outside = other.name == host and other is not one
        return worlds.DROP if is_from_outside and size == worlds.BEGIN_OF_ONE else None

    robot.world.rules.append(rule)


def reboot(robot, host):
    """A host loses its power; when it is back, its processes are started again, and connections half open."""
    home = robot.world.hosts[host]
    home.lose_power()
    robot.world.at(LONG, robot.start_host_again, home)


def slow_network(robot, host):
    """Each packet from or to a host takes longer."""
    robot.world.delays[host] = SLOW


def no_names(robot, _):
    """The name server is killed."""
    robot.names.kill()


def empty_names(robot, _):
    """The name server is killed, and is back without a name."""
    robot.names.kill()
    robot.world.at(0.5, _new_names, robot)


def _new_names(robot):
    robot.names = robot.start_names()


def lose_power(robot, host):
    """A host loses its power, for good."""
    robot.world.hosts[host].lose_power()


def fill_disk(robot, host):
    """The disk on which people work is nearly full, for a while."""
    disk = robot.world.hosts[host].disk
    disk.room = robot.world.random.randrange(5000)
    robot.world.at(LONG, disk.__setattr__, "room", None)


def break_disk(robot, host):
    """Nothing can be written to the disk on which people work, for a while."""
    disk = robot.world.hosts[host].disk
    disk.is_failing = True
    robot.world.at(LONG, disk.__setattr__, "is_failing", False)


def lose_power_in_writing(robot, host):
    """The host on which people work loses its power while something is written."""
    robot.world.hosts[host].disk.steps = robot.world.random.randrange(1, 12)


def wrong_clock(robot, host):
    """The clock of a host is set: an hour ahead, or back."""
    robot.world.hosts[host].ahead += robot.world.random.choice((3600, -3600))


def start_by_hand(robot, process):
    """Somebody starts what an rtkeep keeps."""
    host, flavour, component = robot.kept[process]
    robot.start(process + BY_HAND, host, flavour, [component])


# each fault, what it concerns, and whether a doctor who looks after it has to find something
FAULTS = {
    kill: ("process", True),
    hang: ("process", True),
    pause: ("process", False),
    lag: ("process", True),
    garble: ("process", True),
    tear: ("process", True),
    break_off: ("process", True),
    restart: ("process", False),
    error: ("component", True),
    halt: ("component", False),
    slow_down: ("component", False),
    forget: ("component", False),
    leave: ("component", False),
    take: ("component", False),
    waver: ("component", False),
    refuse: ("component", False),
    seize: ("component", True),
    tire: ("process", False),
    doubt_names: ("seat", False),
    cut: ("host", False),
    unplug: ("host", False),
    close_port: ("process", False),
    shut_port: ("process", False),
    lose_one_way: ("host", False),
    shrink_packets: ("host", False),
    hide: ("host", False),
    reboot: ("host", False),
    slow_network: ("host", False),
    no_names: ("names", True),
    empty_names: ("names", True),
    wrong_clock: ("host", False),
    lose_power: ("host", False),
    lose_power_in_writing: ("seat", False),
    fill_disk: ("seat", False),
    break_disk: ("seat", False),
}
# what people type who see it; {} is a component that it concerns
ANSWERS = {
    error: ("rtreset --wait 3 {}", "rtact --wait 3 {}", "rtls -l", "rtcat -l {}"),
    halt: ("rtact --wait 3 {}", "rtdeact --wait 3 {}", "rtreset --wait 3 {}", "rtls -l"),
    slow_down: ("rtact --wait 3 {}", "rtdeact --wait 3 {}", "rtcat -l {}"),
    close_port: ("rtdel -z .", "rtdel -z {}", "rtls -l", "rtdoctor -q"),
    kill: ("rtdel -z .", "rtls -l", "rtdoctor -q", "rtcat {}", "rtls"),
    pause: ("rttop --json -n 16 -r 1", "rtls -l"),
    seize: ("rtls -l", *(f"{name} robot.rtsys" for name in ("rtstart", "rtstop", "rtresurrect", "rtcheck"))),
    refuse: ("rtdis {}", "rtdis {}:out", "rtdis {}:in", "rtteardown robot.rtsys"),
    tire: (
        "rtact --wait 3 {}", "rtdeact --wait 3 {}", "rtstop robot.rtsys",
        "rtconf {} set gain 5", "rtdis {}:out",
    ),
    doubt_names: ("rtls -l", "rtprint -t 1 {}:out", "rtdoctor -q", "rtwatch -t 3 {}"),
    hang: ("rtls -l", "rtdoctor -q", "rtact --wait 3 {}", "rtdel -z {}"),
}
BY_NAME = {fault.__name__: fault for fault in FAULTS}
OF_PROCESSES = {"start_by_hand": start_by_hand}  # which an rtkeep keeps
OF_NETWORK = {"cut", "unplug", "slow_network", "close_port", "shut_port", "lose_one_way", "shrink_packets"}
OF_NETWORK |= {"hide", "reboot", "lose_power", "lose_power_in_writing", "doubt_names"}
HARMLESS = {"tire"}  # nobody is to notice


def named(name):
    """The function of a fault."""
    return BY_NAME.get(name) or OF_PROCESSES[name]
