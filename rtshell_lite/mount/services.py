"""Interfaces of service ports in a mounted RTC Tree: their operations are files, which are called by writing.

Operations are not listed, and nothing is asked until one is named: what they are is in the IDL, which IDL it
is in a reference that only a connection gives.
"""

import re
import stat

from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.mount.nodes import Absent, Directory, File, Text, line, unique
from rtshell_lite.mount.openfile import OpenFile
from rtshell_lite.net import loop

_IDENTIFIER = r"_?[A-Za-z]\w*\Z"


class InterfacesDirectory(Directory):
    """The interfaces of a service port."""

    __slots__ = ()

    def named(self, snapshot):
        """{file name: ports.Interface}"""
        listed = self.above.port(snapshot).interfaces
        return dict(zip(unique(interface.instance_name for interface in listed), listed))

    def entries(self, snapshot):
        return {name: (InterfaceDirectory,) for name in self.named(snapshot)}


class InterfaceDirectory(Directory):
    """One interface."""

    __slots__ = ("_provider",)

    def __init__(self, above, name):
        super().__init__(above, name, above.source)
        self._provider = None  # that of the last call, which is good as long as the process lives

    def interface(self, snapshot):
        """Its ports.Interface. Raises Absent."""
        return self.own(self.above.named(snapshot))

    def entries(self, snapshot):
        def shown(now):
            interface = self.interface(now)
            return line(f"{interface.polarity} {interface.type_name}")

        return {"type": (Text, self.source, shown)}

    async def find(self, name):
        snapshot = await self.source.get()
        is_provided = self.interface(snapshot).polarity == "Provided"
        if name == "type" or not is_provided or not re.match(_IDENTIFIER, name, re.ASCII):
            return self.pick(name, snapshot)
        provider = await self.provider()
        if name not in provider.operations():
            raise Absent(f"{self.where}/{name}")
        return self.child(name, (Operation,))

    async def provider(self):
        """Its calling.Provider. Raises Absent, Unreachable, Refused."""
        from rtshell_lite.data import calling, datatypes
        from rtshell_lite.robot import services

        snapshot = await self.source.get()
        instance = self.interface(snapshot).instance_name
        port = self.above.above.port(snapshot)
        if self._provider is not None and orb.same(self._provider.service.port.ref, port.ref):
            return self._provider
        provided = [service for service in await services.of_port(port) if service.instance == instance]
        if not provided:
            raise Absent(self.where)
        types = datatypes.Types()
        await loop.on_thread(types.interface, provided[0].repository_id)  # there may be many files
        self._provider = calling.of_service(provided[0], types)
        return self._provider

    def forget(self):
        """Look it up again next time."""
        self._provider = None


class Operation(File):
    """An operation: a line of JSON that is written to it calls it, what it returns is read from the same open
    file.
    """

    __slots__ = ()
    mode = stat.S_IFREG | 0o644

    async def content(self):
        return ""

    def open(self):
        return Call(self)

    async def call(self, text):
        """What it returns, as a line. Raises errors.Error."""
        from rtshell_lite.data import call_values

        provider = await self.above.provider()
        operation = provider.operation(self.name)
        values = call_values.of_line(operation, text, provider.find_type)
        try:
            result = await provider.call(operation, values)
        except errors.Raised as e:
            raise call_values.shown_exception(e)
        except errors.Unreachable:
            self.above.forget()
            raise
        return line(call_values.as_text(operation, result) or "")


class Call(OpenFile):
    """An open Operation; `_result` is what is left to read."""

    def __init__(self, node):
        super().__init__(node)
        self._result = b""

    def read(self, offset, size):
        part = self._result[:size]
        self._result = self._result[size:]
        return part

    async def store(self, text):
        """Call it for each line; what the last writing has returned can be read."""
        self._result = b""
        for words in text.split("\n"):
            self._result += (await self.node.call(words)).encode("utf-8", "backslashreplace")
