rtkeep convert makes an RtsProfile from a launch file of rtmlaunch.

world: these ConsoleIn ConsoleOut Motor Sensor Controller
world: services

  $ bare() { sed 's/^\[[0-9:]*\] //; s,/localhost:[0-9]*/,,g' "$@"; }
  $ cat > robot.launch <<'EOF'
  > <launch>
  >   <arg name="WALKING" default="false"/>
  >   <arg name="ROBOT" default="ConsoleIn0"/>
  >   <arg name="SOURCE" default="$(arg ROBOT)"/>
  >   <arg name="kind" default="new"/>
  >   <include file="other.launch"/>
  >   <node name="bridge" pkg="p" type="t"/> <node name="launch" pkg="openrtm_tools" type="rtmlaunch.py"/>
  >   <group if="$(arg WALKING)">
  >     <rtactivate component="Motor0.rtc"/>
  >     <rtconnect from="Controller0.rtc:out" to="Motor0.rtc:in" subscription_type="periodic" push_rate="20" buffer_length="4"/>
  >   </group>
  >   <group unless="$(arg WALKING)">
  >     <rtactivate component="Sensor0.rtc"/>
  >   </group>
  >   <rtconnect from="$(arg SOURCE).rtc:out" to="ConsoleOut0.rtc:in" subscription_type="$(arg kind)" push_policy="all"/>
  >   <rtconnect from="$(arg SOURCE).rtc:out" to="ConsoleOut0.rtc:in" if="$(arg WALKING)"/>
  >   <rtactivate component="ConsoleOut0.rtc"/> <rtactivate component="$(arg SOURCE).rtc"/>
  > </launch>
  > EOF
  $ rtkeep convert robot.launch -o still.rtsys
  rtkeep: 1 <include> left out
  rtkeep: 2 <node> left out
  $ rtkeep convert robot.launch WALKING:=true -y -q > walking.rtsys
  $ sed -n '/Connectors /,/DataPortConnectors>/p; /targets/p' still.rtsys
      <rts:DataPortConnectors xsi:type="rtsExt:dataport_connector_ext" rts:connectorId="ConsoleIn0.out_ConsoleOut0.in" rts:name="ConsoleIn0.out_ConsoleOut0.in" rts:dataType="" rts:interfaceType="corba_cdr" rts:dataflowType="push" rts:subscriptionType="new">
          <rts:sourceDataPort xsi:type="rtsExt:target_port_ext" rts:componentId="" rts:instanceName="ConsoleIn0" rts:portName="out">
              <rtsExt:Properties rtsExt:name="COMPONENT_PATH_ID" rtsExt:value="localhost:$PORT/ConsoleIn0.rtc"/>
          </rts:sourceDataPort>
          <rts:targetDataPort xsi:type="rtsExt:target_port_ext" rts:componentId="" rts:instanceName="ConsoleOut0" rts:portName="in">
              <rtsExt:Properties rtsExt:name="COMPONENT_PATH_ID" rtsExt:value="localhost:$PORT/ConsoleOut0.rtc"/>
          </rts:targetDataPort>
          <rtsExt:Properties rtsExt:name="dataport.publisher.push_policy" rtsExt:value="all"/>
      </rts:DataPortConnectors>
          <rts:targets xsi:type="rtsExt:condition_ext" rts:sequence="1">
          </rts:targets>
          <rts:targets xsi:type="rtsExt:condition_ext" rts:sequence="2">
          </rts:targets>
          <rts:targets xsi:type="rtsExt:condition_ext" rts:sequence="3">
          </rts:targets>

Of these names components are kept, whatever their ids; those that the file does not activate stay as they are.

  $ sed "s,localhost:$PORT/,&test.host_cxt/," still.rtsys > still.here
  $ sed "s,localhost:$PORT/,&test.host_cxt/," walking.rtsys > walking.here
  $ rtkeep --once --within 60 still.here | bare | sort; rtls -l | awk '{print $1, $2, $6}'
  test.host_cxt/ConsoleIn0.rtc: Active
  test.host_cxt/ConsoleIn0.rtc: restored connection ConsoleIn0.out_ConsoleOut0.in
  test.host_cxt/ConsoleOut0.rtc: Active
  test.host_cxt/Sensor0.rtc: Active
  Active 1/1 ConsoleIn0.rtc
  Active 1/1 ConsoleOut0.rtc
  Inactive 2/0 Controller0.rtc
  Inactive 2/0 Motor0.rtc
  Inactive 1/0 MyServiceConsumer0.rtc
  Inactive 1/0 MyServiceProvider0.rtc
  Active 2/0 Sensor0.rtc
  $ rtkeep --once --within 60 walking.here | bare | sort
  test.host_cxt/Controller0.rtc: restored connection Controller0.out_Motor0.in
  test.host_cxt/Motor0.rtc: Active
  $ rtcat -ll Controller0.rtc:out | grep -e rate -e buffer.length -e policy
      dataport.buffer.length          4
      dataport.publisher.push_policy  all
      dataport.push_rate              20

The environment has values for arguments, as rtmlaunch's. What is wrong is said with its place:

  $ ROBOT=Other0 rtkeep convert -q robot.launch | grep -c Other0
  5
  $ try() { echo "<launch>$*</launch>" > p.launch; rtkeep convert p.launch > nul; }
  $ try '<rtactivate component="$(arg NAME).rtc"/>'
  rtkeep: p.launch:1:9: no value for the argument NAME: give NAME:=VALUE
  [1]
  $ try '<rtactivate/>'
  rtkeep: p.launch:1:9: <rtactivate> without component
  [1]
  $ try '<rtconnect from="A0.rtc" to="B0.rtc:in"/>'
  rtkeep: p.launch:1:9: from: not COMPONENT:PORT
  [1]
  $ try '<rtconnect from="A0.rtc:out" to="B0.rtc:in" subscription_type="fast"/>'
  rtkeep: p.launch:1:9: subscription_type: not one of flush, new, periodic: fast
  [1]
  $ try '<rtactivate component="A0.rtc" if="maybe"/>'
  rtkeep: p.launch:1:9: if: neither true nor false: maybe
  [1]
  $ try '<arg name="A" value="$(arg B)"/><rtactivate component="A0.rtc"/>'
  rtkeep: p.launch:1:9: no value for the argument B: give B:=VALUE
  [1]
  $ try '<arg name="A" default="$(arg A)"/><rtactivate component="$(arg A).rtc"/>'
  rtkeep: p.launch:1:43: component: arguments that contain themselves
  [1]
  $ echo '<!DOCTYPE x><launch/>' > p.launch; rtkeep convert p.launch
  rtkeep: p.launch:1:12: a DOCTYPE is not supported here
  [1]
  $ rtkeep convert; rtkeep convert robot.launch WALKING=true
  rtkeep: LAUNCH is missing (see --help)
  rtkeep: not NAME:=VALUE: WALKING=true (see --help)
  [2]
