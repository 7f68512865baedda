"""The worlds: which components there are, how they are connected and bound. A function each; its docstring is its help."""
import os
import signal
import subprocess
import sys

from rtshell_lite.idl_stubs.component import RTC

from . import components, naming
from .properties import nvlist

PUSH = [("dataport.dataflow_type", "push"), ("dataport.interface_type", "corba_cdr"),
        ("dataport.subscription_type", "flush")]


class Stage:
    """A world being set up: its process, its name server, its components."""

    def __init__(self, process, names, flavour, options):
        self.process = process
        self.names = names
        self.flavour = flavour
        self.options = options
        self.components = {}
        self.after_ready = None         # called once `ready` has been printed

    def add(self, type_name, instance_name=None, bind=True, **changes):
        """Start a component, and bind it under the names that its naming.formats give."""
        spec = changes.pop("spec", None) or components.SPECS[type_name]
        flavour = changes.pop("flavour", self.flavour)
        options = self.options.but(**changes)
        instance_name = instance_name or type_name + "0"
        component = spec.play(self.process, spec, instance_name, flavour, options)
        component.ended = self._ended
        self.components[instance_name] = component
        if bind:
            for name in component.names:
                self.names.bind(naming.parse(name), component.reference)
        return component

    def connect(self, one, other, name=None, pairs=PUSH):
        """Connect two ports, written `Instance:port`."""
        ports = [self.port(one), self.port(other)]
        profile = RTC.ConnectorProfile(name or "_".join(port.short_name for port in ports), "",
                                       [port.reference for port in ports], nvlist(pairs))
        code, _ = ports[0].connect(profile)
        assert code == RTC.RTC_OK, (one, other, code)

    def port(self, text):
        instance_name, _, port = text.rpartition(":")
        return self.components[instance_name].port(port)

    def _ended(self, component, linger):
        import threading
        self.components.pop(component.instance_name, None)
        unbind = threading.Timer(linger, lambda: [self.names.unbind(naming.parse(name)) for name in component.names])
        unbind.daemon = True
        unbind.start()


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


def many(stage, count=200):
    """N components Mock0, Mock1, … (default 200)"""
    for number in range(int(count)):
        stage.add("Mock", "Mock%d" % number)


WORLDS = {world.__name__: world for world in (two, linked, console, services, config, many)}
