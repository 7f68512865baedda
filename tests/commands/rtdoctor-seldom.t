What only a second look, or a careful one, finds.

world: these Mock:Near0 Mock:Other0
world: these Mock:Far0 --context far.host_cxt/%n.rtc
world: chain 3

A component that something starts again and again is alive at each look:

  $ rtdoctor -q --twice 20 ../far.host_cxt > out & doctor=$!
  $ soon 'calls @these2 | grep get_ports'; kill-mock these2; mock these Mock:Far0 --context far.host_cxt/%n.rtc; wait $doctor; grep again out
  warn  /localhost:$PORT/far.host_cxt/Far0.rtc: started again within 20 s: it was at 127.0.0.1:*, and is at 127.0.0.1:* now; try: see its log, and what starts it again (glob)
  $ rtdoctor -q --twice 0.1 ../far.host_cxt | grep again; rtdoctor --twice 0.1 --from x.html
  rtdoctor: --from examines nothing: no PATH, --profile, --measure, --twice or --report goes with it (see --help)
  [2]

The far end of a connection that lives, while another object has its name:

  $ rtcon -i one Near0.rtc:out ../far.host_cxt/Far0.rtc:in; rtdoctor -q . | grep connection
  [1]
  $ rtdel -f ../far.host_cxt/Far0.rtc; rtdoctor -q . | grep connection
  warn  /localhost:$PORT/test.host_cxt/Near0.rtc:out: the far end of connection outin, Far0.in at 127.0.0.1:*, lives, but is bound in no name server that is known here; try: restart its process, so that it binds its name; rtcat /localhost:$PORT/test.host_cxt/Near0.rtc:out shows the connection (glob)

Nobody sees what the last component takes, nor what comes to the first in port:

  $ rttrace -t 1 Link0.rtc:out | tail -1
  no stage stops, holds, thins, delays or disorders the values; whether /localhost:$PORT/test.host_cxt/Link2.rtc takes what comes to it cannot be seen
  $ rttrace -t 1 Link2.rtc:in | tail -1
  no stage stops, holds, thins, delays or disorders the values; whether /localhost:$PORT/test.host_cxt/Link2.rtc takes what comes to it cannot be seen, nor whether anything comes: rttrace -u PORT follows it to where it comes from

Addresses without a meaning; what is no name server:

  $ rtdoctor -q '[fe80::1]' | grep fe80
  fail  /[fe80::1]: fe80::1 is an address of one link only, which means nothing without an interface; try: write the interface, too: [fe80::1%eth0]
