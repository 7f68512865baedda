rtmgr -u takes the names that -l takes, and does not let a manager unload what is in use.

world: manager ConsoleIn ConsoleOut --flavour cpp2
world: manager ConsoleIn --flavour py2 --context py2.host_cxt/%n.rtc

A manager lists a module by its path; it can be loaded by other names:

  $ S=manager.mgr/manager
  $ loaded() { rtmgr --loaded "$@" | grep -E 'Seq|Clus'; }
  $ rtmgr -v -l ./SeqIn.so:SeqInInit -l //opt/openrtm/components/c++/examples/rtc/SeqOut.so:SeqOutInit $S
  rtmgr: loaded ./SeqIn.so
  rtmgr: loaded //opt/openrtm/components/c++/examples/rtc/SeqOut.so
  $ rtmgr -v -q -u ./SeqIn.so -u //opt/openrtm/components/c++/examples/rtc/SeqOut.so $S
  rtmgr: unloaded ./SeqIn.so
  rtmgr: unloaded //opt/openrtm/components/c++/examples/rtc/SeqOut.so
  $ loaded $S
  [1]

Python adds .py to a name:

  $ P=../py2.host_cxt/manager.mgr
  $ rtmgr -v -l SeqIn:SeqInInit -l SeqOut.py:SeqOutInit $P
  rtmgr: loaded SeqIn
  rtmgr: loaded SeqOut.py
  $ rtmgr -v -l SeqIn:SeqInInit $P
  rtmgr: SeqIn adds nothing that can be created: it was loaded before, or SeqInInit is the wrong function
  rtmgr: loaded SeqIn
  $ loaded $P
  /opt/openrtm/components/python/SeqIO/SeqIn.py
  /opt/openrtm/components/python/SeqIO/SeqOut.py
  $ rtmgr -v -u SeqIn -u SeqOut $P
  rtmgr: unloaded SeqIn
  rtmgr: unloaded SeqOut
  $ loaded $P
  [1]
  $ rtmgr -u SeqIn $P
  rtmgr: /localhost:$PORT/py2.host_cxt/manager.mgr: no such loaded module: SeqIn
  [3]

Digits in the middle of a name are not a number:

  $ rtmgr -u .so $S
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr/manager: no such loaded module: .so
  [3]
  $ rtmgr -u onsoleIn.so $S
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr/manager: no such loaded module: onsoleIn.so
  [3]

A module of C++ whose component lives: its process would end at the next call. In Python that is no harm:

  $ rtmgr -u ConsoleIn.so manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr/manager: /opt/openrtm/components/c++/examples/rtc/ConsoleIn.so is in use by ConsoleIn0, whose process would end; delete it first
  [1]
  $ rtmgr -v -d ConsoleIn0 -u ConsoleIn.so manager.mgr
  rtmgr: deleted ConsoleIn0
  rtmgr: ConsoleIn is still offered: load it again before it is created, or the manager's process ends
  rtmgr: unloaded ConsoleIn.so
  $ rtmgr -v -l ConsoleIn.so:ConsoleInInit $S
  rtmgr: ConsoleIn.so adds nothing that can be created: it was loaded before, or ConsoleInInit is the wrong function
  rtmgr: loaded ConsoleIn.so
  $ rtmgr -v -c ConsoleIn manager.mgr
  rtmgr: created ConsoleIn0
  $ rtmgr -v -u ConsoleIn $P
  rtmgr: unloaded ConsoleIn
  $ rtls -l ../py2.host_cxt
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  -         -    -    -    -    manager.mgr

A master of C++ 2.1 does not list what its slaves have; rtmgr asks them, too:

  $ rtmgr --factories manager.mgr
  RTC:AIST:example:ConsoleIn:C++:2.0.0
  RTC:AIST:example:ConsoleOut:C++:2.0.0
  RTC:AIST:example:Controller:C++:2.0.0
  RTC:AIST:example:Motor:C++:2.0.0
  RTC:AIST:example:Sensor:C++:2.0.0
  RTC:AIST:example:SeqIn:C++:2.0.0
  RTC:AIST:example:SeqOut:C++:2.0.0
  RTC:jp.go.aist:composite.PeriodicECShared:PeriodicECSharedComposite:C++:1.0
  $ rtmgr --loaded manager.mgr
  /opt/openrtm/components/c++/examples/rtc/ConsoleIn.so
  /opt/openrtm/components/c++/examples/rtc/ConsoleOut.so
  /opt/openrtm/components/c++/examples/rtc/Controller.so
  /opt/openrtm/components/c++/examples/rtc/Motor.so
  /opt/openrtm/components/c++/examples/rtc/Sensor.so
