Managers of OpenRTM differ, and so does what rtmgr has to know: C++ 1.1, 1.2 and 2.x, Python, Java, RtORB.

world: manager --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: manager --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: manager --flavour py2 --context py2.host_cxt/%n.rtc
world: manager --flavour java --context java.host_cxt/%n.rtc
world: manager --flavour rtorb --context rtorb.host_cxt/%n.rtc

  $ at() { where=$1; shift; RTCSH_CWD=/localhost:$PORT/$where.host_cxt rtmgr "$@" manager.mgr; }

The identity of what is to be created has no language in it with C++ 1.1 and RtORB, and one with all others; rtmgr knows
both, and what it lists can be created everywhere:

  $ at cpp11 --factories | grep Motor
  RTC:Noriaki Ando, AIST:example:Motor:C++:1.0
  $ at cpp12 --factories | grep Motor
  RTC:Noriaki Ando, AIST:example:Motor:C++:1.0
  $ at java --factories | grep Motor
  RTC:Noriaki Ando, AIST:example:Motor:Java:1.0
  $ at rtorb --factories | grep Motor
  RTC:Noriaki Ando, AIST:example:Motor:C:1.0
  $ at cpp11 -vc "$(at cpp11 --factories | grep Motor)"
  rtmgr: created Motor0
  $ at cpp12 -vc "$(at cpp12 --factories | grep Motor)"
  rtmgr: created Motor0
  $ at py2 -vc "$(at py2 --factories | grep Motor)"
  rtmgr: created Motor0
  $ at java -vc "$(at java --factories | grep Motor)"
  rtmgr: created Motor0
  $ at rtorb -vc "$(at rtorb --factories | grep Motor)"
  rtmgr: created Motor0
  $ at cpp11 -vc 'RTC:Noriaki Ando, AIST:example:Motor:C++:1.0'
  rtmgr: created Motor1
  $ at cpp12 -vc 'RTC:Noriaki Ando, AIST:example:Motor:1.0'
  rtmgr: created Motor1

Masters of C++ 1.1 and RtORB make components themselves, the others have a slave do it; both is where it should be:

  $ ctl components
  ConsoleIn0
  ConsoleOut0
  Motor0
  Motor1
  $ ctl @manager2 components; ctl @manager2 slave 1 components
  ConsoleIn0
  ConsoleOut0
  Motor0
  Motor1
  $ at cpp11 -vd Motor0
  rtmgr: deleted Motor0
  $ at cpp12 -vd Motor0
  rtmgr: deleted Motor0
  $ at py2 -vd Motor0
  rtmgr: deleted Motor0
  $ at java -vd Motor0
  rtmgr: deleted Motor0
  $ at rtorb -vd Motor0
  rtmgr: deleted Motor0

C++ 1.1 and RtORB say RTC_OK to a name that they do not know:

  $ at cpp11 -d nobody
  rtmgr: /localhost:$PORT/cpp11.host_cxt/manager.mgr: no such component: nobody
  [3]
  $ at rtorb -d nobody
  rtmgr: /localhost:$PORT/rtorb.host_cxt/manager.mgr: no such component: nobody
  [3]
  $ at cpp12 -d nobody
  rtmgr: /localhost:$PORT/cpp12.host_cxt/manager.mgr: no such component: nobody
  [3]

Python keeps the instance name of one creation for the next, and gives back what is there already: nothing new

  $ at py2 -v -c 'Motor?instance_name=left' -c Motor
  rtmgr: created left
  rtmgr: /localhost:$PORT/py2.host_cxt/manager.mgr: created nothing of use: it returned the name left, which is taken; give another one: ?instance_name=…
  [6]
  $ at py2 -v -c 'Motor?instance_name=right' -d left -d right
  rtmgr: created right
  rtmgr: deleted left
  rtmgr: deleted right
  $ at cpp11 -v -c 'Motor?instance_name=left' -c Motor
  rtmgr: created left
  rtmgr: created Motor0
  $ at cpp12 -v -c 'Motor?instance_name=left' -c Motor
  rtmgr: created left
  rtmgr: created Motor0

A name that is taken is refused, by rtmgr: the process of C++ 1.x would crash as soon as both have ended

  $ at cpp11 -c 'Motor?instance_name=left'
  rtmgr: /localhost:$PORT/cpp11.host_cxt/manager.mgr: has a component left already
  [6]
  $ at cpp12 -c 'Sensor?instance_name=left'
  rtmgr: /localhost:$PORT/cpp12.host_cxt/manager.mgr: has a component left already
  [6]
  $ at py2 -c 'Motor?instance_name=ConsoleIn0'
  rtmgr: /localhost:$PORT/py2.host_cxt/manager.mgr: has a component ConsoleIn0 already
  [6]

Modules that could be loaded are not known to C++ 1.1, if its helper program is not found; Python fails to get at a vendor:

  $ at cpp11 -m
  $ at py2 -m | grep -E 'Sensor|Motor'
  RTC::example:Sensor:Python:1.0
  RTC:Geoffrey Biggs, AIST:Sensor:Hokuyo_AIST:Python:1.0
  RTC:Shinji Kurihara, AIST:example:Motor:Python:1.0
  $ at py2 --json -m | python3 -c 'import json, sys
  > print([each["implementation_id"] for each in map(json.loads, sys.stdin) if "vendor" not in each])'
  ['Sensor']

The configuration of Python has a number for its process id, which is shown like any value:

  $ at py2 -g | sed -n 's/^manager.pid:  *[0-9][0-9]*$/a number/p'
  a number
  $ at py2 --json -g | python3 -c 'import json, sys; print(json.load(sys.stdin)["manager.pid"].isdigit())'
  True

A component in a slave that is started for it, by its master (RtORB and Python do not). Slaves are told apart by their
instance names where these differ:

  $ at cpp12 --wait -v -c 'Motor?manager_name=fresh&instance_name=far'
  rtmgr: created far
  $ rtls ../cpp12.host_cxt/manager.mgr ../cpp12.host_cxt/manager.mgr/fresh
  ../cpp12.host_cxt/manager.mgr:
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Motor0.rtc
  Motor1.rtc
  far.rtc
  fresh/
  left.rtc
  manager/

  ../cpp12.host_cxt/manager.mgr/fresh:
  far.rtc
   (esc)
  $ at cpp12 -vd far
  rtmgr: deleted far
  $ rtls ../cpp12.host_cxt/manager.mgr/fresh
  $ at py2 -v -c 'Motor?manager_name=fresh'
  rtmgr: /localhost:$PORT/py2.host_cxt/manager.mgr: does not create Motor?manager_name=fresh (a wrong argument, its max_instance of 10 is reached, or its own initialisation failed)
  [6]
  $ at java -v -c 'Motor?manager_name=fresh&instance_name=far' -d far
  rtmgr: created far
  rtmgr: deleted far

A slave of C++ 1.1: its master says RTC_OK when it is to delete one of its components, and does nothing

  $ M=$(ctl port)
  $ mock slave localhost:$M manager 'Motor?instance_name=far' --flavour cpp11 --context cpp11.host_cxt/%n.rtc
  $ rtls ../cpp11.host_cxt/manager.mgr/manager
  far.rtc
  $ at cpp11 -v -d far
  rtmgr: deleted far
  $ at cpp11 -v -c "Sensor?manager=localhost:$(ctl @slave port)&instance_name=far" -d far
  rtmgr: created far
  rtmgr: deleted far

Masters that end, after their slaves:

  $ at cpp11 -v --shutdown
  rtmgr: shut down /localhost:$PORT/cpp11.host_cxt/manager.mgr/manager
  rtmgr: shut down /localhost:$PORT/cpp11.host_cxt/manager.mgr
  $ at cpp12 -v --shutdown
  rtmgr: shut down /localhost:$PORT/cpp12.host_cxt/manager.mgr/manager
  rtmgr: shut down /localhost:$PORT/cpp12.host_cxt/manager.mgr/fresh
  rtmgr: shut down /localhost:$PORT/cpp12.host_cxt/manager.mgr
  $ at py2 --shutdown
  $ at java --shutdown
  $ at rtorb --shutdown
  $ rtls -R ..
  .:
  cpp11.host_cxt/
  cpp12.host_cxt/
  java.host_cxt/
  py2.host_cxt/
  rtorb.host_cxt/

  ./cpp11.host_cxt:

  ./cpp12.host_cxt:

  ./java.host_cxt:

  ./py2.host_cxt:

  ./rtorb.host_cxt:
   (esc)
