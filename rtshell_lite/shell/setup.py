"""What the user's shell evaluates, `eval "$(rtcwd --shell bash)"`: a function that changes RTCSH_CWD, and completion.

The program prints a path and never shell code with a path in it: rtshell's export RTCSH_CWD="…", evaluated, ran the
command in a directory called $(command). For completion the shell gives the line up to the cursor, and gets back words that
are quoted for it already.
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
alias rtcwd 'setenv RTCSH_CWD "`\\rtcwd \\!*`"'
"""

FUNCTIONS = {"sh": _POSIX, "bash": _POSIX, "zsh": _POSIX, "fish": _FISH, "csh": _CSH}

# $2 is what readline replaces: the word from its last colon or equals sign on (COMP_WORDBREAKS), or from its quote on.
_COMPLETE_BASH = """\
_rtshell_lite() {
    local answers answer
    COMPREPLY=()
    answers=$(command rtcwd --shell=bash --line="${COMP_LINE:0:COMP_POINT}" --word="=$2" 2>/dev/null </dev/null)
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
    answers=("${(@f)$(command rtcwd --shell=zsh --line="$line" --word="=$IPREFIX$PREFIX" 2>/dev/null </dev/null)}")
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
    """What a shell evaluates at its start: its rtcwd and, if it can complete, completion of the `commands`."""
    completion = _COMPLETIONS.get(shell)
    return FUNCTIONS[shell] + (completion % " ".join(sorted(commands)) if completion else "")


# ---- words on a line that is being typed ----------------------------------------------------------------------

# `words` of the last command, the last of them unfinished; `quote` that it is in ('', ", ' or, behind a backslash, \);
# `open` True when the shell will make something else of the last word, which is not to be guessed.
Line = collections.namedtuple("Line", "words quote open redirected")

_BETWEEN_COMMANDS, _EXPANDED = ";|&()\n", "$`*?[{"


def split(line, fish=False):
    """Read an unfinished command line as the shell will, as far as quotes go: a Line."""
    words, quote, opened, redirected = [], "", False, False
    word = None  # type: str
    special = "$" if fish else "$`"  # within double quotes
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
            word = (word or "") + ("\\" if quote and c not in special + '"\\' else "") + c
        elif quote:
            quote = "" if c == '"' else quote
            word += c if quote else ""
            opened = opened or c in special
        elif c in "'\"":
            quote, word = c, word or ""
        elif c in " \t" + _BETWEEN_COMMANDS + "<>":
            if word is not None and not (c in "<>" and word.isdigit()) and not redirected:
                words.append(word)
            redirected = c in "<>" or redirected and word is None
            word, opened = None, False
            if c in _BETWEEN_COMMANDS:
                words, redirected = [], False
        else:
            word = (word or "") + c
            opened = opened or c in _EXPANDED
    return Line(words + [word or ""], quote, opened, redirected)


def answers(shell, line, found, typed):
    """The lines that complete a Line in a shell, for `found` (candidates: text, final, help); `typed` is what it replaces."""
    if shell == "fish":  # which quotes by itself, and puts a blank behind all but / : =
        more = [each.text + ":" for each in found if not each.final and each.text[-1] not in "/:="]
        return [f"{each.text}\t{each.help}" if each.help else each.text for each in found] + more
    written = []
    for text, final, _ in found:
        rest = _quoted(text[len(line.words[-1]):], line.quote)
        if line.quote != "\\" or rest.startswith("\\"):
            written.append(typed + rest[line.quote == "\\":] + (" " if final and line.quote in ("", "\\") else ""))
    return written


def _quoted(s, quote):
    """`s` as it is typed inside of such a quote, such that the shell takes every character for itself."""
    if quote == "'":
        return s.replace("'", "'\\''")
    if quote == '"':
        return re.sub(r'([$`"\\])', r"\\\1", s).replace("!", "\"'!'\"")
    return re.sub(r"([^\w@%+:,./-])", r"\\\1", s)
