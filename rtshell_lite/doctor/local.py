"""This host and this shell: what is checked before any peer is asked."""

import collections
import os
import re
import sys

from rtshell_lite import errors, path
from rtshell_lite.corba import orb, session
from rtshell_lite.doctor import addresses, limits, remedies
from rtshell_lite.doctor.finding import HERE, fail, ok, reason, warn
from rtshell_lite.mount import kernel
from rtshell_lite.net import loop
from rtshell_lite.robot import tree
from rtshell_lite.text import printable

CONFIGURATION = "/etc/omniORB.cfg"
SMALLEST_MESSAGE = 2097152  # octets: omniORB's default of giopMaxMsgSize
OURS = "these commands"
THEIRS = "components started here"
ARGUMENTS = "RTCTREE_ORB_ARGS"
LEAST_PATIENCE = 500  # ms: a component that waits for its next cycle takes that long to answer


Rule = collections.namedtuple("Rule", "text remedy")  # a setting in words, and the Remedy for it


async def findings():
    """Findings on Python and omniORB, their settings, the names of this host, our environment,
    and mounted trees.
    """
    all_findings = _programs()
    lacking = limits.findings()
    if lacking:
        return all_findings + lacking
    all_findings += _settings(started=all_findings[-1].level != "fail")
    return (
        all_findings
        + await _host_name()
        + await _localhost()
        + await _name_servers()
        + _patience()
        + _working_directory()
        + await _mounts()
    )


# ---- programs ----


def _programs():
    python = "Python %d.%d.%d" % sys.version_info[:3]
    try:
        version = orb.version()
    except errors.MissingOmniORB:
        message = f"{python} has no omniORBpy, which RTSHELL_ORB asks for"
        return [fail("ORB", HERE, message, remedies.command("unset", variable="RTSHELL_ORB"))]
    findings = [ok("ORB", HERE, f"{python}, {version}")]
    name, _, number = version.partition(" ")
    if name == "omniORBpy" and _number(number.partition(".")[0]) < 4:
        message = f"{python}, {version}: older than 4.0, untried"
        findings = [warn("ORB", HERE, message, remedies.words("newer omniORBpy"))]
    try:
        orb.start()
    except errors.Error:
        where = " or ".join(name for name, _ in _sources()) or "its settings"
        message = "the ORB does not start: it does not understand " + where
        findings.append(fail("ORB", HERE, message, remedies.words("correct settings")))
    return findings


def _number(word):
    return int(word) if word.isdigit() else 0


# ---- settings of the ORB ----


def _settings(started):
    """Settings of omniORB that break things, whatever their source.
    The last source wins, but each is reported.
    """
    findings = []
    sources = _sources()
    named = os.environ.get("OMNIORB_CONFIG")
    if named and not os.path.exists(named):
        message = "OMNIORB_CONFIG names a file that is not there: " + printable(named)
        findings.append(warn("ORB", HERE, message, remedies.command("unset", variable="OMNIORB_CONFIG")))
    for source, settings in sources:
        for option, value in settings:
            why = _harm(option, value, OURS if source == ARGUMENTS else THEIRS)
            if why and (source != ARGUMENTS or orb.obeys(option)):
                message = f"{source} sets {option} to {printable(value)}: {why}"
                findings.append(warn("ORB", HERE, message, _without(source)))
    if not findings and sources and started:
        names = ", ".join(name for name, _ in sources)
        findings.append(ok("ORB", HERE, "settings of omniORB that break nothing: " + names))
    return findings


def _sources():
    """(name, [(option, value)]) of each source of settings: file, variables ORB…, RTCTREE_ORB_ARGS."""
    name = os.path.abspath(os.environ.get("OMNIORB_CONFIG") or CONFIGURATION)
    settings = [(printable(name), _configured(name))]
    settings += [
        (key, [(key[3:], value)])
        for key, value in sorted(os.environ.items())
        if re.match("ORB[a-z]+[A-Za-z]*$", key)
    ]
    words = [word for word in os.environ.get(ARGUMENTS, "").split(";") if word]
    arguments = [(word[4:], value) for word, value in zip(words, words[1:] + [""]) if word.startswith("-ORB")]
    sources = [source for source in settings if source[1]]
    if words:
        sources.append((ARGUMENTS, arguments))
    return sources


def _configured(name):
    """The settings in a file of omniORB: `option = value` lines."""
    try:
        with open(name, encoding="utf-8", errors="replace") as file:
            lines = [line.partition("#")[0] for line in file]
    except OSError:
        return []
    pairs = [line.partition("=") for line in lines if line.strip()]
    return [(option.strip(), value.strip()) for option, _, value in pairs]


def _without(source):
    """The Remedy for a setting from this source."""
    if source.startswith("/"):
        return remedies.words("correct file", file=source)
    return remedies.command("unset", variable=source)


def _harm(option, value, whom):
    """What a setting breaks, and for `whom`, '' if nothing that we know of.

    Our commands have limits of their own, which only RTCTREE_ORB_ARGS overrides.
    """
    if option == "giopMaxMsgSize" and _number(value) < SMALLEST_MESSAGE:
        return f"{whom} cannot send or receive larger messages (MARSHAL)"
    if (
        option in ("clientCallTimeOutPeriod", "clientConnectTimeOutPeriod")
        and 0 < _number(value) < LEAST_PATIENCE
    ):
        return f"{whom} give up before slower answers come"
    if option == "throwTransientOnTimeOut" and value != "0":
        return "hung peers look like peers out of reach to these commands"
    if option == "maxGIOPVersion" and value in ("1.0", "1.1"):
        return "Japanese names and large lists fail"
    if option in ("endPoint", "endPointPublish"):
        return _harm_of_end_point(value, whom)
    return ""


def _harm_of_end_point(value, whom):
    """`_harm` of giop:TRANSPORT:HOST:PORT, where HOST and PORT may be empty."""
    transport, _, address = value.partition("giop:")[2].partition(":")
    host, _, port = address.rpartition(":")
    host = host.strip("[]")
    why = addresses.why_not_bound(host, _number(port)) if transport == "tcp" else ""
    if why:
        return f"{whom} cannot listen there ({why})"
    if addresses.is_loopback(host) or host == "localhost":
        return f"{whom} cannot be reached from other hosts"
    if transport == "tcp" and port:
        return "only one process at a time can have this port"
    return ""


def transport_rule():
    """The Rule that may forbid connections, or None; only reported where one fails."""
    if not orb.obeys("clientTransportRule"):
        return None
    for source, settings in _sources():
        for option, value in settings:
            if option == "clientTransportRule":
                return Rule(f"clientTransportRule {printable(value)} of {source}", _without(source))
    return None


# ---- names of this host ----


async def _host_name():
    """The name of this host must mean an address that others can use:
    components may publish what it means.
    """
    name = loop.world().host_name()
    shown = f"this host's name, {printable(name)}, "
    cure = remedies.words("name of host")
    try:
        numbers = await addresses.resolve(name)
    except errors.Error as e:
        return [warn("host name", HERE, shown + f"is not known here ({reason(e)})", cure)]
    means = ", ".join(numbers)
    if all(addresses.is_loopback(address) for address in numbers):
        return [
            warn(
                "host name", HERE,
                shown + f"means {means}: components that publish it cannot be reached from elsewhere", cure,
            )
        ]
    if not any(addresses.is_own(address) for address in numbers):
        return [warn("host name", HERE, shown + f"means {means}, which is not this host", cure)]
    return [ok("host name", HERE, shown + "means " + means)]


async def _localhost():
    cure = remedies.words("localhost")
    try:
        numbers = await addresses.resolve("localhost")
    except errors.Error as e:
        return [fail("host name", HERE, f"localhost is not known here ({reason(e)})", cure)]
    if not all(addresses.is_loopback(address) for address in numbers):
        return [fail("host name", HERE, f"localhost means {', '.join(numbers)}", cure)]
    return []


# ---- our environment ----


def _patience():
    """RTSHELL_TIMEOUT: less than a cycle of many components, and a network's repetition of a lost packet,
    seems to be silence.
    """
    value = os.environ.get("RTSHELL_TIMEOUT", "")
    if not value or 1000 * session.current().timeout >= LEAST_PATIENCE:
        return []
    message = (
        f"RTSHELL_TIMEOUT is {printable(value)}: what answers after {session.current().timeout:g} s is "
        "taken for silent"
    )
    return [warn("RTSHELL_TIMEOUT", HERE, message, remedies.command("unset", variable="RTSHELL_TIMEOUT"))]


async def _name_servers():
    """RTCTREE_NAMESERVERS: HOST[:PORT], separated by semicolons."""
    value = os.environ.get("RTCTREE_NAMESERVERS", "")
    if not value.strip("; "):
        return [
            ok("RTCTREE_NAMESERVERS", HERE, "RTCTREE_NAMESERVERS is not set: localhost is the name server")
        ]
    faults = [(address, await fault(address)) for address in tree.servers()]
    return [
        fail(
            "RTCTREE_NAMESERVERS", HERE, f"RTCTREE_NAMESERVERS: {printable(address)}: {why}",
            remedies.words("correct addresses"),
        )
        for address, why in faults
        if why
    ] or [ok("RTCTREE_NAMESERVERS", HERE, f"RTCTREE_NAMESERVERS: {printable('; '.join(tree.servers()))}")]


async def fault(address):
    """What is wrong with the address of a name server, '' if nothing."""
    if re.search(r"[,\s]", address):
        return "several are separated by semicolons"
    is_manager = re.match("corbaloc:.*/manager$", address)
    if not is_manager and address.startswith(("corbaloc:", "corbaname:", "rtcname:", "rtcloc:", "IOR:")):
        return f"only HOST[:PORT], without {address.partition(':')[0]}:"
    try:
        parsed = path.parse("/" + address)
        if not is_manager and _is_started():
            await tree.resolve(parsed._replace(names=()))  # contacts nobody
    except errors.Error:
        return "not HOST[:PORT]"
    if parsed.names or parsed.server is None:
        return "only HOST[:PORT], nothing after it"
    return ""


def _is_started():
    try:
        orb.start()
    except errors.Error:  # reported before
        return False
    return True


def _working_directory():
    try:
        path.parse(".")
    except errors.Error as e:
        return [fail("RTCSH_CWD", HERE, f"RTCSH_CWD: {e}", remedies.command("unset", variable="RTCSH_CWD"))]
    return []


# ---- rtmount ----


async def _is_stale(directory):
    return await session.on_thread(printable(directory), lambda: kernel.is_stale(directory))


async def _mounts():
    """Mounted RTC Trees whose rtmount has been killed; one that is stopped answers nobody."""
    directories = kernel.mounted()
    answers = await session.each(
        directories, _is_stale, lambda directory: (("mount", directory), printable(directory))
    )
    return [
        warn(
            "mount", HERE, f"{printable(directory)} is a mount of an rtmount that has been killed",
            remedies.command("unmount", directory=directory),
        )
        for directory, stale in zip(directories, answers)
        if stale is True
    ]
