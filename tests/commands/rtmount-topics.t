A data port that is connected alone, in a mounted tree: the link names what carries its data.

needs: fuse
world: topics

  $ rtcon -n chatter -p dataport.interface_type=fast-rtps ConsoleIn0.rtc:out
  $ rtcon -n rtlog -p dataport.interface_type=ssm ConsoleIn0.rtc:out
  $ mkdir m
  $ rtmount m
  $ cd m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc/ports/out/connections
  $ ls; readlink chatter
  chatter
  fast-rtps
  $ rm chatter; ls
  $ cd
  $ ctl connectors ConsoleIn0:out | sed 's/.* //'
  rtlog
  $ rtmount -u m
