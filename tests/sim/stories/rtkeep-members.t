rtkeep gives a composite back the member that it has lost. As long as the composite refuses that, the component alone is as before:
what a person does to it is left alone.

world: composite

  $ rtcryo --all -o a.xml
  $ insert a.xml b.xml
  > <rts:Activation>
  > <rts:targets rts:sequence="1"><rts:TargetComponent rts:componentId="Motor0" rts:instanceName="Motor0" rts:id="0"/></rts:targets>
  > </rts:Activation>
  $ rtkeep --delay 2-3 --look 0.2 b.xml &
  $ sleep 5
  $ show rtkeep
  [08:00:00] /robot/test.host_cxt/Controller0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Motor0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:00:00] /robot/test.host_cxt/composite0.rtc: Active
  $ ctl fail add_members 1 BAD_PARAM
  $ ctl fail add_members 2 BAD_PARAM
  $ ctl fail add_members 3 BAD_PARAM
  $ ctl fail add_members 4 BAD_PARAM
  $ rtcomp -r Motor0.rtc composite0.rtc
  $ sleep 3.1
  $ show rtkeep
  [08:00:05] /robot/test.host_cxt/composite0.rtc: configuration set default was changed by hand: left alone
  [08:00:05] /robot/test.host_cxt/composite0.rtc: CORBA.BAD_PARAM
  [08:00:05] /robot/test.host_cxt/Motor0.rtc: Active
  $ rtdeact Motor0.rtc
  $ sleep 2.1
  $ show rtkeep
  [08:00:08] /robot/test.host_cxt/Motor0.rtc: was made Inactive by hand: left alone
  $ rtls -l Motor0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
  $ sleep 10
  $ show rtkeep
  [08:00:14] /robot/test.host_cxt/composite0.rtc: restored members Controller0, Motor0, Sensor0
  $ rtls -l Motor0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
  $ rtact Motor0.rtc
  $ sleep 2
  $ show rtkeep
  [08:00:20] /robot/test.host_cxt/Motor0.rtc: is Active again
  $ strike TERM rtkeep
  $ wait rtkeep
  [0] after 22.2 s

One that goes to Error meanwhile is reset, and has failed once:

  $ rtkeep --burst 1/60 --delay 2-3 --look 0.2 b.xml &
  $ sleep 5
  $ show rtkeep
  [08:00:22] /robot/test.host_cxt/composite0.rtc: restored configuration set default
  $ ctl reset
  $ ctl fail add_members 1 BAD_PARAM
  $ ctl fail add_members 2 BAD_PARAM
  $ ctl fail add_members 3 BAD_PARAM
  $ ctl fail add_members 4 BAD_PARAM
  $ rtcomp -r Motor0.rtc composite0.rtc
  $ rtact Motor0.rtc
  $ later 0.25 ctl error Motor0
  $ sleep 7
  $ show rtkeep
  [08:00:27] /robot/test.host_cxt/composite0.rtc: configuration set default was changed by hand: left alone
  [08:00:27] /robot/test.host_cxt/composite0.rtc: CORBA.BAD_PARAM
  [08:00:27] /robot/test.host_cxt/composite0.rtc: CORBA.BAD_PARAM; given up after more than 1 failure in 60s
  [08:00:27] /robot/test.host_cxt/Motor0.rtc: in Error: reset
  [08:00:27] /robot/test.host_cxt/Motor0.rtc: Active
