"""Commands with verbs: if this fails, a line in somebody's script means another verb than it did, or a verb
takes an option that it does not have.
"""
import os
import unittest
from unittest import mock

from rtshell_lite import errors, options
from rtshell_lite.shell import installation

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

# lines without a verb, and the same lines with one
LINES = """    A:out                                             record A:out
    -f run.mcap -t 60 A:out.joints B:out              record -f run.mcap -t 60 A:out.joints B:out
    -f run.mcap -i -e 1000 A:out -l simpkl            record -f run.mcap -i -e 1000 A:out -l simpkl
    -if run.mcap --append A:out                       record -if run.mcap --append A:out
    --events --listen 0 --only *x --every 2 .  record --events --listen 0 --only *x --every 2 .
    --rotate 5M --keep 20 --leave 1G -f run.mcap .  record --rotate 5M --keep 20 --leave 1G -f run.mcap .
    --ring 10 --after 5 --trigger error -f run.mcap .  ring --last 10 --after 5 --trigger error -f run.mcap .
    --ring-size 1M -f run.mcap .                      ring --size 1M -f run.mcap .
    --ring 2 --in-memory -l mcap -t 6 A:out           ring --last 2 --in-memory -l mcap -t 6 A:out
    --trigger-now run.mcap                            ring --trigger-now run.mcap
    -p -f run.mcap A:in                               play -f run.mcap A:in
    -pf run.mcap A:in                                 play run.mcap A:in
    A:in --play --filename=run.mcap                   play --filename=run.mcap A:in
    -p run.mcap -r 0.5 -s 1 -e -1 -a -x 10 A:in       play run.mcap -r 0.5 -s 1 -e -1 -a -x 10 A:in
    -p -f run.mcap -n -r 2                            play -n -r 2 run.mcap
    -p --json -f run.mcap                             play --json run.mcap
    -p --csv --ns -f run.mcap                         play --csv --ns run.mcap
    -p -f run.mcap --map a=b --only x --linger 0 .    play run.mcap --map a=b --only x --linger 0 .
    -p -f run.mcap --as-components                    serve run.mcap
    -p -f run.mcap --as-components below --serve 1    serve run.mcap below --serve 1
    --as-components -p -f run.mcap --when-connected   serve -f run.mcap --when-connected
    -d -f run.mcap                                    show run.mcap
    -d --json run.mcap                                show --json run.mcap
    --display-info -f run.mcap -m Arm --path .        show -f run.mcap -m Arm --path .
    --json -f run.mcap -i -s 1 -e 2                   export --json run.mcap -i -s 1 -e 2
    --csv out -f run.mcap --ns                        export --csv run.mcap out --ns
    --attachment system-1.rtsys -f run.mcap           export run.mcap --attachment system-1.rtsys
    --mend run.mcap                                   mend run.mcap
    --mend=run.mcap -f out.mcap                       mend run.mcap -f out.mcap
    --mend run.mcap --in-place                        mend --in-place run.mcap
    -q -f play play                                   -q play -f play
    -f run.mcap ./play                                record -f run.mcap ./play
"""
# what had no effect, and still may be there, as scripts for rtshell have it
IN_VAIN = """
    -p -l simpkl -f run.mcap A:in                       play -f run.mcap A:in
    -d -l simpkl -t 5 -r 2 -x 3 -i -e 5 -s 1 -f run     show -f run
    --json -l text -r 2 -an -t 1 -f run                 export --json -f run
    -f run -r 2 -a -x 5 A:out                           record -f run A:out
    -p --as-components -l mcap -f run                   serve -f run
"""
REFUSED = """
    -d -p -f run            -d is for rtlog show, not for rtlog play
    show run -p             -p is for rtlog play and serve, not for rtlog show
    A:out -s 5              -s is for rtlog play, serve and export, not for rtlog record
    record A:out -s 5       -s is for rtlog play, serve and export, not for rtlog record
    show -l simpkl run      -l is for rtlog record and ring, not for rtlog show
    --trigger error A:out   --trigger is for rtlog ring, not for rtlog record
    --ring 5 --rotate 5 .   --rotate is for rtlog record, not for rtlog ring
    --ring 5 -l text .      argument -l/--logger: not one of mcap, simpkl: text
    play --as run           unrecognized arguments: --as
    -p --as -f run          unrecognized arguments: --as
    show one two            unrecognized arguments: two
"""


def pairs(table):
    for row in table.strip().splitlines():
        first, _, second = row.strip().partition("  ")
        yield first, second.strip()


class Rtlog(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.module = installation.load(os.path.join(ROOT, "bin", "rtlog"), "rtshell_lite command")

    def meaning(self, line):
        """What a command line has rtlog do: the function of its verb, and the values of its options."""
        args = options.parser(self.module.arguments, self.module.__doc__, "rtlog").parse_args(line.split())
        verb = args.verb
        known = {action.dest for action in options.parser(verb.arguments, verb.doc, "")._actions}
        given = {name: value for name, value in vars(args).items() if name in known}
        if "log" in given and verb is not self.module.VERBS["mend"]:
            rest = given.pop("targets", [given.pop("prefix", given.pop("directory", None))])
            given["rest"] = self.module._take_log(args, rest)
            given["filename"] = args.filename
            given.pop("log")
        return verb.run, given

    def test_lines_without_a_verb(self):
        for table in LINES, IN_VAIN:
            for line, named in pairs(table):
                with self.subTest(line):
                    self.assertEqual(self.meaning(line), self.meaning(named))

    def test_each_flag_has_a_line_here(self):
        flags = {flag.split("/")[0] for row, _ in self.module.FLAGS for flag in row.split()}
        there = {word for line, _ in pairs(LINES) for word in line.replace("=", " ").split()}
        self.assertEqual(sorted(flags - there), [])

    def test_whose_option_it_is(self):
        for line, why in pairs(REFUSED):
            with self.subTest(line), self.assertRaises(errors.Usage) as raised:
                self.meaning(line)
            self.assertEqual(str(raised.exception), why + " (see --help)")

    def test_a_verb_lists_its_options_only(self):
        top = options.parser(self.module.arguments, self.module.__doc__, "rtlog")
        shown = top.verbs.parser("show").format_help()
        self.assertIn("--json", shown)
        for option in ("--play", "-p,", "--ring", "--mend", "--rate", "--csv"):
            self.assertNotIn(option, shown)

    def test_the_help_fits_a_screen(self):
        with mock.patch.dict(os.environ, COLUMNS="80"):
            shown = options.parser(self.module.arguments, self.module.__doc__, "rtlog").format_help()
        self.assertLessEqual(len(shown.splitlines()), 24)
        for verb in self.module.VERBS:
            self.assertIn(f"\n  {verb} ", shown)


if __name__ == "__main__":
    unittest.main()
