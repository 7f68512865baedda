"""Runs commands given on stdin, a line of JSON each, and prints CPU, wall and peak memory: a small process of
its own, because a child's peak memory begins with that of the process that started it.
"""
import json
import os
import sys
import time

for line in sys.stdin:
    asked = json.loads(line)
    begun = time.perf_counter()
    child = os.fork()
    if not child:
        out = os.open(
            os.devnull if asked["out"] is None else asked["out"], os.O_WRONLY | os.O_CREAT | os.O_TRUNC
        )
        os.dup2(out, 1)
        os.dup2(out, 2)
        os.execvpe(asked["words"][0], asked["words"], asked["environment"])
    _, status, used = os.wait4(child, 0)
    print(json.dumps([used.ru_utime + used.ru_stime, time.perf_counter() - begun, used.ru_maxrss / 1024,
                      os.WEXITSTATUS(status) if os.WIFEXITED(status) else -os.WTERMSIG(status)]), flush=True)
