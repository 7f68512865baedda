"""A launch script, as you may write it: create what is missing, connect, activate, watch, and stop in the
end.

`PYTHONPATH=. python3 docs/example_launch.py` runs it in a checkout, on mock components.
"""
from contextlib import closing
from typing import List

from mock_components import world

from rtshell_lite import api


def launch(home: str, manager: str) -> List[str]:
    """Start a motor and what sees it; returns the paths of the components, the last one to be
    started first.
    """
    made = api.manager(manager).create("Motor", instance_name="arm")
    source = api.component(home + "ConsoleIn0.rtc", wait=30)
    sink = api.component(home + "ConsoleOut0.rtc", wait=30)
    if not api.connections(source.path + ":out"):
        api.connect(source.path + ":out", sink.path + ":in", subscription_type="flush")
    for component in (sink, source, made):
        component.activate(wait=10)
    return [made.path, source.path, sink.path]


def stop(paths: List[str]) -> None:
    """Stop the components at these paths, in this order; what has ended by itself is no failure."""
    for path in paths:
        try:
            api.component(path).deactivate(wait=10)
        except api.Error as e:
            print("%s: %s" % (e.where, e.why))


if __name__ == "__main__":
    with world("managers") as robot:
        home = robot.home if robot.home.endswith("/") else robot.home + "/"
        running = launch(home, home + "manager.mgr")
        try:
            print(", ".join(component.state for component in map(api.component, running)))
            with closing(api.watch(running[1], timeout=0.5)) as happening:
                print(next(happening))
        finally:
            stop(running)
        assert api.component(running[0]).state == "Inactive"
