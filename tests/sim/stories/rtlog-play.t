A component ends while a log is played to it: soon after it was connected, or later.

world: senders 10 8
world: these ConsoleOut

  $ rtlog -q -t 4 -f c.rtlog Source0.rtc:number.n
  [0] after 4.1 s
  $ restart these
  $ sleep 1
  $ rtact --wait ConsoleOut0.rtc
  $ later 1.5 kill these
  $ rtlog -p -f c.rtlog ConsoleOut0.rtc:in.n
  ! rtlog: /robot/test.host_cxt/ConsoleOut0.rtc:in: the component is gone, and its process too
  [4] after 1.6 s
  $ restart these
  $ sleep 1
  $ rtact --wait ConsoleOut0.rtc
  $ later 0.005 kill these
  $ rtlog -p -f c.rtlog ConsoleOut0.rtc:in.n
  ! rtlog: /robot/test.host_cxt/ConsoleOut0.rtc: connection refused; its process is gone (zombie)
  [4]
  $ restart these
  $ sleep 1
  $ rtact --wait ConsoleOut0.rtc
  $ later 0.01 kill these
  $ rtlog -p -f c.rtlog ConsoleOut0.rtc:in.n
  ! rtlog: /robot/test.host_cxt/ConsoleOut0.rtc:in: the component is gone, and its process too
  [4] after 0.2 s
  $ restart these
  $ sleep 1
  $ rtact --wait ConsoleOut0.rtc
  $ later 0.02 kill these
  $ rtlog -p -f c.rtlog ConsoleOut0.rtc:in.n
  ! rtlog: /robot/test.host_cxt/ConsoleOut0.rtc:in: the component is gone, and its process too
  [4] after 0.2 s
