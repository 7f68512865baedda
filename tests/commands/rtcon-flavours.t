rtcon between components of different implementations of OpenRTM, and what each of them answers. What the others
print as C++ 1.1 does is not repeated.

world: two --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: two --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: two --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: two --flavour py2 --context py2.host_cxt/%n.rtc
world: two --flavour java --context java.host_cxt/%n.rtc
world: two --flavour rtorb --context rtorb.host_cxt/%n.rtc

  $ here=/localhost:$PORT
  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do
  >   "$@" $here/$v.host_cxt/ConsoleIn0.rtc:out $here/$v.host_cxt/ConsoleOut0.rtc:in 2>&1 |
  >     sed "s|$here||g; s/$v.host/V.host/g; s/[0-9a-f-]\{36\}/ID/" >$v
  >   [ $v != cpp11 ] && cmp -s cpp11 $v || { echo "$v:"; cat $v; }
  > done; }

All of them connect, and carry data:

  $ each rtcon
  cpp11:
  $ for at in cpp11 cpp12 cpp2 py2 java rtorb; do rtact --wait $here/$at.host_cxt/ConsoleOut0.rtc; done
  $ for n in '' 2 3 4 5 6; do ctl @two$n write ConsoleIn0:out 7; ctl @two$n received ConsoleOut0:in 1; done
  1 7
  1 7
  1 7
  1 7
  1 7
  1 7

The same ports again:

  $ each rtcon
  cpp11:
  cpp12:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: already connected (id ID)
  cpp2:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: already connected (id ID)
  py2:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: already connected (id ID)
  java:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: already connected (id ID)
  rtorb:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: refused by the component (RTC_ERROR); it is connected already (id ID)
  $ each rtcon -d
  cpp11:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: already connected (id ID)
  $ each rtdis
  cpp11:
  $ each rtdis -q
  cpp11:
  rtdis: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: not connected

Ids of one's own, which RtORB does not take:

  $ each rtcon -i mine
  cpp11:
  rtorb:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: refused; id mine is in use, or the component takes no ids (RtORB)
  $ each rtdis
  cpp11:
  rtorb:
  rtdis: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: not connected

Requests that only some refuse; nothing is left behind:

  $ each rtcon -p dataport.subscription_type=periodic
  cpp11:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: a periodic connection needs a rate: dataport.publisher.push_rate=HZ
  rtorb:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: /V.host_cxt/ConsoleIn0.rtc:out has no subscription_type periodic (it has: flush)
  $ each rtdis
  cpp11:
  rtdis: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: not connected
  $ each rtcon -p dataport.serializer.cdr.endian=middle
  cpp11:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: refused by the component (UNSUPPORTED)
  py2:
  rtcon: /V.host_cxt/ConsoleIn0.rtc:out to /V.host_cxt/ConsoleOut0.rtc:in: refused by the component (RTC_ERROR)
  $ for n in '' 2 3 4 5 6; do ctl @two$n connectors ConsoleIn0:out; ctl @two$n connectors ConsoleOut0:in; done

From each to the next; the data types of RtORB are spelt TimedLong, and its port names are bare:

  $ chain() { "$@" $here/cpp11.host_cxt/ConsoleIn0.rtc:out $here/cpp12.host_cxt/ConsoleOut0.rtc:in
  >   "$@" $here/cpp12.host_cxt/ConsoleIn0.rtc:out $here/cpp2.host_cxt/ConsoleOut0.rtc:in
  >   "$@" $here/cpp2.host_cxt/ConsoleIn0.rtc:out $here/py2.host_cxt/ConsoleOut0.rtc:in
  >   "$@" $here/py2.host_cxt/ConsoleIn0.rtc:out $here/java.host_cxt/ConsoleOut0.rtc:in
  >   "$@" $here/java.host_cxt/ConsoleIn0.rtc:out $here/rtorb.host_cxt/ConsoleOut0.rtc:in
  >   "$@" $here/rtorb.host_cxt/ConsoleIn0.rtc:out $here/cpp11.host_cxt/ConsoleOut0.rtc:in
  > }
  $ chain rtcon
  $ for n in '' 2 3 4 5 6; do ctl @two$n write ConsoleIn0:out 8; done
  $ for n in '' 2 3 4 5 6; do ctl @two$n received ConsoleOut0:in 2; done
  2 8
  2 8
  2 8
  2 8
  2 8
  2 8
  $ rtcat $here/rtorb.host_cxt/ConsoleIn0.rtc:out -l | grep Connected
   +Connected to  /localhost:$PORT/cpp11.host_cxt/ConsoleOut0.rtc:in
  $ chain rtdis
  $ for n in '' 2 3 4 5 6; do ctl @two$n connectors ConsoleIn0:out; ctl @two$n connectors ConsoleOut0:in; done
