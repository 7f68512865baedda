"""The direction of imports and a few rules of the house, read from the source: if this fails, layers grow together."""
import ast
import os
import re
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

ONCE = "it reads the source: one Python is enough"

# A module imports from its own layer and from those below, never from above; a new module is put where it belongs.
LAYERS = [
    ["bin"],  # the commands
    ["__main__"],
    # changing a system in steps; running commands, completing them, describing them; the live page
    ["apply", "completion", "interpreter", "linking", "manpages", "mapping", "page", "prompt", "restore", "steps"],
    # what single commands do
    ["compare", "composing", "describe", "describe_manager", "doctor", "drawing", "exporting", "graph", "injecting", "listing",
     "manual", "markup", "plan", "playing", "printing", "recording", "search", "starting", "svg", "system", "top", "unbind",
     "unpack", "watch"],
    # what can be asked of components, ports and managers, and done with them; being a port or an observer; logs of data
    ["component", "configuration", "connection", "datalog", "dataport", "datatypes", "delivery", "execution", "flow", "fsm",
     "inbox", "manager", "observer", "organisation", "places", "polling", "ports", "servants", "targets"],
    ["tree"],  # from a path to a node
    ["aliases", "node"],
    ["answers", "orb", "cli", "commandline", "installation", "reports", "streams"],  # the door to omniORB; what commands share
    # forms of things, told from text or bytes without asking anybody
    ["cdr", "constants", "constraints", "construct", "descriptors", "idl", "ior", "overview", "path", "portable", "values",
     "xmlprofile"],
    ["files", "interrupts", "rpc", "shell", "text"],
    ["errors"],
    ["__init__"],
]
OMNIORB_HOMES = {"orb", "answers", "servants", "observer"}  # all but the first two serve CORBA objects themselves
# Stubs are imported here, inside functions; a command must not pay for those that it does not use.
STUB_LAYERS = next(names for names in LAYERS if "component" in names) + ["node", "orb"]
CATCH_ALL_HOMES = {"cli", "rpc"}
LONGEST = 400


def below(directory):
    """Our Python files below a directory: paths relative to the root, generated files aside."""
    found = []
    for where, directories, names in os.walk(os.path.join(ROOT, directory)):
        directories[:] = [name for name in directories if name not in ("__pycache__", "idl_stubs", "data")]
        for path in [os.path.join(where, name) for name in names]:
            if path.endswith(".py") or directory == "bin" and not os.path.basename(path).startswith("."):
                found.append(os.path.relpath(path, ROOT))
    return sorted(found)


def source(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


def module(path):
    """The name of a file in LAYERS: its part of rtshell_lite, or bin."""
    return "bin" if path.startswith("bin") else re.split(r"[/.]", path)[1]


def layer(name):
    """The height of a module in LAYERS, counted from below."""
    heights = [height for height, names in enumerate(reversed(LAYERS)) if name in names]
    return heights[0] if heights else None


def imports(tree):
    """Dotted names that a module imports, anywhere, each with whether it stands in a function."""
    inner = {node for function in ast.walk(tree) if isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef))
             for node in ast.walk(function)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for name in node.names:
                yield name.name, node in inner
        elif isinstance(node, ast.ImportFrom):
            start = "rtshell_lite" if node.level else ""
            where = ".".join(filter(None, [start, node.module]))
            for name in node.names:  # `from rtshell_lite import tree` and `from rtshell_lite.tree import walk` alike
                yield where + "." + name.name, node in inner


def own(dotted):
    """The module of ours that an import names, or None."""
    parts = dotted.split(".")
    if parts[0] != "rtshell_lite":
        return None
    return "__init__" if len(parts) == 1 or parts[1].startswith("__v") else parts[1]


class Layers(unittest.TestCase):
    def setUp(self):
        paths = below("rtshell_lite") + below("bin")
        self.trees = {path: ast.parse(source(path)) for path in paths}
        self.arrows = [(path, dotted, inside) for path in paths for dotted, inside in imports(self.trees[path])]

    def test_every_module_has_its_layer(self):
        self.assertEqual([path for path in self.trees if layer(module(path)) is None], [], "to be put into LAYERS")

    def test_imports_go_down(self):
        wrong = [(path, dotted) for path, dotted, _ in self.arrows if own(dotted) not in (None, "idl_stubs")
                 and (layer(own(dotted)) is None or layer(own(dotted)) > (layer(module(path)) or 0))]
        self.assertEqual(wrong, [])

    def test_no_circles(self):
        targets = {module(path): set() for path in self.trees}
        for path, dotted, _ in self.arrows:
            targets[module(path)] |= {own(dotted)} - {module(path)}
        while targets:
            free = [name for name in targets if not targets[name] & set(targets)]
            self.assertTrue(free, "these import each other: %s" % sorted(targets))
            for name in free:
                del targets[name]

    def test_omniorb_has_few_homes(self):
        wrong = [(path, dotted) for path, dotted, _ in self.arrows
                 if dotted.split(".")[0] in ("omniORB", "CORBA", "PortableServer") and module(path) not in OMNIORB_HOMES]
        self.assertEqual(wrong, [])

    def test_stubs_are_imported_where_they_are_needed(self):
        wrong = [(path, dotted) for path, dotted, inside in self.arrows
                 if (own(dotted) == "idl_stubs" or dotted.startswith("CosNaming"))
                 and not (module(path) in STUB_LAYERS and (inside or module(path) in OMNIORB_HOMES))]
        self.assertEqual(wrong, [])

    @unittest.skipUnless(hasattr(sys, "stdlib_module_names"), "Python before 3.10 does not list its own modules")
    def test_nothing_foreign(self):
        known = set(sys.stdlib_module_names) | {"rtshell_lite", "omniORB", "CosNaming"}
        self.assertEqual([(path, dotted) for path, dotted, _ in self.arrows if dotted.split(".")[0] not in known], [])

    def test_a_command_imports_at_its_top_what_needs_no_omniorb(self):
        wrong = [(path, dotted) for path, dotted, inside in self.arrows if module(path) == "bin" and not inside
                 and own(dotted) and (layer(own(dotted)) >= layer("tree") or own(dotted) == "orb")]
        self.assertEqual(wrong, [], "to be imported inside run()")

    def test_only_commands_cli_and_reports_print(self):
        wrong = [(path, calls(tree, {"print"})) for path, tree in self.trees.items()
                 if module(path) not in ("bin", "cli", "reports", "__main__") and calls(tree, {"print"})]
        self.assertEqual(wrong, [])


class Rules(unittest.TestCase):
    def setUp(self):
        paths = [path for directory in ("rtshell_lite", "bin", "mock_components", "tests") for path in below(directory)]
        self.trees = {path: ast.parse(source(path)) for path in paths}

    def check(self, faults):
        """No file has a fault; faults(path, tree) gives line numbers."""
        found = {path: list(faults(path, tree)) for path, tree in self.trees.items()}
        self.assertEqual({path: lines for path, lines in found.items() if lines}, {})

    def test_length(self):
        self.check(lambda path, tree: [n for n in [source(path).count("\n")] if n > LONGEST])

    def test_nothing_is_evaluated(self):
        self.check(lambda path, tree: calls(tree, {"eval", "exec"}))

    def test_no_shell_between(self):
        def faults(path, tree):
            for node in ast.walk(tree):
                if isinstance(node, ast.Call) and any(word.arg == "shell" for word in node.keywords):
                    yield node.lineno
                elif isinstance(node, ast.Attribute) and node.attr in ("system", "popen") and \
                        isinstance(node.value, ast.Name) and node.value.id == "os":
                    yield node.lineno
        self.check(faults)

    def test_exceptions_are_named(self):
        def faults(path, tree):
            for node in ast.walk(tree):
                if isinstance(node, ast.ExceptHandler):
                    catch_all = node.type is not None and names(node.type) & {"Exception", "BaseException"}
                    free = path.startswith(("tests", "mock_components")) or module(path) in CATCH_ALL_HOMES
                    if node.type is None or catch_all and not free:
                        yield node.lineno
        self.check(faults)

    @unittest.skipIf(sys.version_info < (3, 8), "this Python cannot tell newer syntax")
    def test_syntax_of_3_6(self):
        for path in self.trees:
            ast.parse(source(path), path, feature_version=(3, 6))


def names(node):
    return {inner.id for inner in ast.walk(node) if isinstance(inner, ast.Name)}


def calls(tree, functions):
    """Lines where one of these plain names is called."""
    return [node.lineno for node in ast.walk(tree)
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in functions]


if __name__ == "__main__":
    unittest.main()
