"""What rtcall prints besides a result: interfaces, their operations, repeated calls."""

from rtshell_lite import errors, notes, text
from rtshell_lite.data import call_values, calling, repeating
from rtshell_lite.robot import ports


async def interfaces(path, types, as_json):
    """Lines about the interfaces that a component, or one of its ports, provides: the port, the instance, its
    type, its repository id, the file of its IDL; none for a manager or a name server. Raises what
    calling.providers raises.
    """
    rows = []
    try:
        providers = await calling.providers(path, types)
    except errors.WrongKind:
        if path.port is not None:
            raise
        await calling.itself(path, types)
        providers = []
    for provider in providers:
        service = provider.service
        row = {
            "port": ports.label(service.port),
            "instance": service.instance,
            "type_name": service.type_name,
            "repository_id": provider.repository_id,
            "idl": provider.interface and provider.interface.file,
        }
        rows.append(row)
    if as_json:
        return [text.json_line(row) for row in rows]
    if not rows:
        own = text.shell_word(str(path))
        notes.note(
            f"{path}: it has no ports that provide interfaces; rtcall {own} -l lists what it serves itself"
        )
    for row in rows:
        row["port"] = row["port"][len(str(path.object())) + 1 :]
    return text.table([[text.printable(cell or "IDL not known") for cell in row.values()] for row in rows])


async def operations(paths, types, as_json, names=()):
    """Lines with the operations and attributes of the providers at Paths, as IDL, of these names or all; an
    errors.Error for what failed.
    """
    providers = []
    for path in paths:
        try:
            if path.port is None:
                providers.append(await calling.itself(path, types))
            else:
                providers += await calling.providers(path, types)
        except errors.Error as e:
            providers.append(e)
    lines = []
    for provider in providers:
        lines += _operations(provider, len(providers) > 1, as_json, names)
    return lines + _unknown(providers, names)


def _operations(provider, is_one_of_several, as_json, names):
    if isinstance(provider, errors.Error):
        return [provider]
    try:
        provider.check_known()
    except errors.Error as e:
        return [e]
    notes.detail(f"{provider.where}: {provider.described()}")
    members = [member for member in provider.members() if not names or member.name in names]
    if as_json:
        rows = [{"provider": provider.where, "name": member.name, "idl": member.idl()} for member in members]
        return list(map(text.json_line, rows))
    if not is_one_of_several:
        return [member.idl() for member in members]
    if not members:
        return []
    return [provider.where + ":"] + ["  " + member.idl() for member in members]


def _unknown(providers, names):
    """An errors.NoSuch for each of the names that none of the Providers has; none where one has failed."""
    operation_names = []
    for provider in providers:
        if isinstance(provider, errors.Error) or provider.interface is None:
            return []
        operation_names += provider.names()
    where = ", ".join(provider.where for provider in providers)
    return [
        calling.no_operation(where, name, operation_names) for name in names if name not in operation_names
    ]


class Repeated:
    """An operation called again and again: the lines about it."""

    def __init__(self, provider, operation, as_json, is_each_shown):
        self.provider = provider
        self.operation = operation
        self.as_json = as_json
        self.is_each_shown = is_each_shown
        self.figures = repeating.Latencies()

    async def run(self, values, limit, rate, number):
        """Yield a line for each call, if that is wanted; else the first failure is reported."""
        call = self.provider.repeated(self.operation, values, limit)
        ended = None
        async for seconds, result, error in repeating.calls(call, rate, number):
            self.figures.add(seconds, error)
            if isinstance(error, errors.Raised):
                error = call_values.shown_exception(error)
            if self.is_each_shown:
                yield self._line(seconds, result, error)
            elif error is not None and self.figures.failed == 1:
                notes.fail(error)
            if isinstance(error, errors.Unreachable):
                ended = error
        if ended is not None and (number is None or self.figures.count < number):
            self._report_end(ended, number)

    def _report_end(self, error, number):
        """Report that no more calls were made, and why, unless the first failure has said that."""
        calls = text.counted(self.figures.count, "call")
        if number is not None:
            calls = f"{self.figures.count} of {text.counted(number, 'call')}"
        if self.figures.failed > 1 and not self.is_each_shown:
            notes.fail(f"{error}; ended after {calls}")
        else:
            notes.fail(f"{self.provider.where}: ended after {calls}")

    def _line(self, seconds, result, error):
        if not self.as_json:
            shown = str(error) if error else call_values.as_text(self.operation, result)
            return "%.3f ms  %s" % (1e3 * seconds, text.safe(shown or ""))
        row = {"seconds": seconds, "error": None, "value": None}
        if error is None:
            row["value"] = call_values.as_dict(self.operation, result)
        else:
            row["error"] = str(error)
        return text.json_line(row)

    def summary(self):
        """A line with the figures."""
        if self.as_json:
            return text.json_line(self.figures.summary())
        return self.figures.line()

    def status(self):
        """The exit status."""
        return self.figures.status()
