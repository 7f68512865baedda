"""The direction of imports and a few rules of the house, read from the source: if this fails, layers grow together."""
import ast
import os
import re
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# A module imports from its own line and from those below, never from above; a new module is put where it belongs.
LAYERS = [
    ["bin"],
    ["__main__"],
    ["system", "plan", "graph", "listing", "describe", "search", "unbind", "shell", "unpack"],
    ["component", "ports", "manager", "observer", "dataport", "datalog", "datatypes", "configuration"],
    ["tree"],
    ["orb", "cli", "installation"],
    ["path", "xmlprofile"],
    ["rpc", "text", "files"],
    ["errors"],
    ["__init__"],
]
OMNIORB_HOMES = {"orb", "dataport", "observer"}  # the last two serve CORBA objects themselves
STUB_LAYERS = LAYERS[3] + LAYERS[4] + ["orb"]  # inside functions; a command must not pay for stubs that it does not use
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
    paths = below("rtshell_lite") + below("bin")

    def each(self):
        for path in self.paths:
            with self.subTest(path):
                yield path, ast.parse(source(path))

    def test_every_module_has_its_layer(self):
        for path in self.paths:
            with self.subTest(path):
                self.assertIsNotNone(layer(module(path)), "put it into LAYERS")

    def test_imports_go_down(self):
        for path, tree in self.each():
            for dotted, _ in imports(tree):
                target = own(dotted)
                if target and target != "idl_stubs":
                    self.assertIsNotNone(layer(target), dotted)
                    self.assertLessEqual(layer(target), layer(module(path)), "%s imports %s" % (path, dotted))

    def test_no_circles(self):
        arrows = {}
        for path, tree in self.each():
            targets = {own(dotted) for dotted, _ in imports(tree)} - {None, "idl_stubs", module(path)}
            arrows.setdefault(module(path), set()).update(targets)
        while arrows:
            free = [name for name, targets in arrows.items() if not targets & set(arrows)]
            self.assertTrue(free, "these import each other: %s" % sorted(arrows))
            for name in free:
                del arrows[name]

    def test_omniorb_has_few_homes(self):
        for path, tree in self.each():
            for dotted, _ in imports(tree):
                if dotted.split(".")[0] in ("omniORB", "CORBA", "CosNaming", "PortableServer"):
                    self.assertIn(module(path), OMNIORB_HOMES, "%s imports %s" % (path, dotted))

    def test_stubs_are_imported_where_they_are_needed(self):
        for path, tree in self.each():
            for dotted, inside in imports(tree):
                if own(dotted) == "idl_stubs":
                    self.assertIn(module(path), STUB_LAYERS, "%s imports %s" % (path, dotted))
                    self.assertTrue(inside or module(path) in OMNIORB_HOMES, "%s imports %s at its top" % (path, dotted))

    @unittest.skipUnless(hasattr(sys, "stdlib_module_names"), "Python before 3.10 does not list its own modules")
    def test_nothing_foreign(self):
        for path, tree in self.each():
            for dotted, _ in imports(tree):
                name = dotted.split(".")[0]
                if name != "omniORB" and name != "rtshell_lite":
                    self.assertIn(name, sys.stdlib_module_names, path)

    def test_a_command_imports_at_its_top_what_needs_no_omniorb(self):
        for path in below("bin"):
            with self.subTest(path):
                for dotted, inside in imports(ast.parse(source(path))):
                    target = own(dotted)
                    if target and not inside:
                        self.assertNotIn(target, set(STUB_LAYERS) | OMNIORB_HOMES, "%s: import %s inside run()" % (path, target))

    def test_only_commands_and_cli_print(self):
        for path, tree in self.each():
            if module(path) not in ("bin", "cli", "__main__"):
                self.assertEqual(calls(tree, {"print"}), [], path)


class Rules(unittest.TestCase):
    paths = sum((below(directory) for directory in ("rtshell_lite", "bin", "mock_components", "tests")), [])

    def test_length(self):
        for path in self.paths:
            with self.subTest(path):
                self.assertLessEqual(source(path).count("\n"), LONGEST)

    def test_nothing_is_evaluated(self):
        for path in self.paths:
            with self.subTest(path):
                tree = ast.parse(source(path))
                self.assertEqual(calls(tree, {"eval", "exec", "__import__"}), [])
                shells = [word for call in ast.walk(tree) if isinstance(call, ast.Call) for word in call.keywords
                          if word.arg == "shell"]
                attributes = [node.lineno for node in ast.walk(tree) if isinstance(node, ast.Attribute)
                              and isinstance(node.value, ast.Name) and node.value.id == "os"
                              and node.attr in ("system", "popen")]
                self.assertEqual(shells + attributes, [])

    def test_exceptions_are_named(self):
        for path in self.paths:
            with self.subTest(path):
                for node in ast.walk(ast.parse(source(path))):
                    if isinstance(node, ast.ExceptHandler):
                        self.assertIsNotNone(node.type, "line %d: bare except" % node.lineno)
                        if path.startswith(("rtshell_lite", "bin")) and module(path) not in CATCH_ALL_HOMES:
                            self.assertFalse(names(node.type) & {"Exception", "BaseException"}, "line %d" % node.lineno)

    @unittest.skipIf(sys.version_info < (3, 8), "this Python knows no newer syntax, or not how to refuse it")
    def test_syntax_of_3_6(self):
        for path in self.paths:
            with self.subTest(path):
                ast.parse(source(path), feature_version=(3, 6))


def names(node):
    return {inner.id for inner in ast.walk(node) if isinstance(inner, ast.Name)}


def calls(tree, functions):
    """Lines where one of these plain names is called."""
    return [node.lineno for node in ast.walk(tree)
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in functions]


if __name__ == "__main__":
    unittest.main()
