"""Hosts in network namespaces of their own, joined by a switch: what `ip netns` and `nft` are asked for."""
import contextlib
import os
import shutil
import subprocess
import unittest

MARK = "rt%d" % os.getpid()


def ip(*words):
    """Run ip; raises CalledProcessError."""
    subprocess.run(("ip",) + words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)


def namespace(name):
    return "%s-%s" % (MARK, name)


def inside(name):
    return ["ip", "netns", "exec", namespace(name)]


def build(addresses, switch="switch"):
    """The hosts, {name: address}, and a switch with a bridge that joins them; skips what tests where there
    may be none.
    """
    if not shutil.which("ip"):
        raise unittest.SkipTest("needs ip (iproute2)")
    try:
        ip("netns", "add", namespace(switch))
        ip("-n", namespace(switch), "link", "add", "bridge", "type", "bridge")
        ip("-n", namespace(switch), "link", "set", "bridge", "up")
        for name, address in addresses.items():
            plug_in(name, address, switch)
    except subprocess.CalledProcessError as e:
        unbuild(addresses, switch)
        raise unittest.SkipTest("this machine allows no network namespaces: " + e.stderr.decode().strip())


def plug_in(name, address, switch="switch"):
    """Add a host with an address to a switch."""
    there = namespace(name)
    ip("netns", "add", there)
    veth = ["link", "add", name, "type", "veth", "peer", "name", "eth0", "netns", there]
    ip("-n", namespace(switch), *veth)
    ip("-n", namespace(switch), "link", "set", name, "master", "bridge", "up")
    ip("-n", there, "link", "set", "lo", "up")
    ip("-n", there, "address", "add", address + "/24", "dev", "eth0")
    ip("-n", there, "link", "set", "eth0", "up")


def unbuild(names, switch="switch"):
    """Remove the hosts and their switch."""
    for name in list(names) + [switch]:
        shutil.rmtree(os.path.join("/etc/netns", namespace(name)), ignore_errors=True)
        subprocess.run(["ip", "netns", "del", namespace(name)], stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)


def cable(name, how, switch="switch"):
    """Pull the cable of a host at the switch ("down"), or plug it in again ("up"): the host itself does not
    notice.
    """
    ip("-n", namespace(switch), "link", "set", name, how)


def call_hosts(name, **names):
    """Give names to addresses, as a host sees them: files of /etc/netns are mounted by ip netns exec."""
    place = os.path.join("/etc/netns", namespace(name))
    os.makedirs(place, exist_ok=True)
    with open("/etc/hosts") as known, open(os.path.join(place, "hosts"), "w") as file:
        file.writelines(line for line in known if not set(line.split()[1:]) & set(names))
        for each, addresses in names.items():
            file.write("".join("%s %s\n" % (address, each) for address in addresses))


@contextlib.contextmanager
def rules(name, chain, rule):
    """Of a host: what nft does with packets that come from outside (`chain` input), or go out (output)."""
    if not shutil.which("nft"):
        raise unittest.SkipTest("needs nft (nftables)")
    side = "iif" if chain == "input" else "oif"
    table = "table ip wall { chain wall { type filter hook %s priority 0; %s lo accept; %s; }; }"
    # it refuses each time
    subprocess.run(inside(name) + ["sh", "-c", "echo 0 >/proc/sys/net/ipv4/icmp_ratelimit"], check=True)
    subprocess.run(inside(name) + ["nft", table % (chain, side, rule)], check=True)
    try:
        yield
    finally:
        subprocess.run(inside(name) + ["nft", "delete table ip wall"], check=True)
