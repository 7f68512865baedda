"""The components that an RtsProfile lists,
each with its place and with what one look at the running system found there.
"""

import collections

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb
from rtshell_lite.robot import ports, tree
from rtshell_lite.system import capture, relocate

# Something to ask: `endpoint` of the process that answers, `where`, the path of the object, for errors, and a
# coroutine function.
Question = collections.namedtuple("Question", "endpoint where ask")

MISSING = (errors.NotFound, errors.Gone, errors.ProcessGone)


def is_gone(failure):
    """True for an errors.Error that says that a component is not there, or not any more."""
    return isinstance(failure, MISSING) and not isinstance(failure, errors.NoNameServer)


class Placement:
    """A component of a profile (a model.Component) and where it is, or is to be: `path`.

    found  its capture.ComponentState; None while it is not there
    node   its Node; None while it is not there
    error  why nothing can be done with it; None if something can
    """

    def __init__(self, component):
        self.component = component
        self.instance = component.instance_name
        self.required = component.is_required
        self.path = relocate.path_in(component.path_uri)
        self.where = str(self.path) if self.path.names else capture.shown_path(component)
        self.found = self.node = self.error = None
        if not self.path.names:
            self.error = errors.Failed(self.where, "not the path of a component")

    def port(self, name, listed=None):
        """The Port that a profile calls `name`, of the Ports `listed` (default:
        those found), or the error NoSuch.
        """
        if listed is None:
            listed = self.found.ports
        names = [name, self.instance + "." + name]
        return next((port for port in listed if port.name in names), None) or ports.named(
            self.path.with_port(name), listed
        )

    def port_question(self, name):
        """A Question that asks the component for its port called `name`. Raises NoSuch."""
        where = str(self.path.with_port(name))
        if self.found is None:
            return Question(self.node.endpoint, where, lambda: self._asked_port(name))
        port = self.port(name)
        if isinstance(port, errors.Error):
            raise port
        return Question(orb.endpoint(port.ref), where, lambda: ports.port(self.node, port.ref))

    async def _asked_port(self, name):
        return self.port(name, await ports.ports(self.node))


def of(profile):
    """The Placements of the components of a profile, in the order of the file."""
    return [Placement(component) for component in profile.components]


async def find(placements, ask=capture.ask):
    """Find the components of Placements, and what `ask(node)`, which returns a capture.ComponentState, says
    of each; `error` where that fails.
    """
    asked = [placement for placement in placements if placement.error is None]
    with notes.Work("components", len(asked)) as work:
        answers = await tree.on_components([placement.path for placement in asked], work.counting(ask))
    for placement, answer in zip(asked, answers):
        if isinstance(answer, errors.Error):
            placement.error = answer
        else:
            placement.found = answer
            placement.node = answer.node


def finder(locate, placements):
    """A function: the one of `placements` that an end or a participant in the profile names, or None;
    `locate` is a capture.locator.
    """
    by_component = {id(placement.component): placement for placement in placements}
    return lambda target: by_component.get(id(locate(target)))
