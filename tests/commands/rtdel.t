rtdel deletes names from name servers. What lives behind a name lives on.

world: two
world: names --context odd.host_cxt/%n.rtc
world: these Mock:Dead0 Mock:Dead1 Mock:Dead2 Mock:Dead3
world: these Mock:Hung0
world: fragile
faulty: bottomless

A name, whatever it is bound to; the component does not notice:

  $ rtdel ConsoleIn0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: alive, with its connections, but no longer found by this name; a restart binds it again, or, by itself, naming.update.enable: YES in its rtc.conf
  $ calls
  1 _non_existent
  $ rtls -R . | grep Console
  ConsoleOut0.rtc
  $ ctl state ConsoleIn0
  INACTIVE

--dry-run prints commands that do it, and changes nothing:

  $ rtdel --dry-run ConsoleOut0.rtc
  rtdel /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ rtls ConsoleOut0.rtc
  ConsoleOut0.rtc
  $ rtdel --dry-run ConsoleOut0.rtc | sh
  rtdel: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: alive, with its connections, but no longer found by this name; a restart binds it again, or, by itself, naming.update.enable: YES in its rtc.conf
  $ rtls ConsoleOut0.rtc
  rtls: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no such path
  [3]

Zombies: with -z, only those; each is looked at twice before it goes.

  $ kill-mock these
  $ rtdel -z Fragile0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/Fragile0.rtc: not a zombie (it is a component)
  [3]
  $ ctl @these2 reset
  $ rtdel -z Hung0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/Hung0.rtc: not a zombie (it is a component)
  [3]
  $ calls @these2
  1 _non_existent
  $ rtdel -z -v Dead0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/Dead0.rtc: deleted
  $ rtls . | grep Dead
  *Dead1.rtc
  *Dead2.rtc
  *Dead3.rtc

A component that does not answer is no zombie, nor is one that says that it has died but does answer the second time:

  $ hang these2
  $ within 4-8 rtdel --timeout 4 -z Hung0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/Hung0.rtc: no answer within 4s
  [4]
  $ wake these2
  $ ctl @fragile fail _non_existent 1 TRANSIENT; rtdel -z Fragile0.rtc 2>&1 | cat
  rtdel: /localhost:\$PORT/test.host_cxt/Fragile0.rtc: (not a zombie \(it is a component\)|cannot be reached now \(TRANSIENT_ConnectFailed\)) (re)
  $ rtls Fragile0.rtc
  Fragile0.rtc

An object that is gone while its process lives is a zombie, too; -z is used for all paths, and they fail one by one:

  $ rtdel -z -v ../odd.host_cxt/Gone0.rtc Fragile0.rtc Dead1.rtc Nope0.rtc
  rtdel: /localhost:$PORT/odd.host_cxt/Gone0.rtc: deleted
  rtdel: /localhost:$PORT/test.host_cxt/Fragile0.rtc: not a zombie (it is a component)
  rtdel: /localhost:$PORT/test.host_cxt/Dead1.rtc: deleted
  rtdel: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [5]
  $ rtls . | grep Dead
  *Dead2.rtc
  *Dead3.rtc

Contexts: only empty ones, or with --recursive; the context itself is destroyed:

  $ odd=/localhost:$PORT/odd.host_cxt
  $ rtdel -f -v $odd/empty.cxt
  rtdel: /localhost:$PORT/odd.host_cxt/empty.cxt: deleted
  $ rtls $odd/empty.cxt
  rtls: /localhost:$PORT/odd.host_cxt/empty.cxt: no such path
  [3]
  $ rtdel $odd/a.cxt
  rtdel: /localhost:$PORT/odd.host_cxt/a.cxt: not empty (2 names); delete it with --recursive
  [1]
  $ rtdel $odd/many.cxt
  rtdel: /localhost:$PORT/odd.host_cxt/many.cxt: not empty (300 names); delete it with --recursive
  [1]
  $ rtdel --recursive --dry-run $odd/a.cxt
  rtdel /localhost:$PORT/odd.host_cxt/a.cxt/Same0.rtc
  rtdel /localhost:$PORT/odd.host_cxt/a.cxt/b.cxt/c.cxt/Deep0.rtc
  rtdel /localhost:$PORT/odd.host_cxt/a.cxt/b.cxt/c.cxt
  rtdel /localhost:$PORT/odd.host_cxt/a.cxt/b.cxt
  rtdel /localhost:$PORT/odd.host_cxt/a.cxt
  $ rtdel --recursive --dry-run $odd/a.cxt | sed 's/rtdel/rtdel -f/' | sh
  $ rtls $odd/a.cxt
  rtls: /localhost:$PORT/odd.host_cxt/a.cxt: no such path
  [3]
  $ rtdel --recursive -v $odd/many.cxt 2>&1 | wc -l
  301
  $ rtls $odd/many.cxt
  rtls: /localhost:$PORT/odd.host_cxt/many.cxt: no such path
  [3]
  $ rtdel -z --recursive $odd; rtls $odd | wc -l
  30

A context that is bound inside itself loses that name only, also with --recursive:

  $ rtdel --recursive --dry-run $odd/loop.cxt
  rtdel: /localhost:$PORT/odd.host_cxt/loop.cxt: another name of /localhost:$PORT/odd.host_cxt; only this name is deleted
  rtdel /localhost:$PORT/odd.host_cxt/loop.cxt
  $ rtdel --recursive --dry-run $odd/loop.cxt/loop.cxt
  rtdel: /localhost:$PORT/odd.host_cxt/loop.cxt/loop.cxt: another name of /localhost:$PORT/odd.host_cxt; only this name is deleted
  rtdel /localhost:$PORT/odd.host_cxt/loop.cxt/loop.cxt
  $ rtls $odd | wc -l
  30
  $ rtdel --recursive $odd/loop.cxt
  rtdel: /localhost:$PORT/odd.host_cxt/loop.cxt: another name of /localhost:$PORT/odd.host_cxt; only this name is deleted
  $ rtls $odd | wc -l
  29

Names that are hard to type, and a nil reference:

  $ rtdel -f -v $odd/Nil0.rtc $odd/'sl\/ash.rtc' $odd/'co\:lon.rtc' $odd/'do.t.rtc' $odd/'back\\slash.rtc' \
  >     $odd/'sp ace.rtc' $odd/-l.rtc
  rtdel: /localhost:$PORT/odd.host_cxt/Nil0.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/sl\/ash.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/co\:lon.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/do.t.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/back\\slash.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/sp ace.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/-l.rtc: deleted
  $ rtdel -f -v $odd/'tab\x09new\x0aline.rtc' $odd/'esc\x1b[31mred.rtc' $odd/'csi\x9b31m.rtc' \
  >     $odd/'bell\x07del\x7f.rtc'
  rtdel: /localhost:$PORT/odd.host_cxt/tab\x09new\x0aline.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/esc\x1b[31mred.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/csi\x9b31m.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/bell\x07del\x7f.rtc: deleted
  $ rtdel -f -v $odd/'$(id);'"'"'"*.rtc' $odd/日本語.rtc $odd/'bad\xff\xfe.rtc' $odd/'rtl\u202ecba.rtc'
  rtdel: /localhost:$PORT/odd.host_cxt/$(id);'"*.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/日本語.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/bad\xff\xfe.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/rtl\u202ecba.rtc: deleted
  $ rtdel -f -v $odd/nokind $odd/'\e' $odd/'kind\/slash.r\/tc' $odd/'kinddot.r\.tc' $odd/'.rtc' \
  >     $odd/'..rtc' $odd/'...rtc'
  rtdel: /localhost:$PORT/odd.host_cxt/nokind: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/\e: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/kind\/slash.r\/tc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/kinddot.r\.tc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/..rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/...rtc: deleted
  $ cd /tmp; RTCSH_CWD=$odd rtdel -v -- NotAComponent0.rtc NotAManager0.mgr Thing0.obj
  rtdel: /localhost:$PORT/odd.host_cxt/NotAComponent0.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/NotAManager0.mgr: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/Thing0.obj: deleted
  $ rtls $odd
  Same0.rtc
  Twin0.rtc
  Twin0again.rtc
  xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx.rtc

The whole of what is left:

  $ rtdel --recursive -v $odd
  rtdel: /localhost:$PORT/odd.host_cxt/Same0.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/Twin0.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/Twin0again.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt/xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx.rtc: deleted
  rtdel: /localhost:$PORT/odd.host_cxt: deleted
  $ rtls ..
  test.host_cxt/

Not to be deleted:

  $ rtdel /
  rtdel: /: not a name that can be deleted (it is a root directory)
  [3]
  $ rtdel --recursive /localhost:$PORT
  rtdel: /localhost:$PORT: not a name that can be deleted (it is a name server)
  [3]
  $ rtdel ConsoleIn0.rtc:out
  rtdel: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not a name that can be deleted (it is a port)
  [3]
  $ rtdel Fragile0.rtc/below.rtc
  rtdel: /localhost:$PORT/test.host_cxt/Fragile0.rtc: not a directory (it is a component)
  [3]
  $ rtdel Nope0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [3]
  $ rtdel /localhost:1/x.rtc
  rtdel: /localhost:1: connection refused; is the name server running?
  [4]
  $ rtdel
  rtdel: no path given (see --help)
  [2]
  $ rtdel -f ConsoleIn0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such path
  [3]
  $ rtdel --recursive
  rtdel: no path given (see --help)
  [2]
  $ rtdel -z :
  rtdel: :: a single colon separates a component from its port; write \: in a name
  [2]

A name server in which there is always one more directory below is given up:

  $ rtdel --recursive /localhost:$BOTTOMLESS/deeper.host_cxt 2>&1 | sed 's|/deeper[^:]*|/…|'
  rtdel: /localhost:$BOTTOMLESS/…: more than 64 directories deep

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -z SERVER
invocation: -f A
invocation: -z A
invocation: --dry-run --recursive SERVER/x.host_cxt
looking: --dry-run -z SERVER
broken server: 3
broken component: 0 3
fatal: components that others need may end
example: rtdel -z Motor0.rtc <- kill -9 $ROBOT; until rtfind / -t z -q; do sleep 0.1; done
