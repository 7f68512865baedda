rtresurrect --map restores a system that is elsewhere than it was: at another name server, host, context, under other names.

server: other
world: these ConsoleIn ConsoleOut --context old.host_cxt/arm.cxt/%n.rtc
world: these ConsoleIn ConsoleOut --nameserver localhost:$PORT2 --context new.host_cxt/%n.rtc
world: these ConsoleIn:Left ConsoleOut:Right --nameserver localhost:$PORT2 --context old.host_cxt/arm.cxt/%n.rtc

  $ O=/localhost:$PORT/old.host_cxt/arm.cxt; rtcon -i one -n n $O/ConsoleIn0.rtc:out $O/ConsoleOut0.rtc:in
  $ rtcryo localhost:$PORT > a.xml

A name server and contexts; each OLD means whole elements, and the longest that fits counts:

  $ rtresurrect -v --map localhost:$PORT=localhost:$PORT2 --map old.host_cxt/arm.cxt=new.host_cxt a.xml
  rtresurrect: connection one of /localhost:$PORT2/new.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT2/new.host_cxt/ConsoleOut0.rtc:in: done
  rtresurrect: 1 done, 6 already done
  $ rtteardown -v --map /localhost:$PORT/old.host_cxt/arm.cxt/=localhost:$PORT2/new.host_cxt a.xml
  rtteardown: connection one of /localhost:$PORT2/new.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT2/new.host_cxt/ConsoleOut0.rtc:in: done
  rtteardown: 1 done
  $ rtresurrect --dry-run -m old.host_cxt=x.cxt -m localhost:$PORT=localhost:$PORT2 -m arm.cxt=y.cxt \
  >     -m old.host_cxt/arm.cxt=new.host_cxt a.xml |
  >     wc -l
  1

Single components, which may have other names there:

  $ N=localhost:$PORT2/old.host_cxt/arm.cxt
  $ rtresurrect --map $O/ConsoleIn0.rtc=$N/Left.rtc -m /localhost:$PORT=localhost:$PORT2 \
  >     -m ConsoleOut0.rtc=Right.rtc -v a.xml
  rtresurrect: connection one of /localhost:$PORT2/old.host_cxt/arm.cxt/Left.rtc:out to /localhost:$PORT2/old.host_cxt/arm.cxt/Right.rtc:in: done
  rtresurrect: 1 done, 6 already done
  $ rtls -l /$N
  Inactive  1/1  0/0  1/1  0/0  Left.rtc
  Inactive  1/1  1/1  0/0  0/0  Right.rtc

Names can be exchanged, as each element is replaced once; but two components cannot be at one place:

  $ rtresurrect --dry-run --map ConsoleIn0.rtc=ConsoleOut0.rtc --map ConsoleOut0.rtc=ConsoleIn0.rtc a.xml
  rtresurrect: /localhost:$PORT/old.host_cxt/arm.cxt/ConsoleOut0.rtc: not a RTC:Shinji Kurihara:example:ConsoleIn:1.0 (it is a RTC:Shinji Kurihara:example:ConsoleOut:1.0)
  rtresurrect: /localhost:$PORT/old.host_cxt/arm.cxt/ConsoleIn0.rtc: not a RTC:Shinji Kurihara:example:ConsoleOut:1.0 (it is a RTC:Shinji Kurihara:example:ConsoleIn:1.0)
  [3]
  $ rtresurrect --map ConsoleIn0.rtc=ConsoleOut0.rtc a.xml
  rtresurrect: /localhost:$PORT/old.host_cxt/arm.cxt/ConsoleOut0.rtc: the file has two components here
  [1]

Whom the file names must stay clear:

  $ rtcryo -q --all localhost:$PORT localhost:$PORT2 > all.xml
  $ rtcheck --dry-run -m $O/ConsoleIn0.rtc=$O/Left.rtc all.xml | grep -c $O/Left.rtc:out
  1
  $ sed /COMPONENT_PATH_ID/d all.xml | rtcheck --dry-run -m $O/ConsoleIn0.rtc=$O/Left.rtc
  rtcheck: ConsoleIn0 (RTC:Shinji Kurihara:example:ConsoleIn:1.0): there are several, of which --map renames some (the property COMPONENT_PATH_ID decides which is meant)
  [1]

What cannot be meant:

  $ rtresurrect --map old.host_cxt a.xml
  rtresurrect: not OLD=NEW: old.host_cxt (see --help)
  [2]
  $ rtresurrect --map = a.xml
  rtresurrect: not OLD=NEW: = (see --help)
  [2]
  $ rtresurrect --map /old.host_cxt=new.host_cxt a.xml
  rtresurrect: --map /old.host_cxt=new.host_cxt: nothing in the file is there (see --help)
  [2]
  $ rtresurrect --map localhost:$PORT=localhost:x a.xml
  rtresurrect: /localhost:x: x is not a TCP port (1 to 65535)
  [2]
  $ rtresurrect --map $O/ConsoleIn0.rtc=$O/ConsoleIn0.rtc:out a.xml
  rtresurrect: --map does not accept ports: localhost:$PORT/old.host_cxt/arm.cxt/ConsoleIn0.rtc:out (see --help)
  [2]

  $ rtcheck --map ..=other a.xml
  rtcheck: --map does not accept . or ..: .. (see --help)
  [2]
  $ rtcheck --map old.host_cxt=x/.. a.xml
  rtcheck: --map does not accept . or ..: x/.. (see --help)
  [2]

What is elsewhere can be checked, started, stopped and examined with the same file:

  $ M="-m localhost:$PORT=localhost:$PORT2 -m ConsoleIn0.rtc=Left.rtc -m ConsoleOut0.rtc=Right.rtc"
  $ rtteardown -q $M a.xml
  $ rtcheck -s inactive $M a.xml
  No connection between /localhost:$PORT2/old.host_cxt/arm.cxt/Left.rtc:out and /localhost:$PORT2/old.host_cxt/arm.cxt/Right.rtc:in
  [1]
  $ rtdoctor --profile a.xml -s Inactive $M localhost:$PORT2 | grep ^fail
  fail  /localhost:$PORT2/old.host_cxt/arm.cxt/Left.rtc:out and /localhost:$PORT2/old.host_cxt/arm.cxt/Right.rtc:in: No connection; try: rtresurrect -m localhost:$PORT=localhost:$PORT2 -m ConsoleIn0.rtc=Left.rtc -m ConsoleOut0.rtc=Right.rtc a.xml
  $ rtresurrect -q $M a.xml; rtstart -q $M a.xml
  $ sed 's/portName="\([a-z]*\)"\(.*instanceName="\([A-Za-z0-9]*\)"\)/portName="\3.\1"\2/' a.xml > b.xml
  $ grep -c 'ConsoleIn0.out\|ConsoleOut0.in' b.xml
  2
  $ rtcheck $M a.xml && rtcheck $M b.xml
  $ rtstop -q $M a.xml
  $ rtcheck -s inactive a.xml -m ConsoleIn0.rtc=Gone.rtc
  Required component missing: /localhost:$PORT/old.host_cxt/arm.cxt/Gone.rtc
  [1]
  $ rtstart --dry-run a.xml -m nowhere=b
  rtstart: --map nowhere=b: nothing in the file is there (see --help)
  [2]
  $ rtdoctor -m a=b
  rtdoctor: --map is for --profile (see --help)
  [2]
