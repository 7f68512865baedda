"""Run a command of rtshell_lite from a checkout, an installation or straight from a wheel file.

  python3 -m rtshell_lite COMMAND [ARGUMENT ...]
  python3 -m rtshell_lite --unpack DIR [WHEEL ...]

For a robot without pip, copy the wheel (and one of omniORBpy) there, then:
  PYTHONPATH=rtshell_lite-0.1.0-py3-none-any.whl python3 -m rtshell_lite rtls -l
  PYTHONPATH=rtshell_lite-0.1.0-py3-none-any.whl python3 -m rtshell_lite --unpack /opt/rtshell
  jeteve_omniorb-*.whl
"""

import sys

# `python3 -m` looks for modules in the working directory first, even for those of Python itself; what is
# there may be anybody's. What Python has imported before it comes here cannot be helped (README, "Install").
if (
    __name__ == "__main__"
    and not sys.flags.isolated
    and not getattr(sys.flags, "safe_path", False)
    and sys.path
):
    del sys.path[0]

from rtshell_lite import start

start.quietly(__name__)

from rtshell_lite import cli, errors, text
from rtshell_lite.shell import installation


def arguments(parser):
    parser.add_argument(
        "--unpack", metavar="DIR", help="lay out the commands, and what they import, under DIR"
    )
    parser.add_argument(
        "words", nargs="*", metavar="WHEEL", help="more wheels to lay out there, such as omniORBpy's"
    )


def run(args):
    if args.unpack is not None:
        return unpack(args.unpack, args.words)
    if args.words:
        raise errors.Usage(unknown(args.words[0]))
    print("\n".join(["commands (COMMAND --help says more):"] + installation.summaries()))


def unpack(directory, wheels):
    """Lay the commands and these wheels out under a directory, and print the line that puts them on PATH."""
    from rtshell_lite.shell.unpack import unpack

    if not directory or ":" in directory:
        raise errors.Usage(f"{directory or repr('')}: cannot be in PATH")
    print(f"export PATH={text.quoted(unpack(directory, wheels))}:$PATH")


def unknown(name):
    """The message for an unknown command."""
    return f"{name}: no such command{text.near(name, installation.commands())}"


def run_command(path, words):
    """Become that command, as if the shell had started it."""
    sys.argv = [path] + words
    installation.load(path, "__main__")


def main():
    """Run the command that the first argument names, or follow this module's own options."""
    sys.argv[0] = "rtshell_lite"
    words = sys.argv[1:]
    try:
        command = words and installation.commands().get(words[0])
        if words[:1] in (["-h"], ["--help"]):
            doc = __doc__ + "\ncommands:\n" + "\n".join(installation.summaries())
        else:
            doc = __doc__
    except (errors.Error, OSError) as e:
        sys.exit(cli.complain(e))
    if command:
        run_command(command, words[1:])
    else:
        cli.main(arguments, run, doc)


if __name__ == "__main__":
    main()
