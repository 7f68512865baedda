"""The control channel: a Unix socket on which tests query a running mock, and make it misbehave; see
asking.py.
"""
import os
import signal
import socket


from . import asking, carrier, observers, values
from .idl import RTC, OpenRTM


class Commands:
    """A method per command; each returns the lines to print."""

    def __init__(self, stage):
        self.stage = stage
        self.ledger = stage.process.ledger

    def calls(self, component=None):
        return self.ledger.report(component)

    def highwater(self):
        return [str(self.ledger.highwater)]

    def reset(self):
        self.ledger.reset()

    def received(self, port, count=0):
        port = self.stage.port(port)
        with port.process.arrived:
            if not port.process.arrived.wait_for(lambda: port.received >= int(count), asking.PATIENCE):
                raise ValueError("only %d values received" % port.received)
        return ["%d %s" % (port.received, shown(port.last))]

    def waiting(self, port):
        return [str(len(self.stage.port(port).buffer.values))]

    def blocked(self, port):
        return [str(self.stage.port(port).buffer.waiting)]

    def buffer(self, port):
        found = self.stage.port(port).buffer
        return ["%d %s" % (found.length, found.policy)]

    def near_misses(self):
        return [str(self.stage.process.near_misses)]

    def times(self, port):
        return [str(len(self.stage.port(port).times))]

    def sent(self, port):
        return [str(self.stage.port(port).sent)]

    def write(self, port, number):
        port = self.stage.port(port)
        port.write(values.make(port.type_name, float(number)))

    def answer(self, port, status):
        getattr(OpenRTM, status)
        self.stage.port(port).status = status

    def refuse(self, port, code):
        getattr(RTC, code)
        self.stage.port(port).refusal = None if code == "RTC_OK" else code

    def blind(self, port):
        self.stage.port(port).is_blind = True

    def connectors(self, port):
        return [f"{p.connector_id} {p.name}" for p in list(self.stage.port(port).profiles.values())]

    def references(self, port):
        port = self.stage.port(port)
        served = [carrier.reference for carrier in list(port.transports.values()) if carrier.servant]
        return [port.process.text(reference) for reference in served]

    def forget(self, port):
        port = self.stage.port(port)
        for profile in list(port.profiles.values()):
            # of the last port of a connection: the others do not hear of it
            port.notify_disconnect(profile.connector_id)

    def state(self, component, handle=0):
        component = self.stage.components[component]
        return [
            str(component.get_context(int(handle)).get_component_state(component.reference))[: -len("_STATE")]
        ]

    def error(self, component, participant=0):
        context = self.stage.components[component].owned[0]
        for _ in range(100):
            if len(context.members) > int(participant):
                break
            carrier.sleep(0.01)  # who has been added joins at the next cycle
        context.fail(context.members[int(participant)].reference)  # the component itself comes first

    def fail(self, operation, nth=1, kind="TRANSIENT"):
        self.ledger.fail(operation, int(nth), kind)

    def delay(self, operation, seconds):
        self.ledger.delay(operation, float(seconds))

    def hang(self, component, seconds):
        self.ledger.hang(component, float(seconds))

    def log(self, component, level, name, message):
        if level not in observers.LEVELS:
            raise ValueError("no such level: " + level)
        self.stage.components[component].observers.log(level, name, message)

    def observers(self, component):
        registered = self.stage.components[component].observers.registered
        return sorted(consumer.interface_type for consumer in list(registered.values()))

    def mute(self, component, count=0):
        self.stage.components[component].observers.forget(int(count))

    def fsm(self, component, state):
        self.stage.components[component].go(state)

    def misname(self, name=None):
        self.stage.misname = name

    def forsake(self, component):
        self.stage.forsake(component)

    def port(self):
        return [self.stage.process.endpoint.rpartition(":")[2]]

    def slave(self, number, *words):
        ok, text = asking.request(self.stage.controls[int(number) - 1], words)
        if not ok:
            raise ValueError(text.rstrip("\n"))
        return text.splitlines()

    def components(self):
        return sorted(self.stage.components)

    def pid(self):
        return [str(os.getpid())]

    def stop(self):
        return lambda: os.kill(os.getpid(), signal.SIGSTOP)

    def die(self):
        return self.stage.process.die

    def exit(self):
        return self.stage.finish.set


def shown(value):
    """The data of a received value, without its time."""
    return "-" if value is None else repr(value.data)


def serve(path, commands):
    """Answer commands, one a connection, as long as the process lives."""
    forget(path)
    listener = socket.socket(socket.AF_UNIX)
    listener.bind(path)
    listener.listen(8)
    return lambda: _answer_all(listener, commands)


def forget(path):
    """Remove the socket, if it is still there."""
    try:
        os.unlink(path)
    except OSError:
        pass


def _answer_all(listener, commands):
    while True:
        try:
            connection = listener.accept()[0]
        except OSError:
            return
        commands.stage.process.thread(_answer, connection, commands)


def _answer(connection, commands):
    with connection, connection.makefile("rw") as stream:
        words = stream.readline().rstrip("\n").split("\0")
        after = None
        try:
            if words[0].startswith("_") or not callable(getattr(commands, words[0], None)):
                raise ValueError("no such command: " + words[0])
            lines = getattr(commands, words[0])(*words[1:]) or []
            if callable(lines):
                lines, after = [], lines
            stream.write("ok\n" + "".join(line + "\n" for line in lines))
        except (KeyError, IndexError, StopIteration):
            stream.write("error\nno such component or port\n")
        except (TypeError, ValueError, AttributeError) as error:
            stream.write(f"error\n{error}\n")
        stream.flush()
        connection.shutdown(socket.SHUT_WR)
    if after:
        after()
