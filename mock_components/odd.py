"""Names in a name server that are hard to print, type or interpret."""
from .serviceport import MyService

JAPANESE = "日本語".encode("utf-8").decode("latin-1")      # bytes travel as Latin-1 characters

# (id, kind), each bound to a component of its own
NAMES = [
    ("sl/ash", "rtc"),
    ("co:lon", "rtc"),
    ("do.t", "rtc"),
    ("back\\slash", "rtc"),
    ("sp ace", "rtc"),
    ("-l", "rtc"),
    (".", "rtc"),
    ("..", "rtc"),
    ("tab\tnew\nline", "rtc"),
    ("esc\x1b[31mred", "rtc"),
    ("csi\x9b31m", "rtc"),
    ("bell\x07del\x7f", "rtc"),
    ("$(id);'\"*", "rtc"),
    (JAPANESE, "rtc"),
    ("bad\xff\xfe", "rtc"),
    ("rtl\u202ecba".encode("utf-8").decode("latin-1"), "rtc"),
    ("x" * 250, "rtc"),
    ("", "rtc"),
    ("nokind", ""),
    ("", ""),
    ("kind/slash", "r/tc"),
    ("kinddot", "r.tc"),
]
MANY = 300


def bind(stage):
    """Below the home context; the contexts made stay when the world ends, as they do with OpenRTM."""
    home = stage.home()
    for number, name in enumerate(NAMES):
        stage.add("Mock", name[0] or "empty%d" % number, names=[home + [name]])
    twin = stage.add("Mock", "Twin0", names=[home + [("Twin0", "rtc")], home + [("Twin0again", "rtc")]])
    stranger = stage.process.serve(MyService(), "stranger")
    stage.names.bind(home + [("NotAComponent0", "rtc")], stranger)
    stage.names.bind(home + [("NotAManager0", "mgr")], stranger)
    stage.names.bind(home + [("Thing0", "obj")], stranger)
    stage.names.bind(home + [("Gone0", "rtc")], stage.process.ghost(twin._NP_RepositoryId))
    stage.names.bind(home + [("Nil0", "rtc")], None)
    stage.names.bind_context(home + [("loop", "cxt")], stage.names.contexts(home))
    stage.names.contexts(home + [("empty", "cxt")])
    stage.add("Mock", "Deep0", names=[home + [("a", "cxt"), ("b", "cxt"), ("c", "cxt"), ("Deep0", "rtc")]])
    stage.add("Mock", "Same0", names=[home + [("Same0", "rtc")], home + [("a", "cxt"), ("Same0", "rtc")]])
    for number in range(MANY):
        stage.names.bind(home + [("many", "cxt"), ("Name%03d" % number, "rtc")], twin.reference)
