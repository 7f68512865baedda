rtdoctor looks first at what is here: programs, settings of omniORB, names of this host, our environment.

  $ mkdir fake
  $ cat > fake/sitecustomize.py <<'END'
  > """A host that is called robot1, and names that mean what HOSTS says; robot1's own address is 198.51.100.1."""
  > import os, time
  > from rtshell_lite.doctor import servers
  > from rtshell_lite.net import real
  > servers.SLOW = 60.0  # seconds: how busy this machine is, is nobody's business here
  > hosts = dict(word.split("=") for word in os.environ["HOSTS"].split())
  > resolve, stream, is_own, bind = real.resolve, real.stream, real.is_own, real.bind
  > def named(host, *rest, **more):
  >     if isinstance(host, bytes):
  >         host = host.decode()
  >     address = hosts.get(host, host)
  >     if address == "slow":
  >         time.sleep(60)
  >     if address == "unknown":
  >         raise real.NoSuchHost(-2, "Name or service not known")
  >     return resolve(address, *rest, **more)
  > def here(family, protocol=0):
  >     class Socket(type(stream(family, protocol))):
  >         def connect_ex(self, address):
  >             return super().connect_ex(("127.0.0.1", address[1]))
  >     return Socket(family, 1, protocol)
  > real.host_name = lambda: "robot1"
  > real.is_own = lambda address: address == "198.51.100.1" or is_own(address)
  > real.bind = lambda host, port: host == hosts.get("robot1") or bind(host, port)
  > real.resolve, real.stream = named, here
  > END
  $ doctor() { PYTHONPATH=$TMP/fake${PYTHONPATH:+:$PYTHONPATH} rtdoctor "$@"; }
  $ touch none.cfg; export HOSTS="robot1=198.51.100.1 localhost=127.0.0.1" OMNIORB_CONFIG=$TMP/none.cfg

All is well:

  $ doctor
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  ok    here: Python [0-9.]*, (omniORBpy .*|builtin ORB) (re)
  ok    here: this host's name, robot1, means 198.51.100.1
  ok    here: RTCTREE_NAMESERVERS: localhost:$PORT
  ok    /localhost:$PORT: answers (name * ms, TCP * ms, CORBA * ms, naming * ms) (glob)
  0 failed, 1 to be looked at, 4 ok
  $ doctor -q
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted

The name of this host, which components may publish:

  $ HOSTS="robot1=127.0.1.1" doctor -q
  warn  here: this host's name, robot1, means 127.0.1.1: components that publish it cannot be reached from elsewhere; try: give it its real address in /etc/hosts
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  $ HOSTS="robot1=198.51.100.2" doctor -q
  warn  here: this host's name, robot1, means 198.51.100.2, which is not this host; try: give it its real address in /etc/hosts
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  $ HOSTS="robot1=unknown" doctor -q
  warn  here: this host's name, robot1, is not known here (Name or service not known); try: give it its real address in /etc/hosts
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  $ HOSTS="robot1=slow" doctor -q --timeout 4
  warn  here: this host's name, robot1, is not known here (no answer within 4s); try: give it its real address in /etc/hosts
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  $ HOSTS="robot1=198.51.100.1 localhost=unknown" doctor -q
  fail  here: localhost is not known here (Name or service not known); try: write into /etc/hosts: 127.0.0.1 localhost
  fail  /localhost:$PORT: host name localhost not known here (Name or service not known); try: correct the name, or write its address into /etc/hosts
  [1]
  $ HOSTS="robot1=198.51.100.1 localhost=198.51.100.1" doctor -q
  fail  here: localhost means 198.51.100.1; try: write into /etc/hosts: 127.0.0.1 localhost
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  [1]

RTCTREE_NAMESERVERS, each address on its own; the good ones are examined all the same:

  $ RTCTREE_NAMESERVERS="robot1,robot2" doctor -q
  fail  here: RTCTREE_NAMESERVERS: robot1,robot2: several are separated by semicolons; try: write HOST[:PORT], several separated by semicolons: RTCTREE_NAMESERVERS='robot1;robot2:2810'
  [1]
  $ RTCTREE_NAMESERVERS="localhost:$PORT;localhost:99999;corbaloc::robot1;/robot1/a.host_cxt;a b;:2809" \
  >     doctor -q
  fail  here: RTCTREE_NAMESERVERS: localhost:*: not HOST[:PORT]; try: write HOST[:PORT], several separated by semicolons: RTCTREE_NAMESERVERS='robot1;robot2:2810' (glob)
  fail  here: RTCTREE_NAMESERVERS: corbaloc::robot1: only HOST[:PORT], without corbaloc:; try: write HOST[:PORT], several separated by semicolons: RTCTREE_NAMESERVERS='robot1;robot2:2810'
  fail  here: RTCTREE_NAMESERVERS: /robot1/a.host_cxt: only HOST[:PORT], nothing after it; try: write HOST[:PORT], several separated by semicolons: RTCTREE_NAMESERVERS='robot1;robot2:2810'
  fail  here: RTCTREE_NAMESERVERS: a b: several are separated by semicolons; try: write HOST[:PORT], several separated by semicolons: RTCTREE_NAMESERVERS='robot1;robot2:2810'
  fail  here: RTCTREE_NAMESERVERS: :2809: not HOST[:PORT]; try: write HOST[:PORT], several separated by semicolons: RTCTREE_NAMESERVERS='robot1;robot2:2810'
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  [1]
  $ RTCTREE_NAMESERVERS= doctor | grep RTCTREE
  ok    here: RTCTREE_NAMESERVERS is not set: localhost is the name server
  $ RTCTREE_NAMESERVERS="; ;localhost:$PORT;" doctor | grep RTCTREE
  ok    here: RTCTREE_NAMESERVERS: localhost:$PORT
  $ RTCTREE_NAMESERVERS="localhost:$PORT;127.0.0.1:$PORT" doctor -q
  warn  /127.0.0.1:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  warn  /localhost:$PORT: the same name server as /127.0.0.1:$PORT; try: take one of them out of RTCTREE_NAMESERVERS
  $ RTCSH_CWD=robot1 doctor -q
  fail  here: RTCSH_CWD: robot1: a working directory (RTCSH_CWD) starts with /; try: unset RTCSH_CWD
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  [1]

Settings of omniORB that break things, from each of the places that have some:

  $ cat > omniORB.cfg <<'END'
  > # of somebody else
  > InitRef = NameService=corbaname::robot1
  > giopMaxMsgSize = 100000
  > endPoint = giop:tcp:127.0.0.1:
  > END
  $ OMNIORB_CONFIG=$TMP/omniORB.cfg doctor -q
  warn  here: $TMP/omniORB.cfg sets giopMaxMsgSize to 100000: components started here cannot send or receive larger messages (MARSHAL); try: remove it from $TMP/omniORB.cfg
  warn  here: $TMP/omniORB.cfg sets endPoint to giop:tcp:127.0.0.1:: components started here cannot be reached from other hosts; try: remove it from $TMP/omniORB.cfg
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  $ OMNIORB_CONFIG=$TMP/nothing doctor -q
  warn  here: OMNIORB_CONFIG names a file that is not there: $TMP/nothing; try: unset OMNIORB_CONFIG
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  $ ORBclientCallTimeOutPeriod=100 ORBendPoint=giop:tcp::2810 ORBmaxGIOPVersion=1.0 doctor -q
  warn  here: ORBclientCallTimeOutPeriod sets clientCallTimeOutPeriod to 100: components started here give up before slower answers come; try: unset ORBclientCallTimeOutPeriod
  warn  here: ORBendPoint sets endPoint to giop:tcp::2810: only one process at a time can have this port; try: unset ORBendPoint
  warn  here: ORBmaxGIOPVersion sets maxGIOPVersion to 1.0: Japanese names and large lists fail; try: unset ORBmaxGIOPVersion
  warn  /localhost:$PORT: nothing is bound in it: nothing was started, or it was restarted; try: start the components; those that run already bind their names again by themselves (naming.update.enable), or when they are restarted
  $ ORBclientCallTimeOutPeriod=5000 ORBendPoint=giop:tcp:: doctor | grep ORB
  ok    here: Python [0-9.]*, (omniORBpy .*|builtin ORB) (re)
  ok    here: settings of omniORB that break nothing: ORBclientCallTimeOutPeriod, ORBendPoint
  ok    /localhost:$PORT: answers (name * ms, TCP * ms, CORBA * ms, naming * ms) (glob)

A name server on another host: what publishes a loopback address there, means this host to us. Were the name server on this
host, but asked under its outer address, only others would be lost:

  $ mock two
  $ rtact ConsoleIn0.rtc
  $ HOSTS="robot1=198.51.100.1 127.0.0.1=198.51.100.7" doctor -q 127.0.0.1:$PORT
  fail  /127.0.0.1:$PORT/test.host_cxt/ConsoleIn0.rtc: publishes 127.0.0.1:*, which means this host, not its own; try: give its process an address that others reach: corba.endpoints: 198.51.100.7: in rtc.conf (glob)
  fail  /127.0.0.1:$PORT/test.host_cxt/ConsoleOut0.rtc: publishes 127.0.0.1:*, which means this host, not its own; try: give its process an address that others reach: corba.endpoints: 198.51.100.7: in rtc.conf (glob)
  [1]
  $ HOSTS="robot1=198.51.100.1 127.0.0.1=198.51.100.1" doctor -q 127.0.0.1:$PORT
  warn  /127.0.0.1:$PORT/test.host_cxt/ConsoleIn0.rtc: publishes 127.0.0.1:*: only this host can reach it; try: give its process an address that others reach: corba.endpoints: 198.51.100.1: in rtc.conf (glob)
  warn  /127.0.0.1:$PORT/test.host_cxt/ConsoleOut0.rtc: publishes 127.0.0.1:*: only this host can reach it; try: give its process an address that others reach: corba.endpoints: 198.51.100.1: in rtc.conf (glob)
  $ doctor -q localhost:$PORT

What is worse comes first:

  $ mock these Mock:Gone0 --context gone.host_cxt/%n.rtc
  $ hang these
  $ export HOSTS="robot1=198.51.100.1 127.0.0.1=198.51.100.1"
  $ doctor -q --timeout 4 /127.0.0.1:$PORT/gone.host_cxt
  fail  /127.0.0.1:$PORT/gone.host_cxt/Gone0.rtc: hung: 127.0.0.1:* accepts TCP, but no answer within 4s; try: restart it; netstat -ltnp | grep :* there names its process (glob)
  warn  /127.0.0.1:$PORT/gone.host_cxt/Gone0.rtc: publishes 127.0.0.1:*: only this host can reach it; try: give its process an address that others reach: corba.endpoints: 198.51.100.1: in rtc.conf (glob)
  [1]
  $ wake these
  $ kill-mock these; doctor -q /127.0.0.1:$PORT/gone.host_cxt | grep Gone0
  fail  /127.0.0.1:$PORT/gone.host_cxt/Gone0.rtc: dead (zombie): nothing listens at 127.0.0.1:*; try: rtdel -z /127.0.0.1:$PORT/gone.host_cxt/Gone0.rtc (glob)
  warn  /127.0.0.1:$PORT/gone.host_cxt/Gone0.rtc: publishes 127.0.0.1:*: only this host can reach it; try: give its process an address that others reach: corba.endpoints: 198.51.100.1: in rtc.conf (glob)
  $ rtdel -f /localhost:$PORT/gone.host_cxt/Gone0.rtc /localhost:$PORT/gone.host_cxt
  $ export HOSTS="robot1=198.51.100.1 localhost=127.0.0.1"

One that is no address costs its own line:

  $ RTCTREE_NAMESERVERS="http://laptop;localhost:$PORT" doctor | grep -v -e ORB -e 'host.s name'
  fail  here: RTCTREE_NAMESERVERS: http://laptop: not HOST[:PORT]; try: write HOST[:PORT], several separated by semicolons: RTCTREE_NAMESERVERS='robot1;robot2:2810'
  ok    /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: Active, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  ok    /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Inactive, claims 1000 Hz, 1 port, 0 connections, at 127.0.0.1:* (glob)
  1 failed, 0 to be looked at, 5 ok

An end point that cannot be bound:

  $ ORBendPoint=giop:tcp:203.0.113.9: doctor -q
  warn  here: ORBendPoint sets endPoint to giop:tcp:203.0.113.9:: components started here cannot listen there (Cannot assign requested address); try: unset ORBendPoint
  $ ORBendPoint=giop:tcp::$PORT doctor -q
  warn  here: ORBendPoint sets endPoint to giop:tcp::$PORT: components started here cannot listen there (Address already in use); try: unset ORBendPoint

Out of what a process needs here: nobody else is to blame:

  $ (ulimit -n 16; doctor -q)
  fail  here: out of files here (Too many open files, at 16): nothing can be judged; try: raise the limit in this shell (ulimit -n 1024), or end the programs that use most files here
  [1]
