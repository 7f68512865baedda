"""Single changes to a running system: each knows the command that does it, whether it is so already, how to do and undo it."""
import time

from rtshell_lite import compare, component, configuration, errors, execution, manager, orb, organisation, ports, rpc, system, tree
from rtshell_lite.text import printable, shell_word

MISSING = (errors.NotFound, errors.Gone, errors.ConnectionRefused)


def is_gone(failure):
    """True for an errors.Error that tells that a component is not there, or not any more."""
    return isinstance(failure, MISSING) and not isinstance(failure, errors.NoNameServer)


class Site:
    """A component of a profile and where it is, or is to be: `path`.

    found  its system.Found; None while it is not there
    node   its Node; None while it is not there
    error  why nothing can be done with it; None if something can
    """

    def __init__(self, each, path, instance):
        self.each, self.path, self.instance = each, path, instance
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
        """An rpc.Job that asks the component for its port called `name`. Raises NoSuch."""
        where = str(self.path.with_port(name))
        if self.found is None:
            return rpc.Job(self.node.endpoint, where, lambda: self.named(ports.ports(self.node), name))
        known = self.named(self.found.ports, name)
        return rpc.Job(orb.endpoint(known.ref), where, lambda: ports.port(self.node, known.ref))


class Step:
    """One change. `sites` are the Sites that it concerns: steps that share one are done in their order.

    title     what is done, for people
    where     the object, for errors
    command   the command that does the same, ready for a shell
    endpoint  the process that `act` asks
    """

    kind = command = ""
    tolerant = False  # True if it makes sense though a component is dead

    def __init__(self, sites, where, title):
        self.sites, self.where, self.title = list(sites), where, title
        self.required = all(site.required for site in self.sites)

    @property
    def endpoint(self):
        return self.sites[0].node.endpoint

    def jobs(self):
        """What has to be asked to know whether it is so: pairs of a Site and an rpc.Job."""
        return []

    def so(self, answers):
        """Whether it is so, told by the answers to `jobs`. Raises an errors.Error if it cannot be told or done."""
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
        Step.__init__(self, [site], site.where, "component " + site.where)


# ---- making components ------------------------------------------------------------------------------------------

class Create(Step):
    """Let the manager `holder` (restore.Holder) create the component that it knows as `identity`, with the wanted name."""

    kind = "create"

    def __init__(self, site, holder, identity):
        Step.__init__(self, [site, holder], site.where, "component %s, created by %s" % (site.where, holder.where))
        self.required = site.required
        self.site, self.holder = site, holder
        self.argument = "%s?instance_name=%s" % (identity, site.instance)
        self.command = "rtmgr -c %s --wait %s" % (shell_word(self.argument), shell_word(holder.where))
        if any(c in site.instance + identity for c in "?&="):
            raise errors.No(self.where, "a manager cannot create a component of this name or id")

    @property
    def endpoint(self):
        return self.holder.node.endpoint

    def jobs(self):
        return [(self.holder, rpc.Job(self.holder.node.endpoint, self.where, self._there))]

    def _there(self):
        try:
            node = tree.component(self.site.path)
            orb.ask(self.where, node.ref, "_non_existent")
        except MISSING:
            return None
        return node

    def so(self, answers):
        self.site.node = given(answers)[0]
        return self.site.node is not None

    def act(self, answers):
        name = manager.create(self.holder.node, self.argument, wait=manager.SETTLE_TIME)
        if name != self.site.instance:
            manager.delete(self.holder.node, name)
            raise errors.Refused(self.where, "its manager made %s instead; deleted again" % printable(name))
        limit = time.monotonic() + manager.SETTLE_TIME
        while self._there() is None:
            if time.monotonic() > limit:
                manager.delete(self.holder.node, name)
                raise errors.Refused(self.where, "%s made it, but it is not bound here; deleted again" % self.holder.where)
            time.sleep(component.POLL)

    def undo(self, before, after):
        manager.delete(self.holder.node, self.site.instance)

    def give_up(self, error):
        self.site.error = error


class Members(Step):
    """Make components members of a composite."""

    kind = "members"

    def __init__(self, site, members):
        names = ", ".join(printable(each.instance) for each in members)
        Step.__init__(self, [site] + members, site.where, "members %s of %s" % (names, site.where))
        self.site, self.members = site, members
        there = [ref for _, ref in site.found.members] if site.found else []
        new = [one for one in members if one.node is None or not any(orb.same(ref, one.node.ref) for ref in there)]
        words = ["rtcomp"] + [word for one in new for word in ("-a", one.where)] + [site.where]
        self.command = " ".join(map(shell_word, words))

    def jobs(self):
        return [(self.site, rpc.Job(self.endpoint, self.where, lambda: organisation.the_one(self.site.node)))]

    def so(self, answers):
        return not self._lacking(answers)

    def _lacking(self, answers):
        one, = given(answers)
        return [each for each in self.members if not any(orb.same(ref, each.node.ref) for _, ref in one.members)]

    def act(self, answers):
        wanted = [organisation.Member(each.instance, each.node, []) for each in self._lacking(answers)]
        organisation.check(self.site.node, answers[0], wanted, [])
        organisation.add(self.site.node, answers[0], wanted)

    def undo(self, before, after):
        gone = [organisation.Member(each.instance, each.node, []) for each in self._lacking(before)]
        organisation.remove(self.site.node, after[0], gone)


# ---- configuration ----------------------------------------------------------------------------------------------

class Values(Step):
    """Give the parameters of one configuration set their values, a dict."""

    kind = "configuration"

    def __init__(self, site, set_id, values):
        Step.__init__(self, [site], site.where, "configuration set %s of %s" % (printable(set_id), site.where))
        self.site, self.set_id, self.values = site, set_id, values
        self.kept = None  # the set that was active before, which it has to be again
        self.command = configuration.command(site.where, set_id, "set", *["%s=%s" % item for item in values.items()])

    def jobs(self):
        return [(self.site, rpc.Job(self.endpoint, self.where, lambda: configuration.Configuration(self.site.node)))]

    def _now(self, answers):
        found, = given(answers)
        within = found.set(self.set_id, with_hidden=True)
        found.check(self.values, within)
        return found, within

    def so(self, answers):
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
        Step.__init__(self, [site], site.where, "active configuration set %s of %s" % (printable(set_id), site.where))
        self.site, self.set_id = site, set_id
        self.command = configuration.command(site.where, set_id, "act")

    jobs = Values.jobs

    def so(self, answers):
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
        Step.__init__(self, [site], site.where, "rate of execution context %d of %s" % (handle, site.where))
        self.site, self.index, self.handle, self.rate = site, index, handle, rate
        words = ["rtec"] + ["-e", str(index)] * bool(index) + [site.where, "rate", "%r" % rate]
        self.command = " ".join(map(shell_word, words))

    def jobs(self):
        return [(self.site, rpc.Job(self.endpoint, self.where, self._contexts))]

    def _contexts(self):
        owned, _ = component.context_refs(self.site.node)
        return [component.context(self.site.node, ref) for ref in owned]

    def so(self, answers):
        _, context = self._number(given(answers)[0])
        return execution.same_rate(context.rate, self.rate)

    def _number(self, contexts):
        for index, context in enumerate(contexts):
            if context.handle == self.handle:
                return index, context
        raise errors.NoSuch(self.where, "execution context", "%d" % self.handle)

    def act(self, answers):
        execution.set_rate(self.site.node, self._number(answers[0])[0], self.rate)

    def undo(self, before, after):
        index, context = self._number(before[0])
        execution.set_rate(self.site.node, index, context.rate)


# ---- connections ------------------------------------------------------------------------------------------------

class Connection(Step):
    """What connecting and disconnecting share: a connector of the profile, and its `ends` as (Site, port name)."""

    def __init__(self, connector, ends):
        names = [str(site.path.with_port(name)) for site, name in ends]
        sites = []
        for site, _ in ends:
            if site not in sites:
                sites.append(site)
        label = printable(connector.connector_id) or "without id"
        Step.__init__(self, sites, " to ".join(names), "connection %s of %s" % (label, " to ".join(names)))
        self.connector, self.ends = connector, ends

    def jobs(self):
        return [(site, site.look_at(name)) for site, name in self.ends]

    def _ours(self, port, at):
        """The ports.Connector of a Port that the profile means; `at` are all the Ports that it is to join."""
        return compare.having(port, self.connector, at)


class Connect(Connection):
    """Make a connection with the id, name and properties that the profile gives it; `ids` are those of all in the profile."""

    kind = "connect"

    def __init__(self, connector, ends, ids):
        Connection.__init__(self, connector, ends)
        self.ids, self.given = ids, wanted_properties(connector)
        words = ["rtcon"] + ["-n", connector.name] * bool(connector.name)
        words += ["-i", connector.connector_id] * bool(connector.connector_id)
        for item in sorted(self.given.items()):
            words += ["-p", "%s=%s" % item]
        self.command = " ".join(map(shell_word, words + [str(site.path.with_port(name)) for site, name in ends]))

    @property
    def endpoint(self):
        site, name = self.ends[0]
        return site.look_at(name).endpoint

    def so(self, answers):
        at = given(answers)
        if self.leftovers(at):
            raise errors.Refused(self.where, "connection %s is there, but not complete" % printable(self.connector.connector_id))
        have = self._ours(at[0], at)
        if have is None:
            ports.check(at, self.given)
            for other in ports.joining(at) if len(at) > 1 else []:
                if other.id not in self.ids and len(other.ports) == len(at):
                    raise errors.Refused(self.where, "already connected with another id (%s); rtdis removes that" % printable(other.id))
            return False
        for key, wanted, actual in compare.wrong_properties(self.connector, have):
            raise errors.Refused(self.where, "is connected with %s=%s, not %s; rtdis removes that" % (
                printable(key), printable(actual or ""), printable(wanted)))
        return True

    def leftovers(self, at):
        """(Port, Connector) of each end that has the connection; none if it is complete or nowhere."""
        have = [(port, self._ours(port, at)) for port in at]
        wanted = {orb.identity(port.ref) for port in at}
        if all(one is not None and {orb.identity(ref) for ref in one.ports if ref is not None} == wanted for _, one in have):
            return []
        return [(port, one) for port, one in have if one is not None]

    def act(self, answers):
        ports.connect(answers, self.connector.name, self.connector.connector_id, self.given)

    def tidy(self, answers):
        there = [answer for answer in answers if not isinstance(answer, errors.Error)]
        for port in there:
            one = compare.having(port, self.connector, there)
            if one is not None:
                rpc.ask(orb.endpoint(port.ref), ports.label(port), lambda: ports.disconnect(port, one))

    def undo(self, before, after):
        self.tidy(after)


def wanted_properties(connector):
    """The properties to connect with: those that the profile gives, without references to where ports once were."""
    found = {}
    for name in compare.TYPES:
        value = getattr(connector, name, "")
        if value and (name != "data_type" or value.startswith("IDL:")):  # a short name: the ports know the long one
            found["dataport." + name] = value
    found.update((item.name, item.value or "") for item in connector.properties
                 if item.name and not system.is_reference(item.name, item.value))
    return found


class Disconnect(Connection):
    """Remove a connection from all of its ends that live."""

    kind = "disconnect"
    tolerant = True

    @property
    def endpoint(self):
        return self._looked_at()[0][1].endpoint

    def _looked_at(self):
        return [(site, site.look_at(name)) for site, name in self.ends if site.error is None]

    jobs = _looked_at

    @property
    def command(self):
        return "; ".join("rtdis -i %s %s" % (shell_word(one.id), shell_word(ports.label(port))) for port, one in self.last[:1])

    def so(self, answers):
        there = [answer for answer in answers if not isinstance(answer, errors.Error)]
        self.last = [(port, one) for port, one in ((port, self._ours(port, there)) for port in there) if one is not None]
        failed = [e for e in answers + [site.error for site in self.sites] if isinstance(e, errors.Error)]
        for e in failed:
            if not self.last and not is_gone(e):
                raise e
        return not self.last

    def act(self, answers):
        failures = []
        for port, one in self.last:
            try:
                rpc.ask(orb.endpoint(port.ref), ports.label(port), lambda: ports.disconnect(port, one))
            except errors.Error as e:
                failures.append(e)
        if failures:
            raise failures[0]

    def undo(self, before, after):
        there = given([answer for answer in after if not isinstance(answer, errors.Error)])
        then = next(one for port in before if not isinstance(port, errors.Error)
                    for one in [compare.having(port, self.connector, there)] if one is not None)
        properties = {name: value for name, value in then.properties if not system.is_reference(name, value)}
        ports.connect(there, then.name, then.id, properties)
