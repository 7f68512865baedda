A robot must not notice that it is looked at: rtls asks each component as little as can be. The mocks count.

world: many 200
world: services --context svc.host_cxt/%n.rtc
both: each ORB reads answers in its own way

Names, and whether each still lives: one call a component, at most 4 at a time to one process.

  $ ctl reset; rtls | wc -l
  200
  $ calls
  200 _non_existent
  $ test $(ctl highwater) -le 4

-l: four calls a component, one a port (a Mock has two ports). In each line: how often, what.

  $ ctl reset; rtls -l | grep -c '^Inactive  2/0  1/0  1/0  0/0  Mock'
  200
  $ calls
  200 get_component_state
  200 get_owned_contexts
  200 get_participating_contexts
  400 get_port_profile
  200 get_ports
  $ test $(ctl highwater) -le 4
  $ calls Mock7
  1 get_component_state
  1 get_owned_contexts
  1 get_participating_contexts
  2 get_port_profile
  1 get_ports

One component is asked alone; the other 199 hear nothing.

  $ ctl reset
  $ rtls Mock7.rtc
  Mock7.rtc
  $ calls
  1 _non_existent
  $ ctl reset
  $ rtls -l Mock7.rtc Mock8.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock7.rtc
  Inactive  2/0  1/0  1/0  0/0  Mock8.rtc
  $ calls Mock7
  1 get_component_state
  1 get_owned_contexts
  1 get_participating_contexts
  2 get_port_profile
  1 get_ports
  $ calls | awk '{calls += $1} END {print calls}'
  12

Naming contexts and name servers are listed without asking any component below them; so are mistyped names.

  $ ctl reset
  $ rtls -l ..
  -  -  -  -  -  svc.host_cxt
  -  -  -  -  -  test.host_cxt
  $ rtls -l /
  -  -  -  -  -  localhost:$PORT
  $ rtls ../svc.host_cxt
  MyServiceConsumer0.rtc
  MyServiceProvider0.rtc
  $ rtls Mock7.rtd Mock201.rtc
  rtls: /localhost:$PORT/test.host_cxt/Mock7.rtd: no such path; did you mean Mock7.rtc?
  rtls: /localhost:$PORT/test.host_cxt/Mock201.rtc: no such path; did you mean Mock21.rtc?
  [3]
  $ rtls Mock7.rtc/
  rtls: /localhost:$PORT/test.host_cxt/Mock7.rtc: not a directory (it is a component)
  [3]
  $ rtls Mock7.rtc/Mock8.rtc
  rtls: /localhost:$PORT/test.host_cxt/Mock7.rtc: not a directory (it is a component)
  [3]
  $ rtls Mock7.rtc:in
  rtls: /localhost:$PORT/test.host_cxt/Mock7.rtc:in: not a directory or component (it is a port; rtcat shows it)
  [3]
  $ calls

-0 and --json ask no more than the listing does.

  $ rtls -0 >/dev/null
  $ calls
  200 _non_existent
  $ ctl reset
  $ rtls --json >/dev/null
  $ calls
  200 _non_existent
  $ ctl reset
  $ rtls -R / >/dev/null; calls
  200 _non_existent
