"""Every failure a command can report: `message` is what it prints, `status` the exit status.

The first argument of most, called `where` elsewhere, is the object as the user knows it: a path escaped for
the terminal. The last says why, without naming a path.
"""

TYPE_CHECKING = False  # checkers of types take it as True; importing typing would slow each command down
if TYPE_CHECKING:
    from typing import Any

NO_USABLE_ADDRESS = "host name not known"  # or no address that the settings of omniORB let us use
BAD_ENDPOINT = "this machine cannot be reached at the address that ORBendPoint names"


class Error(Exception):
    message = "{}"
    status = 1
    # of the system exception that an operation of a user's IDL raised: its name, whether the operation was
    # completed (0: yes, 1: no, 2: maybe)
    exception = None  # type: object

    def __str__(self) -> str:
        return self.message.format(*self.args)

    @property
    def where(self) -> str:
        """The object that the message begins with: a path, a file, a type; "" where it names none."""
        return str(self.args[0]) if self.message.startswith("{}:") else ""

    @property
    def why(self) -> str:
        """What the message says of `where`; all of it where that is ""."""
        return str(self)[len(self.where) + 1 :].lstrip() if self.where else str(self)


def split(values: "list[Any]") -> "tuple[list[Any], list[Error]]":
    """(values that are not Errors, the Errors) of a mixed list."""
    good = [value for value in values if not isinstance(value, Error)]
    bad = [value for value in values if isinstance(value, Error)]
    return good, bad


def raise_first(values: "list[Any]") -> "list[Any]":
    """The values of a mixed list, none of which is an Error; raises the first that is."""
    for value in values:
        if isinstance(value, Error):
            raise value
    return values


async def or_error(coroutine: "Any") -> "Any":
    """What a coroutine returns, or the Error that it raises."""
    try:
        return await coroutine
    except Error as e:
        return e


class Failed(Error):
    message = "{}: {}"


class Shortage(Error):
    message = "out of {} here: {}"  # files, threads, ports, memory; why


class BadProfile(Error):
    message = "{}:{}:{}: {}"  # file, line, column, what is wrong there


class BadIdl(Error):
    message = "{}:{}:{}: {}"  # file, line, column, what is wrong there


class BadType(Error):
    message = "{}: {}"  # type, why it cannot be used


class MissingOmniORB(Error):
    message = (
        "omniORBpy is not installed, but RTSHELL_ORB asks for it; unset that, or install it from the "
        "package index (jeteve-omniorb; salome-omniorb for Python 3.7) or from OpenRTM-aist's package "
        "repository"
    )


class OnlyOmniORB(Error):
    message = (
        "{}: only omniORB knows that, and omniORBpy is not installed "
        "(package jeteve-omniorb; salome-omniorb for Python 3.7)"
    )


class IncompletePython(Error):
    message = (
        "this Python lacks its module {}, which is needed for that; "
        "a whole one has it (Debian: python3, not python3-minimal)"
    )


class NoXml(Error):
    message = (
        "this Python lacks its module {}, which XML needs; rtcryo --yaml writes YAML, which all commands "
        "read (Debian: python3 is whole, python3-minimal is not)"
    )


class Usage(Error):
    message = "{} (see --help)"
    status = 2


class BadPath(Error):
    message = "{}: {}"  # as it was typed, what is wrong with it
    status = 2


class BadValue(Error):
    message = "{}: {}"  # type and field, why the value does not fit
    status = 2


class BadLine(Error):
    message = "{}"  # of rtsh
    status = 2


class NotFound(Error):
    message = "{}: no such path"
    status = 3


class Misspelt(NotFound):
    message = "{}: no such path; did you mean {}?"


class NoPattern(NotFound):
    message = "{}: no such path; to look for a pattern: {}"


class NoEntry(NotFound):
    message = "{}: no such path; a name server is written with a slash: {}"


class NoServer(NotFound):
    message = (
        "{}: no such path: it begins with no name server; RTSHELL_FIND=1 finds a component by its name alone"
    )


class Ambiguous(Error):
    message = "{}: {}; which one?"  # what was typed, what it may mean
    status = 3


class NoSuch(Error):
    message = "{}: no such {}: {}"
    status = 3


class Unsupported(Error):
    message = "{}: {}"  # what the object, or this program, cannot do
    status = 6


class WrongKind(Error):
    message = "{}: not a {} (it is a {})"
    status = 3


class Unreachable(Error):
    message = "{}: {}"
    status = 4


class ConnectionLost(Unreachable):
    message = "{}: connection lost"


class Garbled(Unreachable):
    message = "{}: garbled answer ({})"  # what is in it that must not be used


class LostMember(Unreachable):
    message = "{}: {}"  # a port that a composite exports: the process of its member is gone


class Unanswered(Unreachable):
    message = "{}: {}"  # nothing has come from it: it is Silent, or was NotAsked


class Silent(Unanswered):
    message = "{}: {}"  # it was asked, and did not answer in time


class NotAsked(Unanswered):
    message = "{}: not asked: {}"  # a process that others found silent, and the like


class Unspoken(NotAsked):
    message = "{}: listens with {} only, which is not spoken here"  # TLS and the like; it may well live


class NoTime(NotAsked):
    message = "{}: {}"  # a command that promises to end in time had none left


class Late(Unreachable):
    message = "{}: {}"  # it answers, but what was asked for has not come to be in time


class ConnectionRefused(Unreachable):
    message = "{}: connection refused"


class ProcessGone(ConnectionRefused):
    message = "{}: connection refused; its process is gone (zombie)"


class MaybeGone(ConnectionRefused):
    message = "{}: refuses: dead, or a firewall closes this port"


class NoNameServer(ConnectionRefused):
    message = "{}: connection refused; is the name server running?"


class NoManager(ConnectionRefused):
    message = "{}: connection refused; is the manager running?"


class BadData(Unreachable):
    message = "{}: {}"  # type, why the bytes are no value of it


class Refused(Error):
    message = "{}: {}"
    __slots__ = ("name",)  # 20,000 of them are kept when as many objects refuse
    status = 6

    def __init__(self, where: str, why: str, name: str = "") -> None:
        """`name` is the CORBA exception's or return code's name,
        for callers that treat some of them otherwise.
        """
        super().__init__(where, why)
        self.name = name


class Raised(Error):
    message = "{}: {}"
    status = 6

    def __init__(self, where: str, name: str, value: object, shown: str = "") -> None:
        """`name` is that of an exception of the IDL, `value` has its members as attributes, `shown` them as
        text.
        """
        super().__init__(where, name + shown)
        self.name = name
        self.value = value


class Mismatch(Refused):
    message = "{}: {}"  # what is asked for does not go together; no peer was asked
    __slots__ = ()
    status = 2


class LeftAlone(Error):
    message = "{}: left: {}"  # a name of what may live, and why that is not known


class Gone(Unreachable):
    message = "{}: zombie (the name is bound, but its object is gone)"


class Uncertain(Unreachable):
    message = "{}: {}; whether it has been done is not known"


class MayBeDone(Unreachable):
    message = "{}: {}; it may have been done, or be going on"


class Unread(Error):
    message = "{}: {}"
    status = 5


class NotTried(Error):
    message = "{}: not tried: {}"
    status = 5


class Partial(Error):
    message = "{} of {} failed"
    status = 5
