"""This host in words, for a report: versions, clock, interfaces, routes, names, settings, limits,
processes.
"""

import os
import platform
import re
import ipaddress
import struct
import sys

import rtshell_lite
from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.doctor import waiting
from rtshell_lite.net import calendar, hosts, loop
from rtshell_lite.text import quoted

MOST = 1 << 16  # characters of a file that are taken
# The variables that are shown, of which none has a secret; RTC_TOKEN or ORB_KEY may.
OURS = re.compile(
    "RTCTREE_(NAMESERVERS|ORB_ARGS)|RTCSH_CWD|RTSHELL_(ORB|FIND|TIMEOUT|IDL|DEBUG)"
    "|RTM_(ROOT|BASE|IDL|IDL_PATH|VC_VERSION|JAVA_ROOT|VERSION)|OpenRTM_DIR"
    "|ORB(endPoint|endPointPublish|endPointPublishAllIFs|InitRef|DefaultInitRef|nativeCharCodeSet|traceLevel"
    "|clientCallTimeOutPeriod|clientConnectTimeOutPeriod|giopMaxMsgSize|clientTransportRule"
    "|serverTransportRule)"
    "|OMNIORB_CONFIG|OMNIORB_USEHOSTNAME|OMNINAMES_(LOGDIR|DATADIR|ITERATOR_TIMEOUT)"
    "|PYTHON(PATH|HOME|SAFEPATH|STARTUP|OPTIMIZE|DEBUG|UNBUFFERED|DONTWRITEBYTECODE|PYCACHEPREFIX|HASHSEED"
    "|IOENCODING|UTF8|COERCECLOCALE|NOUSERSITE|WARNINGS|MALLOC|DEVMODE|FAULTHANDLER|ASYNCIODEBUG)"
    "|LANG|LANGUAGE|LC_(ALL|CTYPE|COLLATE|MESSAGES|MONETARY|NUMERIC|TIME)|TZ|HOSTNAME"
)
# What may come before a secret in the words of a command line.
SECRET = re.compile(r"pass(w|phrase|$|[_-])|secret|token|credential|auth|(^|[_-])(api)?key$", re.IGNORECASE)
HIDDEN = "(hidden)"


def versions():
    """The text on versions and the clock."""
    try:
        ours = orb.version()
    except errors.MissingOmniORB:
        ours = "no ORB"
    now = loop.wall()
    return "\n".join(
        [
            f"rtshell_lite {rtshell_lite.__version__}, {ours}, Python %d.%d.%d" % sys.version_info[:3],
            f"{platform.system()} {platform.release()} {platform.machine()}",
            f"clock: {calendar.utc('%Y-%m-%d %H:%M:%S', now)} UTC, {now:.6f} s since the "
            "epoch; with --measure, the clocks of components are compared with it",
            "seconds up, seconds idle: " + _content("/proc/uptime").partition("\n")[0],
        ]
    )


def surroundings(ports):
    """[(heading, text)] on this host: its names, its network, our environment, and the processes that listen
    on these ports.
    """
    return [
        ("Interfaces of this host", f"{loop.world().host_name()}\n" + "\n".join(_interfaces())),
        ("Routes", "\n".join(_routes())),
        ("/etc/hosts", _content("/etc/hosts")),
        ("Environment", "\n".join(_environment())),
        ("Limits", _content("/proc/self/limits")),
        ("Processes of this host that listen on the ports concerned", "\n".join(_processes(ports))),
    ]


def _content(name):
    """The beginning of a file, or why it cannot be read."""
    try:
        with open(name, encoding="utf-8", errors="surrogateescape") as file:
            return file.read(MOST)
    except OSError as e:
        return f"cannot be read: {e.strerror}"


# ---- the network ----


def _interfaces():
    for name, interface in hosts.interfaces():
        yield f"{name}  {interface}"
    for line in _content("/proc/net/if_inet6").splitlines():
        words = line.split()
        if len(words) == 6:
            address = ipaddress.ip_address(bytes.fromhex(words[0]))
            yield f"{words[5]}  {address}/{int(words[2], 16)}"


def _routes():
    """The IPv4 routes, from /proc/net/route."""
    for line in _content("/proc/net/route").splitlines()[1:]:
        words = line.split()
        if len(words) < 8:
            continue
        name, to, gateway, *_ = words
        yield f"{_ip(to)}/{_ip(words[7])}  via {_ip(gateway)}  on {name}  metric {words[6]}"


def _ip(word):
    """An IPv4 address from 8 hexadecimal digits, in this host's order of bytes."""
    return str(ipaddress.ip_address(struct.pack("=I", int(word, 16))))


def _environment():
    for name, value in sorted(os.environ.items()):
        if OURS.fullmatch(name):
            yield f"{name}={quoted(';'.join(without_secrets(value.split(';'))))}"


def without_secrets(words):
    """The words of a command line, with what looks like a secret hidden: the word after -ORBsslPassword, what
    is after --token=, and a password in an address.
    """
    shown = []
    is_next = False
    for word in words:
        name, sign, _ = word.partition("=")
        is_option = word.startswith("-") and not sign
        if is_next:
            word = HIDDEN
        elif sign and SECRET.search(name):
            word = f"{name}={HIDDEN}"
        shown.append(re.sub(r"(://[^/@:]*):[^/@]*@", rf"\1:{HIDDEN}@", word))
        is_next = is_option and not is_next and bool(SECRET.search(name))
    return shown


# ---- processes ----


def _processes(ports):
    """A line for each process and each of these ports that it listens on, as far as we may know."""
    sockets = _listening(ports)
    owners = _owners(set(sockets))
    for inode, port in sorted(sockets.items(), key=lambda pair: (pair[1], pair[0])):
        pid = owners.get(inode)
        if pid is None:
            yield f"port {port}: a process that we may not look at"
        else:
            yield f"port {port}: {_process(pid)}"
    for port in sorted(ports - set(sockets.values())):
        yield f"port {port}: nothing listens here"


def _listening(ports):
    """{inode of a socket: port} of those that listen on these ports, from /proc/net/tcp and tcp6."""
    ports_by_inode = {inode: waiting.end(local)[1] for local, _, inode in waiting.rows(waiting.LISTENING)}
    return {inode: port for inode, port in ports_by_inode.items() if port in ports}


def _owners(inodes):
    """{inode: number of the process that has this socket}."""
    owners = {}
    if not inodes:
        return owners
    inode_of = {f"socket:[{inode}]": inode for inode in inodes}
    for pid in filter(str.isdigit, os.listdir("/proc")):
        for link in _links(f"/proc/{pid}/fd"):
            if link in inode_of:
                owners[inode_of[link]] = pid
    return owners


def _links(folder):
    try:
        names = os.listdir(folder)
    except OSError:  # it has ended, or is somebody else's
        return
    for name in names:
        try:
            yield os.readlink(f"{folder}/{name}")
        except OSError:
            continue


def _process(pid):
    """What /proc says of a process, in a line."""
    words = _content(f"/proc/{pid}/cmdline").split("\0")
    status = dict(
        line.partition(":\t")[::2] for line in _content(f"/proc/{pid}/status").splitlines() if ":\t" in line
    )
    more = [f"{name} {status[name].strip()}" for name in ("State", "Threads", "VmRSS") if name in status]
    line = " ".join(map(quoted, without_secrets(filter(None, words))))
    return f"{pid}  {', '.join(more)}  {line}"
