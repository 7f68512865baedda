"""Logs that somebody has made to do harm: they are refused, or read, within bounds."""
import json
import tracemalloc
import unittest

from rtshell_lite.datalog import blocks, logfile
from test_datalog import Case, LONG, messages, as_read


class Hostile(Case):
    def frame(self, kind, value):
        return blocks.text(kind, value)

    def header(self, **changes):
        value = {"created": 1, "channels": [{"name": "a", "type": LONG, "typecode": None, "sources": []}]}
        return blocks.MAGIC + self.frame(blocks.HEADER, dict(value, **changes))

    def refused(self, data):
        self.put(data)
        tracemalloc.start()
        try:
            return self.read() is None
        finally:
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            self.assertLess(peak, 20 << 20)

    def test_headers(self):
        nested = b"".join(blocks.frame(blocks.HEADER, b"[" * 100000))
        bad = [{"channels": 1}, {"channels": [1]}, {"channels": [{}]}, {"created": "x"}, {"created": None},
               {"created": True}, {"created": 10 ** 400},
               {"channels": [{"name": 1, "type": LONG, "typecode": None, "sources": []}]},
               {"channels": [{"name": "a", "type": LONG, "typecode": "xy", "sources": []}]},
               {"channels": [{"name": "a", "type": LONG, "typecode": None, "sources": [["x"]]}]},
               {"channels": [{"name": "%d" % i, "type": LONG, "typecode": None, "sources": []} for i in range(1001)]}]
        for data in [b"", blocks.MAGIC, b"text", blocks.MAGIC + nested, blocks.MAGIC + self.frame(blocks.HEADER, [])] + \
                [self.header(**each) for each in bad]:
            self.assertTrue(self.refused(data), data[:80])
        self.assertFalse(self.refused(self.header()))

    def test_lengths(self):
        """A length is not believed: nothing is allocated for it."""
        for length in (1 << 20, 1 << 28, (1 << 32) - 1):
            self.refused(blocks.MAGIC + blocks.BLOCK.pack(blocks.HEADER, length, 0) + b"x")
            self.refused(self.header() + blocks.BLOCK.pack(blocks.RECORD, length, 0) + b"x" * 1000)

    def test_records(self):
        good = b"".join(blocks.entry(0, 1, 0, True, b"x"))
        short = b"".join(blocks.frame(blocks.RECORD, b"x"))
        for record in (b"".join(blocks.entry(1, 1, 9, True, b"")), short, b"".join(blocks.entry(0, 1, 0, True, b"")),
                       b"".join(blocks.entry((1 << 64) - 1, 1, 0, True, b"")), b"".join(blocks.frame(b"X", b""))):
            self.put(self.header() + good + record)
            log, found = self.read()
            self.assertEqual(([entry.number for entry in found], log.torn), ([0], len(record)))

    def test_indexes(self):
        """Whatever an index says, all records are found."""
        written = messages(5)
        body = self.write(written, close=False)
        true = json.loads(writer_index(self.name))
        points = true["points"]
        lies = [{"next": 9}, {"next": "5"}, {"next": None}, {"last": 1}, {"points": []}, {"points": [[0, 0, None]]},
                {"points": 7}, {"points": [[1] + points[0][1:]]}, {"points": [[0, 1 << 80, None]]},
                {"points": [[0, -1, None]]}, {"points": points + points}, {"headers": []}, {"headers": [8, 9]},
                {"headers": [8, 1 << 70]}, {"headers": "ab"},
                {"counts": {"a": 1.5, "b": 3.5}}, {"counts": {"a": 50}}, {"counts": [5]}, {"first": "x"}, {"first": 10 ** 400},
                {"headers": [8, 8]}]
        for lie in lies:
            index = blocks.text(blocks.INDEX, dict(true, **lie), len(body))
            self.put(body + index)
            log, found = self.read()
            self.assertEqual(found, as_read(written), lie)
            self.assertFalse(log.closed, lie)
        for position in (0, 8, len(body) - 1, len(body) + 1, (1 << 64) - 1):
            self.put(body + blocks.text(blocks.INDEX, true, position))
            self.assertEqual(self.read()[1], as_read(written), position)
        self.put(body + b"".join(blocks.frame(blocks.INDEX, b"[" * 100000 + blocks.FOOTER.pack(len(body), b"rtlogend"))))
        self.assertEqual(self.read()[1], as_read(written))


def writer_index(name):
    """The JSON of the index that belongs to a file without one."""
    with logfile.load(name) as log:
        return log.index.block(0)[blocks.BLOCK.size:-blocks.FOOTER.size].decode()


if __name__ == "__main__":
    unittest.main()
