"""The surroundings of one transcript: a name server, peers, one shell, and the commands to play with them.

`session.py run` is started by transcripts.py, one process group a transcript; it reads a request
(JSON, one line) and answers with each step's output and status. The group dies with it, and it dies
when its stdin ends, so that nothing survives a runner that was killed.

Lines at the margin of a transcript that ask for surroundings:
    world: two            mock components, in a process of their own; several such lines, several processes
    server: another       a second omniNames, on $PORT2 (`world: two --nameserver localhost:$PORT2`), and so on
    faulty: silent drip   peers that misbehave, their ports $SILENT and $DRIP; see python3 -m mock_components.faulty -h
    needs: fuse           skipped where no file systems can be mounted
    python: pure          needs no omniORB: no name server runs (nothing listens on $PORT)
    orb: omniorb          for this ORB only, or for `builtin`; the others are played with both
    alone: it measures    run when no more than one for each processor runs
    once: what peers do   on one Python of the matrix only

Commands that exist only inside a session: see the functions named play_…
"""
import json
import os
import re
import shutil
import signal
import stat
import subprocess
import sys
import threading
import time

import mounts
import processes
from mock_components import asking

UNWINDING = 2.0  # seconds that a command may take to tidy up after Ctrl-C, on a busy machine; the timeout is 3
MARK = "-- end of step "
UUID = r"\b[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}\b"


# ---- the session, on behalf of transcripts.py ----

def run(request):
    top = request["top"]
    home = os.path.join(top, "home")
    os.mkdir(home)
    asked = [tuple(pair) for pair in request["directives"]]
    pure = ("python", "pure") in asked
    if not pure and not processes.nameserver.binary():
        return {"skip": "omniORBpy is not installed in %s" % sys.prefix}
    if ("needs", "fuse") in asked and mounts.refused():
        return {"skip": "nothing can be mounted here: " + mounts.refused()}
    os.environ["SESSION"] = top  # where the functions below keep their files
    keep_alive()
    environment = surroundings(top, home, request["commands"], dict(asked).get("orb", request["orb"]))
    substitutions = [(re.escape(home), "$TMP"), (re.escape(top), "$SESSION"), (UUID, "$UUID")]
    try:
        environment["PORT"] = str(processes.nameserver.free_port()) if pure else processes.start_name_server("names")
        start_peers(asked, environment)
    except processes.Failed as e:
        return {"results": [], "substitutions": substitutions, "problem": str(e)}
    environment["RTCTREE_NAMESERVERS"] = "localhost:" + environment["PORT"]
    environment["RTCSH_CWD"] = "/localhost:%(PORT)s/test.host_cxt" % environment
    for name in sorted(environment):
        if re.match("[0-9]{5}$", environment[name]):  # a port; all have five digits, so that columns stay where they are
            substitutions.append((r"(?<![0-9])%s(?![0-9])" % environment[name], "$" + name))
    results, problem = play(request, environment, home)
    return {"results": results, "substitutions": substitutions, "problem": problem}


def keep_alive():
    """Make the pipe that every peer has as stdin: it ends when this process does."""
    os.mkfifo(processes.session_file("alive"))
    os.open(processes.session_file("alive"), os.O_RDWR)  # never closed


def surroundings(top, home, commands, orb):
    """The environment of the session's shell: nothing of the developer's own gets in."""
    tools = os.path.join(top, "bin")
    os.mkdir(tools)
    plays = [name[5:].replace("_", "-") for name in globals() if name.startswith("play_")]
    for name in plays:
        write_tool(os.path.join(tools, name), '"%s" "%s" %s' % (sys.executable, os.path.abspath(__file__), name))
    is_old = commands and os.path.isdir(os.path.join(os.path.dirname(commands), "lib", "python3.6"))  # it takes the C locale for ASCII
    environment = {"HOME": home, "TMP": home, "TMPDIR": home, "SESSION": top, "LC_ALL": "C.UTF-8" if is_old else "C", "TERM": "xterm",
                   "RTSHELL_TESTS": os.environ.get("RTSHELL_TESTS", "")}  # how tests/run finds what was left behind
    if orb:
        environment["RTSHELL_ORB"] = orb
    if commands:
        os.mkdir(os.path.join(top, "python"))  # peers find the mocks here, and rtshell_lite where it is installed
        os.symlink(os.path.join(processes.ROOT, "mock_components"), os.path.join(top, "python", "mock_components"))
    else:
        commands = os.path.join(processes.ROOT, "bin")
        environment["PYTHONPATH"] = processes.ROOT
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
    script, output = processes.session_file("script"), processes.session_file("output")
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


def start_peers(asked, environment):
    """Start all that the transcript asks for at once, wait for each, put where they are into the environment."""
    waiting = []
    for kind, words in asked:
        for name in sorted(environment, key=len, reverse=True):
            words = words.replace("$" + name, environment[name])
        if kind == "server":
            name = unused(environment, "PORT")
            last = max(environment[each] for each in environment if re.match(r"PORT\d*$", each))
            environment[name] = processes.start_name_server(name.replace("PORT", "names"), above=last)
        elif kind == "world":
            process, name = processes.start_world(words.split(), environment["PORT"])
            environment[unused(environment, "MOCK_CONTROL")] = processes.control(name)
            waiting.append((process, name))
        elif kind == "faulty":
            waiting.append(processes.start_faulty(words.split()))
    for process, name in waiting:
        line = processes.ready(process, name)
        if line.startswith("{"):
            environment.update((re.sub(r"\W", "_", mode).upper(), str(port)) for mode, port in json.loads(line).items())


def unused(environment, variable):
    """VARIABLE, VARIABLE2, VARIABLE3 …"""
    names = [variable] + ["%s%d" % (variable, number) for number in range(2, 100)]
    return next(name for name in names if name not in environment)


def hear_ctrl_c():
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # a runner in the background ignores it, and that is inherited


# ---- commands of a session ----

def play_mock(words):
    """mock WORLD [ARGUMENT...]: start one more world; the others know it by its first word (two, two2 …)."""
    processes.ready(*processes.start_world(words, os.environ["PORT"]))


def play_ctl(words):
    """ctl [@WORLD] WORD...: talk to a world's control socket, by default the first one's."""
    where = os.environ.get("MOCK_CONTROL", "")
    if words and words[0].startswith("@"):
        where, words = processes.control(words[0][1:]), words[1:]
    return asking.ask(where, words)


def play_calls(words):
    """calls [@WORLD] ...: the calls that a world's components received."""
    world = words[:1] if words and words[0].startswith("@") else []
    return play_ctl(world + ["calls"] + words[len(world):])


def play_kill_mock(words):
    """kill-mock WORLD: kill -9, so that its names stay bound."""
    processes.tell(words, signal.SIGKILL, "gone")


def play_end_mock(words):
    """end-mock WORLD: ask it to end, and wait."""
    processes.tell(words, signal.SIGTERM, "gone")


def play_hang(words):
    """hang WORLD: stop its process; it accepts connections and never answers."""
    processes.tell(words, signal.SIGSTOP, "stopped")


def play_start_again(words):
    """start-again SERVER: start a name server that was killed, at its old port, with its old names."""
    with open(processes.session_file(words[0] + ".command")) as file:
        processes.start(words[0], json.load(file))


def play_resume(words):
    """resume WORLD: let it go on."""
    processes.tell(words, signal.SIGCONT, "running")


def play_within(words):
    """within LEAST-MOST COMMAND...: complain if the command takes less or more seconds; status is the command's.

    What it was ready to run and was not let, as other tests had the processors, does not count as MOST.
    """
    least, most = [float(number) for number in words[0].split("-")]
    begun = time.monotonic()
    process = subprocess.Popen(words[1:], preexec_fn=hear_ctrl_c)
    os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
    taken, waited = time.monotonic() - begun, processes.waited_for_processor(process.pid)
    status = shell_status(process.wait())
    if taken < least or taken - waited > most:
        sys.stdout.write("took %.2f s (%.2f s of it for a processor), not %s\n" % (taken, waited, words[0]))
        return status or 99
    return status


def play_interrupt(words):
    """interrupt SECONDS COMMAND...: press Ctrl-C after that long; the command must be gone soon, long before the timeout."""
    process = subprocess.Popen(words[1:], preexec_fn=hear_ctrl_c)
    try:
        process.wait(float(words[0]))
        sys.stdout.write("ended before Ctrl-C\n")
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(UNWINDING)
        except subprocess.TimeoutExpired:
            sys.stdout.write("still there %g s after Ctrl-C\n" % UNWINDING)
            process.kill()
            process.wait()
    return shell_status(process.returncode)


def printed_on(terminal):
    """What programs print on a terminal, as bytes come, until all of them have ended."""
    while True:
        try:
            data = os.read(terminal, 65536)
        except OSError:  # how Linux says that the other side is closed
            return
        if not data:
            return
        yield data


def play_tty(words):
    """tty COLUMNS COMMAND...: run the command on a terminal that wide, type what comes through a pipe, show what is written there."""
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
    if stat.S_ISFIFO(os.fstat(0).st_mode):
        os.write(terminal, sys.stdin.buffer.read())
    for data in printed_on(terminal):
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
    except processes.Failed as e:
        sys.stderr.write("%s: %s\n" % (name, e))
        return 99


def die_with_parent(top):
    sys.stdin.read()
    mounts.take_away(top)
    shutil.rmtree(top, ignore_errors=True)
    os.killpg(0, signal.SIGKILL)


if __name__ == "__main__":
    sys.exit(main())
