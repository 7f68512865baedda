"""Peers that misbehave on purpose (mock_components/faulty.py) as processes of a simulated world."""

import carrier
import peers

from mock_components import faulty

from rtshell_lite.giop import references
from rtshell_lite.net import loop, tcp

MODES = sorted(faulty.MODES)
BANDWIDTH = 2.5e6  # octets a second that a peer sends: what comes without end takes time
MANY = faulty.MANY[:2000]  # that `many` lists here, as each takes our processor as long as on a robot


class Connection:
    """A connection of a peer, as faulty.py uses sockets; called on a Strand."""

    def __init__(self, socket):
        self._socket = socket
        self.setsockopt = socket.setsockopt

    def recv(self, most):
        return carrier.await_it(tcp.receive(self._socket, most))

    def sendall(self, octets):
        carrier.sleep(len(octets) / BANDWIDTH)
        carrier.await_it(peers.send(self._socket, octets))


class Peer(peers.Listener):
    """A process at a Host that misbehaves in one way."""

    def __init__(self, host, mode):
        port = host.free_port()
        self._other = None
        other = None
        if mode == "elsewhere-silent":
            self._other = Peer(host, "silent")
            other = self._other.port
        elif mode == "elsewhere-refused":
            other = host.free_port()
        self._behaviour = faulty.Behaviour(mode, port, other, MANY)
        self._behaviour.sleep = carrier.sleep
        self.strands = {}
        self.is_ended = False
        super().__init__(host, port)

    def close(self):
        super().close()
        if self._other is not None:
            self._other.close()

    def is_reached(self):
        """Whether anybody has connected to it, or to where it leads."""
        return bool(self.connections or self._other is not None and self._other.connections)

    def reference(self, type_id):
        """What its name leads to where it is bound as an object of that type; made in a process of mocks."""
        found = references.make_reference("127.0.0.1", self.port, b"faulty", type_id=type_id.encode())
        return carrier.Remote(found)

    @property
    def loop(self):
        """That of its process; what a Strand has to know."""
        return self.program.loop

    def _main(self):
        try:
            super()._main()
        finally:
            self.is_ended = True
            while self.strands:
                for strand in list(self.strands):
                    strand.go_on()

    async def talk(self, connection):
        strand = carrier.Strand(self, self._converse, connection)
        strand.over = loop.Wait()
        strand.begin()
        await strand.over

    def _converse(self, connection):
        try:
            self._behaviour.converse(Connection(connection))
        except (EOFError, OSError):
            pass
