What rtcat shows of components of C++ 1.1, 1.2 and 2.x, Python, Java, RtORB.

world: these ConsoleIn ConsoleOut MyServiceProvider --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider --flavour py2 --context py2.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider --flavour java --context java.host_cxt/%n.rtc
world: these ConsoleIn ConsoleOut MyServiceProvider --flavour rtorb --context rtorb.host_cxt/%n.rtc

What the other versions print as C++ 1.1 does is not repeated:

  $ each() { for v in cpp11 cpp12 cpp2 py2 java rtorb; do
  >   { RTCSH_CWD=/localhost:$PORT/$v.host_cxt "$@" 2>&1; s=$?; [ $s = 0 ] || echo "status $s"; } |
  >       sed "s/$v.host/V.host/g; s/[0-9a-f-]\{36\}/ID/" >$v
  >   [ $v != cpp11 ] && cmp -s cpp11 $v || { echo "$v:"; cat $v; }
  > done; }

  $ each rtcat ConsoleIn0.rtc
  cpp11:
  ConsoleIn0.rtc  Inactive
    Category       example
    Description    Console input component
    Instance name  ConsoleIn0
    Type name      ConsoleIn
    Vendor         Noriaki Ando, AIST
    Version        1.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
   +Extra properties
  +Execution Context 0
  +DataOutPort: out
  cpp2:
  ConsoleIn0.rtc  Inactive
    Category       example
    Description    Console input component
    Instance name  ConsoleIn0
    Type name      ConsoleIn
    Vendor         AIST
    Version        2.0.0
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
   +Extra properties
  +Execution Context 0
  +DataOutPort: out
  py2:
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
  $ each rtcat -l ConsoleIn0.rtc:out
  cpp11:
  -DataOutPort: out
    dataport.data_type          IDL:RTC/TimedLong:1.0
    dataport.data_value         <IDL:RTC/TimedLong:1.0>
    dataport.dataflow_type      push,pull
    dataport.interface_type     corba_cdr
    dataport.subscription_type  flush,new,periodic
    port.port_type              DataOutPort
  cpp12:
  -DataOutPort: out
    dataport.data_type          IDL:RTC/TimedLong:1.0
    dataport.dataflow_type      push,pull
    dataport.interface_type     corba_cdr,direct,shared_memory
    dataport.subscription_type  flush,new,periodic
    port.port_type              DataOutPort
  cpp2:
  -DataOutPort: out
    data_type                                IDL:RTC/TimedLong:1.0
    dataport.data_type                       IDL:RTC/TimedLong:1.0
    dataport.dataflow_type                   push,pull
    dataport.interface_option.corba_cdr\x20\x20\x20\x20\x20\x20 (esc)
    dataport.interface_option.data_service\x20\x20\x20 (esc)
    dataport.interface_option.direct\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    dataport.interface_option.shared_memory\x20\x20 (esc)
    dataport.interface_type                  corba_cdr,data_service,direct,shared_memory
    dataport.io_mode                         block,flush,new,nonblock,periodic
    dataport.marshaling_types                cdr
    dataport.subscription_type               block,flush,new,nonblock,periodic
    port.port_type                           DataOutPort
  py2:
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
  java:
  -DataOutPort: out
    dataport.data_type          IDL:RTC/TimedLong:1.0
    dataport.data_value         <IDL:RTC/TimedLong:1.0>
    dataport.dataflow_type      push,pull
    dataport.interface_type     corba_cdr,direct,shared_memory
    dataport.subscription_type  flush,new,periodic
    port.port_type              DataOutPort
  rtorb:
  -DataOutPort: out
    dataport.data_type          TimedLong
    dataport.dataflow_type      push
    dataport.interface_type     corba_cdr
    dataport.subscription_type  flush
    port.port_type              DataOutPort
  $ each rtcat -l MyServiceProvider0.rtc:MyService
  cpp11:
  -CorbaPort: MyService
    port.port_type  CorbaPort
    Interface:
      Instance name  myservice0
      Type name      MyService
      Polarity       Provided
  cpp2:
  -CorbaPort: MyService
    port.port_type  CorbaPort
    Interface:
      Instance name  myservice
      Type name      SimpleService::MyService
      Polarity       Provided

Connections:

  $ each rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  cpp11:
  $ connections() { rtcat -ll "$1" | sed -n '/Connected/,$p'; }
  $ each connections ConsoleIn0.rtc:out
  cpp11:
   -Connected to  /localhost:$PORT/V.host_cxt/ConsoleOut0.rtc:in
      Name                            outin
      ID                              ID
      dataport.data_type              IDL:RTC/TimedLong:1.0
      dataport.dataflow_type          push
      dataport.interface_type         corba_cdr
      dataport.subscription_type      new
      dataport.serializer.cdr.endian  little,big
  cpp2:
   -Connected to  /localhost:$PORT/V.host_cxt/ConsoleOut0.rtc:in
      Name                            outin
      ID                              ID
      dataport.data_type              IDL:RTC/TimedLong:1.0
      dataport.dataflow_type          push
      dataport.interface_type         corba_cdr
      dataport.subscription_type      new
      dataport.serializer.cdr.endian  little,big
      dataport.outport\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
      dataport.inport\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
  py2:
   -Connected to  /localhost:$PORT/V.host_cxt/ConsoleOut0.rtc:in
      Name                            outin
      ID                              ID
      dataport.data_type              IDL:RTC/TimedLong:1.0
      dataport.dataflow_type          push
      dataport.interface_type         corba_cdr
      dataport.subscription_type      new
      dataport.serializer.cdr.endian  little,big
      dataport.outport.data_type      IDL:RTC/TimedLong:1.0
      dataport.inport.data_type       IDL:RTC/TimedLong:1.0
  rtorb:
   -Connected to  /localhost:$PORT/V.host_cxt/ConsoleOut0.rtc:in
      Name                            outin
      ID                              ID
      dataport.data_type              TimedLong
      dataport.dataflow_type          push
      dataport.interface_type         corba_cdr
      dataport.subscription_type      flush
      dataport.serializer.cdr.endian  little,big
