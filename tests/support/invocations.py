"""With which arguments every command is run by tests that run them all; one place, so that none is forgotten.

Words stand for things: SERVER a name server (or another directory), A and B components (A:out an out port, A:in an in port),
MGR a manager, FILE an RtsProfile that connects A:out to B:in, OUT a file to write, LOG a log that was recorded before.
"""
import os
import re

import processes

# Those that ask somebody, one invocation each or several; the first is the one that shows or does most.
ASKING = {
    "rtact": ["A", "--wait 0.5 A B"],
    "rtcat": ["-ll A", "A:out", "--json A B"],
    "rtcheck": ["FILE", "--extra --json FILE"],
    "rtcomp": ["-a B A", "-a B:in MGR:Arm", "-r B A"],
    "rtcon": ["A:out B:in", "B:in A:out", "--dry-run A:out B:in"],
    "rtconf": ["-l A", "A get p", "A set p 1", "A act default", "A diff B", "A dump"],
    "rtcryo": ["-o OUT SERVER", "-y SERVER", "--all SERVER"],
    "rtcwd": ["SERVER/x.host_cxt"],
    "rtdeact": ["A", "--wait 0.5 A B"],
    "rtdel": ["-z SERVER", "A", "-z A", "--dry-run --recursive SERVER/x.host_cxt"],
    "rtdis": ["A:out B:in", "A", "-i id A"],
    "rtdoc": ["A", "-f rst A", "--json A"],
    "rtdoctor": ["SERVER", "--json SERVER", "A", "--profile FILE SERVER"],
    "rtec": ["A", "--json A", "A rate 100", "A start", "A attach B", "--measure=0.3 A"],
    "rtexit": ["A", "--wait 0.5 A"],
    "rtfind": ["SERVER", "SERVER --state error", "--json SERVER -t z", "SERVER -n none --wait 0.5"],
    "rtfsm": ["A getstate", "A getstructure", "A seteventprofiles a:TimedLong"],
    "rtinject": ["--anyway -c {\"data\":1} A:in", "-c {\"data\":1} -n 3 -r 100 B:in A:in", "--anyway -c 1 -n 3 -r 100 B:in A:in"],
    "rtlog": ["-f OUT -t 0.5 A:out", "-p -f LOG A:in", "-p --anyway -f LOG A:in"],
    "rtls": ["-lR SERVER", "-l SERVER", "SERVER", "--json -l SERVER", "A"],
    "rtmgr": ["-r MGR", "-c Mock MGR", "-l Mock.so:MockInit -m --loaded --factories MGR", "-d Mock0 MGR"],
    "rtprint": ["-t 0.5 A:out", "-n 1 -t 0.5 --raw A:out B:out", "--pull -t 0.5 A:out", "--stats -t 0.5 A:out"],
    "rtreset": ["A", "--wait 0.5 A B"],
    "rtresurrect": ["FILE", "--dry-run FILE", "--rollback FILE"],
    "rtsh": ["-c {ls_-l_SERVER;cat_A}"],
    "rtstart": ["FILE", "--json --wait 0.5 FILE"],
    "rtstodot": ["--live FILE", "--live --text FILE", "--live --svg FILE"],
    "rtstop": ["FILE", "--json --wait 0.5 FILE"],
    "rtteardown": ["FILE", "--dry-run FILE", "--rollback FILE"],
    "rttop": ["-n 1 A"],
    "rtvlog": ["-t 0.5 A"],
    "rtwatch": ["-t 0.5 A", "-f LIFE_EVENT -t 0.5 A B"],
}

# Those that only look, and print the same as long as nothing changes.
LOOKING = ["rtls -lR SERVER", "rtls --json -l SERVER", "rtcat -ll A B", "rtcat --json A", "rtconf -l A", "rtconf --json A",
           "rtec A", "rtfind --json SERVER", "rtcheck -s Inactive FILE", "rtstodot --live --text FILE", "rtdoc A",
           "rtdoctor -q A", "rtcwd SERVER", "rtresurrect --dry-run FILE", "rtteardown --dry-run FILE", "rtstart --dry-run FILE",
           "rtcon --dry-run A:out B:in", "rtdel --dry-run -z SERVER", "rtmgr -r MGR", "rtfsm A getstate"]

LOCAL = {"rtpwd"}  # these contact nobody

# Words with which a command goes on until it is ended; it must have someone to ask.
LASTING = {"rtprint": "A:out", "rtlog": "-f OUT A:out", "rtwatch": "A", "rtvlog": "A", "rttop": "A",
           "rtinject": "--anyway -n -1 -r 50 -c {\"data\":1} B:in", "rtfind": "SERVER -n none --wait 60", "rtact": "--wait 60 A",
           "rtsh": ""}


def all_commands():
    """Names of all files in bin/."""
    directory = os.path.join(processes.ROOT, "bin")
    return sorted(name for name in os.listdir(directory) if re.match(r"rt\w+$", name))


def words(line, places):
    """The words of a line of the tables, with what stands for things replaced: places = {"A": path, …}.

    Braces keep words together in which _ stands for a blank.
    """
    def word(w):
        if w.startswith("{") and w.endswith("}") and '"' not in w:
            w = w[1:-1].replace("_", " ")
        return re.sub(r"\b(SERVER|A|B|MGR|FILE|OUT|LOG)\b", lambda found: places[found.group()], w)
    return [word(w) for w in line.split()]
