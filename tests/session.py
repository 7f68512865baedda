"""The surroundings of one transcript: a name server, peers, one shell, and the commands to play with them.

`session.py run` is started by transcripts.py, one process group a transcript; it reads a request
(JSON, one line) and answers with each step's output and status. The group dies with it, and it dies
when its stdin ends, so that nothing survives a runner that was killed.

Lines at the margin of a transcript that ask for surroundings:
    world: two            mock components, in a process of their own; several such lines, several processes
    faulty: silent        a peer that misbehaves; its port is $FAULTY, the next one's $FAULTY2
    python: pure          needs no omniORB: no name server runs (nothing listens on $PORT)
    alone: it measures    run while nothing else runs

Commands that exist only inside a session: see the functions named play_…
"""
import json
import os
import random
import re
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
START_LIMIT = 30.0  # seconds until a peer must have said that it is ready
MARK = "-- end of step "
UUID = r"\b[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}\b"


class Failed(Exception):
    pass


# ---- the session, on behalf of transcripts.py ----

def run(request):
    top = request["top"]
    home = os.path.join(top, "home")
    os.mkdir(home)
    asked = [tuple(pair) for pair in request["directives"]]
    pure = ("python", "pure") in asked
    if not pure and not omninames():
        return {"skip": "omniORBpy is not installed in %s" % sys.prefix}
    os.environ["SESSION"] = top  # where the functions below keep their files
    keep_alive()
    environment = surroundings(top, home, request["commands"])
    substitutions = [(re.escape(home), "$TMP"), (re.escape(top), "$SESSION"), (UUID, "$UUID")]
    try:
        environment["PORT"] = str(free_port() if pure else start_name_server())
        environment.update(start_peers(asked, environment["PORT"]))
    except Failed as e:
        return {"results": [], "substitutions": substitutions, "problem": str(e)}
    environment["RTCTREE_NAMESERVERS"] = "localhost:" + environment["PORT"]
    environment["RTCSH_CWD"] = "/localhost:%(PORT)s/test.host_cxt" % environment
    for name in sorted(environment):
        if re.match("(PORT|FAULTY[0-9]*)$", name):
            substitutions.append((r"(?<![0-9])%s(?![0-9])" % environment[name], "$" + name))
    results, problem = play(request, environment, home)
    return {"results": results, "substitutions": substitutions, "problem": problem}


def keep_alive():
    """Make the pipe that every peer has as stdin: it ends when this process does."""
    os.mkfifo(session_file("alive"))
    os.open(session_file("alive"), os.O_RDWR)  # never closed


def surroundings(top, home, commands):
    """The environment of the session's shell: nothing of the developer's own gets in."""
    tools = os.path.join(top, "bin")
    os.mkdir(tools)
    plays = [name[5:].replace("_", "-") for name in globals() if name.startswith("play_")]
    for name in plays:
        write_tool(os.path.join(tools, name), '"%s" "%s" %s' % (sys.executable, os.path.abspath(__file__), name))
    environment = {"HOME": home, "TMP": home, "TMPDIR": home, "SESSION": top, "LC_ALL": "C", "TERM": "xterm",
                   "RTSHELL_TESTS": os.environ.get("RTSHELL_TESTS", "")}  # how tests/run finds what was left behind
    if commands:
        os.mkdir(os.path.join(top, "python"))  # peers find the mocks here, and rtshell_lite where it is installed
        os.symlink(os.path.join(ROOT, "mock_components"), os.path.join(top, "python", "mock_components"))
    else:
        commands = os.path.join(ROOT, "bin")
        environment["PYTHONPATH"] = ROOT
        environment["PYTHONDONTWRITEBYTECODE"] = "1"
        write_tool(os.path.join(tools, "python3"), '"%s"' % sys.executable)
    environment["PATH"] = os.pathsep.join([commands, tools, "/usr/local/bin", "/usr/bin", "/bin"])
    return environment


def write_tool(path, command):
    with open(path, "w") as file:
        file.write('#!/bin/sh\nexec %s "$@"\n' % command)
    os.chmod(path, 0o755)


def play(request, environment, home):
    """Run all steps in one shell: pairs of output and status, and what went wrong with the session itself."""
    script, output = session_file("script"), session_file("output")
    with open(script, "w", encoding="utf-8") as file:
        file.write("_mark() { _status=$?; printf '%%s%%s %%s\\n' '%s' $1 $_status; return $_status; }\n" % MARK)
        for number, step in enumerate(request["steps"]):
            file.write("%s\n_mark %d\n" % (step, number))
    problem = None
    with open(output, "wb") as out:
        shell = subprocess.Popen(request["shell"] + [script], stdin=subprocess.DEVNULL, stdout=out, stderr=out,
                                 cwd=home, env=environment, preexec_fn=hear_ctrl_c)
    try:
        shell.wait(request["time_limit"])
    except subprocess.TimeoutExpired:
        problem = "no end after %g s" % request["time_limit"]
    with open(output, "rb") as file:
        parts = re.split((MARK + r"(\d+) (\d+)\n").encode(), file.read())
    results = [(parts[i].decode("latin-1"), int(parts[i + 2])) for i in range(0, len(parts) - 1, 3)]
    if len(results) < len(request["steps"]):
        problem = "%s in: %s\n%s" % (problem or "the shell ended (%s)" % shell.returncode,
                                     request["steps"][len(results)], parts[-1].decode("utf-8", "backslashreplace"))
    return results, problem


def hear_ctrl_c():
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # a runner in the background ignores it, and that is inherited


# ---- peers ----

def omninames():
    """The real omniNames of this Python's omniORBpy: the script on PATH is a wrapper that survives its death."""
    for entry in sys.path:
        for package in ("jeteve_omniorb", "omniORB"):
            path = os.path.join(entry, package, "bin", "omniNames")
            if os.path.exists(path):
                return path
    try:
        import omniORB  # noqa: F401  an operating system's package brings its own omniNames
    except ImportError:
        return None
    return shutil.which("omniNames")


def free_port():
    """A port below the kernel's ephemeral range, so that no outgoing connection takes it in between."""
    for _ in range(200):
        port = random.randrange(12000, 32000)
        with socket.socket() as probe:
            try:
                probe.bind(("127.0.0.1", port))
                return port
            except OSError:
                pass
    raise Failed("no free port")


def start_name_server():
    for attempt in range(5):  # another session may have taken the port since it was found free
        port = free_port()
        data = session_file("names%d" % attempt)
        os.mkdir(data)
        server = start_peer("names%d" % attempt, [omninames(), "-start", str(port), "-logdir", data, "-ORBendPoint",
                                                  "giop:tcp:127.0.0.1:%d" % port])
        if wait_for_line(server, "names%d" % attempt, "Root context is"):
            return port
    raise Failed("omniNames does not start: " + said("names%d" % attempt))


def start_peers(asked, port):
    """Start all worlds and faulty peers at once, wait for each: the variables that tell where they are."""
    variables, waiting, seen = {}, [], {"world": "MOCK_CONTROL", "faulty": "FAULTY"}
    numbers = {"world": 0, "faulty": 0}
    for kind, words in asked:
        if kind in seen:
            numbers[kind] += 1
            variable = seen[kind] + (str(numbers[kind]) if numbers[kind] > 1 else "")
            start = start_world if kind == "world" else start_faulty
            waiting.append((variable, kind) + start(words.replace("$PORT", port).split(), port))
    for variable, kind, process, name in waiting:
        ready = wait_for_line(process, name, "ready")
        if not ready:
            raise Failed("%s is not ready: %s" % (name, said(name)))
        variables[variable] = control(name) if kind == "world" else re.search(r"\b\d{4,5}\b", ready).group()
    return variables


def start_world(words, port):
    name = unused_name(words[0])
    return start_peer(name, [sys.executable, "-m", "mock_components"] + words +
                      ["--nameserver", "localhost:" + port, "--control", control(name)]), name


def start_faulty(words, port):
    name = unused_name(words[0])
    return start_peer(name, [sys.executable, "-m", "mock_components.faulty"] + words), name


def start_peer(name, command):
    """Start a process that ends when this session does; its words go to a file, its number to another."""
    environment = dict(os.environ, PYTHONPATH=mocks(), PYTHONUNBUFFERED="1", PYTHONDONTWRITEBYTECODE="1")
    with open(session_file("alive")) as alive, open(session_file(name + ".out"), "wb") as out:
        process = subprocess.Popen(command, stdin=alive, stdout=out, stderr=out, cwd=session_file(""), env=environment)
    with open(session_file(name + ".pid"), "w") as file:
        file.write(str(process.pid))
    return process


def wait_for_line(process, name, start):
    """The first line of a peer's output that holds `start`, or nothing if it ended or took too long."""
    deadline = time.monotonic() + START_LIMIT
    while time.monotonic() < deadline:
        ended = process.poll() is not None
        for line in said(name).splitlines(True):
            if start in line and line.endswith("\n"):
                return line
        if ended:
            return None
        time.sleep(0.01)
    return None


def said(name):
    with open(session_file(name + ".out"), encoding="utf-8", errors="replace") as file:
        return file.read()


def session_file(name):
    return os.path.join(os.environ["SESSION"], name)


def mocks():
    """Where to import mock_components from, without importing rtshell_lite from there if it is installed."""
    apart = session_file("python")
    return apart if os.path.isdir(apart) else ROOT


def control(name):
    return session_file(name + ".control")


def unused_name(name):
    known, number = name, 1
    while os.path.exists(session_file(known + ".pid")):
        number += 1
        known = "%s%d" % (name, number)
    return known


# ---- commands of a session ----

def play_mock(words):
    """mock WORLD [ARGUMENT...]: start one more world; the others know it by its first word (two, two2 …)."""
    process, name = start_world(words, os.environ["PORT"])
    if not wait_for_line(process, name, "ready"):
        raise Failed("%s is not ready: %s" % (name, said(name)))


def play_ctl(words):
    """ctl [@WORLD] WORD...: talk to a world's control socket, by default the first one's."""
    where = os.environ.get("MOCK_CONTROL", "")
    if words and words[0].startswith("@"):
        where, words = control(words[0][1:]), words[1:]
    command = [sys.executable, "-m", "mock_components", "ctl", where]
    return subprocess.call(command + words, env=dict(os.environ, PYTHONPATH=mocks()))


def play_calls(words):
    """calls [@WORLD] ...: the calls that a world's components received."""
    world = words[:1] if words and words[0].startswith("@") else []
    return play_ctl(world + ["calls"] + words[len(world):])


def play_kill_mock(words):
    """kill-mock WORLD: kill -9, so that its names stay bound."""
    tell(words, signal.SIGKILL, "gone")


def play_end_mock(words):
    """end-mock WORLD: ask it to end, and wait."""
    tell(words, signal.SIGTERM, "gone")


def play_hang(words):
    """hang WORLD: stop its process; it accepts connections and never answers."""
    tell(words, signal.SIGSTOP, "stopped")


def play_resume(words):
    """resume WORLD: let it go on."""
    tell(words, signal.SIGCONT, "running")


def tell(names, number, state):
    for name in names:
        try:
            with open(session_file(name + ".pid")) as file:
                process = int(file.read())
        except OSError:
            raise Failed("no world named %s" % name)
        os.kill(process, number)
        deadline = time.monotonic() + START_LIMIT
        while state_of(process) != state:
            if time.monotonic() > deadline:
                raise Failed("%s is still %s" % (name, state_of(process)))
            time.sleep(0.005)


def state_of(process):
    try:
        with open("/proc/%d/stat" % process) as file:
            letter = file.read().rpartition(") ")[2][0]
    except OSError:
        return "gone"
    return {"Z": "gone", "X": "gone", "T": "stopped"}.get(letter, "running")


def play_within(words):
    """within LEAST-MOST COMMAND...: complain if the command takes less or more seconds; status is the command's."""
    least, most = [float(number) for number in words[0].split("-")]
    begun = time.monotonic()
    status = shell_status(subprocess.call(words[1:], preexec_fn=hear_ctrl_c))
    taken = time.monotonic() - begun
    if not least <= taken <= most:
        sys.stdout.write("took %.2f s, not %s\n" % (taken, words[0]))
        return status or 99
    return status


def play_interrupt(words):
    """interrupt SECONDS COMMAND...: press Ctrl-C after that long; the command must be gone 0.3 s later."""
    process = subprocess.Popen(words[1:], preexec_fn=hear_ctrl_c)
    try:
        process.wait(float(words[0]))
        sys.stdout.write("ended before Ctrl-C\n")
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(0.3)
        except subprocess.TimeoutExpired:
            sys.stdout.write("still there 0.3 s after Ctrl-C\n")
            process.kill()
            process.wait()
    return shell_status(process.returncode)


def play_tty(words):
    """tty COLUMNS COMMAND...: run the command on a terminal that wide, show what it writes there."""
    import fcntl
    import pty
    import struct
    import termios
    child, terminal = pty.fork()
    if child == 0:
        try:  # the size is set from this side, before the command can ask for it
            fcntl.ioctl(0, termios.TIOCSWINSZ, struct.pack("HHHH", 24, int(words[0]), 0, 0))
            hear_ctrl_c()
            os.execvp(words[1], words[1:])
        finally:
            os._exit(127)
    while True:
        try:
            data = os.read(terminal, 65536)
        except OSError:  # how Linux says that the other side is closed
            data = b""
        if not data:
            break
        sys.stdout.buffer.write(data.replace(b"\r\n", b"\n"))
    status = os.waitpid(child, 0)[1]
    return os.WEXITSTATUS(status) if os.WIFEXITED(status) else 128 + os.WTERMSIG(status)


def shell_status(code):
    return 128 - code if code < 0 else code


def main():
    name, words = sys.argv[1], sys.argv[2:]
    if name == "run":
        request = json.loads(sys.stdin.readline())
        threading.Thread(target=die_with_parent, args=(request["top"],), daemon=True).start()
        sys.stdout.write(json.dumps(run(request)) + "\n")
        sys.stdout.flush()
        signal.pause()  # until the group is killed
    try:
        return globals()["play_" + name.replace("-", "_")](words)
    except Failed as e:
        sys.stderr.write("%s: %s\n" % (name, e))
        return 99


def die_with_parent(top):
    sys.stdin.read()
    shutil.rmtree(top, ignore_errors=True)
    os.killpg(0, signal.SIGKILL)


if __name__ == "__main__":
    sys.exit(main())
