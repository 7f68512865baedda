rtcat shows what a component or a port reports about itself. ConsoleIn0 is connected to ConsoleOut0.

world: linked

  $ rtcat ConsoleIn0.rtc
  ConsoleIn0.rtc  Inactive
    Category       example
    Description    Console input component
    Instance name  ConsoleIn0
    Type name      ConsoleIn
    Vendor         Shinji Kurihara
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
   +Extra properties
  +Execution Context 0
  +DataOutPort: out

-l opens what follows a +, and names the ports that are connected.

  $ rtcat -l ConsoleIn0.rtc
  ConsoleIn0.rtc  Inactive
    Category       example
    Description    Console input component
    Instance name  ConsoleIn0
    Type name      ConsoleIn
    Vendor         Shinji Kurihara
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
   +Extra properties
  -Execution Context 0
    State  Running
    Kind   Periodic
    Rate   1000.0
    Owner  ConsoleIn0
   +Extra properties
  -DataOutPort: out
    data_type                                IDL:RTC/TimedLong:1.0
    dataport.data_type                       IDL:RTC/TimedLong:1.0
    dataport.dataflow_type                   push,pull,duplex
    dataport.interface_option.corba_cdr\x20\x20\x20\x20\x20\x20 (esc)
    dataport.interface_option.csp_channel\x20\x20\x20\x20 (esc)
    dataport.interface_option.data_service\x20\x20\x20 (esc)
    dataport.interface_option.direct\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    dataport.interface_option.shared_memory\x20\x20 (esc)
    dataport.interface_type                  corba_cdr,csp_channel,data_service,direct,shared_memory
    dataport.io_mode                         block,flush,new,nonblock,periodic
    dataport.marshaling_types                cdr
    dataport.subscription_type               block,flush,new,nonblock,periodic
    port.port_type                           DataOutPort
   +Connected to  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in

-ll (or -l -l; more is no more) also shows the properties of everything.

  $ rtcat -ll ConsoleOut0.rtc
  ConsoleOut0.rtc  Inactive
    Category       example
    Description    Console output component
    Instance name  ConsoleOut0
    Type name      ConsoleOut
    Vendor         Shinji Kurihara
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
    Extra properties:
      activity_type                            DataFlowComponent
      category                                 example
      conf.default\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
      config.version                           2.1.0
      config_file\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
      corba.endpoints                          127.0.0.1:* (glob)
      corba.endpoints_ipv4                     127.0.0.1:* (glob)
      corba.endpoints_ipv6\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
      corba.id                                 omniORB
      description                              Console output component
      exec_cxt.periodic.rate                   1000
      exec_cxt.periodic.type                   PeriodicExecutionContext
      exec_cxt.sync_transition                 YES
      exec_cxt.transition_timeout              0.5
      implementation_id                        ConsoleOut
      instance_name                            ConsoleOut0
      lang_type                                script
      language                                 Python
      logger.enable                            YES
      logger.log_level                         INFO
      manager.instance_name                    manager
      max_instance                             10
      naming.enable                            YES
      naming.formats                           test.host_cxt/%n.rtc
      naming.names                             test.host_cxt/ConsoleOut0.rtc
      naming.type                              corba
      openrtm.name                             OpenRTM-aist-2.1.0
      openrtm.version                          2.1.0
      os.arch                                  x86_64
      os.hostname                              test
      os.name                                  Linux
      os.release                               6.1.0
      os.version                               #1 SMP
      port.inport.dataport\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
      sdo.service.consumer.available_services  IDL:OpenRTM/ComponentObserver:1.0
      sdo.service.consumer.enabled_services    ALL
      sdo.service.provider.available_services\x20\x20 (esc)
      sdo.service.provider.enabled_services    ALL
      type_name                                ConsoleOut
      vendor                                   Shinji Kurihara
      version                                  1.0
   -Execution Context 0
      State  Running
      Kind   Periodic
      Rate   1000.0
      Owner  ConsoleOut0
     -Extra properties
        rate                1000
        sync_transition     YES
        transition_timeout  0.5
        type                PeriodicExecutionContext
   -DataInPort: in
      data_type                                IDL:RTC/TimedLong:1.0
      dataport.data_type                       IDL:RTC/TimedLong:1.0
      dataport.dataflow_type                   push,pull,duplex
      dataport.interface_option.corba_cdr\x20\x20\x20\x20\x20\x20 (esc)
      dataport.interface_option.csp_channel\x20\x20\x20\x20 (esc)
      dataport.interface_option.data_service\x20\x20\x20 (esc)
      dataport.interface_option.direct\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
      dataport.interface_option.shared_memory\x20\x20 (esc)
      dataport.interface_type                  corba_cdr,csp_channel,data_service,direct,shared_memory
      dataport.marshaling_types                cdr
      dataport.subscription_type               Any
      port.port_type                           DataInPort
     -Connected to  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
        Name                            out_in
        ID                              $UUID
        dataport.dataflow_type          push
        dataport.interface_type         corba_cdr
        dataport.subscription_type      flush
        dataport.data_type              IDL:RTC/TimedLong:1.0
        dataport.serializer.cdr.endian  little,big
        dataport.outport.data_type      IDL:RTC/TimedLong:1.0
        dataport.inport.data_type       IDL:RTC/TimedLong:1.0
  $ rtcat -ll ConsoleIn0.rtc | sed 1,/^.-Exec/d >two; for level in '-l -l' -lll '-l -ll'; do
  >     rtcat $level ConsoleIn0.rtc | sed 1,/^.-Exec/d | diff two -; done

A port alone:

  $ rtcat ConsoleIn0.rtc:out
  +DataOutPort: out
  $ rtcat ConsoleOut0.rtc:in -l
  -DataInPort: in
    data_type                                IDL:RTC/TimedLong:1.0
    dataport.data_type                       IDL:RTC/TimedLong:1.0
    dataport.dataflow_type                   push,pull,duplex
    dataport.interface_option.corba_cdr\x20\x20\x20\x20\x20\x20 (esc)
    dataport.interface_option.csp_channel\x20\x20\x20\x20 (esc)
    dataport.interface_option.data_service\x20\x20\x20 (esc)
    dataport.interface_option.direct\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    dataport.interface_option.shared_memory\x20\x20 (esc)
    dataport.interface_type                  corba_cdr,csp_channel,data_service,direct,shared_memory
    dataport.marshaling_types                cdr
    dataport.subscription_type               Any
    port.port_type                           DataInPort
   +Connected to  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  $ rtcat -ll ConsoleIn0.rtc:out | sed -n '/Connected/,$p'
   -Connected to  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
      Name                            out_in
      ID                              $UUID
      dataport.dataflow_type          push
      dataport.interface_type         corba_cdr
      dataport.subscription_type      flush
      dataport.data_type              IDL:RTC/TimedLong:1.0
      dataport.serializer.cdr.endian  little,big
      dataport.outport.data_type      IDL:RTC/TimedLong:1.0
      dataport.inport.data_type       IDL:RTC/TimedLong:1.0

Several, components and ports, an empty line between them:

  $ rtcat ConsoleIn0.rtc:out ConsoleOut0.rtc /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  +DataOutPort: out

  ConsoleOut0.rtc  Inactive
    Category       example
    Description    Console output component
    Instance name  ConsoleOut0
    Type name      ConsoleOut
    Vendor         Shinji Kurihara
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
   +Extra properties
  +Execution Context 0
  +DataInPort: in

  +DataInPort: in

Paths are relative to RTCSH_CWD, or absolute; a server need not be in RTCTREE_NAMESERVERS.

  $ RTCSH_CWD=/ rtcat localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  +DataOutPort: out
  $ rtcat ../test.host_cxt/./ConsoleIn0.rtc:out
  +DataOutPort: out
  $ (unset RTCTREE_NAMESERVERS RTCSH_CWD; rtcat -l /127.0.0.1:$PORT/test.host_cxt/ConsoleIn0.rtc:out |
  >     tail -n 1)
   +Connected to  /127.0.0.1:$PORT/test.host_cxt/ConsoleOut0.rtc:in
  $ RTCTREE_NAMESERVERS=localhost:1 rtcat -l ConsoleOut0.rtc:in | tail -n 1
   +Connected to  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out
  $ rtcat ConsoleOut0.rtc:ConsoleOut0.in
  +DataInPort: in

--json is for programs: an object a line, everything in it that -ll shows.

  $ rtcat --json ConsoleIn0.rtc ConsoleOut0.rtc:in | python3 -c 'import json, sys
  > component, port = map(json.loads, sys.stdin)
  > print(sorted(component))
  > print(component["path"], component["state"], component["instance_name"], \
  >     component["properties"]["language"])
  > print(sorted(component["execution_contexts"][0]), component["execution_contexts"][0]["rate"])
  > print(sorted(port), port["path"], port["type"], port["properties"]["dataport.data_type"])
  > print(sorted(port["connectors"][0]), port["connectors"][0]["connected_to"])'
  ['category', 'composite', 'composite_member', 'compositions', 'description', 'execution_contexts', 'instance_name', 'parent', 'parent_compositions', 'path', 'ports', 'properties', 'state', 'type_name', 'vendor', 'version']
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc Inactive ConsoleIn0 Python
  ['handle', 'kind', 'owner', 'participants', 'properties', 'rate', 'running', 'state'] 1000.0
  ['connectors', 'interfaces', 'name', 'path', 'properties', 'type'] /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc:in DataInPort IDL:RTC/TimedLong:1.0
  ['connected_to', 'id', 'name', 'properties'] ['/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out']
  $ rtcat --json ConsoleIn0.rtc:out ConsoleOut0.rtc | LC_ALL=C grep -c '^{[ -~]*}$'
  2

What does not exist:

  $ rtcat ConsolIn0.rtc
  rtcat: /localhost:$PORT/test.host_cxt/ConsolIn0.rtc: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ rtcat nothing.like.it ConsoleIn0.rtc:out
  rtcat: /localhost:$PORT/test.host_cxt/nothing.like.it: no such path
  +DataOutPort: out
  [5]
  $ rtcat ConsoleIn0.rtc:uot
  rtcat: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such port: uot (its ports: out)
  [3]
  $ rtcat ConsoleIn0.rtc:out ConsoleIn0.rtc:in nothing.rtc:in
  +DataOutPort: out
  rtcat: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no such port: in (its ports: out)
  rtcat: /localhost:$PORT/test.host_cxt/nothing.rtc: no such path
  [5]
  $ rtcat ConsolIn0.rtc:out
  rtcat: /localhost:$PORT/test.host_cxt/ConsolIn0.rtc: no such path; did you mean ConsoleIn0.rtc?
  [3]

What is no component:

  $ rtcat .
  rtcat: /localhost:$PORT/test.host_cxt: not a component or manager (it is a directory)
  [3]
  $ rtcat /
  rtcat: /: not a component or manager (it is a root directory)
  [3]
  $ rtcat ..
  rtcat: /localhost:$PORT: not a component or manager (it is a name server)
  [3]
  $ rtcat ConsoleIn0.rtc/
  rtcat: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtcat ConsoleIn0.rtc/out
  rtcat: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtcat ../test.host_cxt:out
  rtcat: /localhost:$PORT/test.host_cxt: not a component or manager (it is a directory)
  [3]
  $ rtcat ../../localhost:1/a.rtc
  rtcat: /localhost:1: connection refused; is the name server running?
  [4]

Wrong usage:

  $ rtcat
  rtcat: the following arguments are required: PATH[:PORT] (see --help)
  [2]
  $ rtcat -x ConsoleIn0.rtc
  rtcat: unrecognized arguments: -x (see --help)
  [2]
  $ rtcat --ll ConsoleIn0.rtc
  rtcat: --ll is an option of old versions; now: -ll (see --help)
  [2]
  $ rtcat ConsoleIn0.rtc:out:in
  rtcat: ConsoleIn0.rtc:out:in: a single colon separates a component from its port; write \: in a name
  [2]
  $ rtcat ConsoleIn0.rtc:out/
  rtcat: ConsoleIn0.rtc:out/: a port has no directory below it
  [2]
  $ rtcat ConsoleIn0.rtc:
  rtcat: ConsoleIn0.rtc:: no port after the colon
  [2]
  $ rtcat :out
  rtcat: :out: a single colon separates a component from its port; write \: in a name
  [2]
  $ rtcat --timeout 1s ConsoleIn0.rtc
  rtcat: argument --timeout: not a number of seconds above 0: 1s (see --help)
  [2]

The common options:

  $ rtcat -v -q --timeout=22.5 ConsoleIn0.rtc:out
  +DataOutPort: out
  $ rtcat ConsoleIn0.rtc:out --verbose --quiet --timeout 20
  +DataOutPort: out
  $ rtcat --version
  1.0.0
  $ rtcat --help -v | sed -n '/^examples/,/^$/p'
  examples:
    rtcat ConsoleIn0.rtc
    rtcat -ll ConsoleIn0.rtc:out
          a port, its connections and their properties
    rtcat --json ConsoleIn0.rtc
   (esc)
  $ rtcat -hv | grep -o '^  --*[a-zR0-9]*' | tr -d '\n'; echo
    -l  --json  -v  -q  --timeout  --version  -h
  $ rtcat ConsoleIn0.rtc >/dev/full
  rtcat: No space left on device
  [1]
  $ rtcat ConsoleIn0.rtc Nobody0.rtc >/dev/full
  rtcat: /localhost:$PORT/test.host_cxt/Nobody0.rtc: no such path
  rtcat: No space left on device
  [1]
  $ rtcat ConsoleIn0.rtc >&-
  rtcat: cannot write the output: Bad file descriptor
  [1]

On a terminal the state, the handle of a context, names of ports and of what they are connected to stand out:

  $ terminal 80 rtcat -l ConsoleOut0.rtc | grep '\['
  ConsoleOut0.rtc  \x1b[01;34mInactive\x1b[00m (esc)
  -Execution Context \x1b[01m0\x1b[00m (esc)
  -DataInPort: \x1b[01min\x1b[00m (esc)
   +Connected to  \x1b[01m/localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out\x1b[00m (esc)
  $ NO_COLOR=1 terminal 80 rtcat ConsoleOut0.rtc | head -n 1
  ConsoleOut0.rtc  Inactive
  $ terminal 80 rtcat --json ConsoleOut0.rtc:in | grep -c '\['
  1

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -ll A
invocation: A:out
invocation: --json A B
looking: -ll A B
looking: --json A
broken component: 5
examples: asking
