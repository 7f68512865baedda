"""Names of our components in a name server: bound as components bind theirs, and gone at the end."""

from rtshell_lite import errors, notes
from rtshell_lite.corba import orb
from rtshell_lite.path import Name, Path  # noqa: F401: in a type comment


class Bindings:
    """Names in the name server at `server`, a tree.Node; `bound` {tuple of Names: the reference that it is
    bound to}.
    """

    def __init__(self, server):
        self._server = server
        self.server = server.path
        self.bound = {}
        self._made = []  # names of naming contexts that were made for them

    async def bind(self, names, reference):
        """Bind a tuple of Names. Raises Refused where somebody who lives has it, and what remote
        calls raise.
        """
        where = self._path(names)
        await self._make_contexts(where)
        try:
            await self._call(where, "bind", names, reference)
        except errors.Refused as e:
            if e.name != "AlreadyBound":
                raise
            await self._refuse_living(where)
            await self._call(where, "rebind", names, reference)
        self.bound[names] = reference

    async def _refuse_living(self, where):
        """Raise Refused unless what is bound is known to be gone."""
        bound = await self._call(where, "resolve", where.names)
        try:
            await orb.is_alive(where, bound)
        except (errors.Gone, errors.ProcessGone):
            return
        except errors.Error:
            pass
        raise errors.Refused(
            str(where), "is bound already, to what may live; --as-components PREFIX binds below another name"
        )

    async def _make_contexts(self, where):
        for end in range(1, len(where.names)):
            names = where.names[:end]
            if names in self._made:
                continue
            try:
                await self._call(where, "bind_new_context", names)
                self._made.append(names)
            except errors.Refused as e:
                if e.name != "AlreadyBound":
                    raise

    async def unbind(self, names):
        """Remove a tuple of Names, unless somebody else has it now."""
        reference = self.bound.pop(names)
        where = self._path(names)
        try:
            if orb.same(await self._call(where, "resolve", names), reference):
                await self._call(where, "unbind", names)
        except errors.Refused as e:
            if e.name != "NotFound":
                raise

    async def clear(self):
        """Remove all names, and the contexts that were made for them and are empty; those that are refused
        stay.
        """
        steps = [(self.unbind, names) for names in list(self.bound)]
        steps += [(self._remove_context, names) for names in sorted(self._made, key=len, reverse=True)]
        for remove, names in steps:
            try:
                await remove(names)
            except errors.Unreachable as e:
                notes.fail(e)
                return
            except errors.Error as e:
                notes.fail(e)

    async def _remove_context(self, names):
        where = self._path(names)
        try:
            context = orb.context(await self._call(where, "resolve", names))
            await orb.call(where, context, "destroy")
            await self._call(where, "unbind", names)
        except errors.Refused as e:
            if e.name not in ("NotEmpty", "NotFound"):
                raise

    def _path(self, names):
        return Path(self._server.path.server, names, None, False)

    async def _call(self, where, operation, names, *args):
        return await orb.call(where, orb.context(self._server.ref), operation, orb.naming_name(names), *args)
