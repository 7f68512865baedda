"""Corrupted answers of a robot: recorded GIOP replies with changes, served by a socket to commands in a child
process.

    python3 tests/fuzz/fuzz_replies.py     records tests/data/replies.json anew, from omniNames and mock components

A case is JSON: the words of a command, and which replies are changed to what: [[operation, how many of its
replies come before, the message in hex], ...]. All objects live behind one port, whatever the references said
when they were recorded.
"""  # noqa: E501

import json
import os
import re
import signal
import struct
import subprocess
import sys
import threading

import fuzz
import listening
import relay
import tools
from mock_components import giop  # which fuzz makes findable

RECORDED = os.path.join(fuzz.DATA, "replies.json")
WORLDS = [["linked"], ["config"], ["manager"]]
DIRECTORY = "test.host_cxt"
COMMANDS = [
    ["rtls", "-lR"],
    ["rtls", "-l", DIRECTORY],
    ["rtls", DIRECTORY],
    ["rtcat", "-ll", DIRECTORY + "/ConsoleIn0.rtc"],
    ["rtcat", DIRECTORY + "/manager.mgr"],
    ["rtcat", "--json", DIRECTORY + "/ConsoleOut0.rtc:in"],
    ["rtfind", ".", "-t", "c"],
    ["rtconf", "-l", DIRECTORY + "/ConfigSample0.rtc", "list"],
    ["rtec", DIRECTORY + "/ConsoleIn0.rtc"],
    ["rtdis", "--dry-run", DIRECTORY + "/ConsoleIn0.rtc"],
    ["rtact", DIRECTORY + "/ConsoleIn0.rtc"],
    ["rtcryo", "."],
    ["rtdoctor", "."],
    ["rtdoc", DIRECTORY + "/ConfigSample0.rtc"],
    ["rtcall", "--limit", "1", DIRECTORY + "/ConsoleIn0.rtc", "get_component_profile"],
    ["rtcall", "--limit", "1", "--json", DIRECTORY + "/ConsoleIn0.rtc", "get_ports"],
    ["rtmgr", "--loaded", DIRECTORY + "/manager.mgr"],
    ["rtdel", "--dry-run", "-z", DIRECTORY],
]
TIMEOUT = 0.3  # seconds that a command waits for an answer
PATIENCE = 10.0  # the same for the robot as it was recorded, which answers, but only when it has a processor
# seconds for a whole command: several questions may be asked one after the other, and machines are shared
LIMIT = 4.0
MEMORY = 64 << 20  # bytes that a child may grow to on top of what it began with
# omniORBpy (4.3) reads a reference whose repository id is not UTF-8 into a null pointer. Nothing of ours can
# be put before that: replies are read in C++. faulthandler names the call in a stub.
OMNIORBS = "ended by omniORBpy"
IN_STUB = re.compile(r"Current thread .*\n  File \".*(_idl|/CORBA)\.py\", line")
WORDS = [
    b"\0\0\0\0",
    b"\1\0\0\0",
    b"\xff\xff\xff\xff",
    b"\xff\xff\xff\x7f",
    b"\0\0\0\x80",
    b"\0\0\0\x10",
    b"\1\0\0\1",
    b"\x1b[2J",
    b"\xc2\x9b",
    b"\xe2\x80\xae",
    b"\n",
    b"\0",
    b"GIOP",
    b"IDL:",
    b"\6\0\0\0RTC:x\0",
]


# ---- serving ----

class Robot(listening.Listener):
    """A port behind which all recorded objects live; `changed` is {(operation, number): message}."""

    def __init__(self, recorded, changed):
        self.recorded = recorded
        self.changed = changed
        self.counts = {}
        self.lock = threading.Lock()
        super().__init__()

    def talk(self, connection):
        try:
            while True:  # a question that cannot be read ends it
                request = giop.read_request(connection)
                if request.type == giop.LOCATE_REQUEST:
                    connection.sendall(giop.harmless_answer(request))
                elif request.expects_reply:
                    connection.sendall(self._answer(request))
        except (struct.error, IndexError, ValueError):
            pass

    def _answer(self, request):
        with self.lock:
            number = self.counts[request.operation] = self.counts.get(request.operation, -1) + 1
        message = self.changed.get((request.operation, number)) or found(self.recorded, request)
        if message is None:
            return giop.bad_operation(request)
        message = (
            message[:12] + struct.pack("<I", request.id) + message[16:] if message[:4] == b"GIOP" else message
        )
        return relay.HOST.sub(lambda _: b"127.0.0.1\0" + struct.pack("<H", self.port), message)


def asked(request):
    """What distinguishes requests: the object, the operation, its arguments."""
    reader = request.arguments
    return [request.key.hex(), request.operation, reader.data[reader.position:].hex()]


def found(recorded, request):
    """The recorded reply to a request, or to the most similar one."""
    wanted = asked(request)
    for count in (3, 2):
        for *question, message in recorded:
            if question[:count] == wanted[:count]:
                return message
    return next((message for _, operation, _, message in recorded if operation == request.operation), None)


def load():
    """What was recorded: [[object key, operation, arguments, reply], ...]."""
    with open(RECORDED) as file:
        return [
            [key, operation, arguments, bytes.fromhex(message)]
            for key, operation, arguments, message in json.load(file)
        ]


# ---- the target ----

class Replies(fuzz.Target):
    name = "replies"
    orb = "omniorb"
    alone = False  # the limits are those of the child
    ended_by_omniorb = 0

    def prepare(self):
        self.recorded = load()
        self.child = None
        self._counts = {}
        self.timeout = PATIENCE
        for words in COMMANDS:  # which replies a command gets, so that no change is in vain
            robot = Robot(self.recorded, {})
            said = self._run(words, robot)
            if not robot.counts:
                raise AssertionError("%s: %s" % (words, said))
            self._counts[" ".join(words)] = sorted(robot.counts.items())
        self._end()
        self.timeout = TIMEOUT

    def done(self):
        self._end()
        if self.ended_by_omniorb:
            self.remark = ", %d ended by omniORBpy itself" % self.ended_by_omniorb

    def make(self, rng):
        words = rng.choice(COMMANDS)
        changes = []
        for _ in range(rng.choice((1, 1, 1, 2, 5))):
            operation, last = rng.choice(self._counts[" ".join(words)])
            messages = [message for _, name, _, message in self.recorded if name == operation]
            if messages:
                may_be_silent = operation != "get_loadable_modules"  # which has half a minute
                changes.append(
                    [
                        operation,
                        rng.randint(0, last),
                        self._spoilt(rng, rng.choice(messages), may_be_silent).hex(),
                    ]
                )
        return json.dumps({"words": words, "changes": changes}).encode()

    def _spoilt(self, rng, message, may_be_silent):
        """Mostly the body is changed and the length is right: a wrong one costs a timeout and shows little.
        """
        while True:
            body = fuzz.spoilt(rng, message[16:], WORDS, [rng.choice(self.recorded)[3]])
            if rng.random() < 0.5:  # a number at its place, or any other four octets
                at = rng.randrange(0, max(len(message) - 16, 1), 4)
                body = message[16:16 + at] + rng.choice(WORDS[:7]) + message[20 + at:]
            head = message[:8] + struct.pack("<I", len(body) + 4)
            if may_be_silent and rng.random() < 0.05:
                head = fuzz.spoilt(rng, message[:12], WORDS, [message])
            changed = head + message[12:16] + body
            # nobody else's host is asked
            if len(relay.HOST.findall(changed)) == len(relay.HOST.findall(message)):
                return changed

    def check(self, data):
        wanted = json.loads(data.decode())
        robot = Robot(self.recorded, {(operation, number): bytes.fromhex(message)
                                      for operation, number, message in wanted["changes"]})
        status, said, seconds, grown = self._run(wanted["words"], robot)
        wrong = None
        if status == OMNIORBS:
            self.ended_by_omniorb += 1
            raise fuzz.Refused(said)
        if "Traceback" in said or status not in range(7):
            wrong = "status %s" % status
        elif re.search("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]", said):
            wrong = "control characters"
        elif seconds > LIMIT:
            wrong = "%.1f s" % seconds
        elif grown > MEMORY:
            wrong = "%d MiB of memory" % (grown >> 20)
        if wrong:
            self._end()
            raise fuzz.Crash("%s: %s\n%s" % (" ".join(wanted["words"]), wrong, said))
        if status:
            raise fuzz.Refused(said)

    def _run(self, words, robot):
        """The exit status of a command, its output, how many seconds it took but for those in which it waited
        for a processor, by how much its process has grown meanwhile.
        """
        if not self.child:
            self.child = subprocess.Popen(
                [sys.executable, os.path.abspath(__file__), "--child"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                env=dict(
                    os.environ, RTSHELL_DEBUG="1", RTSHELL_TIMEOUT=str(self.timeout), RTSHELL_ORB=self.orb
                ),
            )
        watch = tools.Stopwatch(self.child.pid)
        # faulthandler says where it hangs
        timer = threading.Timer(5 * LIMIT, self.child.send_signal, [signal.SIGABRT])
        timer.start()
        try:
            self.child.stdin.write(json.dumps({"words": words, "port": robot.port}).encode() + b"\n")
            self.child.stdin.flush()
            answer = self.child.stdout.readline()
        except OSError:
            answer = b""
        finally:
            timer.cancel()
            robot.close()
        if not answer:
            said = self.child.stderr.read().decode("utf-8", "replace")
            status = self.child.wait()
            self._end()
            return (
                (
                    OMNIORBS
                    if status == -signal.SIGSEGV and IN_STUB.search(said)
                    else "of the process: %d" % status
                ),
                said,
                0,
                0,
            )
        answer = json.loads(answer.decode())
        return answer["status"], answer["said"], watch.seconds(), answer["grown"]

    def _end(self):
        if self.child:
            self.child.kill()
            self.child.wait()
            for pipe in (self.child.stdin, self.child.stdout, self.child.stderr):
                pipe.close()
            self.child = None


class Builtin(Replies):
    """The same for our own ORB."""

    name = "builtin"
    orb = "builtin"


# ---- the child ----

def serve():
    """Run the commands on stdin, a line of JSON each, and print their results."""
    import faulthandler
    import io
    from rtshell_lite import cli, notes
    from rtshell_lite.shell import installation
    files = installation.commands()
    modules = {}
    out = sys.stdout
    notes.listener = cli._hear
    faulthandler.enable()
    for line in sys.stdin:
        asked = json.loads(line)
        before = _memory()
        name, *words = asked["words"]
        if name not in modules:
            modules[name] = installation.load(files[name], "fuzzed_" + name)
        os.environ.update(
            RTCTREE_NAMESERVERS="127.0.0.1:%d" % asked["port"], RTCSH_CWD="/127.0.0.1:%d" % asked["port"]
        )
        sys.argv = [name] + words
        sys.stdout = sys.stderr = io.TextIOWrapper(
            io.BytesIO(), "utf-8", "backslashreplace", line_buffering=True
        )
        status = cli.command(modules[name].arguments, modules[name].run, modules[name].__doc__, words)
        said = sys.stdout.buffer.getvalue().decode("utf-8")
        sys.stdout = out
        sys.stderr = sys.__stderr__
        out.write(json.dumps({"status": status, "said": said, "grown": _memory() - before}) + "\n")
        out.flush()
    os._exit(0)


def _memory():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096


# ---- recording ----

class Recorder(relay.Relay):
    """Records requests and replies."""

    def __init__(self):
        super().__init__()
        self.noted = []

    def passed(self, request, reply):
        plain = relay.HOST.sub(b"127.0.0.1\0\xff\xff", reply[:12] + bytes(4) + reply[16:])
        entry = asked(request) + [plain.hex()]
        if entry[:3] not in [known[:3] for known in self.noted]:
            self.noted.append(entry)
        return reply


def record():
    """Run all commands once against omniNames and mocks."""
    import worlds
    worlds.start_name_server()
    running = [worlds.World(*words) for words in WORLDS]
    recorder = Recorder()
    place = "127.0.0.1:%d" % recorder.front(worlds.Server.port)
    environment = dict(worlds.ENVIRONMENT, RTCTREE_NAMESERVERS=place, RTCSH_CWD="/" + place)
    for name, *words in COMMANDS:
        subprocess.run([sys.executable, os.path.join(fuzz.ROOT, "bin", name)] + words, env=environment)
    for world in running:
        world.close()
    worlds.Server.stop()
    with open(RECORDED, "w") as file:
        json.dump(sorted(recorder.noted), file, indent=0)
        file.write("\n")


if __name__ == "__main__":
    serve() if "--child" in sys.argv else record()
