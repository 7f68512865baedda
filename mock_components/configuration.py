"""The configuration of a component: its sets of parameters, one of them active."""
from . import carrier
from .idl import SDOPackage
from .properties import is_text, nvlist


def error(name, description):
    """An SDO exception or, if the name is not one of theirs, a system exception."""
    if hasattr(SDOPackage, name):
        return getattr(SDOPackage, name)(description)
    return carrier.failure(name, may_be_done=False)


def of_a_set(key):
    """Whether a property of a component is the value of a parameter: conf.SET.PARAMETER."""
    return key.startswith("conf.") and key.count(".") > 1


class Configuration(carrier.skeleton("SDOPackage.Configuration")):
    """Sets are kept in order of registration; a set whose id starts with `_` is data about the others."""

    def __init__(self, component, sets, active):
        self.component = component
        self.flavour = component.flavour
        self.sets = {"default": {}}
        for name, values in sets.items():
            self.sets[name] = dict(values)
        self.active = active
        self.last_active = active
        self.applied = dict(self.sets[active])     # the values that the component works with
        self.added = set()
        self.organizations = []

    def preset(self, arguments):
        """Take over the `conf.SET.NAME` among the arguments that a component is created with."""
        for key, value in arguments.items():
            if of_a_set(key):
                _, name, parameter = key.split(".", 2)
                self.sets.setdefault(name, {})[parameter] = value

    def profile(self):
        """The `conf.…` properties of the component's profile."""
        pairs = []
        for name, values in self.sets.items():
            pairs += [(f"conf.{name}.{key}", value) for key, value in values.items()]
            if not values and name == "default":
                pairs.append(("conf.default", ""))
        return pairs

    def _as_set(self, name):
        return SDOPackage.ConfigurationSet(name, "", nvlist(self.sets[name].items()))

    def _changed(self):
        """No set is active until one is activated again."""
        if not self.flavour.keeps_active:
            self.active = None

    def _where(self, operation):
        return f"Configuration{self.flavour.scope}{operation}()"

    # reading

    def get_configuration_sets(self):
        return [self._as_set(name) for name in self.sets]

    def get_configuration_set(self, config_id):
        if config_id == "" and self.flavour.empty_set_id != "InternalError":
            raise error(self.flavour.empty_set_id, "")
        if config_id not in self.sets:
            raise error("InternalError", self.flavour.no_set)
        return self._as_set(config_id)

    def get_active_configuration_set(self):
        if self.active is None:
            cpp = self.flavour.scope == "::"
            raise error(
                "NotAvailable", "" if cpp else "NotAvailable: " + self._where("get_active_configuration_set")
            )
        return self._as_set(self.active)

    def get_configuration_parameters(self):
        return []

    def get_configuration_parameter_values(self):
        return []

    def get_configuration_parameter_value(self, name):
        if name == "":
            raise error("InvalidParameter", "Name is empty.")
        if self.flavour.parameter_value == "null":
            return carrier.Any(carrier.NULL, None)
        raise carrier.failure("BAD_PARAM")

    # changing

    def set_configuration_parameter(self, name, value):
        return True

    def set_configuration_set_values(self, config):
        if config.id == "":
            raise error("InvalidParameter", "ID is empty.")
        if config.id not in self.sets and not self.flavour.set_creates:
            return False
        self._merge(self.sets.setdefault(config.id, {}), config.configuration_data)
        self._changed()
        self._report("SET_CONFIG_SET", config.id)
        return True

    def add_configuration_set(self, config):
        if config.id in self.sets:
            return False
        self._merge(self.sets.setdefault(config.id, {}), config.configuration_data)
        self.added.add(config.id)
        self._changed()
        self._report("ADD_CONFIG_SET", config.id)
        return True

    def remove_configuration_set(self, config_id):
        if config_id == "":
            raise error("InvalidParameter", "ID is empty.")
        if config_id == self.active or config_id not in self.added:
            return False
        self.added.remove(config_id)
        del self.sets[config_id]
        self._changed()
        self._report("REMOVE_CONFIG_SET", config_id)
        return True

    def activate_configuration_set(self, config_id):
        if config_id == "":
            raise error("InvalidParameter", "ID is empty.")
        if config_id not in self.sets or config_id.startswith("_"):
            raise error(self.flavour.bad_activate, self._where("activate_configuration_set"))
        self.active = self.last_active = config_id
        self._report("ACTIVATE_CONFIG_SET", config_id)
        self.component.configured(config_id)
        if self.component.active():
            self.update()
        return True

    def update(self):
        """Apply the values of the active set to the component."""
        values = dict(self.sets[self.last_active])
        for name, value in values.items():
            if self.applied.get(name) != value:
                self._report("UPDATE_CONFIG_PARAM", self.last_active + "." + name)
        self.applied = values
        self._report("UPDATE_CONFIG_SET", self.last_active)

    def _report(self, what, name):
        self.component.report("CONFIGURATION", f"{what}: {name}")

    def _merge(self, values, data):
        for item in data:
            if is_text(item.value):
                values[item.name] = item.value.value()
            elif self.flavour.converts_values:
                values[item.name] = str(item.value.value())

    # device and services

    def set_device_profile(self, profile):
        """Accepted without effect."""
        return True

    def add_service_profile(self, profile):
        return self.component.observers.add(profile)

    def remove_service_profile(self, service_id):
        return self.component.observers.remove(service_id)

    # organisations

    def add_organization(self, organization):
        self.organizations.append(organization)
        return True

    def remove_organization(self, organization_id):
        before = len(self.organizations)
        self.organizations = [
            one for one in self.organizations if one.get_organization_id() != organization_id
        ]
        return len(self.organizations) < before
