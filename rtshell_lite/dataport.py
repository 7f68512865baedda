"""Data from and to ports of components, through connectors of one port (no port of ours is seen by anyone).

An out port that is connected with dataflow `pull` queues its values for OpenRTM::OutPortCdr::get; the connector belongs to
the port alone, and nothing dangles when we are gone.
"""
import time

from rtshell_lite import errors, orb, ports

QUEUE = 4096  # values the port may queue between two looks
POLL = 0.02  # seconds between two looks at the queue: the default queue of 8 lasts that long at 400 Hz


class Pull:
    """A pull connection to a DataOutPort, to be used in a `with` statement: `get` fetches the oldest value."""

    def __init__(self, port):
        self.port, self.where = port, ports.label(port)

    def __enter__(self):
        self.connector = ports.connect_alone(self.port, "rtshell_lite", {
            "dataport.dataflow_type": "pull", "dataport.interface_type": "corba_cdr", "dataport.subscription_type": "new",
            "dataport.buffer.read.empty_policy": "do_nothing", "dataport.buffer.length": str(QUEUE)})
        try:
            self.source = self._source()
        except errors.Error:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        ports.disconnect(self.port, self.connector)

    def _source(self):
        from rtshell_lite.idl_stubs.dataport import OpenRTM
        ior = dict(self.connector.properties).get("dataport.corba_cdr.outport_ior")
        if not ior:
            raise errors.Refused(self.where, "tells no provider for pull")
        return orb.narrow(orb.from_text(self.where, ior), OpenRTM.OutPortCdr)

    def get(self):
        """The next value as CDR bytes, None when there is none now."""
        try:
            status, data = orb.ask(self.where, self.source, "get")
        except errors.Refused as e:
            if e.name == "BAD_PARAM":  # what Python components answer when nothing was written
                return None
            raise
        return data if str(status) == "PORT_OK" else None


def count_writes(port, seconds):
    """How many values a DataOutPort is given within `seconds`: (count, seconds between the first and the last look)."""
    with Pull(port) as source:
        drain(source)  # values from before may be there
        count, start = 0, time.monotonic()
        while time.monotonic() - start < seconds:
            time.sleep(POLL)
            count += drain(source)
        return count, time.monotonic() - start


def drain(source):
    """Fetch what is queued and return how many values there were; one that never runs dry is left after a queue of them."""
    for count in range(QUEUE):
        if source.get() is None:
            return count
    return QUEUE
