Connections in rtlog --events: those of a composite's members have the members' paths, also when one of them is dead; a port that
does not answer hides no other.

world: these ConsoleIn:Fine0 ConsoleOut:Sink0
world: these ConsoleIn:Dead0
world: manager
alone: kills

  $ events() { rtlog --json -f a.mcap | grep 'PORT_\|DIED' |
  > sed 's/.*"event": "//; s/".*_cxt\/\(.*\)", "subject": "\(.*\)".*/ \1 \2/; s/ $//'; }
  $ rtcomp -q -a Dead0.rtc:out -a Fine0.rtc:out $(rtfind /localhost:$PORT -t m | head -n 1):A0
  $ rtlog -q --events -f a.mcap . 2> nul & pid=$!
  $ soon 'rtlog -d -f a.mcap | grep system-1'
  $ kill-mock these2; soon 'events | grep DIED'
  $ rtcon -q Fine0.rtc:out Sink0.rtc:in; soon '[ $(events | grep -c _CONNECT) = 2 ]'
  $ rtdis Fine0.rtc:out Sink0.rtc:in; soon 'events | grep _DISCONNECT.Fine0'
  $ soon 'events | grep _DISCONNECT.Sink0'
  $ asked() { ctl calls | grep get_connector_profiles; }; before=$(asked)
  $ ctl fail get_connector_profiles 1 HANG; soon '[ "$(asked)" != "$before" ]'
  $ rtcon -q Fine0.rtc:out Sink0.rtc:in
  $ soon '[ $(events | grep -c _CONNECT) = 4 ]'
  $ kill $pid; wait $pid
  [143]
  $ events | sort
  DIED Dead0.rtc
  PORT_CONNECT Fine0.rtc Fine0.out
  PORT_CONNECT Fine0.rtc Fine0.out
  PORT_CONNECT Sink0.rtc Sink0.in
  PORT_CONNECT Sink0.rtc Sink0.in
  PORT_DISCONNECT Fine0.rtc Fine0.out
  PORT_DISCONNECT Sink0.rtc Sink0.in

Ports that a composite shows come and go, also where it shows no other:

  $ rtcomp -q -a Sink0.rtc $(rtfind /localhost:$PORT -t m | head -n 1):Arm; rm a.mcap
  $ rtlog -q --events -f a.mcap . 2> nul & pid=$!
  $ soon 'rtlog -d -f a.mcap | grep system-1'
  $ rtcomp -q -a Sink0.rtc:in Arm.rtc; soon 'events | grep ADD.Arm'
  $ for n in 1 2; do rtcomp -q -r Sink0.rtc:in Arm.rtc; soon "[ \$(events | grep -c REMOVE.Arm) = $n ]"
  >     rtcomp -q -a Sink0.rtc:in Arm.rtc; soon "[ \$(events | grep -c ADD.Arm) = $((n + 1)) ]"
  > done
  $ kill $pid; wait $pid
  [143]
  $ events | grep Arm | sort | uniq -c | sed 's/^ *//'
  3 PORT_ADD Arm.rtc Sink0.in
  2 PORT_REMOVE Arm.rtc Sink0.in

One that refuses our observer is asked for its connections all the same:

  $ rm a.mcap; ctl fail add_service_profile 1 UNKNOWN
  $ rtlog -q --events -f a.mcap . 2> nul & pid=$!
  $ soon 'rtlog -d -f a.mcap | grep system-1'
  $ [ $(for name in Fine0 Sink0; do ctl observers $name; done | grep -c Observer) = 1 ] || echo both
  $ rtdis -q Fine0.rtc:out Sink0.rtc:in; soon '[ $(events | grep -c "_DISCONNECT \(Fine0\|Sink0\)") = 2 ]'
  $ kill $pid; wait $pid
  [143]
