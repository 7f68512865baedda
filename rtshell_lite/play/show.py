"""A recording that is played as components, from its beginning to its end."""


from rtshell_lite import errors, notes, path
from rtshell_lite.corba import orb
from rtshell_lite.datalog import flight
from rtshell_lite.net import loop
from rtshell_lite.play import bindings, nameserver, recording, stage
from rtshell_lite.robot import tree

HERE = "127.0.0.1"
DISCARD = 9  # a port that nobody is asked at
ELSEWHERE = "192.0.2.1"  # of no host (RFC 5737): what faces it is this host's usual address
SLICE = 1000  # entries that are looked at before others go on
LOOK = 0.02  # seconds between two looks whether somebody is connected


class Show:
    """Plays a log as components, with its decode.Decoder.

    prefix     Names below which they are bound
    server     address of the name server; None for the first of RTCTREE_NAMESERVERS
    serve      (host, port) of a name server of our own instead, or None; at all addresses of this host with
               0.0.0.0 or ::
    choice     flight.Choice of the out ports that send
    is_absolute  the timestamps in the data stay
    """

    def __init__(self, decoder, prefix=(), server=None, serve=None, choice=None, is_absolute=False):
        self._decoder = decoder
        self._log = decoder.log
        self._prefix = prefix
        self._server = server
        self._serve = serve
        self._choice = choice or flight.Choice()
        self._is_absolute = is_absolute
        self._recording = recording.Recording(self._log)
        self._scene = 0
        self._stage = None
        self._bound = None
        self._failed = set()  # channels whose values cannot be sent

    async def run(self, pace, begin):
        """Bind the components, play what a pace.Pace says, and end them; begin(): awaited when they can be
        asked.
        """
        host, server = await self._listen()
        async with loop.Group() as tasks:
            self._stage = stage.Stage(self._recording, host, tasks)
            self._bound = bindings.Bindings(server)
            try:
                self._stage.show(self._recording.scenes[0], is_jump=True)
                await self._bind()
                count = len(self._bound.bound)
                what = "1 component is" if count == 1 else f"{count} components are"
                notes.note(f"{what} bound in {self._bound.server}")
                await begin()
                await self._play(pace)
                await self._stage.sent()
            finally:
                await loop.finish(self._end())
                tasks.cancel()

    async def _end(self):
        await self._bound.clear()
        await self._stage.leave()
        self._stage.close()

    async def _listen(self):
        """Take calls: (this host's address for references, the Node of the name server)."""
        if self._serve is None:
            orb.listen()
            server = tree.name_server(self._server or tree.servers()[0])
            return await _facing(*server.endpoint), server
        host, port = self._serve
        if host in ("0.0.0.0", "::"):
            port = orb.listen("", port)
            host = await _facing(ELSEWHERE, DISCARD)
        else:
            port = orb.listen(host, port)
        nameserver.Names(host)
        address = f"[{host}]:{port}" if ":" in host else f"{host}:{port}"
        return host, tree.name_server(address)

    async def _bind(self, has_begun=False):
        """Bind the names of the components that have come, and unbind those of the ones that are gone."""
        changed = sorted(self._stage.changed)
        self._stage.changed = set()
        for where in changed:
            names = self._prefix + path.parse(where).names
            try:
                await self._bind_one(names, self._stage.components[where])
            except errors.Error as e:
                if not has_begun:
                    raise
                notes.fail(e)

    async def _bind_one(self, names, component):
        if names in self._bound.bound:
            await self._bound.unbind(names)
        if component.is_there:
            await self._bound.bind(names, component.reference)

    def is_played(self, number):
        """Whether the values of a channel are sent."""
        port = self._recording.channels.get(number)
        if port is None:
            return False
        type_id = self._log.channels[number].type_id
        return self._choice.allows(flight.names_of(str(port), type_id))

    async def connected(self):
        """Wait until somebody is connected with each port that is played."""
        ports = [port for number, port in self._stage.outs.items() if self.is_played(number)]
        while not all(port.carriers for port in ports if port.component.is_there):
            await loop.sleep(LOOK)

    # ---- playing ----

    async def _play(self, pace):
        async for entry in pace.entries():
            if pace.is_elsewhere:
                await self._seek(entry.received)
            self._take(entry)
            if self._stage.changed:
                await self._bind(has_begun=True)

    async def _seek(self, moment):
        """Have everything be as it was right before a moment."""
        self._scene = self._recording.scene_at(moment)
        scene = self._recording.scenes[self._scene]
        self._stage.show(scene, is_jump=True)
        first = self._log.since(scene.moment)
        if first is None:
            return
        for count, entry in enumerate(self._log.entries(first)):
            if entry.received >= moment:
                return
            if entry.channel in self._recording.events:
                self._report(entry)
            if count % SLICE == 0:
                await loop.sleep(0)

    def _take(self, entry):
        scenes = self._recording.scenes
        while self._scene + 1 < len(scenes) and scenes[self._scene + 1].moment <= entry.received:
            self._scene += 1
            self._stage.show(scenes[self._scene])
        if entry.channel in self._recording.events:
            self._report(entry)
        elif entry.channel in self._stage.outs and self.is_played(entry.channel):
            self._send(entry)

    def _report(self, entry):
        report = self._recording.report(entry)
        if report is None:
            return
        scenes = self._recording.scenes
        following = scenes[self._scene + 1] if self._scene + 1 < len(scenes) else None
        self._stage.take(report, following)

    def _send(self, entry):
        moment = None if self._is_absolute else int(loop.wall() * 1e9)

        def data_of(little):
            return self._decoder.data(entry, little, moment)

        try:
            self._stage.outs[entry.channel].write(data_of)
        except errors.Failed as e:
            if entry.channel not in self._failed:
                self._failed.add(entry.channel)
                notes.fail(e)


async def _facing(host, port):
    """This host's address that faces another one."""
    return await loop.on_thread(loop.world().own_address, host, port) or HERE
