A component may be bound under another reference than the one that its execution contexts know: by its key, or with a
rewritten address. Its contexts take such a reference for a stranger's. The commands find the right one.

orb: omniorb
world: two

  $ endpoint=$(rtcat -ll ConsoleIn0.rtc | sed -n 's/^ *corba.endpoints  *//p')
  $ python3 - "$endpoint" <<'EOF'
  > import os, sys
  > import CosNaming
  > from omniORB import CORBA
  > orb = CORBA.ORB_init(["bind"], CORBA.ORB_ID)
  > names = orb.string_to_object("corbaloc:iiop:1.2@localhost:%s/NameService" % os.environ["PORT"])
  > names = names._narrow(CosNaming.NamingContext)
  > known = orb.string_to_object("corbaloc:iiop:1.2@%s/example.ConsoleIn0" % sys.argv[1])
  > names.rebind([CosNaming.NameComponent(*name) for name in (("test", "host_cxt"), ("ByKey0", "rtc"))], known)
  > EOF

  $ rtls -l
  Inactive  1/0  0/0  1/0  0/0  ByKey0.rtc
  Inactive  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  $ rtact ByKey0.rtc
  $ rtls -l
  Active    1/0  0/0  1/0  0/0  ByKey0.rtc
  Active    1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  Inactive  1/0  1/0  0/0  0/0  ConsoleOut0.rtc
  $ rtdeact --wait ByKey0.rtc && rtfind . --state inactive
  /localhost:$PORT/test.host_cxt/ByKey0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ rtcat ByKey0.rtc | head -1
  ByKey0.rtc  Inactive
  $ rtec ByKey0.rtc
  0  0  Periodic  1000  Running  Inactive  ConsoleIn0  -
