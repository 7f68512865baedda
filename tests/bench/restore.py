"""How fast profiles are read and systems restored. `python3 tests/bench/restore.py [SHELL COMMAND PREFIX]`;
prints a line each.
"""
import os
import resource
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [ROOT, os.path.join(ROOT, "tests", "support")]
import worlds  # noqa: E402
from rtshell_lite import files  # noqa: E402
from rtshell_lite.xmlprofile import model, rtsprofile  # noqa: E402

LOAD = """
import resource, sys, time
start = time.perf_counter()
from rtshell_lite import files
from rtshell_lite.xmlprofile import rtsprofile
profile = rtsprofile.load(files.read(sys.argv[1]), sys.argv[1])
print(time.perf_counter() - start, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024, len(profile.components),
      len(profile.data_port_connectors))
"""  # noqa: E501
PROPERTIES = (("dataport.data_type", "IDL:RTC/TimedLong:1.0"), ("dataport.dataflow_type", "push"),
              ("dataport.interface_type", "corba_cdr"), ("dataport.serializer.cdr.endian", "little,big"),
              ("dataport.subscription_type", "flush"))


def system(components, server):
    """A profile of mocks, each connected to the next two."""
    profile = model.RtsProfile(
        id="RTSystem:Me:Bench:1", creation_date="2024-01-01T00:00:00", update_date="2024-01-01T00:00:00"
    )
    for number in range(components):
        profile.components.append(
            model.Component(
                id=mocks_id(),
                path_uri="%s/test.host_cxt/Mock%d.rtc" % (server, number),
                instance_name="Mock%d" % number,
                active_configuration_set="default",
                is_required=True,
                location=model.Location(),
                data_ports=[model.DataPort(name="in"), model.DataPort(name="out")],
                configuration_sets=[model.ConfigurationSet(id="default")],
                execution_contexts=[model.ExecutionContext(id="0", kind="PERIODIC", rate=1000.0)],
            )
        )
    for number in range(components):
        for step in (1, 2):
            ends = [end(number, "out", server), end((number + step) % components, "in", server)]
            one = model.DataPortConnector(
                connector_id="c%d-%d" % (number, step),
                name="c",
                data_type="IDL:RTC/TimedLong:1.0",
                dataflow_type="push",
                interface_type="corba_cdr",
                subscription_type="flush",
                properties=[model.Property(name=name, value=value) for name, value in PROPERTIES],
            )
            one.ends = ends
            profile.data_port_connectors.append(one)
    return profile


def mocks_id():
    return "RTC:Shinji Kurihara:test:Mock:1.0"


def end(number, port, server):
    uri = "%s/test.host_cxt/Mock%d.rtc" % (server, number)
    return model.TargetPort(
        component_id=mocks_id(),
        instance_name="Mock%d" % number,
        port_name="Mock%d.%s" % (number, port),
        properties=[model.Property(name="COMPONENT_PATH_ID", value=uri)],
    )


def loading(directory):
    profile = system(1000, "localhost")
    for form in (rtsprofile.XML, rtsprofile.YAML):
        name = os.path.join(directory, "big." + form)
        files.write(name, rtsprofile.dump(profile, form))
        out = (
            subprocess.check_output([sys.executable, "-c", LOAD, name], env=worlds.ENVIRONMENT)
            .decode()
            .split()
        )
        print("load %-4s  %6.2f s  %5.1f MB  (%s components, %s connections, %.1f MB file)" % (
            form, float(out[0]), float(out[1]), out[2], out[3], os.path.getsize(name) / 1e6))


def timed(what, *words):
    start = time.perf_counter()
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(
        [sys.executable, os.path.join(ROOT, "bin", words[0])] + list(words[1:]),
        env=worlds.ENVIRONMENT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        universal_newlines=True,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    lines = done.stdout.splitlines()
    print(
        "%-20s  %6.2f s  (%.2f s of CPU, status %d, %d lines; %s)"
        % (
            what,
            time.perf_counter() - start,
            after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
            done.returncode,
            len(lines),
            lines[-1][:60] if lines else "",
        )
    )


def restoring(directory):
    worlds.start_name_server()
    world = worlds.World("many", "200")
    try:
        name = os.path.join(directory, "live.xml")
        files.write(name, rtsprofile.dump(system(200, "127.0.0.1:%d" % worlds.Server.port), rtsprofile.XML))
        for what, words in (
            ("dry run", ["rtresurrect", "--dry-run", name]),
            ("restore", ["rtresurrect", "-v", name]),
            ("restore again", ["rtresurrect", "-v", name]),
            ("check", ["rtcheck", "-s", "inactive", name]),
            ("tear down, dry run", ["rtteardown", "--dry-run", name]),
            ("tear down", ["rtteardown", "-v", name]),
        ):
            timed(what, *words)
    finally:
        world.close()
        worlds.Server.stop()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        loading(temporary)
        restoring(temporary)
