"""Components whose connected peer has been killed."""
import os
import subprocess
import sys

from rtshell_lite.idl_stubs.component import OpenRTM, RTC

from . import naming
from .properties import nvlist
from .stage import PUSH

PEER = "Peer0"


def leave_behind(stage, instance_name, flavour):
    """Add a component, connect it to one in another process, and kill that process; its name stays bound."""
    component = stage.add("ConsoleIn", instance_name, flavour=flavour)
    command = [sys.executable, "-m", "mock_components", "these", "ConsoleOut:" + PEER, "--context", stage.options.context,
               "--nameserver", stage.names.address]
    environment = {key: value for key, value in os.environ.items() if key != "MOCK_CONTROL"}
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment) as process:
        try:
            assert process.stdout.readline().startswith(b"ready"), "the peer did not start"
            name = stage.home() + naming.parse("%s.rtc" % PEER)
            peer = stage.names.resolve(name)._narrow(OpenRTM.DataFlowComponent)
            ports = [component.ports[0].reference, peer.get_ports()[0]]
            code, _ = component.ports[0].connect(RTC.ConnectorProfile("lost", "", ports, nvlist(PUSH)))
            assert code == RTC.RTC_OK, code
            stage.names.adopt(name)
        finally:
            process.kill()
