"""IDL files in known directories: types and interfaces are found in them, whatever else is there."""
import contextlib
import os
import tempfile
import time
import unittest

from rtshell_lite import errors, notes
from rtshell_lite.giop import descriptors
from rtshell_lite.data import datatypes
from rtshell_lite.data.idl import library

SERVICE = "module M { struct Part { long a; }; interface Service { Part get(in string name); }; };"


class Told:
    """Hears what is remarked."""

    def __init__(self):
        self.lines = []

    def __call__(self, kind, what):
        self.lines.append((kind, str(what)))

    def of(self, kind):
        return [what for each, what in self.lines if each == kind]


class Tree:
    """A directory with files."""

    def __init__(self, path):
        self.path = path

    def write(self, name, text):
        path = os.path.join(self.path, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)
        return path


@contextlib.contextmanager
def tree(**texts):
    """A Tree that is RTSHELL_IDL and not the working directory."""
    before = os.getcwd(), os.environ.get(library.VARIABLE), notes.listener
    notes.listener = Told()
    with tempfile.TemporaryDirectory() as directory, tempfile.TemporaryDirectory() as elsewhere:
        os.chdir(elsewhere)
        os.environ[library.VARIABLE] = ":%s:/no/such/directory" % directory
        made = Tree(directory)
        for name, text in texts.items():
            made.write(name.replace("__", "/") + ".idl", text)
        try:
            yield made
        finally:
            os.chdir(before[0])
            notes.listener = before[2]
            os.environ.pop(library.VARIABLE)
            if before[1] is not None:
                os.environ[library.VARIABLE] = before[1]


class Search(unittest.TestCase):
    def test_an_interface_by_its_id(self):
        with tree(
            a__service=SERVICE, other="module M { interface Other { void Service(in long part); }; };"
        ) as made:
            interface = datatypes.Types().interface("IDL:M/Service:1.0")
            self.assertEqual([each.idl() for each in interface.operations], ["M::Part get(in string name);"])
            self.assertEqual(notes.listener.of(notes.DETAIL),
                             ["/no/such/directory: No such file or directory",
                              "IDL:M/Service:1.0 is read from %s/a/service.idl" % made.path])
            self.assertIsNone(datatypes.Types().interface("IDL:M/Missing:1.0"))
            self.assertIsNone(datatypes.Types().interface("IDL:N/Service:1.0"))
            self.assertIsNone(datatypes.Types().interface(""))

    def test_types_by_their_names(self):
        with tree(one="module A { struct S { long a; }; typedef sequence<S> Ss; }; module B { struct S "
                      "{ string b; }; enum E { X, Y }; };"):
            types = datatypes.Types()
            self.assertEqual(types.named("A.S").id, "IDL:A/S:1.0")
            self.assertEqual(types.named("IDL:B/S:1.0").name, "B.S")
            self.assertEqual(types.named("Ss").id, "IDL:A/Ss:1.0")
            self.assertEqual(types.named("B::E").id, "IDL:B/E:1.0")
            with self.assertRaisesRegex(errors.NoSuch, "it may be IDL:A/S:1.0 or IDL:B/S:1.0"):
                types.named("S")
            self.assertEqual(types.named("TimedLong").id, "IDL:RTC/TimedLong:1.0")

    def test_by_another_id(self):
        text = 'module M { interface Own { void go(); };\n#pragma ID Own "IDL:com.example/Own:3.1"\n};'
        with tree(one=text, two='#pragma prefix "org.example"\nmodule M { interface Own { void stop(); '
                                '}; };'):
            types = datatypes.Types()
            self.assertEqual(types.interface("IDL:com.example/Own:3.1").operations[0].name, "go")
            self.assertEqual(types.interface("IDL:org.example/M/Own:1.0").operations[0].name, "stop")

    def test_the_working_directory_alone(self):
        with tree() as made:
            os.environ.pop(library.VARIABLE)
            made.write("service.idl", SERVICE)
            made.write("below/more.idl", SERVICE.replace("Service", "More"))
            os.chdir(made.path)
            self.assertTrue(datatypes.Types().interface("IDL:M/Service:1.0"))
            self.assertIsNone(datatypes.Types().interface("IDL:M/More:1.0"))
            os.environ[library.VARIABLE] = os.path.join(made.path, "below", "more.idl")
            self.assertTrue(datatypes.Types().interface("IDL:M/More:1.0"))

    def test_a_named_file_comes_first(self):
        with tree(one=SERVICE) as made:
            own = made.write("own.txt", SERVICE.replace("get(", "fetch("))
            self.assertEqual(
                datatypes.Types(idl=[own]).interface("IDL:M/Service:1.0").operations[0].name, "fetch"
            )

    def test_one_name_in_many_files(self):
        texts = {
            "a%d" % number: "module M%d { interface Same { void in_%d(); }; };" % (number, number)
            for number in range(30)
        }
        with tree(z="module other { module M { interface Same { void here(); }; }; };", **texts):
            types = datatypes.Types()
            self.assertEqual(types.interface("IDL:other/M/Same:1.0").operations[0].name, "here")
            self.assertEqual(types.interface("IDL:M29/Same:1.0").operations[0].name, "in_29")
            self.assertIsNone(types.interface("IDL:Same:1.0"))
            self.assertIn("too many files may declare Same", notes.listener.of(notes.DETAIL)[-1])

    def test_includes(self):
        with tree(package__idl__service='#include "package/idl/part.idl"\n#include <BasicDataType.idl>\n'
                                        "module M { interface Service { Part get(in RTC::Time t); }; };",
                  package__idl__part="#include <other/deep.idl>\nmodule M { struct Part { Deep a; }; };",
                  x__other__deep="module M { struct Deep { long a; }; };"):
            given = datatypes.Types().interface("IDL:M/Service:1.0").operations[0]
            self.assertEqual(descriptors.words(given.result), "Part")

    def test_only_files_with_a_named_type_are_parsed(self):
        """Nothing, while no type of it is named; then the files are searched, and those that declare it are
        parsed.
        """
        texts = {"a%d" % number: SERVICE.replace("M", "M%d" % number) for number in range(50)}
        read = []
        parsed = []
        own = library._text, library.parser.read_file

        def text(path, *rest):
            read.append(path)
            return own[0](path, *rest)

        def read_file(path, *rest):
            parsed.append(os.path.basename(path))
            return own[1](path, *rest)
        library._text = text
        library.parser.read_file = read_file
        try:
            with tree(b="module N { interface Other { void Service(in long part); }; };", **texts) as made:
                types = datatypes.Types().load()
                types.named("TimedLong")
                types.interface("IDL:omg.org/RTC/PortService:1.0")
                self.assertEqual([path for path in read if path.startswith(made.path)], [])
                del parsed[:]
                self.assertTrue(types.interface("IDL:N/Other:1.0"))
                self.assertEqual(
                    (len([path for path in read if path.startswith(made.path)]), parsed), (51, ["b.idl"])
                )
        finally:
            library._text, library.parser.read_file = own

    def test_component_s_own(self):
        interface = datatypes.Types().interface("IDL:omg.org/RTC/PortService:1.0")
        self.assertIn("RTC::ReturnCode_t connect(inout RTC::ConnectorProfile connector_profile);",
                      [each.idl() for each in interface.operations])


class Hostile(unittest.TestCase):
    def test_pipes_links_and_loops_are_skipped(self):
        with tree(service=SERVICE) as made:
            os.mkfifo(os.path.join(made.path, "a.idl"))
            os.symlink("/dev/zero", os.path.join(made.path, "b.idl"))
            os.symlink("nothing", os.path.join(made.path, "c.idl"))
            os.symlink("d.idl", os.path.join(made.path, "d.idl"))
            os.symlink(".", os.path.join(made.path, "loop"))
            os.symlink(made.path, os.path.join(made.path, "again"))
            os.mkdir(os.path.join(made.path, "e.idl"))
            made.write("b0.idl", "\0module M { interface Service {" * 1000)
            self.assertTrue(datatypes.Types().interface("IDL:M/Service:1.0"))
            texts = library.Library(library.roots()).texts()
            self.assertEqual(
                sorted(os.path.basename(path) for path, text in texts.items() if text),
                ["b0.idl", "service.idl"],
            )
            self.assertTrue([line for line in notes.listener.of(notes.DETAIL) if "b0.idl:1:1" in line])

    def test_one_that_is_broken(self):
        with tree(service=SERVICE.replace("long a", "lnog a")) as made:
            types = datatypes.Types()
            self.assertIsNone(types.interface("IDL:M/Service:1.0"))
            with self.assertRaisesRegex(
                errors.NoSuch, r"M.Part: .*service.idl:1:\d+: not declared: lnog; name its IDL file"
            ):
                types.named("M.Part")
            made.write("z.idl", SERVICE)
            self.assertTrue(datatypes.Types().interface("IDL:M/Service:1.0"))

    def test_many(self):
        with tree(
            **{
                "a%d" % number: SERVICE.replace("Part", "Part%d" % number).replace("Service", "S%d" % number)
                for number in range(60)
            }
        ):
            self.assertTrue(datatypes.Types().interface("IDL:M/S59:1.0"))
            before = library.MOST_FILES, library.LARGEST, library.CANDIDATES
            try:
                library.MOST_FILES = 20
                self.assertLessEqual(len(library.Library(library.roots()).texts()), 22)
                self.assertIn("too many files", notes.listener.of(notes.NOTE)[-1])
                library.MOST_FILES = before[0]
                library.LARGEST = 1000
                self.assertLess(len(library.Library(library.roots()).texts()), 20)
                self.assertIn("too many IDL files", notes.listener.of(notes.NOTE)[-1])
            finally:
                library.MOST_FILES, library.LARGEST, library.CANDIDATES = before

    def test_typedefs_that_never_end(self):
        with tree(long="typedef " * 400000 + " Service", service=SERVICE):
            begun = time.process_time()
            self.assertTrue(datatypes.Types().interface("IDL:M/Service:1.0"))
            self.assertIsNone(datatypes.Types().interface("IDL:N/Service:1.0"))
            self.assertLess(time.process_time() - begun, 10)

    def test_includes_that_never_end(self):
        with tree(one='#include "two.idl"\ninterface Service {};', two='#include "one.idl"\n'):
            self.assertIsNone(datatypes.Types().interface("IDL:Service:1.0"))
            self.assertIn("includes too many files", " ".join(notes.listener.of(notes.DETAIL)))

    def test_an_interface_that_inherits_deeply(self):
        text = "interface I0 { void a(); };" + "".join(
            "interface I%d : I%d {};" % (i + 1, i) for i in range(3000)
        )
        with tree(deep=text):
            self.assertEqual(list(datatypes.Types().interface("IDL:I3000:1.0").all_operations()), ["a"])


if __name__ == "__main__":
    unittest.main()
