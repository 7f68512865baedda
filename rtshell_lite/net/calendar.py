"""Moments in words, as strftime writes them."""

import time

from rtshell_lite.net import loop


def local(pattern, seconds=None):
    """A moment, in seconds since 1970 (None: the present), in the time zone of this computer."""
    return time.strftime(pattern, time.localtime(loop.wall() if seconds is None else seconds))


def utc(pattern, seconds):
    """A moment, in seconds since 1970, in UTC."""
    return time.strftime(pattern, time.gmtime(seconds))
