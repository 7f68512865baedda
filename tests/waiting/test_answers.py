"""Answers that are made to harm who reads them: if one of these fails, a peer ends our process, or fills its
memory.

omniORB dies of what these peers send (SIGSEGV), so commands are run, and what they leave is looked at.
RTSHELL_ORB=omniorb tries our own ORB, which reads some of it otherwise.
"""
import binascii
import os
import tempfile
import unittest

import running
from mock_components import faulty, giop, malice
from rtshell_lite import errors
from rtshell_lite.corba import stubs
from rtshell_lite.giop import descriptors, idl, ior

try:
    import omniORB
except ImportError:
    omniORB = None


TYPE = b"IDL:RTC/X:1.0\0"
TIMEOUT = "3"

ALONE = "it measures times"
ONCE = "how long a peer is waited for does not depend on the Python"
BOTH = "each ORB reads answers in its own way"
IS_BUILTIN = os.environ.get("RTSHELL_ORB") != "omniorb"


def run(*words):
    """The running.Ran of a command."""
    with tempfile.TemporaryDirectory() as directory:
        return running.run(list(words), directory, RTSHELL_TIMEOUT=TIMEOUT)


class Commands(unittest.TestCase):
    def peer(self, mode):
        peer = faulty.Peer(mode)
        self.addCleanup(peer.close)
        return "/127.0.0.1:%d" % peer.port

    def says(self, mode, status, said, *words):
        """Check the single line that a command reports; returns what it prints."""
        server = self.peer(mode)
        words = [word.replace("SERVER", server) for word in words]
        ran = run(*words)
        err = ran.err.decode().splitlines()
        self.assertEqual((ran.status, len(err)), (status, 1), err)
        self.assertIn(said.replace("SERVER", server), err[0])
        return ran.out.decode()

    def test_a_reference_that_ends_omniorb_costs_its_own_line(self):
        for mode, why in (
            ("bad-type", "a reference whose type is not text"),
            ("bad-profiles", "a reference of 10000 profiles"),
            ("bad-body", "an unusable reference"),
        ):
            with self.subTest(mode):
                self.says(mode, 4, "SERVER/Evil0.rtc: garbled answer (%s)" % why, "rtcat", "SERVER/Evil0.rtc")
                self.assertIn("?Evil0.rtc", self.says(mode, 4, "1 of 1 did not answer", "rtls", "SERVER"))
                self.says(mode, 5, "SERVER/Evil0.rtc: garbled", "rtfind", "SERVER")
                self.says(mode, 4, "SERVER/Evil0.rtc: garbled", "rttop", "-n", "1", "SERVER")

    def test_in_other_places(self):
        self.says("bad-iterator", 4, "SERVER: garbled answer (a reference", "rtls", "SERVER")
        status, said = (4, "garbled answer (a reference") if IS_BUILTIN else (3, "no such path")
        self.says("bad-exception", status, "SERVER/Evil0.rtc: " + said, "rtcat", "SERVER/Evil0.rtc")
        self.says(
            "bad-ports", 4, "SERVER/Evil0.rtc: garbled answer (a reference", "rtcat", "SERVER/Evil0.rtc"
        )
        self.says(
            "bad-owner",
            4,
            "SERVER/Evil0.rtc: garbled answer (a reference",
            "rtcat",
            "-ll",
            "SERVER/Evil0.rtc",
        )

    def test_values_inside_values(self):
        where, nested = ("", "types inside types") if IS_BUILTIN else ("deep: ", "values inside values")
        for mode, what in (("any-in-any", "values inside values"), ("deep-value", nested)):
            self.says(
                mode,
                4,
                "SERVER/Evil0.rtc: garbled answer (%s%s, deeper than 64)" % (where, what),
                "rtcat",
                "SERVER/Evil0.rtc",
            )

    def test_references_left_out_are_reported(self):
        for mode, said, words in (
            ("endless", "names are taken; its list of them does not end", ["rtfind", "SERVER", "-n", "x"]),
            (
                "endless-nothing",
                "only its first 1 names are taken; its list of them does not end",
                ["rtls", "SERVER"],
            ),
            ("many-ports", "19000 of 20000 ports are left out", ["rtls", "-l", "SERVER"]),
            ("many-ends", "19984 of 20000 ends of a connector are left out", ["rtls", "-l", "SERVER"]),
            (
                "megabytes",
                "1 of 2 names are left out: they are longer than 131072 characters",
                ["rtls", "SERVER"],
            ),
        ):
            with self.subTest(mode):
                self.assertLess(len(self.says(mode, 5, said, *words)), 1 << 20)

    def test_long_names_without_end(self):
        self.says(
            "endless-long",
            5,
            "only its first 151 names are taken; its list of them does not end",
            "rtls",
            "SERVER",
        )

    def test_a_name_listed_again_is_the_same_name(self):
        lines = self.says(
            "endless", 5, "only its first 50000 names are taken", "rtfind", "SERVER"
        ).splitlines()
        self.assertEqual(len(lines), len(set(lines)))

    def test_contexts_in_contexts_without_end(self):
        """They were listed for ever."""
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        more = "SERVER: more is below it than is taken (50000 names, 8 MB of paths, 10 s)"
        log = os.path.join(directory.name, "x.mcap")
        late = "SERVER: what is below it could not be listed within 1s"
        for status, said, limit, *words in (
            (5, more, 10, "rtls", "-R", "--timeout", "0.5", "SERVER"),
            (4, late, 1, "rtlog", "-t", "1", "-f", log, "SERVER"),
            (1, "not deleted", 10, "rtdel", "--recursive", "--timeout", "0.5", "SERVER/a.host_cxt"),
        ):
            with self.subTest(words[0]):
                server = self.peer("branching")
                ran = run(*[word.replace("SERVER", server) for word in words])
                self.assertEqual(ran.status, status, ran)
                self.assertIn(said.replace("SERVER", server), ran.err.decode().splitlines()[-1])
                self.assertLess(ran.seconds, limit + 5)

    @unittest.skipIf(IS_BUILTIN, "the builtin ORB refuses the answer: see the next test")
    def test_long_texts_are_cut(self):
        server = self.peer("megabytes")
        ran = run("rtcat", "-l", server + "/Evil0.rtc")
        self.assertEqual((ran.status, ran.err), (0, b""))
        self.assertLess(len(ran.out), 10000)
        self.assertIn("M… (%d more characters)" % (len(malice.MEGABYTES) - 1000), ran.out.decode())

    @unittest.skipUnless(IS_BUILTIN, "omniORB takes them")
    def test_answers_of_megabytes_without_data_are_refused(self):
        self.says("megabytes", 4, "SERVER/Evil0.rtc: garbled answer (", "rtcat", "-l", "SERVER/Evil0.rtc")


class References(unittest.TestCase):
    PROFILE = (0, b"\1\1\2\0" + giop.cdr(b"host") + b"\0\x39\x05" + giop.cdr(giop.sequence(b"key"), 0))

    def test_valid_references_are_unchanged(self):
        for profiles in ([self.PROFILE], [self.PROFILE] * 3, [(1, b""), (0x41545401, b"x"), self.PROFILE]):
            for type_id in (TYPE, b"\0", b"", "IDL:日本:1.0\0".encode()):
                data = ior.octets(type_id, profiles)
                text = "IOR:" + binascii.hexlify(b"\1\0\0\0" + data).decode()
                self.assertEqual(ior.checked(text), text)
                self.assertEqual(ior.address(text)[1:], ("host", 1337, b"key"))
        self.assertEqual(ior.octets(b"\0", []), b"")

    def test_a_reference_without_an_address_has_none(self):
        elsewhere = "IOR:" + binascii.hexlify(b"\1\0\0\0" + ior.octets(TYPE, [(1, b"x")])).decode()
        self.assertEqual(
            (ior.address(elsewhere), ior.addresses(elsewhere)), ((TYPE[:-1].decode(), "", 0, b""), [])
        )
        cut = elsewhere[:-8]
        self.assertEqual((ior.address(cut), ior.addresses(cut)), (("", "", 0, b""), []))

    def test_invalid_references_are_refused(self):
        for type_id in (b"IDL:\xff:1.0\0", b"no end", b"a\0b\0", b"x" * 2000 + b"\0", b"\xed\xa0\x80\0"):
            with self.subTest(type_id), self.assertRaisesRegex(ValueError, "whose type is not text"):
                ior.octets(type_id, [self.PROFILE])
        with self.assertRaisesRegex(ValueError, "of 10000 profiles"):
            ior.octets(TYPE, [self.PROFILE] * 10000)
        for profiles in ([(0, b"x" * 100000)], [(0, b"x" * 10000)] * 10):
            with self.assertRaisesRegex(ValueError, "of 100000 octets"):
                ior.octets(TYPE, profiles)

    def test_texts_that_are_no_references(self):
        whole = binascii.hexlify(b"\1\0\0\0" + ior.octets(TYPE, [self.PROFILE])).decode()
        nil = "IOR:01000000" + "01000000" + "00000000" + "00000000"
        for text in [
            nil,
            "",
            "IOR:",
            "IOR:0",
            "IOR:zz",
            "IOR:é",
            "corbaname::evil",
            "corbaloc::evil:1/x",
            "IOR:" + "00" * 100000,
        ] + ["IOR:" + whole[:size] for size in range(0, len(whole) - 2, 2)]:
            with self.subTest(text[:80]), self.assertRaises(ValueError):
                ior.checked(text)


@unittest.skipIf(omniORB is None, "omniORBpy is not installed")
class Descriptors(unittest.TestCase):
    def operations(self):
        for type_id in idl.INTERFACES:
            for above in idl.ancestry(type_id):
                yield from ((stubs.interface(type_id), operation) for operation in idl.INTERFACES[above][1])

    def test_no_operation_can_return_a_reference_that_is_not_looked_at(self):
        from rtshell_lite.corba import answers

        def kinds(found):
            return {descriptors.kind(inner) for each in found for _, inner in descriptors.walk(each, "")}
        count = 0
        for objref, operation in self.operations():
            plain = stubs.operation(objref._NP_RepositoryId, operation)
            results = list(plain[1] or ()) + [
                part for each in (plain[2] or {}).values() for part in each[5::2]
            ]
            guarded = answers._guarded(objref, operation)
            if descriptors.OBJECT not in kinds(results):
                continue
            count += 1
            with self.subTest("%s.%s" % (objref.__name__, operation)):
                safe = list(guarded[1]) + [
                    part for each in (guarded[2] or {}).values() for part in each[5::2]
                ]
                self.assertNotIn(descriptors.OBJECT, kinds(safe))
        self.assertGreater(count, 30)


class Messages(unittest.TestCase):
    def test_where_and_why(self):
        self.assertEqual(
            (str(errors.Garbled("/a", "b")), errors.Garbled.status), ("/a: garbled answer (b)", 4)
        )


if __name__ == "__main__":
    unittest.main()
