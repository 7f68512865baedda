rtshell_lite demo: a robot to play with, on any machine.

orb: builtin

  $ rtshell_lite demo > said & pid=$!
  $ soon 'grep rtstodot said'; eval "$(grep export said)"
  $ sed "s,${RTCSH_CWD#/},ADDRESS,g" said
  A mobile arm of 12 components works here until Ctrl-C. In another terminal:

    export RTCTREE_NAMESERVERS=ADDRESS RTCSH_CWD=/ADDRESS

    rtls -lR                                          what there is, and in which state
    rtprint arm.host_cxt/Shoulder0.rtc:angle          what a joint sends, until Ctrl-C
    rtconf arm.host_cxt/Planner0.rtc act small        the arm waves less: look at the joint again
    rttop                                             all of it, live; q ends it
    rtdoctor                                          what is wrong: nothing, until the hand is too hot
    rtstodot --html robot.html .                      a page with the whole robot, for a browser
  $ rtconf arm.host_cxt/Gripper0.rtc set limit 1000  # else it is hot after 50 s
  $ rtls -lR
  .:
  -  -  -  -  -  arm.host_cxt
  -  -  -  -  -  base.host_cxt

  ./arm.host_cxt:
  Active  0/0  0/0  0/0  0/0  Arm0.rtc
  Active  2/2  1/1  1/1  0/0  Elbow0.rtc
  Active  3/1  1/1  2/0  0/0  Gripper0.rtc
  Active  4/4  0/0  4/4  0/0  Planner0.rtc
  Active  2/2  1/1  1/1  0/0  Shoulder0.rtc
  Active  4/3  3/3  1/0  0/0  Tip0.rtc
  Active  2/2  1/1  1/1  0/0  Wrist0.rtc

  ./base.host_cxt:
  Active  1/1  0/0  1/1  0/0  Battery0.rtc
  Active  2/0  0/0  1/0  1/0  Camera0.rtc
  Active  3/3  2/2  1/1  0/0  Guard0.rtc
  Active  2/2  1/1  1/1  0/0  Laser0.rtc
  Active  2/2  1/1  1/1  0/0  Odometry0.rtc
   (esc)

What is done to its components has an effect on them. A joint follows its target:

  $ A=arm.host_cxt
  $ rtprint -n 1 $A/Shoulder0.rtc:angle > angle; grep -c '^\[.*\] -*[0-9.e-]*$' angle
  1
  $ rtconf $A/Planner0.rtc act small; rtconf -l $A/Planner0.rtc
  -default
    period  6.0
    reach   1.0
  -small*
    period  6.0
    reach   0.2
  $ rtdis $A/Planner0.rtc:elbow $A/Elbow0.rtc:target
  $ rtinject -n 1 -c 1.5 $A/Elbow0.rtc:target
  $ soon 'rtprint -n 1 $A/Elbow0.rtc:angle | grep " 1.5$"'
  $ rtcon -q $A/Planner0.rtc:elbow $A/Elbow0.rtc:target
  $ rtdeact $A/Arm0.rtc; rtls -l $A | grep -c Inactive
  4
  $ rtact $A/Arm0.rtc; rtls -l $A | grep -c Inactive
  0
  [1]
  $ rtec $A/Tip0.rtc stop; rtec $A/Tip0.rtc
  0  0  Periodic  10  Stopped  Active  Tip0  -
  $ rtec $A/Tip0.rtc start
  $ rtec $A/Elbow0.rtc rate 50
  rtec: /127.0.0.1:*/arm.host_cxt/Elbow0.rtc: this context is stopped; rtec lists those that execute it, -e N chooses one (glob)
  $ rtec -e 1 $A/Elbow0.rtc rate 20; soon 'rtec --measure $A/Elbow0.rtc | grep "measured *[12][0-9]\.[0-9] Hz"' > nul
  $ rtec -e 1 $A/Elbow0.rtc rate 10

The hand goes to Error when it is hot, and comes back:

  $ rtconf $A/Gripper0.rtc set limit 25
  $ soon 'rtls -l $A | grep Error'; rtdoctor -q | grep Gripper0
  fail  /127.0.0.1:*/arm.host_cxt/Gripper0.rtc: in Error; try: rtreset /127.0.0.1:*/arm.host_cxt/Gripper0.rtc (glob)
  $ rtconf $A/Gripper0.rtc set limit 1000; soon 'rtls -l $A | grep "^Active.*Gripper0"'

A camera sends pictures when its service is asked to:

  $ C=base.host_cxt/Camera0.rtc; rtcall $C:capture
  capture  camera  CameraCaptureService  IDL:Img/CameraCaptureService:1.0  OpenRTM's own IDL
  $ rtprint -n 3 $C:picture > pictures & printing=$!
  $ soon "rtls -l $C | grep 2/1"; rtcall $C:capture.camera start_continuous
  $ wait $printing; rtcall $C:capture.camera stop_continuous
  $ grep -c "width=16 height=12 bpp=8 format='gray'" pictures
  3
  $ rtprint -n 3 $C:picture > pictures & printing=$!
  $ soon "rtls -l $C | grep 2/1"; rtcall $C:capture.camera take_multi_frames 2
  $ soon 'grep -c width pictures | grep 2'; rtcall $C:capture.camera take_one_frame
  $ wait $printing
  $ rtcall $C:capture.camera getProfile | cut -c1-60
  {"devtypeid": "", "guid": "", "intrinsic": {"distortion_coef

Whole systems:

  $ rtcryo -q --all -o robot.xml
  $ rtcheck robot.xml
  $ rtteardown robot.xml; rtls -l base.host_cxt
  Active  1/0  0/0  1/0  0/0  Battery0.rtc
  Active  2/0  0/0  1/0  1/0  Camera0.rtc
  Active  3/0  2/0  1/0  0/0  Guard0.rtc
  Active  2/0  1/0  1/0  0/0  Laser0.rtc
  Active  2/0  1/0  1/0  0/0  Odometry0.rtc
  $ rtresurrect robot.xml; rtcheck robot.xml
  $ rtstop robot.xml 2> nul; rtls -lR | grep -c Inactive
  12
  $ rtstart robot.xml 2> nul; rtls -lR | grep -c Active
  12
  $ rtlog record -q -i -e 20 -f a.mcap $A/Shoulder0.rtc:angle
  $ rtlog export a.mcap | wc -l
  20
  $ rtstodot --html robot.html .; grep -c Shoulder0 robot.html
  1

What components of a robot refuse, and mistakes:

  $ rtconf $A/Arm0.rtc
  +default*
  $ rtconf $A/Shoulder0.rtc act none
  rtconf: /127.0.0.1:*/arm.host_cxt/Shoulder0.rtc: no such configuration set: none (there are: default, gentle) (glob)
  [3]
  $ rtexit $A/Tip0.rtc
  rtexit: /127.0.0.1:*/arm.host_cxt/Tip0.rtc: does not exit (RTC_ERROR) (glob)
  [6]
  $ rtshell_lite demo --port 99999
  rtshell_lite demo: 99999: is no TCP port (see --help)
  [2]
  $ rtshell_lite demo --port ²
  rtshell_lite demo: ²: is no TCP port (see --help)
  [2]
  $ rtshell_lite demo --port ${RTCSH_CWD##*:}
  rtshell_lite demo: 127.0.0.1:*: cannot listen there; does another program? (glob)
  [1]
  $ rtshell_lite demo now
  rtshell_lite demo: unrecognized arguments: now (see --help)
  [2]

It is ended, and leaves nothing:

  $ kill -TERM $pid; wait $pid
  [143]
  $ rtls
  rtls: /127.0.0.1:*: connection refused; is the name server running? (glob)
  [4]
