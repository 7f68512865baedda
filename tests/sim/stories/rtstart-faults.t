rtstart and rtstop where components are slow, silent, or die, and when they are interrupted: what is said is so.

world: two
world: these Slow Stuck
world: these Motor Sensor --flavour cpp11 --rate 50

  $ rtcryo --all -o all.xml

What takes longer than the timeout failed, --wait gives it more; what answers before it has changed is waited for:

  $ ctl @these delay activate_component 3
  $ rtstart -q --timeout 0.4 all.xml
  ! rtstart: /robot/test.host_cxt/Slow0.rtc: no answer within 0.4s; whether it has been done is not known
  ! rtstart: /robot/test.host_cxt/Stuck0.rtc: no answer within 0.4s; whether it has been done is not known
  [5] after 0.4 s
  $ ctl @these reset
  $ rtls -l
  Active    1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Active    1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Active    2/0  1/0  1/0  0/0  Motor0.rtc
  Active    2/0  1/0  1/0  0/0  Sensor0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
  Inactive  0/0  0/0  0/0  0/0  Stuck0.rtc
  $ rtstop -q --wait 2 all.xml
  [0] after 0.2 s
  $ rtstart -q --wait 2 all.xml
  ! rtstart: /robot/test.host_cxt/Stuck0.rtc: not Active within 2s, still Inactive
  [5] after 2.6 s

Ctrl-C and SIGTERM, during the checks too:

  $ ctl delay get_ports 9
  $ interrupt 1 rtstart --json -q --timeout 9 all.xml
  {"action": "activate", "context": "0", "error": "/robot/test.host_cxt/ConsoleIn0.rtc: not tried: interrupted", "number": 1, "path": "/robot/test.host_cxt/ConsoleIn0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/robot/test.host_cxt/ConsoleOut0.rtc: not tried: interrupted", "number": 2, "path": "/robot/test.host_cxt/ConsoleOut0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/robot/test.host_cxt/Motor0.rtc: not tried: interrupted", "number": 3, "path": "/robot/test.host_cxt/Motor0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/robot/test.host_cxt/Sensor0.rtc: not tried: interrupted", "number": 4, "path": "/robot/test.host_cxt/Sensor0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/robot/test.host_cxt/Slow0.rtc: not tried: interrupted", "number": 5, "path": "/robot/test.host_cxt/Slow0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/robot/test.host_cxt/Stuck0.rtc: not tried: interrupted", "number": 6, "path": "/robot/test.host_cxt/Stuck0.rtc", "required": true, "result": "not tried"}
  ! rtstart: /robot/test.host_cxt/ConsoleIn0.rtc: not tried: interrupted
  ! rtstart: /robot/test.host_cxt/ConsoleOut0.rtc: not tried: interrupted
  ! rtstart: /robot/test.host_cxt/Motor0.rtc: not tried: interrupted
  ! rtstart: /robot/test.host_cxt/Sensor0.rtc: not tried: interrupted
  ! rtstart: /robot/test.host_cxt/Slow0.rtc: not tried: interrupted
  ! rtstart: /robot/test.host_cxt/Stuck0.rtc: not tried: interrupted
  [130] after 1.0 s
  $ ctl reset

  $ insert all.xml c.xml
  > <rts:Activation>
  > <rts:targets rts:sequence="1"><rts:WaitTime rts:waitTime="9000"/><rts:TargetComponent rts:componentId="Sensor0" rts:instanceName="Sensor0" rts:id="0"/></rts:targets>
  > <rts:targets rts:sequence="2"><rts:Preceding rts:sendingTiming="SYNC" rts:timeout="0"><rts:PrecedingComponents rts:componentId="Sensor0" rts:instanceName="Sensor0" rts:id="0"/></rts:Preceding><rts:TargetComponent rts:componentId="ConsoleIn0" rts:instanceName="ConsoleIn0" rts:id="0"/></rts:targets>
  > </rts:Activation>
  $ rtdeact --wait ConsoleIn0.rtc Sensor0.rtc
  [0] after 0.2 s
  $ interrupt 4 rtstart -q --wait 9 c.xml
  ! rtstart: /robot/test.host_cxt/ConsoleIn0.rtc: not tried: interrupted
  ! rtstart: /robot/test.host_cxt/Sensor0.rtc: not tried: interrupted
  ! rtstart: /robot/test.host_cxt/Stuck0.rtc: interrupted; whether it has been done is not known
  [130] after 4.0 s
  $ terminate 4 rtstart --json --wait 9 c.xml
  {"action": "activate", "context": "0", "error": null, "number": 2, "path": "/robot/test.host_cxt/ConsoleOut0.rtc", "required": true, "result": "already"}
  {"action": "activate", "context": "0", "error": null, "number": 5, "path": "/robot/test.host_cxt/Slow0.rtc", "required": true, "result": "already"}
  {"action": "activate", "context": "0", "error": null, "number": 3, "path": "/robot/test.host_cxt/Motor0.rtc", "required": true, "result": "already"}
  {"action": "activate", "context": "0", "error": "/robot/test.host_cxt/ConsoleIn0.rtc: not tried: interrupted", "number": 1, "path": "/robot/test.host_cxt/ConsoleIn0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/robot/test.host_cxt/Sensor0.rtc: not tried: interrupted", "number": 4, "path": "/robot/test.host_cxt/Sensor0.rtc", "required": true, "result": "not tried"}
  {"action": "activate", "context": "0", "error": "/robot/test.host_cxt/Stuck0.rtc: interrupted; whether it has been done is not known", "number": 6, "path": "/robot/test.host_cxt/Stuck0.rtc", "required": true, "result": "uncertain"}
  ! Executing {2} Activate /robot/test.host_cxt/ConsoleOut0.rtc in execution context 0 (Required)
  ! Executing {3} Activate /robot/test.host_cxt/Motor0.rtc in execution context 0 (Required)
  ! Executing {5} Activate /robot/test.host_cxt/Slow0.rtc in execution context 0 (Required)
  ! Executing {6} Activate /robot/test.host_cxt/Stuck0.rtc in execution context 0 (Required)
  ! rtstart: /robot/test.host_cxt/ConsoleIn0.rtc: not tried: interrupted
  ! rtstart: /robot/test.host_cxt/Sensor0.rtc: not tried: interrupted
  ! rtstart: /robot/test.host_cxt/Stuck0.rtc: interrupted; whether it has been done is not known
  [143] after 4.0 s
  $ rtexit --wait=5 Stuck0.rtc
  [0] after 0.7 s
  $ rtcryo --all -o all.xml
  $ rtstop -q all.xml
  [0] after 0.8 s

Sync waits for the state, After does not:

  $ insert all.xml b.xml
  > <rts:Activation>
  > <rts:targets rts:sequence="1"><rts:Preceding rts:sendingTiming="SYNC" rts:timeout="400"><rts:PrecedingComponents rts:componentId="Slow0" rts:instanceName="Slow0" rts:id="0"/></rts:Preceding><rts:TargetComponent rts:componentId="ConsoleIn0" rts:instanceName="ConsoleIn0" rts:id="0"/></rts:targets>
  > <rts:targets rts:sequence="1"><rts:Preceding rts:sendingTiming="ASYNC" rts:timeout="1000"><rts:PrecedingComponents rts:componentId="Motor0" rts:instanceName="Motor0" rts:id="0"/></rts:Preceding><rts:TargetComponent rts:componentId="ConsoleOut0" rts:instanceName="ConsoleOut0" rts:id="0"/></rts:targets>
  > <rts:targets rts:sequence="1"><rts:WaitTime rts:waitTime="1"/><rts:TargetComponent rts:componentId="Slow0" rts:instanceName="Slow0" rts:id="0"/></rts:targets>
  > <rts:targets rts:sequence="1"><rts:WaitTime rts:waitTime="1"/><rts:TargetComponent rts:componentId="Motor0" rts:instanceName="Motor0" rts:id="0"/></rts:targets>
  > </rts:Activation>
  $ rtstart -q b.xml
  ! rtstart: /robot/test.host_cxt/ConsoleIn0.rtc: not tried: Sync to Slow0: not Active within 400ms
  [5] after 0.9 s
  $ rtls -l
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Active    1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Active    2/0  1/0  1/0  0/0  Motor0.rtc
  Active    2/0  1/0  1/0  0/0  Sensor0.rtc
  Active    1/0  0/0  1/0  0/0  Slow0.rtc
  $ rtstop -q all.xml
  [0] after 0.8 s

A call whose answer is lost may have been heard: the state shows it, and where it cannot, rtstart says so

  $ ctl @two fail activate_component 1 HANG
  $ rtstart -q --timeout 1 all.xml
  ! rtstart: /robot/test.host_cxt/ConsoleIn0.rtc: no answer within 1s; it is Inactive now
  [5] after 1.1 s
  $ ctl @two reset
  $ rtstart -q all.xml
  [0] after 0.1 s
  $ rtls -l
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Active  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Active  2/0  1/0  1/0  0/0  Motor0.rtc
  Active  2/0  1/0  1/0  0/0  Sensor0.rtc
  Active  1/0  0/0  1/0  0/0  Slow0.rtc
  $ rtstop -q all.xml
  [0] after 0.8 s
  $ ctl @two fail activate_component 1 COMM_FAILURE
  $ rtstart -q all.xml
  ! rtstart: /robot/test.host_cxt/ConsoleIn0.rtc: connection lost; it is Inactive now
  [5] after 0.8 s
  $ rtstop -q all.xml
  [0] after 0.8 s
  $ ctl @two delay activate_component 2
  $ insert all.xml d.xml
  > <rts:Activation>
  > <rts:targets rts:sequence="1"><rts:TargetComponent rts:componentId="ConsoleIn0" rts:instanceName="ConsoleIn0" rts:id="0"/></rts:targets>
  > <rts:targets rts:sequence="2"><rts:TargetComponent rts:componentId="Slow0" rts:instanceName="Slow0" rts:id="0"/></rts:targets>
  > <rts:targets rts:sequence="3"><rts:TargetComponent rts:componentId="ConsoleOut0" rts:instanceName="ConsoleOut0" rts:id="0"/></rts:targets>
  > </rts:Activation>
  $ rtstart -q d.xml --timeout 1
  ! rtstart: /robot/test.host_cxt/ConsoleIn0.rtc: no answer within 1s; whether it has been done is not known
  ! rtstart: /robot/test.host_cxt/Slow0.rtc: not tried: it comes after /robot/test.host_cxt/ConsoleIn0.rtc, which failed
  ! rtstart: /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it comes after /robot/test.host_cxt/ConsoleIn0.rtc, which failed
  [5] after 1.1 s
  $ sleep 2
  $ ctl @two state ConsoleIn0
  ACTIVE
  $ ctl @two reset
  $ rtstop -q all.xml
  [0] after 0.2 s
  $ ctl @two fail activate_component 1 DIE
  $ rtstart -q d.xml
  ! rtstart: /robot/test.host_cxt/ConsoleIn0.rtc: connection refused; its process is gone (zombie)
  ! rtstart: /robot/test.host_cxt/Slow0.rtc: not tried: it comes after /robot/test.host_cxt/ConsoleIn0.rtc, which failed
  ! rtstart: /robot/test.host_cxt/ConsoleOut0.rtc: not tried: it comes after /robot/test.host_cxt/ConsoleIn0.rtc, which failed
  [5] after 0.1 s
  $ rtls -l
  -         -    -    -    -    *ConsoleIn0.rtc
  -         -    -    -    -    *ConsoleOut0.rtc
  Active    2/0  1/0  1/0  0/0  Motor0.rtc
  Active    2/0  1/0  1/0  0/0  Sensor0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
  $ rtdel -z
  $ mock two
  $ rtstart -q d.xml
  [0] after 1.0 s
  $ rtls -l
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Active  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Active  2/0  1/0  1/0  0/0  Motor0.rtc
  Active  2/0  1/0  1/0  0/0  Sensor0.rtc
  Active  1/0  0/0  1/0  0/0  Slow0.rtc
