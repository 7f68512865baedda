"""Where in the RTC Tree a reference is bound: told by comparing references, without asking their objects."""
from rtshell_lite import errors, orb, tree
from rtshell_lite.path import ROOT, Name, Path


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
            tops = [tree.resolve(Path(self.beside.server, (), None, False)), tree.resolve(ROOT)]
            self.everywhere = [node for top in tops for node in tree.walk(top, managers=False)
                               if node.kind == "component" and node.ref is not None]
        return next((node.path for node in self.everywhere if orb.same(node.ref, ref)), None)
