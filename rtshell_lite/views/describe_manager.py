"""What rtcat shows of a manager, as lines or as JSON."""

import collections

from rtshell_lite import errors
from rtshell_lite.robot import manager, tree
from rtshell_lite.text import printable

# What rtcat shows of a manager: `profile` a dict, `loaded` and `loadable` lists of file paths; `loadable` is
# None if the manager refuses it, with the errors.Error `error`.
About = collections.namedtuple("About", "node profile loaded loadable error")

# (heading or None, the lines below it: (key of the profile, label)).
_SECTIONS = (
    (None, (
        ("name", "Name"),
        ("instance_name", "Instance name"),
        ("pid", "Process ID"),
        ("naming_formats", "Naming format"),
        ("refstring_path", "Refstring path"),
        ("components.precreate", "Components precreate"),
    )),
    ("Modules", (
        ("modules.load_path", "Load path"),
        ("modules.config_path", "Config path"),
        ("modules.preload", "Preload"),
        ("modules.init_func_prefix", "Init function prefix"),
        ("modules.init_func_suffix", "Init function suffix"),
        ("modules.download_allowed", "Download allowed"),
        ("modules.abs_path_allowed", "Absolute path allowed"),
    )),
    ("OS", (
        ("os.version", "Version"),
        ("os.arch", "Architecture"),
        ("os.release", "Release"),
        ("os.hostname", "Host name"),
        ("os.name", "Name"),
    )),
)


async def collect(node):
    """Ask a manager for all that rtcat shows, an About. It may take a while to look for loadable modules."""
    profile = dict(await manager.profile(node))
    loaded = [module.get("file_path", "") for module in await manager.modules(node, "get_loaded_modules")]
    try:
        return About(
            node, profile, loaded,
            sorted(module.get("module_file_path", "") for module in await manager.modules(node)), None,
        )
    except errors.Refused as e:
        return About(node, profile, loaded, None, e)


def lines(about):
    """The lines of rtcat for a manager, without what its version does not have."""
    for heading, entries in _SECTIONS:
        if heading and any(key in about.profile for key, _ in entries):
            yield heading + ":"
        for key, label in entries:
            if key in about.profile:
                line = f"{label}: {printable(about.profile[key])}"
                if heading:
                    line = "  " + line
                yield line
    yield "Loaded modules:"
    for path in about.loaded:
        yield "  Filepath: " + printable(path)
    yield "Loadable modules:"
    for path in about.loadable or ():
        yield "  " + printable(path)


async def as_dict(about):
    """The JSON object of a manager."""
    return {
        "path": str(about.node.path),
        "kind": "manager",
        "profile": about.profile,
        "loaded_modules": about.loaded,
        "loadable_modules": about.loadable,
        "components": [name for name, _ in await manager.components(about.node)],
        "slaves": [str(slave.path) for slave in await tree.slaves(about.node)],
    }
