What rtresurrect makes of systems that break while they are restored, and of hostile ones.

world: linked
world: these ConsoleOut:ConsoleOut1 ConsoleOut:ConsoleOut2 ConfigSample

  $ rtdis ConsoleIn0.rtc
  $ rtcon -i 0 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcon -i 1 ConsoleIn0.rtc:out ConsoleOut1.rtc:in
  $ rtcon -i 2 ConsoleIn0.rtc:out ConsoleOut2.rtc:in
  $ rtcryo --all -o a.xml /robot/test.host_cxt

What a restoration costs that has nothing to do: a look at everything, once.

  $ ctl reset
  $ rtresurrect a.xml
  $ calls ConsoleOut0
  1 get_active_configuration_set
  1 get_component_profile
  1 get_component_state
  1 get_configuration
  1 get_configuration_sets
  1 get_context_handle
  1 get_owned_contexts
  1 get_owned_organizations
  1 get_participating_contexts
  1 get_port_profile
  1 get_ports
  1 get_profile

A connection that a component refuses: what else can be done is done, and the second time it is completed.

  $ rtteardown a.xml
  $ ctl @these fail notify_connect 2 UNKNOWN
  $ rtresurrect -v a.xml
  ! rtresurrect: connection 0 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut0.rtc:in: done
  ! rtresurrect: connection 1 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut1.rtc:in: done
  ! rtresurrect: /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: refused by the component (BAD_PARAMETER)
  ! rtresurrect: 2 done, 20 already done, 1 failed
  [5]
  $ rtresurrect -v a.xml
  ! rtresurrect: connection 2 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: done
  ! rtresurrect: 1 done, 22 already done

One that dies meanwhile: nothing more is asked of it, and no half of a connection stays. It is started again; the next time all
is completed:

  $ rtteardown a.xml
  $ rtec ConsoleOut2.rtc rate 100
  $ ctl @these fail set_rate 1 DIE
  $ rtresurrect -v a.xml
  ! rtresurrect: /robot/test.host_cxt/ConsoleOut2.rtc: connection refused; its process is gone (zombie)
  ! rtresurrect: connection 0 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut0.rtc:in: done
  ! rtresurrect: connection 1 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut1.rtc:in: not tried because of /robot/test.host_cxt/ConsoleOut1.rtc
  ! rtresurrect: connection 2 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: not tried because of /robot/test.host_cxt/ConsoleOut2.rtc
  ! rtresurrect: 1 done, 19 already done, 1 failed, 2 not tried
  [5]
  $ ctl connectors ConsoleIn0:out
  0 outin
  $ mock these ConsoleOut:ConsoleOut1 ConsoleOut:ConsoleOut2 ConfigSample
  $ rtresurrect -v a.xml
  ! rtresurrect: connection 1 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut1.rtc:in: done
  ! rtresurrect: connection 2 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: done
  ! rtresurrect: 2 done, 21 already done
  $ rtcheck -s inactive a.xml

One that has died before, whose end of the connections the others still have: it is removed first.

  $ kill these2
  $ mock these ConsoleOut:ConsoleOut1 ConsoleOut:ConsoleOut2 ConfigSample
  $ rtresurrect -v a.xml
  ! rtresurrect: connection 1 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut1.rtc:in: done
  ! rtresurrect: connection 2 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: done
  ! rtresurrect: 2 done, 21 already done

One that falls silent costs one timeout, and one look after it:

  $ rtteardown a.xml
  $ rtconf ConfigSample0.rtc set int_param0 5
  $ ctl @these3 fail set_configuration_set_values 1 HANG
  $ rtresurrect --timeout 0.5 -v a.xml
  ! rtresurrect: /robot/test.host_cxt/ConfigSample0.rtc: no answer within 0.5s
  ! rtresurrect: connection 0 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut0.rtc:in: done
  ! rtresurrect: connection 1 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut1.rtc:in: done
  ! rtresurrect: connection 2 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: done
  ! rtresurrect: 3 done, 19 already done, 1 failed
  [5] after 0.6 s
  $ rtresurrect a.xml
  $ rtteardown a.xml
  $ hang these3
  $ rtresurrect --timeout 0.5 a.xml
  ! rtresurrect: /robot/test.host_cxt/ConfigSample0.rtc: no answer within 0.5s
  ! rtresurrect: /robot/test.host_cxt/ConsoleOut1.rtc: no answer within 0.5s
  ! rtresurrect: /robot/test.host_cxt/ConsoleOut2.rtc: no answer within 0.5s
  ! rtresurrect: 1 done, 6 already done, 3 failed, 13 not tried
  [5] after 0.6 s
  $ wake these3
  $ rtresurrect -v a.xml
  ! rtresurrect: connection 1 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut1.rtc:in: done
  ! rtresurrect: connection 2 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: done
  ! rtresurrect: 2 done, 21 already done

At Ctrl-C it reports what has been done, and what may have been:

  $ rtteardown a.xml
  $ ctl @these3 delay notify_connect 6
  $ interrupt 3 rtresurrect --timeout 5 -v a.xml
  ! rtresurrect: connection 0 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut0.rtc:in: done
  ! rtresurrect: /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut1.rtc:in: interrupted while it was done
  ! rtresurrect: connection 2 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: not tried
  ! rtresurrect: 1 done, 20 already done, 1 uncertain, 1 not tried
  [130] after 3.0 s
  $ sleep 5
  $ ctl @these3 connectors ConsoleOut1:in
  1 outin
  $ ctl @these3 reset
  $ rtresurrect a.xml
  $ rtcheck -s inactive a.xml

With --rollback it undoes all, what was being done, too, as soon as that has come to its end:

  $ rtteardown a.xml
  $ ctl @these3 delay notify_connect 4
  $ terminate 3 rtresurrect --rollback --timeout 9 -v a.xml
  ! rtresurrect: connection 0 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut0.rtc:in: undone
  ! rtresurrect: connection 1 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut1.rtc:in: undone
  ! rtresurrect: connection 2 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: not tried
  ! rtresurrect: 20 already done, 2 undone, 1 not tried
  [143] after 4.0 s
  $ ctl @these3 reset
  $ rtteardown --dry-run a.xml
  $ rtresurrect a.xml
  $ rtcheck -s inactive a.xml

The configuration set that was active before is active again:

  $ rtconf ConfigSample0.rtc list
  +default
  +mode0
  +mode1*
  $ rtconf ConfigSample0.rtc act mode0
  $ rtteardown a.xml
  $ ctl @these3 fail notify_connect 1 UNKNOWN
  $ rtresurrect --rollback -v a.xml
  ! rtresurrect: active configuration set mode1 of /robot/test.host_cxt/ConfigSample0.rtc: undone
  ! rtresurrect: connection 0 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut0.rtc:in: undone
  ! rtresurrect: /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut1.rtc:in: refused by the component (BAD_PARAMETER)
  ! rtresurrect: connection 2 of /robot/test.host_cxt/ConsoleIn0.rtc:out to /robot/test.host_cxt/ConsoleOut2.rtc:in: not tried
  ! rtresurrect: 19 already done, 2 undone, 1 failed, 1 not tried
  [6]
  $ rtconf ConfigSample0.rtc list
  +default
  +mode0*
  +mode1
  $ rtresurrect a.xml
  $ rtcheck -s inactive a.xml

A name server that is not there:

  $ rtresurrect --map robot=robot:1 a.xml
  ! rtresurrect: /robot:1: connection refused; is the name server running?
  ! rtresurrect: 5 failed, 18 not tried
  [4]
