rtcwd --shell prints a function for the shell to evaluate. It changes RTCSH_CWD, and only when rtcwd succeeds.

world: names
world: two --context test.host_cxt/$(touch${IFS}canary).cxt/%n.rtc,test.host_cxt/`touch${IFS}canary`.cxt/%n.rtc
world: two --context test.host_cxt/q"uo'te.cxt/%n.rtc,test.host_cxt/;touch${IFS}canary;.cxt/%n.rtc,test.host_cxt/-e.cxt/%n.rtc
world: two --context test.host_cxt/*?~[a].cxt/%n.rtc,test.host_cxt/b\ack\n.cxt/%n.rtc,test.host_cxt/%%s!.cxt/%n.rtc

  $ rtcwd --shell
  rtcwd() {
      case ${1-} in -h | --help | --version | --shell*) command rtcwd "$@"; return ;; esac
      _rtcwd=$(RTCWD_FUNCTION=1 command rtcwd "$@") && export RTCSH_CWD="$_rtcwd"
  }
  $ eval "$(rtcwd --shell)"
  $ rtcwd a.cxt
  $ echo $?
  0
  $ echo "$RTCSH_CWD"
  /localhost:$PORT/test.host_cxt/a.cxt
  $ rtcwd b.cxt
  $ rtpwd
  /localhost:$PORT/test.host_cxt/a.cxt/b.cxt
  $ rtls
  c.cxt/
  $ rtcwd ..; rtpwd
  /localhost:$PORT/test.host_cxt/a.cxt

A failure changes nothing, says why, and passes its status on:

  $ rtcwd nothing.cxt
  rtcwd: /localhost:$PORT/test.host_cxt/a.cxt/nothing.cxt: no such path
  [3]
  $ rtcwd Same0.rtc; rtpwd
  rtcwd: /localhost:$PORT/test.host_cxt/a.cxt/Same0.rtc: not a directory (it is a component)
  /localhost:$PORT/test.host_cxt/a.cxt
  $ rtcwd a b
  rtcwd: unrecognized arguments: b (see --help)
  [2]
  $ rtcwd /localhost:1 || echo "$? and still in $RTCSH_CWD"
  rtcwd: /localhost:1: connection refused; is the name server running?
  4 and still in /localhost:$PORT/test.host_cxt/a.cxt
  $ set -eu
  $ (unset RTCSH_CWD; rtcwd /localhost:$PORT; rtpwd)
  /localhost:$PORT
  $ rtcwd nothing.cxt || rtpwd
  rtcwd: /localhost:$PORT/test.host_cxt/a.cxt/nothing.cxt: no such path
  /localhost:$PORT/test.host_cxt/a.cxt
  $ set +eu

Options and questions go to the program:

  $ rtcwd --version
  1.0.0
  $ rtcwd --help | grep '^Change'
  Change the working directory in the RTC Tree.
  $ rtcwd --shell sh | head -n 1
  rtcwd() {
  $ rtcwd --timeout 20 ..; rtpwd
  /localhost:$PORT/test.host_cxt
  $ rtcwd -q a.cxt
  $ rtcwd
  $ rtpwd
  /
  $ rtcwd /localhost:$PORT/test.host_cxt; terminal 80 sh -c 'eval "$(rtcwd --shell)"; rtcwd a.cxt; rtpwd'
  /localhost:$PORT/test.host_cxt/a.cxt

Names that shells might trip over: each is gone to and come back from, and nothing is executed (rtshell's rtcwd
ran the command in a directory called $(touch canary)).

  $ rtls -0 | tr '\0' '\n' | grep '[.]cxt$' | grep -v '/[a-z]*[.]cxt$' >directories
  $ sed 's,.*/,,' directories
  $(touch${IFS}canary).cxt
  %s!.cxt
  *?~[a].cxt
  -e.cxt
  ;touch${IFS}canary;.cxt
  `touch${IFS}canary`.cxt
  b\\ack\\n.cxt
  q"uo'te.cxt
  $ cat >try <<'end'
  > eval "$(rtcwd --shell)"
  > count=0
  > while read -r directory; do
  >     rtcwd "$directory" || echo "lost: $directory"
  >     test "$RTCSH_CWD" = "$directory" || echo "astray: $RTCSH_CWD"
  >     rtcwd ..
  >     test "$RTCSH_CWD" = /localhost:$PORT/test.host_cxt || echo "not back: $RTCSH_CWD"
  >     count=$((count + 1))
  > done <directories
  > rtcwd nothing.cxt 2>error && echo "wrong status" || test $? = 3 || echo "wrong status"
  > test "$RTCSH_CWD" = /localhost:$PORT/test.host_cxt || echo "moved: $RTCSH_CWD"
  > rtcwd && test "$RTCSH_CWD" = / || echo "no root: $RTCSH_CWD"
  > echo "$count tried, $(ls | grep -c canary) canaries"
  > end
  $ dash -eu try
  8 tried, 0 canaries
  $ busybox ash -eu try
  8 tried, 0 canaries
  $ bash -eu try
  8 tried, 0 canaries
  $ bash --posix try
  8 tried, 0 canaries
  $ try() { if command -v $1 >/dev/null; then "$@"; else echo '8 tried, 0 canaries'; fi; }
  $ try mksh -eu try
  8 tried, 0 canaries
  $ try zsh -eu try
  8 tried, 0 canaries

Fish is another language. (Its function is tried where fish is installed.)

  $ cat >try.fish <<'end'
  > rtcwd --shell fish | source
  > set count 0
  > while read -l directory
  >     rtcwd $directory; or echo "lost: $directory"
  >     test $RTCSH_CWD = $directory; or echo "astray: $RTCSH_CWD"
  >     rtcwd ..; test $RTCSH_CWD = /localhost:$PORT/test.host_cxt; or echo "not back: $RTCSH_CWD"
  >     set count (math $count + 1)
  > end <directories
  > rtcwd nothing.cxt
  > test $status = 3; or echo "wrong status"
  > test $RTCSH_CWD = /localhost:$PORT/test.host_cxt; or echo "moved: $RTCSH_CWD"
  > echo "$count tried, "(ls | grep -c canary)" canaries"
  > end
  $ try fish try.fish 2>error
  8 tried, 0 canaries
  $ rtcwd --shell fish | head -n 1
  function rtcwd
  $ rtcwd --shell csh
  alias rtcwd 'set _rtcwd = "`\rtcwd \!*`" && setenv RTCSH_CWD "$_rtcwd"'
  $ rtcwd --shell zsh | head -n 1
  rtcwd() {
  $ rtcwd --shell bash | head -n 1
  rtcwd() {

So is csh. (Its alias is tried where tcsh or csh is installed.)

  $ cat >try.csh <<'end'
  > eval "`rtcwd --shell csh`"
  > rtcwd nothing.cxt
  > echo "$status in $RTCSH_CWD"
  > rtcwd a.cxt
  > echo "$status in $RTCSH_CWD"
  > end
  $ for shell in tcsh bsd-csh; do
  >     if command -v $shell >/dev/null; then
  >         $shell -f try.csh 2>error
  >     else
  >         printf '3 in %s\n0 in %s/a.cxt\n' "$RTCSH_CWD" "$RTCSH_CWD"
  >     fi
  > done
  3 in /localhost:$PORT/test.host_cxt
  0 in /localhost:$PORT/test.host_cxt/a.cxt
  3 in /localhost:$PORT/test.host_cxt
  0 in /localhost:$PORT/test.host_cxt/a.cxt
