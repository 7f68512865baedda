"""Worlds of mock components for unittest modules, and short ways to call what is in them."""
import glob
import os
import shutil
import time
import unittest

import processes

try:
    import omniORB
    from omniORB import CORBA, any as omniany
    import CosNaming
except ImportError:
    omniORB = None
else:
    from mock_components.idl import RTC, OpenRTM, SDOPackage

LIMIT = 180.0  # seconds that anything may take on a busy machine
LONG = "IDL:RTC/TimedLong:1.0"
COMMANDS = os.path.dirname(shutil.which("rtcwd") or os.path.join(processes.ROOT, "bin", "rtcwd"))
ENVIRONMENT = dict(os.environ, PYTHONPATH=os.environ.get("PYTHONPATH") or processes.ROOT)


def eventually(condition, what):
    """Wait until a condition holds; returns its value."""
    end = time.monotonic() + LIMIT
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > end:
            raise AssertionError("not within %g s: %s" % (LIMIT, what))
        time.sleep(0.01)


class Server:
    """omniNames for the whole module, and this process's ORB."""
    NAME = "names"

    @classmethod
    def start(cls):
        cls.directory = processes.open_session()
        cls.orb = CORBA.ORB_init(
            ["test", "-ORBclientCallTimeOutPeriod", "8000", "-ORBtraceLevel", "0"], CORBA.ORB_ID
        )
        cls.port = int(processes.start_name_server(cls.NAME))
        cls.root = cls.orb.string_to_object("corbaloc:iiop:1.2@127.0.0.1:%d/NameService" % cls.port)
        cls.root = cls.root._unchecked_narrow(CosNaming.NamingContext)

    @classmethod
    def stop(cls):
        processes.close_session(cls.directory)

    @classmethod
    def start_again(cls):
        """Start it again after it was killed, without the names that it had."""
        for file in glob.glob(os.path.join(cls.directory, cls.NAME + "-*", "*")):
            os.remove(file)
        processes.start_again(cls.NAME)
        eventually(lambda: processes.nameserver.answers(cls.port), "the name server")


def start_name_server():
    """For setUpModule: start a name server, or skip all tests without omniORB."""
    if omniORB is None or not processes.nameserver.binary():
        raise unittest.SkipTest("needs omniORBpy and omniNames")
    Server.start()


class World:
    """A world in a process of its own, and the objects bound by it."""

    def __init__(self, *words):
        self.name = processes.start_world(list(words), str(Server.port))
        self.process = processes.find(self.name)
        self.ready = processes.ready(self.name)

    def close(self):
        processes.end(self.name)

    def resolve(self, *names):
        parts = [CosNaming.NameComponent("test", "host_cxt")]
        for name in names:
            parts.append(CosNaming.NameComponent(*name.rsplit(".", 1)))
        return Server.root.resolve(parts)

    def component(self, name):
        return self.resolve(name + ".rtc")._narrow(OpenRTM.DataFlowComponent)

    def port(self, component, name):
        for port in self.component(component).get_ports():
            if port.get_port_profile().name.split(".")[-1] == name:
                return port
        raise AssertionError("no port " + name)

    def context(self, component):
        return self.component(component).get_owned_contexts()[0]

    def ctl(self, *words):
        """Ask the world; returns its answer. Raises processes.Failed."""
        return processes.ctl(self.name, *words)

    def count(self, operation):
        lines = [line.split() for line in self.ctl("calls").splitlines()]
        return {name: int(count) for count, name in lines}.get(operation, 0)


def nvlist(**changes):
    """Connector properties, written with _ for dots after `dataport`; None leaves one out."""
    values = {"dataflow_type": "push", "interface_type": "corba_cdr", "subscription_type": "flush",
              "data_type": LONG}
    values.update(changes)
    return [SDOPackage.NameValue("dataport." + name.replace("__", "."), omniany.to_any(value))
            for name, value in values.items() if value is not None]


def connector(ports, connector_id="", **changes):
    return RTC.ConnectorProfile("n", connector_id, ports, nvlist(**changes))
