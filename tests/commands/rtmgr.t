rtmgr asks and commands managers: the daemons that load modules and make components of them.

world: manager ConsoleIn ConsoleOut --flavour cpp2

A manager is named by its path. --factories lists what can be created (a master lists those of its slaves, too), --rtcs the
components, --loaded the modules that are there:

  $ rtmgr --factories manager.mgr
  RTC:AIST:example:ConsoleIn:C++:2.0.0
  RTC:AIST:example:ConsoleOut:C++:2.0.0
  RTC:AIST:example:Controller:C++:2.0.0
  RTC:AIST:example:Motor:C++:2.0.0
  RTC:AIST:example:Sensor:C++:2.0.0
  RTC:jp.go.aist:composite.PeriodicECShared:PeriodicECSharedComposite:C++:1.0
  $ rtmgr -r manager.mgr
  instance name:\tConsoleIn0 (esc)
      class name:   RTC:AIST:example:ConsoleIn:C++:2.0.0
      naming name:  test.host_cxt/ConsoleIn0.rtc
      host name:    test
      manager name: manager
  instance name:\tConsoleOut0 (esc)
      class name:   RTC:AIST:example:ConsoleOut:C++:2.0.0
      naming name:  test.host_cxt/ConsoleOut0.rtc
      host name:    test
      manager name: manager
  $ rtmgr --rtcs manager.mgr/manager | grep instance
  instance name:\tConsoleIn0 (esc)
  instance name:\tConsoleOut0 (esc)
  $ rtmgr --loaded manager.mgr
  /opt/openrtm/components/c++/examples/rtc/ConsoleIn.so
  /opt/openrtm/components/c++/examples/rtc/ConsoleOut.so
  /opt/openrtm/components/c++/examples/rtc/Controller.so
  /opt/openrtm/components/c++/examples/rtc/Motor.so
  /opt/openrtm/components/c++/examples/rtc/Sensor.so

-m asks for the modules that could be loaded, which may take a real manager a while; -g for its configuration:

  $ rtmgr -m manager.mgr | grep Seq
  RTC:AIST:example:SeqIn:C++:2.0.0
  RTC:AIST:example:SeqOut:C++:2.0.0
  $ rtmgr --modules manager.mgr | head -1
  RTC:AIST:example:ConsoleIn:C++:2.0.0
  $ rtmgr -g manager.mgr | grep -E "name|command"
  openrtm.name:                           OpenRTM-aist-2.1.0
  manager.instance_name:                  manager
  manager.name:                           manager
  manager.command:                        rtcd2
  manager.nameservers:                    default
  os.name:                                Linux
  os.hostname:                            test
  logger.file_name:                       ./rtc%p.log
  corba.nameservers:                      localhost
  corba.nameservice.replace_endpoint:     NO
  $ rtmgr --config manager.mgr | wc -l
  76

-c creates a component and -d deletes it; -v reports what was done. The name is the manager's choice, or given:

  $ rtmgr -c ConsoleIn manager.mgr
  $ rtmgr -v --create 'Motor?instance_name=left' manager.mgr
  rtmgr: created left
  $ rtls
  ConsoleIn0.rtc
  ConsoleIn1.rtc
  ConsoleOut0.rtc
  left.rtc
  manager.mgr/
  $ rtmgr -v -d left manager.mgr
  rtmgr: deleted left
  $ rtmgr -v --delete ConsoleIn1 manager.mgr
  rtmgr: deleted ConsoleIn1
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager.mgr/

More properties of a component can be given; and the whole identity of what is wanted:

  $ rtmgr -c 'Sensor?instance_name=slowly&exec_cxt.periodic.rate=5&naming.formats=lab.host_cxt/%n.rtc' \
  >     manager.mgr
  $ rtec ../lab.host_cxt/slowly.rtc
  0  0  Periodic  5  Running  Inactive  slowly  -
  $ rtmgr -vc RTC:AIST:example:Controller:C++:2.0.0 -c 'RTC:::Controller::?instance_name=other' manager.mgr
  rtmgr: created Controller0
  rtmgr: created other

What is asked for is done in the order of the options; the first failure ends the command:

  $ rtmgr -v -c 'Controller?instance_name=a' -d a -c 'Controller?instance_name=a' -d nobody -d a manager.mgr
  rtmgr: created a
  rtmgr: deleted a
  rtmgr: created a
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: no such component: nobody
  [3]
  $ rtmgr -v -d Controller0 -d other -d a -r -d slowly manager.mgr
  rtmgr: deleted Controller0
  rtmgr: deleted other
  rtmgr: deleted a
  instance name:\tConsoleIn0 (esc)
      class name:   RTC:AIST:example:ConsoleIn:C++:2.0.0
      naming name:  test.host_cxt/ConsoleIn0.rtc
      host name:    test
      manager name: manager
  instance name:\tConsoleOut0 (esc)
      class name:   RTC:AIST:example:ConsoleOut:C++:2.0.0
      naming name:  test.host_cxt/ConsoleOut0.rtc
      host name:    test
      manager name: manager
  instance name:\tslowly (esc)
      class name:   RTC:AIST:example:Sensor:C++:2.0.0
      naming name:  lab.host_cxt/slowly.rtc
      host name:    test
      manager name: manager
  rtmgr: deleted slowly
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  manager.mgr/

-l loads a module, by its path or by a name in the manager's load path, and calls a function of it; -u unloads it. A manager
says RTC_OK whatever happens; it is looked whether it is there:

  $ rtmgr -v -l SeqIn.so:SeqInInit manager.mgr
  rtmgr: loaded SeqIn.so
  $ rtmgr -v --load /opt/openrtm/components/c++/examples/rtc/SeqOut.so:SeqOutInit manager.mgr
  rtmgr: loaded /opt/openrtm/components/c++/examples/rtc/SeqOut.so
  $ rtmgr --loaded manager.mgr
  /opt/openrtm/components/c++/examples/rtc/ConsoleIn.so
  /opt/openrtm/components/c++/examples/rtc/ConsoleOut.so
  /opt/openrtm/components/c++/examples/rtc/Controller.so
  /opt/openrtm/components/c++/examples/rtc/Motor.so
  /opt/openrtm/components/c++/examples/rtc/Sensor.so
  /opt/openrtm/components/c++/examples/rtc/SeqIn.so
  /opt/openrtm/components/c++/examples/rtc/SeqOut.so
  $ rtmgr -v -u SeqIn.so --unload /opt/openrtm/components/c++/examples/rtc/SeqOut.so manager.mgr
  rtmgr: SeqIn is still offered: load it again before it is created, or the manager's process ends
  rtmgr: unloaded SeqIn.so
  rtmgr: SeqOut is still offered: load it again before it is created, or the manager's process ends
  rtmgr: unloaded /opt/openrtm/components/c++/examples/rtc/SeqOut.so
  $ rtmgr --loaded manager.mgr
  /opt/openrtm/components/c++/examples/rtc/ConsoleIn.so
  /opt/openrtm/components/c++/examples/rtc/ConsoleOut.so
  /opt/openrtm/components/c++/examples/rtc/Controller.so
  /opt/openrtm/components/c++/examples/rtc/Motor.so
  /opt/openrtm/components/c++/examples/rtc/Sensor.so

A file that is there already, or a wrong function, adds nothing; that is reported (unless with -q), and is no failure:

  $ rtmgr -v -l Motor.so:MotorInit manager.mgr
  rtmgr: Motor.so adds nothing that can be created: it was loaded before, or MotorInit is the wrong function
  rtmgr: loaded Motor.so
  $ rtmgr -q -l SeqIn.so:WrongInit manager.mgr

-s sets a configuration value; most are read only when a manager starts, and that is reported:

  $ rtmgr -v -s logger.log_level=DEBUG manager.mgr
  rtmgr: set logger.log_level=DEBUG
  $ rtmgr -g manager.mgr | grep log_level
  logger.log_level:                       DEBUG
  $ rtmgr --setconfig naming.formats=%n.rtc manager.mgr
  rtmgr: /localhost:$PORT/test.host_cxt/manager.mgr: did not set naming.formats (it returned RTC_OK; the value is test.host_cxt/%n.rtc)
  [6]
  $ rtmgr -s my.own.value=a=b -g manager.mgr | grep "^my"
  my.own.value:                           a=b
  $ rtmgr -s my.other.value= -g manager.mgr | grep "^my"
  my.own.value:                           a=b
  my.other.value:\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)

--wait comes back when what was created is ready:

  $ rtmgr -v --wait -c 'Motor?instance_name=m1' manager.mgr
  rtmgr: created m1
  $ rtls -l m1.rtc
  Inactive  2/0  1/0  1/0  0/0  m1.rtc
  $ rtmgr -c 'Motor?instance_name=m2' --wait=2 manager.mgr
  $ rtls -l manager.mgr
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  1/0  1/0  0/0  m1.rtc
  Inactive  2/0  1/0  1/0  0/0  m2.rtc
  -         -    -    -    -    manager

--dry-run prints what would be done, and does not do it; what only asks is done:

  $ rtmgr --dry-run -c 'Motor?instance_name=m3' -d m1 -l a.so:aInit -u a.so -s a='b c' \
  >     --shutdown -r manager.mgr |
  >     grep -v '^ '
  rtmgr --create 'Motor?instance_name=m3' /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr --delete m1 /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr --load a.so:aInit /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr --unload a.so /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr --setconfig 'a=b c' /localhost:$PORT/test.host_cxt/manager.mgr
  rtmgr --shutdown /localhost:$PORT/test.host_cxt/manager.mgr
  instance name:\tConsoleIn0 (esc)
  instance name:\tConsoleOut0 (esc)
  instance name:\tm1 (esc)
  instance name:\tm2 (esc)
  $ rtls
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  m1.rtc
  m2.rtc
  manager.mgr/

--json: one object a line, for what is listed and for what is created:

  $ rtmgr --json -r manager.mgr | python3 -c 'import json, sys
  > for line in sys.stdin:
  >     found = json.loads(line)
  >     print(sorted(found), found["instance_name"], found["properties"]["naming.names"])'
  ['category', 'description', 'instance_name', 'parent', 'path', 'properties', 'type_name', 'vendor', 'version'] ConsoleIn0 test.host_cxt/ConsoleIn0.rtc
  ['category', 'description', 'instance_name', 'parent', 'path', 'properties', 'type_name', 'vendor', 'version'] ConsoleOut0 test.host_cxt/ConsoleOut0.rtc
  ['category', 'description', 'instance_name', 'parent', 'path', 'properties', 'type_name', 'vendor', 'version'] m1 test.host_cxt/m1.rtc
  ['category', 'description', 'instance_name', 'parent', 'path', 'properties', 'type_name', 'vendor', 'version'] m2 test.host_cxt/m2.rtc
  $ rtmgr --json -m manager.mgr | python3 -c 'import json, sys
  > for line in sys.stdin:
  >     found = json.loads(line)
  >     print(found["implementation_id"], found["module_file_name"])' | head -2
  ConsoleIn ConsoleIn.so
  ConsoleOut ConsoleOut.so
  $ rtmgr --json --factories manager.mgr | head -1
  {"activity_type": "PERIODIC", "category": "example", "description": "Console input component", "implementation_id": "ConsoleIn", "kind": "DataFlowComponent", "lang_type": "compile", "language": "C++", "max_instance": "10", "type_name": "ConsoleIn", "vendor": "AIST", "version": "2.0.0"}
  $ rtmgr --json --loaded manager.mgr | head -1
  {"file_path": "/opt/openrtm/components/c++/examples/rtc/ConsoleIn.so"}
  $ rtmgr --json -g manager.mgr | python3 -c 'import json, sys; print(json.load(sys.stdin)["manager.name"])'
  manager
  $ rtmgr --json -c 'Motor?instance_name=m4' -d m4 manager.mgr
  {"created": "m4", "manager": "/localhost:$PORT/test.host_cxt/manager.mgr"}

Without a name server, a manager is reached at its address; its key is `manager`, whatever its name. The slaves of a master
are in no name server; they have an address, too:

  $ M=$(ctl port) S=$(ctl slave 1 port)
  $ rtmgr -r corbaloc:iiop:localhost:$M/manager | grep instance
  instance name:\tConsoleIn0 (esc)
  instance name:\tConsoleOut0 (esc)
  instance name:\tm1 (esc)
  instance name:\tm2 (esc)
  $ rtmgr -r corbaloc::localhost:$M/manager | grep -c instance
  4
  $ rtmgr -r corbaloc::localhost:$M | grep -c instance
  4
  $ rtmgr -r corbaloc:iiop:1.2@127.0.0.1:$M/manager | grep -c instance
  4
  $ rtmgr -v -c 'Motor?instance_name=m5' -d m5 --wait corbaloc:iiop:localhost:$M/manager
  rtmgr: created m5
  rtmgr: deleted m5
  $ rtmgr -v -c 'Motor?instance_name=m6' -d m6 corbaloc::localhost:$S
  rtmgr: created m6
  rtmgr: deleted m6
  $ rtmgr --json -c 'Motor?instance_name=m7' -d m7 corbaloc::localhost:$S
  {"created": "m7", "manager": "corbaloc::localhost:?????"} (glob)
  $ rtmgr -g corbaloc::localhost:$S | grep is_master
  manager.is_master:                      NO

--shutdown ends a manager, its slaves first; their names disappear, and they are gone when the command ends:

  $ rtmgr -v --shutdown manager.mgr
  rtmgr: shut down /localhost:$PORT/test.host_cxt/manager.mgr/manager
  rtmgr: shut down /localhost:$PORT/test.host_cxt/manager.mgr
  $ rtmgr -r corbaloc::localhost:$S 2>&1 | sed s/$S/S/
  rtmgr: corbaloc::localhost:S: connection refused; is the manager running?
  $ rtls

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -r MGR
invocation: -c Mock MGR
invocation: -l Mock.so:MockInit -m --loaded --factories MGR
invocation: -d Mock0 MGR
looking: -r MGR
broken component: 3
