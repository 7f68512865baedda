Components that listen with TLS, with UNIX sockets or with anything else but TCP live, though nobody can ask them from here.

world: secured
world: zombie 1 --context dead.host_cxt/%n.rtc
both: each ORB reads answers in its own way

  $ rtls; rtls -v -l
  Alternate0.rtc
  ~Other0.rtc
  ~Tls0.rtc
  ~Unix0.rtc
  rtls: 3 of 4 cannot be asked from here (Other0.rtc, Tls0.rtc, Unix0.rtc)
  Inactive  2/0  1/0  1/0  0/0  Alternate0.rtc
  -         -    -    -    -    ~Other0.rtc
  -         -    -    -    -    ~Tls0.rtc
  -         -    -    -    -    ~Unix0.rtc
  rtls: /localhost:$PORT/test.host_cxt/Other0.rtc: listens with another transport only, which is not spoken here
  rtls: /localhost:$PORT/test.host_cxt/Tls0.rtc: listens with TLS only, which is not spoken here
  rtls: /localhost:$PORT/test.host_cxt/Unix0.rtc: listens with UNIX sockets only, which is not spoken here
  rtls: 3 of 4 cannot be asked from here (Other0.rtc, Tls0.rtc, Unix0.rtc)
  [5]
  $ rtls --json Tls0.rtc
  {"error": "/localhost:$PORT/test.host_cxt/Tls0.rtc: listens with TLS only, which is not spoken here", "kind": "unasked", "name": "Tls0.rtc", "path": "/localhost:$PORT/test.host_cxt/Tls0.rtc"}
  rtls: 1 of 1 cannot be asked from here (Tls0.rtc)
  [4]
  $ rtcat Tls0.rtc Unix0.rtc Other0.rtc
  rtcat: /localhost:$PORT/test.host_cxt/Tls0.rtc: listens with TLS only, which is not spoken here
  rtcat: /localhost:$PORT/test.host_cxt/Unix0.rtc: listens with UNIX sockets only, which is not spoken here
  rtcat: /localhost:$PORT/test.host_cxt/Other0.rtc: listens with another transport only, which is not spoken here
  [4]
  $ rtact Tls0.rtc
  rtact: /localhost:$PORT/test.host_cxt/Tls0.rtc: listens with TLS only, which is not spoken here
  [4]
  $ rtdoctor -q . | grep rtc
  warn  /localhost:$PORT/test.host_cxt/Other0.rtc: listens with another transport only, which is not spoken here; try: to look at it from here, have its process listen with TCP, too: corba.endpoints in rtc.conf
  warn  /localhost:$PORT/test.host_cxt/Tls0.rtc: listens with TLS only, which is not spoken here; try: to look at it from here, have its process listen with TCP, too: corba.endpoints in rtc.conf
  warn  /localhost:$PORT/test.host_cxt/Unix0.rtc: listens with UNIX sockets only, which is not spoken here; try: to look at it from here, have its process listen with TCP, too: corba.endpoints in rtc.conf
  warn  /: all components examined are Inactive: none has been started; try: rtact /localhost:$PORT/test.host_cxt/Alternate0.rtc
  $ rtdel -z
  $ rtls
  Alternate0.rtc
  ~Other0.rtc
  ~Tls0.rtc
  ~Unix0.rtc
  rtls: 3 of 4 cannot be asked from here (Other0.rtc, Tls0.rtc, Unix0.rtc)
  [5]
  $ rtls ../dead.host_cxt
  $ rtdel -zf Tls0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/Tls0.rtc: listens with TLS only, which is not spoken here
  [4]
  $ rtdel -z Unix0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/Unix0.rtc: listens with UNIX sockets only, which is not spoken here
  [4]
  $ rtls | wc -l
  rtls: 3 of 4 cannot be asked from here (Other0.rtc, Tls0.rtc, Unix0.rtc)
  4
  $ rtcryo
  rtcryo: /localhost:$PORT/test.host_cxt/Other0.rtc: listens with another transport only, which is not spoken here
  rtcryo: /localhost:$PORT/test.host_cxt/Tls0.rtc: listens with TLS only, which is not spoken here
  rtcryo: /localhost:$PORT/test.host_cxt/Unix0.rtc: listens with UNIX sockets only, which is not spoken here
  [4]
  $ rtfind . -t z
  $ rtfind . -t c 2>/dev/null
  /localhost:$PORT/test.host_cxt/Alternate0.rtc
  /localhost:$PORT/test.host_cxt/Other0.rtc
  /localhost:$PORT/test.host_cxt/Tls0.rtc
  /localhost:$PORT/test.host_cxt/Unix0.rtc
  [5]
