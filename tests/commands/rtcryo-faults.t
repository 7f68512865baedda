What rtcryo makes of systems that are broken, hostile, composed, or empty. (What hangs: tests/sim/stories/rtcryo-faults.t.)

server: composites
server: empty
world: hostile
world: names
world: orphan --context orphan.host_cxt/%n.rtc
world: fragile --context fragile.host_cxt/%n.rtc
world: composite --nameserver localhost:$PORT2

Components whose peer has died forget the connection when they are asked for their ports; none dies of being asked:

  $ for home in orphan fragile; do
  >     rtcryo localhost:$PORT/$home.host_cxt | grep -o -E 'pathUri="[^"]*"|connectorId="[^"]*"'
  >     rtls ../$home.host_cxt
  > done
  rtcryo: /localhost:$PORT/orphan.host_cxt/Peer0.rtc: zombie, left out
  rtcryo: 1 component without connections left out; --all saves them, too
  Orphan0.rtc
  *Peer0.rtc
  rtcryo: /localhost:$PORT/fragile.host_cxt/Peer0.rtc: zombie, left out
  rtcryo: 1 component without connections left out; --all saves them, too
  Fragile0.rtc
  *Peer0.rtc

Hostile names and values come through both forms:

  $ rtcryo -q --timeout 10 localhost:$PORT/test.host_cxt -o h.xml
  $ rtcryo -q --timeout 10 -y localhost:$PORT/test.host_cxt -o h.yaml
  $ grep -o 'pathUri="[^"]*"' h.xml
  pathUri="localhost:$PORT/test.host_cxt/Hostile0.rtc"
  $ rtcheck -s inactive h.xml
  $ rtcheck -s inactive h.yaml
  $ rtstodot h.xml | grep -c -e '->'
  1
  $ grep -c 'Configuration' h.xml
  25

A composite is saved with its members, as soon as one of them is connected:

  $ rtcryo localhost:$PORT2 | grep -c pathUri
  rtcryo: 3 components and 1 composite without connections left out; --all saves them, too
  0
  [1]
  $ rtcon /localhost:$PORT2/test.host_cxt/composite0.rtc:Motor0.out \
  >     /localhost:$PORT2/test.host_cxt/Sensor0.rtc:in
  $ rtcryo localhost:$PORT2 |
  >     grep -o -E 'pathUri="[^"]*"|<rts:Participant.*|compositeType="P[^"]*"|portName="[^"]*"|DataPorts.*name="[^"]*"'
  pathUri="localhost:$PORT2/test.host_cxt/Controller0.rtc"
  DataPorts xsi:type="rtsExt:dataport_ext" rts:name="in"
  DataPorts xsi:type="rtsExt:dataport_ext" rts:name="out"
  pathUri="localhost:$PORT2/test.host_cxt/Motor0.rtc"
  DataPorts xsi:type="rtsExt:dataport_ext" rts:name="in"
  DataPorts xsi:type="rtsExt:dataport_ext" rts:name="out"
  pathUri="localhost:$PORT2/test.host_cxt/Sensor0.rtc"
  DataPorts xsi:type="rtsExt:dataport_ext" rts:name="in"
  DataPorts xsi:type="rtsExt:dataport_ext" rts:name="out"
  pathUri="localhost:$PORT2/test.host_cxt/composite0.rtc"
  compositeType="PeriodicECShared"
  DataPorts xsi:type="rtsExt:dataport_ext" rts:name="Sensor0.in"
  DataPorts xsi:type="rtsExt:dataport_ext" rts:name="Motor0.out"
  <rts:Participants>
  <rts:Participant xsi:type="rtsExt:target_component_ext" rts:componentId="RTC:Shinji Kurihara, AIST:example:Controller:1.0" rts:instanceName="Controller0">
  <rts:Participants>
  <rts:Participant xsi:type="rtsExt:target_component_ext" rts:componentId="RTC:Shinji Kurihara, AIST:example:Motor:1.0" rts:instanceName="Motor0">
  <rts:Participants>
  <rts:Participant xsi:type="rtsExt:target_component_ext" rts:componentId="RTC:Shinji Kurihara, AIST:example:Sensor:1.0" rts:instanceName="Sensor0">
  portName="Motor0.out"
  portName="Sensor0.in"

A member that is gone from the name server is named:

  $ rtdel -f /localhost:$PORT2/test.host_cxt/Controller0.rtc
  $ rtcryo localhost:$PORT2 | grep -c pathUri
  rtcryo: /localhost:$PORT2/test.host_cxt/composite0.rtc: its member Controller0 is not in the system, left out
  3

Nothing at all:

  $ rtcryo localhost:$PORT3 -o empty.xml; grep -c RtsProfile empty.xml
  rtcryo: no components
  1
  $ rtcryo --all -q localhost:$PORT3 | grep -c RtsProfile
  1
