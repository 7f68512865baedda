A port that does not answer does not hold up the others; it gets values again when it answers.

world: two
world: these ConsoleOut:Far0
both: each ORB waits in its own way

  $ export RTSHELL_TIMEOUT=1
  $ got() { ctl "$@" | cut -d' ' -f1; }
  $ rtact ConsoleOut0.rtc Far0.rtc
  $ rtinject -n -1 -r 50 -c 1 ConsoleOut0.rtc:in Far0.rtc:in 2>said & pid=$!; [ $(got received ConsoleOut0:in 20) -ge 20 ]
  $ hang these; soon 'grep -q answer said'; n=$(got received ConsoleOut0:in)
  $ [ $(within 0-4 ctl received ConsoleOut0:in $((n + 90)) | cut -d' ' -f1) -ge $((n + 90)) ]
  $ wake these; n=$(got @these received Far0:in); [ $(got @these received Far0:in $((n + 9))) -ge $((n + 9)) ]
  $ soon 'grep -q again said'; kill $pid; wait $pid; cat said; ctl @these connectors Far0:in
  rtinject: /localhost:$PORT/test.host_cxt/Far0.rtc:in: no answer within 1s
  rtinject: /localhost:$PORT/test.host_cxt/Far0.rtc:in: answers again
