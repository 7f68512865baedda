# What every transcript may call: shell functions, read before its first step, under each shell. What takes
# more than a little shell is a command of tools.py.

# soon CONDITION: wait until a command line succeeds; complain after half a minute.
soon() {
    _tries=0
    until eval "$1" >/dev/null 2>&1; do
        _tries=$((_tries + 1))
        [ $_tries -gt 600 ] && echo "never: $1" && return
        sleep 0.05
    done
}

# said FILE…: what rtkeep and others have said, without times, process numbers, and where the names are.
said() {
    sed 's/^\[[0-9:]*\] //; s,/localhost:[0-9]*/test.host_cxt/,,g' "$@" |
        sed 's/pid [0-9]*/pid N/; s/20[-0-9]* [0-9:]*/T/g'
}

# plain FILE…: lines of rtwatch and rtvlog without their times, and without addresses.
plain() {
    sed 's/[0-9]*\.[0-9]\{6\}\]/T]/; s/"time": [0-9.]*/"time": T/; s/ at [0-9.]*:[0-9]*;/ at HOST:PORT;/' "$@"
}

# watched COMPONENT: wait until it has an observer.
watched() {
    soon "ctl observers $1 | grep Observer"
}

# has FILE WORD…: say which words are not in a file.
has() {
    _file=$1
    shift
    for _word; do
        grep -q -e "$_word" "$_file" || echo "no $_word"
    done
}

# Conditions of an RtsProfile: `plan CONDITION…` puts them into one, for Activation; `plan -d` for Deactivation.
plan() {
    _list=Activation
    [ "$1" = -d ] && _list=Deactivation && shift
    sed "s|</rts:RtsProfile>|<rts:$_list>$*</rts:$_list></rts:RtsProfile>|"
}

# when SEQUENCE COMPONENT [CONDITION]: one target.
when() {
    _target="rts:componentId=\"$2\" rts:instanceName=\"$2\" rts:id=\"0\""
    echo "<rts:targets rts:sequence=\"$1\">$3<rts:TargetComponent $_target/></rts:targets>"
}

# waiting MILLISECONDS
waiting() {
    echo "<rts:WaitTime rts:waitTime=\"$1\"/>"
}

# preceding TIMING TIMEOUT COMPONENT
preceding() {
    _first="rts:componentId=\"$3\" rts:instanceName=\"$3\" rts:id=\"0\""
    _first="<rts:PrecedingComponents $_first/>"
    echo "<rts:Preceding rts:sendingTiming=\"$1\" rts:timeout=\"$2\">$_first</rts:Preceding>"
}

# listens PORT: the addresses at which somebody listens on it, in hexadecimal as the kernel has them.
listens() {
    _line='$4 == "0A" && index($2, port) {print substr($2, 1, 8)}'
    awk -v port=":$(printf %04X $1)" "$_line" /proc/net/tcp /proc/net/tcp6 | sort -u
}

# A BusyBox that prefers its applets to what is in PATH, as Debian's busybox-static does: the statuses and the
# words of these are not those that transcripts show.
if [ "$(command -v cat)" = cat ]; then
    for _name in cat grep ls setsid timeout xargs; do
        eval "$_name() { /usr/bin/env $_name \"\$@\"; }"
    done
fi
