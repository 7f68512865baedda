"""Every failure a command can report: the docstring is the message, `status` the exit status."""


class Error(Exception):
    """{}"""

    status = 1

    def __str__(self):
        return self.__doc__.format(*self.args)


class Usage(Error):
    """{} (see --help)"""

    status = 2


class MissingOmniORB(Error):
    """omniORBpy is not installed: take it from the OS packages (python3-omniorb), or pip install 'rtshell_lite[omniorb]'"""


class NotFound(Error):
    """{}: no such path"""

    status = 3


class Misspelt(NotFound):
    """{}: no such path; did you mean {}?"""


class NoSuchPort(NotFound):
    """{}: no such port"""


class NoSuchItem(NotFound):
    """{}: no such {}: {}"""


class WrongKind(Error):
    """{}: not a {}"""

    status = 3


class Unreachable(Error):
    """{}: {}"""

    status = 4


class Zombie(Unreachable):
    """{}: zombie: the name is bound, but its object is gone"""

    def __init__(self, where):
        Unreachable.__init__(self, where, "zombie")


class Partial(Error):
    """{}"""

    status = 5


class Refused(Error):
    """{}: {}"""

    status = 6
