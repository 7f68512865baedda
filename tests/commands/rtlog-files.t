rtlog inspects and exports logs: its own and rtshell's, whole and damaged; no component is asked.

A log that rtshell's rtlog wrote (simpkl, Python 3.7), and one of Python 2 whose recording was killed:

  $ base64 -d << END | gzip -d > old.rtlog
  > H4sIAAAAAAACA9WSy2rbQBSGZV1i14QUCsXLlqwcSGR3611JQmhs1Sb2KmCGkTyxRHRjNGrqRcDd
  > mC5m1+PXcDd9gDxHuw40eYocKb6UYgiYbDK7mTn/me//54z1aaWg5Ovk4++b7nldUfog33CRuMz3
  > zTjigohRzBKQpQ5uujFz4AfsfYNrqMoyuYh4QIVgHD7LLeKFcSrguzRISAMGshimgc04isuE0yuS
  > oDoBfOBdzY8c6rtRImpd7tRNLpxGlApzIaCyRATlQyay+j6+VaiBfLVUIc5CB0xqKIUJiowcFuRr
  > PBecsezePOsdorTnBWzQisIh4iNOVjenfPvpqNXAotqypPHBrENq0wmYY33afgxIWcWSeEF86RM/
  > GoLcOkx5J0pWoRheOGBfoalKPebsCzQVaTjUcRlYU02qFzFYbT21zfcvYqH/2dx/FZ1sLyLwcvPF
  > 41DwUa+7cq+TBCfk1LUKl9kY5Jtx5dd+av8zDU98z7yVKgJwS1LPrlanWtbS+qtJPW/eNLCzPqCC
  > YtCpPQFrV20qIv+4n0vwwmbgyqx18Mzgd+vAizn4HxXZ/ydXN4z86Pa5ye/Xke/k5FMN4ZH8AVMd
  > mStPBAAA
  > END
  $ base64 -d << END | gzip -d > python2.rtlog
  > H4sIAAAAAAACA+WRsU7DMBCGnbSlJTtihDFIkJQ1GwKEiApCJF6QIstxTRuRxJF9FupQqQxUiIdh
  > 4gF4Dt6Bd8BJSwamMnPTyf/9d5/8L+yLk8+P6G6IUMIkqCnPc68SEgjMKq6cG9NGFWfOwdPcxQ65
  > F7KgAFxe4y2SlZWGF9wjJS047pe6SLlUZkrSR6KMSyV4z88Fo/lUKPAjyYaeBBYIDd56muIBASon
  > HFSSuNjy8XZrwIMfB8cd41lSc6vmYrfxqRNnBR+PRDlxzMX6dYWxc3k2Cozut3pw7A11Spfe/j+v
  > he2GyFQbdJaLiXNegpzF0Sphk6XiLFzsvh/iLqnb6ZX1oNM23V9f35i6Ywq02YxtKNqJtdgs7NVi
  > x3SvFtKpTpfhl4VQ4wGv5rI24kJvo6O/cvU35LJWXM92y/UN/BRHgh0DAAA=
  > END
  $ TZ=UTC rtlog -d -f old.rtlog
  Name: old.rtlog
  Size: 1.08KiB (1103B)
  Start time: 2026-11-21 07:51:04 (1795247464.750000000)
  First entry time: 2026-11-21 07:51:04 (1795247464.750000000)
  End time: 2026-11-21 07:51:04 (1795247464.770000000)
  Number of entries: 3
  Channel 1
    Name: numbers
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 3
    Sources:
      /localhost/Src0.rtc:out.numbers
  $ rtlog -d --json -f old.rtlog
  {"attachments": [], "channels": [{"entries": 3, "name": "numbers", "sources": ["/localhost/Src0.rtc:out.numbers"], "type": "IDL:RTC/TimedLong:1.0", "typecode": false}], "closed": true, "damaged": 0, "entries": 3, "file": "old.rtlog", "first": 1795247464.7500002, "form": "simpkl", "gaps": [], "last": 1795247464.77, "size": 1103, "started": 1795247464.7500002, "torn": 0}
  $ rtlog -d old.rtlog | head -n 1
  Name: old.rtlog
  $ rtlog --json ./old.rtlog | wc -l
  3
  $ rtlog -p --csv old.rtlog | wc -l
  4
  $ rtlog old.rtlog
  rtlog: old.rtlog: a log; show, play and export read it, -f names what is recorded to (see --help)
  [2]
  $ TZ=Asia/Tokyo rtlog -d -f python2.rtlog
  Name: python2.rtlog
  Size: 797B
  Start time: 2026-11-21 16:51:04 (1795247464.750000000)
  First entry time: 2026-11-21 16:51:04 (1795247464.750000000)
  End time: 2026-11-21 16:51:04 (1795247464.760000000)
  Number of entries: 2
  State: INCOMPLETE, whole up to octet 797
  Channel 1
    Name: numbers
    Data type: IDL:RTC/TimedLong:1.0
    Number of entries: 2
    Sources:
      /localhost/Src0.rtc:out.numbers
  rtlog: python2.rtlog: recording has not ended regularly, or goes on
  $ rtlog --json -f old.rtlog
  {"number": 0, "port": "numbers", "received": 1795247464.7500002, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 0, "tm": {"nsec": 5, "sec": 1000}}}
  {"number": 1, "port": "numbers", "received": 1795247464.76, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 7, "tm": {"nsec": 5, "sec": 1001}}}
  {"number": 2, "port": "numbers", "received": 1795247464.77, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 14, "tm": {"nsec": 5, "sec": 1002}}}

Two entries from number 1 on, and from a time to a time; with -q nothing is said on stderr:

  $ rtlog --json -f old.rtlog -i -s 1 -e 2 | grep -c number
  2
  $ rtlog --json -f old.rtlog -i -e 1 | grep -c number
  1
  $ rtlog --json -f old.rtlog -s 1795247464.755 -e 1795247464.765
  {"number": 1, "port": "numbers", "received": 1795247464.76, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 7, "tm": {"nsec": 5, "sec": 1001}}}
  $ rtlog --json -f old.rtlog -i -s 5
  rtlog: old.rtlog: the start is after the last entry
  [1]
  $ rtlog --json -f old.rtlog -e 5
  rtlog: old.rtlog: the end is before the first entry
  [1]
  $ rtlog --json -q -f python2.rtlog
  {"number": 0, "port": "numbers", "received": 1795247464.7500002, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 0, "tm": {"nsec": 5, "sec": 0}}}
  {"number": 1, "port": "numbers", "received": 1795247464.76, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 7, "tm": {"nsec": 5, "sec": 1}}}

Cut off in the middle, and with something else inside, what is whole is read:

  $ head -c 1000 old.rtlog > cut.rtlog; rtlog --csv -f cut.rtlog
  number,time,port,tm,data
  0,1795247464.750000000,numbers,1000.000000005,0
  1,1795247464.760000000,numbers,1001.000000005,7
  rtlog: cut.rtlog: the last 83 octets cannot be read and are left out: it does not end
  $ (cat old.rtlog; printf 'cos\nsystem\n(S"touch /tmp/x"\ntR.') > evil.rtlog; rtlog -d --json -f evil.rtlog
  {"attachments": [], "channels": [{"entries": 3, "name": "numbers", "sources": ["/localhost/Src0.rtc:out.numbers"], "type": "IDL:RTC/TimedLong:1.0", "typecode": false}], "closed": true, "damaged": 0, "entries": 3, "file": "evil.rtlog", "first": 1795247464.7500002, "form": "simpkl", "gaps": [], "last": 1795247464.77, "size": 1134, "started": 1795247464.7500002, "torn": 31}
  rtlog: evil.rtlog: the last 31 octets cannot be read and are left out: os.system is not a class that a log holds; -m MODULE names a module of your own

Classes of other modules than the standard ones are taken when their module is named, or an IDL file with their types; nothing
is imported:

  $ sed 's/rtctree.rtc.RTC/robot.mods2.Arm/g; s,IDL:RTC/,IDL:Arm/,g' old.rtlog > own.rtlog
  $ rtlog --csv -f own.rtlog
  rtlog: own.rtlog: its header cannot be read: robot.mods2.Arm.TimedLong is not a class that a log holds; -m MODULE names a module of your own
  [1]
  $ rtlog --csv -m robot.mods2.Arm -f own.rtlog
  number,time,port,tm.sec,tm.nsec,data
  0,1795247464.750000000,numbers,1000,5,0
  1,1795247464.760000000,numbers,1001,5,7
  2,1795247464.770000000,numbers,1002,5,14
  $ rtlog --json -m robot.mods2.Arm -f own.rtlog | head -n 1
  {"number": 0, "port": "numbers", "received": 1795247464.7500002, "type": "IDL:Arm/TimedLong:1.0", "value": {"data": 0, "tm": {"nsec": 5, "sec": 1000}}}
  $ rtlog -p -m robot.mods2.Arm -f own.rtlog -r 100 | head -n 1
  {'tm': {'sec': 1000, 'nsec': 5}, 'data': 0}
  $ echo 'module Arm { struct Time { unsigned long sec, nsec; }; struct TimedLong { Time tm; long data; }; };' > arm.idl
  $ rtlog --json --idl arm.idl -f own.rtlog | head -n 1; rtlog -d --idl arm.idl -f own.rtlog | grep -c Arm
  {"number": 0, "port": "numbers", "received": 1795247464.7500002, "type": "IDL:Arm/TimedLong:1.0", "value": {"data": 0, "tm": {"nsec": 5, "sec": 1000}}}
  1

MCAP that somebody else wrote, with a type in the words of ROS, and with messages of JSON; and cut off:

  $ base64 -d << END | gzip -d > other.mcap
  > H4sIAAAAAAACA+v0dXYMMODlYpRkQABBIM5NTizQLagsycjP0zfUM9MzYOtlhMmnLN+87QEvjE6Fipu/veYEomF85n1Q5YxgA4tK
  > kvVzi9P1QzJzU1N88vPS2UGC+cVGQMEZUHmQnEJJLldmXomxkUJKYkmigrJCokJeaW5SahGXLZUBl2+wu5UCzF6uUoitxanJMGYe
  > iM0iDfcGIwMHkNaHOKeYGchOTikCe1UeqoaJgRVIBpcklqRyARlZxfl5xckZqbmJTEBedS2LFFwdEwMbyKxikFIWqFKQDKsa3Dps
  > gQ0SfgG0mRUqyy4GVy6ApNwMqpstCGbMqX+PwPrb5ntsBdJaUPE0kZIlIBrGR7cepg3J+pdQ69mxKJ8yU24LmvJXUOV8WJTHmUSh
  > K38NVS6KRbnG+anoyt9AlctgUf4p8yK68rdQ5cog5WbwyAADaMjAlFcr5eanpCpZKSiVJ+ZkK+koKOWkphcD+dGGOgpGsbXsYXDb
  > AlBCigElKPRhfKhf42B8qGd6YXyoa/egRywTJGKhrnsNFeVnQcqvwySnEZ2LiMiRROQ0bidYUCMpRQAm5NwHDX0RsKVscBWwzMXh
  > xYC9bNSCik6DquQCG3AAypNHsg5WasJojhAG7Dn3PlRBNJSGuMmKGeammVBWHZLhsNwNo/kEYSnnKFT1ewY0GZYt0BTmji7D/Rsq
  > 440uw+EGLZY2oMtwfWNlQAFwGV50GSYRKAPmNJiCk5qWhp3Q6goADruKmrcGAAA=
  > END
  $ rtlog --json -f other.mcap
  {"number": 0, "port": "/numbers", "received": 1000000000.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 0, "tm": {"nsec": 5, "sec": 1000}}}
  {"number": 1, "port": "/numbers", "received": 1000000001.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 7, "tm": {"nsec": 5, "sec": 1001}}}
  {"number": 2, "port": "/numbers", "received": 1000000002.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 14, "tm": {"nsec": 5, "sec": 1002}}}
  {"number": 3, "port": "/numbers", "received": 1000000003.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 21, "tm": {"nsec": 5, "sec": 1003}}}
  {"number": 4, "port": "/numbers", "received": 1000000004.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 28, "tm": {"nsec": 5, "sec": 1004}}}
  {"number": 5, "port": "/numbers", "received": 1000000005.0, "type": "IDL:RTC/TimedLong:1.0", "value": {"data": 35, "tm": {"nsec": 5, "sec": 1005}}}
  {"number": 6, "port": "/state", "received": 1000000007.0, "type": "State", "value": {"legs": [1, 2], "mode": "walk"}}
  $ rtlog --csv --ns other -f other.mcap; head -n 2 other/*
  ==> other/numbers.csv <==
  number,time,port,tm,data
  0,1000000000000000000,/numbers,1000000000005,0

  ==> other/state.csv <==
  number,time,port,mode,legs[0],legs[1]
  6,1000000007000000000,/state,walk,1,2
  $ rtlog --csv a b -f other.mcap
  rtlog: one DIRECTORY at a time: b (see --help)
  [2]
  $ rtlog --csv -f other.mcap | head -n 2
  number,time,port,tm,data,mode,legs[0],legs[1]
  0,1000000000.000000000,/numbers,1000.000000005,0,,,
  $ head -c 1000 other.mcap > torn.mcap; rtlog -d -f torn.mcap 2>&1 | grep 'INCOMPLETE\|torn'
  Name: torn.mcap
  State: INCOMPLETE, whole up to octet 952
  rtlog: torn.mcap: the last 48 octets are not a whole record and are left out
  rtlog: torn.mcap: other readers may refuse it; rtlog mend makes a copy that they open

For others it is made whole in a copy, or in place:

  $ rtlog --mend torn.mcap
  rtlog: torn.mcap: the last 48 octets are not a whole record and are left out
  rtlog: the copy is torn-mended.mcap
  $ rtlog -d --json -f torn-mended.mcap | grep -o '"closed.*damaged": 0\|"entries": [0-9]*, "file'
  "closed": true, "damaged": 0
  "entries": 7, "file
  $ rtlog --mend torn.mcap
  rtlog: torn-mended.mcap: exists already; -f OUT names another file
  [1]
  $ rtlog -q --mend torn.mcap -f out.mcap; cmp out.mcap torn-mended.mcap
  $ rtlog -q --mend torn.mcap --in-place; cmp out.mcap torn.mcap
  $ rtlog --mend old.rtlog
  rtlog: old.rtlog: a log of rtshell; only MCAP can be mended
  [1]
  $ rtlog --mend torn.mcap -d
  rtlog: -d is for rtlog show, not for rtlog mend (see --help)
  [2]
  $ head -c 1000 other.mcap > torn.mcap
  $ rtlog -q --mend --in-place torn.mcap
  $ cmp out.mcap torn.mcap
  $ rtlog --in-place -d -f torn.mcap
  rtlog: --in-place is for rtlog mend, not for rtlog show (see --help)
  [2]

Compressed by somebody else: read by those Pythons that can, zstd from 3.14 on; else refused, with what to do:

  $ base64 -d << END | gzip -d > zstd.mcap
  > H4sIAAAAAAACA+v0dXYMMODlYpRkQABBIM5NTizQLagsycjP0zfUM9MzYFsIl09ZvnnbA16GKTPltgDpG1DR6fs6LViAdFVxSUopVExj
  > q/5fhRupzAxfWJjlGRgZWIFiwSWJJalcQEZWcX5ecXJGam4iE5BXXcsiBVTByMAG5OgXs7CqQaypVsrNT0lVslJQKk/MyVaqPfXvEchi
  > bgYFFcbiCVxrRYN2MPZofZFkelJ6SqnxI5sBC7sZ1HZGBgMk93rDnA80AcSvgvGh/lgJ5fKzIAUF0NUwswi5HaYO5gOQUhaoUpAMtwXM
  > TCSlCMCIJWi5wOIw9Rx+OGJACyq6CkpDtF2B8uyhNHrcwOKNTxDmLgWoezTQZVg8oDLK6DLc2VAZR3QZjjVQmXB0GS5mJgYUAJfhRZdh
  > EoEyYE6DKRBddE6qE5p2AQOUfSbEAgAA
  > END
  $ base64 -d << END | gzip -d > lz4.mcap
  > H4sIAAAAAAACA+v0dXYMMODlYpRkQABBIM5NTizQLagsycjP0zfUM9MzYDsAl09ZvnnbA16GKTPltgDpG1DR6fs6LZiBdE6VyVSoEIuS
  > r0SGA0xBdB2QMGKWZ2Bk+CTEyMAK5AWXJJakcgEZWcX5ecXJGam5iUxAXnUti5Q6wwagQkYGNiBfv1ibQZhFm4FBlkGBVY2NgVGZgZGd
  > oQTqEA6GP4zVSrn5KalKVgpK5Yk52Uq1+gz2p/490meQ9Ae5Mo6BOQAsDHIGuxnUPYwMBkje8Yb5DqgPxK+C8aHeXAnl8rMghRTQMzCz
  > CHgHrg7mI5BSFqhSkAy3BcxMJKUIwIgl5LnA4jD1HL44IkgLKnoSSkO0fYby7JGsRYo6WKTxCcLk7aHO0UCXYUmHyiijy3B3QWUc0WU4
  > TkNlwtBluBSZGFAAXIYXXYZJBOYHqGEwBfNEuxs6oSkbACwG8UbiAgAA
  > END
  $ rtlog -d -f lz4.mcap
  rtlog: lz4.mcap: compressed with lz4, which is not read; `mcap decompress FILE -o OUT` makes a copy that can be read
  [1]
  $ rtlog --mend lz4.mcap; ls lz4*
  rtlog: lz4.mcap: compressed with lz4, which is not read; `mcap decompress FILE -o OUT` makes a copy that can be read
  lz4.mcap
  $ rtlog --json -f zstd.mcap
  rtlog: zstd.mcap: compressed with zstd, which is read by Python 3.14 and later; `mcap decompress FILE -o OUT` makes a copy that can be read
  [1]
  $ rtplot -f zstd.mcap
  rtplot: zstd.mcap: compressed with zstd, which is read by Python 3.14 and later; `mcap decompress FILE -o OUT` makes a copy that can be read
  [1]

Not logs:

  $ rtlog -d -f none
  rtlog: none: No such file or directory
  [1]
  $ rtlog -d -f .
  rtlog: .: Is a directory
  [1]
  $ rtlog -d -f /proc/self/mem
  rtlog: /proc/self/mem: Input/output error
  [1]
  $ rtlog -d -f /dev/null
  rtlog: /dev/null: not a log file (it is empty)
  [1]
  $ echo hello > x; rtlog -d -f x
  rtlog: x: not a log file
  [1]
  $ printf '1795247466.747797248\t(1)\n' > x; rtlog -d -f x
  rtlog: x: a log of text; it is for people, and can be neither played nor inspected
  [1]
  $ printf '\200\004K\001.' > x; rtlog -d -f x
  rtlog: x: its header is not that of a log
  [1]
  $ printf '\200\004cos\nsystem\n.' > x; rtlog -d -f x
  rtlog: x: its header cannot be read: os.system is not a class that a log holds; -m MODULE names a module of your own
  [1]
  $ printf '\211MCAP0\r\n' > x; rtlog -d -f x
  rtlog: x: its header is damaged, nothing can be read
  [1]

Wrong usage:

  $ rtlog -d
  rtlog: no log file specified (see --help)
  [2]
  $ rtlog -p
  rtlog: no log file specified (see --help)
  [2]
  $ rtlog --json
  rtlog: no log file specified (see --help)
  [2]
  $ rtlog -d -p -f old.rtlog
  rtlog: -d is for rtlog show, not for rtlog play (see --help)
  [2]
  $ rtlog -d --csv -f old.rtlog
  rtlog: --csv is for rtlog play and export, not for rtlog show (see --help)
  [2]
  $ rtlog -d -f old.rtlog a.rtc:b
  rtlog: one log at a time: a.rtc:b (see --help)
  [2]
  $ rtlog --csv --json -f old.rtlog
  rtlog: --json and --csv exclude each other (see --help)
  [2]
