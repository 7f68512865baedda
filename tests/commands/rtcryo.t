rtcryo saves a running system as an RtsProfile.

world: these ConsoleIn ConsoleIn:ConsoleIn1 ConsoleOut ConsoleOut:ConsoleOut1 ConfigSample
world: services
world: these Mock SequenceInComponent --context away.host_cxt/%n.rtc

What takes long says on a terminal how far it is, and leaves nothing of that there:

  $ ctl @these hang ConsoleOut0 60
  $ TERM=xterm terminal 80 rtcryo --timeout 60 --all -o far.rtsys . > far.txt &
  $ soon 'grep "rtcryo: [0-9]* of [0-9]* components, waiting for [0-9]* s" far.txt'
  $ ctl @these hang ConsoleOut0 0
  $ wait $!
  $ tr '\r' '\n' < far.txt | tail -n 1
  \x1b[K (esc) (no-eol)
  $ TERM=dumb terminal 80 rtcryo --all -o far.rtsys .; rm far.*

Components, their configuration sets with the hidden ones, execution contexts, and connections:

  $ rtcon -i number -n n ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo > a.xml; sed 's/\(Date=\)"[^"]*"/\1"…"/g; s/\(iiop:127.0.0.1:\)[^"]*/\1…/' a.xml
  rtcryo: 7 components without connections left out; --all saves them, too
  <?xml version="1.0" encoding="UTF-8"?>
  <rts:RtsProfile xmlns:rts="http://www.openrtp.org/namespaces/rts" xmlns:rtsExt="http://www.openrtp.org/namespaces/rts_ext" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" rts:id="RTSystem:Me:RTSystem:0" rts:abstract="RT System created by rtcryo." rts:creationDate="…" rts:updateDate="…" rts:version="0.2">
      <rts:Components xsi:type="rtsExt:component_ext" rts:id="RTC:Shinji Kurihara:example:ConsoleIn:1.0" rts:pathUri="localhost:$PORT/test.host_cxt/ConsoleIn0.rtc" rts:activeConfigurationSet="default" rts:instanceName="ConsoleIn0" rts:compositeType="None" rts:isRequired="true" rtsExt:visible="true">
          <rts:DataPorts xsi:type="rtsExt:dataport_ext" rts:name="out" rtsExt:visible="true"/>
          <rts:ConfigurationSets rts:id="default"/>
          <rts:ExecutionContexts xsi:type="rtsExt:execution_context_ext" rts:id="0" rts:kind="PERIODIC" rts:rate="1000.0"/>
          <rtsExt:Location rtsExt:x="0" rtsExt:y="0" rtsExt:height="0" rtsExt:width="0" rtsExt:direction="DOWN"/>
          <rtsExt:Properties rtsExt:name="REFERENCE" rtsExt:value="corbaloc:iiop:127.0.0.1:…"/>
      </rts:Components>
      <rts:Components xsi:type="rtsExt:component_ext" rts:id="RTC:Shinji Kurihara:example:ConsoleOut:1.0" rts:pathUri="localhost:$PORT/test.host_cxt/ConsoleOut0.rtc" rts:activeConfigurationSet="default" rts:instanceName="ConsoleOut0" rts:compositeType="None" rts:isRequired="true" rtsExt:visible="true">
          <rts:DataPorts xsi:type="rtsExt:dataport_ext" rts:name="in" rtsExt:visible="true"/>
          <rts:ConfigurationSets rts:id="default"/>
          <rts:ExecutionContexts xsi:type="rtsExt:execution_context_ext" rts:id="0" rts:kind="PERIODIC" rts:rate="1000.0"/>
          <rtsExt:Location rtsExt:x="0" rtsExt:y="0" rtsExt:height="0" rtsExt:width="0" rtsExt:direction="DOWN"/>
          <rtsExt:Properties rtsExt:name="REFERENCE" rtsExt:value="corbaloc:iiop:127.0.0.1:…"/>
      </rts:Components>
      <rts:DataPortConnectors xsi:type="rtsExt:dataport_connector_ext" rts:connectorId="number" rts:name="n" rts:dataType="IDL:RTC/TimedLong:1.0" rts:interfaceType="corba_cdr" rts:dataflowType="push" rts:subscriptionType="new">
          <rts:sourceDataPort xsi:type="rtsExt:target_port_ext" rts:componentId="RTC:Shinji Kurihara:example:ConsoleIn:1.0" rts:instanceName="ConsoleIn0" rts:portName="ConsoleIn0.out">
              <rtsExt:Properties rtsExt:name="COMPONENT_PATH_ID" rtsExt:value="localhost:$PORT/test.host_cxt/ConsoleIn0.rtc"/>
          </rts:sourceDataPort>
          <rts:targetDataPort xsi:type="rtsExt:target_port_ext" rts:componentId="RTC:Shinji Kurihara:example:ConsoleOut:1.0" rts:instanceName="ConsoleOut0" rts:portName="ConsoleOut0.in">
              <rtsExt:Properties rtsExt:name="COMPONENT_PATH_ID" rtsExt:value="localhost:$PORT/test.host_cxt/ConsoleOut0.rtc"/>
          </rts:targetDataPort>
          <rtsExt:Properties rtsExt:name="dataport.data_type" rtsExt:value="IDL:RTC/TimedLong:1.0"/>
          <rtsExt:Properties rtsExt:name="dataport.dataflow_type" rtsExt:value="push"/>
          <rtsExt:Properties rtsExt:name="dataport.inport.data_type" rtsExt:value="IDL:RTC/TimedLong:1.0"/>
          <rtsExt:Properties rtsExt:name="dataport.interface_type" rtsExt:value="corba_cdr"/>
          <rtsExt:Properties rtsExt:name="dataport.outport.data_type" rtsExt:value="IDL:RTC/TimedLong:1.0"/>
          <rtsExt:Properties rtsExt:name="dataport.serializer.cdr.endian" rtsExt:value="little,big"/>
          <rtsExt:Properties rtsExt:name="dataport.subscription_type" rtsExt:value="new"/>
      </rts:DataPortConnectors>
  </rts:RtsProfile>

In YAML:

  $ rtcryo -y | sed '/Date:/,/year:/d; s/\(iiop:127.0.0.1:\).*/\1…/'
  rtcryo: 7 components without connections left out; --all saves them, too
  rtsProfile:
    abstract: RT System created by rtcryo.
    components:
    - activeConfigurationSet: default
      compositeType: None
      configurationSets:
      - id: default
      dataPorts:
      - name: out
        rtsExt::visible: true
      executionContexts:
      - id: '0'
        kind: PERIODIC
        rate: 1000.0
      id: RTC:Shinji Kurihara:example:ConsoleIn:1.0
      instanceName: ConsoleIn0
      isRequired: true
      pathUri: localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
      rtsExt::location:
        direction: DOWN
        height: 0
        width: 0
        x: 0
        y: 0
      rtsExt::properties:
      - name: REFERENCE
        value: corbaloc:iiop:127.0.0.1:…
      rtsExt::visible: true
    - activeConfigurationSet: default
      compositeType: None
      configurationSets:
      - id: default
      dataPorts:
      - name: in
        rtsExt::visible: true
      executionContexts:
      - id: '0'
        kind: PERIODIC
        rate: 1000.0
      id: RTC:Shinji Kurihara:example:ConsoleOut:1.0
      instanceName: ConsoleOut0
      isRequired: true
      pathUri: localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
      rtsExt::location:
        direction: DOWN
        height: 0
        width: 0
        x: 0
        y: 0
      rtsExt::properties:
      - name: REFERENCE
        value: corbaloc:iiop:127.0.0.1:…
      rtsExt::visible: true
    dataPortConnectors:
    - connectorId: number
      dataType: IDL:RTC/TimedLong:1.0
      dataflowType: push
      interfaceType: corba_cdr
      name: n
      rtsExt::properties:
      - name: dataport.data_type
        value: IDL:RTC/TimedLong:1.0
      - name: dataport.dataflow_type
        value: push
      - name: dataport.inport.data_type
        value: IDL:RTC/TimedLong:1.0
      - name: dataport.interface_type
        value: corba_cdr
      - name: dataport.outport.data_type
        value: IDL:RTC/TimedLong:1.0
      - name: dataport.serializer.cdr.endian
        value: little,big
      - name: dataport.subscription_type
        value: new
      sourceDataPort:
        componentId: RTC:Shinji Kurihara:example:ConsoleIn:1.0
        instanceName: ConsoleIn0
        portName: ConsoleIn0.out
        rtsExt::properties:
        - name: COMPONENT_PATH_ID
          value: localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
      subscriptionType: new
      targetDataPort:
        componentId: RTC:Shinji Kurihara:example:ConsoleOut:1.0
        instanceName: ConsoleOut0
        portName: ConsoleOut0.in
        rtsExt::properties:
        - name: COMPONENT_PATH_ID
          value: localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
    id: RTSystem:Me:RTSystem:0
    version: '0.2'

What a file says, in the other form; nobody is asked:

  $ RTCTREE_NAMESERVERS=localhost:1 rtcryo --from a.xml -y -o a.yaml; head -n 2 a.yaml
  rtsProfile:
    abstract: RT System created by rtcryo.
  $ rtcryo --from - <a.yaml | cmp - a.xml && rtcryo --from a.yaml --yaml | cmp - a.yaml && echo same
  same
  $ head -n 43 a.yaml | rtcryo --from -; head -n 43 a.yaml | rtcheck
  rtcryo: -:2:3: id is missing; perhaps the file was cut off
  rtcheck: -:2:3: id is missing; perhaps the file was cut off
  [1]
  $ rtcryo --from a.xml -n Arm
  rtcryo: --from goes with -o, -x and -y only: it writes what the file says (see --help)
  [2]
  $ rtcryo --from a.xml --all
  rtcryo: --from goes with -o, -x and -y only: it writes what the file says (see --help)
  [2]
  $ rtcryo --from a.xml localhost
  rtcryo: --from goes with -o, -x and -y only: it writes what the file says (see --help)
  [2]
  $ rtcryo --from nosuch.xml
  rtcryo: nosuch.xml: No such file or directory
  [1]

Everything that a system can have: service connections, one with three ends, a connection within one component:

  $ rtcon -i all ConsoleIn1.rtc:out ConsoleOut0.rtc:in ConsoleOut1.rtc:in
  $ rtcon -i service MyServiceConsumer0.rtc:MyService MyServiceProvider0.rtc:MyService
  $ rtcon -i self ../away.host_cxt/Mock0.rtc:out ../away.host_cxt/Mock0.rtc:in -p 'a "b"=<c>&'
  $ rtcryo > b.xml
  rtcryo: 2 components without connections left out; --all saves them, too
  $ grep -o -E 'pathUri="[^"]*"|connectorId="[^"]*"|portName="[^"]*"|<rtsExt:FurtherEnds|"a &quot.*"' b.xml
  pathUri="localhost:$PORT/away.host_cxt/Mock0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConsoleIn0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConsoleIn1.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConsoleOut0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConsoleOut1.rtc"
  pathUri="localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc"
  connectorId="self"
  portName="Mock0.out"
  portName="Mock0.in"
  "a &quot;b&quot;" rtsExt:value="&lt;c&gt;&amp;"
  connectorId="number"
  portName="ConsoleIn0.out"
  portName="ConsoleOut0.in"
  connectorId="all"
  portName="ConsoleIn1.out"
  portName="ConsoleOut0.in"
  <rtsExt:FurtherEnds
  portName="ConsoleOut1.in"
  connectorId="service"
  portName="MyServiceConsumer0.MyService"
  portName="MyServiceProvider0.MyService"

References are left out: they say where a port is today, and mislead tomorrow.

  $ rtcat -ll MyServiceConsumer0.rtc:MyService | grep -c IOR:
  2
  $ grep -c IOR: b.xml
  0
  [1]

The same system gives the same file, apart from its dates, in both forms:

  $ rtcryo | grep -v Date= > c; grep -v Date= b.xml | cmp - c
  rtcryo: 2 components without connections left out; --all saves them, too
  $ rtcryo -y | sed '/Date:/,/year:/d' > c.yaml; rtcryo --yaml | sed '/Date:/,/year:/d' | cmp - c.yaml
  rtcryo: 2 components without connections left out; --all saves them, too
  rtcryo: 2 components without connections left out; --all saves them, too

--all takes components without connections, too:

  $ rtcryo --all | grep -o 'pathUri="[^"]*"'
  pathUri="localhost:$PORT/away.host_cxt/Mock0.rtc"
  pathUri="localhost:$PORT/away.host_cxt/SequenceInComponent0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConfigSample0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConsoleIn0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConsoleIn1.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConsoleOut0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/ConsoleOut1.rtc"
  pathUri="localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc"
  pathUri="localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc"
  $ rtcryo --all | sed -n '/ConfigSample0/,/ExecutionContexts/p' |
  >     grep -v 'rtsExt:\|int_param[1-9]\|<rts:ConfigurationData rts:name="[dsv]'
          <rts:ConfigurationSets rts:id="__constraints__">
              <rts:ConfigurationData rts:name="int_param0" rts:data="0&lt;=x&lt;=150"/>
          </rts:ConfigurationSets>
          <rts:ConfigurationSets rts:id="__widget__">
              <rts:ConfigurationData rts:name="int_param0" rts:data="slider.10"/>
          </rts:ConfigurationSets>
          <rts:ConfigurationSets rts:id="default">
              <rts:ConfigurationData rts:name="int_param0" rts:data="0"/>
          </rts:ConfigurationSets>
          <rts:ConfigurationSets rts:id="mode0">
              <rts:ConfigurationData rts:name="int_param0" rts:data="12345"/>
          </rts:ConfigurationSets>
          <rts:ConfigurationSets rts:id="mode1">
              <rts:ConfigurationData rts:name="int_param0" rts:data="-999"/>
          </rts:ConfigurationSets>

What the system is called, and where it is written; --verbose reports what was saved:

  $ rtcryo -n Arm -e 'Robot & Co' -v 2.1 -a 'two arms' -o arm.rtsys --verbose
  rtcryo: 2 components without connections left out; --all saves them, too
  rtcryo: 7 components, 3 data and 1 service connections
  $ grep -o 'rts:id="RTSys[^"]*" rts:abstract="[^"]*"' arm.rtsys
  rts:id="RTSystem:Robot &amp; Co:Arm:2.1" rts:abstract="two arms"
  $ rtcryo --system-name=Arm --vendor Lab --system-version 3 --abstract= --output arm.rtsys -x
  rtcryo: 2 components without connections left out; --all saves them, too
  $ grep -o 'rts:id="RTSys[^"]*" rts:abstract="[^"]*"' arm.rtsys
  rts:id="RTSystem:Lab:Arm:3" rts:abstract=""
  $ rtcryo -x -y | head -1; rtcryo -y --xml | head -1
  rtcryo: 2 components without connections left out; --all saves them, too
  rtsProfile:
  rtcryo: 2 components without connections left out; --all saves them, too
  <?xml version="1.0" encoding="UTF-8"?>

Only some name servers, or a part of one; what is connected to the outside is reported:

  $ rtcryo localhost:$PORT | grep -c pathUri
  rtcryo: 2 components without connections left out; --all saves them, too
  7
  $ rtcryo /localhost:$PORT/away.host_cxt | grep -o 'pathUri="[^"]*"'
  rtcryo: 1 component without connections left out; --all saves them, too
  pathUri="localhost:$PORT/away.host_cxt/Mock0.rtc"
  $ rtcon -i far ConsoleIn0.rtc:out ../away.host_cxt/SequenceInComponent0.rtc:Long
  $ rtcryo localhost:$PORT/test.host_cxt | grep -c far
  rtcryo: connection far of /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: its end /localhost:$PORT/away.host_cxt/SequenceInComponent0.rtc:Long is not in the system, left out
  rtcryo: 1 component without connections left out; --all saves them, too
  0
  [1]
  $ rtcryo -q localhost:$PORT/test.host_cxt | grep -c far
  0
  [1]

What it costs: nothing is asked twice, and the profile comes last.

  $ ctl @these reset
  $ rtcryo > b.xml
  rtcryo: 1 component without connections left out; --all saves them, too
  $ calls @these ConsoleOut1
  1 get_active_configuration_set
  1 get_component_profile
  1 get_configuration
  1 get_configuration_sets
  1 get_context_handle
  1 get_owned_contexts
  1 get_owned_organizations
  1 get_port_profile
  1 get_ports
  1 get_profile

A name server that is not there, a path that is malformed, a file that cannot be written; the old file stays:

  $ rtcryo localhost:1 -o arm.rtsys
  rtcryo: /localhost:1: connection refused; is the name server running?
  [4]
  $ rtcryo localhost:1 localhost:$PORT -o both.xml; grep -c pathUri both.xml
  rtcryo: /localhost:1: connection refused; is the name server running?
  rtcryo: 1 component without connections left out; --all saves them, too
  8
  $ rtcryo localhost:$PORT/nothing.host_cxt
  rtcryo: /localhost:$PORT/nothing.host_cxt: no such path
  [3]
  $ rtcryo robot.rtsys
  rtcryo: to write a file: -o robot.rtsys (see --help)
  [2]
  $ rtcryo -q -o robot.rtsys
  $ rtcheck -s Inactive robot.rtsys
  $ rm robot.rtsys
  $ rtcryo localhost:x
  rtcryo: /localhost:x: x is not a TCP port (1 to 65535)
  [2]
  $ rtcryo -o no/such/dir.xml
  rtcryo: 1 component without connections left out; --all saves them, too
  rtcryo: no/such/dir.xml: No such file or directory
  [1]
  $ rtcryo --json
  rtcryo: unrecognized arguments: --json (see --help)
  [2]
  $ grep -c pathUri arm.rtsys; ls -A
  7
  a.xml
  a.yaml
  arm.rtsys
  b.xml
  both.xml
  c
  c.yaml

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -o OUT SERVER
invocation: -y SERVER
invocation: --all SERVER
broken component: 0 5
examples: asking
