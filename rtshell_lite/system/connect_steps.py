"""Steps that make connections and remove them; see steps.py."""
from rtshell_lite import errors
from rtshell_lite.corba import lanes, orb
from rtshell_lite.robot import connectors, ports
from rtshell_lite.system import capture, compare, steps
from rtshell_lite.text import printable, shell_word


class Connection(steps.Step):
    """What connecting and disconnecting share: a connector of the profile, and its `ends` as (Site, port name)."""

    free = True

    def __init__(self, connector, ends):
        names = [str(site.path.with_port(name)) for site, name in ends]
        sites = []
        for site, _ in ends:
            if site not in sites:
                sites.append(site)
        label = printable(connector.connector_id) or "without id"
        super().__init__(sites, " to ".join(names), f"connection {label} of {' to '.join(names)}")
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
        super().__init__(connector, ends)
        self.ids, self.given = ids, wanted_properties(connector)
        paths = [str(site.path.with_port(name)) for site, name in ends]
        self.command = connectors.command(paths, connector.name, connector.connector_id, self.given)

    @property
    def endpoint(self):
        site, name = self.ends[0]
        return site.look_at(name).endpoint

    def is_done(self, answers):
        at = steps.given(answers)
        if self.leftovers(at):
            raise errors.Refused(self.where, f"connection {printable(self.connector.connector_id)} is there, but not complete")
        have = self._ours(at[0], at)
        if have is None:
            ports.check(at, self.given)
            for other in ports.joining(at) if len(at) > 1 else []:
                if other.id not in self.ids and len(other.ports) == len(at):
                    raise errors.Refused(self.where, f"already connected with another id ({printable(other.id)}); rtdis removes that")
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
        connectors.connect(answers, self.connector.name, self.connector.connector_id, self.given)

    def tidy(self, answers):
        there = [answer for answer in answers if not isinstance(answer, errors.Error)]
        for port in there:
            one = compare.having(port, self.connector, there)
            if one is not None:
                lanes.ask(orb.endpoint(port.ref), ports.label(port), lambda: connectors.disconnect(port, one))

    def undo(self, before, after):
        self.tidy(after)


def wanted_properties(connector):
    """The properties to connect with: those that the profile gives, without references to where ports once were."""
    found = {}
    for name in capture.DATA_FIELDS:
        value = getattr(connector, name, "")
        if value and (name != "data_type" or value.startswith("IDL:")):  # a short name: the ports know the long one
            found["dataport." + name] = value
    found.update((item.name, item.value or "") for item in connector.properties
                 if item.name and not capture.is_reference(item.name, item.value))
    return found


class Disconnect(Connection):
    """Remove a connection from all of its ends that live."""

    kind = "disconnect"
    tolerant = True
    command = ""  # once it has been seen that it is there

    @property
    def endpoint(self):
        return self._looked_at()[0][1].endpoint

    def _looked_at(self):
        return [(site, site.look_at(name)) for site, name in self.ends if site.error is None]

    jobs = _looked_at

    def is_done(self, answers):
        there = [answer for answer in answers if not isinstance(answer, errors.Error)]
        self.last = [(port, one) for port, one in ((port, self._ours(port, there)) for port in there) if one is not None]
        for port, one in self.last[:1]:
            self.command = f"rtdis -i {shell_word(one.id)} {shell_word(ports.label(port))}"
        failed = [e for e in answers + [site.error for site in self.sites] if isinstance(e, errors.Error)]
        for e in failed:
            if not self.last and not steps.is_gone(e):
                raise e
        return not self.last

    def act(self, answers):
        failures = []
        for port, one in self.last:
            try:
                lanes.ask(orb.endpoint(port.ref), ports.label(port), lambda: connectors.disconnect(port, one))
            except errors.Error as e:
                failures.append(e)
        if failures:
            raise failures[0]

    def undo(self, before, after):
        there = steps.given([answer for answer in after if not isinstance(answer, errors.Error)])
        then = next(one for port in before if not isinstance(port, errors.Error)
                    for one in [compare.having(port, self.connector, there)] if one is not None)
        properties = {name: value for name, value in then.properties if not capture.is_reference(name, value)}
        connectors.connect(there, then.name, then.id, properties)
