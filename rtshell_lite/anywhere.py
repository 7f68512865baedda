"""`python3 -m rtshell_lite`: commands that are not on PATH, and putting them there."""

import sys

from rtshell_lite import cli, errors, text
from rtshell_lite.shell import installation


DEMO = """Play a robot on this machine: a mobile arm of twelve components.

They have a name server of their own, at a TCP port of 127.0.0.1, and are true components for all commands:
activate, configure, connect and disturb them. All of it is in memory, and gone at Ctrl-C. What to try is
printed at the start.
"""


PAPERS = """\
to read
  man 7 rtshell_lite: paths, options, environment, exit statuses, scripts
  docs/ of the repository: install paths trouble recording seeing keeping scripts
    library reference differences figures stability"""


def main(doc):
    """Run the command that the first argument names, or follow the module's own options; `doc` is
    its help.
    """
    sys.argv[0] = "rtshell_lite"
    words = sys.argv[1:]
    try:
        command = words and installation.command(words[0])
        if words[:1] in (["-h"], ["--help"]):
            doc += "\ncommands:\n" + "\n".join(installation.summaries())
    except (errors.Error, OSError) as e:
        sys.exit(cli.complain(e))
    if words[:1] == ["demo"]:
        sys.argv = ["rtshell_lite demo"] + words[1:]
        cli.main(_demo_arguments, _play_demo, DEMO)
    elif command:
        sys.argv = words
        installation.load(command, "__main__")
    else:
        cli.main(arguments, run, doc)


def arguments(parser):
    """Declare the options."""
    parser.option("--unpack DIR", "lay out the commands, and what they import, under DIR")
    parser.option("[WHEEL ...]", "more wheels to lay out there, such as omniORBpy's", dest="words")


def run(args):
    """Do what the options ask for."""
    if args.unpack is not None:
        _unpack(args.unpack, args.words)
    elif args.words:
        name = args.words[0]
        raise errors.Usage(f"{name}: no such command{text.near(name, installation.commands())}")
    else:
        lines = ["commands (COMMAND --help says more):"] + installation.summaries()
        print("\n".join(lines + [PAPERS]))


def _unpack(directory, wheels):
    """Lay the commands and these wheels out under a directory, and print the line that puts them on PATH."""
    from rtshell_lite.shell.unpack import unpack

    if ":" in directory:
        raise errors.Usage(f"{directory}: cannot be in PATH")
    print(f"export PATH={text.quoted(unpack(directory, wheels))}:$PATH")


# ---- the demo ----


def _demo_arguments(parser):
    parser.option("--port PORT", "TCP port of its name server (default: a free one)", default=0, type=_port)


def _port(word):
    if not word.isdecimal() or int(word) > 65535:
        raise errors.Usage(f"{word}: is no TCP port")
    return int(word)


async def _play_demo(args):
    from rtshell_lite.play import demo

    await demo.play(args.port, cli.write)
