rtcon between components of different implementations of OpenRTM, and what each of them answers.

once: it is the peers that differ here
world: two --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: two --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: two --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: two --flavour py2 --context py2.host_cxt/%n.rtc
world: two --flavour java --context java.host_cxt/%n.rtc
world: two --flavour rtorb --context rtorb.host_cxt/%n.rtc

  $ here=/localhost:$PORT
  $ each() { for at in cpp11 cpp12 cpp2 py2 java rtorb; do echo $at; "$@" $here/$at.host_cxt/ConsoleIn0.rtc:out $here/$at.host_cxt/ConsoleOut0.rtc:in; done; }

All of them connect, and carry data:

  $ each rtcon
  cpp11
  cpp12
  cpp2
  py2
  java
  rtorb
  $ for at in cpp11 cpp12 cpp2 py2 java rtorb; do rtact --wait $here/$at.host_cxt/ConsoleOut0.rtc; done
  $ for n in '' 2 3 4 5 6; do ctl @two$n write ConsoleIn0:out 7; ctl @two$n received ConsoleOut0:in 1; done
  1 7
  1 7
  1 7
  1 7
  1 7
  1 7

The same ports again:

  $ each rtcon 2>&1 | sed "s|$here||g"
  cpp11
  cpp12
  rtcon: /cpp12.host_cxt/ConsoleIn0.rtc:out to /cpp12.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  cpp2
  rtcon: /cpp2.host_cxt/ConsoleIn0.rtc:out to /cpp2.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  py2
  rtcon: /py2.host_cxt/ConsoleIn0.rtc:out to /py2.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  java
  rtcon: /java.host_cxt/ConsoleIn0.rtc:out to /java.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  rtorb
  rtcon: /rtorb.host_cxt/ConsoleIn0.rtc:out to /rtorb.host_cxt/ConsoleOut0.rtc:in: refused by the component (RTC_ERROR); it is connected already (id $UUID)
  $ each rtcon -d 2>&1 | sed "s|$here||g"
  cpp11
  rtcon: /cpp11.host_cxt/ConsoleIn0.rtc:out to /cpp11.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  cpp12
  rtcon: /cpp12.host_cxt/ConsoleIn0.rtc:out to /cpp12.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  cpp2
  rtcon: /cpp2.host_cxt/ConsoleIn0.rtc:out to /cpp2.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  py2
  rtcon: /py2.host_cxt/ConsoleIn0.rtc:out to /py2.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  java
  rtcon: /java.host_cxt/ConsoleIn0.rtc:out to /java.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  rtorb
  rtcon: /rtorb.host_cxt/ConsoleIn0.rtc:out to /rtorb.host_cxt/ConsoleOut0.rtc:in: already connected (id $UUID)
  $ each rtdis
  cpp11
  cpp12
  cpp2
  py2
  java
  rtorb
  $ each rtdis -q 2>&1 | sed "s|$here||g"
  cpp11
  rtdis: /cpp11.host_cxt/ConsoleIn0.rtc:out to /cpp11.host_cxt/ConsoleOut0.rtc:in: not connected
  cpp12
  rtdis: /cpp12.host_cxt/ConsoleIn0.rtc:out to /cpp12.host_cxt/ConsoleOut0.rtc:in: not connected
  cpp2
  rtdis: /cpp2.host_cxt/ConsoleIn0.rtc:out to /cpp2.host_cxt/ConsoleOut0.rtc:in: not connected
  py2
  rtdis: /py2.host_cxt/ConsoleIn0.rtc:out to /py2.host_cxt/ConsoleOut0.rtc:in: not connected
  java
  rtdis: /java.host_cxt/ConsoleIn0.rtc:out to /java.host_cxt/ConsoleOut0.rtc:in: not connected
  rtorb
  rtdis: /rtorb.host_cxt/ConsoleIn0.rtc:out to /rtorb.host_cxt/ConsoleOut0.rtc:in: not connected

Ids of one's own, which RtORB does not take:

  $ each rtcon -i mine 2>&1 | sed "s|$here||g"
  cpp11
  cpp12
  cpp2
  py2
  java
  rtorb
  rtcon: /rtorb.host_cxt/ConsoleIn0.rtc:out to /rtorb.host_cxt/ConsoleOut0.rtc:in: refused; id mine is in use, or the component takes no ids (RtORB)
  $ each rtdis 2>&1 | sed "s|$here||g"
  cpp11
  cpp12
  cpp2
  py2
  java
  rtorb
  rtdis: /rtorb.host_cxt/ConsoleIn0.rtc:out to /rtorb.host_cxt/ConsoleOut0.rtc:in: not connected

Requests that only some refuse; nothing is left behind:

  $ each rtcon -p dataport.subscription_type=periodic 2>&1 | sed "s|$here||g"
  cpp11
  rtcon: /cpp11.host_cxt/ConsoleIn0.rtc:out to /cpp11.host_cxt/ConsoleOut0.rtc:in: a periodic connection needs a rate: dataport.publisher.push_rate=HZ
  cpp12
  rtcon: /cpp12.host_cxt/ConsoleIn0.rtc:out to /cpp12.host_cxt/ConsoleOut0.rtc:in: a periodic connection needs a rate: dataport.publisher.push_rate=HZ
  cpp2
  rtcon: /cpp2.host_cxt/ConsoleIn0.rtc:out to /cpp2.host_cxt/ConsoleOut0.rtc:in: a periodic connection needs a rate: dataport.publisher.push_rate=HZ
  py2
  rtcon: /py2.host_cxt/ConsoleIn0.rtc:out to /py2.host_cxt/ConsoleOut0.rtc:in: a periodic connection needs a rate: dataport.publisher.push_rate=HZ
  java
  rtcon: /java.host_cxt/ConsoleIn0.rtc:out to /java.host_cxt/ConsoleOut0.rtc:in: a periodic connection needs a rate: dataport.publisher.push_rate=HZ
  rtorb
  rtcon: /rtorb.host_cxt/ConsoleIn0.rtc:out to /rtorb.host_cxt/ConsoleOut0.rtc:in: /rtorb.host_cxt/ConsoleIn0.rtc:out has no subscription_type periodic (it has: flush)
  $ each rtdis 2>&1 | sed "s|$here||g"
  cpp11
  rtdis: /cpp11.host_cxt/ConsoleIn0.rtc:out to /cpp11.host_cxt/ConsoleOut0.rtc:in: not connected
  cpp12
  rtdis: /cpp12.host_cxt/ConsoleIn0.rtc:out to /cpp12.host_cxt/ConsoleOut0.rtc:in: not connected
  cpp2
  rtdis: /cpp2.host_cxt/ConsoleIn0.rtc:out to /cpp2.host_cxt/ConsoleOut0.rtc:in: not connected
  py2
  rtdis: /py2.host_cxt/ConsoleIn0.rtc:out to /py2.host_cxt/ConsoleOut0.rtc:in: not connected
  java
  rtdis: /java.host_cxt/ConsoleIn0.rtc:out to /java.host_cxt/ConsoleOut0.rtc:in: not connected
  rtorb
  rtdis: /rtorb.host_cxt/ConsoleIn0.rtc:out to /rtorb.host_cxt/ConsoleOut0.rtc:in: not connected
  $ each rtcon -p dataport.serializer.cdr.endian=middle 2>&1 | sed "s|$here||g"
  cpp11
  rtcon: /cpp11.host_cxt/ConsoleIn0.rtc:out to /cpp11.host_cxt/ConsoleOut0.rtc:in: refused by the component (UNSUPPORTED)
  cpp12
  rtcon: /cpp12.host_cxt/ConsoleIn0.rtc:out to /cpp12.host_cxt/ConsoleOut0.rtc:in: refused by the component (UNSUPPORTED)
  cpp2
  rtcon: /cpp2.host_cxt/ConsoleIn0.rtc:out to /cpp2.host_cxt/ConsoleOut0.rtc:in: refused by the component (UNSUPPORTED)
  py2
  rtcon: /py2.host_cxt/ConsoleIn0.rtc:out to /py2.host_cxt/ConsoleOut0.rtc:in: refused by the component (RTC_ERROR)
  java
  rtcon: /java.host_cxt/ConsoleIn0.rtc:out to /java.host_cxt/ConsoleOut0.rtc:in: refused by the component (UNSUPPORTED)
  rtorb
  rtcon: /rtorb.host_cxt/ConsoleIn0.rtc:out to /rtorb.host_cxt/ConsoleOut0.rtc:in: refused by the component (UNSUPPORTED)
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
