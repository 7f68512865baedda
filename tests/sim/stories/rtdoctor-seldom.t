What only a second look, or a careful one, finds.

world: these Mock:Near0 Mock:Other0
world: these Mock:Far0 --context far.host_cxt/%n.rtc
world: chain 3

A component that something starts again and again is alive at each look:

  $ later 5 restart these2
  $ rtdoctor -q --twice 20 ../far.host_cxt
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/far.host_cxt/Far0.rtc
  warn  /robot/far.host_cxt/Far0.rtc: started again within 20 s: it was at 10.0.0.1:$PORT, and is at 10.0.0.1:$PORT now; try: see its log, and what starts it again
  [0] after 20.0 s
  $ rtdoctor -q --twice 0.1 ../far.host_cxt
  warn  /: all components examined are Inactive: none has been started; try: rtact /robot/far.host_cxt/Far0.rtc
  [0] after 0.1 s
  $ rtdoctor --twice 0.1 --from x.html
  ! rtdoctor: --from examines nothing: no PATH, --profile, --measure, --twice or --report goes with it (see --help)
  [2]

The far end of a connection that lives, while another object has its name:

  $ rtcon -i one Near0.rtc:out ../far.host_cxt/Far0.rtc:in
  $ rtdoctor -q .
  $ rtdel -f ../far.host_cxt/Far0.rtc
  $ rtdoctor -q .
  warn  /robot/test.host_cxt/Near0.rtc:out: the far end of connection outin, Far0.in at 10.0.0.1:$PORT, lives, but is bound in no name server that is known here; try: restart its process, so that it binds its name; rtcat /robot/test.host_cxt/Near0.rtc:out shows the connection

Nobody sees what the last component takes, nor what comes to the first in port:

  $ rttrace -t 1 Link0.rtc:out
  …
  no stage stops, holds, thins, delays or disorders the values; whether /robot/test.host_cxt/Link2.rtc takes what comes to it cannot be seen
  [0] after 1.0 s
  $ rttrace -t 1 Link2.rtc:in
  …
  no stage stops, holds, thins, delays or disorders the values; whether /robot/test.host_cxt/Link2.rtc takes what comes to it cannot be seen, nor whether anything comes: rttrace -u PORT follows it to where it comes from
  [0] after 1.0 s

Addresses without a meaning; what is no name server:

  $ rtdoctor -q '[fe80::1]'
  fail  /[fe80::1]: fe80::1 is an address of one link only, which means nothing without an interface; try: write the interface, too: [fe80::1%eth0]
  [1]
