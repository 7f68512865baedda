"""A manager: the CORBA object that creates and deletes components in its process or, as a master, in others.
"""
import itertools

from . import carrier, children, composite, modules
from .creation import Wanted, extract
from .idl import RTC, RTM
from .properties import get, nvlist

KEY = "manager"             # its object key, whatever its name
SHUTDOWN_TIME = 0.5         # seconds from the answer to shutdown() to the end of the process


class Manager(carrier.skeleton("RTM.Manager")):
    """Lives in the process of a stage, whose components are its own."""

    def __init__(self, stage, name="manager", master=True):
        self.stage = stage
        self.flavour = stage.flavour
        self.name = name
        self.master = master
        self.modules = modules.Modules(self.flavour)
        self.names_kept = {}            # implementation id -> instance name that the factory has kept
        self.masters = []
        self.slaves = []
        self.changed = {}               # configuration that did take
        self.reference = stage.process.serve_key(self, KEY, name)._narrow(RTM.Manager)
        stage.manager = self
        if master:
            stage.names.bind(stage.home() + [(name, "mgr")], self.reference)

    # modules

    def load_module(self, path, function):
        """RTC_OK, whatever happens."""
        self.modules.load(path, function)
        return RTC.RTC_OK

    def unload_module(self, path):
        if path not in self.modules.loaded:
            raise carrier.failure("UNKNOWN", self.flavour.exception_minor)
        self.modules.unload(path)
        if any(self.modules.lacks_code(component.spec) for component in list(self.stage.components.values())):
            self.stage.process.later(0.1, self.stage.process.die)
        return RTC.RTC_OK

    def get_loadable_modules(self):
        return modules.profiles(self.modules.loadable_profiles())

    def get_loaded_modules(self):
        return modules.profiles(self.modules.loaded_profiles()) + self._modules_of_slaves(
            "get_loaded_modules"
        )

    def get_factory_profiles(self):
        return modules.profiles(self.modules.factory_profiles()) + self._modules_of_slaves(
            "get_factory_profiles"
        )

    def _modules_of_slaves(self, operation):
        return self._of_slaves(operation) if self.flavour.tells_slaves else []

    # components

    def create_component(self, line):
        if self.master and not self.flavour.creates_here:
            return self._create_in_slave(line)
        address, line = extract(line, "manager") if self.flavour.creates_here else (None, line)
        if address:
            return self._create_at(address, line)
        component = self.create(line)
        return component and component.reference

    def create(self, line):
        """Make a component here; returns it, or the existing one of that name, or None."""
        wanted = Wanted(line, self.flavour.ident_fields)
        spec = self.modules.factory(wanted.implementation_id) if wanted.valid else None
        if spec is None or not wanted.matches(dict(modules.factory(spec, self.flavour))):
            return None
        if wanted.arguments.get("language", self.flavour.language) != self.flavour.language:
            return None
        if self.modules.lacks_code(spec):
            self.stage.process.die()
        name = self._instance_name(spec, wanted.arguments)
        if self.flavour.twins == "same" and name in self.stage.components:
            return (
                self.stage.components[name]
                if "instance_name" in wanted.arguments
                else self.stage.stray(spec, name)
            )
        if not spec.play.initialises:
            return None
        alike = [one for one in list(self.stage.components.values()) if one.spec is spec]
        if spec.max_instance and len(alike) >= spec.max_instance:
            return None
        return self.stage.add(spec, name, **options(wanted.arguments))

    def _instance_name(self, spec, arguments):
        """The name that is given, now or (in Python) earlier to the same factory; else the type with the
        first free number.
        """
        name = self.stage.misname or arguments.get("instance_name")
        if self.flavour.sticky_name:
            name = name or self.names_kept.get(spec.implementation_id)
            self.names_kept[spec.implementation_id] = name
        if name:
            return name
        return next(
            name
            for name in map((spec.type_name + "%d").__mod__, itertools.count())
            if name not in self.stage.listed
        )

    def _create_in_slave(self, line):
        """Create it in the first slave of that name that can; start a slave if there is none."""
        name, line = extract(line, "manager_name")
        address, line = extract(line, "manager_address")
        slaves = self._live_slaves(name)
        if address:
            if any(self.stage.process.address(slave) == address for slave in slaves):
                return None
            slaves = []
        for slave in slaves or self._started(name, address):
            component = slave.create_component(line)
            if component is not None:
                return component
        # a new process is to have it, which stays
        if slaves and self._is_tried_elsewhere(line.partition("?")[0]):
            for slave in self._started(name, address):
                return slave.create_component(line)
        return None

    def _is_tried_elsewhere(self, ident):
        """Whether C++ 2.x has no factory, and tries in a new process: for an unknown name, and for an id that
        lacks a language.
        """
        fields = ident.split(":")
        if len(fields) not in (1, 5) or self.flavour.language != "C++" or not self.flavour.modern:
            return False
        if len(fields) == 1:
            profiles = self._of_slaves("get_factory_profiles") + self._of_slaves("get_loadable_modules")
            names = [get(each.properties, "implementation_id") for each in profiles]
            return bool(ident) and ident not in names
        spec = self.modules.factory(fields[3])
        return spec is None or dict(modules.factory(spec, self.flavour))["version"] == fields[-1]

    def _started(self, name, address):
        if not self.flavour.starts_slaves:
            return []
        before = list(self.slaves)
        name = "manager" if not name or name == "manager_%p" else name
        children.start(
            self.stage, ["slave", self.stage.process.endpoint, name], (address or "").partition(":")[2]
        )
        return [slave for slave in self.slaves if not _among(slave, before)]

    def _create_at(self, address, line):
        """Create it in the manager at HOST:PORT."""
        try:
            return children.manager_at(self.stage.process, address).create_component(line)
        except carrier.SystemException:
            return None

    def delete_component(self, instance_name):
        component = self.stage.listed.get(instance_name)
        if self.stage.gone(component):
            return getattr(RTC, self.flavour.delete_unknown)
        return component.exit()

    def get_components(self):
        return [component.reference for component in list(self.stage.listed.values())] + self._of_slaves(
            "get_components"
        )

    def get_component_profiles(self):
        own = [component.get_component_profile() for component in list(self.stage.listed.values())]
        return own + self._of_slaves("get_component_profiles")

    def get_components_by_name(self, pattern):
        """NAME, */NAME or CATEGORY/NAME; of a master, its own only."""
        if not self.flavour.by_name:
            raise carrier.failure("BAD_OPERATION", may_be_done=False)
        category, _, name = pattern.rpartition("/")
        return [component.reference for component in list(self.stage.listed.values())
                if component.instance_name == name and category in ("", "*", component.spec.category)]

    # what it is

    def _configuration(self):
        stage = self.stage
        pairs = modules.configuration(
            self.flavour, self.modules, self.name, stage.options.context, stage.process.endpoint, self.master
        )
        known = dict(pairs)
        return ([(name, self.changed.get(name, value)) for name, value in pairs] +
                [pair for pair in self.changed.items() if pair[0] not in known])

    def get_profile(self):
        prefix = "manager."
        return RTM.ManagerProfile(nvlist([(name[len(prefix):], value) for name, value in self._configuration()
                                          if name.startswith(prefix)]))

    def get_configuration(self):
        return nvlist(self._configuration())

    def set_configuration(self, name, value):
        """RTC_OK; new names are added, existing ones keep their values, which are read at the start, except
        the logger's.
        """
        if name.startswith("logger.") or name not in dict(self._configuration()):
            self.changed[name] = value
        return RTC.RTC_OK

    def is_master(self):
        return self.master

    # other managers

    def get_master_managers(self):
        return list(self.masters)

    def get_slave_managers(self):
        return list(self.slaves)

    def add_master_manager(self, manager):
        return _add(self.masters, manager)

    def remove_master_manager(self, manager):
        return _remove(self.masters, manager)

    def add_slave_manager(self, manager):
        return _add(self.slaves, manager)

    def remove_slave_manager(self, manager):
        return _remove(self.slaves, manager)

    def join(self, master):
        """Become a slave of another manager."""
        master.add_slave_manager(self.reference)
        self.add_master_manager(master)

    def leave(self):
        """Sign off at the other managers; the slaves of a master live on."""
        for others, tell in ((self.masters, "remove_slave_manager"), (self.slaves, "remove_master_manager")):
            for other in list(others):
                carrier.set_timeout(other, 1000)
                try:
                    getattr(other, tell)(self.reference)
                except carrier.SystemException:
                    pass

    def _of_slaves(self, operation):
        """The answers of all slaves in one list; those that do not exist any more are forgotten only now."""
        answers = []
        for slave in list(self.slaves):
            try:
                answers += getattr(slave, operation)()
            except carrier.SystemException:
                _remove(self.slaves, slave)
        return answers

    def _live_slaves(self, name):
        """The slaves that answer and, if a name is given, have it."""
        found = []
        for slave in list(self.slaves):
            try:
                if name in (None, get(slave.get_profile().properties, "instance_name")):
                    found.append(slave)
            except carrier.SystemException:
                _remove(self.slaves, slave)
        return found

    # the process

    def fork(self):
        return RTC.RTC_OK

    def restart(self):
        return RTC.RTC_OK

    def shutdown(self):
        self.stage.children = []        # they live on
        if self.flavour.dead_member == "process" and self.flavour.modern and self._has_composite():
            return self.stage.process.die()  # its members are gone first: CORBA::BAD_PARAM
        self.stage.process.later(SHUTDOWN_TIME, self.stage.finish.set)
        return RTC.RTC_OK

    def _has_composite(self):
        listed = list(self.stage.listed.values())
        return any(isinstance(each, composite.Composite) and not self.stage.gone(each) for each in listed)

    def get_service(self, name):
        return None


def options(arguments):
    """The changes that arguments of create_component make to the options of a component."""
    changes = {"arguments": arguments}
    if "naming.formats" in arguments:
        changes["context"] = arguments["naming.formats"]
    if "exec_cxt.periodic.rate" in arguments:
        changes["rate"] = float(arguments["exec_cxt.periodic.rate"])
    if "execution_contexts" in arguments:
        changes["contexts"] = len(arguments["execution_contexts"].split(","))
    return changes


def _among(manager, managers):
    return any(manager._is_equivalent(other) for other in managers)


def _add(managers, manager):
    if manager is None or _among(manager, managers):
        return RTC.BAD_PARAMETER
    managers.append(manager)
    return RTC.RTC_OK


def _remove(managers, manager):
    for index, other in enumerate(managers):
        if manager is not None and other._is_equivalent(manager):
            del managers[index]
            return RTC.RTC_OK
    return RTC.BAD_PARAMETER
