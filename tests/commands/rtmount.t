rtmount makes the RTC Tree a part of the file system. All that follows is done with the applets of BusyBox alone.

needs: fuse
world: linked
world: config
world: composite --context parts.host_cxt/%n.rtc
world: services --context parts.host_cxt/%n.rtc
world: manager --context plant.host_cxt/%n.rtc
world: zombie
world: names --context odd.host_cxt/%n.rtc

It returns when the tree can be used, and goes on in the background:

  $ mkdir m bin; busybox --install -s bin
  $ rtmount m
  $ tools=$PATH PATH=$PWD/bin root=$PWD/m/localhost:$PORT
  $ ls m
  README
  errors
  localhost:$PORT
  $ head -n 1 m/README
  This is the RTC Tree, the tree of OpenRTM-aist components, as files. One value a file.
  $ test $(wc -l <m/README) -le 40; wc -c m/errors
  0 m/errors
  $ ls m/localhost:$PORT
  odd.host_cxt
  parts.host_cxt
  plant.host_cxt
  test.host_cxt
  $ cd $root/test.host_cxt; ls
  ConfigSample0.rtc
  ConsoleIn0.rtc
  ConsoleOut0.rtc
  Mock0.rtc

A component. What is not listed is in rtmount-streams.t; a reader sees one value a file:

  $ cd ConsoleIn0.rtc; ls
  category
  configuration
  contexts
  description
  instance_name
  members
  ports
  profile.json
  properties
  state
  type_name
  vendor
  version
  $ cat state
  Inactive
  $ for name in instance_name type_name category vendor version description; do
  >     echo "$name: $(cat $name)"
  > done
  instance_name: ConsoleIn0
  type_name: ConsoleIn
  category: example
  vendor: Shinji Kurihara
  version: 1.0
  description: Console input component
  $ read -r state <state; echo "$state"
  Inactive
  $ PATH=$tools rtcat --json ConsoleIn0.rtc >$TMP/json; cmp profile.json $TMP/json
  $ head -n 3 properties/implementation_id properties/language properties/openrtm.name
  ==> properties/implementation_id <==
  ConsoleIn

  ==> properties/language <==
  Python

  ==> properties/openrtm.name <==
  OpenRTM-aist-2.1.0
  $ ls properties | wc -l
  41

Ports, and what they are connected to:

  $ ls ports ports/out ports/out/properties
  ports:
  out

  ports/out:
  connections
  data_type
  properties
  type

  ports/out/properties:
  data_type
  dataport.data_type
  dataport.dataflow_type
  dataport.interface_option.corba_cdr
  dataport.interface_option.csp_channel
  dataport.interface_option.data_service
  dataport.interface_option.direct
  dataport.interface_option.shared_memory
  dataport.interface_type
  dataport.io_mode
  dataport.marshaling_types
  dataport.subscription_type
  port.port_type
  $ cat ports/out/type ports/out/data_type ports/out/properties/dataport.subscription_type
  DataOutPort
  IDL:RTC/TimedLong:1.0
  block,flush,new,nonblock,periodic
  $ ls -l ports/out/connections | sed 's/.* //'
  0
  ../../../../ConsoleOut0.rtc/ports/in
  $ readlink -f ports/out/connections/out_in; cat ports/out/connections/out_in/type
  $TMP/m/localhost:$PORT/test.host_cxt/ConsoleOut0.rtc/ports/in
  DataInPort
  $ cd ../../parts.host_cxt; ls MyServiceProvider0.rtc/ports/MyService
  connections
  interfaces
  properties
  type
  $ cat MyServiceProvider0.rtc/ports/MyService/interfaces/*/type
  Provided MyService

Configuration; hidden sets are not listed, but can be opened:

  $ cd ../test.host_cxt/ConfigSample0.rtc/configuration; ls
  active
  default
  mode0
  mode1
  $ cat active
  mode1
  $ ls mode0
  double_param0
  double_param1
  int_param0
  int_param1
  str_param0
  str_param1
  vector_param0
  $ cat mode0/int_param0 __widget__/int_param0
  12345
  slider.10

Execution contexts, members of a composite:

  $ cd ../../ConsoleIn0.rtc/contexts; ls
  0
  $ ls 0
  kind
  owner
  rate
  state
  $ cat 0/state 0/rate 0/kind 0/owner
  Running
  1000
  Periodic
  ConsoleIn0
  $ cd $root/parts.host_cxt; ls -l composite0.rtc/members | sed 's/.*[0-9] //'
  total 0
  -> ../../Controller0.rtc
  -> ../../Motor0.rtc
  -> ../../Sensor0.rtc
  $ ls ../test.host_cxt/ConsoleIn0.rtc/members
  $ cat composite0.rtc/members/Motor0/instance_name
  Motor0
  $ ls Motor0.rtc/contexts
  0
  1
  $ cat Motor0.rtc/contexts/1/owner
  composite0

A manager:

  $ cd ../plant.host_cxt/manager.mgr; ls
  components
  create
  factories
  loaded
  $ ls -l components | sed 's/.*[0-9] //'
  total 0
  ConsoleIn0.rtc -> ../../ConsoleIn0.rtc
  ConsoleOut0.rtc -> ../../ConsoleOut0.rtc
  $ cat loaded
  /opt/openrtm/components/python/Composite/Controller.py
  /opt/openrtm/components/python/Composite/Motor.py
  /opt/openrtm/components/python/Composite/Sensor.py
  /opt/openrtm/components/python/SimpleIO/ConsoleIn.py
  /opt/openrtm/components/python/SimpleIO/ConsoleOut.py
  $ cat factories
  RTC:Shinji Kurihara, AIST:example:Controller:Python:1.0
  RTC:Shinji Kurihara, AIST:example:Motor:Python:1.0
  RTC:Shinji Kurihara, AIST:example:Sensor:Python:1.0
  RTC:Shinji Kurihara:example:ConsoleIn:Python:1.0
  RTC:Shinji Kurihara:example:ConsoleOut:Python:1.0
  RTC:jp.go.aist:composite.PeriodicECShared:PeriodicECSharedComposite:Python:1.0
  $ cat create

The modules that could be loaded are in no listing: to find them, a manager runs a process a file (7 s with 7 modules of C++).

  $ PATH=$tools ctl @manager reset; grep -r . . >/dev/null
  $ PATH=$tools calls @manager | grep -c modules
  0
  [1]
  $ PATH=$tools ctl @manager reset; cat loadable
  RTC::example:Sensor:Python:1.0
  RTC:Geoffrey Biggs, AIST:Perception:Clusterer:Python:2.1
  RTC:Geoffrey Biggs, AIST:Sensor:Hokuyo_AIST:Python:1.0
  RTC:Shinji Kurihara, AIST:example:Controller:Python:1.0
  RTC:Shinji Kurihara, AIST:example:Motor:Python:1.0
  RTC:Shinji Kurihara:example:ConfigSample:Python:1.0
  RTC:Shinji Kurihara:example:ConsoleIn:Python:1.0
  RTC:Shinji Kurihara:example:ConsoleOut:Python:1.0
  RTC:Shinji Kurihara:example:Microwave:Python:1.0
  RTC:Shinji Kurihara:example:MyServiceConsumer:Python:1.0
  RTC:Shinji Kurihara:example:MyServiceProvider:Python:1.0
  RTC:Shinji Kurihara:example:SeqIn:Python:1.0
  RTC:Shinji Kurihara:example:SeqOut:Python:1.0
  RTC:Shinji Kurihara:test:Err:Python:1.0
  RTC:Shinji Kurihara:test:ErrStart:Python:1.0
  RTC:Shinji Kurihara:test:Mock:Python:1.0
  RTC:Shinji Kurihara:test:Robot:Python:1.0
  RTC:Shinji Kurihara:test:Slow:Python:1.0
  RTC:Shinji Kurihara:test:Source:Python:1.0
  RTC:Shinji Kurihara:test:Stuck:Python:1.0
  RTC:Shinji Kurihara:test:Unborn:Python:1.0
  $ PATH=$tools calls @manager | grep modules
  1 get_loadable_modules

A zombie is a link that leads nowhere:

  $ cd $root/test.host_cxt; soon '[ -L Mock0.rtc ]'
  $ readlink Mock0.rtc
  zombie: its object is gone
  $ cat Mock0.rtc
  cat: can't open 'Mock0.rtc': No such file or directory
  [1]

Names that files cannot have are escaped as in our paths, slashes as \x2f; what is listed can be opened:

  $ cd ../odd.host_cxt; ls | grep -v xxx
  $(id);'"*.rtc
  -l.rtc
  Gone0.rtc
  Nil0.rtc
  NotAComponent0.rtc
  NotAManager0.mgr
  Same0.rtc
  Thing0.obj
  Twin0.rtc
  Twin0again.rtc
  \e
  a.cxt
  back\\slash.rtc
  bad\xff\xfe.rtc
  bell\x07del\x7f.rtc
  co\:lon.rtc
  csi\x9b31m.rtc
  do.t.rtc
  empty.cxt
  esc\x1b[31mred.rtc
  kind\x2fslash.r\x2ftc
  kinddot.r\.tc
  loop.cxt
  many.cxt
  nokind
  rtl\u202ecba.rtc
  sl\x2fash.rtc
  sp ace.rtc
  tab\x09new\x0aline.rtc
  ???*.rtc (glob)
  $ soon '[ -f NotAComponent0.rtc ] && [ -L Gone0.rtc ]'  # a listing waits 0.2 s for what objects are
  $ for name in *.rtc; do [ -d "./$name" ] && cat "./$name/instance_name"; done
  $(id);'"*
  -l
  Same0
  Twin0
  Twin0
  back\\slash
  bad\xff\xfe
  bell\x07del\x7f
  co:lon
  csi\x9b31m
  do.t
  esc\x1b[31mred
  rtl\u202ecba
  sl/ash
  sp ace
  tab\x09new\x0aline
  xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
  日本語
  $ cat Thing0.obj NotAComponent0.rtc Nil0.rtc
  CORBA object of unknown kind
  CORBA object of unknown kind
  nil reference
  $ readlink loop.cxt
  .

Attributes: the owner may write what can be changed, others read.

  $ cd $root/test.host_cxt; stat -c '%A %U %s %n' . ConsoleIn0.rtc ConsoleIn0.rtc/state ConsoleIn0.rtc/version
  drwxr-xr-x root 0 .
  dr-xr-xr-x root 0 ConsoleIn0.rtc
  -rw-r--r-- root 4096 ConsoleIn0.rtc/state
  -r--r--r-- root 4096 ConsoleIn0.rtc/version
  $ df $root | sed 1d
  rtmount                      0         0         0   0% $TMP/m

Whatever is listed can be read by anyone, and nothing changes, blocks or connects by it. Of one value a call, of the profile, the
ports, the configuration and the composition their own calls, however many files they are; profile.json asks for all of it.

  $ cd $TMP; PATH=$tools rtmount -u m
  $ PATH=$tools rtmount --ttl 60 m; cd m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  $ PATH=$tools ctl reset; grep -r . . | wc -l
  59
  $ find . -type f -exec cat {} + | wc -l
  69
  $ PATH=$tools calls ConsoleIn0
  1 get_active_configuration_set
  2 get_component_profile
  3 get_component_state
  1 get_configuration
  1 get_configuration_sets
  2 get_context_handle
  1 get_organizations
  2 get_owned_contexts
  2 get_owned_organizations
  2 get_participating_contexts
  2 get_port_profile
  2 get_ports
  2 get_profile
  2 get_rate
  1 get_sdo_id
  4 is_running
  $ cp -r ports $TMP/copy; cat $TMP/copy/out/type
  DataOutPort
  $ cd ..
  $ PATH=$tools rtcat -l ConsoleIn0.rtc:out | grep Conn
   +Connected to  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in

Polling: one call a value.

  $ PATH=$tools ctl reset; i=0
  $ while [ $i -lt 100 ]; do read -r state <ConsoleIn0.rtc/state; i=$((i + 1)); done
  $ echo "$state"
  Inactive
  $ PATH=$tools calls ConsoleIn0 | grep -v exist
  100 get_component_state

Other name servers appear when they are named; the root lists them then:

  $ ls ../../127.0.0.1:$PORT | head -n 1; ls ../..
  odd.host_cxt
  127.0.0.1:$PORT
  README
  errors
  localhost:$PORT
  $ cat ../../127.0.0.1:$PORT/test.host_cxt/ConsoleIn0.rtc/type_name
  ConsoleIn

The end:

  $ cd $TMP; PATH=$tools rtmount -u m
  $ ls m

local: it contacts nobody before somebody reads
prepared: mkdir robot; rtact Motor0.rtc
example: grep -l Error robot/localhost/*/*.rtc/state -> 1
