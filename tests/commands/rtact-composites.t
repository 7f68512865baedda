rtact, rtdeact and rtreset of composites, which take their members along; how long that takes depends on the version.

world: composite --flavour cpp11 --context cpp11.host_cxt/%n.rtc --rate 100
world: composite --flavour cpp12 --context cpp12.host_cxt/%n.rtc --rate 100
world: composite --flavour cpp2 --context cpp2.host_cxt/%n.rtc --rate 100
world: composite --flavour py2 --context py2.host_cxt/%n.rtc --rate 100

  $ at() { export RTCSH_CWD=/localhost:$PORT/$1.host_cxt; }
  $ states() { rtls -l | awk '{print $1, $6}'; }

  $ all() { soon "[ \$(rtls -l | grep -c ^$1) = 4 ]"; states; }

C++ 2.x and Python say RTC_OK before it is done; --wait waits for it. The states of all components follow:

  $ at cpp2
  $ rtact -v --wait composite0.rtc
  rtact: /localhost:$PORT/cpp2.host_cxt/composite0.rtc: Active
  $ all Active
  Active Controller0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  Active composite0.rtc
  $ rtdeact -v --wait composite0.rtc
  rtdeact: /localhost:$PORT/cpp2.host_cxt/composite0.rtc: Inactive
  $ all Inactive
  Inactive Controller0.rtc
  Inactive Motor0.rtc
  Inactive Sensor0.rtc
  Inactive composite0.rtc
  $ at py2
  $ rtact -v --wait composite0.rtc; all Active
  rtact: /localhost:$PORT/py2.host_cxt/composite0.rtc: Active
  Active Controller0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  Active composite0.rtc
  $ rtdeact -v --wait composite0.rtc; all Inactive
  rtdeact: /localhost:$PORT/py2.host_cxt/composite0.rtc: Inactive
  Inactive Controller0.rtc
  Inactive Motor0.rtc
  Inactive Sensor0.rtc
  Inactive composite0.rtc

C++ 1.2 says RTC_ERROR after half a second, and is active soon after: no failure

  $ at cpp12
  $ within 0.5-8 rtact -v composite0.rtc
  rtact: /localhost:$PORT/cpp12.host_cxt/composite0.rtc: Active
  $ all Active
  Active Controller0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  Active composite0.rtc
  $ within 0.5-8 rtdeact -v --wait composite0.rtc
  rtdeact: /localhost:$PORT/cpp12.host_cxt/composite0.rtc: Inactive
  $ all Inactive
  Inactive Controller0.rtc
  Inactive Motor0.rtc
  Inactive Sensor0.rtc
  Inactive composite0.rtc

C++ 1.1 says RTC_OK at once when it is to become active. To become inactive, it waits for its members in vain, which would
go on for minutes; so they are deactivated before it:

  $ at cpp11
  $ rtact -v --wait composite0.rtc; all Active
  rtact: /localhost:$PORT/cpp11.host_cxt/composite0.rtc: Active
  Active Controller0.rtc
  Active Motor0.rtc
  Active Sensor0.rtc
  Active composite0.rtc
  $ within 0-8 rtdeact -v --wait composite0.rtc; all Inactive
  rtdeact: /localhost:$PORT/cpp11.host_cxt/composite0.rtc: Inactive
  Inactive Controller0.rtc
  Inactive Motor0.rtc
  Inactive Sensor0.rtc
  Inactive composite0.rtc
  $ rtact --wait composite0.rtc
  $ rtdeact -v -e 1 Sensor0.rtc; states
  rtdeact: /localhost:$PORT/cpp11.host_cxt/Sensor0.rtc: accepted
  Active Controller0.rtc
  Active Motor0.rtc
  Inactive Sensor0.rtc
  Active composite0.rtc

A member alone: its own context is stopped, so that the composite's is meant, with -e or without

  $ at cpp2
  $ rtact -v -e 1 --wait Motor0.rtc
  rtact: /localhost:$PORT/cpp2.host_cxt/Motor0.rtc: Active
  $ states
  Inactive Controller0.rtc
  Active Motor0.rtc
  Inactive Sensor0.rtc
  Inactive composite0.rtc
  $ rtdeact -v -e 1 --wait Motor0.rtc
  rtdeact: /localhost:$PORT/cpp2.host_cxt/Motor0.rtc: Inactive
  $ rtact -v Motor0.rtc
  rtact: /localhost:$PORT/cpp2.host_cxt/Motor0.rtc: accepted in the context of composite0

A composite in Error is reset as all components are:

  $ ctl @composite3 error composite0
  $ rtact composite0.rtc
  rtact: /localhost:$PORT/cpp2.host_cxt/composite0.rtc: cannot activate: it is in Error; reset it first
  [6]
  $ rtreset -v --wait composite0.rtc; states
  rtreset: /localhost:$PORT/cpp2.host_cxt/composite0.rtc: Inactive
  Inactive Controller0.rtc
  Active Motor0.rtc
  Inactive Sensor0.rtc
  Inactive composite0.rtc
