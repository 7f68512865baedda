"""Worlds with managers: a master, bound as manager.mgr, and slaves in processes of their own, bound nowhere.
"""
from . import children, modules
from .flavour import Flavour
from .manager import Manager


def master(stage, *slaves):
    """A manager with slaves, each given as a list of what it is to create; C++ 1.1 creates that in the
    master.
    """
    lead(stage)
    if stage.flavour.creates_here:
        populate(stage, [line for lines in slaves for line in lines])
        return
    for lines in slaves:
        children.start(stage, ["slave", stage.process.endpoint, "manager"] + list(lines))


def lead(stage):
    """Become a master."""
    Manager(stage)
    stage.ready.append(str(port(stage)))


def port(stage):
    """The IIOP port of this process."""
    return int(stage.process.endpoint.rpartition(":")[2])


def populate(stage, lines):
    """Create components, their modules loaded first; a line is what create_component takes."""
    for line in lines:
        name = line.partition("?")[0]
        stage.manager.modules.load(name + modules.SUFFIXES[stage.flavour.language], name + "Init")
        assert stage.manager.create(line), "cannot create " + line


def manager(stage, *lines):
    """[TYPE[?KEY=VALUE&…] …]: a master and one slave with ConsoleIn0 and ConsoleOut0, or with what is given
    """
    master(stage, lines or ["ConsoleIn", "ConsoleOut"])


def managers(stage):
    """a master and two slaves of the same name: one with ConsoleIn0, one with ConsoleOut0"""
    master(stage, ["ConsoleIn"], ["ConsoleOut"])


def twonames(stage):
    """a master with ConsoleIn0 in its slave, bound by two names: manager.mgr and second.mgr"""
    master(stage, ["ConsoleIn"])
    stage.names.bind(stage.home() + [("second", "mgr")], stage.manager.reference)


def manager11(stage):
    """a master of C++ 1.1, which creates components itself: ConsoleIn0 and ConsoleOut0"""
    stage.flavour = Flavour("cpp11")
    master(stage, ["ConsoleIn", "ConsoleOut"])


def deadslave(stage):
    """the two slaves again, but the second has been killed, and ConsoleOut0 with it; the master forgets it
    when it asks it
    """
    managers(stage)
    stage.children[1].kill()
    stage.children[1].wait()
    stage.names.adopt(stage.home() + [("ConsoleOut0", "rtc")])


def deadchild(stage):
    """a master and one slave with ConsoleIn0, and with ConsoleOut0 which has ended but is still listed"""
    lead(stage)
    children.start(stage, ["halfdead", stage.process.endpoint])


def halfdead(stage, place):
    """HOST:PORT: that slave"""
    slave(stage, place, "manager", "ConsoleIn", "ConsoleOut")
    stage.forsake("ConsoleOut0")


def slave(stage, place, name="manager", *lines):
    """HOST:PORT [NAME [TYPE[?KEY=VALUE&…] …]]: a slave of the master at that address"""
    here = Manager(stage, name, master=False)
    stage.ready.append(str(port(stage)))
    populate(stage, lines)
    here.join(children.manager_at(stage.process, place))


WORLDS = {
    world.__name__: world
    for world in (manager, managers, twonames, manager11, deadslave, deadchild, halfdead, slave)
}
