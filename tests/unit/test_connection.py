"""Removing the connectors of many ports: if this fails, Ctrl-C takes longer the more ports there are."""
import threading
import time
import unittest

from rtshell_lite.data import reading


def idle_reader():
    """The part of a push Reader that closes it, for a port that sends nothing."""
    reader = reading.Reader.__new__(reading.Reader)
    reader.dataflow = "push"
    reader.ended, reader.came = threading.Event(), threading.Event()
    return reader


class Closing(unittest.TestCase):
    def test_ports_that_send_nothing_are_waited_for_together(self):
        readers = [idle_reader() for _ in range(100)]
        begun = time.monotonic()
        for reader in readers:
            reader.stop()
        self.assertTrue(all(reader.is_at_rest() for reader in readers))
        self.assertLess(time.monotonic() - begun, 100 * reading.QUIET / 2)

    def test_a_value_that_came_long_ago_is_no_sign(self):
        """A value that came while others were closed does not count; the next one is waited for, up to a limit."""
        reader = idle_reader()
        reader.stop()
        reader.came.set()
        begun = time.monotonic()
        self.assertTrue(reader.is_at_rest())
        self.assertGreater(time.monotonic() - begun, reading.QUIET)


if __name__ == "__main__":
    unittest.main()
