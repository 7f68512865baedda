"""A log that is played on a terminal: its keys, and a line that says where it is."""

import os
import sys

from rtshell_lite.datalog import decode
from rtshell_lite.datalog.pace import JUMP
from rtshell_lite.net import loop, real

TICK = 0.2  # seconds between two lines


def line(pace):
    """Where a pace.Pace is: when it was recorded, how many entries came, how fast it is played."""
    words = [decode.date(pace.position), f"{pace.count} entries", f"x{pace.rate:g}"]
    if pace.is_paused:
        words.append("paused")
    return "  ".join(words)


async def attend(pace, write):
    """Take keys from the terminal, and have write(text) show the line on it, until cancelled: space pauses, .
    plays one entry, < and > jump. Nothing where there is no terminal, or it is another program's just now.
    """
    try:
        import termios  # not every system has it, nor Debian's python3-minimal
    except ImportError:
        return
    if not _is_ours():
        return
    terminal = sys.stdin.fileno()
    before = termios.tcgetattr(terminal)
    settings = list(before)
    settings[3] &= ~(termios.ICANON | termios.ECHO)
    termios.tcsetattr(terminal, termios.TCSANOW, settings)

    def resume():
        termios.tcsetattr(terminal, termios.TCSANOW, settings)
        pace.resume()

    loop.current().hear(real.SIGCONT, resume)
    try:
        async with loop.background(_show(pace, write)):
            await _take_keys(terminal, pace)
    finally:
        loop.current().hear(real.SIGCONT, None)
        termios.tcsetattr(terminal, termios.TCSANOW, before)
        write("\n")


def _is_ours():
    """Whether there is a terminal for keys and the line, in whose foreground we are."""
    if not (sys.stdin and sys.stdin.isatty() and sys.stderr and sys.stderr.isatty()):
        return False
    try:
        return os.tcgetpgrp(sys.stdin.fileno()) == os.getpgrp()
    except OSError:
        return False


async def _take_keys(terminal, pace):
    acts = {" ": pace.pause, ".": pace.step, "<": lambda: pace.jump(-JUMP), ">": lambda: pace.jump(JUMP)}
    while True:
        await loop.ready(terminal, loop.READ)
        keys = os.read(terminal, 64).decode("latin-1")
        if not keys:
            return
        for key in keys:
            if key in acts:
                acts[key]()


async def _show(pace, write):
    """Show the line again and again. It ends at the first column, so that what is said otherwise
    covers it.
    """
    while True:
        if pace.position is not None:
            write(line(pace) + "\x1b[K\r")
        await loop.sleep(TICK)
