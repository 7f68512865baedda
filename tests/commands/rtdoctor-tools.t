The connectors of tools are no part of a system; rtdoctor reports those whose tool was killed.

world: linked

  $ rtprint -q ConsoleIn0.rtc:out & soon 'ctl connectors ConsoleIn0:out | grep -q rtprint'
  > rtdoctor -q . | grep rtprint
  [1]
  $ kill -9 $!
  $ until rtdoctor -q . | grep 'gone'; do sleep 0.1; done | sed 's/^.* \(warn\|fail\)/\1/; s/-i [^ ]*/-i ID/'
  warn  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: connection rtprint was left by a tool that is gone; try: rtdis -i ID /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out

The remedy removes it, and nothing else:

  $ eval "$(rtdoctor -q . | sed -n 's/.*gone; try: //p')"
  $ ctl connectors ConsoleIn0:out | sed 's/.* //'
  out_in
  $ rtdoctor -q . | grep gone
  [1]

A tool that sends serves nothing: nobody can know whether it still runs, and nothing is said.
