What rtmgr says when it cannot do what is asked, and with which exit status.

world: manager --flavour cpp2
world: two --context other.host_cxt/%n.rtc
world: manager --flavour py2 --context py.host_cxt/%n.rtc
world: deadslave --context deadslave.host_cxt/%n.rtc
world: deadchild --context deadchild.host_cxt/%n.rtc
faulty: silent reset garbage

Wrong usage is reported before anything is contacted:

  $ RTCTREE_NAMESERVERS=nowhere.invalid rtmgr nowhere/manager.mgr
  rtmgr: nothing to do: no option says what (see --help)
  [2]
  $ rtmgr -r
  rtmgr: the following arguments are required: MANAGER (see --help)
  [2]
  $ rtmgr -r manager.mgr another.mgr
  rtmgr: unrecognized arguments: another.mgr (see --help)
  [2]
  $ rtmgr -l mycomp.py nowhere/manager.mgr
  rtmgr: argument -l/--load: no initialisation function specified (FILE:FUNCTION): mycomp.py (see --help)
  [2]
  $ rtmgr -l mycomp.py: nowhere/manager.mgr
  rtmgr: argument -l/--load: no initialisation function specified (FILE:FUNCTION): mycomp.py: (see --help)
  [2]
  $ rtmgr -l c:/win/mycomp.dll nowhere/manager.mgr
  rtmgr: argument -l/--load: no initialisation function specified (FILE:FUNCTION): c:/win/mycomp.dll (see --help)
  [2]
  $ rtmgr -s a nowhere/manager.mgr
  rtmgr: argument -s/--setconfig: not NAME=VALUE: a (see --help)
  [2]
  $ rtmgr -s =b nowhere/manager.mgr
  rtmgr: argument -s/--setconfig: not NAME=VALUE: =b (see --help)
  [2]
  $ rtmgr -c '' nowhere/manager.mgr
  rtmgr: not MODULE[?KEY=VALUE&KEY=VALUE…]:  (see --help)
  [2]
  $ rtmgr -c 'A?b' nowhere/manager.mgr
  rtmgr: not MODULE[?KEY=VALUE&KEY=VALUE…]: A?b (see --help)
  [2]
  $ rtmgr -c
  rtmgr: argument -c/--create: expected one argument (see --help)
  [2]
  $ rtmgr --wait=soon -c A nowhere/manager.mgr
  rtmgr: argument --wait: not a number of seconds above 0: soon (see --help)
  [2]
  $ rtmgr -r corbaloc:
  rtmgr: corbaloc:: not corbaloc:iiop:HOST[:PORT][/KEY]
  [2]
  $ rtmgr -r corbaloc::localhost:70000/manager
  rtmgr: corbaloc::localhost:70000/manager: not corbaloc:iiop:HOST[:PORT][/KEY]
  [2]
  $ rtmgr -r corbaloc::localhost:x/manager
  rtmgr: corbaloc::localhost:x/manager: not corbaloc:iiop:HOST[:PORT][/KEY]
  [2]
  $ rtmgr -r corbaloc:rir:/NameService
  rtmgr: corbaloc:rir:/NameService: not corbaloc:iiop:HOST[:PORT][/KEY]
  [2]
  $ rtmgr -r corbaloc:iiop:/manager
  rtmgr: corbaloc:iiop:/manager: not corbaloc:iiop:HOST[:PORT][/KEY]
  [2]

What is no manager:

  $ rtmgr -r ../other.host_cxt/ConsoleIn0.rtc
  rtmgr: /localhost:$PORT/other.host_cxt/ConsoleIn0.rtc: not a manager (it is a component)
  [3]
  $ rtmgr -r ../other.host_cxt
  rtmgr: /localhost:$PORT/other.host_cxt: not a manager (it is a directory)
  [3]
  $ rtmgr -r ../other.host_cxt/ConsoleIn0.rtc:out
  rtmgr: /localhost:$PORT/other.host_cxt/ConsoleIn0.rtc:out: not a manager (it is a port)
  [3]
  $ rtmgr -r manager.mgr:out
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr:out: not a manager (it is a port)
  [3]
  $ rtmgr -r manager.mgr/ConsoleIn0.rtc
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr/ConsoleIn0.rtc: not a manager (it is a component)
  [3]
  $ rtmgr -r manager.mgr/nobody
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr/nobody: no such path
  [3]
  $ rtmgr -r manger.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manger.mgr: no such path; did you mean manager.mgr?
  [3]
  $ rtmgr -r /
  rtmgr: /: not a manager (it is a root directory)
  [3]
  $ rtmgr -r corbaloc::localhost:$PORT/NameService
  rtmgr: corbaloc::localhost:$PORT/NameService: not a manager (it is a directory)
  [3]
  $ rtmgr -r corbaloc::localhost:$PORT/nothing
  rtmgr: corbaloc::localhost:$PORT/nothing: no such object: nothing
  [3]
  $ M=$(ctl port)
  $ rtmgr -c Motor corbaloc::localhost:$M/nothing 2>&1 | sed s/$M/M/
  rtmgr: corbaloc::localhost:M/nothing: no such object: nothing

Nobody there, or nobody who answers:

  $ rtmgr -r corbaloc::127.1.2.3/manager
  rtmgr: corbaloc::127.1.2.3/manager: connection refused; is the manager running?
  [4]
  $ rtmgr -r corbaloc::nowhere.invalid/manager
  rtmgr: corbaloc::nowhere.invalid/manager: host name not known
  [4]
  $ rtmgr -r nowhere.invalid/manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/nowhere.invalid: no such path
  [3]
  $ rtmgr --timeout 2 -r corbaloc::localhost:$SILENT
  rtmgr: corbaloc::localhost:$SILENT: no answer within 2s
  [4]
  $ rtmgr -r corbaloc::localhost:$RESET
  rtmgr: corbaloc::localhost:$RESET: connection lost
  [4]
  $ rtmgr -r corbaloc::localhost:$GARBAGE
  rtmgr: corbaloc::localhost:\$GARBAGE: (connection lost|garbled answer \(not GIOP\)) (re)
  [4]

Components: a name that is unknown or taken, a module that is unknown, an argument that makes no sense, too many instances:

  $ rtmgr -d nobody manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: no such component: nobody
  [3]
  $ rtmgr -c NoSuchModule manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: does not create NoSuchModule (no factory NoSuchModule; there are: ConsoleIn, ConsoleOut, Controller, Motor, PeriodicECSharedComposite, Sensor)
  [6]
  $ rtmgr -c RTC:AIST:example:Motor:1.0 manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: does not create RTC:AIST:example:Motor:1.0 (there is RTC:AIST:example:Motor:C++:2.0.0)
  [6]
  $ rtmgr -c RTC:Nobody:example:Motor:C++:2.0.0 manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: does not create RTC:Nobody:example:Motor:C++:2.0.0 (there is RTC:AIST:example:Motor:C++:2.0.0)
  [6]
  $ rtmgr -c 'Motor?language=Python' manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: does not create Motor?language=Python (a wrong argument, its max_instance of 10 is reached, or its own initialisation failed)
  [6]
  $ rtmgr -c 'Motor?instance_name=a?instance_name=b' manager.mgr
  rtmgr: not MODULE[?KEY=VALUE&KEY=VALUE…]: Motor?instance_name=a?instance_name=b (see --help)
  [2]
  $ rtmgr -v -c 'Motor?instance_name=a' -c 'Sensor?instance_name=a' manager.mgr
  rtmgr: created a
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: has a component a already
  [6]
  $ rtmgr -c Motor -c Motor -c Motor -c Motor -c Motor -c Motor -c Motor -c Motor -c Motor \
  >     -c Motor manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: does not create Motor (a wrong argument, its max_instance of 10 is reached, or its own initialisation failed)
  [6]
  $ rtmgr -r manager.mgr | grep -c Motor:
  10
  $ rtmgr -c Unborn manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: does not create Unborn (a wrong argument, its max_instance of 10 is reached, or its own initialisation failed)
  [6]

Python gives a component under a name that is taken: the one that has it, or, where the factory kept the name, another one that
nobody lists. Its name shows that it is one:

  $ rtmgr -v -c 'Motor?instance_name=kept' ../py.host_cxt/manager.mgr
  rtmgr: created kept
  $ rtmgr -v -c Motor ../py.host_cxt/manager.mgr
  rtmgr: /localhost:$PORT/py.host_cxt/manager.mgr: created nothing of use: it returned the name kept, which is taken; give another one: ?instance_name=…
  [6]
  $ rtls ../py.host_cxt
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  kept.rtc
  manager.mgr/

Modules: a manager says RTC_OK for a file that is not there; what is not loaded is not unloaded:

  $ rtmgr -l /no/such/file.so:fileInit manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: did not load /no/such/file.so (it returned RTC_OK)
  [6]
  $ rtmgr -l nofile.so:fileInit manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: did not load nofile.so (it returned RTC_OK)
  [6]
  $ rtmgr -u nofile.so manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: no such loaded module: nofile.so
  [3]

A master has the modules of its slaves unloaded, too, but its own first:

  $ rtmgr -u Sensor.so manager.mgr
  rtmgr: Sensor is still offered: load it again before it is created, or the manager's process ends
  $ rtmgr --loaded manager.mgr | grep Sensor
  /opt/openrtm/components/c++/examples/rtc/Sensor.so

A wrong initialisation function leaves a file that is loaded and of no use:

  $ rtmgr -l SeqIn.so:WrongInit manager.mgr
  rtmgr: SeqIn.so adds nothing that can be created: it was loaded before, or WrongInit is the wrong function
  $ rtmgr -v -l SeqOut.so:SeqOutInit manager.mgr
  rtmgr: loaded SeqOut.so
  $ rtmgr -q -l SeqIn.so:WrongInit manager.mgr

Configuration that does not take:

  $ rtmgr -s corba.args=-ORBtraceLevel manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: did not set corba.args (it returned RTC_OK; the value is empty)
  [6]

Managers that refuse, fail, hang:

  $ ctl fail get_configuration 1 NO_PERMISSION; rtmgr -g manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: CORBA.NO_PERMISSION
  [6]
  $ ctl fail create_component 1 COMM_FAILURE; rtmgr -c Motor manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: connection lost
  [4]
  $ ctl fail get_components 1 BAD_OPERATION; rtmgr -r manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: CORBA.BAD_OPERATION
  [6]
  $ ctl slave 1 fail delete_component 1 UNKNOWN; rtmgr -d ConsoleIn0 manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr/manager: CORBA.UNKNOWN
  [6]
  $ ctl fail get_slave_managers 1 BAD_OPERATION; rtls manager.mgr
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Motor0.rtc
  Motor1.rtc
  Motor2.rtc
  Motor3.rtc
  Motor4.rtc
  Motor5.rtc
  Motor6.rtc
  Motor7.rtc
  Motor8.rtc
  a.rtc
  $ ctl fail get_loadable_modules 1 BAD_OPERATION; rtcat manager.mgr | tail -3
  rtcat: loadable modules: /localhost:$PORT/test.host_cxt/manager.mgr: CORBA.BAD_OPERATION
    Filepath: /opt/openrtm/components/c++/examples/rtc/SeqOut.so
    Filepath: /opt/openrtm/components/c++/examples/rtc/Unborn.so
  Loadable modules:
  $ ctl fail get_loaded_modules 1 HANG; within 2-6 rtmgr --timeout 2 --loaded manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: no answer within 2s
  [4]

A slave that has died takes its components with it, and the master forgets it when it is asked:

  $ rtmgr -r ../deadslave.host_cxt/manager.mgr | grep instance
  instance name:\tConsoleIn0 (esc)
  $ rtls ../deadslave.host_cxt/manager.mgr ../deadslave.host_cxt
  ../deadslave.host_cxt/manager.mgr:
  ConsoleIn0.rtc
  manager/

  ../deadslave.host_cxt:
  ConsoleIn0.rtc
  *ConsoleOut0.rtc
  manager.mgr/
   (esc)

A component that has ended while its manager goes on listing it: the manager lives, and does all it can:

  $ cd() { export RTCSH_CWD=$1; }
  $ cd /localhost:$PORT/deadchild.host_cxt
  $ rtmgr -r manager.mgr | grep instance
  instance name:\tConsoleIn0 (esc)
  $ rtls -l manager.mgr manager.mgr/manager
  manager.mgr:
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  -         -    -    -    -    manager
  -         -    -    -    -    *unknown1.rtc

  manager.mgr/manager:
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  -         -    -    -    -    *unknown1.rtc
   (esc)
  $ rtls -R
  .:
  ConsoleIn0.rtc
  manager.mgr/

  ./manager.mgr:
  ConsoleIn0.rtc
  manager/
  *unknown1.rtc

  ./manager.mgr/manager:
  ConsoleIn0.rtc
  *unknown1.rtc
   (esc)
  $ rtmgr -v -c Motor manager.mgr
  rtmgr: created Motor0
  $ rtmgr -d ConsoleOut0 manager.mgr
  rtmgr: /localhost:$PORT/deadchild.host_cxt/manager.mgr: no such component: ConsoleOut0
  [3]
  $ rtmgr -v -d ConsoleIn0 manager.mgr
  rtmgr: deleted ConsoleIn0
  $ rtcat manager.mgr | head -1
  Name: manager

A hung manager, a manager whose process is gone:

  $ cd /localhost:$PORT/test.host_cxt
  $ hang manager
  $ within 2-6 rtmgr --timeout 2 -r manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: no answer within 2s
  [4]
  $ within 2-6 rtmgr --timeout 2 -r corbaloc::localhost:$M 2>&1 | sed s/$M/M/
  rtmgr: corbaloc::localhost:M: no answer within 2s
  $ within 2-6 rtls --timeout 2
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Motor0.rtc
  Motor1.rtc
  Motor2.rtc
  Motor3.rtc
  Motor4.rtc
  Motor5.rtc
  Motor6.rtc
  Motor7.rtc
  Motor8.rtc
  a.rtc
  ?manager.mgr
  rtls: 1 of 13 did not answer (manager.mgr)
  [5]
  $ within 2-6 rtls --timeout 2 manager.mgr
  rtls: /localhost:$PORT/test.host_cxt/manager.mgr: no answer within 2s
  [4]
  $ wake manager
  $ kill-mock manager
  $ rtmgr -r manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: connection refused; its process is gone (zombie)
  [4]
  $ rtmgr -r corbaloc::localhost:$M 2>&1 | sed s/$M/M/
  rtmgr: corbaloc::localhost:M: connection refused; is the manager running?
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Motor0.rtc
  Motor1.rtc
  Motor2.rtc
  Motor3.rtc
  Motor4.rtc
  Motor5.rtc
  Motor6.rtc
  Motor7.rtc
  Motor8.rtc
  a.rtc
  *manager.mgr
  $ rtls manager.mgr
  rtls: /localhost:$PORT/test.host_cxt/manager.mgr: connection refused; its process is gone (zombie)
  [4]
