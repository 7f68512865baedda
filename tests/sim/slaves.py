"""In place of mock_components/children.py: further processes of a world of mocks are programs on its host."""

import sys

import carrier
import mock_components

from mock_components.__main__ import arguments
from mock_components.idl import RTM

TICK = 0.01  # seconds between looks whether one is ready


def start(stage, words, port=""):
    """Start another process and wait until it is ready; where its own name is `manager`, it is called
    manager.1, manager.2 …
    """
    options = stage.options
    name = f"{stage.process.program.name}.{len(stage.children) + 1}"
    line = ["--context", options.context, "--flavour", stage.flavour.name, "--rate", f"{options.rate:g}"]
    line += [] if options.sync else ["--async"]
    line += ["--port", port] if port else []
    given = arguments().parse_args([*line, *words])
    stage.children.append(options.robot.start(name, stage.process.program.host, given))
    while name not in options.robot.stages:
        assert not stage.children[-1].is_over, f"did not start: {' '.join(words)}"
        carrier.sleep(TICK)


def end(stage):
    """They end with their world."""


def manager_at(process, place):
    """The manager that listens on HOST:PORT."""
    reference = process.reference(f"corbaloc:iiop:1.2@{place}/manager")
    return reference._unchecked_narrow(RTM.Manager)


sys.modules["mock_components.children"] = mock_components.children = sys.modules[__name__]
