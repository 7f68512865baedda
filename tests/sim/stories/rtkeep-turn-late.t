What a component comes after is absent when its turn comes, and Active before those beside it are.

world: these Slow:A0 ConsoleOut
world: these Sensor

  $ rtcryo --all -o a.xml
  $ insert a.xml b.xml
  > <rts:Activation>
  > <rts:targets rts:sequence="1"><rts:Preceding rts:sendingTiming="SYNC" rts:timeout="0"><rts:PrecedingComponents rts:componentId="Sensor0" rts:instanceName="Sensor0" rts:id="0"/></rts:Preceding><rts:TargetComponent rts:componentId="ConsoleOut0" rts:instanceName="ConsoleOut0" rts:id="0"/></rts:targets>
  > </rts:Activation>
  $ restart these2
  $ sleep 0.2
  $ rtkeep b.xml &
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:01] /robot/test.host_cxt/A0.rtc: Active
  [08:00:02] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  $ rtcheck b.xml
