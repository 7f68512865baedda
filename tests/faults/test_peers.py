"""Every command against every kind of broken peer: one calm line, in time, and no more memory than it needs."""
import os
import re
import unittest

import invocations
from faults import running
from mock_components import faulty

ONCE = "how long a peer is waited for does not depend on the Python"

try:
    import omniORB  # noqa: F401: the commands need it
except ImportError:
    raise unittest.SkipTest("needs omniORBpy")

MODES = sorted(set(faulty.MODES) | set(faulty.UNREACHABLE))
ANSWERING = {"hostile", "many", "loop", "bottomless"}  # as a name server these answer, if strangely


def setUpModule():
    global around, server, text, log, ports
    around = running.Surroundings()
    server = around.name_server()
    around.world(server, "linked")
    text, log = around.files(server)
    ports = around.faulty(*MODES)
    around.bind(server + "/faulty.host_cxt", *MODES)


def tearDownModule():
    around.close()


def places(mode, number, top, a, b, manager):
    """What the words of the tables stand for."""
    return {"SERVER": top, "A": a, "B": b, "MGR": manager, "OUT": "out", "LOG": log,
            "FILE": around.profile(text, "%s-%d.yaml" % (mode, number), server, a, b)}


def as_server(number, command, line, mode):
    top = "/127.0.0.1:%d" % ports[mode]
    return run(number, command, line, places(mode, number, top, top + "/a.rtc", top + "/b.rtc", top + "/m.mgr"), top[1:])


def as_component(number, command, line, mode):
    top, home = server + "/faulty.host_cxt", server + "/test.host_cxt"
    a = "%s/%s.rtc" % (top, mode)
    return run(number, command, line, places(mode, number, top, a, home + "/ConsoleOut0.rtc", a), server[1:])


def run(number, command, line, meant, servers):
    where = around.directory("run%d" % number)
    return running.run([command] + invocations.words(line, meant) + ["--timeout", str(running.TIMEOUT)], where,
                       RTCTREE_NAMESERVERS=servers)


class Peers(unittest.TestCase):
    pass
