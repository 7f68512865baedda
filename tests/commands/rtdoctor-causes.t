rtdoctor names the true cause: of two findings about an object the worse one, and never a remedy that harms.

world: these Mock:Lone0 Mock:Idle0 --context alone.host_cxt/%n.rtc
world: robot --rate 10 --context robot.host_cxt/%n.rtc
world: manager11 --context mgr.host_cxt/%n.rtc
world: services --context service.host_cxt/%n.rtc
faulty: refused

  $ doctor() {
  >     rtdoctor "$@" > out
  >     code=$?
  >     grep -v -e "here: " -e " failed, " -e "^[a-z]* *[^ ]*$PORT: [as][nl]" out
  >     return $code
  > }

A component that nobody is connected to is nobody's business:

  $ rtact --wait ../alone.host_cxt/Lone0.rtc; doctor -q ../alone.host_cxt

Inactive in a system that is Active; the failure of another system does not hide it:

  $ mock error --context error.host_cxt/%n.rtc
  $ rtact --wait ../robot.host_cxt/Sensor0.rtc ../robot.host_cxt/Controller0.rtc \
  >     ../robot.host_cxt/Hokuyo_AIST0.rtc
  $ doctor -q ../robot.host_cxt ../error.host_cxt
  fail  /localhost:$PORT/error.host_cxt/Broken0.rtc: in Error; try: rtreset /localhost:$PORT/error.host_cxt/Broken0.rtc
  warn  /localhost:$PORT/robot.host_cxt/Clusterer0.rtc: Inactive, while 1 component of its system is Active; it may have been reset; try: if it is to move, activate it: rtact /localhost:$PORT/robot.host_cxt/Clusterer0.rtc
  warn  /localhost:$PORT/robot.host_cxt/Motor0.rtc: Inactive, while 2 components of its system are Active; it may have been reset; try: if it is to move, activate it: rtact /localhost:$PORT/robot.host_cxt/Motor0.rtc
  [1]

The log of what is in Error, as its manager has it:

  $ ctl @manager11 error ConsoleIn0; doctor -q ../mgr.host_cxt | grep Error
  fail  /localhost:$PORT/mgr.host_cxt/ConsoleIn0.rtc: in Error; its process writes its log to ./rtc%p.log; try: rtreset /localhost:$PORT/mgr.host_cxt/ConsoleIn0.rtc

A consumer whose provider is there, but not connected:

  $ rtact --wait ../service.host_cxt/MyServiceConsumer0.rtc ../service.host_cxt/MyServiceProvider0.rtc
  $ doctor -q ../service.host_cxt
  warn  /localhost:$PORT/service.host_cxt/MyServiceConsumer0.rtc:MyService: requires MyService and is not connected, though /localhost:$PORT/service.host_cxt/MyServiceProvider0.rtc:MyService provides it to nobody; try: if they belong together, connect them again: rtcon /localhost:$PORT/service.host_cxt/MyServiceConsumer0.rtc:MyService /localhost:$PORT/service.host_cxt/MyServiceProvider0.rtc:MyService

Name servers whose ports are swapped:

  $ doctor -q localhost:$REFUSED localhost:$PORT | grep refused
  fail  /localhost:$REFUSED: connection refused: nothing listens on port $REFUSED, but something does on port $PORT of that host; try: see whether it is the name server (rtls /localhost:$PORT), and correct the address; if not: rtm-naming $REFUSED there

A timeout that nobody keeps:

  $ RTSHELL_TIMEOUT=0.1 rtdoctor -q | grep RTSHELL
  warn  here: RTSHELL_TIMEOUT is 0.1: what answers after 0.1 s is taken for silent; try: unset RTSHELL_TIMEOUT

Warnings that are alike are one, but for commands, each of which is to be pasted; JSON has them all:

  $ mock these Mock:A0 Mock:A1 Mock:A2 Mock:A3 Mock:A4 --rate 1000 --context fast.host_cxt/%n.rtc
  $ for each in 0 1 2 3 4; do rtcon ../fast.host_cxt/A$each.rtc:out ../alone.host_cxt/Lone0.rtc:in; done
  $ doctor -q ../fast.host_cxt ../alone.host_cxt
  warn  /localhost:$PORT/fast.host_cxt/A0.rtc: Inactive, while 1 component of its system is Active; it may have been reset; the same with /localhost:$PORT/fast.host_cxt/A1.rtc, /localhost:$PORT/fast.host_cxt/A2.rtc, /localhost:$PORT/fast.host_cxt/A3.rtc and 1 more; try: if it is to move, activate it: rtact /localhost:$PORT/fast.host_cxt/A0.rtc
  $ rtdoctor -q --json ../fast.host_cxt ../alone.host_cxt | grep -c "it may have been reset"
  5
