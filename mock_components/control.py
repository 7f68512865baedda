"""The control channel: a Unix socket on which tests ask a running mock what it has seen, and tell it to misbehave."""
import os
import signal
import socket
import sys

from rtshell_lite.idl_stubs.component import RTC
from rtshell_lite.idl_stubs.dataport import OpenRTM

from . import observers, values

HELP = """\
calls [COMPONENT]          one `count operation` line per operation received from outside
highwater                  most calls from outside that were in flight at a time
reset                      forget calls, high-water mark, faults, delays and hangs
received COMPONENT:PORT [N]  how many values an InPort has got and the last one; waits up to 10 s for N
sent COMPONENT:PORT        how many values an OutPort has written
write COMPONENT:PORT NUMBER  let an OutPort send a value made of that number
answer COMPONENT:PORT STATUS  an InPort refuses values: BUFFER_FULL, PORT_ERROR …; PORT_OK: takes them again
refuse COMPONENT:PORT CODE  a data port refuses connections: RTC_ERROR …; RTC_OK: takes them again
connectors COMPONENT:PORT  id and name of each connection
forget COMPONENT:PORT      let the last port of connections forget them, and the others not
state COMPONENT [HANDLE]   its state in its first context, or in another: 1000 of the composite that has taken it
error COMPONENT            put it into the Error state
fail OPERATION [N] [KIND]  the Nth next call of it ends badly: a system exception such as TRANSIENT (default),
                           COMM_FAILURE, UNKNOWN or TIMEOUT; HANG (no answer); DIE (the process ends)
delay OPERATION SECONDS    every call of it takes that long
hang COMPONENT SECONDS     its calls wait until so long from now; 0 lets them go
log COMPONENT LEVEL NAME MESSAGE  hand a record to its loggers, as no real component does
observers COMPONENT        the interface types of what is registered with it
mute COMPONENT [N]         it loses them, and the N next ones, too
fsm COMPONENT STATE        let a state machine change its state
forsake COMPONENT          it ends, but a manager goes on listing it
components                 instance names
port                       IIOP port: of a manager, corbaloc:iiop:1.2@127.0.0.1:PORT/manager
slave N COMMAND …          ask the Nth further process of a world, such as a slave manager, the same way
pid                        process id
stop                       SIGSTOP itself
die                        end at once, names left bound
exit                       end in good order, names unbound"""


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
            if not port.process.arrived.wait_for(lambda: port.received >= int(count), 10):
                raise ValueError("only %d values received" % port.received)
        return ["%d %s" % (port.received, shown(port.last))]

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

    def connectors(self, port):
        return ["%s %s" % (p.connector_id, p.name) for p in list(self.stage.port(port).profiles.values())]

    def forget(self, port):
        port = self.stage.port(port)
        for profile in list(port.profiles.values()):
            port.notify_disconnect(profile.connector_id)  # of the last port of a connection: the others do not hear of it

    def state(self, component, handle=0):
        component = self.stage.components[component]
        return [str(component.get_context(int(handle)).get_component_state(component.reference))[:-len("_STATE")]]

    def error(self, component):
        component = self.stage.components[component]
        component.owned[0].fail(component.reference)

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

    def forsake(self, component):
        self.stage.forsake(component)

    def port(self):
        return [self.stage.process.endpoint.rpartition(":")[2]]

    def slave(self, number, *words):
        ok, text = request(self.stage.controls[int(number) - 1], words)
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
    """Answer commands, one a connection, for as long as the process lives."""
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
            stream.write("error\n%s\n" % error)
        stream.flush()
        connection.shutdown(socket.SHUT_WR)
    if after:
        after()


def request(path, words):
    """Send one command to a running mock; returns whether it was done, and the answer."""
    with socket.socket(socket.AF_UNIX) as connection:
        try:
            connection.connect(path)
        except OSError as error:
            return False, "%s: %s\n" % (path, error.strerror)
        connection.sendall(("\0".join(words) + "\n").encode())
        status, _, text = connection.makefile().read().partition("\n")
    return status == "ok", text


def ask(path, words):
    """Send one command to a running mock, print the answer; returns the exit status."""
    ok, text = request(path, words)
    (sys.stdout if ok else sys.stderr).write(text)
    return 0 if ok else 1
