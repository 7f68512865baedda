"""How often what fails is tried again: restart policies, as those of systemd."""

import collections

from rtshell_lite import errors
from rtshell_lite.net import loop
from rtshell_lite.system import capture

HEALTH = 60.0  # seconds without a failure, after the pause for the last one, until earlier ones are forgotten
DAY = 86400.0
RESTARTS = ("always", "on-error", "no")
PREFIX = "keep."  # of the extended properties of a component that say how it is kept

# `restart` is one of RESTARTS; given up after more than `burst` failures in `within` seconds; from `first` to
# `most` seconds between attempts.
Policy = collections.namedtuple("Policy", "restart burst within first most")
USUAL = Policy("always", 5, 60.0, 0.5, 30.0)


def of(component, usual):
    """The Policy of a model.Component: its extended properties keep.restart, keep.burst and keep.delay, words
    as `parse` takes them, go before those of `usual`. Raises Failed.
    """
    words = [component.property(PREFIX + name) for name in ("restart", "burst", "delay")]
    try:
        return parse(words[0], words[1], words[2], usual)
    except ValueError as e:
        raise errors.Failed(capture.shown_path(component), f"its property {PREFIX}{e}")


def parse(restart=None, burst=None, delay=None, usual=USUAL):
    """The Policy of three words such as on-error, 5/60 and 0.5-30; None for what `usual` has.

    Raises ValueError with the name of the word that is wrong and what it is not.
    """
    if restart and restart not in RESTARTS:
        raise ValueError("restart: not one of " + ", ".join(RESTARTS))
    policy = usual._replace(restart=restart or usual.restart)
    if burst:
        number, within = _two_numbers(burst, "/", "burst: not NUMBER/SECONDS")
        policy = policy._replace(burst=int(number), within=within)
    if delay:
        first, most = _two_numbers(delay, "-", "delay: not FIRST-MOST")
        policy = policy._replace(first=first, most=most)
    return policy


def _two_numbers(text, between, complaint):
    try:
        low, high = [float(word) for word in text.split(between)]
    except ValueError:
        raise ValueError(complaint)
    if not 0 < low <= DAY or not 0 < high <= DAY:
        raise ValueError(complaint)
    return low, high


class Trial:
    """How often something has failed of late, and when it may be tried again.

    until     loop.now() before which it is not to be tried
    why       the last failure, in words
    given_up  True after too many failures, until `begin_again`
    """

    def __init__(self, policy):
        self.policy = policy
        self.failures = []  # type: list
        self.until = 0.0
        self.given_up = False
        self.why = ""

    def fail(self, why=""):
        """Note a failure: the next attempt comes at once after the first one, later after others,
        or never.
        """
        now = loop.now()
        self.why = why
        if self.failures and now - self.until > HEALTH:
            self.failures = []
        self.failures.append(now)
        recent = [when for when in self.failures if now - when < self.policy.within]
        self.given_up = len(recent) > self.policy.burst
        doublings = min(len(self.failures) - 2, 20)
        delay = min(self.policy.most, self.policy.first * 2**doublings) if doublings >= 0 else 0.0
        jitter = loop.world().octets(1)[0] / 1020  # at most a quarter; `random` would take 300 kB
        self.until = now + delay * (1 + jitter)

    def why_given_up(self):
        """In words."""
        failures = "1 failure" if self.policy.burst == 1 else f"{self.policy.burst} failures"
        return f"given up after more than {failures} in {self.policy.within:g}s"

    def begin_again(self):
        """Something about it has changed."""
        self.failures = []
        self.until = 0.0
        self.given_up = False
