rtdoctor names a directory that is bound by several names, or belongs to another name server, and calls none of them stale.

server: another
world: aliased localhost:$PORT2
world: zombie 1 --nameserver localhost:$PORT2

  $ doctor() { rtdoctor "$@" |
  > grep -v -e ' here: ' -e 'to be looked at' -e 'ok    .*answers' -e 'Inactive'; }
  $ doctor
  warn  /localhost:$PORT/test.host_cxt/again.cxt/Inner0.rtc: somebody else's name: this component calls itself test.host_cxt/Inner0.rtc; try: restart it, so that it binds its own name; do not delete this one: no other leads to it
  ok    /localhost:$PORT/test.host_cxt/again.cxt/loop.cxt: an alias: the same directory as /localhost:$PORT/test.host_cxt/again.cxt
  ok    /localhost:$PORT/test.host_cxt/far0.cxt: an alias: a directory of the name server at localhost:$PORT2, which is examined by: rtdoctor localhost:$PORT2
  ok    /localhost:$PORT/test.host_cxt/real.cxt: an alias: the same directory as /localhost:$PORT/test.host_cxt/again.cxt
  ok    /localhost:$PORT/test.host_cxt/top.cxt: an alias: the same directory as /localhost:$PORT
  $ doctor --json | grep alias | head -1
  {"cause": "", "check": "context", "level": "ok", "message": "an alias: the same directory as /localhost:$PORT/test.host_cxt/again.cxt", "path": "/localhost:$PORT/test.host_cxt/again.cxt/loop.cxt", "remedy": ""}

What is only empty, or dead, behind several names is nobody's to delete:

  $ rtdel -f again.cxt/Inner0.rtc
  $ doctor -q
  [1]
  $ doctor -q again.cxt
  [1]
  $ doctor -q real.cxt
  [1]
  $ doctor far0.cxt
  ok    /localhost:$PORT/test.host_cxt/far0.cxt: an alias: a directory of the name server at localhost:$PORT2, which is examined by: rtdoctor localhost:$PORT2
  $ doctor far0.cxt/test.host_cxt
  ok    /localhost:$PORT/test.host_cxt/far0.cxt: an alias: a directory of the name server at localhost:$PORT2, which is examined by: rtdoctor localhost:$PORT2
  $ doctor far0.cxt/test.host_cxt/Mock0.rtc
  ok    /localhost:$PORT/test.host_cxt/far0.cxt: an alias: a directory of the name server at localhost:$PORT2, which is examined by: rtdoctor localhost:$PORT2
  $ doctor -q localhost:$PORT2
  fail  /localhost:$PORT2/test.host_cxt/Mock0.rtc: dead (zombie): nothing listens at 127.0.0.1:*; try: rtdel -z /localhost:$PORT2/test.host_cxt/Mock0.rtc (glob)
  warn  /localhost:$PORT2/test.host_cxt: stale: only dead names are in it; try: when the dead names in it are deleted it is empty; then: rtdel /localhost:$PORT2/test.host_cxt

With the last but one name gone it is what it was:

  $ rtdel -q real.cxt/loop.cxt
  $ doctor -q
  [1]
  $ doctor -q again.cxt real.cxt
  [1]
  $ doctor -q real.cxt
  [1]
  $ rtdel -q again.cxt; doctor -q
  warn  /localhost:$PORT/test.host_cxt/real.cxt: stale: empty; try: rtdel /localhost:$PORT/test.host_cxt/real.cxt
  $ rtdel -f real.cxt; doctor
  ok    /localhost:$PORT/test.host_cxt/far0.cxt: an alias: a directory of the name server at localhost:$PORT2, which is examined by: rtdoctor localhost:$PORT2
  ok    /localhost:$PORT/test.host_cxt/top.cxt: an alias: the same directory as /localhost:$PORT
