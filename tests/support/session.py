"""The surroundings of one transcript: a name server, peers, one shell, and the commands to play with them.

`session.py DIRECTORY REQUEST` is a job (see jobs.py) that transcripts.py starts; the request is JSON.

Lines at the margin of a transcript that ask for surroundings:
    world: two            mock components, in a process of their own; several such lines, several processes
    server: another       a second omniNames, on $PORT2 (`world: two --nameserver localhost:$PORT2`), and so on
    faulty: silent drip   peers that misbehave, their ports $SILENT and $DRIP; see python3 -m mock_components.faulty -h
    needs: fuse           skipped where no file systems can be mounted
    python: pure          needs no omniORB: no name server runs (nothing listens on $PORT)
    orb: omniorb          for this ORB only, or for `builtin`; the others are played with both
    alone: it measures    run when few others run, and none that compute
    once: what peers do   on one Python of the matrix only

Commands that exist only inside a session: see tools.py, and helpers.sh for what needs no more than shell.
"""  # noqa: E501

import json
import os
import re
import subprocess
import sys

import jobs
import mounts
import processes
import tools
import transcripts

MARK = "-- end of step "
UUID = r"\b[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}\b"


def run(top, path, shell, commands, orb, accept, time_limit):
    """Play a transcript: ("pass", "fail" or "skip", explanation)."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    try:
        items = transcripts.parse(text)
    except transcripts.Malformed as e:
        return "fail", str(e)
    asked = transcripts.directives(items)
    pure = ("python", "pure") in asked
    if not pure and not processes.nameserver.binary():
        return "skip", "omniORBpy is not installed in %s" % sys.prefix
    if ("needs", "fuse") in asked and mounts.refused():
        return "skip", "nothing can be mounted here: " + mounts.refused()
    processes.open_session(top)
    environment = surroundings(top, commands, dict(asked).get("orb", orb))
    substitutions = [
        (re.escape(environment["HOME"]), "$TMP"),
        (re.escape(top), "$SESSION"),
        (re.escape(environment["MOCKS"]), "$MOCKS"),
        (UUID, "$UUID"),
    ]
    results = []
    try:
        environment["PORT"] = (
            str(processes.nameserver.free_port()) if pure else processes.start_name_server("names")
        )
        start_peers(asked, environment)
    except tools.Failed as e:
        problem = str(e)
    else:
        environment["RTCTREE_NAMESERVERS"] = "localhost:" + environment["PORT"]
        environment["RTCSH_CWD"] = "/localhost:%(PORT)s/test.host_cxt" % environment
        for name in sorted(environment):
            # a port; all have five digits, so that columns stay where they are
            if re.match("[0-9]{5}$", environment[name]):
                substitutions.append((r"(?<![0-9])%s(?![0-9])" % environment[name], "$" + name))
        words = ["\n".join(step.command) for step in transcripts.steps(items)]
        results, problem = play(words, shell, environment, time_limit)
    return transcripts.compare(path, text, items, results, problem, substitutions, accept)


def surroundings(top, commands, orb):
    """The environment of the session's shell: nothing of the developer's own gets in."""
    home = os.path.join(top, "home")
    directory = os.path.join(top, "bin")
    os.mkdir(home)
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
        "MOCKS": os.path.join(processes.ROOT, "mock_components"),  # which has IDL files
        "MOCK_PYTHON": sys.executable,  # which has omniORBpy
        "MOCK_PATH": os.environ.get("PYTHONPATH") or processes.ROOT,  # where it finds the mocks
        # how tests/run finds what was left behind
        "RTSHELL_TESTS": os.environ.get("RTSHELL_TESTS", ""),
    }
    if orb:
        environment["RTSHELL_ORB"] = orb
    if not commands:
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


def play(steps, shell, environment, time_limit):
    """Run all steps in one shell: pairs of output and status, and what went wrong with the session itself."""
    script = tools.session_file("script")
    output = tools.session_file("output")
    with open(script, "w", encoding="utf-8") as file:
        file.write('. "%s"\n' % os.path.join(jobs.HERE, "helpers.sh"))
        file.write(
            "_mark() { _status=$?; printf '%%s%%s %%s\\n' '%s' $1 $_status; return $_status; }\n" % MARK
        )
        for number, step in enumerate(steps):
            file.write("%s\n_mark %d\n" % (step, number))
    problem = None
    with open(output, "wb") as out:
        process = subprocess.Popen(
            shell + [script],
            stdin=subprocess.DEVNULL,
            stdout=out,
            stderr=out,
            cwd=environment["HOME"],
            env=environment,
            preexec_fn=tools.hear_ctrl_c,
        )
    try:
        process.wait(time_limit)
    except subprocess.TimeoutExpired:
        problem = "no end after %g s" % time_limit
    with open(output, "rb") as file:
        parts = re.split((MARK + r"(\d+) (\d+)\n").encode(), file.read())
    results = [(parts[i], int(parts[i + 2])) for i in range(0, len(parts) - 1, 3)]
    if len(results) < len(steps):
        problem = "%s in: %s\n%s" % (
            problem or "the shell ended (%s)" % process.returncode,
            steps[len(results)],
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
            environment[name] = processes.start_name_server(name.replace("PORT", "names"), above=last)
        elif kind == "world":
            name = processes.start_world(words.split(), environment["PORT"])
            environment[unused(environment, "MOCK_CONTROL")] = tools.control(name)
            waiting.append(name)
        elif kind == "faulty":
            waiting.append(processes.start_faulty(words.split()))
    for line in map(processes.ready, waiting):
        if line.startswith("{"):
            environment.update(
                (re.sub(r"\W", "_", mode).upper(), str(port)) for mode, port in json.loads(line).items()
            )


def unused(environment, variable):
    """VARIABLE, VARIABLE2, VARIABLE3 …"""
    names = [variable] + ["%s%d" % (variable, number) for number in range(2, 100)]
    return next(name for name in names if name not in environment)


if __name__ == "__main__":
    top, (request,) = jobs.begin()
    jobs.finish(run(top, *json.loads(request)))
