"""Where in the RTC Tree a reference is bound: found by comparing references, without asking their objects."""
from rtshell_lite import errors
from rtshell_lite.corba import orb
from rtshell_lite.path import Name, Path
from rtshell_lite.robot import ports, tree
from rtshell_lite.text import printable


class Places:
    """Finds the paths of components: beside a known one first, in its name server and all others when need be."""

    def __init__(self, node):
        self.beside = node.path.parent()
        self.everywhere = None

    def path(self, instance, ref):
        """The Path where the component `ref` with this instance name is bound, None where it is bound nowhere."""
        return self._beside(instance, ref) or self._anywhere(ref)

    def _beside(self, instance, ref):
        path = self.beside.child(Name(instance, "rtc"))
        try:
            return path if orb.same(tree.resolve(path).ref, ref) else None
        except errors.Error:
            return None

    def _anywhere(self, ref):
        if self.everywhere is None:
            self.everywhere = [node for node in tree.walk_servers(self._servers(), managers=False)
                               if node.kind == "component" and node.ref is not None]
        return next((node.path for node in self.everywhere if orb.same(node.ref, ref)), None)

    def _servers(self):
        """The name servers to look into: that of the known component, and all others; what is no address is left out."""
        found = []
        for address in [self.beside.server] + [each for each in tree.servers() if each != self.beside.server]:
            try:
                found.append(tree.resolve(Path(address, (), None, False)))
            except errors.BadPath:
                pass
        return found


# ---- the far ends of connections ------------------------------------------------------------------------------

def far_ends(node, found):
    """Names for the other ends of all connectors of the Ports `found` of one component.

    Returns a function reference → text: the path of the port there. Only the ports at those ends are asked, one call each;
    whose they are is found by comparing their owner with what is bound in the name servers, without asking anyone else.
    An end that does not answer or is bound nowhere is `Unknown (…)`.
    """
    own = {orb.identity(each.ref) for each in found}
    ends = {}
    for connector in (c for each in found for c in each.connectors):
        for ref in connector.ports:
            if ref is not None and orb.identity(ref) not in own:
                ends.setdefault(orb.identity(ref), ref)
    answers, places = orb.each(ends.values(), lambda ref: ports.port(node, ref)), Places(node)
    names = dict(zip(ends, [_place(answer, places) for answer in answers]))
    return lambda ref: names.get(orb.identity(ref)) if ref is not None else "Unknown (nil)"


def _place(found, places):
    """The path of a Port, or what is known where there is none."""
    if isinstance(found, errors.Error):
        return f"Unknown ({found})"
    if found.owner is None:
        return printable(found.name)
    path = places.path(found.name.rpartition(".")[0], found.owner)
    if path is None:
        return f"Unknown ({printable(found.name)})"
    return str(path.with_port(ports.short_name(found.name, path.names[-1].id)))
