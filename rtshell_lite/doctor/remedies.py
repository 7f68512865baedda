"""All remedies that rtdoctor names; tests/commands/test_remedies.py tries each.

A remedy is a command, which can be pasted into a shell and followed blindly, or words, for a person to think
about. Its first word shows which: only commands begin with a program of ours, or with unset. A command mends
what was found, and changes nothing else; a name is deleted only if its object is certainly dead.
"""

import collections
import re

from rtshell_lite import errors
from rtshell_lite.doctor import addresses
from rtshell_lite.text import printable, shell_word

# {name} becomes a word of the shell, or several; an empty one leaves no gap
COMMANDS = {
    "activate": "rtact {option} {path}",
    "deactivate": "rtdeact {option} {path}",
    "reset": "rtreset {option} {path}",
    "reset and activate": "rtreset --wait {path}; rtact --wait {path}",
    "start context": "rtec {path} start",
    "set rate": "rtec {option} {path} rate {rate}",
    "disconnect": "rtdis -i {id} {port}",
    "reconnect": "rtdis -i {id} {port}; {rtcon}",
    "delete name": "rtdel {path}",
    "delete zombie": "rtdel -z {path}",
    "restore": "rtresurrect {file}",
    "start system": "rtstart {file}",
    "unset": "unset {variable}",
    "unmount": "rtmount -u {directory}",
}

# {name} becomes text
WORDS = {
    # here
    "newer omniORBpy": "pip install -U jeteve-omniorb, or set RTSHELL_ORB=builtin",
    "correct settings": "correct or remove it",
    "correct file": "remove it from {file}",
    "raise limit": "raise the limit in this shell ({command}), or end the programs that use most {what} here",
    "name of host": "give it its real address in /etc/hosts",
    "localhost": "write into /etc/hosts: 127.0.0.1 localhost",
    "correct addresses": (
        "write HOST[:PORT], several separated by semicolons: RTCTREE_NAMESERVERS='robot1;robot2:2810'"
    ),
    "one address": "take one of them out of RTCTREE_NAMESERVERS",
    "clock": "compare the clocks (date, here and there) and set the wrong one: timedatectl",
    # the network
    "network": (
        "look at what is between here and {host}: firewall (port {port}), route (ip route get {host}), MTU "
        "and loss (ping {host})"
    ),
    "large packets": (
        "ping -M do -s 1472 {host}, here and there back, shows whether large packets come through: if not, "
        "correct the MTU on the way; if they do, it hangs: netstat -ltnp | grep :{port} there names its "
        "process"
    ),
    "firewall": (
        "on that host: rtdoctor, rtdel -z; netstat -ltnp | grep :{port} there shows whether its process "
        "runs: if so, let this host through its firewall; if not, start it again"
    ),
    "name in reference": (
        "write the address of {host} into /etc/hosts here, or have its process publish an address: "
        "corba.endpoints in rtc.conf"
    ),
    "name of this host": (
        "see what {host} means where its process runs, and have that publish an address: corba.endpoints "
        "in rtc.conf"
    ),
    "exception": "see what it writes into its log; netstat -ltnp | grep :{port} there names its process",
    "who listens instead": (
        "netstat -ltnp | grep :{port} there names what listens; the component that had this port is gone, "
        "or elsewhere"
    ),
    "host name": "correct the name, or write its address into /etc/hosts",
    "host file": "write its address into /etc/hosts",
    "slow": "ping {host}",
    "who listens": "netstat -ltnp | grep :{port} there names what listens; correct the address",
    "another address": "give its process an address that others reach: corba.endpoints: {host}: in rtc.conf",
    "only good addresses": (
        "have its process publish only addresses that others reach: corba.endpoints in rtc.conf"
    ),
    # name servers
    "start name server": "start the name server: rtm-naming {port}",
    "start name server or correct host": (
        "start the name server: rtm-naming {port}; if {host} is another host, correct /etc/hosts"
    ),
    "scope": "write the interface, too: [{host}%eth0]",
    "start name server there": (
        "netstat -ltnp | grep :{port} there shows whether it runs: if so, let this host through its "
        "firewall; if not: rtm-naming {port}"
    ),
    "other port": (
        "see whether it is the name server (rtls {server}), and correct the address; if not: rtm-naming "
        "{port} there"
    ),
    "bind again": (
        "look again in some time, as many bind their names again by themselves (naming.update.enable); "
        "restart those that do not"
    ),
    "nothing bound": (
        "start the components; those that run already bind their names again by themselves "
        "(naming.update.enable), or when they are restarted"
    ),
    "restart name server": "restart the name server that has it",
    "restart": "restart it; netstat -ltnp | grep :{port} there names its process",
    "correct port": "correct the port; netstat -ltnp | grep omniNames there shows it",
    "correct or restart": "correct the port, or restart it",
    "no such path": "see what is there: rtls {path}",
    "stale names": "when the dead names in it are deleted it is empty; then: rtdel {path}",
    "bad reference": "find out what has bound it; its component binds a good one when it is restarted",
    "name of another": "see who uses this name; if nobody does: rtdel {path}",
    "name taken": "restart the component that should have this name; if none should: rtdel {path}",
    "renamed": "restart it, so that it binds its own name; do not delete this one: no other leads to it",
    "unbound": "restart its process, so that it binds its name; rtcat {path} shows the connection",
    "crash loop": "see its log, and what starts it again",
    # components
    "more time": "ask it with more time: rtdoctor --timeout 30 {path}",
    "in parts": "examine the system in parts (rtdoctor PATH), or with more time: rtdoctor --timeout 30",
    "others first": "mend those that do not answer first, then: rtdoctor {path}",
    "hung first": "mend {paths} first",
    "unspoken": (
        "to look at it from here, have its process listen with TCP, too: corba.endpoints in rtc.conf"
    ),
    "look at contexts": "look at its contexts: rtec {path}",
    "active once": "see whose they are (rtec {path}), and leave all but one: rtdeact -e N {path}",
    "activate": "if it is to move, activate it: rtact {path}",
    "activate many": "activate those that are to move (rtact), or the whole system by its file (rtstart)",
    "restart composite": "restart its process, with all members alive (rtcomp cannot remove a dead one); "
    "netstat -ltnp | grep :{port} there names it",
    "load": (
        "look for what takes the time of its host, or of the component itself (top there), or what is lost "
        "on the way (ping {host})"
    ),
    "load or values": (
        "see whether values come to it as often (rttrace -u {port}); if so, look for what takes the time "
        "of its host, or of the component itself (top there), or what is lost on the way (ping {host})"
    ),
    "measure again": "measure it alone: rtec --measure {path}",
    # connections
    "connect again": "disconnect it (rtdis -i {id} {port}), then connect its ends again: rtcon",
    "connect provider": "if they belong together, connect them again: rtcon {one} {other}",
    "full buffer": "raise the rate of its context (rtec {path} rate HZ), or, if old values may go, connect "
    "it with -p dataport.buffer.write.full_policy=overwrite",
    "before removal": "before you remove it: rtdeact {paths} (rtdis then waits until no value waits)",
    "restart its process": "restart the process of the far end; netstat -ltnp | grep :{port} there names it",
    "restart far end": "restart the far end and connect it again: rtcon",
    # managers
    "restart manager": "restart it; rtls {path} marks what is gone",
    "restart slave": "restart that slave",
    "restart manager or slave": (
        "restart it, or a slave that it waits for; netstat -ltnp | grep :{port} there names its process"
    ),
    "hung below": "see which: rtls -l {path}",
    # profiles
    "start component": "start it, or have its manager make it: rtresurrect --create {file}",
    "look at component": "look at it: rtcat {path}",
    "look at state": "look at its state: rtls -l {path}",
}

Remedy = collections.namedtuple("Remedy", "name text")


class Line(str):
    """Words of a command line, quoted already."""


def _quoted(part):
    return part if isinstance(part, Line) else shell_word(str(part))


def command(name, **values):
    """The Remedy of that name in COMMANDS; a value is a word, a list of words or a Line."""

    def word(match):
        value = values[match.group(2)]
        if not isinstance(value, list):
            value = [value]
        text = " ".join(_quoted(part) for part in value)
        return match.group(1) + text if text else ""

    return Remedy(name, re.sub(r"( ?)\{(\w+)\}", word, COMMANDS[name]))


def words(name, **values):
    """The Remedy of that name in WORDS."""
    return Remedy(name, WORDS[name].format(**values))


def option(index):
    """The words that choose an execution context."""
    return ["-e", str(index)] if index else []


def reconnect(connector_id, port, rtcon):
    """The Remedy that replaces a connection:
    `rtcon` is a command line of `connectors.command`, None where an end has no path.
    """
    if rtcon is None:
        return words("connect again", id=shell_word(connector_id), port=shell_word(port))
    return command("reconnect", id=connector_id, port=port, rtcon=Line(rtcon))


def network(endpoint):
    """The Remedy if it cannot be known from here whether a peer lives:
    it must not be restarted or deleted.
    """
    return words("network", host=printable(endpoint[0]), port=endpoint[1])


async def of_silence(e, endpoint, path, restart=None):
    """The Remedy for an errors.Error of a process at `endpoint` that has not answered a question with a large
    answer, or badly.

    Only if a call is known to have reached it is it to be restarted; `restart` is the Remedy then.
    """
    if isinstance(e, errors.NoTime):
        return words("more time", path=shell_word(path))
    if isinstance(e, errors.NotAsked):
        return not_asked(e, path)
    if await is_of_network(e, endpoint):
        return network(endpoint)
    if await may_be_lost(e, endpoint):
        return words("large packets", host=printable(endpoint[0]), port=endpoint[1])
    return restart or words("restart", port=endpoint[1])


def not_asked(e, path):
    """The Remedy for what was not asked, by an errors.NotAsked."""
    if isinstance(e, errors.Unspoken):
        return words("unspoken")
    return words("others first", path=shell_word(path))


async def may_be_lost(e, endpoint):
    """True if the errors.Error of a process may mean that its answer was too large for the network on the
    way.
    """
    if not isinstance(e, errors.Silent):
        return False
    return await addresses.loses_large(endpoint)


async def is_of_network(e, endpoint):
    """True if the network between here and the process at `endpoint` may have caused an errors.Error."""
    if isinstance(e, (errors.Refused, errors.Gone, errors.ConnectionRefused, errors.NotAsked)):
        return False
    return not isinstance(e, errors.Silent) or not await addresses.arrives(endpoint)
