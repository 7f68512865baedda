#!/usr/bin/env python3
"""Change modules of rtshell_lite in one place after another, and see whether a test fails. What survives is a
hole in the tests, or a change that changes nothing.

    python3 tests/mutate.py data/statistics.py … [--seed N] [--most N] [--tests N] [--transcripts N]

Runs in a copy of the checkout, on a Python from 3.8 on that has omniORBpy: this one, or what `tests/run` has
made below .venv-tests. Which tests cover a module is read from imports: the nearest of tests/unit that import
it, directly or through others, and the transcripts of the nearest commands that do. Each runs unspoilt before
it is needed for the first time, which says what functions it enters: it is left out if it fails, or does not
enter the function that is spoilt; if it takes three times as long later, and 10 s, it fails. They run up to
the first that fails: those that were quick and noticed much come first.
"""
import argparse
import ast
import collections
import glob
import itertools
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
COMPARISONS = {
    "<": ["<=", ">"],
    "<=": ["<", ">="],
    ">": [">=", "<"],
    ">=": [">", "<="],
    "==": ["!="],
    "!=": ["=="],
    "is": ["is not"],
    "is not": ["is"],
    "in": ["not in"],
    "not in": ["in"],
}
OTHERS = {"and": ["or"], "or": ["and"], "+": ["-"], "-": ["+"], "*": ["/"], "//": ["*"], "/": ["*"]}
DELETED = (ast.Expr, ast.Raise, ast.AugAssign, ast.Break, ast.Continue, ast.Delete)


# ---- what is changed ----

class Source:
    """The text of a module, and the positions of its nodes in bytes."""

    def __init__(self, data):
        self.data = data
        self.tree = ast.parse(data)
        self.meaning = ast.dump(self.tree)
        self.lines = [0]
        for line in data.splitlines(True):
            self.lines.append(self.lines[-1] + len(line))

    def start(self, node):
        return self.lines[node.lineno - 1] + node.col_offset

    def end(self, node):
        return self.lines[node.end_lineno - 1] + node.end_col_offset

    def spoilt(self, start, end, new):
        """The text with another piece at one place and the same lines; None where the meaning is the same, or
        invalid.
        """
        old = self.data[start:end]
        data = (
            self.data[:start]
            + new.encode()
            + b"\\\n" * (old.count(b"\n") - new.count("\n"))
            + self.data[end:]
        )
        try:
            return data if ast.dump(ast.parse(data)) != self.meaning else None
        except (SyntaxError, ValueError):
            return None

    def functions(self):
        """Pairs of the functions that do anything and their first statements, docstrings aside."""
        for node in ast.walk(self.tree):
            if isinstance(node, ast.FunctionDef):
                statements = node.body[ast.get_docstring(node) is not None:]
                if statements:
                    yield node, statements[0]

    def function(self, position):
        """The line where the innermost function around a position begins, None where there is none."""
        around = [
            node.lineno for node, first in self.functions() if self.start(first) <= position < self.end(node)
        ]
        return max(around) if around else None

    def probed(self, probe):
        """The text with an expression, `probe % line`, where each function begins; `line` is that of its def.
        """
        data = self.data
        for node, first in sorted(self.functions(), key=lambda pair: -self.start(pair[1])):
            line = (
                min([first.lineno] + [decorator.lineno for decorator in getattr(first, "decorator_list", ())])
                - 1
            )
            start = self.lines[line] + first.col_offset
            margin = data[self.lines[line]:start]
            between = b"; " if margin.strip() else b"\n" + margin
            data = data[:start] + (probe % node.lineno).encode() + between + data[start:]
        return data


def mutations(source):
    """Triples (start, end, new text) of all places that can be changed."""
    skipped = set()
    for node in ast.walk(source.tree):
        if (
            isinstance(node, ast.Expr)
            and isinstance(node.value, ast.Constant)
            or isinstance(node, ast.JoinedStr)
        ):
            # docstrings; the inner nodes of an f-string have no places of their own
            skipped.update(ast.walk(node))
    for node in ast.walk(source.tree):
        if node not in skipped:
            for name in [cls.__name__ for cls in type(node).__mro__ if "_" + cls.__name__ in globals()]:
                yield from globals()["_" + name](source, node)


def _between(source, left, right, operators):
    """Other operators between two operands."""
    start = source.end(left)
    end = source.start(right)
    gap = source.data[start:end].decode()
    found = re.match(r"[\s)\\]*([-+*/<>=!]+|(?:is|not|and|or|in)(?: +(?:not|in)\b)?)", gap)
    for new in operators.get(found.group(1), ()) if found else ():
        yield start + found.start(1), start + found.end(1), new


def _Compare(source, node):
    for left, right in zip([node.left] + node.comparators, node.comparators):
        yield from _between(source, left, right, COMPARISONS)


def _BinOp(source, node):
    yield from _between(source, node.left, node.right, OTHERS)


def _BoolOp(source, node):
    for left, right in zip(node.values, node.values[1:]):
        yield from _between(source, left, right, OTHERS)
        yield source.start(left), source.start(right), ""
    yield source.end(node.values[-2]), source.end(node.values[-1]), ""


def _UnaryOp(source, node):
    if isinstance(node.op, ast.Not):
        yield source.start(node), source.start(node.operand), ""


def _If(source, node):
    if isinstance(node.test, (ast.Name, ast.Attribute, ast.Call)):
        yield source.start(node.test), source.start(node.test), "not "


_While = _IfExp = _If


def _Return(source, node):
    if node.value is not None:
        yield source.start(node.value), source.end(node.value), "None"


def _Constant(source, node):
    if isinstance(node.value, bool):
        yield source.start(node), source.end(node), str(not node.value)
    elif isinstance(node.value, (int, float)):
        yield source.start(node), source.end(node), repr(node.value + 1)
    elif (
        isinstance(node.value, (str, bytes))
        and node.lineno == node.end_lineno
        and len(node.value.split()) < 2
    ):
        yield source.start(node), source.end(node), repr(
            node.value + ("x" if isinstance(node.value, str) else b"x")
        )


def _stmt(source, node):
    assigned = isinstance(node, ast.Assign) and not any(
        isinstance(target, (ast.Name, ast.Tuple)) for target in node.targets
    )
    if isinstance(node, DELETED) or assigned:
        yield source.start(node), source.end(node), "pass"


def _ExceptHandler(source, node):
    if isinstance(node.type, ast.Tuple):
        for item in node.type.elts:
            yield source.start(item), source.end(item), "()"
    elif node.type:
        yield source.start(node.type), source.end(node.type), "()"


def _Call(source, node):
    """Arguments to drop: the last of several positional ones, and each keyword argument."""
    before = source.end(node.func)
    for number, argument in enumerate(node.args):
        if number == len(node.args) - 1 > 0:
            yield before, source.end(argument), ""
        before = source.end(argument)
    for keyword in node.keywords:
        end = source.end(keyword.value)
        yield (before, end, "") if node.args or keyword is not node.keywords[0] else (before, end, "(")
        before = end


# ---- which tests cover it ----

def imported(path):
    """Files of ours that a Python file imports, anywhere in it."""
    with open(path, "rb") as file:
        tree = ast.parse(file.read())
    for node in ast.walk(tree):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            for name in node.names:
                dotted = name.name if isinstance(node, ast.Import) else "%s.%s" % (node.module, name.name)
                for part in (dotted, dotted.rpartition(".")[0]):
                    yield from filter(
                        os.path.isfile,
                        [
                            os.path.join(root, part.replace(".", "/") + ".py")
                            for root in (ROOT, os.path.join(ROOT, "tests", "support"))
                        ],
                    )


def covering(path):
    """Test modules of tests/unit and tests/waiting that import a file, the nearest first: `unit/test_path` …;
    and the tests of the nearest commands, by turns: `commands/rtls.t` …
    """
    files = [
        file
        for pattern in ("rtshell_lite/**/*.py", "tests/support/*.py", "tests/[uw]*/test_*.py", "bin/rt*")
        for file in sorted(glob.glob(os.path.join(glob.escape(ROOT), pattern), recursive=True))
        if "/idl_stubs/" not in file and os.path.isfile(file)
    ]
    arrows = {file: set(imported(file)) for file in files}
    near = [path]
    reached = {path}
    for file in near:
        near += [other for other in files if file in arrows[other] and other not in reached]
        reached.update(near)
    tests = os.path.join(ROOT, "tests")
    modules = [os.path.relpath(file, tests)[:-3] for file in near if "/test_" in file]
    # the one of its name comes first
    modules.sort(key="unit/test_{}".format(os.path.basename(path)[:-3]).__ne__)
    commands = [os.path.basename(file) for file in near if os.path.dirname(file) == os.path.join(ROOT, "bin")]
    written = sorted(
        os.listdir(os.path.join(ROOT, "tests", "commands")), key=lambda file: ("-" in file, file)
    )
    by_turns = itertools.zip_longest(
        *[
            [file for file in written if re.match(r"(%s(-.*)?\.t|test_%s\.py)$" % (name, name), file)]
            for name in commands
        ]
    )
    transcripts = ["commands/" + re.sub(r"\.py$", "", file) for turn in by_turns for file in turn if file]
    return modules, transcripts


PROBES = '''\
"""Write down what is entered: a line `file:line` for each function, once a process."""
import os

_entered = set()


def entered(place):
    if place not in _entered:
        _entered.add(place)
        file = os.open(%r, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o666)
        os.write(file, (place + "\\n").encode())
        os.close(file)
'''


class Probed:
    """While it lasts, the package in a copy of the checkout writes down which functions are entered."""

    def __init__(self, copy):
        self.package = os.path.join(copy, "rtshell_lite")
        self.aside = os.path.join(copy, ".rtshell_lite")
        self.file = os.path.join(copy, ".entered")
        shutil.copytree(self.package, self.aside)
        with open(os.path.join(self.aside, "probes.py"), "w") as file:
            file.write(PROBES % self.file)
        for path in glob.glob(os.path.join(glob.escape(self.aside), "**", "*.py"), recursive=True):
            inner = os.path.relpath(path, self.aside)
            if inner != "probes.py" and not inner.startswith("idl_stubs"):
                with open(path, "rb+") as file:
                    data = Source(file.read()).probed(
                        "__import__('rtshell_lite.probes').probes.entered('%s:%%d')" % inner
                    )
                    file.seek(0)
                    file.write(data)

    def __enter__(self):
        self._swap()
        return self

    def __exit__(self, *exception):
        self._swap()

    def _swap(self):
        os.rename(self.package, self.package + ".old")
        os.rename(self.aside, self.package)
        os.rename(self.package + ".old", self.aside)

    def entered(self):
        """What was entered since the last call: a set of `file:line`."""
        try:
            with open(self.file) as file:
                return set(file.read().split())
        except FileNotFoundError:
            return set()
        finally:
            with open(self.file, "w"):
                pass


class Tests:
    """The tests in a copy of the checkout, where a module can be changed."""

    def __init__(self, copy, python):
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".git", ".venv*", "__pycache__", ".*.tmp"))
        self.probed = Probed(copy)
        subprocess.call([python, "-m", "compileall", "-q", copy], stdout=subprocess.DEVNULL)
        sys.path.insert(0, os.path.join(copy, "tests", "support"))
        import runner  # of the copy: all that it starts is of the copy, too
        runner.hear_signals()
        self.copy = copy
        self.python = python
        self.runner = runner
        self.marker = runner.jobs.mark()
        self.environment = dict(os.environ, PYTHONPATH=copy, PYTHONDONTWRITEBYTECODE="1")
        self.limits = {}
        self.entered = {}
        self.killed = collections.Counter()

    def passes(self, name, limit):
        """Does a test pass within `limit` seconds?"""
        if name.endswith(".t"):
            path = os.path.join(self.copy, "tests", name)
            return self.runner.transcripts.run_case(path, "dash", self.python, time_limit=limit)[0] == "pass"
        found = self.runner.run_module(name, self.python, self.environment, [], limit)
        outcomes = [outcome for _, outcome, _ in found]
        return "pass" in outcomes and "fail" not in outcomes

    def try_out(self, name):
        """Learn the seconds that a test may take, None where it fails unspoilt, and what it enters. Nothing
        may be spoilt now.
        """
        with self.probed:
            begun = time.monotonic()
            passed = self.passes(name, 120)
            self.entered[name] = self.probed.entered() if passed else None
        if not passed:  # one that reads the source, say: the probes are in it
            begun = time.monotonic()
            passed = self.passes(name, 120)
        self.limits[name] = 3 * (time.monotonic() - begun) + 10 if passed else None
        if not passed:
            print("left out, as it fails unspoilt: " + name, flush=True)

    def concerned(self, names, place):
        """Those of the tests that enter a function, `file:line`, or None for what is outside of functions;
        the best first.
        """
        for name in sorted(
            names,
            key=lambda name: (name.endswith(".t"), (self.limits.get(name) or 30) / (1 + self.killed[name])),
        ):
            if name not in self.limits:
                self.try_out(name)
            if self.limits[name] and (not place or self.entered[name] is None or place in self.entered[name]):
                yield name

    def fails(self, name, path, data):
        """Does a test fail when the file at `path` is `data`?"""
        kept = self._replace(path, data)
        try:
            failed = not self.passes(name, self.limits[name])
        finally:
            self._replace(path, kept)
            self.runner.jobs.left_behind(self.marker)
        self.killed[name] += failed
        return failed

    @staticmethod
    def _replace(path, data):
        """Write a module; return what it was."""
        for compiled in glob.glob(
            os.path.join(os.path.dirname(path), "__pycache__", os.path.basename(path)[:-3] + ".*")
        ):
            os.remove(compiled)
        with open(path, "rb") as file:
            old = file.read()
        with open(path, "wb") as file:
            file.write(data)
        return old


def find_python():
    """A Python that has omniORBpy, or None."""
    for path in [sys.executable] + sorted(
        glob.glob(os.path.join(glob.escape(ROOT), ".venv-tests", "3.*", "bin", "python"))
    ):
        if not subprocess.call(
            [path, "-c", "import omniORB"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        ):
            return path
    return None


def options():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("module", nargs="+", help="a file below rtshell_lite, such as data/statistics.py")
    parser.add_argument("--seed", default="1", help="which places are chosen (1)")
    parser.add_argument("--most", type=int, default=40, metavar="N", help="places at most (40)")
    parser.add_argument("--tests", type=int, default=8, metavar="N", help="test modules of tests/unit at "
                                                                          "most (8)")
    parser.add_argument(
        "--transcripts",
        type=int,
        default=8,
        metavar="N",
        help="transcripts at most (8); they take their time",
    )
    args = parser.parse_args()
    for module in args.module:
        if not os.path.isfile(os.path.join(ROOT, "rtshell_lite", module)):
            parser.error("no such file below rtshell_lite: " + module)
    if sys.version_info < (3, 8):
        parser.error("needs Python 3.8: those before do not know where expressions end")
    return args


def spoil(module, tests, args):
    """Spoil a module, print what survived; how many did."""
    inner = os.path.join("rtshell_lite", module)
    with open(os.path.join(tests.copy, inner), "rb") as file:
        source = Source(file.read())
    places = sorted({place for place in mutations(source) if source.spoilt(*place)})
    chosen = sorted(random.Random(args.seed).sample(places, min(args.most, len(places))))
    modules, transcripts = covering(os.path.join(ROOT, inner))
    names = modules[:args.tests] + transcripts[:args.transcripts]
    print("%s, covered by: %s" % (module, " ".join(names)), flush=True)
    survived = 0
    for start, end, new in chosen:
        data = source.spoilt(start, end, new)
        function = source.function(start)
        tried = 0
        for name in tests.concerned(names, function and "%s:%d" % (module, function)):
            if tests.fails(name, os.path.join(tests.copy, inner), data):
                break
            tried += 1
        else:
            survived += 1
            line = source.data.count(b"\n", 0, start) + 1
            whole = source.data.splitlines()[line - 1].decode().strip()
            print("%s:%d: %r -> %r in: %s (seen by %d tests)" % (
                inner, line, source.data[start:end].decode(), new, whole, tried), flush=True)
    print("%s: %d of %d places spoilt, %d killed, %d survived" % (
        module, len(chosen), len(places), len(chosen) - survived, survived), flush=True)
    return survived


def main():
    args = options()
    python = find_python()
    if not python:
        sys.exit("mutate.py: no Python with omniORBpy is here; tests/run makes one")
    with tempfile.TemporaryDirectory(prefix="rt-mutate-") as directory:
        tests = Tests(os.path.join(directory, "copy"), python)
        return 1 if sum([spoil(module, tests, args) for module in args.module]) else 0


if __name__ == "__main__":
    sys.exit(main())
