Components that take part in the execution context of a component whose process hangs are not hidden by that.

world: these Mock:Driver0
world: these Mock:A Mock:B Mock:C Mock:D Mock:E Mock:F
alone: it measures time

  $ rtec Driver0.rtc attach A.rtc B.rtc C.rtc D.rtc E.rtc F.rtc
  $ rtec A.rtc
  0  0     Periodic  1000  Running  Inactive  A        -
  1  1000  Periodic  1000  Running  Inactive  Driver0  A,B,C,D,E,F
  $ hang these

All of them together cost one timeout:

  $ within 2-3.8 rtls -l --timeout 2
  Inactive  2/0  1/0  1/0  0/0  A.rtc
  Inactive  2/0  1/0  1/0  0/0  B.rtc
  Inactive  2/0  1/0  1/0  0/0  C.rtc
  Inactive  2/0  1/0  1/0  0/0  D.rtc
  ?         -    -    -    -    ?Driver0.rtc
  Inactive  2/0  1/0  1/0  0/0  E.rtc
  Inactive  2/0  1/0  1/0  0/0  F.rtc
  rtls: 1 of 7 did not answer (Driver0.rtc)
  [5]
  $ within 2-3.8 rtfind --timeout 2 . --state inactive
  /localhost:$PORT/test.host_cxt/A.rtc
  /localhost:$PORT/test.host_cxt/B.rtc
  /localhost:$PORT/test.host_cxt/C.rtc
  /localhost:$PORT/test.host_cxt/D.rtc
  /localhost:$PORT/test.host_cxt/E.rtc
  /localhost:$PORT/test.host_cxt/F.rtc
  rtfind: /localhost:$PORT/test.host_cxt/Driver0.rtc: no answer within 2s
  [5]
  $ within 2-3.8 rtcat --timeout 2 A.rtc
  A.rtc  Inactive
    Category       test
    Description    Does nothing
    Instance name  A
    Type name      Mock
    Vendor         Shinji Kurihara
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
   +Extra properties
  +Execution Context 0  Inactive
  +Execution Context of another component, which does not answer  Unknown
  +DataInPort: in
  +DataOutPort: out
  $ within 2-3.8 rtec --timeout 2 A.rtc
  0  0  Periodic  1000  Running  Inactive  A  -
  1  ?  ?         ?     ?        Unknown   ?  ?
  $ within 2-3.8 rtec --timeout 2 --json A.rtc | tail -1
  {"index": 1, "path": "/localhost:$PORT/test.host_cxt/A.rtc", "state": "Unknown"}
  $ within 0-3.8 rtact --timeout 2 A.rtc && rtls -l A.rtc --timeout 2
  Active  2/0  1/0  1/0  0/0  A.rtc
