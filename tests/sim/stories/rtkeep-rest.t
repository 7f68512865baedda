At rest, who reports by himself is asked for connections only, which no observer of ours reports (protocol.md 5.4), and others all
else: a question each --look seconds. (What is Inactive sends nothing meanwhile.)

world: these ConsoleIn ConsoleOut Motor ConfigSample
world: these ConsoleOut:Plain0 --flavour cpp2

  $ rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon -i two ConsoleIn0.rtc:out Plain0.rtc:in
  $ rtcryo --all -o a.xml
  $ rtkeep a.xml &
  $ sleep 30
  $ rtdeact ConsoleIn0.rtc
  $ sleep 30
  $ ctl @these reset
  $ ctl @these2 reset
  $ sleep 20
  $ calls @these
  10 get_connector_profiles
  $ calls @these2
  5 get_component_state
  5 get_connector_profiles
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:00:00] /robot/test.host_cxt/ConfigSample0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Motor0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Plain0.rtc: Active
  [08:00:30] /robot/test.host_cxt/ConsoleIn0.rtc: was made Inactive by hand: left alone
  [0] after 80.0 s
