rtact --all, rtdeact --all and rtreset --all: all components below a path.

world: two
world: error --context arm.host_cxt/%n.rtc
world: zombie 1 --context arm.host_cxt/Dead%n.rtc

What became of each is printed. What fails is a line on stderr; the name of a dead component is a note. Of one that goes to Error
when it becomes Active, the command may see either, without --wait:

  $ rtact --all --dry-run /localhost:$PORT/arm.host_cxt .
  rtact: /localhost:$PORT/arm.host_cxt/DeadMock0.rtc: zombie, left out
  rtact /localhost:$PORT/arm.host_cxt/Broken0.rtc
  rtact /localhost:$PORT/arm.host_cxt/Err0.rtc
  rtact /localhost:$PORT/arm.host_cxt/ErrStart0.rtc
  rtact /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  rtact /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc
  $ rtact --all .
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: accepted
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: accepted
  $ rtact --all -q /
  rtact: /localhost:$PORT/arm.host_cxt/Broken0.rtc: cannot activate: it is in Error; reset it first
  (rtact: )?/localhost:\$PORT/arm.host_cxt/Err0.rtc: (accepted|cannot activate: it went to Error) (re)
  (rtact: )?/localhost:\$PORT/arm.host_cxt/ErrStart0.rtc: (accepted|cannot activate: it went to Error) (re)
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: Active
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Active
  [5]
  $ rtdeact --all --wait 30 /localhost:$PORT/test.host_cxt /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc
  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: Inactive
  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Inactive

A reset concerns only those that are in Error:

  $ soon '[ $(rtfind / --state error | wc -l) = 3 ]'
  $ rtreset --all -q --wait 30 / | head -1
  /localhost:$PORT/arm.host_cxt/Broken0.rtc: Inactive
  $ rtreset --all /
  rtreset: /localhost:$PORT/arm.host_cxt/DeadMock0.rtc: zombie, left out
  $ rtact --all /localhost:$PORT/nosuch.host_cxt
  rtact: /localhost:$PORT/nosuch.host_cxt: no such path
  [3]
  $ rtact --all /localhost:1
  rtact: /localhost:1: connection refused; is the name server running?
  [4]
