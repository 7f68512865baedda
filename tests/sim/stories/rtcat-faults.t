rtcat of components that hang, are gone, or fail to answer something, and of a name server that hangs.

world: two
world: zombie --context test.host_cxt/Dead%n.rtc
world: hung --context test.host_cxt/Hung%n.rtc
world: contexts

A zombie, and a hung component:

  $ kill zombie
  $ hang hung
  $ rtcat DeadMock0.rtc
  ! rtcat: /robot/test.host_cxt/DeadMock0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtcat -ll DeadMock0.rtc:out
  ! rtcat: /robot/test.host_cxt/DeadMock0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ rtcat --timeout 0.3 HungMock0.rtc
  ! rtcat: /robot/test.host_cxt/HungMock0.rtc: no answer within 0.3s
  [4] after 0.3 s
  $ RTSHELL_TIMEOUT=0.3 rtcat -l HungMock0.rtc:in
  ! rtcat: /robot/test.host_cxt/HungMock0.rtc: no answer within 0.3s
  [4] after 0.3 s
  $ rtcat --timeout 0.3 --json HungMock0.rtc HungMock0.rtc:in DeadMock0.rtc ConsoleIn0.rtc:out
  {"connectors": [], "interfaces": [], "name": "ConsoleIn0.out", "path": "/robot/test.host_cxt/ConsoleIn0.rtc:out", "properties": {"data_type": "IDL:RTC/TimedLong:1.0", "dataport.data_type": "IDL:RTC/TimedLong:1.0", "dataport.dataflow_type": "push,pull,duplex", "dataport.interface_option.corba_cdr": "", "dataport.interface_option.csp_channel": "", "dataport.interface_option.data_service": "", "dataport.interface_option.direct": "", "dataport.interface_option.shared_memory": "", "dataport.interface_type": "corba_cdr,csp_channel,data_service,direct,shared_memory", "dataport.io_mode": "block,flush,new,nonblock,periodic", "dataport.marshaling_types": "cdr", "dataport.subscription_type": "block,flush,new,nonblock,periodic", "port.port_type": "DataOutPort"}, "type": "DataOutPort"}
  ! rtcat: /robot/test.host_cxt/HungMock0.rtc: no answer within 0.3s
  ! rtcat: /robot/test.host_cxt/DeadMock0.rtc: connection refused; its process is gone (zombie)
  [5] after 0.3 s

A component that fails to answer something. A failure that says that it is passing is asked once more.

  $ ctl fail get_port_profile 1 TRANSIENT
  $ rtcat ConsoleIn0.rtc:out
  +DataOutPort: out
  $ ctl fail get_port_profile 1 TRANSIENT
  $ ctl fail get_port_profile 2 TRANSIENT
  $ rtcat ConsoleIn0.rtc:out
  ! rtcat: /robot/test.host_cxt/ConsoleIn0.rtc: cannot be reached now (CORBA.TRANSIENT)
  [4]
  $ ctl fail get_component_profile 1 COMM_FAILURE
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
  $ ctl fail get_ports 1 NO_IMPLEMENT
  $ rtcat ConsoleIn0.rtc
  ! rtcat: /robot/test.host_cxt/ConsoleIn0.rtc: CORBA.NO_IMPLEMENT
  [6]
  $ ctl fail get_ports 1 NO_PERMISSION
  $ rtcat ConsoleIn0.rtc Multi0.rtc:in
  +DataInPort: in
  ! rtcat: /robot/test.host_cxt/ConsoleIn0.rtc: CORBA.NO_PERMISSION
  [5]
  $ ctl fail get_component_profile 1 OBJECT_NOT_EXIST
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
  $ ctl fail get_component_profile 1 HANG
  $ rtcat --timeout 0.3 ConsoleIn0.rtc
  ! rtcat: /robot/test.host_cxt/ConsoleIn0.rtc: no answer within 0.3s
  [4] after 0.3 s
  $ ctl fail get_owned_organizations 1 NO_IMPLEMENT
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
  $ ctl fail is_running 1 UNKNOWN
  $ rtcat -l ConsoleIn0.rtc
  ! rtcat: /robot/test.host_cxt/ConsoleIn0.rtc: CORBA.UNKNOWN
  [6]

Name servers:

  $ rtcat ../../robot:1/a.rtc /robot:1/b.rtc:in
  ! rtcat: /robot:1: connection refused; is the name server running?
  [4]
  $ rtcat /no-such-host.invalid/a.rtc
  ! rtcat: /no-such-host.invalid: host name not known
  [4]
  $ hang names
  $ rtcat --timeout 0.3 ConsoleIn0.rtc
  ! rtcat: /robot: no answer within 0.3s
  [4] after 0.3 s
  $ interrupt 0.3 rtcat ConsoleIn0.rtc
  [130] after 0.3 s
  $ wake names
  $ RTCSH_CWD= interrupt 0.3 rtcat robot/test.host_cxt/HungMock0.rtc
  [130] after 0.3 s
