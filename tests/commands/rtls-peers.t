Peers that misbehave, in the place of a name server and of a component. rtls ends in time, with one line.

faulty: silent half-header drip reset close garbage announce sequence-bomb string-bomb wrong-id dead-host
faulty: --bind localhost:$PORT/bad.host_cxt a=late-silent b=late-reset c=late-close d=late-garbage e=string-bomb f=late-drip
faulty: hostile loop bottomless elsewhere-silent elsewhere-refused
world: linked
alone: it measures
both: each ORB reads answers in its own way

As a name server:

  $ export RTCSH_CWD=/
  $ within 0.5-1 rtls --timeout 0.5 localhost:$SILENT
  rtls: /localhost:$SILENT: no answer within 0.5s
  [4]
  $ within 0.5-1 rtls --timeout 0.5 localhost:$HALF_HEADER/a.cxt
  rtls: /localhost:$HALF_HEADER: no answer within 0.5s
  [4]
  $ within 0.5-1 rtls --timeout 0.5 localhost:$DRIP
  rtls: /localhost:$DRIP: no answer within 0.5s
  [4]
  $ within 0-1 rtls --timeout 0.5 localhost:$ANNOUNCE
  rtls: /localhost:\$ANNOUNCE: (no answer within 0.5s|garbled answer \(a message of 2147483632 octets\)) (re)
  [4]
  $ within 0-1 rtls --timeout 0.5 localhost:$WRONG_ID
  rtls: /localhost:\$WRONG_ID: (no answer within 0.5s|garbled answer \(a reply to another request\)) (re)
  [4]
  $ within 0.5-1 rtls --timeout 0.5 localhost:$DEAD_HOST
  rtls: /localhost:$DEAD_HOST: no answer within 0.5s
  [4]
  $ within 0-2 rtls localhost:$RESET
  rtls: /localhost:$RESET: connection lost
  [4]
  $ rtls localhost:$CLOSE
  rtls: /localhost:$CLOSE: connection lost
  [4]
  $ rtls localhost:$GARBAGE
  rtls: /localhost:\$GARBAGE: (connection lost|garbled answer \(not GIOP\)) (re)
  [4]
  $ rtls localhost:$SEQUENCE_BOMB
  rtls: /localhost:$SEQUENCE_BOMB: garbled answer (*) (glob)
  [4]
  $ rtls localhost:$STRING_BOMB
  rtls: /localhost:$STRING_BOMB: garbled answer (*) (glob)
  [4]
  $ within 2-3.8 rtls --timeout 2 -R localhost:$SILENT localhost:$DRIP localhost:$HALF_HEADER \
  >     localhost:$PORT 2>&1 |
  >     grep -v '^$'
  rtls: /localhost:$SILENT: no answer within 2s
  rtls: /localhost:$DRIP: no answer within 2s
  rtls: /localhost:$HALF_HEADER: no answer within 2s
  localhost:$PORT:
  bad.host_cxt/
  test.host_cxt/
  localhost:$PORT/bad.host_cxt:
  a.rtc
  b.rtc
  c.rtc
  d.rtc
  e.rtc
  f.rtc
  localhost:$PORT/test.host_cxt:
  ConsoleIn0.rtc
  ConsoleOut0.rtc

As components, beside good ones (the directory does not say what they are; their names say that they are components):

  $ export RTCSH_CWD=/localhost:$PORT/bad.host_cxt
  $ within 0-1.8 rtls --timeout 2
  a.rtc
  b.rtc
  c.rtc
  d.rtc
  e.rtc
  f.rtc
  $ within 2-3.8 rtls --timeout 2 -l -v . ../test.host_cxt
  .:
  ?  -  -  -  -  ?a.rtc
  ?  -  -  -  -  ?b.rtc
  ?  -  -  -  -  ?c.rtc
  ?  -  -  -  -  ?d.rtc
  ?  -  -  -  -  ?e.rtc
  ?  -  -  -  -  ?f.rtc

  ../test.host_cxt:
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc

  rtls: /localhost:$PORT/bad.host_cxt/a.rtc: no answer within 2s
  rtls: /localhost:$PORT/bad.host_cxt/b.rtc: connection lost
  rtls: /localhost:$PORT/bad.host_cxt/c.rtc: connection lost
  rtls: /localhost:\$PORT/bad.host_cxt/d.rtc: (connection lost|garbled answer \(not GIOP\)) (re)
  rtls: /localhost:$PORT/bad.host_cxt/e.rtc: garbled answer (*) (glob)
  rtls: /localhost:$PORT/bad.host_cxt/f.rtc: no answer within 2s
  rtls: 6 of 8 did not answer (a.rtc, b.rtc, c.rtc, d.rtc, e.rtc, …)
  [5]
  $ within 2-3.8 rtls --timeout 2 -l a.rtc
  ?  -  -  -  -  ?a.rtc
  rtls: 1 of 1 did not answer (a.rtc)
  [4]
  $ rtls -lv b.rtc
  ?  -  -  -  -  ?b.rtc
  rtls: /localhost:$PORT/bad.host_cxt/b.rtc: connection lost
  rtls: 1 of 1 did not answer (b.rtc)
  [4]
  $ rtls -lv c.rtc
  ?  -  -  -  -  ?c.rtc
  rtls: /localhost:$PORT/bad.host_cxt/c.rtc: connection lost
  rtls: 1 of 1 did not answer (c.rtc)
  [4]
  $ rtls -lv d.rtc
  ?  -  -  -  -  ?d.rtc
  rtls: /localhost:\$PORT/bad.host_cxt/d.rtc: (connection lost|garbled answer \(not GIOP\)) (re)
  rtls: 1 of 1 did not answer (d.rtc)
  [4]
  $ rtls -lv e.rtc
  ?  -  -  -  -  ?e.rtc
  rtls: /localhost:$PORT/bad.host_cxt/e.rtc: garbled answer (*) (glob)
  rtls: 1 of 1 did not answer (e.rtc)
  [4]

A name server with hostile names: a line each, no control character, and what is printed is found again.

  $ export RTCSH_CWD=/
  $ rtls localhost:$HOSTILE | cut -c 1-60
  $(touch canary);`touch canary`.rtc
  -rf.rtc
  ...host_cxt/
  ..\/..\/etc\/passwd.rtc
  .rtc
  LLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLLL
  \./
  \.\./
  \e/
  \x1b]0;pwned\x07\x1b[2Jescape.rtc
  \x1b]52;c;cm0gLXJmIH4=\x07clipboard.host_cxt/
  \xc6\xfc\xcb\u0738\xec.rtc
  \xff\xfe\x80invalid.rtc
  a.b\\\/c\:d.k\.k/
  bidi\u202ecba\u200b.rtc
  c1\x9b31m\u009b32m.rtc
  line\x0afeed\x0dreturn\x09tab.rtc
  quote'"space .rtc
  日本語.rtc
  $ rtls -0 localhost:$HOSTILE | tr '\0' '\n' | LC_ALL=C grep -c '[[:cntrl:]]'
  0
  [1]
  $ rtls --json localhost:$HOSTILE | python3 -c 'import json, sys
  > print(len([json.loads(line) for line in sys.stdin]))'
  19
  $ ls

A context inside itself, contexts without end (shown 64 deep), references that lead elsewhere:

  $ rtls -R localhost:$LOOP
  .:
  again.host_cxt/
  leaf.rtc

  ./again.host_cxt:
  again.host_cxt/ -> /localhost:$LOOP/again.host_cxt
  leaf.rtc
   (esc)
  $ rtls -R localhost:$BOTTOMLESS | grep -c :
  65
  $ within 2-3.8 rtls --timeout 2 localhost:$ELSEWHERE_SILENT
  lost.host_cxt/
  ?lost.rtc
  rtls: 1 of 1 did not answer (lost.rtc)
  [5]
  $ rtls localhost:$ELSEWHERE_REFUSED
  lost.host_cxt/
  *lost.rtc
