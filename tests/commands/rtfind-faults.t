What rtfind says when something does not work, and with names that are hard to type. (What hangs:
tests/sim/stories/rtfind-faults.t.)

world: two
world: names --context odd.host_cxt/%n.rtc
world: fragile
faulty: silent hostile
faulty: --bind localhost:$PORT/bad.host_cxt a=close

One whose reference does not say what it is, and which does not answer, is a component:

  $ rtfind ../bad.host_cxt -t c
  /localhost:$PORT/bad.host_cxt/a.rtc
  rtfind: /localhost:$PORT/bad.host_cxt/a.rtc: connection lost
  [5]
  $ rtfind ../bad.host_cxt -t mz

The fragile one survives:

  $ rtfind . --state active -t c --timeout 30 -n 'F*'; ctl @fragile components
  Fragile0

Names are matched, and printed, in the spelling that rtls shows; what is printed can be typed.

  $ cd=/localhost:$PORT/odd.host_cxt
  $ rtfind $cd -n '*\*' -n 'esc*' -n '日*' -n '?l.rtc' -n '$(*' -n '*
  > *'
  /localhost:$PORT/odd.host_cxt/$(id);'"*.rtc
  /localhost:$PORT/odd.host_cxt/-l.rtc
  /localhost:$PORT/odd.host_cxt/\e
  /localhost:$PORT/odd.host_cxt/back\\slash.rtc
  /localhost:$PORT/odd.host_cxt/bad\xff\xfe.rtc
  /localhost:$PORT/odd.host_cxt/bell\x07del\x7f.rtc
  /localhost:$PORT/odd.host_cxt/co\:lon.rtc
  /localhost:$PORT/odd.host_cxt/csi\x9b31m.rtc
  /localhost:$PORT/odd.host_cxt/esc\x1b[31mred.rtc
  /localhost:$PORT/odd.host_cxt/kind\/slash.r\/tc
  /localhost:$PORT/odd.host_cxt/kinddot.r\.tc
  /localhost:$PORT/odd.host_cxt/rtl\u202ecba.rtc
  /localhost:$PORT/odd.host_cxt/sl\/ash.rtc
  /localhost:$PORT/odd.host_cxt/tab\x09new\x0aline.rtc
  /localhost:$PORT/odd.host_cxt/日本語.rtc
  $ rtfind $cd -i 'BAD\XFF*' | xargs -d '\n' rtls
  bad\xff\xfe.rtc
  $ rtfind $cd -m 1 -t c -0 | xargs -0 rtfind -m 1 | wc -l; rtfind $cd -m 1 -t c | wc -l
  25
  25
  $ rtfind --json $cd -m 1 | LC_ALL=C grep -c -v '^{[ -~]*}$'
  0
  [1]

Zombies, wrong objects, loops:

  $ rtfind $cd -t z
  /localhost:$PORT/odd.host_cxt/Gone0.rtc
  $ rtfind $cd -n '[A-Z]*' -n 'N*[a-z]0.*' -n 'Not*' -n 'Nil*' -n 'Thing*' -n 'Gone*'
  /localhost:$PORT/odd.host_cxt/Gone0.rtc
  /localhost:$PORT/odd.host_cxt/Nil0.rtc
  /localhost:$PORT/odd.host_cxt/NotAComponent0.rtc
  /localhost:$PORT/odd.host_cxt/NotAManager0.mgr
  /localhost:$PORT/odd.host_cxt/Thing0.obj
  $ rtfind $cd -t c -n 'N*[a-z]0.*' -n 'Not*' -n 'Nil*' -n 'Thing*' -n 'Gone*'
  $ rtfind $cd -t d
  /localhost:$PORT/odd.host_cxt
  /localhost:$PORT/odd.host_cxt/a.cxt
  /localhost:$PORT/odd.host_cxt/a.cxt/b.cxt
  /localhost:$PORT/odd.host_cxt/a.cxt/b.cxt/c.cxt
  /localhost:$PORT/odd.host_cxt/empty.cxt
  /localhost:$PORT/odd.host_cxt/loop.cxt -> /localhost:$PORT/odd.host_cxt
  /localhost:$PORT/odd.host_cxt/many.cxt
  $ rtfind $cd -n Deep0.rtc -n Same0.rtc
  /localhost:$PORT/odd.host_cxt/Same0.rtc
  /localhost:$PORT/odd.host_cxt/a.cxt/Same0.rtc
  /localhost:$PORT/odd.host_cxt/a.cxt/b.cxt/c.cxt/Deep0.rtc
  $ rtfind $cd/many.cxt -n 'Name*' | wc -l
  300
  $ rtfind $cd/Nil0.rtc/ $cd/Nil0.rtc
  /localhost:$PORT/odd.host_cxt/Nil0.rtc
  rtfind: /localhost:$PORT/odd.host_cxt/Nil0.rtc: not a directory (it is a nil reference)
  [5]

Name servers:

  $ rtfind --timeout 1 /localhost:$SILENT
  rtfind: /localhost:$SILENT: no answer within 1s
  [4]
  $ rtfind /localhost:$HOSTILE -m 1 | LC_ALL=C grep -c '[[:cntrl:]]'; ls
  0
