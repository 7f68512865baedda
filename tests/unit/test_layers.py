"""The order of packages and other rules, checked in the source."""

import ast
import collections
import functools
import os
import re
import sys
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

ONCE = "it reads the source: one Python is enough"

# Files and packages of rtshell_lite import from those before them, never from those after them.
ORDER = """
    __init__ compiled bytecode start errors notes text records path idl_stubs giop net files corba
    options verbs robot data xmlprofile live datalog system play mocks views mount top doctor shell api
    progress cli anywhere __main__ commands bin
""".split()
OMNIORB = {"omniORB", "CORBA", "PortableServer", "CosNaming"}  # named in corba/ only, like stubs
PRINTING = ("bin", "anywhere.py", "cli.py", "options.py", "system/reports.py")
CATCH_ALL = (
    "cli.py",
    "api.py",
    "mocks.py",
    "net/loop.py",
    "corba/omniorb.py",
    "corba/iiop/server.py",
    "mount/attempt.py",
    "mount/server.py",
)
DOORS = ("cli.py", "api.py", "mocks.py", "shell/prompt.py")  # where a loop is entered
THREADS = (
    "net/real.py",
    "corba/omniorb.py",
    "corba/answers.py",
    "api.py",
)  # which may import threading


# Files that import what is net/'s to import, and what: two that run before anything else is imported, and the
# threads of omniORB, which are none of our loop's.
BESIDE_THE_DOOR = {
    "start.py": {"_signal"},
    "shell/installation.py": {"_signal"},
    "corba/answers.py": {"threading"},
    "corba/omniorb.py": {"threading"},
}
# What the behaviour of mocks takes from its carrier, and the modules of mock_components that are about real
# processes, sockets or omniORB, and so import it themselves.
CARRIED = OMNIORB | {"time", "threading", "uuid", "socket", "subprocess", "signal"}
CARRIED |= {"rtshell_lite.corba", "rtshell_lite.net"}
OF_THE_MACHINE = (
    "__main__",
    "asking",
    "carrier",
    "children",
    "control",
    "faulty",
    "nameserver",
    "orphans",
    "process",
    "robotservice",
    "running",
    "worlds",
)

# Names that say nothing of what they name, and how often they are still bound.
EMPTY = {"found", "each", "at", "known", "wanted", "made", "one", "so", "have"}
MOST_EMPTY = 5
MOST_PLACES = 13


def below(directory):
    """Our Python files below a directory: paths relative to the root, generated files aside."""
    found = []
    for where, directories, names in os.walk(os.path.join(ROOT, directory)):
        directories[:] = [
            name
            for name in directories
            if name not in ("__pycache__", "idl_stubs", "data")
            or name == "data"
            and where.endswith("rtshell_lite")
        ]
        for path in [os.path.join(where, name) for name in names]:
            if path.endswith(".py") or directory == "bin" and not os.path.basename(path).startswith("."):
                found.append(os.path.relpath(path, ROOT))
    return sorted(found)


def source(path):
    with open(os.path.join(ROOT, path), encoding="utf-8") as file:
        return file.read()


@functools.lru_cache(maxsize=None)
def parsed(path):
    return ast.parse(source(path))


@functools.lru_cache(maxsize=None)
def walk(tree):
    """ast.walk as a list, made once: most rules look at every node."""
    return list(ast.walk(tree))


def place(path):
    """A file's place in ORDER; None for one that is not there."""
    name = "bin" if path.startswith("bin") else re.split(r"[/.]", path)[1]
    return ORDER.index(name) if name in ORDER else None


def is_in(path, names):
    """Whether a path is one of these files of rtshell_lite, or in one of these packages."""
    inner = path[len("rtshell_lite/") :] if path.startswith("rtshell_lite/") else path
    return inner in names or inner.startswith(tuple(name + "/" for name in names))


def imports(tree):
    """(dotted name, whether it is inside a function) of all imports of a module."""
    inner = {
        node
        for function in walk(tree)
        if isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef))
        for node in walk(function)
    }
    for node in walk(tree):
        if isinstance(node, ast.Import):
            yield from ((name.name, node in inner) for name in node.names)
        elif isinstance(node, ast.ImportFrom):
            yield from (("%s.%s" % (node.module, name.name), node in inner) for name in node.names)


def words(tree):
    """The constants and the names of attributes in a part of a module."""
    constants = {node.value for node in walk(tree) if isinstance(node, ast.Constant)}
    return constants | {node.attr for node in walk(tree) if isinstance(node, ast.Attribute)}


class Layers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.paths = below("rtshell_lite") + below("bin")
        cls.trees = {path: parsed(path) for path in cls.paths}
        cls.arrows = [
            (path, dotted, inside) for path in cls.paths for dotted, inside in imports(cls.trees[path])
        ]

    def target(self, dotted):
        """The file of ours that an import names, or None."""
        parts = dotted.split(".")
        if parts[0] != "rtshell_lite":
            return None
        if "idl_stubs" in parts:
            return "rtshell_lite/idl_stubs/__init__.py"
        names = [
            "/".join(parts[:size]) + end
            for size in range(len(parts), 0, -1)
            for end in (".py", "/__init__.py")
        ]
        return next(name for name in names if name in self.trees)

    def test_every_file_has_its_place(self):
        self.assertEqual(
            [path for path in self.paths if place(path) is None],
            [],
            "to be put into a package, or into ORDER",
        )

    def test_imports_go_down(self):
        wrong = [
            (path, dotted)
            for path, dotted, _ in self.arrows
            if self.target(dotted) and place(self.target(dotted)) > place(path)
        ]
        self.assertEqual(wrong, [])

    def test_no_circles(self):
        targets = {path: set() for path in self.paths}
        for path, dotted, _ in self.arrows:
            targets[path] |= {self.target(dotted)} - {path}
        while targets:
            free = [name for name in targets if not targets[name] & set(targets)]
            self.assertTrue(free, "these import each other: %s" % sorted(targets))
            for name in free:
                del targets[name]

    @unittest.skipIf(sys.version_info < (3, 8), "this Python knows no ast.Constant")
    def test_facts_of_a_profile_are_listed_once(self):
        """A new one is a row of component.FACTS, and not one of seven lists."""
        lists = [
            path
            for path, tree in self.trees.items()
            for node in walk(tree)
            if isinstance(node, (ast.Dict, ast.List, ast.Tuple)) and {"vendor", "description"} <= words(node)
        ]
        self.assertEqual(lists, ["rtshell_lite/robot/component.py"])

    @unittest.skipIf(sys.version_info < (3, 8), "this Python knows no ast.Constant")
    def test_what_becomes_of_changes_has_one_vocabulary(self):
        """Steps and plans end in the same words, so that programs which read their JSON need one list."""
        for word in ("already", "uncertain", "not tried", "undone", "not undone"):
            homes = [path for path, tree in self.trees.items() if word in words(tree)]
            self.assertEqual(homes, ["rtshell_lite/system/outcomes.py"], word)

    def test_a_package_is_a_docstring(self):
        wrong = [
            path
            for path, tree in self.trees.items()
            if path.endswith("/__init__.py")
            and place(path)
            and not path.startswith("bin")  # where it stands in for the package
            and not (len(tree.body) == 1 and ast.get_docstring(tree))
        ]
        self.assertEqual(wrong, [])

    def test_omniorb_and_stubs_have_one_home(self):
        wrong = [
            (path, dotted)
            for path, dotted, _ in self.arrows
            if (dotted.split(".")[0] in OMNIORB or ".idl_stubs" in dotted)
            and not is_in(path, ["corba", "giop"])
        ]
        self.assertEqual(wrong, [])

    @unittest.skipUnless(
        hasattr(sys, "stdlib_module_names"), "Python before 3.10 does not list its own modules"
    )
    def test_nothing_foreign(self):
        known = set(sys.stdlib_module_names) | OMNIORB | {"rtshell_lite"}
        self.assertEqual(
            [(path, dotted) for path, dotted, _ in self.arrows if dotted.split(".")[0] not in known], []
        )

    def test_a_command_imports_at_its_top_what_needs_no_omniorb(self):
        wrong = [
            (path, dotted)
            for path, dotted, inside in self.arrows
            if path.startswith("bin")
            and not inside
            and is_in(self.target(dotted) or "", ["corba", "robot"])
        ]
        self.assertEqual(wrong, [], "to be imported inside run()")

    def test_few_files_print(self):
        wrong = [
            (path, calls(tree, {"print"})) for path, tree in self.trees.items() if not is_in(path, PRINTING)
        ]
        self.assertEqual([(path, lines) for path, lines in wrong if lines], [])


class OneColour(unittest.TestCase):
    """What may ask a peer is a coroutine; nothing else waits."""

    @classmethod
    def setUpClass(cls):
        cls.trees = {path: parsed(path) for path in below("rtshell_lite") + below("bin")}

    def uses(self, module, attribute):
        """(path, line) of each use of an attribute of a module."""
        return [
            (path, node.lineno)
            for path, tree in self.trees.items()
            for node in walk(tree)
            if isinstance(node, ast.Attribute)
            and node.attr == attribute
            and isinstance(node.value, ast.Name)
            and node.value.id == module
        ]

    def test_nobody_sleeps(self):
        self.assertEqual(self.uses("time", "sleep"), [])

    def test_threads_have_few_homes(self):
        wrong = [
            (path, dotted)
            for path, tree in self.trees.items()
            for dotted, _ in imports(tree)
            if dotted.split(".")[0] in ("threading", "queue", "asyncio", "concurrent")
            and not is_in(path, THREADS)
        ]
        self.assertEqual(wrong, [])
        starting = {
            path
            for path, tree in self.trees.items()
            for node in walk(tree)
            if isinstance(node, ast.Attribute) and node.attr == "start_thread"
        }
        self.assertEqual(
            starting,
            {
                "rtshell_lite/" + path
                for path in (
                    "cli.py",
                    "api.py",
                    "mocks.py",
                    "net/hosts.py",
                    "net/loop.py",
                    "doctor/limits.py",
                )
            },
        )

    def test_the_world_has_one_door(self):
        """Clocks, sockets, names of hosts, threads, processes and signals are those of the loop's world."""
        doors = {"socket", "_socket", "select", "time", "subprocess", "signal", "_signal", "threading"}
        doors |= {"ctypes"}
        wrong = [(path, line) for path, line in self.uses("os", "readv") if not is_in(path, ("net",))]
        for path, tree in self.trees.items():
            found = {dotted.split(".")[0] for dotted, _ in imports(tree)} & doors
            inner = path[len("rtshell_lite/") :]
            if not inner.startswith("net/") and found - BESIDE_THE_DOOR.get(inner, set()):
                wrong.append((path, sorted(found)))
        self.assertEqual(wrong, [])
        unused = set(BESIDE_THE_DOOR) - {path[len("rtshell_lite/") :] for path in self.trees}
        self.assertEqual(unused, set())

    def test_loops_have_few_doors(self):
        wrong = [(path, line) for path, line in self.uses("loop", "run") if not is_in(path, DOORS)]
        self.assertEqual(wrong, [])

    def test_coroutines_are_awaited(self):
        """Calling a coroutine function of the same file without `await` does nothing."""
        wrong = []
        for path, tree in self.trees.items():
            own = {
                node.name
                for node in walk(tree)
                if isinstance(node, ast.AsyncFunctionDef) and not node.decorator_list
            }
            own -= {node.name for node in walk(tree) if isinstance(node, ast.FunctionDef)}
            for node in walk(tree):
                value = node.value if isinstance(node, ast.Expr) else None
                if isinstance(value, ast.Call) and own_name(value.func) in own:
                    wrong.append((path, node.lineno))
        self.assertEqual(wrong, [])


COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
WIDTH = 110  # columns


def inner_nodes(statement):
    """The nodes of a statement, without those of the statements inside it."""
    waiting = list(ast.iter_child_nodes(statement))
    while waiting:
        node = waiting.pop()
        if isinstance(node, (ast.stmt, ast.ExceptHandler)):
            continue
        yield node
        waiting += ast.iter_child_nodes(node)


def is_filtered(comprehension):
    return any(loop.ifs for loop in comprehension.generators)


class PlainCode(unittest.TestCase):
    """Statements that are read once."""

    @classmethod
    def setUpClass(cls):
        cls.paths = below("rtshell_lite") + below("bin")

    def statements(self):
        """(place, its inner nodes) of every statement."""
        for path in self.paths:
            for node in walk(parsed(path)):
                if isinstance(node, ast.stmt):
                    yield "%s:%d" % (path, node.lineno), list(inner_nodes(node))

    def test_a_statement_has_one_choice(self):
        wrong = [
            place
            for place, nodes in self.statements()
            if sum(isinstance(node, ast.IfExp) for node in nodes) > 1
        ]
        self.assertEqual(wrong, [])

    def test_filters_are_not_nested(self):
        wrong = []
        for place, nodes in self.statements():
            filtered = [node for node in nodes if isinstance(node, COMPREHENSIONS) and is_filtered(node)]
            if any(other in walk(node)[1:] for node in filtered for other in filtered):
                wrong.append(place)
        self.assertEqual(wrong, [])

    @unittest.skipIf(sys.version_info < (3, 8), "Python before 3.8 does not say where a string ends")
    def test_lines_are_short(self):
        """Those with sentences for people may be longer."""
        wrong = []
        for path in self.paths:
            long = {number for number, line in enumerate(source(path).splitlines(), 1) if len(line) > WIDTH}
            for node in walk(parsed(path)):
                if (
                    isinstance(node, ast.JoinedStr)
                    or isinstance(node, ast.Constant)
                    and isinstance(node.value, str)
                ):
                    long -= set(range(node.lineno, node.end_lineno + 1))
            wrong += ["%s:%d" % (path, number) for number in sorted(long)]
        self.assertEqual(wrong, [])

    def test_names_say_what_they_name(self):
        """Variables and parameters have nouns of the domain. Some that say nothing are left: there may be
        fewer, never more. `place` once had ten meanings.
        """
        bound = collections.Counter(name for path in self.paths for name in bound_names(parsed(path)))
        self.assertLessEqual(sum(bound[name] for name in EMPTY), MOST_EMPTY)
        self.assertLessEqual(bound["place"] + bound["places"], MOST_PLACES)


class Rules(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        paths = [
            path
            for directory in ("rtshell_lite", "bin", "mock_components", "tests")
            for path in below(directory)
        ]
        cls.trees = {path: parsed(path) for path in paths}

    def check(self, faults):
        """No file has a fault; faults(path, tree) gives line numbers."""
        found = {path: list(faults(path, tree)) for path, tree in self.trees.items()}
        self.assertEqual({path: lines for path, lines in found.items() if lines}, {})

    def test_mocks_leave_the_orb_and_the_machine_to_their_carrier(self):
        wrong = []
        for path in below("mock_components"):
            if os.path.basename(path)[: -len(".py")] in OF_THE_MACHINE:
                continue
            for dotted, _ in imports(self.trees[path]):
                parts = dotted.split(".")
                if {parts[0], ".".join(parts[:2])} & CARRIED:
                    wrong.append((path, dotted))
        self.assertEqual(wrong, [])

    def test_nothing_is_evaluated(self):
        self.check(lambda path, tree: calls(tree, {"eval", "exec"}))

    def test_no_shell_between(self):
        def faults(path, tree):
            for node in walk(tree):
                if isinstance(node, ast.Call) and any(word.arg == "shell" for word in node.keywords):
                    yield node.lineno
                elif (
                    isinstance(node, ast.Attribute)
                    and node.attr in ("system", "popen")
                    and isinstance(node.value, ast.Name)
                    and node.value.id == "os"
                ):
                    yield node.lineno

        self.check(faults)

    def test_exceptions_are_named(self):
        def faults(path, tree):
            for node in walk(tree):
                if isinstance(node, ast.ExceptHandler):
                    catch_all = node.type is not None and names(node.type) & {"Exception", "BaseException"}
                    free = (
                        path.startswith(("tests", "mock_components"))
                        or is_in(path, CATCH_ALL)
                        or raises_again(node)
                    )
                    if node.type is None or catch_all and not free:
                        yield node.lineno

        self.check(faults)

    @unittest.skipIf(sys.version_info < (3, 8), "this Python does not know newer syntax")
    def test_syntax_of_3_6(self):
        for path in self.trees:
            ast.parse(source(path), path, feature_version=(3, 6))
        self.check(
            lambda path, tree: [
                node.lineno
                for node in walk(tree)
                if isinstance(node, ast.JoinedStr)
                and any(isinstance(inner, ast.Await) for inner in ast.walk(node))
            ]
        )


def own_name(function):
    """`name` of a call of name(…) or self.name(…), else None."""
    if (
        isinstance(function, ast.Attribute)
        and isinstance(function.value, ast.Name)
        and function.value.id == "self"
    ):
        return function.attr
    return getattr(function, "id", None)


def raises_again(handler):
    """Whether an exception goes on after its handler."""
    last = handler.body[-1]
    return isinstance(last, ast.Raise) and last.exc is None


def names(node):
    return {inner.id for inner in walk(node) if isinstance(inner, ast.Name)}


def bound_names(tree):
    """The names of the variables and parameters of a module, as often as they are bound."""
    for node in walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        elif isinstance(node, ast.arg):
            yield node.arg


def calls(tree, functions):
    """Lines where one of these plain names is called."""
    return [
        node.lineno
        for node in walk(tree)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in functions
    ]


if __name__ == "__main__":
    unittest.main()
