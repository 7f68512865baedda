"""JSON for people: on one line where that fits, else a member a line, and numbers side by side."""

import json

from rtshell_lite import text

STEP = "  "  # of indentation


def shown(value, width, indent="", used=0):
    """A value for json.dumps as text of lines within `width` columns, as far as its parts allow; of the
    first, `used` are taken. The lines after it begin with `indent`.
    """
    line = _line(value)
    if len(indent) + used + len(line) < width or not value or not isinstance(value, (dict, list)):
        return line
    inner = indent + STEP
    if isinstance(value, dict):
        members = [(_line(name) + ": ", part) for name, part in value.items()]
        parts = [head + shown(part, width, inner, len(head)) for head, part in members]
        return f"{{\n{inner}" + f",\n{inner}".join(parts) + f"\n{indent}}}"
    parts = [shown(part, width, inner) for part in value]
    if not any(isinstance(part, (dict, list)) for part in value):
        parts = _filled(parts, width - len(inner))
    return f"[\n{inner}" + f",\n{inner}".join(parts) + f"\n{indent}]"


def _line(value):
    line = json.dumps(value, ensure_ascii=False)
    return line if text.is_plain(line) else json.dumps(value)


def _filled(parts, width):
    """Words with commas between them, as many a line as fit."""
    rows = [parts[0]]
    for part in parts[1:]:
        if len(rows[-1]) + len(part) + 3 <= width:
            rows[-1] += ", " + part
        else:
            rows.append(part)
    return rows
