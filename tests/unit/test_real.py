import errno
import select
import socket
import tempfile
import unittest
from unittest import mock

from rtshell_lite.net import real


class Poll(unittest.TestCase):
    """What tells which descriptors are ready does so alike, whatever the system has for it."""

    def check(self, poll):
        with tempfile.TemporaryFile() as file:
            near, far = socket.socketpair()
            poll.register(file.fileno(), 0)
            self.assertEqual(poll.poll(0), [])
            poll.register(file.fileno(), select.POLLIN)
            poll.register(near.fileno(), select.POLLIN)
            self.assertEqual(poll.poll(1000), [(file.fileno(), select.POLLIN)])
            poll.register(near.fileno(), select.POLLOUT)
            both = [(file.fileno(), select.POLLIN), (near.fileno(), select.POLLOUT)]
            self.assertEqual(sorted(poll.poll(0)), sorted(both))
            poll.unregister(file.fileno())
            poll.register(near.fileno(), 0)
            far.close()
            self.assertEqual(poll.poll(1000), [(near.fileno(), select.POLLHUP)])
            descriptor = near.fileno()
            near.close()
            poll.unregister(descriptor)

    def test_select(self):
        self.check(select.poll())

    @unittest.skipUnless(hasattr(select, "epoll"), "needs Linux")
    def test_epoll(self):
        poll = real.Epoll()
        self.addCleanup(poll.close)
        self.check(poll)

    @unittest.skipUnless(hasattr(select, "epoll"), "needs Linux")
    def test_a_process_that_is_out_of_files_polls_all_the_same(self):
        with mock.patch.object(select, "epoll", side_effect=OSError(errno.EMFILE, "Too many open files")):
            self.assertIsInstance(real.poll(), type(select.poll()))


if __name__ == "__main__":
    unittest.main()
