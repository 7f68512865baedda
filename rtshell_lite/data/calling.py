"""Operations of objects that others serve: of the interfaces of service ports, and of components, managers
and name servers themselves.

    provider = await calling.find(path, types, "echo")
    operation = provider.operation("echo")
    values = call_values.of_words(operation, ["hi"], provider.find_type)
    result = await provider.call(operation, values, 60.0)

An operation is asked once, whatever happens: it may move a robot (docs/protocol.md 7).
"""

from _functools import partial  # as in net/loop.py

from rtshell_lite import errors, notes, text
from rtshell_lite.corba import orb
from rtshell_lite.robot import component, tree

LIMIT = 60.0  # seconds that a call may take: the commonest example takes 10
MAYBE = "it may have been done, or be going on"
DONE = "it may have been done"
NOT_COMPLETED = 1  # of CORBA::CompletionStatus
COMPLETED = 0
REMEDY = "name its file (--idl FILE), or its directory (RTSHELL_IDL)"


class Provider:
    """An object whose operations can be called.

    where          its path as a user would type it: PATH:PORT.INSTANCE, or PATH for a component itself
    node           the Node it belongs to
    ref            its reference
    repository_id  of its interface, as the reference says
    service        its services.Service, None for a component itself
    interface      its Interface, None where no IDL is known
    """

    def __init__(self, where, node, ref, repository_id, service, types):
        self.where = where
        self.node = node
        self.ref = ref
        self.repository_id = repository_id
        self.service = service
        self._types = types
        self.interface = types.interface(repository_id)
        self._operations = None
        self._schemas = {}

    def find_type(self, name):
        """The descriptor of a type by its name. Raises NoSuch."""
        return self._types.named(name).descriptor

    # ---- what it has ----

    def check_known(self):
        """Raise NoSuch where the IDL of its interface is not known."""
        if self.interface is None:
            raise errors.NoSuch(self.where, "IDL", f"{text.printable(self.repository_id)}; {REMEDY}")
        if self.interface.kind:
            raise errors.Unsupported(
                self.where, f"its interface is {self.interface.kind}: nobody can call it"
            )

    def described(self):
        """Its repository id, and the file of its IDL, spelt for the terminal."""
        return f"{text.printable(self.repository_id)}, {self._file()}"

    def operations(self):
        """{name: Operation} of all that can be called; those of attributes are _get_NAME and _set_NAME."""
        if self._operations is None:
            self._operations = self.interface.all_operations() if self.interface else {}
        return self._operations

    def members(self):
        """Its Operations and Attributes, the inherited ones after its own."""
        ancestry = self.interface.ancestry() if self.interface else []
        return [member for interface in ancestry for member in interface.attributes + interface.operations]

    def operation(self, name):
        """The Operation of a name; that of an attribute reads it. Raises NoSuch with candidates."""
        self.check_known()
        operation = self.operations().get(name) or self.operations().get("_get_" + name)
        if operation is None and self.service is None and self.node.kind == "component":
            remedy = f"; rtcall {text.shell_word(self.where)} lists what its ports provide"
            raise no_operation(self.where, name, self.names(), remedy)
        if operation is None:
            raise no_operation(self.where, name, self.names())
        return operation

    def names(self):
        """The names of its operations and attributes."""
        return [member.name for member in self.members()]

    def setter(self, name):
        """The Operation that sets an attribute. Raises NoSuch, Unsupported."""
        self.check_known()
        operation = self.operations().get("_set_" + name)
        if operation is None and "_get_" + name in self.operations():
            raise errors.Unsupported(self.where, f"its attribute {text.printable(name)} is readonly")
        if operation is None:
            attributes = [attribute.name for attribute in self.interface.all_attributes()]
            raise errors.NoSuch(
                self.where, "attribute", text.printable(name) + text.candidates(name, attributes)
            )
        return operation

    # ---- calls ----

    async def call(self, operation, values, limit=LIMIT):
        """What an Operation returns, for values in the order of its in and inout parameters: one value, a
        tuple of several, or None. It may take `limit` seconds.

        Raises Raised for an exception of its IDL, Refused, MayBeDone, Unreachable.
        """
        where = self._named(operation)
        ask = partial(orb.call, where, self.ref, self._schema(operation), *values, seconds=limit)
        return await self._ask_once(operation, ask)

    def repeated(self, operation, values, limit=LIMIT):
        """A coroutine function that calls an Operation, see `call`, with the same values each time."""
        where = self._named(operation)
        ask = orb.repeated(where, self.ref, self._schema(operation), *values, seconds=limit)
        return partial(self._ask_once, operation, ask)

    async def _ask_once(self, operation, ask):
        if operation.oneway:
            await self._check_served(self._named(operation))
        is_over = False
        try:
            result = await ask()
            is_over = True
            return result
        except errors.Raised as e:
            is_over = True
            raise e
        except errors.Error as e:
            is_over = True
            raise await self._meaning(e, operation)
        finally:
            if not is_over:
                notes.fail(f"{self._named(operation)}: interrupted; {MAYBE}")

    def _named(self, operation):
        return f"{self.where} {operation.shown}"

    def _schema(self, operation):
        if operation.name not in self._schemas:
            self._schemas[operation.name] = operation.schema()
        return self._schemas[operation.name]

    async def _check_served(self, where):
        """Raise what a call would raise whose failure nobody reports, as it is oneway."""
        try:
            await orb.is_alive(where, self.ref)
        except errors.Gone:
            raise await self._gone(where)

    async def _meaning(self, e, operation):
        """The errors.Error that says what a failure of a call means."""
        where = self._named(operation)
        name, completed = e.exception or ("", None)
        if isinstance(e, errors.Silent) and not name:
            return errors.MayBeDone(where, e.why)
        if isinstance(e, errors.ConnectionLost) and not name:
            return await self._cut(where)
        if name == "OBJECT_NOT_EXIST":
            return await self._gone(where)
        if name == "BAD_OPERATION":
            return errors.Refused(where, f"it has no such operation: {self._wrong_idl()}", name=name)
        if name == "MARSHAL" and completed == NOT_COMPLETED:
            return errors.Refused(where, f"it takes other arguments: {self._wrong_idl()}", name=name)
        if name == "MARSHAL" and completed == COMPLETED:
            return errors.Unreachable(where, f"done, but its answer is of another type: {self._wrong_idl()}")
        if name == "UNKNOWN":
            return errors.Refused(where, f"it raised what {self._file()} does not declare; {DONE}", name=name)
        if completed == NOT_COMPLETED:
            return errors.Refused(where, f"it raised {text.printable(name)}; nothing was done", name=name)
        if name:
            return errors.Refused(where, f"it raised {text.printable(name)}; {DONE}", name=name)
        return e

    async def _cut(self, where):
        """The error for a connection that was cut while a call was under way: omniORB does so at arguments
        with too many octets, and lives.
        """
        try:
            await orb.is_alive(where, self.ref)
        except errors.Error:
            return errors.MayBeDone(where, "connection lost, its process has probably ended")
        return errors.Refused(
            where,
            "it cut the connection and lives: it probably takes other arguments, and did nothing; "
            f"{self._wrong_idl()}",
        )

    async def _gone(self, where):
        """The error for an object that is not there."""
        if self.service is None:
            return errors.Gone(where)
        try:
            state = await component.state(self.node)
        except errors.Error as e:
            return e
        path = text.shell_word(str(self.node.path))
        if state == "Active":
            return errors.Unreachable(where, "its object is gone, though the component is Active")
        remedy = f"rtact {path}"
        if state == "Error":
            remedy = f"rtreset {path}, then {remedy}"
        return errors.Refused(
            where, f"the component is {state}, and serves only while it is Active: {remedy} first"
        )

    def _wrong_idl(self):
        return f"{self._file()} is probably not its IDL ({text.printable(self.repository_id)})"

    def _file(self):
        return text.printable(self.interface.file)


# ---- finding providers ----


async def providers(path, types):
    """The Providers of a Path, in their order: those of a port or, as PATH:PORT.INSTANCE, of one of its
    interfaces; of a path without a port, those of all ports of the component. Raises NoSuch, Unreachable,
    Refused, WrongKind.
    """
    # here and below: a component itself is called without them
    from rtshell_lite.robot import ports, services

    node = await tree.component(path.object())
    listed = await ports.ports(node)
    if path.port is None:
        provided = [service for port in listed for service in await services.of_port(port)]
        return [of_service(service, types) for service in provided]
    port, instance = _named(path, listed)
    provided = await services.of_port(port)
    if not provided:
        raise errors.NoSuch(ports.label(port), "interface", f"it provides none (it is a {port.type})")
    if instance is not None:
        there = [service.instance for service in provided]
        provided = [service for service in provided if service.instance == instance]
        if not provided:
            raise errors.NoSuch(
                ports.label(port), "interface", text.printable(instance) + text.candidates(instance, there)
            )
    return [of_service(service, types) for service in provided]


def _named(path, listed):
    """(the Port, the instance or None) that PATH:PORT[.INSTANCE] means: the longer name of a port comes
    first.
    """
    from rtshell_lite.robot import ports

    port = ports.named(path, listed)
    if not isinstance(port, errors.Error):
        return port, None
    shorter, dot, instance = path.port.rpartition(".")
    if dot and shorter:
        shorter_port = ports.named(path.with_port(shorter), listed)
        if not isinstance(shorter_port, errors.Error):
            return shorter_port, instance
    raise port


def of_service(service, types):
    """The Provider for a services.Service."""
    from rtshell_lite.robot import services

    return Provider(
        services.label(service), service.port.node, service.ref, service.repository_id, service, types
    )


async def itself(path, types):
    """The Provider for the component, manager or name server at a Path. Raises NotFound, WrongKind,
    Unreachable.
    """
    node = await tree.resolve(path)
    if node.kind in ("server", "directory"):
        repository_id = "IDL:omg.org/CosNaming/NamingContext:1.0"
    else:
        node = await tree.component(path, or_manager=True)
        repository_id = orb.address(node.ref).type_id
    return Provider(str(path), node, node.typed, repository_id, None, types)


async def find(path, types, name):
    """The Provider at a Path that has an operation or attribute of this name. Raises NoSuch where none has,
    or several have.
    """
    if path.port is None:
        return await single(path, types)
    candidates = await providers(path, types)
    having = [provider for provider in candidates if has(provider, name)]
    if len(having) > 1:
        listed = " or ".join(provider.where for provider in having)
        raise errors.NoSuch(
            str(path), "operation for certain", f"{text.printable(name)} may be that of {listed}"
        )
    if having:
        return having[0]
    for provider in candidates:
        provider.check_known()
    raise no_operation(
        str(path), name, [operation for provider in candidates for operation in provider.names()]
    )


def no_operation(where, name, names, remedy=""):
    """The NoSuch for an operation, with candidates."""
    names = list(dict.fromkeys(names))
    return errors.NoSuch(where, "operation", text.printable(name) + text.candidates(name, names) + remedy)


async def single(path, types):
    """The only Provider at a Path, whose IDL is known. Raises NoSuch where there are several."""
    if path.port is None:
        candidates = [await itself(path, types)]
    else:
        candidates = await providers(path, types)
    if len(candidates) > 1:
        listed = " or ".join(provider.where for provider in candidates)
        raise errors.NoSuch(str(path), "single interface", f"it is {listed}")
    candidates[0].check_known()
    return candidates[0]


def has(provider, name):
    """Whether a Provider has an operation or attribute of this name."""
    return name in provider.operations() or "_get_" + name in provider.operations()
