rtcat of managers: what they say of themselves, their modules. What a version does not say is left out.

world: manager --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: manager --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: managers --flavour py2 --context py2.host_cxt/%n.rtc

  $ numbers() { sed 's/[0-9][0-9][0-9][0-9]*$/N/; s/_[0-9][0-9]*/_N/'; }
  $ rtcat ../cpp11.host_cxt/manager.mgr | numbers
  Name: manager
  Instance name: manager
  Process ID: N
  Naming format: cpp11.host_cxt/%n.mgr
  Refstring path: /var/log/rtcmanager.ref
  Components precreate:\x20 (esc)
  Modules:
    Load path: /opt/openrtm/components/c++/examples/rtc
    Config path:\x20 (esc)
    Preload: Motor.so, Sensor.so, Controller.so
    Init function prefix:\x20 (esc)
    Init function suffix:\x20 (esc)
    Download allowed:\x20 (esc)
    Absolute path allowed: YES
  Loaded modules:
    Filepath: /opt/openrtm/components/c++/examples/rtc/ConsoleIn.so
    Filepath: /opt/openrtm/components/c++/examples/rtc/ConsoleOut.so
    Filepath: /opt/openrtm/components/c++/examples/rtc/Controller.so
    Filepath: /opt/openrtm/components/c++/examples/rtc/Motor.so
    Filepath: /opt/openrtm/components/c++/examples/rtc/Sensor.so
  Loadable modules:
  $ rtcat ../cpp2.host_cxt/manager.mgr | numbers | sed '/Loadable/{n;n;q}'
  Name: manager
  Instance name: manager
  Process ID: N
  Naming format: cpp2.host_cxt/%n.mgr
  Components precreate:\x20 (esc)
  Modules:
    Load path: /opt/openrtm/components/c++/examples/rtc
    Config path:\x20 (esc)
    Preload: Motor.so, Sensor.so, Controller.so
    Init function prefix:\x20 (esc)
    Init function suffix:\x20 (esc)
    Download allowed:\x20 (esc)
    Absolute path allowed: YES
  Loaded modules:
    Filepath: /opt/openrtm/components/c++/examples/rtc/ConsoleIn.so
    Filepath: /opt/openrtm/components/c++/examples/rtc/ConsoleOut.so
    Filepath: /opt/openrtm/components/c++/examples/rtc/Controller.so
    Filepath: /opt/openrtm/components/c++/examples/rtc/Motor.so
    Filepath: /opt/openrtm/components/c++/examples/rtc/Sensor.so
  Loadable modules:
    /opt/openrtm/components/c++/examples/rtc/Clusterer.so
    /opt/openrtm/components/c++/examples/rtc/ConfigSample.so
  $ rtcat ../py2.host_cxt/manager.mgr | numbers | sed '/Loadable/{n;n;q}'
  Name: manager
  Instance name: manager
  Process ID: N
  Naming format: py2.host_cxt/%n.mgr
  Modules:
    Load path: /opt/openrtm/components/python/SimpleIO,/opt/openrtm/components/python/Composite,/opt/openrtm/components/python/SeqIO,/opt/openrtm/components/python/Others
    Preload: Motor.py, Sensor.py, Controller.py
    Absolute path allowed: YES
  Loaded modules:
    Filepath: /opt/openrtm/components/python/Composite/Controller.py
    Filepath: /opt/openrtm/components/python/Composite/Motor.py
    Filepath: /opt/openrtm/components/python/Composite/Sensor.py
    Filepath: /opt/openrtm/components/python/SimpleIO/ConsoleIn.py
    Filepath: /opt/openrtm/components/python/SimpleIO/ConsoleOut.py
  Loadable modules:
    /opt/openrtm/components/python/Composite/Controller.py
    /opt/openrtm/components/python/Composite/Motor.py

-l and -ll show the same. Slaves and components of managers are shown by their paths:

  $ rtcat ../cpp2.host_cxt/manager.mgr >plain; rtcat -l ../cpp2.host_cxt/manager.mgr | cmp - plain
  $ rtcat -ll ../cpp2.host_cxt/manager.mgr | cmp - plain
  $ rtcat -l ../cpp2.host_cxt/manager.mgr/manager | head -2
  Name: manager
  Instance name: manager
  $ rtcat ../cpp2.host_cxt/manager.mgr/ConsoleIn0.rtc | head -1
  ConsoleIn0.rtc  Inactive
  $ rtcat ../cpp2.host_cxt/manager.mgr/manager/ConsoleIn0.rtc:out
  +DataOutPort: out
  $ rtcat ../cpp2.host_cxt/manager.mgr ../cpp2.host_cxt/ConsoleOut0.rtc | grep -E '^$|ConsoleOut0'

  ConsoleOut0.rtc  Inactive
    Instance name  ConsoleOut0

--json: all that the manager reports, its modules, components and slaves

  $ rtcat --json ../py2.host_cxt/manager.mgr | python3 -c 'import json, re, sys
  > found = json.load(sys.stdin)
  > print(sorted(found), found["kind"], found["path"])
  > print(found["profile"]["name"], found["profile"]["instance_name"], found["profile"]["pid"].isdigit())
  > print(found["components"], [re.sub("[0-9]+$", "N", slave) for slave in found["slaves"]])
  > print(found["loaded_modules"][0], found["loadable_modules"][0])'
  ['components', 'kind', 'loadable_modules', 'loaded_modules', 'path', 'profile', 'slaves'] manager /localhost:$PORT/py2.host_cxt/manager.mgr
  manager manager True
  ['ConsoleIn0', 'ConsoleOut0'] ['/localhost:$PORT/py2.host_cxt/manager.mgr/manager_N', '/localhost:$PORT/py2.host_cxt/manager.mgr/manager_N']
  /opt/openrtm/components/python/Composite/Controller.py /opt/openrtm/components/python/Composite/Controller.py

Failures:

  $ rtcat ../cpp2.host_cxt/manager.mgr:out
  rtcat: /localhost:$PORT/cpp2.host_cxt/manager.mgr: not a component (it is a manager)
  [3]
  $ rtcat ../cpp2.host_cxt/nobody.mgr
  rtcat: /localhost:$PORT/cpp2.host_cxt/nobody.mgr: no such path
  [3]
  $ rtcat ../cpp2.host_cxt/manager.mgr/nobody ../cpp2.host_cxt/manager.mgr/ConsoleIn1.rtc
  rtcat: /localhost:$PORT/cpp2.host_cxt/manager.mgr/nobody: no such path
  rtcat: /localhost:$PORT/cpp2.host_cxt/manager.mgr/ConsoleIn1.rtc: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ hang manager2
  $ within 4-8 rtcat --timeout 4 ../cpp2.host_cxt/manager.mgr
  rtcat: /localhost:$PORT/cpp2.host_cxt/manager.mgr: no answer within 4s
  [4]
  $ wake manager2
  $ kill-mock manager2
  $ rtcat ../cpp2.host_cxt/manager.mgr
  rtcat: /localhost:$PORT/cpp2.host_cxt/manager.mgr: connection refused; its process is gone (zombie)
  [4]
