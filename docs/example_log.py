"""An analyser of logs, as you may write it: how often each port has sent, and between which values.

`python3 docs/example_log.py FILE.mcap` reads a log of rtlog; without a file it records one on mock components
first, which `PYTHONPATH=. python3 docs/example_log.py` does in a checkout.
"""
import os
import subprocess
import sys
import tempfile
from typing import Dict, List, Tuple

from rtshell_lite import api


def summary(name: str) -> Dict[str, Tuple[int, float, float]]:
    """By port: how many values are in a log, the least and the greatest of them."""
    found: Dict[str, List[float]] = {}
    for entry in api.log(name):
        value = entry.get("value", {}).get("data")
        if isinstance(value, (int, float)):
            found.setdefault(entry["port"], []).append(value)
    return {port: (len(values), min(values), max(values)) for port, values in found.items()}


def record(name: str) -> None:
    """Record three values of a mock component."""
    from mock_components import world

    with world("two") as robot:
        command = [sys.executable, "-m", "rtshell_lite", "rtlog", "-f", name, "-i", "-e", "3"]
        command.append(robot.path("ConsoleIn0.rtc:out"))
        recording = subprocess.Popen(command)
        while not api.connections(robot.path("ConsoleIn0.rtc:out")):
            pass
        for number in (3, 1, 2):
            robot.ctl("write", "ConsoleIn0:out", number)
        recording.wait(timeout=60)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        for port, (count, least, greatest) in sorted(summary(sys.argv[1]).items()):
            print("%s: %d values, %g to %g" % (port, count, least, greatest))
    else:
        with tempfile.TemporaryDirectory() as directory:
            record(os.path.join(directory, "log.mcap"))
            print(summary(os.path.join(directory, "log.mcap")))
