rtinject stays until what it sends can have been read, and says so where it cannot.

world: these ConsoleOut Mock:Mock0 ConsoleOut:Slow0 ConsoleIn
world: composite --context robot.host_cxt/%n.rtc

A component reads in its own cycles, however seldom they come; none of its values stays behind:

  $ rtact ConsoleOut0.rtc Slow0.rtc ConsoleIn0.rtc
  $ rtec ConsoleOut0.rtc rate 1000
  $ rtinject -c 1000 ConsoleOut0.rtc:in
  [0] after 0.1 s
  $ ctl received ConsoleOut0:in
  1 1000
  $ rtec ConsoleOut0.rtc rate 100
  $ rtinject -c 100 ConsoleOut0.rtc:in
  [0] after 0.1 s
  $ ctl received ConsoleOut0:in
  2 100
  $ rtec ConsoleOut0.rtc rate 10
  $ rtinject -c 10 ConsoleOut0.rtc:in
  [0] after 0.4 s
  $ ctl received ConsoleOut0:in
  3 10
  $ rtec ConsoleOut0.rtc rate 2
  $ rtinject -c 2 ConsoleOut0.rtc:in
  [0] after 1.3 s
  $ ctl received ConsoleOut0:in
  4 2
  $ rtec ConsoleOut0.rtc rate 1
  $ rtinject -c 6 -n 4 -r 400 ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: waiting 5.1 s until it has read the values (--linger limits it)
  [0] after 5.1 s
  $ ctl received ConsoleOut0:in
  8 6

A rate that it does not reach is reported once, and what was refused is counted; all that was taken is read:

  $ rtec ConsoleOut0.rtc rate 20
  $ rtinject -c 7 -n 100 -r 400 ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: values come faster than it reads them (19.9 Hz)
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: it refused 70 of 100 values: they came faster than it reads them (20.3 Hz)
  [5] after 2.6 s
  $ ctl waiting ConsoleOut0:in
  0

--linger limits that; what has not been read is reported, and dropped, so that no later connection brings it:

  $ rtec Slow0.rtc rate 0.1
  $ rtinject -c 7 --linger 0.1 Slow0.rtc:in
  ! rtinject: /robot/test.host_cxt/Slow0.rtc:in: it executes at 0.1 Hz; it has read about 0 of 1 values; the rest is dropped
  [5] after 0.3 s
  $ ctl waiting Slow0:in
  0
  $ ctl connectors Slow0:in
  $ rtec ConsoleOut0.rtc rate 0.1
  $ rtinject -q -c 7 --linger 0 Slow0.rtc:in ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/Slow0.rtc:in: it executes at 0.1 Hz; it has read about 0 of 1 values; the rest is dropped
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: it executes at 0.1 Hz; it has read about 0 of 1 values; the rest is dropped
  [5] after 0.2 s

Who is not going to read is sent nothing, without --anyway:

  $ rtec Slow0.rtc rate 20
  $ rtec ConsoleOut0.rtc rate 20
  $ rtdeact --wait=30 Slow0.rtc
  [0] after 9.8 s
  $ ctl reset
  $ rtinject -c 8 Slow0.rtc:in
  ! rtinject: /robot/test.host_cxt/Slow0.rtc:in: it is Inactive and would read the values at some later connection; rtact /robot/test.host_cxt/Slow0.rtc first, or --anyway
  [1]
  $ ctl error Mock0
  $ rtinject -c 8 Mock0.rtc:in
  ! rtinject: /robot/test.host_cxt/Mock0.rtc:in: it is in Error and would read the values at some later connection; rtreset /robot/test.host_cxt/Mock0.rtc, then rtact /robot/test.host_cxt/Mock0.rtc first, or --anyway
  [1]
  $ rtact Slow0.rtc
  [0] after 0.1 s
  $ rtec Slow0.rtc stop
  $ rtinject -c 8 Slow0.rtc:in
  ! rtinject: /robot/test.host_cxt/Slow0.rtc:in: its execution context is stopped and would read the values at some later connection; rtec /robot/test.host_cxt/Slow0.rtc start first, or --anyway
  [1]
  $ rtinject -c 8 Slow0.rtc:in ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/Slow0.rtc:in: its execution context is stopped and would read the values at some later connection; rtec /robot/test.host_cxt/Slow0.rtc start first, or --anyway
  [5] after 0.2 s
  $ rtinject -c 8 -n 20 -r 100 Slow0.rtc:in
  ! rtinject: /robot/test.host_cxt/Slow0.rtc:in: its execution context is stopped and would read the values at some later connection; rtec /robot/test.host_cxt/Slow0.rtc start first, or --anyway
  [1]
  $ ctl calls Slow0
  1 activate_component
  5 get_component_state
  6 get_owned_contexts
  5 get_participating_contexts
  4 get_port_profile
  4 get_ports
  5 is_running
  1 stop
  $ ctl waiting Slow0:in
  0
  $ rtinject -c 8 --anyway Slow0.rtc:in
  [0] after 0.1 s
  $ ctl waiting Slow0:in
  1
  $ rtinject -c 8 --anyway --linger 0.5 Slow0.rtc:in
  [0] after 0.5 s
  $ ctl waiting Slow0:in
  2
  $ rtinject -c 8 -n 20 -r 100 --anyway Slow0.rtc:in
  [0] after 0.2 s
  $ ctl waiting Slow0:in
  8
  $ ctl buffer Slow0:in
  8 overwrite
  $ rtinject --dry-run -c 8 --anyway --linger 0.5 Slow0.rtc:in
  rtinject -c 8 -n 1 -r 1 --linger 0.5 --anyway /robot/test.host_cxt/Slow0.rtc:in

A member of a composite reads in the composite's context, and is activated there:

  $ rtinject -c 1 ../robot.host_cxt/Motor0.rtc:in
  ! rtinject: /robot/robot.host_cxt/Motor0.rtc:in: it is Inactive and would read the values at some later connection; rtact -e 1 /robot/robot.host_cxt/Motor0.rtc first, or --anyway
  [1]
  $ rtact --wait ../robot.host_cxt/composite0.rtc
  [0] after 0.1 s
  $ rtinject -c 1 ../robot.host_cxt/Motor0.rtc:in ../robot.host_cxt/composite0.rtc:Sensor0.in
  [0] after 0.1 s
  $ ctl @composite received Motor0:in
  1 1.0
  $ ctl @composite received Sensor0:in
  1 1

Who stops reading meanwhile gets no more:

  $ rtec ConsoleOut0.rtc rate 100
  $ rtdeact --wait=30 ConsoleOut0.rtc
  $ rtact --wait=30 ConsoleOut0.rtc
  $ rtinject -q -n -1 -r 50 -c 9 ConsoleOut0.rtc:in &
  $ sleep 2
  $ rtdeact ConsoleOut0.rtc
  $ wait rtinject
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: it is Inactive now; it has read about 100 of 104 values; the rest is dropped
  [5] after 3.1 s
  $ ctl waiting ConsoleOut0:in
  0
  $ ctl connectors ConsoleOut0:in
  $ rtact ConsoleOut0.rtc

The buffer of a port that others are connected to stays as it is; sending faster than it is read is reported once:

  $ rtec ConsoleOut0.rtc rate 20
  $ rtdeact ConsoleIn0.rtc
  $ rtcon ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtinject -c 1 -n 100 -r 400 ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: values come faster than it executes (20 Hz)
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: it executes at 20 Hz; it has probably read about 13 of 100 values; the rest is in its buffer, or overwritten
  [5] after 0.8 s
  $ rtinject -c 1 ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: it has probably read the value: others are connected, and share its buffer
  [0] after 0.2 s

Whoever writes to the port, too, may push values out of its buffer: an Active component, or another tool. That fetched values wait
elsewhere:

  $ rtact --wait=30 ConsoleIn0.rtc
  $ rtinject -c 1 ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: sent; others write to this port, so whether it was read is not known
  [5] after 0.2 s
  $ rtinject -c 1 -n 3 -r 10 ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: sent; others write to this port, so whether the 3 values were read is not known
  [5] after 0.5 s
  $ rtdis ConsoleOut0.rtc:in
  $ rtcon -p dataflow_type=pull ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtinject -c 1 ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: it has probably read the value: others are connected, and share its buffer
  [0] after 0.2 s
  $ rtdis ConsoleOut0.rtc:in
  $ rtinject -q -c 1 -n -1 -r 20 ConsoleOut0.rtc:in &
  $ sleep 1
  $ rtinject -c 1 ConsoleOut0.rtc:in
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: sent; others write to this port, so whether it was read is not known
  [5] after 0.2 s
  $ strike TERM rtinject
  $ wait rtinject
  [143] after 1.3 s
  $ ctl buffer ConsoleOut0:in
  8 overwrite
  $ ctl connectors ConsoleOut0:in
  $ rtact ConsoleIn0.rtc

One that the user asks for is reckoned with:

  $ rtec ConsoleOut0.rtc rate 20
  $ ctl received ConsoleOut0:in
  204 1
  $ rtinject -q -c 5 -n 40 -r 400 --property dataport.buffer.length=100 ConsoleOut0.rtc:in
  [0] after 2.7 s
  $ ctl received ConsoleOut0:in
  244 5

A buffer that somebody else asks for meanwhile stays as it is:

  $ rtdeact ConsoleIn0.rtc
  $ rtec ConsoleOut0.rtc rate 1
  $ rtinject -q -c 1 -n 12 -r 400 --linger 2 ConsoleOut0.rtc:in &
  $ sleep 0.1
  $ ctl buffer ConsoleOut0:in
  4 do_nothing
  $ rtcon -p dataport.buffer.length=64 ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ wait rtinject
  ! rtinject: /robot/test.host_cxt/ConsoleOut0.rtc:in: it executes at 1 Hz; it has probably read about 10 of 12 values; the rest is in its buffer, or overwritten
  [5] after 2.3 s
  $ ctl buffer ConsoleOut0:in
  64 overwrite
  $ rtdis ConsoleOut0.rtc:in
  $ rtact ConsoleIn0.rtc

What a port refuses is counted; a buffer that the user has asked for is left alone:

  $ rtec Slow0.rtc rate 0.1
  $ rtec Slow0.rtc start
  $ rtinject -q -c 1 -n 20 -r 400 --linger 0 --property dataport.buffer.length=2 --property dataport.buffer.write.full_policy=do_nothing Slow0.rtc:in
  ! rtinject: /robot/test.host_cxt/Slow0.rtc:in: its buffer is full (BUFFER_FULL)
  ! rtinject: /robot/test.host_cxt/Slow0.rtc:in: it refused 18 of 20 values
  ! rtinject: /robot/test.host_cxt/Slow0.rtc:in: it executes at 0.1 Hz; it has read about 0 of 2 values; the rest is dropped
  [5] after 0.3 s
