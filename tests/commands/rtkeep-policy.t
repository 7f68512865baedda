rtkeep gives up what fails again and again, with what depends on it, and begins again when something about it changes.

world: these Err ConsoleIn ConsoleOut Motor
world: these Sensor --flavour cpp2

  $ export XDG_RUNTIME_DIR=$PWD
  $ rtcryo --all -o a.xml localhost:$PORT

Err0 goes to Error as soon as it is Active. ConsoleIn0 starts after it, ConsoleOut0 after that; Motor0 and Sensor0 need neither.

  $ sync() {
  >     echo "<rts:Preceding rts:sendingTiming=\"SYNC\" rts:timeout=\"0\"><rts:PrecedingComponents rts:componentId=\"$1\" rts:instanceName=\"$1\" rts:id=\"0\"/></rts:Preceding>"
  > }
  $ plan $(when 1 ConsoleIn0 "$(sync Err0)") $(when 2 ConsoleOut0 "$(sync ConsoleIn0)") < a.xml > b.xml
  $ rtkeep --stop-at-end --burst 3/60 --delay 0.05-0.1 b.xml > out 2>&1 & keep=$!
  $ soon 'grep given.up out'; soon 'grep Sensor0.*Active out'
  $ said out | sort | uniq -c | sed 's/^ *//'
  1 ConsoleIn0.rtc: not tried: it waits for Err0.rtc, which failed
  1 ConsoleOut0.rtc: not tried: it waits for ConsoleIn0.rtc, which was not tried
  1 Err0.rtc: cannot activate: it went to Error
  1 Err0.rtc: cannot activate: it went to Error; given up after more than 3 failures in 60s
  3 Err0.rtc: in Error: reset
  1 Motor0.rtc: Active
  1 Sensor0.rtc: Active
  $ soon 'rtkeep status | grep "Error (given"'; rtkeep status | said
  b.xml: pid N, since T; not all is as the file says
    ConsoleIn0.rtc   Active  Inactive          T    not tried: it waits for Err0.rtc, which failed
    ConsoleOut0.rtc  Active  Inactive          T    not tried: it waits for ConsoleIn0.rtc, which was not tried
    Err0.rtc         Active  Error (given up)  T    cannot activate: it went to Error; given up after more than 3 failures in 60s
    Motor0.rtc       Active  Active            T    Active
    Sensor0.rtc      Active  Active            T    Active
  $ kill $keep; wait $keep

A required component that is given up takes those with it that were started after it. When something about it changes, it is tried
again, and they follow.

  $ rtexit --wait Err0.rtc; rtcryo --all -o c.xml localhost:$PORT
  $ plan $(when 1 ConsoleOut0 "$(sync ConsoleIn0)") $(when 2 Motor0 "$(sync ConsoleOut0)") < c.xml > d.xml
  $ rtkeep --burst 2/60 --delay 0.05-0.1 d.xml > out 2>&1 & keep=$!
  $ soon 'rtcheck d.xml'
  $ for n in 1 2; do
  >     ctl error ConsoleIn0
  >     soon "[ \$(grep -c 'In0.*reset' out) = $n ]"
  >     soon 'rtcheck d.xml'
  > done
  $ ctl error ConsoleIn0; soon 'grep -c Out0.*deactivated out'
  $ soon 'grep Motor0.*deactivated out'
  $ said out | grep -v -e Sensor0 -e not.tried | sort | uniq -c | sed 's/^ *//'
  3 ConsoleIn0.rtc: Active
  2 ConsoleIn0.rtc: in Error: reset
  1 ConsoleIn0.rtc: in Error; given up after more than 2 failures in 60s
  1 ConsoleOut0.rtc: Active
  1 ConsoleOut0.rtc: ConsoleIn0.rtc is given up: deactivated
  1 Motor0.rtc: Active
  1 Motor0.rtc: ConsoleIn0.rtc is given up: deactivated
  $ ctl state ConsoleIn0
  ERROR
  $ ctl state ConsoleOut0
  INACTIVE
  $ ctl state Motor0
  INACTIVE
  $ rtcon -i x ConsoleIn0.rtc:out ConsoleOut0.rtc:in; soon 'rtcheck d.xml'
  $ kill $keep; wait $keep
