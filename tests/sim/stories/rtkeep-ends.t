rtkeep leaves a system as it is when it is ended. A person's work is left alone.

world: these ConsoleIn ConsoleOut Motor --flavour cpp2 --rate 100
world: sources 1 100 8

  $ rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo --all -o a.xml /robot

SIGTERM, and Ctrl-C, change nothing:

  $ rtkeep a.xml &
  $ sleep 5
  $ rtkeep status
  a.xml: pid 6, since 2027-01-15 08:00:00; all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Active  2027-01-15 08:00:00    Active
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active  2027-01-15 08:00:00    Active
    /robot/test.host_cxt/Motor0.rtc       Active  Active  2027-01-15 08:00:00    Active
    /robot/test.host_cxt/Source0.rtc      Active  Active  2027-01-15 08:00:00
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:00:00] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:00] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:00] /robot/test.host_cxt/Motor0.rtc: Active
  [0] after 5.0 s
  $ rtcheck a.xml
  $ rtkeep a.xml &
  $ sleep 5
  $ strike INT rtkeep
  $ wait rtkeep
  [0] after 5.0 s
  $ rtcheck a.xml
  $ rtkeep status
  ! rtkeep: no rtkeep runs
  [1]

With --stop-at-end, and at `rtkeep stop`, all components are deactivated, as by rtstop; not with --leave.

  $ rtkeep --stop-at-end a.xml &
  $ sleep 5
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:00:15] /robot/test.host_cxt/Source0.rtc: Inactive
  [08:00:15] /robot/test.host_cxt/ConsoleIn0.rtc: Inactive
  [08:00:15] /robot/test.host_cxt/ConsoleOut0.rtc: Inactive
  [08:00:15] /robot/test.host_cxt/Motor0.rtc: Inactive
  [0] after 5.0 s
  $ rtls -l
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
  Inactive  2/0  0/0  2/0  0/0  Source0.rtc
  $ rtkeep a.xml &
  $ sleep 5
  $ rtkeep stop
  $ wait rtkeep
  [08:00:15] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:15] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:15] /robot/test.host_cxt/Motor0.rtc: Active
  [08:00:15] /robot/test.host_cxt/Source0.rtc: Active
  [08:00:20] /robot/test.host_cxt/Source0.rtc: Inactive
  [08:00:20] /robot/test.host_cxt/ConsoleIn0.rtc: Inactive
  [08:00:20] /robot/test.host_cxt/ConsoleOut0.rtc: Inactive
  [08:00:20] /robot/test.host_cxt/Motor0.rtc: Inactive
  [0] after 5.0 s
  $ rtls -l
  Inactive  1/1  0/0  1/1  0/0  ConsoleIn0.rtc
  Inactive  1/1  1/1  0/0  0/0  ConsoleOut0.rtc
  Inactive  2/0  1/0  1/0  0/0  Motor0.rtc
  Inactive  2/0  0/0  2/0  0/0  Source0.rtc
  $ rtkeep --leave --stop-at-end a.xml
  ! rtkeep: --leave is not for --stop-at-end, nor for --teardown (see --help)
  [2]

Without a terminal SIGHUP means `reload`: even twice, that is no restart, and what is there stays there meanwhile.

  $ rtkeep a.xml &
  $ sleep 5
  $ strike HUP rtkeep
  $ strike HUP rtkeep
  $ rtkeep reload
  $ rtkeep reload
  $ rtkeep status
  a.xml: pid 18, since 2027-01-15 08:00:20; not all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active  Active  2027-01-15 08:00:20    Active
    /robot/test.host_cxt/ConsoleOut0.rtc  Active  Active  2027-01-15 08:00:20    Active
    /robot/test.host_cxt/Motor0.rtc       Active  Active  2027-01-15 08:00:20    Active
    /robot/test.host_cxt/Source0.rtc      Active  Active  2027-01-15 08:00:20    Active
  $ sleep 5
  $ rtkeep status --json
  {"kind": "rtkeep", "object": "a.xml", "pid": 18, "settled": true, "since": 20.1}
  {"by_hand": [], "given_up": false, "kind": "component", "last": "Active", "object": "/robot/test.host_cxt/ConsoleIn0.rtc", "restarts": 0, "since": 20.3, "state": "Active", "wanted": "Active"}
  {"by_hand": [], "given_up": false, "kind": "component", "last": "Active", "object": "/robot/test.host_cxt/ConsoleOut0.rtc", "restarts": 0, "since": 20.3, "state": "Active", "wanted": "Active"}
  {"by_hand": [], "given_up": false, "kind": "component", "last": "Active", "object": "/robot/test.host_cxt/Motor0.rtc", "restarts": 0, "since": 20.3, "state": "Active", "wanted": "Active"}
  {"by_hand": [], "given_up": false, "kind": "component", "last": "Active", "object": "/robot/test.host_cxt/Source0.rtc", "restarts": 0, "since": 20.3, "state": "Active", "wanted": "Active"}
  $ show rtkeep
  [08:00:20] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:00:20] /robot/test.host_cxt/ConsoleOut0.rtc: Active
  [08:00:20] /robot/test.host_cxt/Motor0.rtc: Active
  [08:00:20] /robot/test.host_cxt/Source0.rtc: Active

What was made Inactive by hand stays Inactive after an Error, also while the file is read again; it is reset only.

  $ rtdeact Motor0.rtc
  $ sleep 5
  $ show rtkeep
  [08:00:33] /robot/test.host_cxt/Motor0.rtc: was made Inactive by hand: left alone
  $ ctl error Motor0
  $ sleep 5
  $ show rtkeep
  [08:00:37] /robot/test.host_cxt/Motor0.rtc: in Error: reset
  $ rtkeep reload
  $ sleep 5
  $ ctl error Motor0
  $ sleep 10
  $ ctl state Motor0
  INACTIVE
  $ show rtkeep
  [08:00:48] /robot/test.host_cxt/Motor0.rtc: in Error: reset
  $ rtkeep status --json
  {"kind": "rtkeep", "object": "a.xml", "pid": 18, "settled": true, "since": 20.1}
  {"by_hand": [], "given_up": false, "kind": "component", "last": "Active", "object": "/robot/test.host_cxt/ConsoleIn0.rtc", "restarts": 0, "since": 20.3, "state": "Active", "wanted": "Active"}
  {"by_hand": [], "given_up": false, "kind": "component", "last": "Active", "object": "/robot/test.host_cxt/ConsoleOut0.rtc", "restarts": 0, "since": 20.3, "state": "Active", "wanted": "Active"}
  {"by_hand": ["was made Inactive by hand"], "given_up": false, "kind": "component", "last": "in Error: reset", "object": "/robot/test.host_cxt/Motor0.rtc", "restarts": 0, "since": 48.5, "state": "Inactive", "wanted": "Active"}
  {"by_hand": [], "given_up": false, "kind": "component", "last": "Active", "object": "/robot/test.host_cxt/Source0.rtc", "restarts": 0, "since": 20.3, "state": "Active", "wanted": "Active"}

A person activates it again:

  $ rtact --wait Motor0.rtc
  $ sleep 20
  $ show rtkeep
  [08:00:56] /robot/test.host_cxt/Motor0.rtc: is Active again
  $ ctl error Motor0
  $ sleep 20
  $ rtcheck a.xml
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:01:16] /robot/test.host_cxt/Motor0.rtc: in Error: reset
  [08:01:16] /robot/test.host_cxt/Motor0.rtc: Active
  [0] after 75.1 s
