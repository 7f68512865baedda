"""What the user's shell evaluates, `eval "$(rtcwd --shell bash)"`: a function that changes RTCSH_CWD, and
completion.

rtcwd prints a path, never shell code with a path in it: rtshell's export RTCSH_CWD="…", evaluated, ran the
command in a directory called $(command). For completion the shell passes the line up to the cursor, and gets
words that are quoted for it.
"""

import collections
import re

_POSIX = """\
rtcwd() {
    case ${1-} in -h | --help | --version | --shell*) command rtcwd "$@"; return ;; esac
    _rtcwd=$(RTCWD_FUNCTION=1 command rtcwd "$@") && export RTCSH_CWD="$_rtcwd"
}
"""

_FISH = """\
function rtcwd
    switch "$argv[1]"
        case -h --help --version '--shell*'
            command rtcwd $argv
            return
    end
    set -l path (RTCWD_FUNCTION=1 command rtcwd $argv)
    or return
    set -gx RTCSH_CWD $path
end
"""

_CSH = """\
alias rtcwd 'set _rtcwd = "`\\rtcwd \\!*`" && setenv RTCSH_CWD "$_rtcwd"'
"""

FUNCTIONS = {"sh": _POSIX, "bash": _POSIX, "zsh": _POSIX, "fish": _FISH, "csh": _CSH}

# $2 is what readline replaces: the word from its last colon or equals sign on (COMP_WORDBREAKS), or from its
# quote on.
_COMPLETE_BASH = """\
_rtshell_lite() {
    local answers answer
    COMPREPLY=()
    local line=${COMP_LINE:0:COMP_POINT}
    answers=$(command rtcwd --shell=bash --line="$line" --word="=$2" 2>/dev/null </dev/null)
    while IFS= read -r answer; do
        [ -n "$answer" ] && COMPREPLY+=("$answer")
    done <<<"$answers"
}
complete -o nospace -F _rtshell_lite %s
"""

_COMPLETE_ZSH = """\
_rtshell_lite() {
    local line="${(j: :)words[1,CURRENT-1]} $QIPREFIX$IPREFIX$PREFIX"
    local -a answers
    local word="=$IPREFIX$PREFIX"
    answers=("${(@f)$(command rtcwd --shell=zsh --line="$line" --word="$word" 2>/dev/null </dev/null)}")
    [[ -n "$answers" ]] && compadd -Q -U -S '' -- "${answers[@]}"
}
if [[ -o interactive ]]; then
    (( $+functions[compdef] )) || { autoload -Uz compinit && compinit -D -i; }
    compdef _rtshell_lite %s
fi
"""

_COMPLETE_FISH = """\
function __rtshell_lite
    command rtcwd --shell=fish --line=(commandline -cp | string collect) 2>/dev/null </dev/null
end
for name in %s
    complete -c $name -f -a '(__rtshell_lite)'
end
"""

_COMPLETIONS = {"bash": _COMPLETE_BASH, "zsh": _COMPLETE_ZSH, "fish": _COMPLETE_FISH}


def code(shell, commands):
    """The code for a shell: its function rtcwd and, for most shells, completion of the `commands`."""
    if shell not in _COMPLETIONS:
        return FUNCTIONS[shell]
    return FUNCTIONS[shell] + _COMPLETIONS[shell] % " ".join(sorted(commands))


# ---- words on a line that is being typed ----

# The `words` of the last command, of which the last one is unfinished; the `quote` that it is in: '', ", '
# or, after a backslash, \; `open`: it will be expanded by the shell; `redirected`: it is a file after < or >.
Line = collections.namedtuple("Line", "words quote open redirected")

_BETWEEN_COMMANDS = ";|&()\n"
_EXPANDED = "$`?[{"  # a * is one of our own patterns: nothing local is offered for it


def split(line, fish=False):
    """The Line of an unfinished command line, by the shell's rules of quoting."""
    words = []
    quote = ""
    opened = False
    redirected = False
    word = None  # type: str
    # within double quotes
    special = "$" if fish else "$`"
    rest = iter(line)
    for c in rest:
        if quote == "'":
            if c == "'":
                quote = ""
            elif fish and c == "\\":
                word += next(rest, "")
            else:
                word += c
        elif c == "\\":
            c = next(rest, None)
            if c is None:
                return Line(words + [word or ""], "\\", opened or bool(quote), redirected)
            word = word or ""
            if quote and c not in special + '"\\':
                word += "\\"
            word += c
        elif quote:
            if c == '"':
                quote = ""
            if quote:
                word += c
            opened = opened or c in special
        elif c in "'\"":
            quote = c
            word = word or ""
        elif c in " \t" + _BETWEEN_COMMANDS + "<>":
            is_descriptor = word is not None and c in "<>" and word.isdigit()
            if word is not None and not is_descriptor and not redirected:
                words.append(word)
            redirected = c in "<>" or redirected and word is None
            word = None
            opened = False
            if c in _BETWEEN_COMMANDS:
                words = []
                redirected = False
        else:
            word = (word or "") + c
            opened = opened or c in _EXPANDED
    return Line(words + [word or ""], quote, opened, redirected)


def answers(shell, line, candidates, typed):
    """The lines that complete a Line in a shell, for candidates (text, final, help);
    `typed` is what they replace.
    """
    if shell == "fish":
        return _answers_for_fish(candidates)
    written = []
    for text, final, _ in candidates:
        rest = _quoted(text[len(line.words[-1]) :], line.quote)
        if line.quote == "\\":
            if not rest.startswith("\\"):
                continue
            rest = rest[1:]
        end = " " if final and line.quote in ("", "\\") else ""
        written.append(typed + rest + end)
    return written


def _answers_for_fish(candidates):
    """fish quotes by itself, and adds a blank after all but / : ="""
    written = [text + "\t" + help if help else text for text, _, help in candidates]
    return written + [text + ":" for text, final, _ in candidates if not final and text[-1] not in "/:="]


def _quoted(s, quote):
    """`s` as it is typed inside such a quote, with every special character escaped."""
    if quote == "'":
        return s.replace("'", "'\\''")
    if quote == '"':
        return re.sub(r'([$`"\\])', r"\\\1", s).replace("!", "\"'!'\"")
    return re.sub(r"([^\w@%+:,./-])", r"\\\1", s)
