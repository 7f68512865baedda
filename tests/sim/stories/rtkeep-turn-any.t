What is kept in any state counts for what comes after it as soon as it has been looked at.

world: these Sensor
world: these ConsoleOut

  $ write b.xml
  > <?xml version="1.0" encoding="UTF-8"?>
  > <rts:RtsProfile xmlns:rts="http://www.openrtp.org/namespaces/rts" xmlns:rtsExt="http://www.openrtp.org/namespaces/rts_ext" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" rts:id="RTSystem:Me:RTSystem:0" rts:abstract="RT System created by rtcryo." rts:creationDate="2027-01-15T08:00:00" rts:updateDate="2027-01-15T08:00:00" rts:version="0.2">
  >     <rts:Components xsi:type="rtsExt:component_ext" rts:id="RTC:Shinji Kurihara:example:ConsoleOut:1.0" rts:pathUri="robot/test.host_cxt/ConsoleOut0.rtc" rts:activeConfigurationSet="default" rts:instanceName="ConsoleOut0" rts:compositeType="None" rts:isRequired="true" rtsExt:visible="true">
  >         <rts:DataPorts xsi:type="rtsExt:dataport_ext" rts:name="in" rtsExt:visible="true"/>
  >         <rts:ConfigurationSets rts:id="default"/>
  >         <rts:ExecutionContexts xsi:type="rtsExt:execution_context_ext" rts:id="0" rts:kind="PERIODIC" rts:rate="1000.0"/>
  >         <rtsExt:Location rtsExt:x="0" rtsExt:y="0" rtsExt:height="0" rtsExt:width="0" rtsExt:direction="DOWN"/>
  >     </rts:Components>
  >     <rts:Components xsi:type="rtsExt:component_ext" rts:id="RTC:Shinji Kurihara, AIST:example:Sensor:1.0" rts:pathUri="robot/test.host_cxt/Sensor0.rtc" rts:activeConfigurationSet="default" rts:instanceName="Sensor0" rts:compositeType="None" rts:isRequired="true" rtsExt:visible="true">
  >         <rts:DataPorts xsi:type="rtsExt:dataport_ext" rts:name="in" rtsExt:visible="true"/>
  >         <rts:DataPorts xsi:type="rtsExt:dataport_ext" rts:name="out" rtsExt:visible="true"/>
  >         <rts:ConfigurationSets rts:id="default"/>
  >         <rts:ExecutionContexts xsi:type="rtsExt:execution_context_ext" rts:id="0" rts:kind="PERIODIC" rts:rate="1000.0"/>
  >         <rtsExt:Location rtsExt:x="0" rtsExt:y="0" rtsExt:height="0" rtsExt:width="0" rtsExt:direction="DOWN"/>
  >         <rtsExt:Properties rtsExt:name="keep.state" rtsExt:value="any"/>
  >     </rts:Components>
  > <rts:Activation>
  > <rts:targets rts:sequence="1"><rts:Preceding rts:sendingTiming="SYNC" rts:timeout="0"><rts:PrecedingComponents rts:componentId="Sensor0" rts:instanceName="Sensor0" rts:id="0"/></rts:Preceding><rts:TargetComponent rts:componentId="ConsoleOut0" rts:instanceName="ConsoleOut0" rts:id="0"/></rts:targets>
  > </rts:Activation>
  > </rts:RtsProfile>
  $ rtkeep --look 0.5 b.xml &
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  $ ctl delay get_ports 5
  $ rtkeep resume Sensor0
  $ sleep 4
  $ show rtkeep
  [08:00:08] /robot/test.host_cxt/Sensor0.rtc: no answer within 3s
  $ ctl @these2 error ConsoleOut0
  $ sleep 1
  $ show rtkeep
  [08:00:09] /robot/test.host_cxt/ConsoleOut0.rtc: in Error: reset
  [08:00:09] /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it waits for /robot/test.host_cxt/Sensor0.rtc, which failed
  $ ctl delay get_ports 0
  $ sleep 60
  $ show rtkeep
  [08:00:14] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  $ rtkeep status
  b.xml: pid 4, since 2027-01-15 08:00:00; all is as the file says
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active    2027-01-15 08:00:14    Active
    /robot/test.host_cxt/Sensor0.rtc      any     Inactive  2027-01-15 08:00:00    no answer within 3s
