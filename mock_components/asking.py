"""Asking a running mock, over the control channel. (Without CORBA, which would take longer than the answer.)
"""
import socket
import sys

HELP = """\
calls [COMPONENT]          one `count operation` line per operation received from outside
highwater                  most calls from outside that were in flight at a time
reset                      forget calls, high-water mark, faults, delays and hangs
received COMPONENT:PORT [N]  how many values a component has read from an InPort and the last one; waits up to 60 s for N
waiting COMPONENT:PORT     how many values lie in the buffer of an InPort that nobody has read
blocked COMPONENT:PORT     how many writers wait for room in it
buffer COMPONENT:PORT      the length of that buffer, and what it does when it is full
times COMPONENT:PORT       how many different times the values had that were read from an InPort
sent COMPONENT:PORT        how many values an OutPort has written
references PORT            the object references with which it takes part in its connections
near_misses                how many connectors were removed while a publisher was using them
write COMPONENT:PORT NUMBER  let an OutPort send a value made of that number
answer COMPONENT:PORT STATUS  an InPort refuses values: BUFFER_FULL, PORT_ERROR …; PORT_OK: takes them again
refuse COMPONENT:PORT CODE  a data port refuses connections: RTC_ERROR …; RTC_OK: takes them again
connectors COMPONENT:PORT  id and name of each connection
blind COMPONENT:PORT       its connectors show nil in the place of all other ports
forget COMPONENT:PORT      let the last port of connections forget them, and the others not
state COMPONENT [HANDLE]   its state in its first context, or in another: 1000 of the composite that has taken it
error COMPONENT            put it into the Error state
fail OPERATION [N] [KIND]  the Nth next call of it ends badly: a system exception such as TRANSIENT (default),
                           COMM_FAILURE, UNKNOWN or TIMEOUT; HANG (no answer); LOST (done, but no answer);
                           DIE (the process ends)
delay OPERATION SECONDS    every call of it takes that long
hang COMPONENT SECONDS     its calls wait until so long from now; 0 lets them go
log COMPONENT LEVEL NAME MESSAGE  hand a record to its loggers, as no real component does
observers COMPONENT        the interface types of what is registered with it
mute COMPONENT [N]         it loses them, and the N next ones, too
fsm COMPONENT STATE        let a state machine change its state
misname [NAME]             a manager gives that name to all that it makes, whatever is asked for
forsake COMPONENT          it ends, but a manager goes on listing it
components                 instance names
port                       IIOP port: of a manager, corbaloc:iiop:1.2@127.0.0.1:PORT/manager
slave N COMMAND …          ask the Nth further process of a world, such as a slave manager, the same way
pid                        process id
stop                       SIGSTOP itself
die                        end at once, names left bound
exit                       end in good order, names unbound"""  # noqa: E501

PATIENCE = 60  # s for which a mock waits until values have come: on a busy machine it may be held up


def request(path, words):
    """Send one command to a running mock; returns whether it was done, and the answer."""
    with socket.socket(socket.AF_UNIX) as connection:
        try:
            connection.connect(path)
            connection.sendall(("\0".join(words) + "\n").encode())
            status, _, text = connection.makefile().read().partition("\n")
        except OSError as error:  # it may be dying just now
            return False, f"{path}: {error.strerror}\n"
    return status == "ok", text


def ask(path, words):
    """Send one command to a running mock, print the answer; returns the exit status."""
    ok, text = request(path, words)
    (sys.stdout if ok else sys.stderr).write(text)
    return 0 if ok else 1
