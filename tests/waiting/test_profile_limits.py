"""Files that are meant to exhaust a reader of profiles are refused soon, in little memory."""
import concurrent.futures
import os
import subprocess
import sys
import unittest

ALONE = True  # it measures
ONCE = "the bounds are the same for every Python"
MIB = 1 << 20
SECONDS = 8.0  # of processor time for 16 MiB of the worst input; most take less than 0.1 s
MEGABYTES = 150  # beyond what the Python itself takes
ROOT = "rtsProfile: "

# Each is an expression that gives the file.
BOMBS = {
    "elements below elements": "b'<a>' * 10 ** 6",
    "many elements": "b'<a>' + b'<a/>' * (4 * MIB - 4)",
    "many attributes": "b'<a ' + b' '.join(b'a%d=\"\"' % i for i in range(90000)) + b'/>'",
    "more attributes": "b'<a ' + b'a=\"\" ' * (3 * MIB) + b'/>'",
    "a long attribute": "b'<a b=\"' + b'x' * 15 * MIB",
    "a long comment": "b'<!--' + b'x' * 15 * MIB",
    "a long text": "b'<a>' + b'x' * 15 * MIB",
    "many references": "b'<a>' + b'&lt;' * (3 * MIB)",
    "a file that is too long": "b'<a>' + b' ' * 50 * MIB",
    "an internal subset": "b'<!DOCTYPE a [' + b'<!ENTITY a \"b\">' * MIB",
    "UTF-16": "(u'<a>' + u'\\u65e5' * 7 * MIB).encode('utf-16')",
    "nothing but spellings of characters": "b'<a b=\"' + b'_x005F' * 150000 + b'\"/>'",
    "sections of components in version 0.1": (
        "V01 + (V01_COMPONENT + b'<StartUp/></Component>') * 20000 + b'</RtsProfile>'"
    ),
    "conditions and what is copied into each": (
        "V01 + V01_COMPONENT + b'<StartUp>' + b'<Condition/>' * 100000 + b'<Properties name=\"\"/>' * "
        "100000 + b'</StartUp></Component></RtsProfile>'"
    ),
    "connections of a port in version 0.1": (
        "V01 + V01_COMPONENT + b'<DataPorts name=\"\">' + b'<Properties name=\"\"/>' * 60000 + "
        "b'<DataPortConnectors/>' * 60000 + b'</DataPorts></Component></RtsProfile>'"
    ),
    "members of a composite in version 0.1": (
        "V01 + V01_COMPONENT + b'<Participants>' + b'<Participant/>' * 200000 + "
        "b'</Participants></Component></RtsProfile>'"
    ),
    "brackets": "b'[' * 15 * MIB",
    "braces": "b'{a: ' * 3 * MIB",
    "dashes": "b'- ' * 7 * MIB",
    "question marks": "b'? ' * 7 * MIB",
    "keys below keys": "b''.join(b' ' * i + b'a:\\n' for i in range(5000))",
    "list items": "ROOT + b'\\n' + b'- a\\n' * (3 * MIB)",
    "items in brackets": "ROOT + b'[' + b'a,' * (7 * MIB)",
    "keys": "b''.join(b'k%d: v\\n' % i for i in range(600000))",
    "ends of lines": "b'\\n' * 15 * MIB",
    "blanks": "b' ' * 15 * MIB",
    "blanks in quotes": "b'\"' + b' ' * 4000000 + b'\"'",
    "blanks in front of ends of lines in quotes": "b'\"' + (b' ' * 100 + b'\\n') * 40000 + b'\"'",
    "short words": "b'a ' * (7 * MIB)",
    "short lines of one text": "b'a\\n' * (7 * MIB)",
    "comments": "b'#\\n' * (7 * MIB)",
    "escapes": "b'\"' + b'\\\\x41' * 1000000 + b'\"'",
    "backslashes": "b'\"' + b'\\\\' * 4000000 + b'\"'",
    "escaped quotes": "b'\"' + b'\\\\\"' * 2000000 + b'\"'",
    "quotes": "b\"'\" + b\"''\" * 2000000 + b\"'\"",
    "a quote that is never closed": "b'a: \"' + b'x' * 15 * MIB",
    "a literal text": "b'a: |\\n' + b' b\\n' * (1300000)",
    "a digit": "ROOT + b'{pushInterval: ' + b'9' * 4000000 + b'}'",
    "colons": "b':' * 15 * MIB",
    "anchors": "b'[' + b'&a ' * (5 * MIB)",
    "anchors below anchors": "b'[&a ' * 149 + b'[' + b'x,' * 400000 + b']' * 150",
    "more aliases": (
        "b'a: &a [x,x]\\n' + b''.join(b'%c: &%c [*%c,*%c]\\n' % (i + 1, i + 1, i, i) for i in range(97, "
        "119))"
    ),
    "aliases": "b'a: &a [' + b'x,' * 1000 + b']\\nb: [' + b'*a,' * (5 * MIB)",
    "a huge number": "ROOT + b'{activation: {targets: [{sequence: ' + b'9' * 4000000 + b'}]}}'",
    "minutes": "ROOT + b'{x: ' + b'1' + b':59' * 1000000 + b'}'",
}

CHILD = """
import resource, sys, time
from rtshell_lite import errors
from rtshell_lite.xmlprofile import rtsprofile
from rtshell_lite.xmlprofile import xml
from rtshell_lite.xmlprofile.yaml import form
MIB, ROOT = 1 << 20, b"rtsProfile: "
V01 = b'<RtsProfile xmlns="http://www.openrtp.org/namespaces/rts" id="" version="0.1">'
V01_COMPONENT = b'<Component id="" pathUri="" instanceName="">'
def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / (1024.0 * 1024 if sys.platform == "darwin" else 1024)
before = peak()
data = EXPRESSION
held = len(data) / MIB
start = time.process_time()
try:
    rtsprofile.load(data, "bomb")
    said = "read"
except errors.BadProfile as e:
    said = str(e)
print(time.process_time() - start, max(peak() - before - held, 0), said)
"""  # noqa: E501


def read(expression):
    """The result of a child that reads such a file."""
    return subprocess.run(
        [sys.executable, "-c", CHILD.replace("EXPRESSION", expression)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        universal_newlines=True,
        timeout=120,
    )


class Bombs(unittest.TestCase):
    def test_each_is_refused_or_read_within_limits(self):
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            children = list(pool.map(read, BOMBS.values()))
        for name, child in zip(BOMBS, children):
            with self.subTest(name):
                self.assertEqual((child.returncode, child.stderr), (0, ""))
                seconds, megabytes, said = child.stdout.split(" ", 2)
                if "-v" in sys.argv:
                    sys.stderr.write(
                        "%6.2f s %6.1f MB  %s: %s" % (float(seconds), float(megabytes), name, said)
                    )
                self.assertTrue(said.startswith("bomb:") or said == "read\n", said)
                self.assertLess(float(seconds), SECONDS)
                self.assertLess(float(megabytes), MEGABYTES)


if __name__ == "__main__":
    unittest.main()
