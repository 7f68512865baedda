rtvlog --listen receives the logs that OpenRTM 2 sends through Fluent Bit; nobody is asked for them.

world: observed

  $ listening() { soon 'grep -q "TCP port" told'; port=$(sed -n 's/.*TCP port //p' told); }

In every form of a message; a line is a line, and harms no terminal:

  $ rm -f told; rtvlog --listen 0 -n 5 > out 2> told & listening
  $ fluent $port message ERROR Motor0 hot
  $ fluent $port forward INFO Motor0 warm WARN manager "$(printf 'a\033[2J')"
  $ fluent $port packed INFO Arm0 wet
  $ fluent $port gzip INFO Arm0 cold; wait
  $ cat out
  [robot1/manager 1795247382.250000] ERROR <Motor0> hot
  [robot1/manager 1795247382.250000] INFO <Motor0> warm
  [robot1/manager 1795247382.250000] WARN <manager> a\x1b[2J
  [robot1/manager 1795247382.250000] INFO <Arm0> wet
  [robot1/manager 1795247382.250000] INFO <Arm0> cold

Of a level and a source; beside a component that is asked:

  $ rm told
  $ rtvlog --listen 0 -n 3 -l WARN -f Motor0 -f motor --json Motor0.rtc > out 2> told & listening
  $ soon "ctl observers Motor0 | grep Logger"
  $ fluent $port forward INFO Motor0 warm WARN Arm0 hot WARN Motor0 hot FATAL Motor0 broken
  $ soon 'grep broken out'
  $ ctl log Motor0 ERROR motor "it is hot"
  $ wait
  $ plain out
  {"level": "WARN", "logger": "Motor0", "message": "hot", "path": "robot1/manager", "time": T}
  {"level": "FATAL", "logger": "Motor0", "message": "broken", "path": "robot1/manager", "time": T}
  {"level": "ERROR", "logger": "motor", "message": "it is hot", "path": "/localhost:$PORT/test.host_cxt/Motor0.rtc", "time": T}

From some addresses only; what is no log is reported once, and the port goes on:

  $ rm told; rtvlog --listen 0.0.0.0:0 --from 127.0.0.2 -t 30 > out 2> told & log=$!
  $ listening
  $ fluent $port message ERROR Motor0 hot
  $ soon 'grep from told'
  $ kill $log; wait $log
  [143]
  $ cat out
  $ sed 1d told
  rtvlog: 127.0.0.1: may not send (--from)
  $ rm told; rtvlog --listen 0 -n 1 > out 2> told & listening
  $ printf 'GET / HTTP/1.1\r\n\r\n' > request
  $ for i in 1 2; do
  >     python3 -c "import socket, sys; socket.create_connection(('localhost', int(sys.argv[1]))).sendall(open('request', 'rb').read())" $port
  > done
  $ fluent $port message ERROR Motor0 hot
  $ wait
  $ cat out
  [robot1/manager 1795247382.250000] ERROR <Motor0> hot
  $ sed 1d told
  rtvlog: 127.0.0.1: does not send logs as fluentd takes them (not an event)

Only this host can send, unless an address is given:

  $ rm told; rtvlog --listen 0 -n 1 > out 2> told & listening
  > listens $port
  > fluent $port message ERROR Motor0 hot
  > wait
  0100007F
  $ rm told; rtvlog --listen 0.0.0.0:0 -n 1 > out 2> told & listening
  > python3 -c "import socket, sys; socket.create_connection(('127.0.0.3', int(sys.argv[1]))).close()" $port
  > fluent $port message ERROR Motor0 hot
  > wait
  > cut -d, -f1 told
  rtvlog: receiving logs at 0.0.0.0

A gzip bomb (10 MB of values in 10 kB) ends its connection, not the command:

  $ rm told; rtvlog --listen 0 -n 1 > out 2> told & listening
  $ cat > bomb.py <<.
  > import gzip, socket, sys
  > body = gzip.compress(b"\x92\1\xdd\0\x70\0\0" + b"\x80" * 0x700000)
  > octets = b"\x93\xa1t\xc6" + len(body).to_bytes(4, "big") + body + b"\x81\xaacompressed\xa4gzip"
  > socket.create_connection(("127.0.0.1", int(sys.argv[1]))).sendall(octets)
  > .
  $ python3 bomb.py $port
  $ soon 'grep values told'
  $ fluent $port message ERROR Motor0 hot
  $ wait
  $ cat out
  [robot1/manager 1795247382.250000] ERROR <Motor0> hot
  $ sed 1d told
  rtvlog: 127.0.0.1: does not send logs as fluentd takes them (more than 1000 values)

rtlog records them beside the events:

  $ rm told; rtlog --events --listen 0 -f a.mcap . 2> told & log=$!
  $ listening
  $ fluent $port message ERROR Motor0 hot
  $ soon 'rtlog --json -q -f a.mcap | grep robot1'
  $ kill $log; wait $log
  [143]
  $ rtlog --json -f a.mcap | grep robot1 | sed 's/.*"port": "\([^"]*\)".*"value": /\1 /'
  /logs {"level": "ERROR", "logger": "Motor0", "mark": "robot1/manager: hot", "message": "hot", "path": "robot1/manager", "time": 1795247382.25}}

Ctrl-C, a port that is taken, wrong usage:

  $ interrupt 1 rtvlog --listen 0
  rtvlog: receiving logs at 127.0.0.1, TCP port * (glob)
  [130]
  $ rtvlog -t 0.2 --listen $PORT
  rtvlog: --listen: TCP port $PORT of 127.0.0.1 is in use or needs a privilege, or this host has no such address
  [1]
  $ rtvlog -q -t 0.2 -n 1 --listen 0
  rtvlog: --listen: 0 of 1 within 0.2s
  [1]
  $ rtvlog
  rtvlog: nothing to show: no component specified; --listen receives what is sent (see --help)
  [2]
  $ rtvlog --from 127.0.0.1 Motor0.rtc
  rtvlog: --from is for --listen (see --help)
  [2]
  $ rtvlog --listen 0 --from robot1
  rtvlog: argument --from: not an IP address: robot1 (see --help)
  [2]
  $ rtvlog --listen=99999
  rtvlog: argument --listen: not [HOST:]PORT: 99999 (see --help)
  [2]
  $ rtvlog --listen 0 --from 10.0.0.1
  rtvlog: --from 10.0.0.1: only this host reaches 127.0.0.1; listen at an address of this host, or at all: --listen 0.0.0.0:0 (see --help)
  [2]
  $ rtlog --listen 0 -f a.mcap .
  rtlog: --listen needs --events (see --help)
  [2]
