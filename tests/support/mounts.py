"""Mounted RTC Trees in tests: whether they can be had here, and how none is left."""
import os
import subprocess
import tempfile


def refused():
    """Why nothing can be mounted here, '' if it can."""
    from rtshell_lite import errors
    from rtshell_lite.mount import kernel
    from rtshell_lite.net import loop
    with tempfile.TemporaryDirectory() as directory:
        try:
            loop.run(kernel.check(directory))
            os.close(kernel.mount(directory))
        except errors.Failed as e:
            return str(e).replace(directory, "here")
        kernel.unmount(directory)
        return ""


def take_away(top):
    """Unmount all that is mounted below a directory, before it is removed: rm in a mounted tree would
    disconnect ports.
    """
    with open("/proc/self/mountinfo") as file:
        places = [line.split(" ")[4] for line in file]
    for place in places:
        if place.startswith(top + "/"):
            for words in (["umount", "-l", place], ["fusermount3", "-u", "-z", place]):
                if subprocess.call(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) == 0:
                    break
