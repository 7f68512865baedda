rtreset with components of every implementation: reset from Error, nothing to do when Inactive.

world: error --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: error --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: error --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: error --flavour java --context java.host_cxt/%n.rtc
world: error --flavour rtorb --context rtorb.host_cxt/%n.rtc

  $ for f in cpp11 cpp12 cpp2 java rtorb; do
  >     rtreset -v --wait ../$f.host_cxt/Broken0.rtc ../$f.host_cxt/Err0.rtc
  > done
  rtreset: /localhost:$PORT/cpp11.host_cxt/Broken0.rtc: Inactive
  rtreset: /localhost:$PORT/cpp11.host_cxt/Err0.rtc: Inactive
  rtreset: /localhost:$PORT/cpp12.host_cxt/Broken0.rtc: Inactive
  rtreset: /localhost:$PORT/cpp12.host_cxt/Err0.rtc: Inactive
  rtreset: /localhost:$PORT/cpp2.host_cxt/Broken0.rtc: Inactive
  rtreset: /localhost:$PORT/cpp2.host_cxt/Err0.rtc: Inactive
  rtreset: /localhost:$PORT/java.host_cxt/Broken0.rtc: Inactive
  rtreset: /localhost:$PORT/java.host_cxt/Err0.rtc: Inactive
  rtreset: /localhost:$PORT/rtorb.host_cxt/Broken0.rtc: Inactive
  rtreset: /localhost:$PORT/rtorb.host_cxt/Err0.rtc: Inactive
