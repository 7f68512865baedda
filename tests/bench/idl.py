"""What a tree of IDL files in RTSHELL_IDL costs: CPU where no type of it is named, and where one is looked
for.

`python3 tests/bench/idl.py [FILES]`: medians of some runs for each.
"""
import os
import statistics
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ROUNDS = 9
FIND = """
import sys, time
from rtshell_lite.data import datatypes
begun = time.process_time()
types = datatypes.Types().load()
%s
print(time.process_time() - begun)
"""
CASES = [("no type of it is named", "types.named('TimedLong'); "
                                    "types.interface('IDL:omg.org/RTC/PortService:1.0')"),
         ("an interface is found", "assert types.interface('IDL:M%(last)d/Service%(last)d:1.0').operations"),
         ("a type is found by its short name", "types.named('S%(last)d')"),
         ("nothing is found", "assert types.interface('IDL:M/Missing:1.0') is None")]


def grow(directory, count):
    """Write `count` IDL files as robots have them: types, exceptions, twenty operations."""
    for number in range(count):
        place = os.path.join(directory, "package%d" % (number // 10), "idl")
        os.makedirs(place, exist_ok=True)
        operations = "".join("    boolean call%d(in string name, in S%d s, out "
                             "sequence<double> d) raises (Refused);\n" % (each, number)
                             for each in range(20))
        types = "".join(
            "  struct S%d_%d { RTC::Time tm; string name; sequence<double> data; };\n" % (number, each)
            for each in range(10)
        )
        with open(os.path.join(place, "service%d.idl" % number), "w") as file:
            file.write(
                "#include <BasicDataType.idl>\nmodule M%d {\n  exception Refused { string why; };\n%s  typedef S%d_0 S%d;\n"  # noqa: E501
                "  interface Service%d {\n%s  };\n};\n" % (number, types, number, number, number, operations)
            )


def measured(code, directory):
    """Median milliseconds of CPU."""
    environment = dict(os.environ, RTSHELL_IDL=directory, PYTHONPATH=ROOT)
    return 1000 * statistics.median(
        float(subprocess.check_output([sys.executable, "-c", FIND % code], env=environment))
        for _ in range(ROUNDS)
    )


def main(count):
    with tempfile.TemporaryDirectory() as directory:
        grow(directory, count)
        empty = os.path.join(directory, "package0", "idl", "service0.idl")
        for words, code in CASES:
            code = code % {"last": count - 1}
            if "found" in words and "nothing" not in words:
                print("%-36s %6.1f ms with %d files" % (words, measured(code, directory), count))
            else:
                print(
                    "%-36s %6.1f ms with %d files, %.1f with one"
                    % (words, measured(code, directory), count, measured(code, empty))
                )


if __name__ == "__main__":
    main(int((sys.argv[1:] or ["500"])[0]))
