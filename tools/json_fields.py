"""The fields of the JSON of all commands as one text, docs/json-fields.txt: review sees its changes."""

from rtshell_lite import options
from rtshell_lite.shell import installation

HEAD = """Every field that commands print with --json, as their helps and manual pages have them.
Written by python3 -m tools.documentation; the tests compare it with the helps, and these with transcripts.
"""


def text():
    """The text of docs/json-fields.txt."""
    parts = [HEAD]
    for name, path in sorted(installation.commands().items()):
        module = installation.load(path, "rtshell_lite command")
        parser = options.parser(module.arguments, module.__doc__, name)
        helps = {name: module.__doc__}
        if parser.verbs is not None:
            helps = {f"{name} {verb}": one.doc for verb, one in parser.verbs.by_name.items()}
        for title, doc in helps.items():
            fields = doc.partition("\nJSON:\n")[2].partition("\nexamples:\n")[0]
            if fields:
                parts.append(f"{title}\n{fields.strip()}\n")
    return "\n".join(parts)
