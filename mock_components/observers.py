"""The services to which a component reports: observers of two kinds, and loggers."""
from . import carrier
from .idl import RTC, OpenRTM
from .properties import get

# interface types
OBSERVER = "IDL:OpenRTM/ComponentObserver:1.0"
FSM_OBSERVER = "IDL:omg.org/RTC/ComponentObserver:1.0"
LOGGER = "IDL:OpenRTM/Logger:1.0"

LEVELS = ["SILENT", "ERROR", "WARN", "INFO", "NORMAL", "DEBUG", "TRACE", "VERBOSE", "PARANOID"]
CONNECT_LIMIT = 2000        # milliseconds that a dead observer may cost the component
REMOVAL = 0.2               # seconds until an observer that cannot be reached is removed


class Consumer:
    """A service that somebody has registered."""

    def __init__(self, component, profile, kind):
        self.component = component
        self.interface_type = profile.interface_type
        self.reference = profile.service._unchecked_narrow(kind)
        carrier.set_timeout(self.reference, CONNECT_LIMIT)
        self.ended = carrier.Event()
        self.configure(profile.properties)

    def configure(self, properties):
        self.properties = properties

    def switch(self, name):
        return get(self.properties, name, "NO").upper() == "YES"

    def interval(self, name):
        return float(get(self.properties, name, "1.0"))

    def pulse(self):
        """Seconds between two heartbeats, 0 without any."""
        return 0

    def close(self):
        self.ended.set()


class Observer(Consumer):
    """Gets update_status(); `heartbeats` are (kind, hint, prefix of its properties)."""

    heartbeats = [("HEARTBEAT", "", "heartbeat")]
    module = OpenRTM

    def __init__(self, component, profile):
        self.last = {}              # hint -> time of the last event of a kind that must not come too often
        self.lock = carrier.Lock()
        self.failed = 0             # reports of connections
        self.is_lost = False
        super().__init__(component, profile, self.module.ComponentObserver)

    def configure(self, properties):
        """Apply the properties, again if they have changed; old heartbeats stop."""
        super().configure(properties)
        self.ended.set()
        self.ended = carrier.Event()
        self.wanted = [word.strip() for word in get(properties, "observed_status", "ALL").split(",")]
        for kind, hint, prefix in self.heartbeats:
            if self.switch(prefix + ".enable"):
                self.component.process.thread(
                    self._beat, self.ended, kind, hint, self.interval(prefix + ".interval")
                )

    def pulse(self):
        return max(
            [
                self.interval(prefix + ".interval")
                for _, _, prefix in self.heartbeats
                if self.switch(prefix + ".enable")
            ],
            default=0,
        )

    def _beat(self, ended, kind, hint, pause):
        while not ended.wait(pause) and self.send(kind, hint):
            pass

    def wants(self, kind, hint):
        if kind not in self.wanted and "ALL" not in self.wanted or not hasattr(self.module, kind):
            return False
        direction = hint.partition(":")[0].lower()
        if direction not in ("send", "receive"):
            return True
        now = carrier.now()
        if now - self.last.get(hint, 0) < self.interval(f"port_profile.{direction}_event.min_interval"):
            return False
        self.last[hint] = now
        return True

    def send(self, kind, hint):
        """Whether the observer can still be reached; if not, it is forgotten."""
        try:
            self.reference.update_status(getattr(self.module, kind), hint)
        except carrier.SystemException:
            self._lost(hint)
            return False
        return True

    def _lost(self, hint):
        """A report has failed: the observer is dropped."""
        if not self.component.flavour.lost_observer_hangs:
            self.component.observers.drop(self)
            return
        about_connection = hint.startswith(("CONNECT:", "DISCONNECT:"))
        with self.lock:
            self.failed += about_connection
            is_first = not self.is_lost
            self.is_lost = True
        if is_first:
            self.component.process.thread(self._remove)
        if about_connection and self.failed > 1:
            self.component.hang()

    def _remove(self):
        carrier.sleep(REMOVAL)
        self.component.observers.drop(self)


class FsmObserver(Observer):
    """The observer of FSM4RTC."""

    heartbeats = [("RTC_HEARTBEAT", "", "rtc_heartbeat"), ("EC_HEARTBEAT", "HEARTBEAT:0", "ec_heartbeat")]
    module = RTC


class Logger(Consumer):
    """Gets log records on a command of ctl; not in C++, which accepts loggers and never writes to them."""

    def __init__(self, component, profile):
        super().__init__(component, profile, OpenRTM.Logger)

    def publish(self, level, name, message):
        limit = get(self.properties, "logger.log_level", "NORMAL").upper()
        names = get(self.properties, "logger.filter", "ALL").split(",")
        if LEVELS.index(level) > LEVELS.index(limit if limit in LEVELS else "NORMAL"):
            return
        if "ALL" not in names and name not in names:
            return
        now = carrier.wall()
        stamp = RTC.Time(int(now), int(now % 1 * 1e9))
        try:
            self.reference.publish(OpenRTM.LogRecord(stamp, name, getattr(OpenRTM, "RTM_" + level), message))
        except carrier.SystemException:
            self.component.observers.drop(self)


KINDS = {OBSERVER: Observer, FSM_OBSERVER: FsmObserver, LOGGER: Logger}


class Observers:
    """All services that are registered with a component, which cannot be listed from outside."""

    def __init__(self, component, available):
        self.component = component
        self.available = available
        self.registered = {}        # id -> Consumer
        self.to_forget = 0          # how many of those that come next are accepted, and lost

    def add(self, profile):
        if not profile.id or profile.interface_type not in self.available or profile.service is None:
            return False
        if self.to_forget:
            self.to_forget -= 1
        elif profile.id in self.registered:
            self.registered[profile.id].configure(profile.properties)
        else:
            self.registered[profile.id] = KINDS[profile.interface_type](self.component, profile)
        return True

    def remove(self, service_id):
        consumer = self.registered.pop(service_id, None)
        if consumer:
            consumer.close()
            if self.component.flavour.heart_stops_late:
                carrier.sleep(consumer.pulse())
        return consumer is not None

    def forget(self, count):
        """Lose all, and the `count` next ones."""
        self.close()
        self.to_forget = count

    def drop(self, consumer):
        for service_id, one in list(self.registered.items()):
            if one is consumer:
                self.registered.pop(service_id).close()

    def report(self, kind, hint):
        """Report to all observers that asked for this."""
        for consumer in list(self.registered.values()):
            if isinstance(consumer, Observer) and consumer.wants(kind, hint):
                consumer.send(kind, hint)

    def log(self, level, name, message):
        for consumer in list(self.registered.values()):
            if isinstance(consumer, Logger) and not self.component.flavour.silent_loggers:
                consumer.publish(level, name, message)

    def close(self):
        for service_id in list(self.registered):
            self.registered.pop(service_id).close()
