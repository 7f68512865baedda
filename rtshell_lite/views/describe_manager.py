"""What rtcat shows of a manager, as lines or as JSON."""
import collections

from rtshell_lite import errors
from rtshell_lite.robot import manager, tree
from rtshell_lite.text import printable

# All that rtcat knows of one manager: `profile` a dict, `loaded` and `loadable` lists of file paths; the latter is None if the
# manager does not say it, for the reason in `error`.
Found = collections.namedtuple("Found", "node profile loaded loadable error")

# Heading or None, then the lines below it: key of the profile, label.
_SECTIONS = (
    (None, (("name", "Name"), ("instance_name", "Instance name"), ("pid", "Process ID"), ("naming_formats", "Naming format"),
            ("refstring_path", "Refstring path"), ("components.precreate", "Components precreate"))),
    ("Modules", (("modules.load_path", "Load path"), ("modules.config_path", "Config path"), ("modules.preload", "Preload"),
                 ("modules.init_func_prefix", "Init function prefix"), ("modules.init_func_suffix", "Init function suffix"),
                 ("modules.download_allowed", "Download allowed"), ("modules.abs_path_allowed", "Absolute path allowed"))),
    ("OS", (("os.version", "Version"), ("os.arch", "Architecture"), ("os.release", "Release"), ("os.hostname", "Host name"),
            ("os.name", "Name"))),
)


def collect(node):
    """Ask a manager for everything that rtcat shows, a Found. Looking for loadable modules may take it a while."""
    profile = dict(manager.profile(node))
    loaded = [each.get("file_path", "") for each in manager.modules(node, "get_loaded_modules")]
    try:
        return Found(node, profile, loaded, sorted(each.get("module_file_path", "") for each in manager.modules(node)), None)
    except errors.Refused as e:
        return Found(node, profile, loaded, None, e)


def lines(found):
    """The lines of rtcat for a manager; what a version does not say is left out."""
    for heading, entries in _SECTIONS:
        if heading and any(key in found.profile for key, _ in entries):
            yield heading + ":"
        for key, label in entries:
            if key in found.profile:
                yield f"{'  ' if heading else ''}{label}: {printable(found.profile[key])}"
    yield "Loaded modules:"
    for path in found.loaded:
        yield "  Filepath: " + printable(path)
    yield "Loadable modules:"
    for path in found.loadable or ():
        yield "  " + printable(path)


def as_dict(found):
    """The JSON object of a manager."""
    return {"path": str(found.node.path), "kind": "manager", "profile": found.profile, "loaded_modules": found.loaded,
            "loadable_modules": found.loadable, "components": [name for name, _ in manager.components(found.node)],
            "slaves": [str(slave.path) for slave in tree.slaves(found.node)]}
