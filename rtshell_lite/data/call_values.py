"""Arguments of an operation as people write them, and what it returns as text and JSON.

An argument is written as rtinject reads values, a constant or JSON; a text, an item of an enum and a
reference need no quotes. Everything is checked against the IDL before anything is sent.
"""


from rtshell_lite import errors, text
from rtshell_lite.giop import descriptors
from rtshell_lite.giop.descriptors import CHAR, ENUM, OBJECT, STRING, WCHAR, WSTRING
from rtshell_lite.net import loop

TEXTS = (STRING, WSTRING, CHAR, WCHAR)
RESULT = "result"  # the key of what an operation returns, beside its out parameters


# ---- arguments ----


def of_words(operation, words, find):
    """The values of an Operation's in and inout parameters, in their order, from words that are positional or
    NAME=VALUE. `find(name)` gives the descriptor of a type. Raises BadValue, Usage, NoSuch.
    """
    inputs = operation.inputs()
    written = {}
    position = 0
    for word in words:
        name, equals, rest = word.partition("=")
        if equals and text.is_identifier(name):
            parameter = _parameter(operation, name)
            word = rest
        elif position < len(inputs):
            parameter = inputs[position]
            position += 1
        else:
            raise errors.Usage(_too_many(operation, words))
        if parameter.name in written:
            raise errors.Usage(f"{operation.shown}: {parameter.name} is given twice")
        written[parameter.name] = _parsed(parameter.type, word)
    return _built(operation, written, find)


def of_json(operation, given, find):
    """The same from a text, a JSON object of all arguments."""
    import json
    from rtshell_lite.data import build_value

    try:
        written = json.loads(
            given, parse_constant=lambda word: build_value.NUMBERS[word], parse_float=build_value.real
        )
    except (ValueError, RecursionError) as e:
        raise errors.BadValue(operation.shown, f"not JSON ({e})")
    if not isinstance(written, dict):
        raise errors.BadValue(operation.shown, "not a JSON object of its arguments, {…}")
    return _built(
        operation, {_parameter(operation, name).name: (value, True) for name, value in written.items()}, find
    )


def of_line(operation, line, find):
    """The same from a line of JSON: the value of the only argument, or an array or an object of all; nothing
    for an operation without any.
    """
    import re  # takes long, as most modules that are imported in functions here

    inputs = operation.inputs()
    if not line.strip():
        return _built(operation, {}, find)
    if len(inputs) == 1 and not re.match(r'\s*\{\s*"%s"\s*:' % inputs[0].name, line):
        return _built(operation, {inputs[0].name: _parsed(inputs[0].type, line.strip())}, find)
    if line.lstrip()[:1] == "[":
        from rtshell_lite.data import literals

        return of_values(operation, literals.parse(line)[0], {}, find)
    return of_json(operation, line, find)


def of_values(operation, values, named, find):
    """The same from values of a program, positional and by name."""
    inputs = operation.inputs()
    if len(values) > len(inputs):
        raise errors.Usage(_too_many(operation, values))
    written = {parameter.name: (value, False) for parameter, value in zip(inputs, values)}
    for name, value in named.items():
        parameter = _parameter(operation, name)
        if parameter.name in written:
            raise errors.Usage(f"{operation.shown}: {parameter.name} is given twice")
        written[parameter.name] = (value, False)
    return _built(operation, written, find)


def _parameter(operation, name):
    inputs = operation.inputs()
    for parameter in inputs:
        if parameter.name == name:
            return parameter
    names = [parameter.name for parameter in inputs]
    if name in [parameter.name for parameter in operation.parameters]:
        why = f"{name} is an out parameter: it is not given"
    elif names:
        why = f"no parameter {text.printable(name)}{text.candidates(name, names)}"
    else:
        why = f"it takes no arguments, not {text.printable(name)}"
    raise errors.BadValue(operation.shown, why)


def _too_many(operation, words):
    if operation.name.startswith("_get_"):
        return f"{operation.shown} is an attribute: {operation.shown}=VALUE sets it"
    names = ", ".join(parameter.name for parameter in operation.inputs())
    if not names:
        return f"{operation.shown} takes no arguments"
    takes = f"{operation.shown} takes {text.counted(len(operation.inputs()), 'argument')}"
    return f"{takes} ({names}), not {len(words)}"


def _parsed(descriptor, word):
    """(what a word says, whether as JSON) for a type."""
    kind = descriptors.kind(descriptors.target(descriptor))
    word = text.typed(word)
    if kind in TEXTS and word[:1] not in ('"', "'"):
        return word, False
    if kind == ENUM and text.is_identifier(word):
        from rtshell_lite.data import build_value

        return build_value.Word(word), False
    if kind == OBJECT and word[:4].upper() == "IOR:":
        return word, False
    try:
        return int(word), False  # most are numbers: the module json need not be imported
    except ValueError:
        from rtshell_lite.data import literals

        return literals.parse(word)


def _built(operation, written, find):
    """The values in the order of the parameters."""
    missing = [parameter.name for parameter in operation.inputs() if parameter.name not in written]
    if missing:
        raise errors.BadValue(operation.shown, f"{missing[0]} is missing: {operation.idl()}")
    if not written:
        return []
    from rtshell_lite.data import build_value

    now = divmod(int(loop.wall() * 1e9), 10**9)
    values = []
    for parameter in operation.inputs():
        value, is_json = written[parameter.name]
        where = f"{operation.name}: {parameter.name}"
        if operation.shown == parameter.name:  # of an attribute
            where = parameter.name
        values.append(build_value.build(parameter.type, value, where, is_json, now, find))
    return values


# ---- results ----


def as_dict(operation, value):
    """What a call has returned as {"result": …, name of an out parameter: …}, for text.json_line."""
    from rtshell_lite.data import values

    return {name: values.json(part) for name, part in _parts(operation, value)}


def as_text(operation, value, dump=text.json_line):
    """What a call has returned for people, None for nothing: a text as it is, another single value as JSON or
    a number, several as an object. `dump` makes JSON of a value.
    """
    parts = _parts(operation, value)
    if not parts:
        return None
    if len(parts) > 1:
        return dump(as_dict(operation, value))
    part = parts[0][1]
    if isinstance(part, str):
        return part
    if isinstance(part, (int, float)) and not isinstance(part, bool):
        return str(part)
    from rtshell_lite.data import values

    plain = values.json(part)
    return plain if isinstance(plain, str) else dump(plain)


def _parts(operation, value):
    """[(name, value)] of what a call has returned."""
    names = [parameter.name for parameter in operation.outputs()]
    if operation.result is not None and RESULT in names:
        names.insert(0, "_" + RESULT)
    elif operation.result is not None:
        names.insert(0, RESULT)
    if operation.oneway or not names:
        return []
    if len(names) == 1:
        return [(names[0], value)]
    return list(zip(names, value))


def exception(e):
    """An errors.Raised as {"exception": name, "members": {…}}, for text.json_line."""
    from rtshell_lite.data import values

    return {"exception": e.name, "members": values.json(e.value)}


def shown_exception(e):
    """An errors.Raised whose message has the members of the exception."""
    from rtshell_lite.data import values

    members = [
        f"{name}={part!r}" if isinstance(part, str) else f"{name}={values.text(part)}"
        for name, part in vars(e.value).items()
    ]
    shown = f"({', '.join(members)})" if members else ""
    return errors.Raised(e.where, e.name, e.value, shown)


def command(where, operation, values, options):
    """The rtcall command that calls an Operation with these values; `options` are words of it."""
    from rtshell_lite.data import values as data_values

    words = ["rtcall"] + list(options) + [where, operation.name]
    inputs = operation.inputs()
    if inputs:
        written = {parameter.name: data_values.json(value) for parameter, value in zip(inputs, values)}
        words += ["-d", text.json_line(written)]
    return " ".join(map(text.shell_word, words))
