rtexit with components of every implementation: the name is gone afterwards.

world: error --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: error --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: error --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: error --flavour java --context java.host_cxt/%n.rtc
world: error --flavour rtorb --context rtorb.host_cxt/%n.rtc

  $ for f in cpp11 cpp12 cpp2 java rtorb; do
  >     rtexit -v --wait=60 ../$f.host_cxt/Broken0.rtc
  >     rtls ../$f.host_cxt/Broken0.rtc
  > done
  rtexit: /localhost:$PORT/cpp11.host_cxt/Broken0.rtc: exited
  rtls: /localhost:$PORT/cpp11.host_cxt/Broken0.rtc: no such path
  rtexit: /localhost:$PORT/cpp12.host_cxt/Broken0.rtc: exited
  rtls: /localhost:$PORT/cpp12.host_cxt/Broken0.rtc: no such path
  rtexit: /localhost:$PORT/cpp2.host_cxt/Broken0.rtc: exited
  rtls: /localhost:$PORT/cpp2.host_cxt/Broken0.rtc: no such path
  rtexit: /localhost:$PORT/java.host_cxt/Broken0.rtc: exited
  rtls: /localhost:$PORT/java.host_cxt/Broken0.rtc: no such path
  rtexit: /localhost:$PORT/rtorb.host_cxt/Broken0.rtc: exited
  rtls: /localhost:$PORT/rtorb.host_cxt/Broken0.rtc: no such path
  [3]
