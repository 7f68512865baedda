rtact where components take their time, fail when they are Active for a period, or are executed by nobody.

world: slow
world: stopped --flavour cpp2 --context stopped.host_cxt/%n.rtc
world: error --flavour cpp11 --context old.host_cxt/%n.rtc
world: stopped --flavour cpp11 --context oldstopped.host_cxt/%n.rtc
world: these ErrStart ConsoleIn --flavour cpp2 --context lame.host_cxt/%n.rtc --rate 2
world: these ErrStart --flavour cpp2 --context late.host_cxt/%n.rtc --rate 0.5

A period is that of the execution context; one that is Active already may fall yet, too:

  $ rtact --wait ../lame.host_cxt/ErrStart0.rtc
  ! rtact: /robot/lame.host_cxt/ErrStart0.rtc: cannot activate: it went to Error
  [6] after 1.0 s
  $ rtact ../late.host_cxt/ErrStart0.rtc
  [0] after 1.0 s
  $ rtact --wait ../late.host_cxt/ErrStart0.rtc
  ! rtact: /robot/late.host_cxt/ErrStart0.rtc: cannot activate: it went to Error
  [6] after 2.0 s
  $ rtact ../lame.host_cxt/ConsoleIn0.rtc
  [0] after 0.5 s
  $ ctl @these reset
  $ rtact -v --wait ../lame.host_cxt/ConsoleIn0.rtc
  ! rtact: /robot/lame.host_cxt/ConsoleIn0.rtc: Active
  [0] after 0.5 s
  $ calls @these
  4 get_component_state
  1 get_owned_contexts
  1 get_participating_contexts
  1 get_rate
  $ rtec ../lame.host_cxt/ConsoleIn0.rtc rate 0.1
  $ rtact --wait=1 ../lame.host_cxt/ConsoleIn0.rtc
  ! rtact: /robot/lame.host_cxt/ConsoleIn0.rtc: Active, but not yet for a period (10s) of its execution context
  [4] after 1.0 s

Slow components: OpenRTM waits half a second, answers RTC_ERROR, and changes the state later. That is no failure:

  $ rtact -v Slow0.rtc
  ! rtact: /robot/test.host_cxt/Slow0.rtc: Active
  [0] after 0.8 s
  $ ctl @slow state Slow0
  ACTIVE
  $ rtdeact --wait 0.1 Slow0.rtc
  ! rtdeact: /robot/test.host_cxt/Slow0.rtc: not Inactive within 0.1s, still Active
  [4] after 0.5 s

A context of 1 Hz takes up to a second:

  $ rtact -v Lazy0.rtc
  ! rtact: /robot/test.host_cxt/Lazy0.rtc: accepted
  [0] after 0.6 s
  $ ctl @slow state Lazy0
  ACTIVE

One that never gets there is a failure, after --timeout or what --wait says:

  $ rtact --timeout 0.8 Stuck0.rtc
  ! rtact: /robot/test.host_cxt/Stuck0.rtc: not Active within 0.8s, still Inactive
  [4] after 1.4 s
  $ rtact --wait 0.8 Stuck0.rtc
  ! rtact: /robot/test.host_cxt/Stuck0.rtc: not Active within 0.8s, still Inactive
  [4] after 1.4 s

In a stopped execution context nothing changes. What is asked is done later: a deactivation as soon as the context is started, an
activation when something wakes it up, such as another one:

  $ rtact ../stopped.host_cxt/ConsoleIn0.rtc ../stopped.host_cxt/ConsoleOut0.rtc
  ! rtact: /robot/stopped.host_cxt/ConsoleIn0.rtc: cannot activate: its execution context is stopped; once started, it may still do so
  [5] after 0.5 s
  $ ctl @stopped state ConsoleIn0
  INACTIVE
  $ ctl @stopped state ConsoleOut0
  ACTIVE
  $ rtec ../stopped.host_cxt/ConsoleIn0.rtc start
  $ rtec ../stopped.host_cxt/ConsoleOut0.rtc stop
  $ rtdeact -q ../stopped.host_cxt/ConsoleOut0.rtc
  ! rtdeact: /robot/stopped.host_cxt/ConsoleOut0.rtc: cannot deactivate: its execution context is stopped; once started, it may still do so
  [6] after 0.5 s
  $ rtec ../stopped.host_cxt/ConsoleOut0.rtc start
  $ sleep 1
  $ ctl @stopped state ConsoleOut0
  INACTIVE
  $ ctl @stopped state ConsoleIn0
  INACTIVE
  $ rtact --wait ../stopped.host_cxt/ConsoleIn0.rtc

Components of OpenRTM 1.1 accept at once and change later, if at all; only --wait reports what came of it:

  $ rtact ../oldstopped.host_cxt/ConsoleIn0.rtc
  $ ctl @stopped2 state ConsoleIn0
  INACTIVE
  $ rtact --wait=1 ../oldstopped.host_cxt/ConsoleIn0.rtc
  ! rtact: /robot/oldstopped.host_cxt/ConsoleIn0.rtc: cannot activate: its execution context is stopped; once started, it may still do so
  [6]
  $ rtact --wait ../oldstopped.host_cxt/ConsoleOut0.rtc
  $ rtact ../old.host_cxt/ErrStart0.rtc --wait
  ! rtact: /robot/old.host_cxt/ErrStart0.rtc: cannot activate: it went to Error
  [6]
