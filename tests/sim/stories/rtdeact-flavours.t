rtdeact with components of C++ 1.1, 1.2 and 2.x, Python, Java, RtORB.

world: these ConsoleIn Slow --flavour cpp11 --context cpp11.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour cpp12 --context cpp12.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour cpp2 --context cpp2.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour py2 --context py2.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour java --context java.host_cxt/%n.rtc --rate 100
world: these ConsoleIn Slow --flavour rtorb --context rtorb.host_cxt/%n.rtc --rate 100

C++ 1.1: a quick one, and one that takes longer than the half second that its context waits; in Error, it cannot be deactivated:

  $ RTCSH_CWD=/robot/cpp11.host_cxt
  $ rtact --wait ConsoleIn0.rtc
  $ rtdeact -v ConsoleIn0.rtc
  ! rtdeact: /robot/cpp11.host_cxt/ConsoleIn0.rtc: accepted
  [0] after 0.1 s
  $ rtls -l ConsoleIn0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtact --wait Slow0.rtc
  [0] after 0.9 s
  $ rtdeact -v --wait Slow0.rtc
  ! rtdeact: /robot/cpp11.host_cxt/Slow0.rtc: Inactive
  [0] after 0.8 s
  $ rtls -l Slow0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
  $ ctl @these error ConsoleIn0
  $ rtdeact ConsoleIn0.rtc
  ! rtdeact: /robot/cpp11.host_cxt/ConsoleIn0.rtc: cannot deactivate: it is in Error; reset it first
  [6]

C++ 1.2: a quick one, and one that takes longer than the half second that its context waits; in Error, it cannot be deactivated:

  $ RTCSH_CWD=/robot/cpp12.host_cxt
  $ rtact --wait ConsoleIn0.rtc
  $ rtdeact -v ConsoleIn0.rtc
  ! rtdeact: /robot/cpp12.host_cxt/ConsoleIn0.rtc: accepted
  $ rtls -l ConsoleIn0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtact --wait Slow0.rtc
  [0] after 0.8 s
  $ rtdeact -v --wait Slow0.rtc
  ! rtdeact: /robot/cpp12.host_cxt/Slow0.rtc: Inactive
  [0] after 0.8 s
  $ rtls -l Slow0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
  $ ctl @these2 error ConsoleIn0
  $ rtdeact ConsoleIn0.rtc
  ! rtdeact: /robot/cpp12.host_cxt/ConsoleIn0.rtc: cannot deactivate: it is in Error; reset it first
  [6]

C++ 2: a quick one, and one that takes longer than the half second that its context waits; in Error, it cannot be deactivated:

  $ RTCSH_CWD=/robot/cpp2.host_cxt
  $ rtact --wait ConsoleIn0.rtc
  $ rtdeact -v ConsoleIn0.rtc
  ! rtdeact: /robot/cpp2.host_cxt/ConsoleIn0.rtc: accepted
  $ rtls -l ConsoleIn0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtact --wait Slow0.rtc
  [0] after 0.8 s
  $ rtdeact -v --wait Slow0.rtc
  ! rtdeact: /robot/cpp2.host_cxt/Slow0.rtc: Inactive
  [0] after 0.8 s
  $ rtls -l Slow0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
  $ ctl @these3 error ConsoleIn0
  $ rtdeact ConsoleIn0.rtc
  ! rtdeact: /robot/cpp2.host_cxt/ConsoleIn0.rtc: cannot deactivate: it is in Error; reset it first
  [6]

Python: a quick one, and one that takes longer than the half second that its context waits; in Error, it cannot be deactivated:

  $ RTCSH_CWD=/robot/py2.host_cxt
  $ rtact --wait ConsoleIn0.rtc
  $ rtdeact -v ConsoleIn0.rtc
  ! rtdeact: /robot/py2.host_cxt/ConsoleIn0.rtc: accepted
  $ rtls -l ConsoleIn0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtact --wait Slow0.rtc
  [0] after 0.8 s
  $ rtdeact -v --wait Slow0.rtc
  ! rtdeact: /robot/py2.host_cxt/Slow0.rtc: Inactive
  [0] after 0.8 s
  $ rtls -l Slow0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
  $ ctl @these4 error ConsoleIn0
  $ rtdeact ConsoleIn0.rtc
  ! rtdeact: /robot/py2.host_cxt/ConsoleIn0.rtc: cannot deactivate: it is in Error; reset it first
  [6]

Java: a quick one, and one that takes longer than the half second that its context waits; in Error, it cannot be deactivated:

  $ RTCSH_CWD=/robot/java.host_cxt
  $ rtact --wait ConsoleIn0.rtc
  $ rtdeact -v ConsoleIn0.rtc
  ! rtdeact: /robot/java.host_cxt/ConsoleIn0.rtc: accepted
  $ rtls -l ConsoleIn0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtact --wait Slow0.rtc
  [0] after 0.8 s
  $ rtdeact -v --wait Slow0.rtc
  ! rtdeact: /robot/java.host_cxt/Slow0.rtc: Inactive
  [0] after 0.8 s
  $ rtls -l Slow0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
  $ ctl @these5 error ConsoleIn0
  $ rtdeact ConsoleIn0.rtc
  ! rtdeact: /robot/java.host_cxt/ConsoleIn0.rtc: cannot deactivate: it is in Error; reset it first
  [6]

RtORB: a quick one, and one that takes longer than the half second that its context waits; in Error, it cannot be deactivated:

  $ RTCSH_CWD=/robot/rtorb.host_cxt
  $ rtact --wait ConsoleIn0.rtc
  $ rtdeact -v ConsoleIn0.rtc
  ! rtdeact: /robot/rtorb.host_cxt/ConsoleIn0.rtc: accepted
  $ rtls -l ConsoleIn0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  $ rtact --wait Slow0.rtc
  [0] after 0.8 s
  $ rtdeact -v --wait Slow0.rtc
  ! rtdeact: /robot/rtorb.host_cxt/Slow0.rtc: Inactive
  [0] after 0.8 s
  $ rtls -l Slow0.rtc
  Inactive  1/0  0/0  1/0  0/0  Slow0.rtc
  $ ctl @these6 error ConsoleIn0
  $ rtdeact ConsoleIn0.rtc
  ! rtdeact: /robot/rtorb.host_cxt/ConsoleIn0.rtc: cannot deactivate: it is in Error; reset it first
  [6]

C++ 1.1 answers only after ten periods, which may be longer than the timeout; --wait waits for the answer, too:

  $ RTCSH_CWD=/robot/cpp11.host_cxt
  $ rtreset ConsoleIn0.rtc
  $ rtec ConsoleIn0.rtc rate 8
  $ rtact --wait ConsoleIn0.rtc
  [0] after 0.3 s
  $ rtdeact -v --timeout 0.5 --wait=8 ConsoleIn0.rtc
  ! rtdeact: /robot/cpp11.host_cxt/ConsoleIn0.rtc: Inactive
  [0] after 1.3 s
