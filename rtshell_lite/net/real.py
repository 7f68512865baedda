"""The world as it is: the clocks, the network, the threads, signals, processes and files of this computer.

A Loop has a world, this module or an object with the same names: tests put a simulated one in its place.
"""

# which `signal` and `socket` are made of: those take long to import
import _signal
import _socket
import os
import select
import struct
import time

from rtshell_lite import errors


def _if_there(*names):
    """The numbers of signals, None for those that this system lacks."""
    return [getattr(_signal, name, None) for name in names]


now = time.monotonic  # seconds by a clock that is never set
wall = time.time  # seconds since 1970
Stream = _socket.socket  # what `stream` makes
octets = os.urandom  # octets(number) that nobody can guess
NoSuchHost = _socket.gaierror
AT_ONCE = _socket.MSG_DONTWAIT  # flags of `recv` and `send`
PEEK = _socket.MSG_PEEK
NUMERIC = _socket.AI_NUMERICHOST  # a flag of `resolve`: an address, not a name
SENDING = _socket.SHUT_WR  # what `shutdown` ends
ALL = _socket.SHUT_RDWR
LISTEN = 128  # connections that wait to be accepted
# of Linux
SIOCGIFADDR = 0x8915
SIOCGIFNETMASK = 0x891B
FUSE = "/dev/fuse"
MOUNTS = "/proc/self/mountinfo"

SIGINT = _signal.SIGINT
SIGTERM = _signal.SIGTERM
SIGHUP, SIGKILL, SIGCHLD, SIGCONT, SIGSTOP, SIGTSTP, SIGUSR1, SIGWINCH = _if_there(
    "SIGHUP", "SIGKILL", "SIGCHLD", "SIGCONT", "SIGSTOP", "SIGTSTP", "SIGUSR1", "SIGWINCH"
)
IGNORED = _signal.SIG_IGN
DEFAULT = _signal.SIG_DFL
interrupt = _signal.default_int_handler  # the handler that raises KeyboardInterrupt
handler = _signal.getsignal  # handler(number): of a signal, or IGNORED, DEFAULT
handle = _signal.signal  # handle(number, handler), on the main thread
# of subprocess, which takes long to import: what a process reads or writes
PIPE = -1
SAME = -2  # stderr: as stdout
NOTHING = -3
own_pid = os.getpid
own_user = getattr(os, "geteuid", None)  # some systems have no users
file = open  # file(descriptor, mode, buffering) of one that is to be written

looking_up = {}  # type: dict  # {host: hosts.LookUp} that a thread is asking for


# ---- waiting ----


class Epoll:
    """As select.poll, on Linux, where its cost does not grow with the number of descriptors: a poll takes
    10 us for 60 of them, and 36 for 300; this one 4.
    """

    def __init__(self):
        self._epoll = select.epoll()
        self._files = {}  # on disks, which are always ready: {descriptor: events}
        self.close = self._epoll.close

    def register(self, descriptor, events):
        try:
            self._epoll.register(descriptor, events)
        except FileExistsError:
            self._epoll.modify(descriptor, events)
        except PermissionError:
            if events:  # without any, a poll looks whether a pipe's reader has gone; a file has none
                self._files[descriptor] = events

    def unregister(self, descriptor):
        if self._files.pop(descriptor, None) is not None:
            return
        try:
            self._epoll.unregister(descriptor)
        except OSError:
            pass  # closed, and with that forgotten

    def poll(self, milliseconds):
        if self._files:
            return list(self._files.items()) + self._epoll.poll(0)
        return self._epoll.poll(milliseconds / 1000)


def poll():
    """An object that finds which descriptors are ready, with the methods of select.poll."""
    try:
        return Epoll()
    except (AttributeError, OSError):  # not on Linux; out of files
        return select.poll()


# ---- TCP ----


def stream(family, protocol=0):
    """A TCP socket, which is not connected: with the methods of _socket.socket. Raises OSError."""
    return _socket.socket(family, _socket.SOCK_STREAM, protocol)


def listen(family, address, only_v6=True):
    """A socket.socket that listens at a place as of `resolve`, and does not block. Raises OSError,
    OverflowError.
    """
    import socket

    listening = socket.socket(family, socket.SOCK_STREAM)
    try:
        if family == socket.AF_INET6:
            listening.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, only_v6)
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listening.bind(address)
        listening.listen(LISTEN)
        listening.setblocking(False)
    except (OSError, OverflowError):
        listening.close()
        raise
    return listening


def send_at_once(connection):
    """Have what is sent leave without waiting for more. Raises OSError."""
    connection.setsockopt(_socket.IPPROTO_TCP, _socket.TCP_NODELAY, 1)


def failure(connection):
    """The error number of a connection that has been begun; 0 for none."""
    return connection.getsockopt(_socket.SOL_SOCKET, _socket.SO_ERROR)


def limit(connection, seconds):
    """Let `recv` wait for so long at most: a timeout of Python's own would cost a system call more each time.
    """
    whole = int(seconds)
    fraction = int(seconds % 1 * 1e6)
    try:
        connection.setsockopt(_socket.SOL_SOCKET, _socket.SO_RCVTIMEO, struct.pack("ll", whole, fraction))
    except OSError:  # 32-bit systems whose time has 64 bits
        connection.setsockopt(_socket.SOL_SOCKET, _socket.SO_RCVTIMEO, struct.pack("qq", whole, fraction))


def bind(host, port):
    """Bind a TCP socket to a host, "" for all addresses of this one, and a port, and close it. Raises
    OSError, UnicodeError.
    """
    family, _, protocol, _, address = resolve(host or None, port, flags=_socket.AI_PASSIVE)[0]
    own = stream(family, protocol)
    try:
        own.setsockopt(_socket.SOL_SOCKET, _socket.SO_REUSEADDR, 1)
        own.bind(address)
    finally:
        own.close()


def connected(endpoint, seconds):
    """A socket.socket that is connected with (host, port), whose methods wait for so long at most, as this
    does: for threads of omniORB. Raises OSError, ValueError.
    """
    import socket

    return socket.create_connection(endpoint, seconds)


def unacknowledged(connection):
    """How many octets sent have not been acknowledged by the other host; 0 if the kernel does not report it.
    """
    try:
        import fcntl
        import termios  # which Debian's python3-minimal lacks

        return struct.unpack("i", fcntl.ioctl(connection, termios.TIOCOUTQ, b"\0" * 4))[0]
    except (OSError, ImportError):
        return 0


# ---- hosts ----


def resolve(host, port=None, family=0, flags=0):
    """The places of a host for TCP, as of getaddrinfo; host None with AI_PASSIVE: this one. May take long.
    Raises OSError, UnicodeError, ValueError.
    """
    return _socket.getaddrinfo(host, port, family, _socket.SOCK_STREAM, 0, flags)


def scheduled():
    """Seconds for which this thread has run, and for which it waited for a processor; zeros if the kernel
    does not report that.
    """
    try:
        with open("/proc/thread-self/schedstat") as file:  # Documentation/scheduler/sched-stats.rst of Linux
            ran, waited = file.read().split()[:2]
        return int(ran) / 1e9, int(waited) / 1e9
    except (OSError, ValueError):
        return 0.0, 0.0


def host_name():
    """The name of this host."""
    return _socket.gethostname()


def is_own(address):
    """Whether an IP address is one of this host: a UDP socket can be bound there."""
    family = _socket.AF_INET6 if ":" in address else _socket.AF_INET
    own = None
    try:
        own = _socket.socket(family, _socket.SOCK_DGRAM)
        own.bind((address.partition("%")[0], 0))
    except OSError:
        return False
    finally:
        if own is not None:
            own.close()
    return True


def own_address(host, port):
    """The address of this host that faces another, None if there is no route. Sends nothing; may take long.
    """
    try:
        candidates = _socket.getaddrinfo(host, port, 0, _socket.SOCK_DGRAM)
    except (OSError, UnicodeError):
        return None
    for family, kind, protocol, _, address in candidates:
        probe = None
        try:
            probe = _socket.socket(family, kind, protocol)
            probe.connect(address)
            return probe.getsockname()[0]
        except OSError:
            continue
        finally:
            if probe is not None:
                probe.close()
    return None


def interfaces():
    """[(name, IPv4 address, its netmask)] of this host, as text."""
    import socket

    listed = []
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        for _, name in socket.if_nameindex():
            request = struct.pack("256s", name.encode()[:15])
            try:
                import fcntl

                address, mask = [
                    socket.inet_ntoa(fcntl.ioctl(any_socket, number, request)[20:24])
                    for number in (SIOCGIFADDR, SIOCGIFNETMASK)
                ]
            except (OSError, ImportError):  # it has no such address, or this is no Linux
                continue
            listed.append((name, address, mask))
    return listed


# ---- threads ----


def start_thread(function, *args):
    """Run function(*args) on a thread of its own. Raises Shortage."""
    import threading

    try:
        threading.Thread(target=function, args=args, daemon=True).start()
    except RuntimeError as e:
        raise errors.Shortage("threads", str(e))


# ---- signals ----


def handlers():
    """{number: its handler} of all signals, also of those without a name."""
    return {number: handler(number) for number in range(1, _signal.NSIG)}


def signals():
    """{name: number} of all signals."""
    names = [name for name in sorted(vars(_signal)) if name.startswith("SIG") and name[3:].isalnum()]
    return {name: getattr(_signal, name) for name in names}


def stop_here():
    """SIGSTOP this process."""
    os.kill(os.getpid(), SIGSTOP)


# ---- processes and files of this computer ----


def start_process(words, **more):
    """A subprocess.Popen. Raises OSError."""
    import subprocess

    return subprocess.Popen(words, **more)


def sync(descriptor):
    """What an open file has is on the disk then. Raises OSError."""
    os.fsync(descriptor)


def replace(path, target):
    """Give a file the name of another, which it replaces. Raises OSError."""
    os.replace(path, target)


def mounts():
    """What is mounted where, as an open file of lines, each as in mountinfo (proc(5)); a poll finds URGENT at
    it after a change. Raises OSError.
    """
    return open(MOUNTS, encoding="utf-8", errors="surrogateescape")


def open_fuse():
    """The descriptor, which does not block, of another /dev/fuse: its kernel asks there. Raises OSError."""
    return os.open(FUSE, os.O_RDWR | os.O_CLOEXEC | os.O_NONBLOCK)


def system_call(name, *args):
    """One of Linux that Python lacks: mount, umount2. Raises OSError."""
    import ctypes  # which Debian's python3-minimal lacks

    args = [ctypes.c_ulong(arg) if isinstance(arg, int) else arg for arg in args]
    library = ctypes.CDLL(None, use_errno=True)
    if getattr(library, name)(*args):
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))


def read_into(descriptor, buffer):
    """How many octets were read into a buffer, without waiting for any. Raises OSError."""
    return os.readv(descriptor, [buffer])


def write_to(descriptor, data):
    """Write octets, all at once. Raises OSError."""
    os.write(descriptor, data)


def takes(descriptor):
    """Whether something can be written to a descriptor now, without waiting for who reads it."""
    poller = select.poll()
    poller.register(descriptor, select.POLLOUT)
    return bool(poller.poll(0))


def lock(directory):
    """Hold a directory, with others who do, until this process ends. Raises OSError."""
    import fcntl  # which some systems lack

    fcntl.flock(os.open(directory, os.O_RDONLY), fcntl.LOCK_SH)


def local():
    """A UNIX socket, which is not connected. Raises OSError."""
    import socket

    return socket.socket(socket.AF_UNIX)


def tell(address, data):
    """Send a datagram to a UNIX socket, which may be abstract. Raises OSError."""
    import socket

    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as out:
        out.setblocking(False)
        out.sendto(data, address)


def pair():
    """Two UNIX sockets that are connected with one another. Raises OSError."""
    import socket

    return socket.socketpair()


def received(channel):
    """The file descriptor that comes over a UNIX socket, and does not block; None if that is closed first.
    Raises OSError.
    """
    import array

    _, ancillary, _, _ = channel.recvmsg(1, _socket.CMSG_SPACE(4))
    for level, kind, data in ancillary:
        if (level, kind) == (_socket.SOL_SOCKET, _socket.SCM_RIGHTS):
            fd = array.array("i", data[:4])[0]
            os.set_inheritable(fd, False)
            os.set_blocking(fd, False)
            return fd
    return None
