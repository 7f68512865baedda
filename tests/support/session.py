"""The surroundings of one transcript: a name server, peers, one shell, and the commands to play with them.

`session.py` is started by transcripts.py, one process group a transcript; it reads a request
(JSON, one line) and answers with each step's output and status. The group dies with it, and it dies
when its stdin ends, so that nothing survives a runner that was killed.

Lines at the margin of a transcript that ask for surroundings:
    world: two            mock components, in a process of their own; several such lines, several processes
    server: another       a second omniNames, on $PORT2 (`world: two --nameserver localhost:$PORT2`), and so on
    faulty: silent drip   peers that misbehave, their ports $SILENT and $DRIP; see python3 -m mock_components.faulty -h
    needs: fuse           skipped where no file systems can be mounted
    python: pure          needs no omniORB: no name server runs (nothing listens on $PORT)
    orb: omniorb          for this ORB only, or for `builtin`; the others are played with both
    alone: it measures    run when few others run, and none that compute
    once: what peers do   on one Python of the matrix only

Commands that exist only inside a session: see tools.py.
"""  # noqa: E501

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading

import mounts
import processes
import tools

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
    processes.open_session(top)
    environment = surroundings(top, home, request["commands"], dict(asked).get("orb", request["orb"]))
    environment["MOCKS"] = os.path.join(processes.ROOT, "mock_components")  # which has IDL files
    environment["MOCK_PYTHON"] = sys.executable  # which has omniORBpy
    substitutions = [
        (re.escape(home), "$TMP"),
        (re.escape(top), "$SESSION"),
        (re.escape(environment["MOCKS"]), "$MOCKS"),
        (UUID, "$UUID"),
    ]
    try:
        environment["PORT"] = (
            str(processes.nameserver.free_port()) if pure else processes.start_name_server("names")[1]
        )
        start_peers(asked, environment)
    except tools.Failed as e:
        return {"results": [], "substitutions": substitutions, "problem": str(e)}
    environment["RTCTREE_NAMESERVERS"] = "localhost:" + environment["PORT"]
    environment["RTCSH_CWD"] = "/localhost:%(PORT)s/test.host_cxt" % environment
    for name in sorted(environment):
        # a port; all have five digits, so that columns stay where they are
        if re.match("[0-9]{5}$", environment[name]):
            substitutions.append((r"(?<![0-9])%s(?![0-9])" % environment[name], "$" + name))
    results, problem = play(request, environment, home)
    return {"results": results, "substitutions": substitutions, "problem": problem}


def surroundings(top, home, commands, orb):
    """The environment of the session's shell: nothing of the developer's own gets in."""
    directory = os.path.join(top, "bin")
    os.mkdir(directory)
    for name in tools.NAMES:
        write_tool(
            os.path.join(directory, name), '"%s" -I -S "%s" %s' % (sys.executable, tools.__file__, name)
        )
    # it takes the C locale for ASCII
    is_old = commands and os.path.isdir(os.path.join(os.path.dirname(commands), "lib", "python3.6"))
    environment = {
        "HOME": home,
        "TMP": home,
        "TMPDIR": home,
        "SESSION": top,
        "LC_ALL": "C.UTF-8" if is_old else "C",
        "TERM": "xterm",
        # how tests/run finds what was left behind
        "RTSHELL_TESTS": os.environ.get("RTSHELL_TESTS", ""),
    }
    if orb:
        environment["RTSHELL_ORB"] = orb
    if commands:
        # peers find the mocks here, and rtshell_lite where it is installed
        os.mkdir(os.path.join(top, "python"))
        os.symlink(
            os.path.join(processes.ROOT, "mock_components"), os.path.join(top, "python", "mock_components")
        )
    else:
        commands = os.path.join(processes.ROOT, "bin")
        environment["PYTHONPATH"] = processes.ROOT
        environment["PYTHONDONTWRITEBYTECODE"] = "1"
        write_tool(os.path.join(directory, "python3"), '"%s"' % sys.executable)
    environment["PATH"] = os.pathsep.join([commands, directory, "/usr/local/bin", "/usr/bin", "/bin"])
    return environment


def write_tool(path, command):
    with open(path, "w") as file:
        file.write('#!/bin/sh\nexec %s "$@"\n' % command)
    os.chmod(path, 0o755)


def play(request, environment, home):
    """Run all steps in one shell: pairs of output and status, and what went wrong with the session itself."""
    script = tools.session_file("script")
    output = tools.session_file("output")
    with open(script, "w", encoding="utf-8") as file:
        file.write(
            "_mark() { _status=$?; printf '%%s%%s %%s\\n' '%s' $1 $_status; return $_status; }\n" % MARK
        )
        for number, step in enumerate(request["steps"]):
            file.write("%s\n_mark %d\n" % (step, number))
    problem = None
    with open(output, "wb") as out:
        shell = subprocess.Popen(
            request["shell"] + [script],
            stdin=subprocess.DEVNULL,
            stdout=out,
            stderr=out,
            cwd=home,
            env=environment,
            preexec_fn=tools.hear_ctrl_c,
        )
    try:
        shell.wait(request["time_limit"])
    except subprocess.TimeoutExpired:
        problem = "no end after %g s" % request["time_limit"]
    with open(output, "rb") as file:
        parts = re.split((MARK + r"(\d+) (\d+)\n").encode(), file.read())
    results = [(parts[i].decode("latin-1"), int(parts[i + 2])) for i in range(0, len(parts) - 1, 3)]
    if len(results) < len(request["steps"]):
        problem = "%s in: %s\n%s" % (
            problem or "the shell ended (%s)" % shell.returncode,
            request["steps"][len(results)],
            parts[-1].decode("utf-8", "backslashreplace"),
        )
    return results, problem


def start_peers(asked, environment):
    """Start all that the transcript asks for at once, wait for each, put where they are into the environment.
    """
    waiting = []
    for kind, words in asked:
        for name in sorted(environment, key=len, reverse=True):
            words = words.replace("$" + name, environment[name])
        if kind == "server":
            name = unused(environment, "PORT")
            last = max(environment[each] for each in environment if re.match(r"PORT\d*$", each))
            environment[name] = processes.start_name_server(name.replace("PORT", "names"), above=last)[1]
        elif kind == "world":
            process, name = processes.start_world(words.split(), environment["PORT"])
            environment[unused(environment, "MOCK_CONTROL")] = tools.control(name)
            waiting.append((process, name))
        elif kind == "faulty":
            waiting.append(processes.start_faulty(words.split()))
    for process, name in waiting:
        line = processes.ready(process, name)
        if line.startswith("{"):
            environment.update(
                (re.sub(r"\W", "_", mode).upper(), str(port)) for mode, port in json.loads(line).items()
            )


def unused(environment, variable):
    """VARIABLE, VARIABLE2, VARIABLE3 …"""
    names = [variable] + ["%s%d" % (variable, number) for number in range(2, 100)]
    return next(name for name in names if name not in environment)


def main():
    request = json.loads(sys.stdin.readline())
    threading.Thread(target=die_with_parent, args=(request["top"],), daemon=True).start()
    sys.stdout.write(json.dumps(run(request)) + "\n")
    sys.stdout.flush()
    signal.pause()  # until the group is killed


def die_with_parent(top):
    sys.stdin.read()
    mounts.take_away(top)
    shutil.rmtree(top, ignore_errors=True)
    os.killpg(0, signal.SIGKILL)


if __name__ == "__main__":
    main()
