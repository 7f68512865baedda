"""How fast rtprint takes values from a port, beside a bare omniORBpy loop, and how much memory that needs.

`python3 tests/bench/ports.py [VALUES [BLOCKS]]`: TimedLongs, then blocks of 1 MB; prints a line each.
The sender is a mock whose port pushes the same bytes as fast as the receiver takes them; every value is
counted at both ends.
"""
import os
import re
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [ROOT, os.path.join(ROOT, "tests", "support")]
HERE = os.path.abspath(__file__)
MB = 1000000


def sender():
    """A world with Source0, whose ports send without a pause while they are connected; a line when a
    connection ends.
    """
    from mock_components import flavour, naming, process, values
    from mock_components.__main__ import Options
    from mock_components.stage import Stage
    here = process.Process()
    options = Options(
        context="test.host_cxt/%n.rtc",
        rate=1000.0,
        sync=True,
        contexts=1,
        running=True,
        arguments={},
        control=None,
        consumers=None,
        size=MB,
        dies=False,
    )
    stage = Stage(here, naming.Naming(here, sys.argv[2]), flavour.Flavour("cpp2"), options)
    source = stage.add("Source", size=MB)
    print("ready", flush=True)
    here.ledger.own_thread()
    block = values.typecode("TimedOctetSeq")
    import omniORB
    from mock_components.idl import RTC
    data = {"number": values.encode("TimedLong", values.make("TimedLong", 1234, True), True),
            "block": omniORB.cdrMarshal(block, RTC.TimedOctetSeq(RTC.Time(1, 2), b"\x55" * MB), True)}
    while True:
        for name in data:
            for carrier in list(source.port(name).transports.values()):
                begun = time.monotonic()
                count = 0
                while carrier._send(data[name]):
                    count += 1
                    ended = time.monotonic()
                print(name, count, ended - begun, flush=True)
                source.port(name).disconnect_all()
        time.sleep(0.01)


def bare():
    """The same loop without us: receive, unmarshal, write a line, as often as told."""
    import omniORB
    from omniORB import CORBA
    from mock_components.idl import RTC, OpenRTM, SDOPackage
    from rtshell_lite.corba import stubs
    import CosNaming
    server = sys.argv[2]
    name = sys.argv[3]
    number = int(sys.argv[4])
    orb = CORBA.ORB_init(
        ["bare", "-ORBgiopMaxMsgSize", "33554432", "-ORBendPoint", "giop:tcp:127.0.0.1:"], CORBA.ORB_ID
    )
    kind = RTC._tc_TimedLong if name == "number" else RTC._tc_TimedOctetSeq
    count = [0]

    class Receiver(stubs.skeleton("OpenRTM.InPortCdr")):
        def put(self, data):
            value = omniORB.cdrUnmarshal(kind, data, True)
            shown = value.data if name == "number" else value.data.hex()
            sys.stdout.write("[%d.%09d] %s\n" % (value.tm.sec, value.tm.nsec, shown))
            sys.stdout.flush()
            count[0] += 1
            if count[0] == number:
                os._exit(0)
            return OpenRTM.PORT_OK
    poa = orb.resolve_initial_references("RootPOA")
    poa._get_the_POAManager().activate()
    ior = orb.object_to_string(Receiver()._this())
    names = orb.string_to_object("corbaloc:iiop:1.2@%s/NameService" % server)._narrow(CosNaming.NamingContext)
    found = names.resolve(
        [CosNaming.NameComponent("test", "host_cxt"), CosNaming.NameComponent("Source0", "rtc")]
    )._narrow(RTC.RTObject)
    port = next(p for p in found.get_ports() if p.get_port_profile().name.endswith(name))
    text = [("dataflow_type", "push"), ("interface_type", "corba_cdr"), ("subscription_type", "flush"),
            ("corba_cdr.inport_ior", ior)]
    port.connect(RTC.ConnectorProfile("bare", "", [port], [
        SDOPackage.NameValue("dataport." + key, CORBA.Any(CORBA.TC_string, value)) for key, value in text]))
    time.sleep(3600)


def resident(process):
    """Megabytes of memory that a process has, twice a second until it ends, as a list."""
    found = []
    while os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None:
        with open("/proc/%d/statm" % process.pid) as file:
            found.append(int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1048576.0)
        time.sleep(0.5)
    return found


def measure(what, command, source, environment, number):
    """Run a receiver until it has shown `number` values, to nobody; print how fast it was. Returns values a
    second.
    """
    process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL)
    sizes = resident(process)
    _, process.returncode, usage = os.wait4(process.pid, 0)
    if process.returncode:
        sys.exit("%s has failed" % what)
    name, count, seconds = source.stdout.readline().split()
    rate = number / float(seconds)
    print("%s: %d sent, %d printed, %.0f a second, %.1f MB/s" % (
        what, int(count), number, rate, rate * (MB if name == b"block" else 12) / 1e6))
    print("  MB resident: %.1f at a quarter of the time, %.1f at the end, %.1f at most" % (
        sizes[len(sizes) // 4], sizes[-2:][0], usage.ru_maxrss / 1024.0), flush=True)
    return rate


def main():
    import worlds
    worlds.start_name_server()
    server = "127.0.0.1:%d" % worlds.Server.port
    environment = dict(worlds.ENVIRONMENT, RTCTREE_NAMESERVERS=server, PYTHONDONTWRITEBYTECODE="1")
    source = subprocess.Popen(
        [sys.executable, HERE, "sender", server], env=environment, stdout=subprocess.PIPE
    )
    numbers = [int(word) for word in sys.argv[1:] if re.match("[0-9]+$", word)] + [100000, 200][
        len(sys.argv) - 1 :
    ]
    try:
        source.stdout.readline()
        for name, number in zip(("number", "block"), numbers):
            if not number:
                continue
            path = "/%s/test.host_cxt/Source0.rtc:%s" % (server, name)
            rates = [
                measure(what, command, source, environment, number)
                for what, command in (
                    ("bare %s" % name, [sys.executable, HERE, "bare", server, name, str(number)]),
                    (
                        "rtprint %s" % name,
                        [
                            sys.executable,
                            os.path.join(ROOT, "bin", "rtprint"),
                            "-n",
                            str(number),
                            path,
                            "--property",
                            "dataport.subscription_type=flush",
                        ],
                    ),
                )
            ]
            print("rtprint/bare: %.2f" % (rates[1] / rates[0]))
    finally:
        source.kill()
        worlds.Server.stop()


if __name__ == "__main__":
    {"sender": sender, "bare": bare}.get(sys.argv[1] if sys.argv[1:] else "", main)()
