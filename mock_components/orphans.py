"""Components whose connected peer has been killed, and composites with a killed member."""
import contextlib

from . import children, naming
from .idl import RTC, OpenRTM
from .properties import nvlist
from .stage import PUSH

PEER = "Peer0"


@contextlib.contextmanager
def doomed(stage):
    """A ConsoleOut in another process, which is killed in the end; its name stays bound."""
    import subprocess
    command = children.command(stage, ["these", "ConsoleOut:" + PEER])
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=children.environment()
    ) as process:
        try:
            assert process.stdout.readline().startswith(b"ready"), "the peer did not start"
            name = stage.home() + naming.parse(f"{PEER}.rtc")
            yield stage.names.resolve(name)._narrow(OpenRTM.DataFlowComponent)
            stage.names.adopt(name)
        finally:
            process.kill()


def leave_behind(stage, instance_name, flavour):
    """Add a component and connect it to the one that dies."""
    component = stage.add("ConsoleIn", instance_name, flavour=flavour)
    with doomed(stage) as peer:
        ports = [component.ports[0].reference, peer.get_ports()[0]]
        code, _ = component.ports[0].connect(RTC.ConnectorProfile("lost", "", ports, nvlist(PUSH)))
        assert code == RTC.RTC_OK, code


def lose_member(stage, instance_name):
    """Add a composite of a component that lives and the one that dies."""
    alive = stage.add("ConsoleIn")
    composite = stage.add("PeriodicECSharedComposite", instance_name, arguments={
        "conf.default.exported_ports": f"ConsoleIn0.out,{PEER}.in"})
    with doomed(stage) as peer:
        composite.organization.add_members([alive.reference, peer])
