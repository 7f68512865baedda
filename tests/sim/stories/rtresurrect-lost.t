rtresurrect --create makes nothing that may live: what hangs, or is out of reach.

hosts: robot arm
world: manager Sensor Motor --flavour cpp11
world: these ConsoleOut
world: these ConsoleIn --host arm

What lives is not made again, though its name is gone:

  $ rtcryo --all -o a.xml
  $ rtdel -f ConsoleOut0.rtc ConsoleIn0.rtc
  $ rtresurrect --create --manager manager.mgr a.xml
  ! rtresurrect: /robot/test.host_cxt/ConsoleIn0.rtc: not created: it lives at 10.0.0.2:$PORT, though its name is not bound: restart it, or end its process; if that is another robot, take REFERENCE out of the file
  ! rtresurrect: /robot/test.host_cxt/ConsoleOut0.rtc: not created: it lives at 10.0.0.1:$PORT, though its name is not bound: restart it, or end its process; if that is another robot, take REFERENCE out of the file
  ! rtresurrect: 9 already done, 2 failed, 4 not tried
  [5]

Nor is what hangs, or is out of reach; what has ended is to be made:

  $ hang these
  $ rtresurrect --timeout 1 --create --manager manager.mgr a.xml
  ! rtresurrect: /robot/test.host_cxt/ConsoleIn0.rtc: not created: it lives at 10.0.0.2:$PORT, though its name is not bound: restart it, or end its process; if that is another robot, take REFERENCE out of the file
  ! rtresurrect: /robot/test.host_cxt/ConsoleOut0.rtc: not created: 10.0.0.1:$PORT, where it was, does not answer (no answer within 1s): it hangs, or is out of reach (REFERENCE in the file)
  ! rtresurrect: 9 already done, 2 failed, 4 not tried
  [5] after 1.1 s
  $ cut arm
  $ rtresurrect --timeout 1 --create --manager manager.mgr a.xml
  ! rtresurrect: /robot/test.host_cxt/ConsoleIn0.rtc: not created: 10.0.0.2:$PORT, where it was, does not answer (no answer within 1s): it hangs, or is out of reach (REFERENCE in the file)
  ! rtresurrect: /robot/test.host_cxt/ConsoleOut0.rtc: not created: 10.0.0.1:$PORT, where it was, does not answer (no answer within 1s): it hangs, or is out of reach (REFERENCE in the file)
  ! rtresurrect: 9 already done, 2 failed, 4 not tried
  [5] after 2.1 s
  $ wake these
  $ kill these
  $ rtresurrect --timeout 1 --create --manager manager.mgr a.xml
  ! rtresurrect: /robot/test.host_cxt/ConsoleIn0.rtc: not created: 10.0.0.2:$PORT, where it was, does not answer (no answer within 1s): it hangs, or is out of reach (REFERENCE in the file)
  ! rtresurrect: /robot/test.host_cxt/manager.mgr: does not create RTC:Shinji Kurihara:example:ConsoleOut:1.0?instance_name=ConsoleOut0 (no factory ConsoleOut; there are: Controller, Motor, PeriodicECSharedComposite, Sensor)
  ! rtresurrect: 9 already done, 2 failed, 4 not tried
  [5] after 1.1 s
  $ rtls
  Motor0.rtc
  Sensor0.rtc
  manager.mgr/
