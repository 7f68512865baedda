"""Single changes to a running system: each knows the command that does it, whether it is done already, how to do and undo it."""
from rtshell_lite import errors
from rtshell_lite.corba import lanes, orb
from rtshell_lite.robot import component, composites, configuration, contexts, manager, ports, tree
from rtshell_lite.text import printable, shell_word

MISSING = (errors.NotFound, errors.Gone, errors.ConnectionRefused)


def is_gone(failure):
    """True for an errors.Error that says that a component is not there, or not any more."""
    return isinstance(failure, MISSING) and not isinstance(failure, errors.NoNameServer)


class Site:
    """A component of a profile and where it is, or is to be: `path`.

    found  its capture.Found; None while it is not there
    node   its Node; None while it is not there
    error  why nothing can be done with it; None if something can
    """

    def __init__(self, each, path):
        self.each, self.path, self.instance = each, path, each.instance_name
        self.where, self.required = str(path), each.is_required
        self.found = self.node = self.error = None

    def named(self, found, name):
        """That one of the Ports `found` of the component which a profile calls `name`. Raises NoSuch."""
        known = [name, self.instance + "." + name]
        port = next((port for port in found if port.name in known), None) or ports.named(self.path.with_port(name), found)
        if isinstance(port, errors.Error):
            raise port
        return port

    def look_at(self, name):
        """A lanes.Job that asks the component for its port called `name`. Raises NoSuch."""
        where = str(self.path.with_port(name))
        if self.found is None:
            return lanes.Job(self.node.endpoint, where, lambda: self.named(ports.ports(self.node), name))
        known = self.named(self.found.ports, name)
        return lanes.Job(orb.endpoint(known.ref), where, lambda: ports.port(self.node, known.ref))


class Step:
    """One change. `sites` are the Sites that it concerns: steps that share one are done in their order.

    title     what is done, for people
    where     the object, for errors
    command   the command that does the same, ready for a shell
    endpoint  the process that `act` asks
    """

    kind = command = ""
    tolerant = False  # True if it makes sense though a component is dead
    free = False  # True if others of the kind may come before or after it

    def __init__(self, sites, where, title):
        self.sites, self.where, self.title = list(sites), where, title
        self.required = all(site.required for site in self.sites)

    @property
    def endpoint(self):
        return self.sites[0].node.endpoint

    def jobs(self):
        """What has to be asked to know whether it is done: pairs of a Site and a lanes.Job."""
        return []

    def is_done(self, answers):
        """Whether the system is in the wanted state, by the answers to `jobs`. Raises an errors.Error if that is not known."""
        return True

    def act(self, answers):
        """Do it; `answers` are those that said that it is not so."""

    def tidy(self, answers):
        """After `act` has failed: remove what it has left behind."""

    def undo(self, before, after):
        """Undo it; the answers before and after it was done."""

    def give_up(self, error):
        """Note for the steps that follow that it could not be done."""


def given(answers):
    """The answers; raises the first error among them."""
    for answer in answers:
        if isinstance(answer, errors.Error):
            raise answer
    return answers


class Present(Step):
    """That a component is there: a check and no change."""

    kind = "component"

    def __init__(self, site):
        super().__init__([site], site.where, "component " + site.where)


# ---- making components ------------------------------------------------------------------------------------------

class Create(Step):
    """Let the manager `holder` (restore.Holder) create the component that it knows as `identity`, with the wanted name."""

    kind = "create"

    def __init__(self, site, holder, identity):
        super().__init__([site, holder], site.where, f"component {site.where}, created by {holder.where}")
        self.required = site.required
        self.site, self.holder = site, holder
        self.argument = f"{identity}?instance_name={site.instance}"
        self.command = f"rtmgr -c {shell_word(self.argument)} --wait {shell_word(holder.where)}"
        if any(c in site.instance + identity for c in "?&="):
            raise errors.Failed(self.where, "a manager cannot create a component of this name or id")

    @property
    def endpoint(self):
        return self.holder.node.endpoint

    def jobs(self):
        return [(self.holder, lanes.Job(self.holder.node.endpoint, self.where, self._there))]

    def _there(self):
        try:
            node = tree.component(self.site.path)
            orb.ask(self.where, node.ref, "_non_existent")
        except MISSING:
            return None
        return node

    def is_done(self, answers):
        self.site.node = given(answers)[0]
        return self.site.node is not None

    def act(self, answers):
        name = manager.create(self.holder.node, self.argument, wait=manager.SETTLE_TIME)
        if name != self.site.instance:
            manager.delete(self.holder.node, name)
            raise errors.Refused(self.where, f"its manager made {printable(name)} instead; deleted again")
        if not component.until(lambda: self._there() is not None, manager.SETTLE_TIME):
            manager.delete(self.holder.node, name)
            raise errors.Refused(self.where, f"{self.holder.where} made it, but it is not bound here; deleted again")

    def undo(self, before, after):
        manager.delete(self.holder.node, self.site.instance)

    def give_up(self, error):
        self.site.error = error


class Members(Step):
    """Make components members of a composite."""

    kind = "members"

    def __init__(self, site, members):
        names = ", ".join(printable(each.instance) for each in members)
        super().__init__([site] + members, site.where, f"members {names} of {site.where}")
        self.site, self.members = site, members
        there = [ref for _, ref in site.found.members] if site.found else []
        new = [one for one in members if one.node is None or not any(orb.same(ref, one.node.ref) for ref in there)]
        words = ["rtcomp"] + [word for one in new for word in ("-a", one.where)] + [site.where]
        self.command = " ".join(map(shell_word, words))

    def jobs(self):
        return [(self.site, lanes.Job(self.endpoint, self.where, lambda: composites.the_one(self.site.node)))]

    def is_done(self, answers):
        return not self._lacking(answers)

    def _lacking(self, answers):
        one, = given(answers)
        return [each for each in self.members if not any(orb.same(ref, each.node.ref) for _, ref in one.members)]

    def act(self, answers):
        wanted = [composites.Member(each.instance, each.node, []) for each in self._lacking(answers)]
        composites.check(self.site.node, answers[0], wanted, [])
        composites.add(self.site.node, answers[0], wanted)

    def undo(self, before, after):
        gone = [composites.Member(each.instance, each.node, []) for each in self._lacking(before)]
        composites.remove(self.site.node, after[0], gone)


# ---- configuration ----------------------------------------------------------------------------------------------

class Values(Step):
    """Give the parameters of one configuration set their values, a dict."""

    kind = "configuration"

    def __init__(self, site, set_id, values):
        super().__init__([site], site.where, f"configuration set {printable(set_id)} of {site.where}")
        self.site, self.set_id, self.values = site, set_id, values
        self.kept = None  # the set that was active before, which it has to be again
        self.command = configuration.command(site.where, set_id, "set", *["%s=%s" % item for item in values.items()])

    def jobs(self):
        return [(self.site, lanes.Job(self.endpoint, self.where, lambda: configuration.Configuration(self.site.node)))]

    def _now(self, answers):
        found, = given(answers)
        within = found.set(self.set_id, with_hidden=True)
        found.check(self.values, within)
        return found, within

    def is_done(self, answers):
        found, within = self._now(answers)
        return all(within.values[name] == value for name, value in self.values.items()) and (
            self.kept is None or found.active == self.kept)

    def act(self, answers):
        found, within = self._now(answers)
        self.kept = None if self.site.each.active_configuration_set else found.active  # else the next step sees to it
        found.store(self.values, within)

    def undo(self, before, after):
        _, then = self._now(before)
        found, now = self._now(after)
        found.store({name: then.values[name] for name in self.values}, now)


class Active(Step):
    """Make a configuration set the active one."""

    kind = "active set"

    def __init__(self, site, set_id):
        super().__init__([site], site.where, f"active configuration set {printable(set_id)} of {site.where}")
        self.site, self.set_id = site, set_id
        self.command = configuration.command(site.where, set_id, "act")

    jobs = Values.jobs

    def is_done(self, answers):
        found, = given(answers)
        if self.set_id == "default" and not found.sets():
            return True  # components without configuration have no set at all, and files name this one nevertheless
        found.check_active(self.set_id)
        return found.active == self.set_id

    def act(self, answers):
        answers[0].activate(self.set_id)

    def undo(self, before, after):
        if not before[0].active:
            raise errors.Refused(self.where, "had no active configuration set before, and cannot get rid of one")
        after[0].activate(before[0].active)


class Rate(Step):
    """Set the rate (Hz) of the execution context with a handle: number `index` of those that the component owns."""

    kind = "rate"

    def __init__(self, site, index, handle, rate):
        super().__init__([site], site.where, "rate of execution context %d of %s" % (handle, site.where))
        self.site, self.index, self.handle, self.rate = site, index, handle, rate
        words = ["rtec"] + ["-e", str(index)] * bool(index) + [site.where, "rate", f"{rate!r}"]
        self.command = " ".join(map(shell_word, words))

    def jobs(self):
        return [(self.site, lanes.Job(self.endpoint, self.where, self._contexts))]

    def _contexts(self):
        owned, _ = component.context_refs(self.site.node)
        return [component.context(self.site.node, ref) for ref in owned]

    def is_done(self, answers):
        _, context = self._number(given(answers)[0])
        return contexts.same_rate(context.rate, self.rate)

    def _number(self, found):
        for index, context in enumerate(found):
            if context.handle == self.handle:
                return index, context
        raise errors.NoSuch(self.where, "execution context", "%d" % self.handle)

    def act(self, answers):
        contexts.set_rate(self.site.node, self._number(answers[0])[0], self.rate)

    def undo(self, before, after):
        index, context = self._number(before[0])
        contexts.set_rate(self.site.node, index, context.rate)
