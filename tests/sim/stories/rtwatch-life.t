rtwatch reports when a component exits, dies, falls silent, and when it is there again.

world: observed
world: these ConsoleIn:Plain0 --flavour cpp2
world: these ConsoleIn:Dies0 --flavour py2
world: these ConsoleIn:Gone0 --flavour cpp2

One that exits in good order, one that dies, observed and polled, and come back. Once back, it is observed again:

  $ rtwatch -f RTC_STATUS -f LIFE_EVENT Motor0.rtc Plain0.rtc Dies0.rtc Gone0.rtc &
  $ sleep 2
  $ ctl observers Motor0
  IDL:OpenRTM/ComponentObserver:1.0
  $ ctl @these2 observers Dies0
  IDL:OpenRTM/ComponentObserver:1.0
  $ rtexit Motor0.rtc Plain0.rtc
  $ kill these2
  $ kill these3
  $ sleep 10
  $ show rtwatch
  [Motor0.rtc 2.0] 0 FINALIZE
  [Motor0.rtc 2.0] EXITED
  [Gone0.rtc 2.0] DIED
  [Dies0.rtc 2.0] DIED
  [Plain0.rtc 2.1] EXITED
  ! rtwatch: /robot/test.host_cxt/Plain0.rtc: offers no observer; it is polled (5 Hz), which shows no connections
  ! rtwatch: /robot/test.host_cxt/Gone0.rtc: offers no observer; it is polled (5 Hz), which shows no connections
  $ mock these ConsoleIn:Dies0 ConsoleIn:Gone0 --flavour py2
  $ sleep 10
  $ rtact Dies0.rtc Gone0.rtc
  $ sleep 1
  $ show rtwatch
  [Dies0.rtc 12.0] BACK
  [Gone0.rtc 12.0] BACK
  [Dies0.rtc 22.0] 0 ACTIVE
  [Gone0.rtc 22.0] 0 ACTIVE
  $ strike TERM rtwatch
  $ wait rtwatch
  [143] after 23.0 s
  $ ctl @these4 observers Dies0
  $ ctl @these4 observers Gone0

A component whose process hangs, and goes on. What is not wanted as an event is reported on stderr; and SIGTERM ends the watch
within the timeout, although nothing can be taken back:

  $ rtwatch -f RTC_STATUS --timeout 0.5 Dies0.rtc &
  $ sleep 1
  $ hang these4
  $ sleep 10
  $ show rtwatch
  ! rtwatch: /robot/test.host_cxt/Dies0.rtc: no answer within 0.5s
  $ wake these4
  $ sleep 10
  $ rtdeact Dies0.rtc
  $ sleep 1
  $ show rtwatch
  [44.0] 0 INACTIVE
  ! rtwatch: /robot/test.host_cxt/Dies0.rtc: answers again
  $ hang these4
  $ sleep 10
  $ strike TERM rtwatch
  $ sleep 0.6
  $ wait rtwatch
  ! rtwatch: /robot/test.host_cxt/Dies0.rtc: no answer within 0.5s
  ! rtwatch: /robot/test.host_cxt/Dies0.rtc: does not answer; it still has our observer, and drops it when a call to it fails
  [143] after 32.0 s
  $ wake these4

One that answers, but has lost its observer: it is lent once more, then the component is polled.

  $ rtwatch -f RTC_STATUS -f LIFE_EVENT -f PORT_EVENT ConsoleIn0.rtc ConsoleOut0.rtc &
  $ sleep 2
  $ rtact ConsoleIn0.rtc ConsoleOut0.rtc
  $ sleep 1
  $ ctl mute ConsoleIn0
  $ ctl mute ConsoleOut0 9
  $ sleep 30
  $ show rtwatch
  [ConsoleIn0.rtc 57.6] 0 ACTIVE
  [ConsoleOut0.rtc 57.6] 0 ACTIVE
  [ConsoleIn0.rtc 57.6] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 61.4] NO_HEARTBEAT
  [ConsoleOut0.rtc 61.4] NO_HEARTBEAT
  [ConsoleIn0.rtc 61.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 61.4] ANSWERS
  [ConsoleIn0.rtc 62.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 63.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 64.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 65.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 66.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 67.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 68.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 69.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 70.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 71.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 72.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 73.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 74.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 75.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 76.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 77.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 78.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 79.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 80.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 81.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 82.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 83.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 84.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 85.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 86.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 87.4] ConsoleIn0.out PORT_SEND
  [ConsoleIn0.rtc 88.4] ConsoleIn0.out PORT_SEND
  ! rtwatch: /robot/test.host_cxt/ConsoleIn0.rtc: no heartbeat for 3 s
  ! rtwatch: /robot/test.host_cxt/ConsoleOut0.rtc: no heartbeat for 3 s
  ! rtwatch: /robot/test.host_cxt/ConsoleOut0.rtc: cannot call us at 10.0.0.1:$PORT; it is polled from now on
  $ rtdeact ConsoleIn0.rtc ConsoleOut0.rtc
  $ sleep 1
  $ strike TERM rtwatch
  $ wait rtwatch
  [ConsoleIn0.rtc 88.6] 0 INACTIVE
  [ConsoleOut0.rtc 88.7] 0 INACTIVE
  [143] after 34.0 s
  $ ctl observers ConsoleIn0
  $ ctl observers ConsoleOut0

One that takes the observer only after some seconds is watched from then on:

  $ ctl delay add_service_profile 4
  $ rtwatch -f RTC_STATUS -f LIFE_EVENT --timeout 60 ConsoleIn0.rtc &
  $ sleep 3.9
  $ ctl observers ConsoleIn0
  $ sleep 1
  $ ctl observers ConsoleIn0
  IDL:OpenRTM/ComponentObserver:1.0
  $ ctl reset
  $ rtact ConsoleIn0.rtc
  $ sleep 1
  $ strike TERM rtwatch
  $ wait rtwatch
  [94.5] 0 ACTIVE
  [143] after 5.9 s
  $ rtdeact ConsoleIn0.rtc

An observer of C++ is removed at once, but the component answers only when its heart would have beaten again. Nobody waits for
that after Ctrl-C, SIGTERM or SIGHUP; the observer is gone all the same.

  $ mock observed --flavour cpp2 --context cpp.host_cxt/%n.rtc
  $ RTCSH_CWD=/robot/cpp.host_cxt
  $ rtwatch ConsoleIn0.rtc ConsoleOut0.rtc Microwave0.rtc &
  $ sleep 2
  $ ctl @observed2 observers ConsoleIn0
  IDL:OpenRTM/ComponentObserver:1.0
  $ strike INT rtwatch
  $ wait rtwatch
  [ConsoleIn0.rtc 96.6] HEARTBEAT
  [ConsoleOut0.rtc 96.6] RTC_HEARTBEAT
  [ConsoleOut0.rtc 96.6] EC_HEARTBEAT
  [Microwave0.rtc 96.6] RTC_HEARTBEAT
  [Microwave0.rtc 96.6] EC_HEARTBEAT
  [130] after 2.1 s
  $ ctl @observed2 observers ConsoleIn0
  $ ctl @observed2 observers ConsoleOut0
  $ ctl @observed2 observers Microwave0
  $ rtwatch ConsoleIn0.rtc ConsoleOut0.rtc Microwave0.rtc &
  $ sleep 2
  $ ctl @observed2 observers ConsoleIn0
  IDL:OpenRTM/ComponentObserver:1.0
  $ strike TERM rtwatch
  $ wait rtwatch
  [ConsoleIn0.rtc 98.7] HEARTBEAT
  [ConsoleOut0.rtc 98.7] RTC_HEARTBEAT
  [ConsoleOut0.rtc 98.7] EC_HEARTBEAT
  [Microwave0.rtc 98.7] RTC_HEARTBEAT
  [Microwave0.rtc 98.7] EC_HEARTBEAT
  [143] after 2.1 s
  $ ctl @observed2 observers ConsoleIn0
  $ ctl @observed2 observers ConsoleOut0
  $ ctl @observed2 observers Microwave0
  $ rtwatch ConsoleIn0.rtc ConsoleOut0.rtc Microwave0.rtc &
  $ sleep 2
  $ ctl @observed2 observers ConsoleIn0
  IDL:OpenRTM/ComponentObserver:1.0
  $ strike HUP rtwatch
  $ wait rtwatch
  [ConsoleIn0.rtc 100.8] HEARTBEAT
  [ConsoleOut0.rtc 100.8] RTC_HEARTBEAT
  [ConsoleOut0.rtc 100.8] EC_HEARTBEAT
  [Microwave0.rtc 100.8] RTC_HEARTBEAT
  [Microwave0.rtc 100.8] EC_HEARTBEAT
  [129] after 2.1 s
  $ ctl @observed2 observers ConsoleIn0
  $ ctl @observed2 observers ConsoleOut0
  $ ctl @observed2 observers Microwave0
  $ rtwatch -f LIFE_EVENT -t 0.1 ConsoleIn0.rtc
  [0] after 1.1 s
