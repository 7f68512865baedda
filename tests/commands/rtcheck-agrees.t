rtcheck and rtresurrect judge alike: what one finds to differ, the other mends, or says why it cannot.

world: these ConsoleIn ConsoleOut ConsoleIn:ConsoleIn1 ConsoleOut:ConsoleOut1
world: these Sensor

  $ rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in; rtcryo --all -q -o a.xml

A connection of this id that joins other ports is not the one in the file:

  $ rtdis ConsoleIn0.rtc
  $ rtcon -i one ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  $ rtcon -i one ConsoleIn1.rtc:out ConsoleOut0.rtc:in
  $ rtcheck -s inactive a.xml
  No connection between /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  [1]
  $ rtresurrect -q a.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in: connection one joins other ports; rtdis removes it
  [5]
  $ rtdis ConsoleIn0.rtc
  $ rtdis ConsoleIn1.rtc
  $ rtresurrect a.xml
  $ rtcheck -s inactive a.xml

Where the file gives a property twice, and not alike, the connector's own attribute counts:

  $ sed 's/dataflowType="push"/dataflowType="pull"/' a.xml > pull.xml; rtdis ConsoleIn0.rtc
  $ rtresurrect pull.xml
  $ rtcheck -s inactive pull.xml
  $ rtcheck -s inactive a.xml
  Property dataport.dataflow_type of connection from /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out to /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in is incorrect.
  [1]

A component without configuration, whose active set files call "default" nevertheless:

  $ rtcryo --all -q /localhost:$PORT/test.host_cxt/Sensor0.rtc | sed '/<rts:ConfigurationSets/d' > bare.xml
  $ ctl @these2 fail get_configuration 1 NO_IMPLEMENT; rtcheck -s inactive bare.xml
  $ ctl @these2 fail get_configuration 1 NO_IMPLEMENT; rtresurrect -v bare.xml
  rtresurrect: 3 already done
  $ sed 's/activeConfigurationSet="default"/activeConfigurationSet="fast"/' bare.xml > fast.xml
  $ rtcheck -s inactive fast.xml
  Wrong configuration set is active on /localhost:$PORT/test.host_cxt/Sensor0.rtc (Active set: default)
  [1]
  $ rtresurrect -q fast.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/Sensor0.rtc: no such configuration set: fast
  [5]

A component that is another than in the file:

  $ sed 's/instanceName="Sensor0"/instanceName="Eye0"/; s/Sensor:1.0/Eye:1.0/' bare.xml > other.xml
  $ rtcheck -s inactive other.xml
  Component instance names mismatched: Sensor0 != Eye0
  Component IDs mismatched: RTC:Shinji Kurihara, AIST:example:Sensor:1.0 != RTC:Shinji Kurihara, AIST:example:Eye:1.0
  [1]
  $ rtresurrect -q other.xml; rtstart -q other.xml
  rtresurrect: /localhost:$PORT/test.host_cxt/Sensor0.rtc: not a component named Eye0 (it is a component named Sensor0)
  rtstart: /localhost:$PORT/test.host_cxt/Sensor0.rtc: not a component named Eye0 (it is a component named Sensor0)
  [3]
