"""Modules: the files that a manager can load, and the component factories in them."""
import re

from . import carrier, components
from .properties import nvlist

ROOTS = {"C++": "/opt/openrtm/components/c++/examples/rtc", "Python": "/opt/openrtm/components/python",
         "Java": "/opt/openrtm/components/java", "C": "/opt/openrtm/components/c"}
SUFFIXES = {"C++": ".so", "Python": ".py", "Java": ".class", "C": ".so"}
# in this order Python finds its examples; C++ goes by the alphabet
PYTHON_DIRECTORIES = {"ConsoleOut": (
    "SimpleIO"
), "ConsoleIn": "SimpleIO", "Sensor": "Composite", "Controller": "Composite",
                      "Motor": "Composite", "SeqIn": "SeqIO", "SeqOut": "SeqIO"}
PRELOADED = ("Motor", "Sensor", "Controller")
COMPOSITE = "PeriodicECSharedComposite"


class Module:
    """A file with one factory, whose initialisation function is called after the file."""

    def __init__(self, spec, flavour):
        self.spec = spec
        self.flavour = flavour
        self.name = spec.implementation_id + SUFFIXES[flavour.language]
        self.directory = ROOTS[flavour.language]
        if flavour.language == "Python":
            self.directory += "/" + PYTHON_DIRECTORIES.get(spec.implementation_id, "Others")
        self.path = self.directory + "/" + self.name
        self.function = spec.implementation_id + "Init"

    def loadable(self):
        """The profile of the file, as found without loading it; Python does not get at the vendor of one
        example.
        """
        pairs = factory(self.spec, self.flavour)
        if self.flavour.language == "Python" and self.spec.implementation_id == "Sensor":
            pairs = [pair for pair in pairs if pair[0] != "vendor"]
        return pairs + [("module_file_name", self.name), ("module_file_path", self.path)]


def factory(spec, flavour):
    """The profile of a factory."""
    pairs = list(spec.identity(flavour).items()) + spec.nature(flavour)
    for name, values in spec.sets(flavour).items():
        pairs += [(f"conf.{name}.{key}", value) for key, value in values.items()]
    return pairs


def available(flavour):
    """All modules that there are, in the order of a directory listing."""
    specs = {
        spec.implementation_id: spec for spec in components.SPECS.values() if spec.type_name != COMPOSITE
    }
    first = list(PYTHON_DIRECTORIES) if flavour.language == "Python" else []
    return [Module(specs[name], flavour) for name in first + sorted(set(specs) - set(first))]


class Modules:
    """The modules of one manager: those that it could load, and those that it has loaded."""

    def __init__(self, flavour):
        self.flavour = flavour
        self.available = available(flavour)
        self.loaded = []                # paths
        self.unloaded = []              # specs
        self.factories = {COMPOSITE: components.SPECS[COMPOSITE]} if COMPOSITE in components.SPECS else {}
        for name in PRELOADED:
            self.load(name + SUFFIXES[flavour.language], name + "Init")

    def find(self, path):
        """The module that a path or, below the load path, a name leads to; None if there is none. Python adds
        .py to a name.
        """
        path = re.sub("/+", "/", path)
        path = path[2:] if path.startswith("./") else path
        if self.flavour.language == "Python" and not path.endswith(".py"):
            path += ".py"
        return next((module for module in self.available if path in (module.path, module.name)), None)

    def load(self, path, function):
        """Load a file, and register its factory if that is the name of its initialisation function."""
        module = self.find(path)
        if module is None:
            return
        if module.path not in self.loaded:
            self.loaded.append(module.path)
        if module.spec in self.unloaded:
            self.unloaded.remove(module.spec)
        if function == module.function or not function and self.flavour.modern:
            self.factories[module.spec.implementation_id] = module.spec

    def unload(self, path):
        """Forget a loaded file; only its exact path will do. Its factory stays."""
        self.loaded.remove(path)
        self.unloaded.append(self.find(path).spec)

    def lacks_code(self, spec):
        """Whether what a factory or component would execute has been unloaded: of C++ that ends the process.
        """
        return self.flavour.language == "C++" and spec in self.unloaded

    def factory(self, implementation_id):
        """The factory of that name, found and loaded on the way if the manager does such things; or None."""
        if implementation_id not in self.factories and self.flavour.search_auto:
            self.load(implementation_id + SUFFIXES[self.flavour.language], implementation_id + "Init")
        return self.factories.get(implementation_id)

    def directories(self):
        return ",".join(dict.fromkeys(module.directory for module in self.available))

    def loadable_profiles(self):
        return [module.loadable() for module in self.available] if self.flavour.search_auto else []

    def loaded_profiles(self):
        return [[("file_path", path)] for path in self.loaded]

    def factory_profiles(self):
        return [factory(spec, self.flavour) for spec in self.factories.values()]


# ---- what a manager says of itself ----

LANGUAGES = ("C++", "Python", "Java")
_PROGRAMS = {"C++": "", "Python": "_python", "Java": "_java"}


def configuration(flavour, modules, name, context, endpoint, master):
    """All properties of a manager, as pairs; those of its profile are the ones that begin with `manager.`."""
    generation = "2" if flavour.modern else ""
    product = "OpenRTM-aist-" + flavour.version
    above = ""
    if "/" in context:
        above = context.rpartition("/")[0] + "/"
    pid = str(carrier.PID)
    if flavour.integer_pid:
        pid = carrier.to_any(carrier.PID)
    pairs = [
        ("config.version", flavour.version),
        ("openrtm.name", product),
        ("openrtm.version", flavour.version),
        ("manager.instance_name", name),
        ("manager.name", "manager"),
        ("manager.naming_formats", above + "%n.mgr"),
        ("manager.pid", pid),
    ]
    if not flavour.modern:
        pairs.append(("manager.refstring_path", "/var/log/rtcmanager.ref"))
    pairs += [
        ("manager.modules.load_path", modules.directories()),
        ("manager.modules.abs_path_allowed", "YES"),
    ]
    for language in LANGUAGES:
        key = f"manager.modules.{language}."
        tail = generation + _PROGRAMS[language]
        pairs += [
            (key + "manager_cmd", "rtcd" + tail),
            (key + "profile_cmd", "rtcprof" + tail),
            (key + "suffixes", SUFFIXES[language][1:]),
            (key + "load_paths", ""),
        ]
    pairs += [("manager." + key, value) for key, value in _manager(flavour, master)]
    pairs += [
        ("os.name", "Linux"),
        ("os.release", "6.1.0"),
        ("os.version", "#1 SMP"),
        ("os.arch", "x86_64"),
        ("os.hostname", "test"),
    ]
    pairs += [(key, value) for key, value in _SURROUNDINGS]
    pairs += [
        ("corba.args", ""),
        ("corba." + flavour.endpoint_key, endpoint),
        ("corba.id", "omniORB"),
        ("corba.nameservers", "localhost"),
        ("corba.master_manager", "localhost:2810"),
        ("corba.nameservice.replace_endpoint", "NO"),
        ("corba.update_master_manager.enable", "YES"),
        ("corba.update_master_manager.interval", "10.0"),
        ("naming.formats", context),
    ]
    return pairs


NOT_IN_PYTHON = (
    "modules.config_path",
    "modules.download_allowed",
    "modules.init_func_suffix",
    "modules.init_func_prefix",
    "components.precreate",
)


def _manager(flavour, master):
    """The rest of the properties below `manager.`; Python lacks some."""
    suffix = SUFFIXES[flavour.language]
    is_master = "YES" if master else "NO"
    duration = "20.0" if flavour.modern else "10.0"
    pairs = [
        ("modules.config_path", ""),
        ("modules.download_allowed", ""),
        ("modules.init_func_suffix", ""),
        ("modules.init_func_prefix", ""),
        ("modules.preload", ", ".join(name + suffix for name in PRELOADED)),
        ("is_master", is_master),
        ("corba_servant", "YES"),
        ("shutdown_on_nortcs", "NO"),
        ("shutdown_auto", "NO"),
        ("auto_shutdown_duration", duration),
        ("command", flavour.program),
        ("supported_languages", ", ".join(LANGUAGES)),
        ("components.precreate", ""),
        ("components.preconnect", ""),
        ("components.preactivation", ""),
    ]
    if flavour.modern:
        pairs += [
            ("language", flavour.language),
            ("modules.search_auto", "YES"),
            ("termination_waittime", "0.5"),
            ("nameservers", "default"),
        ]
    if flavour.language == "Python":
        return [(key, value) for key, value in pairs if key not in NOT_IN_PYTHON]
    return pairs


_SURROUNDINGS = [
    ("logger.enable", "YES"),
    ("logger.file_name", "./rtc%p.log"),
    ("logger.date_format", "%b %d %H:%M:%S.%Q"),
    ("logger.log_level", "INFO"),
    ("logger.stream_lock", "NO"),
    ("logger.master_logger", ""),
    ("module.conf_path", ""),
    ("module.load_path", ""),
    ("naming.enable", "YES"),
    ("naming.type", "corba"),
    ("naming.update.enable", "YES"),
    ("naming.update.interval", "10.0"),
    ("naming.update.rebind", "NO"),
    ("timer.enable", "YES"),
    ("timer.tick", "0.1"),
    ("exec_cxt.periodic.type", "PeriodicExecutionContext"),
    ("exec_cxt.periodic.rate", "1000"),
    ("exec_cxt.evdriven.type", "EventDrivenExecutionContext"),
    ("exec_cxt.sync_transition", "YES"),
    ("exec_cxt.transition_timeout", "0.5"),
    ("sdo.service.provider.enabled_services", "ALL"),
    ("sdo.service.consumer.enabled_services", "ALL"),
]


def profiles(lists):
    """Lists of pairs as a ModuleProfileList."""
    from .idl import RTM
    return [RTM.ModuleProfile(nvlist(pairs)) for pairs in lists]
