Names are whatever someone bound. rtls shows each in a spelling that cannot harm a terminal, and takes
that spelling back.

world: names

A slash, colon, dot or backslash inside a name, control characters, invalid bytes:

  $ rtls -l
  Inactive  2/0  1/0  1/0  0/0  $(id);'"*.rtc
  Inactive  2/0  1/0  1/0  0/0  -l.rtc
  Inactive  2/0  1/0  1/0  0/0  ...rtc
  Inactive  2/0  1/0  1/0  0/0  ..rtc
  Inactive  2/0  1/0  1/0  0/0  .rtc
  -         -    -    -    -    *Gone0.rtc
  -         -    -    -    -    Nil0.rtc
  -         -    -    -    -    NotAComponent0.rtc
  -         -    -    -    -    NotAManager0.mgr
  Inactive  2/0  1/0  1/0  0/0  Same0.rtc
  -         -    -    -    -    Thing0.obj
  Inactive  2/0  1/0  1/0  0/0  Twin0.rtc
  Inactive  2/0  1/0  1/0  0/0  Twin0again.rtc
  Inactive  2/0  1/0  1/0  0/0  \e
  -         -    -    -    -    a.cxt
  Inactive  2/0  1/0  1/0  0/0  back\\slash.rtc
  Inactive  2/0  1/0  1/0  0/0  bad\xff\xfe.rtc
  Inactive  2/0  1/0  1/0  0/0  bell\x07del\x7f.rtc
  Inactive  2/0  1/0  1/0  0/0  co\:lon.rtc
  Inactive  2/0  1/0  1/0  0/0  csi\x9b31m.rtc
  Inactive  2/0  1/0  1/0  0/0  do.t.rtc
  -         -    -    -    -    empty.cxt
  Inactive  2/0  1/0  1/0  0/0  esc\x1b[31mred.rtc
  Inactive  2/0  1/0  1/0  0/0  kind\/slash.r\/tc
  Inactive  2/0  1/0  1/0  0/0  kinddot.r\.tc
  -         -    -    -    -    loop.cxt
  -         -    -    -    -    many.cxt
  Inactive  2/0  1/0  1/0  0/0  nokind
  Inactive  2/0  1/0  1/0  0/0  rtl\u202ecba.rtc
  Inactive  2/0  1/0  1/0  0/0  sl\/ash.rtc
  Inactive  2/0  1/0  1/0  0/0  sp ace.rtc
  Inactive  2/0  1/0  1/0  0/0  tab\x09new\x0aline.rtc
  Inactive  2/0  1/0  1/0  0/0  xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx.rtc
  Inactive  2/0  1/0  1/0  0/0  日本語.rtc
  $ rtls | LC_ALL=C grep -c '[[:cntrl:]]'
  0
  [1]

What is printed can be typed: the full paths, and each name from where it is.

  $ rtls -0 | xargs -0 rtls -0 >paths; rtls -0 | tr '\0' '\n' | grep -c -v '[.]cxt$'
  30
  $ rtls | grep -v -e /$ -e '^[*]' >names; wc -l <names
  29
  $ sed 's,^,./,' names | tr '\n' '\0' | xargs -0 rtls | sort | diff - names && echo same
  same
  $ rtls -R / | grep -c 'sl\\/ash'
  1

More ways to type a name: a backslash before any punctuation, codes of characters.

  $ rtls './sp\ ace.rtc' './sp ace.rtc' './\x73p\u0020ace.rtc' 'co\:lon.rtc' 'do.t.rtc' './-l.rtc' -- -l.rtc
  sp ace.rtc
  sp ace.rtc
  sp ace.rtc
  co\:lon.rtc
  do.t.rtc
  -l.rtc
  -l.rtc
  $ rtls '日本語.rtc' '\u65e5本語.rtc' "$(printf '\346\227\245\346\234\254\350\252\236.rtc')" 'bad\xff\xfe.rtc'
  日本語.rtc
  日本語.rtc
  日本語.rtc
  bad\xff\xfe.rtc
  $ rtls "$(printf 'bad\377\376.rtc')" "$(printf 'esc\033[31mred.rtc')"
  bad\xff\xfe.rtc
  esc\x1b[31mred.rtc
  $ rtls '\e'
  \e
  $ rtls ./nokind './\..rtc' './\...rtc' .rtc
  nokind
  ..rtc
  ...rtc
  .rtc

Wide characters take two columns of a terminal:

  $ NO_COLOR=1 terminal 36 rtls '日本語.rtc' './sp ace.rtc' './-l.rtc' do.t.rtc 'co\:lon.rtc' '日本語.rtc'
  日本語.rtc  sp ace.rtc   -l.rtc
  do.t.rtc    co\:lon.rtc  日本語.rtc

A name that is no directory says so in the same spelling; so does a near miss.

  $ rtls 'esc\x1b[31mred.rtc/'
  rtls: /localhost:$PORT/test.host_cxt/esc\x1b[31mred.rtc: not a directory (it is a component)
  [3]
  $ rtls 'esc\x1b[32mred.rtc'
  rtls: /localhost:$PORT/test.host_cxt/esc\x1b[32mred.rtc: no such path; did you mean esc\x1b[31mred.rtc?
  [3]
  $ rtls "$(printf 'esc\033[32mred.rtd')"
  rtls: /localhost:$PORT/test.host_cxt/esc\x1b[32mred.rtd: no such path; did you mean esc\x1b[31mred.rtc?
  [3]
  $ rtls 'sl/ash.rtc'
  rtls: /localhost:$PORT/test.host_cxt/sl: no such path
  [3]
  $ rtls 'co:lon.rtc'
  rtls: /localhost:$PORT/test.host_cxt/co: no such path
  [3]

JSON is ASCII whatever the name, and so can be read anywhere.

  $ rtls --json | LC_ALL=C grep -c '[^ -~]'
  0
  [1]
  $ rtls --json | python3 -c 'import json, sys
  > names = [json.loads(line)["path"] for line in sys.stdin]
  > print(len(names), len(set(names)), all(name.isprintable() for name in names))'
  34 34 True
  $ rtls --json 'bad\xff\xfe.rtc' '日本語.rtc' '$(id);'"'"'"*.rtc'
  {"kind": "component", "name": "bad\\xff\\xfe.rtc", "path": "/localhost:$PORT/test.host_cxt/bad\\xff\\xfe.rtc"}
  {"kind": "component", "name": "\u65e5\u672c\u8a9e.rtc", "path": "/localhost:$PORT/test.host_cxt/\u65e5\u672c\u8a9e.rtc"}
  {"kind": "component", "name": "$(id);'\"*.rtc", "path": "/localhost:$PORT/test.host_cxt/$(id);'\"*.rtc"}

Wrong objects: a name ending in .rtc that is bound to something else, one bound to nothing, and one whose
process has lost the object.

  $ rtls NotAComponent0.rtc NotAManager0.mgr Thing0.obj
  NotAComponent0.rtc
  NotAManager0.mgr
  Thing0.obj
  $ rtls -l NotAComponent0.rtc Nil0.rtc Gone0.rtc
  -  -  -  -  -  NotAComponent0.rtc
  -  -  -  -  -  Nil0.rtc
  -  -  -  -  -  *Gone0.rtc
  $ rtls --json NotAComponent0.rtc
  {"kind": "unknown", "name": "NotAComponent0.rtc", "path": "/localhost:$PORT/test.host_cxt/NotAComponent0.rtc"}
  $ rtls --json Nil0.rtc
  {"kind": "unknown", "name": "Nil0.rtc", "path": "/localhost:$PORT/test.host_cxt/Nil0.rtc"}
  $ rtls --json Gone0.rtc
  {"error": "/localhost:$PORT/test.host_cxt/Gone0.rtc: zombie (the name is bound, but its object is gone)", "kind": "zombie", "name": "Gone0.rtc", "path": "/localhost:$PORT/test.host_cxt/Gone0.rtc"}
  $ rtls NotAComponent0.rtc/
  rtls: /localhost:$PORT/test.host_cxt/NotAComponent0.rtc: not a directory (it is a CORBA object of unknown kind)
  [3]
  $ rtls Gone0.rtc/ Nil0.rtc/
  rtls: /localhost:$PORT/test.host_cxt/Gone0.rtc: not a directory (it is a component)
  rtls: /localhost:$PORT/test.host_cxt/Nil0.rtc: not a directory (it is a nil reference)
  [3]

A context that is bound inside itself is entered once; below it, paths work as deep as one likes.

  $ rtls -R . | grep '^[.].*:$'
  .:
  ./a.cxt:
  ./a.cxt/b.cxt:
  ./a.cxt/b.cxt/c.cxt:
  ./empty.cxt:
  ./many.cxt:
  $ rtls loop.cxt/loop.cxt/loop.cxt/Deep0.rtc
  rtls: /localhost:$PORT/test.host_cxt/loop.cxt/loop.cxt/loop.cxt/Deep0.rtc: no such path; did you mean a.cxt/b.cxt/c.cxt/Deep0.rtc?
  [3]
  $ rtls loop.cxt/loop.cxt/a.cxt
  Same0.rtc
  b.cxt/
  $ rtls -R a.cxt
  .:
  Same0.rtc
  b.cxt/

  ./b.cxt:
  c.cxt/

  ./b.cxt/c.cxt:
  Deep0.rtc
   (esc)
  $ rtls -lR a.cxt/b.cxt
  .:
  -  -  -  -  -  c.cxt

  ./c.cxt:
  Inactive  2/0  1/0  1/0  0/0  Deep0.rtc
   (esc)
  $ rtls empty.cxt
  $ rtls -l empty.cxt/
  $ rtls -R empty.cxt
  .:
   (esc)
  $ rtls --json empty.cxt

A context of 300 names is shown in full (rtshell loses what comes after the 200th).

  $ rtls many.cxt | wc -l
  300
  $ rtls many.cxt | sed -n '1p;$p'
  Name000.rtc
  Name299.rtc
  $ rtls -l many.cxt | wc -l
  300
