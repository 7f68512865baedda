rttop without a terminal, or with -n, prints pages. The live page is tried in tests/commands/test_rttop.py.

world: robot
world: error --context err.host_cxt/%n.rtc
world: senders 50 100 --context src.host_cxt/%n.rtc
world: zombie 1 --context gone.host_cxt/%n.rtc
server: empty

  $ top() { rttop -n 1 "$@"; }

One page; by default, of all name servers. What is dead has its line, and spoils no status:

  $ top
  STATE         RATE  CONN  COMPONENT
  Error         1000     0  Broken0.rtc
  Inactive      1000     1  Clusterer0.rtc
  Inactive      1000     2  Controller0.rtc
  Inactive      1000     0  Err0.rtc
  Inactive      1000     0  ErrStart0.rtc
  Inactive      1000     1  Hokuyo_AIST0.rtc
  -                -     -  *Mock0.rtc: connection refused; its process is gone (zombie)
  Inactive      1000     2  Motor0.rtc
  Inactive      1000     2  Sensor0.rtc
  Active          50     0  Source0.rtc
  $ RTCTREE_NAMESERVERS="localhost:$PORT2;localhost:$PORT" top -f robot
  $ rtact --wait 20 Motor0.rtc
  $ rtec Sensor0.rtc stop
  $ top .
  STATE         RATE  CONN  COMPONENT
  Inactive      1000     1  Clusterer0.rtc
  Inactive      1000     2  Controller0.rtc
  Inactive      1000     1  Hokuyo_AIST0.rtc
  Active        1000     2  Motor0.rtc
  Inactive   stopped     2  Sensor0.rtc
  $ top Motor0.rtc ../err.host_cxt
  STATE         RATE  CONN  COMPONENT
  Error         1000     0  Broken0.rtc
  Inactive      1000     0  Err0.rtc
  Inactive      1000     0  ErrStart0.rtc
  Active        1000     2  Motor0.rtc
  $ top localhost:$PORT2

In another order, and only some: words of paths, or states, in capitals or not:

  $ top -s state | cut -c1-8 | uniq -c
        1 STATE\x20\x20\x20 (esc)
        1 Error\x20\x20\x20 (esc)
        1 -\x20\x20\x20\x20\x20\x20\x20 (esc)
        2 Active\x20\x20 (esc)
        6 Inactive
  $ top -s rate -f inactive .
  STATE         RATE  CONN  COMPONENT
  Inactive      1000     1  Clusterer0.rtc
  Inactive      1000     2  Controller0.rtc
  Inactive      1000     1  Hokuyo_AIST0.rtc
  Inactive   stopped     2  Sensor0.rtc
  $ top -s connections -f test.host
  STATE         RATE  CONN  COMPONENT
  Inactive      1000     2  Controller0.rtc
  Active        1000     2  Motor0.rtc
  Inactive   stopped     2  Sensor0.rtc
  Inactive      1000     1  Clusterer0.rtc
  Inactive      1000     1  Hokuyo_AIST0.rtc
  $ top -f 'err BROKEN'
  STATE         RATE  CONN  COMPONENT
  Error         1000     0  Broken0.rtc
  $ top -f nobody

Two components of one name: all have their paths, so that they can be compared:

  $ mock these Motor --context b.host_cxt/%n.rtc
  $ top -f tor0
  STATE         RATE  CONN  COMPONENT
  Inactive      1000     0  /localhost:$PORT/b.host_cxt/Motor0.rtc
  Active        1000     2  /localhost:$PORT/test.host_cxt/Motor0.rtc
  $ NO_COLOR=1 terminal 80 rttop -n 1 -f tor0 && end-mock these
  STATE         RATE  CONN  COMPONENT  below /localhost:$PORT/
  Inactive      1000     0  b.host_cxt/Motor0.rtc
  Active        1000     2  test.host_cxt/Motor0.rtc

The flow of ports, over a second, by a connection that is gone at the end (how much it is: tests/sim/stories/rttop-asks.t):

  $ top -p ../src.host_cxt/Source0.rtc:number -p ../src.host_cxt/Source0.rtc:block -f source
  STATE         RATE  CONN  COMPONENT
  Active          50     2  Source0.rtc
   *\d+\.\d Hz  *[\d.]+ k?B/s  /localhost:\$PORT/src.host_cxt/Source0.rtc:number (re)
   *\d+\.\d Hz  *[\d.]+ k?B/s  /localhost:\$PORT/src.host_cxt/Source0.rtc:block (re)
  $ ctl @senders connectors Source0:number
  $ top -p Sensor0.rtc:out Sensor0.rtc
  STATE         RATE  CONN  COMPONENT
  Inactive   stopped     3  Sensor0.rtc
       0.0 Hz        0 B/s  /localhost:$PORT/test.host_cxt/Sensor0.rtc:out

JSON:

  $ top --json -p ../src.host_cxt/Source0.rtc:number -f motor
  {"connections": 2, "kind": "component", "name": "Motor0.rtc", "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "ports": 2, "rate": 1000.0, "running": true, "state": "Active", "time": *} (glob)
  {"bytes_per_second": *, "kind": "port", "path": "/localhost:$PORT/src.host_cxt/Source0.rtc:number", "time": *, "values_per_second": *} (glob)
  $ top --json ../gone.host_cxt
  {"connections": null, "error": "/localhost:$PORT/gone.host_cxt/Mock0.rtc: connection refused; its process is gone (zombie)", "kind": "zombie", "name": "Mock0.rtc", "path": "/localhost:$PORT/gone.host_cxt/Mock0.rtc", "ports": null, "rate": null, "running": null, "state": "-", "time": *} (glob)

Pages follow one another, -r times a second, or without end:

  $ within 0.5-6 rttop -n 3 -r 4 Motor0.rtc
  STATE         RATE  CONN  COMPONENT
  Active        1000     2  Motor0.rtc

  STATE         RATE  CONN  COMPONENT
  Active        1000     2  Motor0.rtc

  STATE         RATE  CONN  COMPONENT
  Active        1000     2  Motor0.rtc
  $ rttop -r 5 Motor0.rtc | head -4
  STATE         RATE  CONN  COMPONENT
  Active        1000     2  Motor0.rtc

  STATE         RATE  CONN  COMPONENT
  $ interrupt 1.5 rttop --json Motor0.rtc > out
  [130]
  $ rttop -p ../src.host_cxt/Source0.rtc:number Motor0.rtc > out & pid=$!
  $ soon "grep -q '[1-9] Hz' out"
  $ kill $pid; wait $pid
  [143]
  $ tail -1 out; ctl @senders connectors Source0:number
   *\d+\.\d Hz  *[\d.]+ k?B/s  /localhost:\$PORT/src.host_cxt/Source0.rtc:number (re)

Where a terminal knows no pages, they are printed:

  $ page() { terminal 80 interrupt 4 rttop Motor0.rtc | uniq | head -3; }
  $ mkdir lib; echo 'raise ImportError("no")' > lib/curses.py
  $ (export TERM=dumb; page) > dumb & (export TERM=nonsense; page) > nonsense &
  >     (export PYTHONPATH=lib:$PYTHONPATH; page) > without &
  $ wait
  $ cat dumb
  rttop: the terminal dumb has no pages: pages are printed one below the other
  STATE         RATE  CONN  COMPONENT
  Active        1000     2  Motor0.rtc
  $ head -1 nonsense
  rttop: the terminal nonsense is not known here: pages are printed one below the other
  $ head -1 without
  rttop: this Python has no curses: pages are printed one below the other

What cannot be shown is reported; the rest is shown all the same:

  $ top nobody.rtc
  rttop: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  [3]
  $ top nobody.rtc Motor0.rtc -p Motor0.rtc:nothing -p Motor0.rtc:in -p nobody.rtc:out
  rttop: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  rttop: /localhost:$PORT/test.host_cxt/Motor0.rtc: no such port: nothing (its ports: in, out)
  rttop: /localhost:$PORT/test.host_cxt/Motor0.rtc:in: not a DataOutPort (it is a DataInPort)
  STATE         RATE  CONN  COMPONENT
  Active        1000     2  Motor0.rtc
  [5]
  $ top localhost:1
  rttop: /localhost:1: connection refused; is the name server running?
  [4]
  $ top localhost:1 Motor0.rtc
  rttop: /localhost:1: connection refused; is the name server running?
  STATE         RATE  CONN  COMPONENT
  Active        1000     2  Motor0.rtc
  [5]
  $ top --json nobody.rtc
  rttop: /localhost:$PORT/test.host_cxt/nobody.rtc: no such path
  [3]

It asks one component after the other, and each for little (how often, the story says):

  $ ctl reset
  $ rttop -n 2 . > out
  $ ctl calls Controller0 | sed 's/^[0-9]* //'
  get_component_state
  get_owned_contexts
  get_participating_contexts
  get_port_profile
  get_ports
  get_rate
  is_running
  $ ctl highwater
  1
  $ rttop -n 1 > /dev/full
  rttop: No space left on device
  [1]

A page for browsers is tried in tests/commands/test_rttop_serve.py. Without one it shows an address, and ends as pages do:

  $ interrupt 1.5 rttop --serve 127.0.0.1:0
  http://127.0.0.1:\d+/ (re)
  [130]

Wrong usage is found before anything is asked:

  $ ctl reset
  $ rttop Motor0.rtc:in
  rttop: Motor0.rtc:in: name its component, not a port (see --help)
  [2]
  $ rttop -p Motor0.rtc
  rttop: /localhost:$PORT/test.host_cxt/Motor0.rtc: no port specified (see --help)
  [2]
  $ rttop -s size
  rttop: argument -s/--sort: not one of name, state, rate, connections, trouble: size (see --help)
  [2]
  $ rttop -r 6
  rttop: -r 6: at most 5 (see --help)
  [2]
  $ rttop -r 0
  rttop: argument -r/--rate: not a number of Hz above 0: 0 (see --help)
  [2]
  $ rttop --serve 127.0.0.1:0 -n 1
  rttop: --serve does not go with -p, -s, -f, -n or --json (see --help)
  [2]
  $ rttop --serve 127.0.0.1:70000
  rttop: argument --serve: not [HOST:]PORT: 127.0.0.1:70000 (see --help)
  [2]
  $ rttop --serve=nonsense; rttop --serve=localhost:x
  rttop: argument --serve: not [HOST:]PORT: nonsense (see --help)
  rttop: argument --serve: not [HOST:]PORT: localhost:x (see --help)
  [2]
  $ rttop -n many
  rttop: argument -n/--number: not a whole number: 'many' (see --help)
  [2]
  $ ctl calls

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -n 1 A
lasting: A
broken component: 0 5
examples: endless
examples: asking
