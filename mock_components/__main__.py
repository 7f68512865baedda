"""`python3 -m mock_components WORLD [ARGUMENT …]`: start a world; `… ctl PATH COMMAND …`: talk to a running
one.
"""
import argparse
import os
import signal
import sys
import threading


def arguments():
    """The parser of the command that starts a world."""
    parser = argparse.ArgumentParser(
        prog="python3 -m mock_components", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Start a world of mock components; it ends with its standard input, SIGTERM or SIGINT.",
        epilog="python3 -m mock_components ctl PATH help     what a running world can be asked")
    parser.add_argument("world", nargs="?", help="see --list")
    parser.add_argument("arguments", nargs="*", help="of the world")
    parser.add_argument("--list", action="store_true", help="list the worlds")
    parser.add_argument("--nameserver", metavar="HOST:PORT", help="default: first of "
                                                                  "RTCTREE_NAMESERVERS, else localhost")
    parser.add_argument(
        "--context",
        metavar="FORMAT",
        default="test.host_cxt/%n.rtc",
        help="names to bind, like naming.formats of OpenRTM (default: %(default)s)".replace("%n", "%%n"),
    )
    parser.add_argument("--port", type=int, default=0, help="IIOP port (default: any)")
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on (default: %(default)s)")
    parser.add_argument("--publish", metavar="HOST", help="address in references (with --port; "
                                                          "default: that of --host)")
    parser.add_argument("--control", metavar="PATH", default=os.environ.get("MOCK_CONTROL"),
                        help="Unix socket for ctl (default: MOCK_CONTROL)")
    parser.add_argument("--flavour", default="py2", help="cpp11, cpp12, cpp2, py2 (default), java, rtorb")
    parser.add_argument("--rate", type=float, default=1000.0, help="of execution contexts, in Hz "
                                                                   "(default: 1000)")
    parser.add_argument("--async", dest="sync", action="store_false", help="transitions answer at once")
    return parser


def listed():
    """(name, help) of each world, read from the source, as to import it needs omniORB."""
    import ast
    for file in "worlds.py", "deployment.py", "ailments.py":
        with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), file), encoding="utf-8") as source:
            tree = ast.parse(source.read())
        docs = {node.name: ast.get_docstring(node) for node in tree.body if isinstance(node, ast.FunctionDef)}
        for node in tree.body:
            # {world.__name__: world for world in (…)}
            if isinstance(node, ast.Assign) and node.targets[0].id == "WORLDS":
                yield from ((name.id, docs[name.id]) for name in node.value.generators[0].iter.elts)
            elif (
                isinstance(node, ast.Expr)
                and isinstance(node.value, ast.Call)
                and isinstance(node.value.args[0], ast.Dict)
            ):
                named = node.value.args[0]
                yield from (
                    (ast.literal_eval(name), docs[world.id]) for name, world in zip(named.keys, named.values)
                )


class Options:
    """Options for components; worlds override some."""

    def __init__(self, **values):
        self.__dict__.update(values)

    def but(self, **changes):
        return Options(**dict(self.__dict__, **changes))


def main(argv):
    """Start a world, or talk to one; returns the exit status."""
    if argv[:1] == ["ctl"]:
        from . import asking
        if len(argv) < 3 or argv[2] == "help":
            print(asking.HELP)
            return 0 if argv[2:] else 2
        return asking.ask(argv[1], argv[2:])
    parser = arguments()
    args = parser.parse_args(argv)
    if args.list:
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # | head
        print("\n".join(f"{name:10} " + words.replace("\n", "\n    ") for name, words in listed()))
        return 0
    try:
        import omniORB  # noqa: F401
    except ImportError:
        parser.error("needs omniORBpy (for Python 3.7 to 3.13)")
    from . import flavour, worlds
    if args.world not in worlds.WORLDS:
        parser.error(f"no such world: {args.world} (see --list)")
    if args.flavour not in flavour.NAMES:
        parser.error("no such flavour: " + args.flavour)
    return play(args, worlds, flavour.Flavour(args.flavour))


def play(args, worlds, flavour):
    """Set up the world, print `ready`, and stay until asked to end."""
    from . import control, naming, process, stage as staging
    here = process.Process(args.port, args.host, args.publish)
    here.ledger.own_thread()
    server = args.nameserver or os.environ.get("RTCTREE_NAMESERVERS", "localhost").split(";")[0]
    options = Options(context=args.context, rate=args.rate, sync=args.sync, contexts=1, running=True,
                      arguments={}, control=args.control, consumers=None, size=0, fate="")
    stage = staging.Stage(here, naming.Naming(here, server), flavour, options)
    for number in (signal.SIGTERM, signal.SIGINT):
        # On a thread of its own: the handler may run while this one holds the lock of the event.
        signal.signal(number, lambda *_: threading.Thread(target=stage.finish.set).start())
    try:
        worlds.WORLDS[args.world](stage, *args.arguments)
        here.ledger.reset()
        if args.control:
            here.thread(control.serve(args.control, control.Commands(stage)))
        print("ready", len(stage.components), *stage.ready, flush=True)
        if stage.after_ready:
            stage.after_ready()
        threading.Thread(target=wait_for_end_of_input, args=(stage.finish,), daemon=True).start()
        stage.finish.wait()
    finally:
        stage.end()
    if args.control:
        control.forget(args.control)
    sys.stdout.flush()
    os._exit(0)


def wait_for_end_of_input(finish):
    """Set the event `finish` when standard input ends: the parent process has ended."""
    while os.read(0, 4096):
        pass
    finish.set()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
