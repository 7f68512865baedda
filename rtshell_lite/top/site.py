"""rttop --serve: the page of a system for browsers, kept live by events that are sent to them.

However many look on, one Top asks for states, and one task asks each component for everything: when it is
new, when its connections have changed, and again after REFRESH. A browser gets the page as it is then, and on
a stream what has changed since: states one by one, else all that the page shows. Nothing that a browser sends
changes anything.
"""

import binascii
import collections
import errno
import functools
import os

from rtshell_lite import errors
from rtshell_lite.corba import session
from rtshell_lite.net import http, loop
from rtshell_lite.net import calendar
from rtshell_lite.path import split_address
from rtshell_lite.robot import places
from rtshell_lite.system import capture, page_file
from rtshell_lite.text import printable, safe
from rtshell_lite.top import rows
from rtshell_lite.views import live_graph, page

PAUSE = 1.0  # seconds between two looks at what the page shows
# seconds after which a component is asked for everything again, as configuration changes unseen
REFRESH = 60.0
MOST_AGAIN = 10  # components that are asked again in one look
BEAT = 15.0  # seconds after which a browser is sent a comment, which shows that both are still there
TICK = 1.0  # seconds between two looks whether a browser is still there

# What is known of a component: the snapshot.Snapshot with everything, None if it has never answered; which
# connections it had then; when that was, by loop.now().
Detail = collections.namedtuple("Detail", "snapshot links asked")


# ---- where it listens ----


class Place:
    """Where a site listens, and who may ask there.

    host     as it was given
    token    what the address has to contain, "" where only this host can connect
    names    names of hosts by which it may be asked for, beside the IP address that was connected with
    """

    def __init__(self, listener, host, token):
        self.listener = listener
        self.host = host
        self.token = token
        own = loop.world().host_name().lower()
        self.names = {host.lower(), own, own + ".local"}

    @property
    def is_wild(self):
        """Whether it listens at all addresses of this host."""
        return self.listener.getsockname()[0] in ("0.0.0.0", "::")

    def address(self, host):
        """Its address with this host, for a browser."""
        if ":" in host and not host.startswith("["):
            host = f"[{host}]"
        port = self.listener.getsockname()[1]
        return f"http://{host}:{port}{self.path}"

    @property
    def path(self):
        """The path of the page."""
        if self.token:
            return f"/{self.token}/"
        return "/"

    def check(self, request):
        """Raises http.Refused unless a http.Request names this host as its own page does, and has the token:
        other pages in the same browser could ask for it, or a name of theirs that leads here.
        """
        asked = request.headers.get("host", "").lower()
        host, _ = split_address(asked)
        allowed = {request.here, f"[{request.here}]"} | self.names
        if _is_loopback(request.here):
            allowed.add("localhost")
        origin = request.headers.get("origin", "http://" + asked).lower()
        if host not in allowed or origin != "http://" + asked:
            raise http.Refused(403)
        import hmac  # not needed where nothing is served

        word = request.target.split("/")[1]
        if self.token and not hmac.compare_digest(word.encode(), self.token.encode()):
            raise http.Refused(403)


async def place(where, otherwise=None):
    """The Place for a (host, port); port 0 is any free one. `otherwise` is taken where that is in use. Raises
    Failed.
    """
    host, port = where
    try:
        world = loop.world()
        addresses = await loop.on_thread(world.resolve, host, port)
        family, _, _, _, address = sorted(addresses, key=lambda way: way[0])[0]
        listener = world.listen(family, address)
    except (OSError, OverflowError, UnicodeError) as e:
        if otherwise and getattr(e, "errno", None) == errno.EADDRINUSE:
            return await place(otherwise)
        words = f"{host}:{port}"
        if ":" in host:
            words = f"[{host}]:{port}"
        raise errors.Failed(f"--serve {printable(words)}", getattr(e, "strerror", None) or str(e))
    token = ""
    if not _is_loopback(address[0]):
        token = binascii.hexlify(os.urandom(16)).decode()
    return Place(listener, host, token)


def _is_loopback(address):
    return address == "::1" or address.startswith("127.")


# ---- what it shows ----


class Site:
    """The page of what a model.Top looks at, for the browsers that connect with a Place.

    `await site.serve()` does so until it is cancelled.
    """

    def __init__(self, looking, where, title):
        self._looking = looking
        self._place = where
        self._title = title
        self._what = page.origin("rttop --serve") + ". It is live."
        self._run = binascii.hexlify(os.urandom(4)).decode()  # so that no version is one of another run
        self._version = 0
        self._details = {}  # by path: Detail
        self._fields = None
        self._fields = self._page([], {})
        self._numbers = {}  # by path: number of the box
        self._now = {}  # by path: (number of the change, [state, words])
        self._changes = 0
        self._bells = set()  # loop.Bells of the browsers

    async def serve(self):
        """Answer browsers for ever."""
        self._looking.shown = set()  # nobody sees all of many components
        async with loop.Group() as group:
            group.start(self._keep_states())
            group.start(self._keep_details())
            group.start(http.serve(self._place.listener, self._answer))

    # ---- states ----

    async def _keep_states(self):
        noted = None
        while True:
            shown = self._looking.rows()
            if shown is not noted:
                for row in shown:
                    if row.kind != "unknown":
                        self._note(row)
                noted = shown
                self._ring()
            await loop.sleep(self._looking.delay)

    def _note(self, row):
        """Note what a rows.Row says, if that is new."""
        state = {"?": "Unknown", "~": "Unknown", "-": "Unknown", None: None}.get(row.state, row.state)
        why = rows.reason(row.path, row.failure) if row.failure else safe(row.event)
        _, (shown_state, words) = self._now.get(row.path, (0, (None, "")))
        if state == shown_state and words.startswith(why) and bool(why) == bool(words):
            return
        if why:
            why += calendar.local(" (seen at %H:%M:%S)")
        self._changes += 1
        self._now[row.path] = (self._changes, [state, why])

    def _ring(self):
        for bell in self._bells:
            bell.ring()

    # ---- all else ----

    async def _keep_details(self):
        while True:
            before = self._version
            if self._bells or not self._fields["boxes"]:
                await self._look()
            if self._version != before:
                self._ring()
            await loop.sleep(PAUSE)

    async def _look(self):
        """Ask the components that are new or have changed, and make the page anew if it is another one."""
        entries = dict(self._looking.entries())
        self._details = {path: detail for path, detail in self._details.items() if path in entries}
        due = self._due(entries)
        question = functools.partial(capture.ask, everything=True)
        answers = await session.each([entries[path].node for path in due], question)
        for path, answer in zip(due, answers):
            if isinstance(answer, errors.Error):
                last = self._details.get(path)
                shown = last and last.snapshot
            else:
                shown = answer.snapshot
                shown.states = ["as above"] * len(shown.states)  # which the page keeps live
            self._details[path] = Detail(shown, entries[path].links, loop.now())
        snapshots = [detail.snapshot for detail in self._details.values() if detail.snapshot is not None]
        ends = await places.far_ends([port for snapshot in snapshots for port in snapshot.ports])
        lost = {}
        for path, entry in entries.items():
            if not self._is_known(path):
                lost[path] = entry.node.endpoint
        fields = self._page(snapshots, lost, ends)
        if fields != self._fields:
            self._fields = fields
            boxes = enumerate(fields["boxes"])
            self._numbers = {box["path"]: number for number, box in boxes if "path" in box}
            self._version += 1

    def _is_known(self, path):
        return path in self._details and self._details[path].snapshot is not None

    def _due(self, entries):
        """The paths of the components that are to be asked for everything."""
        end = loop.now() - REFRESH
        due = []
        old = []
        for path, entry in sorted(entries.items()):
            detail = self._details.get(path)
            if entry.kind != "component" or not entry.looked:
                continue
            if detail is None or detail.links != entry.links:
                due.append(path)
            elif detail.asked < end:
                old.append(path)
        return due + old[:MOST_AGAIN]

    def _page(self, snapshots, lost, ends=()):
        """The data of the page for components that are known, and others."""
        system = capture.of_snapshots(snapshots, dict(ends))
        drawing = live_graph.of_system(system, lost)
        for box in drawing.picture.boxes:
            if box.path:
                box.state = None
        failures = self._looking.failures().items()
        remarks = [page.Remark("fail", "", path, failure.why, "") for path, failure in failures]
        return page.fields(
            drawing.picture, drawing.profile, self._title, self._what, remarks, last=self._fields
        )

    # ---- browsers ----

    def _answer(self, request):
        """The http.Answer to a http.Request. Raises http.Refused."""
        self._place.check(request)
        path = self._place.path
        if request.target == path:
            html = page.live_html(self._title, self._content())
            policy = ("Content-Security-Policy", page.live_policy())
            return http.Answer(200, "text/html; charset=utf-8", html.encode(), (policy,))
        if request.target.startswith(path + "events?"):
            version = request.headers.get("last-event-id") or request.target.partition("?")[2]
            stream = functools.partial(self._send_events, version)
            return http.Answer(200, "text/event-stream", stream, ())
        raise http.Refused(404)

    def _content(self):
        """The data of the page in JSON, as they are now."""
        return page_file.as_json(dict(self._fields, version=self._name(), now=self._since(0)))

    def _name(self):
        return f"{self._run}-{self._version}"

    def _since(self, change):
        """{number of a box: [state, words]} of those that are new since a change."""
        changed = {}
        for path, number in self._numbers.items():
            when, now = self._now.get(path, (0, None))
            if when > change:
                changed[number] = now
        return changed

    async def _send_events(self, version, connection):
        """Send to a browser what changes; it has this `version`. Raises http.Gone, OSError."""
        bell = loop.Bell()
        self._bells.add(bell)
        change = 0
        beat = loop.now()
        try:
            await connection.send(b"retry: 2000\n\n")
            while True:
                event = ""
                now = self._since(change)
                if version != self._name():
                    event = f"event: system\nid: {self._name()}\ndata: {self._content()}\n\n"
                elif now:
                    event = f"event: states\ndata: {page_file.as_json(now)}\n\n"
                elif loop.now() - beat > BEAT:
                    event = ":\n\n"
                change = self._changes
                version = self._name()
                if event:
                    beat = loop.now()
                    await connection.send(event.encode())
                connection.check()
                await bell.wait(TICK)
        finally:
            self._bells.discard(bell)
