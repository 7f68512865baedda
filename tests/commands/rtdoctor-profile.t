rtdoctor --profile looks for components that are missing where the file says that they were: names are lost when a name
server is started again, components are not.

world: linked
world: these ConsoleOut:Other0
world: manager11 --context made.host_cxt/%n.rtc

  $ doctor() {
  >     rtdoctor -q -s Inactive --profile "$@" > out
  >     code=$?
  >     grep -e missing -e "has none" out
  >     return $code
  > }
  $ rtcryo -q . | grep -v REFERENCE > plain.rtsys

Object references of data ports, as RTSystemEditor saves them with connections; each end is found by its own. What lives is not
to be made a second time:

  $ add() {
  >     sed -i "s|\(<rtsExt:Properties rtsExt:name=\)\"dataport.data_type\"|\1\"$1\" rtsExt:value=\"$2\"/>&|" $3
  > }
  $ cp plain.rtsys in.rtsys
  $ add dataport.corba_cdr.inport_ior $(ctl references ConsoleOut0:in) in.rtsys
  $ cp in.rtsys both.rtsys
  $ rtcon -p dataport.dataflow_type=pull ConsoleIn0.rtc:out Other0.rtc:in
  $ add dataport.corba_cdr.outport_ior $(ctl references ConsoleIn0:out) both.rtsys
  $ doctor both.rtsys .
  $ rtdel -f ConsoleOut0.rtc; doctor in.rtsys .
  fail  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Required component missing, but it lives: its port answers at 127.0.0.1:*; try: look again in some time, as many bind their names again by themselves (naming.update.enable); restart those that do not (glob)
  [1]
  $ doctor plain.rtsys .
  fail  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Required component missing; try: start it, or have its manager make it: rtresurrect --create plain.rtsys
  [1]
  $ rtdel -f ConsoleIn0.rtc; doctor both.rtsys . | cut -d';' -f1
  fail  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: Required component missing, but it lives: its port answers at 127.0.0.1:* (glob)
  fail  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Required component missing, but it lives: its port answers at 127.0.0.1:* (glob)
  warn  /localhost:$PORT: has none of its 2 components in the file, though /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc and /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc live: perhaps it was started again, and they were not, or it is another name server
  $ kill-mock linked; doctor both.rtsys . | cut -d';' -f1
  fail  /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: Required component missing
  fail  /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: Required component missing

Managers whose address the file has:

  $ rtcryo -q --all | grep -v REFERENCE > made.rtsys
  $ sed -i "s|\(\"MANAGER\" rtsExt:value=\)\"[^\"]*\"|\1\"corbaloc::localhost:$(ctl @manager11 port)/manager\"|" made.rtsys
  $ rtdel -f ../made.host_cxt/ConsoleIn0.rtc; doctor made.rtsys ../made.host_cxt | cut -d';' -f1
  fail  /localhost:$PORT/made.host_cxt/ConsoleIn0.rtc: Required component missing, but it lives: the manager corbaloc::localhost:*/manager has it (glob)

Unusable references, and processes that hang, do not make it slower than its limit:

  $ cp plain.rtsys bad.rtsys; add dataport.corba_cdr.inport_ior IOR:00ff bad.rtsys
  $ doctor bad.rtsys . | grep -c missing
  2
  $ hang manager11
  $ within 4-16 rtdoctor -q --timeout 4 --profile made.rtsys . | grep -c missing
  1
  $ wake manager11
