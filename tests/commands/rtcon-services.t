rtcon and rtdis on service ports.

world: services
world: services --context second.host_cxt/%n.rtc
world: services --flavour cpp2 --context cpp.host_cxt/%n.rtc
world: these Hokuyo_AIST

  $ rtcon MyServiceProvider0.rtc:MyService MyServiceConsumer0.rtc:MyService
  $ rtcat -ll MyServiceConsumer0.rtc:MyService | sed -n '/Connected/,$p' | sed 's/IOR:.*/IOR:…/'
   -Connected to  /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService
      Name                                                             MyServiceMyService
      ID                                                               $UUID
      port.port_type                                                   CorbaPort
      MyServiceProvider0.port.MyService.provided.MyService.myservice0  IOR:…
      port.MyService.myservice0                                        IOR:…
  $ rtdis MyServiceProvider0.rtc:MyService MyServiceConsumer0.rtc:MyService
  $ ctl connectors MyServiceConsumer0:MyService

The consumer first; one port alone (a provider gives its reference to the connection):

  $ rtcon -i turned MyServiceConsumer0.rtc:MyService MyServiceProvider0.rtc:MyService
  $ rtcon -i alone MyServiceProvider0.rtc:MyService
  $ ctl connectors MyServiceProvider0:MyService
  turned MyServiceMyService
  alone MyService
  $ rtdis MyServiceProvider0.rtc
  $ ctl connectors MyServiceProvider0:MyService; ctl connectors MyServiceConsumer0:MyService

Properties are passed on:

  $ rtcon -p port.connection.strictness=strict -p x=y MyServiceProvider0.rtc:MyService \
  >     MyServiceConsumer0.rtc:MyService
  $ rtcat -ll MyServiceConsumer0.rtc:MyService | grep -E 'strict|  x '
      port.connection.strictness                                       strict
      x                                                                y
  $ rtdis MyServiceConsumer0.rtc

What does not match:

  $ rtcon MyServiceProvider0.rtc:MyService ../second.host_cxt/MyServiceProvider0.rtc:MyService
  rtcon: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService to /localhost:$PORT/second.host_cxt/MyServiceProvider0.rtc:MyService: both have interface myservice0 provided
  [2]
  $ rtcon MyServiceConsumer0.rtc:MyService ../second.host_cxt/MyServiceConsumer0.rtc:MyService
  rtcon: /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService to /localhost:$PORT/second.host_cxt/MyServiceConsumer0.rtc:MyService: both have interface myservice0 required
  [2]
  $ rtcon MyServiceProvider0.rtc:MyService ../cpp.host_cxt/MyServiceConsumer0.rtc:MyService
  rtcon: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService to /localhost:$PORT/cpp.host_cxt/MyServiceConsumer0.rtc:MyService: /localhost:$PORT/cpp.host_cxt/MyServiceConsumer0.rtc:MyService has no interface myservice0
  [2]
  $ rtcon Hokuyo_AIST0.rtc:ranges MyServiceConsumer0.rtc:MyService
  rtcon: /localhost:$PORT/test.host_cxt/Hokuyo_AIST0.rtc:ranges to /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService: a data port and a service port do not go together
  [2]
  $ rtcon MyServiceProvider0.rtc:MyService MyServiceProvider0.rtc:MyService
  rtcon: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService: a port is named twice
  [2]
  $ rtcon --dry-run MyServiceProvider0.rtc:MyService ../cpp.host_cxt/MyServiceConsumer0.rtc:MyService
  rtcon: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService to /localhost:$PORT/cpp.host_cxt/MyServiceConsumer0.rtc:MyService: /localhost:$PORT/cpp.host_cxt/MyServiceConsumer0.rtc:MyService has no interface myservice0
  [2]

Interfaces of different names are joined by hand, with the property that consumers look for:

  $ rtcon -i mapped -p port.connection.strictness=strict -p 'MyServiceConsumer0.port.MyService.required.SimpleService::MyService.myservice=MyServiceProvider0.port.MyService.provided.MyService.myservice0' MyServiceProvider0.rtc:MyService ../cpp.host_cxt/MyServiceConsumer0.rtc:MyService
  $ ctl @services3 connectors MyServiceConsumer0:MyService
  mapped MyServiceMyService
  $ rtdis -i mapped MyServiceProvider0.rtc

Data properties and duplicates mean nothing here, but -d does:

  $ rtcon MyServiceProvider0.rtc:MyService MyServiceConsumer0.rtc:MyService
  $ rtcon -d MyServiceProvider0.rtc:MyService MyServiceConsumer0.rtc:MyService
  rtcon: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc:MyService to /localhost:$PORT/test.host_cxt/MyServiceConsumer0.rtc:MyService: already connected (id $UUID)
  [1]
