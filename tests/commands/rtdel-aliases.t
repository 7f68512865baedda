A directory that is bound by several names is somebody's, whatever the name: rtdel takes away names, and never what stays.

server: another
world: aliased localhost:$PORT2
world: two --nameserver localhost:$PORT2

Another name, of the directory itself, of one above, of the name server, of another name server: only that name goes, without
--recursive, too.

  $ rtdel real.cxt/loop.cxt
  rtdel: /localhost:$PORT/test.host_cxt/real.cxt/loop.cxt: another name of /localhost:$PORT/test.host_cxt/again.cxt; only this name is deleted
  $ rtdel --recursive real.cxt
  rtdel: /localhost:$PORT/test.host_cxt/real.cxt: another name of /localhost:$PORT/test.host_cxt/again.cxt; only this name is deleted
  $ rtdel --recursive --dry-run top.cxt
  rtdel: /localhost:$PORT/test.host_cxt/top.cxt: another name of /localhost:$PORT; only this name is deleted
  rtdel /localhost:$PORT/test.host_cxt/top.cxt
  $ rtdel -v --recursive top.cxt
  rtdel: /localhost:$PORT/test.host_cxt/top.cxt: another name of /localhost:$PORT; only this name is deleted
  rtdel: /localhost:$PORT/test.host_cxt/top.cxt: deleted
  $ rtdel -q --recursive far0.cxt
  $ rtls
  again.cxt/
  $ rtls again.cxt
  Inner0.rtc
  $ rtls /localhost:$PORT2/test.host_cxt
  ConsoleIn0.rtc
  ConsoleOut0.rtc

The last name takes all with it:

  $ rtdel again.cxt
  rtdel: /localhost:$PORT/test.host_cxt/again.cxt: not empty (1 name); delete it with --recursive
  [1]
  $ rtdel -v --recursive again.cxt
  rtdel: /localhost:$PORT/test.host_cxt/again.cxt/Inner0.rtc: deleted
  rtdel: /localhost:$PORT/test.host_cxt/again.cxt: deleted

What is below a directory that goes, and is bound elsewhere, stays:

  $ mock aliased localhost:$PORT2 --context deep.host_cxt/one.cxt/%n.rtc
  $ one=/localhost:$PORT/deep.host_cxt/one.cxt
  $ rtdel -v --recursive $one 2>&1
  rtdel: /localhost:$PORT/deep.host_cxt/one.cxt/far0.cxt: a directory of the name server at localhost:$PORT2; only this name is deleted
  rtdel: /localhost:$PORT/deep.host_cxt/one.cxt/top.cxt: another name of /localhost:$PORT; only this name is deleted
  rtdel: /localhost:$PORT/deep.host_cxt/one.cxt/again.cxt/Inner0.rtc: deleted
  rtdel: /localhost:$PORT/deep.host_cxt/one.cxt/again.cxt/loop.cxt: deleted
  rtdel: /localhost:$PORT/deep.host_cxt/one.cxt/again.cxt: deleted
  rtdel: /localhost:$PORT/deep.host_cxt/one.cxt/far0.cxt: deleted
  rtdel: /localhost:$PORT/deep.host_cxt/one.cxt/real.cxt: deleted
  rtdel: /localhost:$PORT/deep.host_cxt/one.cxt/top.cxt: deleted
  rtdel: /localhost:$PORT/deep.host_cxt/one.cxt: deleted
  $ rtls -R /localhost:$PORT2
  .:
  test.host_cxt/

  ./test.host_cxt:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
   (esc)

Inside itself, and twice inside what goes, is not elsewhere:

  $ mock aliased --context deep.host_cxt/two.cxt/%n.rtc
  $ rtdel --recursive --dry-run /localhost:$PORT/deep.host_cxt/two.cxt
  rtdel: /localhost:$PORT/deep.host_cxt/two.cxt/top.cxt: another name of /localhost:$PORT; only this name is deleted
  rtdel /localhost:$PORT/deep.host_cxt/two.cxt/again.cxt/Inner0.rtc
  rtdel /localhost:$PORT/deep.host_cxt/two.cxt/again.cxt/loop.cxt
  rtdel /localhost:$PORT/deep.host_cxt/two.cxt/again.cxt
  rtdel /localhost:$PORT/deep.host_cxt/two.cxt/real.cxt
  rtdel /localhost:$PORT/deep.host_cxt/two.cxt/top.cxt
  rtdel /localhost:$PORT/deep.host_cxt/two.cxt
  $ rtdel --recursive /localhost:$PORT/deep.host_cxt
  rtdel: /localhost:$PORT/deep.host_cxt/two.cxt/top.cxt: another name of /localhost:$PORT; only this name is deleted
  $ rtls /localhost:$PORT
  test.host_cxt/

A name server that does not answer, or whose address is unusable, has no say:

  $ mock two
  $ export RTCTREE_NAMESERVERS="http://laptop;127.0.0.1:$PORT;localhost:1"
  $ rtdel --recursive /localhost:$PORT/test.host_cxt; rtls /localhost:$PORT

Zombies in another name server are deleted there, not through its names elsewhere:

  $ export RTCTREE_NAMESERVERS="localhost:$PORT"
  $ mock aliased localhost:$PORT2
  $ mock zombie 1 --nameserver localhost:$PORT2
  $ rtdel -z -v; rtls /localhost:$PORT/test.host_cxt/far0.cxt/test.host_cxt
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  *Mock0.rtc
  $ RTCTREE_NAMESERVERS=localhost:$PORT2 rtdel -z -v
  rtdel: /localhost:$PORT2/test.host_cxt/Mock0.rtc: deleted
