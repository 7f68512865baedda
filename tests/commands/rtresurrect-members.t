rtresurrect --map renames the members of a composite in all that the composite says of them, too.

world: composite
world: these ConsoleOut --context a.host_cxt/%n.rtc
world: these Sensor:Sensor9 Motor:Motor9 Controller ConsoleOut PeriodicECSharedComposite:composite0 --context b.host_cxt/%n.rtc

  $ T=/localhost:$PORT/test.host_cxt; B=/localhost:$PORT/b.host_cxt
  $ rtcon -i one -n n $T/composite0.rtc:Motor0.out /localhost:$PORT/a.host_cxt/ConsoleOut0.rtc:in
  $ rtcryo --all $T /localhost:$PORT/a.host_cxt > a.xml
  $ M="-m test.host_cxt=b.host_cxt -m a.host_cxt=b.host_cxt -m Sensor0.rtc=Sensor9.rtc -m Motor0.rtc=Motor9.rtc"
  $ rtcomp $B/composite0.rtc -a $B/Controller0.rtc -a $B/Sensor9.rtc:in -a $B/Motor9.rtc:out

It keeps the ports that it exports, and connections of them that the file has as its own:

  $ sed '/sourceDataPort.*Motor0.out/{s/componentId="[^"]*"/componentId="RTC:jp.go.aist:composite.PeriodicECShared:PeriodicECSharedComposite:1.0"/;s/instanceName="Motor0"/instanceName="composite0"/;n;s/Motor0/composite0/;}' a.xml > b.xml
  $ grep -c composite0.rtc a.xml b.xml
  a.xml:1
  b.xml:2
  $ rtresurrect -v $M b.xml
  rtresurrect: configuration set default of /localhost:$PORT/b.host_cxt/composite0.rtc: done
  rtresurrect: connection one of /localhost:$PORT/b.host_cxt/composite0.rtc:Motor9.out to /localhost:$PORT/b.host_cxt/ConsoleOut0.rtc:in: done
  rtresurrect: 2 done, 19 already done
  $ rtresurrect $M a.xml
  $ rtconf -l $B/composite0.rtc
  -default*
    exported_ports  Sensor9.in, Motor9.out
    members         Sensor9, Controller0, Motor9
  $ rtls -l $B/composite0.rtc
  Inactive  2/1  1/0  1/1  0/0  composite0.rtc
  $ rtcheck -s inactive $M a.xml && rtcheck -s inactive $M b.xml

A map that takes two components to one place is refused by every command:

  $ rtstart --dry-run a.xml -m Sensor0.rtc=Motor0.rtc
  rtstart: /localhost:$PORT/test.host_cxt/Motor0.rtc: the file has two components here
  [1]
  $ rtcheck a.xml -m Sensor0.rtc=Motor0.rtc
  rtcheck: /localhost:$PORT/test.host_cxt/Motor0.rtc: the file has two components here
  [1]
