"""What the user's shell evaluates: `eval "$(rtcwd --shell)"` defines a function that changes RTCSH_CWD.

The program prints a path and never shell code with a path in it: rtshell's export RTCSH_CWD="…", evaluated, ran the
command in a directory called $(command).
"""

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
