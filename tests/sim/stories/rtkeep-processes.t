rtkeep --processes keeps processes that end, hang, are never ready, or are started by others, and ends them in time.

world: these ConsoleIn --flavour cpp2

  $ write Procfile
  > motor: mock these Motor motor
  > motor.ready: /robot/test.host_cxt/Motor0.rtc
  > motor.delay: 0.1-1
  > out: mock these ConsoleOut out
  > out.after: motor
  > out.ready: /robot/test.host_cxt/ConsoleOut0.rtc
  > talk: family talk 1000
  > talk.after: motor out
  > talk.stop: INT 5
  > brief: brief brief 0.4 0
  > brief.restart: no
  > fails: brief fails 0.4 3
  > fails.burst: 1/60
  > missing: missing
  > missing.burst: 1/60

Each is started when those before it are ready. What fails is tried again, and given up:

  $ rtkeep -v --log . --processes Procfile &
  $ sleep 3
  $ show rtkeep
  [08:00:00] brief: started, pid 4
  [08:00:00] fails: started, pid 5
  [08:00:00] missing: cannot be started: No such file or directory
  brief: as brief as I am
  fails: as brief as I am
  [08:00:00] missing: cannot be started: No such file or directory: given up after more than 1 failure in 60s
  [08:00:00] motor: started, pid 6
  [08:00:00] motor: /robot/test.host_cxt/Motor0.rtc answers: ready
  [08:00:00] out: started, pid 7
  [08:00:00] out: /robot/test.host_cxt/ConsoleOut0.rtc answers: ready
  [08:00:00] talk: started, pid 8
  talk: as brief as I am
  [08:00:00] brief: ended with status 0: not started again
  [08:00:00] fails: ended with status 3
  [08:00:00] fails: started, pid 10
  fails: as brief as I am
  [08:00:00] fails: ended with status 3: given up after more than 1 failure in 60s
  $ rtkeep status
  Procfile: pid 3, since 2027-01-15 08:00:00; not all is as the file says
    motor    running  ready               2027-01-15 08:00:00               pid 6
    out      running  ready               2027-01-15 08:00:00               pid 7
    talk     running  ready               2027-01-15 08:00:00               pid 8
    brief    stopped  stopped             2027-01-15 08:00:00
    fails    stopped  stopped (given up)  2027-01-15 08:00:00  restarts: 1
    missing  stopped  stopped (given up)  2027-01-15 08:00:00  restarts: 1
    brief: as brief as I am
    fails: as brief as I am
    fails: as brief as I am
  $ cat talk.log
  2027-01-15T08:00:00 as brief as I am

What is stopped by name stays stopped until it is resumed:

  $ rtkeep stop talk
  $ sleep 60
  $ show rtkeep
  [08:00:03] talk: ended by SIGINT: as it was told
  $ rtkeep resume talk
  $ show rtkeep
  [08:01:03] talk: started, pid 14

One that is killed comes back, those after it stay. One that hangs stays as it is.

  $ kill motor
  $ sleep 5
  $ hang out
  $ sleep 60
  $ show rtkeep
  talk: as brief as I am
  [08:01:03] motor: ended by SIGKILL
  [08:01:03] motor: started, pid 16
  [08:01:03] motor: /robot/test.host_cxt/Motor0.rtc answers: ready

At the end each ends when those after it have, or is killed after its time:

  $ strike TERM rtkeep
  $ wait rtkeep
  [08:02:08] talk: ended by SIGINT: as it was told
  [08:02:13] out: ended by SIGKILL: as it was told
  [08:02:13] out: does not end within 5s: killed
  [08:02:13] motor: ended by SIGTERM: as it was told
  [0] after 133.0 s
  $ rtls
  ConsoleIn0.rtc
  *ConsoleOut0.rtc
  *Motor0.rtc
  $ rtdel -z

A component that lives is not started a second time, nor one that hangs; when it is gone, the process is started.

  $ mock these Motor
  $ rtkeep --processes Procfile &
  $ sleep 2
  $ rtkeep status
  Procfile: pid 20, since 2027-01-15 08:02:13; not all is as the file says
    motor    running  foreign             2027-01-15 08:02:13
    out      running  ready               2027-01-15 08:02:13               pid 23
    talk     running  ready               2027-01-15 08:02:13               pid 24
    brief    stopped  stopped             2027-01-15 08:02:13
    fails    stopped  stopped (given up)  2027-01-15 08:02:13  restarts: 1
    missing  stopped  stopped (given up)  2027-01-15 08:02:13  restarts: 1
    brief: as brief as I am
    fails: as brief as I am
    fails: as brief as I am
  $ hang these2
  $ sleep 10
  $ rtkeep status
  Procfile: pid 20, since 2027-01-15 08:02:13; not all is as the file says
    motor    running  waiting             2027-01-15 08:02:18
    out      running  ready               2027-01-15 08:02:13               pid 23
    talk     running  ready               2027-01-15 08:02:13               pid 24
    brief    stopped  stopped             2027-01-15 08:02:13
    fails    stopped  stopped (given up)  2027-01-15 08:02:13  restarts: 1
    missing  stopped  stopped (given up)  2027-01-15 08:02:13  restarts: 1
    brief: as brief as I am
    fails: as brief as I am
    fails: as brief as I am
  $ kill these2
  $ sleep 3
  $ show rtkeep
  [08:02:13] brief: started, pid 21
  [08:02:13] fails: started, pid 22
  [08:02:13] missing: cannot be started: No such file or directory
  [08:02:13] missing: cannot be started: No such file or directory: given up after more than 1 failure in 60s
  [08:02:13] motor: /robot/test.host_cxt/Motor0.rtc answers already: not started
  [08:02:13] out: started, pid 23
  [08:02:13] out: /robot/test.host_cxt/ConsoleOut0.rtc answers: ready
  [08:02:13] talk: started, pid 24
  [08:02:13] brief: ended with status 0: not started again
  [08:02:13] fails: ended with status 3
  [08:02:13] fails: started, pid 26
  [08:02:13] fails: ended with status 3: given up after more than 1 failure in 60s
  [08:02:18] motor: /robot/test.host_cxt/Motor0.rtc does not answer, but is not gone: not started
  [08:02:27] motor: started, pid 29
  [08:02:27] motor: /robot/test.host_cxt/Motor0.rtc answers: ready
  $ rtkeep stop
  $ wait rtkeep
  [08:02:28] talk: ended by SIGINT: as it was told
  [08:02:28] out: ended by SIGTERM: as it was told
  [08:02:28] motor: ended by SIGTERM: as it was told
  [0] after 15.0 s

It cannot be looked for while its name server hangs: then it is not started, and those after it are not.

  $ hang names
  $ rtkeep --processes Procfile &
  $ sleep 20
  $ rtkeep status
  Procfile: pid 31, since 2027-01-15 08:02:28; not all is as the file says
    motor    running  waiting             2027-01-15 08:02:28
    out      running  waiting             2027-01-15 08:02:28
    talk     running  waiting             2027-01-15 08:02:28
    brief    stopped  stopped             2027-01-15 08:02:28
    fails    stopped  stopped (given up)  2027-01-15 08:02:28  restarts: 1
    missing  stopped  stopped (given up)  2027-01-15 08:02:28  restarts: 1
    brief: as brief as I am
    fails: as brief as I am
    fails: as brief as I am
  $ wake names
  $ sleep 3
  $ show rtkeep
  [08:02:28] brief: started, pid 32
  [08:02:28] fails: started, pid 33
  [08:02:28] missing: cannot be started: No such file or directory
  [08:02:28] missing: cannot be started: No such file or directory: given up after more than 1 failure in 60s
  [08:02:28] brief: ended with status 0: not started again
  [08:02:28] fails: ended with status 3
  [08:02:28] fails: started, pid 34
  [08:02:28] fails: ended with status 3: given up after more than 1 failure in 60s
  [08:02:31] motor: /robot/test.host_cxt/Motor0.rtc cannot be looked for: its name server does not answer: not started
  [08:02:48] motor: started, pid 36
  [08:02:48] motor: /robot/test.host_cxt/Motor0.rtc answers: ready
  [08:02:48] out: started, pid 37
  [08:02:48] out: /robot/test.host_cxt/ConsoleOut0.rtc answers: ready
  [08:02:48] talk: started, pid 38
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:02:51] talk: ended by SIGINT: as it was told
  [08:02:51] out: ended by SIGTERM: as it was told
  [08:02:51] motor: ended by SIGTERM: as it was told
  [0] after 23.0 s

What is never ready is reported once; those after it wait:

  $ write Procfile
  > a: mute a
  > a.ready: /robot/test.host_cxt/Nobody0.rtc
  > b: brief b 0 0
  > b.after: a
  $ rtkeep --processes Procfile &
  $ sleep 60
  $ strike INT rtkeep
  $ wait rtkeep
  [08:02:51] a: started, pid 41
  [08:02:56] a: /robot/test.host_cxt/Nobody0.rtc does not answer yet: waits
  [08:03:51] a: ended by SIGTERM: as it was told
  [0] after 60.0 s

A second signal ends it at once, with all processes, however long these may take; a first one does not.

  $ write Procfile
  > a: stubborn a
  > a.stop: TERM 1000
  $ rtkeep --processes Procfile &
  $ sleep 1
  $ strike TERM rtkeep
  $ sleep 60
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:03:51] a: started, pid 43
  [143] after 61.0 s
  $ rtkeep --processes Procfile &
  $ sleep 1
  $ strike INT rtkeep
  $ sleep 60
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:04:52] a: started, pid 45
  [143] after 61.0 s
  $ rtkeep --processes Procfile &
  $ sleep 1
  $ strike TERM rtkeep
  $ sleep 60
  $ strike INT rtkeep
  $ wait rtkeep
  [08:05:53] a: started, pid 47
  [130] after 61.0 s

While it ends nothing is begun again, neither by a terminal that closes nor on request; SIGKILL follows in time, also where the file is read again.

  $ write Procfile
  > a: stubborn a
  > a.stop: TERM 2
  $ rtkeep --processes Procfile &
  $ sleep 1
  $ strike TERM rtkeep
  $ strike HUP rtkeep
  $ rtkeep resume a
  ! rtkeep: Procfile: its rtkeep is ending
  [1]
  $ rtkeep reload
  ! rtkeep: Procfile: its rtkeep is ending
  [1]
  $ wait rtkeep
  [08:06:54] a: started, pid 49
  [08:06:57] a: ended by SIGKILL: as it was told
  [08:06:57] a: does not end within 2s: killed
  [0] after 3.0 s
  $ rtkeep --processes Procfile &
  $ sleep 1
  $ rtkeep stop a
  $ sleep 1
  $ rtkeep reload
  $ sleep 5
  $ show rtkeep
  [08:06:57] a: started, pid 53
  [08:07:00] a: ended by SIGKILL: as it was told
  [08:07:00] a: does not end within 2s: killed
  $ strike TERM rtkeep
  $ wait rtkeep
  [0] after 7.0 s

What waits for its next attempt is resumed at once:

  $ write Procfile
  > a: brief a 0 1
  > a.delay: 1000-1000
  $ rtkeep --processes Procfile &
  $ sleep 60
  $ rtkeep resume a
  $ sleep 60
  $ show rtkeep
  [08:07:04] a: started, pid 57
  [08:07:04] a: ended with status 1
  [08:07:04] a: started, pid 58
  [08:07:04] a: ended with status 1
  [08:08:04] a: started, pid 60
  [08:08:04] a: ended with status 1
  [08:08:04] a: started, pid 61
  [08:08:04] a: ended with status 1
  $ strike TERM rtkeep
  $ wait rtkeep
  [0] after 120.0 s

It ends what it has started: the components of these processes are deactivated by the plan first. Others stay as they are.

  $ write Procfile
  > own: mock these Sensor Controller own
  > own.ready: /robot/test.host_cxt/Controller0.rtc
  $ rtkeep --processes Procfile &
  $ sleep 3
  $ rtcryo --all -o b.xml
  ! rtcryo: /robot/test.host_cxt/ConsoleOut0.rtc: zombie, left out
  ! rtcryo: /robot/test.host_cxt/Motor0.rtc: zombie, left out
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:09:04] own: started, pid 63
  [08:09:04] own: /robot/test.host_cxt/Controller0.rtc answers: ready
  [08:09:07] own: ended by SIGTERM: as it was told
  [0] after 3.0 s
  $ rtkeep --processes Procfile b.xml &
  $ sleep 5
  $ rtkeep status
  b.xml: pid 65, since 2027-01-15 08:09:07; all is as the file says
    /robot/test.host_cxt/ConsoleIn0.rtc   Active   Active  2027-01-15 08:09:07    Active
    /robot/test.host_cxt/Controller0.rtc  Active   Active  2027-01-15 08:09:07    Active
    /robot/test.host_cxt/Sensor0.rtc      Active   Active  2027-01-15 08:09:07    Active
    own                                   running  ready   2027-01-15 08:09:07    pid 66
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:09:07] own: started, pid 66
  [08:09:07] own: /robot/test.host_cxt/Controller0.rtc answers: ready
  [08:09:07] /robot/test.host_cxt/ConsoleIn0.rtc: Active
  [08:09:07] /robot/test.host_cxt/Controller0.rtc: Active
  [08:09:07] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:09:12] /robot/test.host_cxt/Sensor0.rtc: Inactive
  [08:09:12] /robot/test.host_cxt/Controller0.rtc: Inactive
  [08:09:12] own: ended by SIGTERM: as it was told
  [0] after 5.0 s
  $ rtls -l
  Active  1/0  0/0  1/0  0/0  ConsoleIn0.rtc
  -       -    -    -    -    *ConsoleOut0.rtc
  -       -    -    -    -    *Controller0.rtc
  -       -    -    -    -    *Motor0.rtc
  -       -    -    -    -    *Sensor0.rtc
  $ rtkeep --leave --processes Procfile b.xml &
  $ sleep 5
  $ strike TERM rtkeep
  $ wait rtkeep
  [08:09:12] own: started, pid 70
  [08:09:12] own: /robot/test.host_cxt/Controller0.rtc answers: ready
  [08:09:12] /robot/test.host_cxt/Controller0.rtc: Active
  [08:09:12] /robot/test.host_cxt/Sensor0.rtc: Active
  [08:09:17] own: ended by SIGTERM: as it was told
  [0] after 5.0 s
