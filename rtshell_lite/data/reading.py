"""Data from out ports of components, pushed to us or fetched by us.

    async with reading.Reader(port, deliver) as reader: …       calls deliver(Message) for each value

writing.py sends to in ports.
"""

import collections
import sys

from rtshell_lite import errors
from rtshell_lite.corba import orb, refusals, servants, session
from rtshell_lite.data import clocks, seam, writing
from rtshell_lite.data.connection import BUSY, SILENT, PortConnection, Ended
from rtshell_lite.net import loop
from rtshell_lite.robot import component, ports

# One value: its arrival, in nanoseconds since 1970; its CDR bytes without a header; their byte order.
Message = collections.namedtuple("Message", "received data little")

QUEUE = 4096  # values that the port may queue while writes are counted, or for a late reader
# values, and their bytes, that the port may queue for a slow reader
BUFFER = 256
BUFFER_BYTES = 16 << 20
EACH = 200  # bytes that a value takes besides its own
SUBSCRIPTION = "dataport.subscription_type"
FEWEST = 4  # values that it may queue however large they are
GRACE = 0.2  # seconds beyond the timeout that a fetch is waited for
POLL = 0.02  # seconds between two fetches from an empty queue
ANSWERED = 0.05  # seconds from the answer to a fetch until the component has left the connector
ANSWERING = 0.001  # seconds in which a thread sends the answer to a value
QUIET = 0.1  # seconds to wait for a last value; after them a connector is no longer new
PERIODS = 4  # of the component, in which it finds out that we have left, and removes the connector itself
LONGEST = 0.2  # seconds to wait for that, at most: a command ends within 0.3 s of its signal
LOOKS = 0.005, 0.05  # seconds between two looks whether it has done so, at first and in the end
# seconds between switches of Python's threads: the thread that prints or writes values must not hold up our
# answers
SWITCH = 0.0005
AWAY = "it was not connected meanwhile"  # why values may be missing
OVERFLOWN = "they exceeded the port's buffer"


class Reader(PortConnection):
    """A connector from a DataOutPort that calls deliver(Message), which returns at once, for each value.

    dataflow: "push" (the component calls us), "pull" (we fetch, for components that cannot reach us), None
    for push where the port offers it. `properties` is a dict of the connector's properties, which override
    ours; `name` is the connector's name.

    Removing a push connector may end the component: with the subscription "new" its publisher may be using
    what is deleted. So we leave by being no more, and its next call finds that out: OBJECT_NOT_EXIST, upon
    which it removes the connector itself, between two writes. On this host the component calls us in its own
    cycle ("flush"): deliver() returns at once. Over a network a slow link must not slow the component: "new".
    With "periodic" the connector is removed right after a value has come.
    """

    kind = "DataOutPort"
    side = "outport"
    flows = ("push", "pull")
    looks_until_why = 0  # how many looks without any value until it asks, once, why none comes; 0: never
    seam = None  # where its values follow those of another Reader
    # function(first, last, how many or None, why), called where values are missing, ns since the epoch
    miss = None

    def __init__(self, port, deliver, dataflow=None, properties=None, name="rtshell_lite"):
        super().__init__(port, name, properties)
        self.deliver = deliver
        offer = ports.offer_without(port, "dataport.dataflow_type", "push")
        self.dataflow = self.user.get("dataport.dataflow_type", "").lower() or dataflow
        if not self.dataflow:
            self.dataflow = "pull" if offer else "push"
        self.room = BUFFER  # values that the port may queue
        self.heaviest = 0  # bytes of the largest one so far
        self.answered = 0.0  # when the last fetch ended
        self.count = self.seen = 0  # values so far, and at the last look
        self.first = self.last = 0.0  # when the first and the last of them came
        self._is_silent = False
        self.served = None
        self._away = None  # when its connector was removed, ns since the epoch
        self.renew()

    def renew(self):
        # values that came before the byte order was known
        self.early = []
        self.early_bytes = 0
        self.stopped = None  # when it began to leave: no more values are wanted
        # ring then, and when no fetch is under way any more
        self.ended = loop.Bell()
        self.idle = loop.Bell()
        self.idle.ring()
        self.count_then = 0  # values when it began to leave
        self.came = loop.Bell()  # rings when another one comes

    async def defaults(self):
        common = {"dataport.buffer.length": str(self.room)}
        if self.dataflow == "pull":
            return dict(common, **{SUBSCRIPTION: "new", "dataport.buffer.read.empty_policy": "do_nothing"})
        sys.setswitchinterval(SWITCH)
        self.served = servants.Served(servants.RECEIVERS[self.interface](self._take, self._is_full))
        is_near = await refusals.is_this_host(self.endpoint[0])
        if is_near and not ports.offer_without(self.port, SUBSCRIPTION, "flush"):
            subscription = "flush"
        else:
            subscription = ports.connection_properties([self.port], {})[SUBSCRIPTION] or "new"
        return dict(
            common,
            **{
                SUBSCRIPTION: subscription,
                "dataport.publisher.push_policy": "all",
                f"dataport.{self.interface}.inport_ior": await self.served.ior(self.endpoint),
            },
        )

    async def open(self):
        try:
            await super().open()
        except errors.Error:
            self._withdraw()
            raise
        for received, data in self.early:
            self.deliver(Message(received, data, self.little))
        self.early = None
        self.early_bytes = 0
        if self.dataflow == "pull":
            fetch = fetcher(self)
            self.idle = loop.Bell()
            self.tasks.start(self._poll(fetch), self.endpoint)

    def _is_full(self):
        """Whether too much has come before the byte order is known, or the connector before this one has
        ended; on any thread.
        """
        held = self.seam.held_bytes if self.seam is not None else 0
        return self.early_bytes + held > BUFFER_BYTES

    async def _connect(self, requested):
        await super()._connect(requested)
        if self.seam is not None:
            self.seam.connected()

    def _take(self, received, data):
        if self.early is not None:
            self.early.append((received, data))
            self.early_bytes += len(data) + EACH
        elif not self.is_closing:
            self.deliver(Message(received, data, self.little))
        self._count(data)

    def compare_clocks(self):
        """Remark, once, where the first time in its values is minutes away from this host's clock."""
        deliver = self.deliver

        def compare(message):
            stamp = clocks.seconds(message)
            if stamp and self.deliver is compare:
                self.deliver = deliver
                self.remark = clocks.difference(message.received / 1e9, stamp) or self.remark
            deliver(message)

        if clocks.is_stamped(self.port):
            self.deliver = compare

    def _count(self, data):
        self.last = loop.now()
        self.first = self.first or self.last
        self.count += 1
        self.heaviest = max(self.heaviest, len(data))
        if self.stopped is not None:
            self.came.ring()

    async def _poll(self, fetch):
        try:
            while self.stopped is None:
                await self._take_next(fetch)
        except errors.Error as e:
            self.failure = e if self.stopped is None else None
        finally:
            self.idle.ring()

    async def _take_next(self, fetch):
        """Fetch a value, or wait POLL seconds when the buffer is empty.
        Raises errors.Error when there will be no more.
        """
        try:
            data = await fetch()
        except errors.Unanswered as e:
            self.failure = e
            return
        self.failure = None
        self.answered = loop.now()
        if data is None:
            await self.ended.wait(POLL)
        else:
            self._take(int(loop.wall() * 1e9), data)

    def stop(self):
        if self.stopped is None:
            self.stopped = loop.now()
            self.count_then = self.count
            self.ended.ring()
        if self._finds_out():
            self._withdraw()
        elif self.served is not None:  # so that `is_at_rest` learns of a value while its sender is answered
            self.served.servant.hurry()

    def _subscription(self):
        return self.agreed.get(SUBSCRIPTION, "").lower()

    def _finds_out(self):
        """Whether the component removes the connector once its calls are answered OBJECT_NOT_EXIST."""
        return self.dataflow == "push" and self._subscription() in ("flush", "new")

    async def close(self):
        if self.connector:
            self._away = int(loop.wall() * 1e9)
        await super().close()

    async def come_back(self):
        was_connected = self.connector is not None
        await super().come_back()
        if self.connector and not was_connected:
            self._report_missing(self._away, int(loop.wall() * 1e9), AWAY)

    def _report_missing(self, first, last, why, count=None):
        if self.miss is not None:
            self.miss(first, last, count, why)

    async def leave(self, connector):
        self.stop()
        if not self._finds_out() or not await self._is_forgotten(connector):
            await super().leave(connector)

    async def _is_forgotten(self, connector):
        """Wait until the component has found out that we have left, and has removed the connector.
        A silent one will.
        """
        period = (self.last - self.first) / (self.count - 1) if self.count > 1 else 0
        end = self.stopped + min(LONGEST, QUIET + PERIODS * period)
        pause = LOOKS[0]
        try:
            while await self.is_there(connector):
                if loop.now() > end:
                    return False
                await loop.sleep(pause)
                pause = min(2 * pause, LOOKS[1])
            self.left = None
        except errors.Refused:
            return False
        except errors.Unreachable as e:
            self.left = None if isinstance(e, Ended) else (connector, SILENT)
            self.failure = self.failure or e
        return True

    async def is_at_rest(self):
        """Wait until the component is not using the connector; False if it goes on using it.

        Removing a connector ends a C++ component that is serving a fetch through it: so wait for the last
        answer. It may also end one whose publisher is pushing a value (17 of 2,100 removals soon after
        connecting to C++ 2.1 at 100 Hz): so remove it while the answer to a value is on its way, when the
        publisher has nothing to do until the next one. Ports are closed a few at a time: all share the wait
        since stop(), and a value that came before this call is too old.
        """
        if self._finds_out():
            return True
        if self.dataflow == "push":
            quiet = QUIET if self.count == self.count_then else 2 * QUIET
            self.came = loop.Bell()
            has_come = await self.came.wait(self.stopped + quiet - loop.now())
            if has_come and not orb.answers_at_once():
                await loop.sleep(ANSWERING)
            return True
        if isinstance(self.failure, errors.Unanswered) or not await self.idle.wait(
            session.current().timeout + GRACE
        ):
            return False
        await loop.sleep(self.answered + ANSWERED - loop.now())
        return not isinstance(self.failure, errors.Unanswered)

    def why_left(self):
        has_unanswered_fetch = self.dataflow == "pull" and isinstance(self.failure, errors.Unanswered)
        return BUSY if has_unanswered_fetch else SILENT

    def is_due(self):
        seen = self.seen
        self.seen = self.count
        if seen != self.count:
            self.failure = None  # it was silent, but values have come
        was_silent = self._is_silent
        self._is_silent = self.dataflow != "pull" and seen == self.count
        is_pressing = bool(self.looks_until_why and not self.count) or self._is_too_heavy()
        self.is_still_silent = was_silent and self._is_silent and not is_pressing and self.failure is None
        return self._is_silent or is_pressing

    async def check(self):
        if self.connector and self._is_too_heavy():
            await loop.finish(self._reopen())
        await super().check()
        if self.looks_until_why and not self.count:
            self.looks_until_why -= 1
            if not self.looks_until_why:
                await self._explain_silence()

    async def _explain_silence(self):
        """Remark that the component sends nothing as it does not execute."""
        why = await writing.Audience(self.port.node, self.where).why_not_reading()
        if why and not self.count:
            self.remark = "no value has come: %s; %s" % why

    def _is_too_heavy(self):
        """Whether a full queue of the largest values would take too much of the component's memory."""
        is_too_heavy = self.heaviest * self.room > BUFFER_BYTES and "dataport.buffer.length" not in self.user
        return is_too_heavy and self._subscription() != "flush" and self.failure is None

    async def _reopen(self):
        """Replace the connector by one with a shorter buffer, now that the size of values is known."""
        self.room = max(FEWEST, BUFFER_BYTES // self.heaviest)
        await self._replace()

    async def _replace(self):
        """Make another connector, then remove the present one; what comes through both is delivered once.
        Where a port takes no second one, or values are fetched, the present one is removed first. Raises
        errors.Error.
        """
        if self.is_closing or not self.connector or self.failure:
            return
        if self.dataflow == "pull" or not await self._replace_pushed():
            await self.close()
            await self.come_back()

    async def _replace_pushed(self):
        """Replace a push connector; False where the port takes no second one."""
        deliver = self.deliver
        other = Reader(self.port, None, self.dataflow, self.user, self.name)
        other.room = self.room
        other.tasks = self.tasks
        other.seam = seam.Seam(deliver, clocks.seconds, self._pass_on)
        other.deliver = other.seam.take_new
        self.deliver = other.seam.take_old
        try:
            await other.open()
        except errors.Error:
            self.deliver = deliver
            return False
        await self.close()
        self.deliver = deliver
        self._follow(other)
        return True

    def _pass_on(self):
        if self.served is not None:
            self.served.servant.pass_on()

    def _follow(self, other):
        """Go on with the connector of another Reader."""
        joint = other.seam
        other.seam = None
        self.renew()
        self.early = None
        self.connector = other.connector
        self.agreed = other.agreed
        self.little = other.little
        self.served = other.served

        def take(message):
            if self.is_closing:
                return
            self._count(message.data)
            if not joint.take(message):
                self._join(joint, other)

        other.deliver = take
        if not joint.end():
            self._join(joint, other)

    def _join(self, joint, other):
        """Nothing comes twice any more through the connector of another Reader."""
        other.deliver = self._take_of_other
        if joint.gap is not None:
            first, last = joint.gap
            self._report_missing(first, last, OVERFLOWN)

    def _take_of_other(self, message):
        if not self.is_closing:
            self.deliver(message)
        self._count(message.data)

    def rate(self):
        """How many values have come a second; None with few."""
        if self.count < FEWEST or self.last <= self.first:
            return None
        return (self.count - 1) / (self.last - self.first)

    def holds_up(self):
        """Whether the component waits, in its own cycle, for our answer to each value."""
        return self.connector is not None and self.dataflow == "push" and self._subscription() == "flush"

    async def let_go(self):
        """Have the component not wait for us any more: with "new" a thread of its own calls us. A port that
        has no "new", or is to have "flush", is given up. Raises errors.Error.
        """
        if SUBSCRIPTION in self.user or ports.offer_without(self.port, SUBSCRIPTION, "new"):
            await self.close()
            raise errors.Failed(self.where, "given up, as its component would be held up")
        self.user[SUBSCRIPTION] = "new"
        self.room = max(FEWEST, min(QUEUE, BUFFER_BYTES // (self.heaviest + EACH)))
        await self._replace()

    def lost(self):
        if self.dataflow == "push" and not self.count:
            return (
                "the connection has been removed; if the component did that, it cannot reach this machine "
                "(pull may do), or its values exceed its ORB's giopMaxMsgSize"
            )
        return super().lost()

    async def release(self):
        self._withdraw()

    def _withdraw(self):
        """Take no more calls."""
        if self.served is not None:
            self.served.withdraw()
            self.served = None

    async def is_always_little(self):
        """C++ from 1.2 on, and RtORB, push little-endian whatever was agreed upon."""
        if self.dataflow == "pull":
            return False
        properties = dict((await component.profile(self.port.node)).properties)
        is_old = properties.get("openrtm.version", "").startswith(("1.0", "1.1"))
        return properties.get("language", "").startswith("C") and not is_old


def fetcher(reader):
    """A function that fetches the oldest value of a pull connection as bytes, or None."""
    source = reader.remote({"corba_cdr": "OpenRTM.OutPortCdr", "data_service": "RTC.DataPullService"})
    operation = "get" if reader.interface == "corba_cdr" else "pull"

    async def fetch():
        try:
            status, data = await orb.call(reader.where, source, operation)
        except errors.Gone:
            raise errors.Unreachable(reader.where, reader.lost())
        except errors.Refused as e:
            if e.name == "BAD_PARAM":  # Python components answer this before the first value
                return None
            raise
        if str(status) in ("UNKNOWN_ERROR", "PORT_ERROR"):
            raise errors.Unreachable(reader.where, reader.lost())
        return data if str(status) == "PORT_OK" else None

    return fetch


async def count_writes(port, seconds):
    """(number of values that a component writes to a DataOutPort, in how many seconds),
    measured for about `seconds`.
    """
    properties = {"dataport.buffer.length": str(QUEUE)}
    async with Reader(port, lambda message: None, "pull", properties) as reader:
        await loop.sleep(2 * POLL)  # fetch older values first
        before = reader.count
        start = loop.now()
        await loop.sleep(seconds)
        if reader.failure:
            raise reader.failure
        return reader.count - before, loop.now() - start
